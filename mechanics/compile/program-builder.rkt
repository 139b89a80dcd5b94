#lang racket/base
;; Arithmetic on operands, written as instructions.
;;
;; Work that can be done beforehand is not left to the program: numbers are combined, neutral
;; elements dropped, whole powers multiplied out.  Signs move outwards, to become
;; subtractions or to meet others; opposite terms cancel.

(require "../algebra/expression/constant-range.rkt"
         "../numeric/constants.rkt"
         "../numeric/machine/instruction-builder.rkt"
         "../numeric/machine/straight-instruction.rkt")

(provide make-builder written written-count
         do! write! add! subtract! multiply! divide! negate! power! pi-times!)

;; ---------------------------------------------------------------------------
;; Arithmetic

(define (add! b x y)
  (cond [(and (number? x) (number? y)) (+ x y)]
        [(eqv? x 0) y]
        [(eqv? y 0) x]
        [(like-terms b x y +)]
        [(cancelled b (terms b x) (terms b y))]
        [(negated b y) => (lambda (z) (subtract! b x z))]
        [(negated b x) => (lambda (z) (subtract! b y z))]
        [else (do-in-order! b 'add x y)]))

(define (subtract! b x y)
  (cond [(and (number? x) (number? y)) (- x y)]
        [(eqv? y 0) x]
        [(eqv? x 0) (negate! b y)]
        [(like-terms b x y -)]
        [(cancelled b (terms b x) (map opposite (terms b y)))]
        [(negated b y) => (lambda (z) (add! b x z))]
        [else (do! b 'subtract x y)]))

;; (c ± d) z if x and y are c z and d z with numbers c and d; or #f.
(define (like-terms b x y combine)
  (define-values (c z) (coefficient b x))
  (define-values (d w) (coefficient b y))
  (define e (combine c d))
  (and (equal? z w) (sum-fits? e c d) (multiply! b e z)))

(define (coefficient b x)
  (define i (instruction-of b x))
  (case (and i (instruction-operation i))
    [(negate) (values -1 (first-operand i))]
    [(multiply)
     (if (number? (first-operand i))
         (values (first-operand i) (second-operand i))
         (values 1 x))]
    [else (values 1 x)]))

;; sign : 1 or -1.  Transparent: equal ones cancel their opposites.
(struct term (sign operand) #:transparent)

;; The terms of a value: two of a sum or difference.
(define (terms b x)
  (define i (instruction-of b x))
  (case (and i (instruction-operation i))
    [(add) (list (term 1 (first-operand i)) (term 1 (second-operand i)))]
    [(subtract) (list (term 1 (first-operand i)) (term -1 (second-operand i)))]
    [else (list (term 1 x))]))

(define (opposite t) (term (- (term-sign t)) (term-operand t)))

;; The sum of terms and others, if one of them is the opposite of one of the others: in
;; Lagrange's equations much is added only to be subtracted.  Otherwise #f.
(define (cancelled b ts others)
  (for*/first ([t (in-list ts)]
               [other (in-value (member (opposite t) others))]
               #:when other)
    (for/fold ([sum 0]) ([rest (in-list (append (remove t ts) (remove (car other) others)))])
      (define x (term-operand rest))
      (if (= (term-sign rest) 1) (add! b sum x) (subtract! b sum x)))))

(define (multiply! b x y)
  (cond [(and (number? x) (number? y)) (* x y)]
        [(or (eqv? x 0) (eqv? y 0)) 0]
        [(number? y) (multiply! b y x)]
        [(and (number? x) (= x 1)) y]
        [(and (number? x) (= x -1)) (negate! b y)]
        [(and (number? x) (scaled b x y)) => (lambda (factors) (apply multiply! b factors))]
        [(negated b x) => (lambda (z) (negate! b (multiply! b z y)))]
        [(negated b y) => (lambda (z) (negate! b (multiply! b x z)))]
        [(and (number? x) (not (representable? b x))) (multiply-in-parts! b x y)]
        [else (do-in-order! b 'multiply x y)]))

(define (representable? b c) (or (flonum? c) (normal? ((builder-constant b) c))))

;; Powers of two are no rounding, and go the way that the value goes: a value that overflows on it
;; does so at its end.
(define (multiply-in-parts! b c x)
  (define part (expt 2 (if (> (abs c) 1) 1000 -1000)))
  (multiply! b part (multiply! b (/ c part) x)))

(define (divide! b x y)
  (cond [(eqv? x 0) 0]
        [(eqv? y 1) x]
        [(and (number? y) (not (eqv? y 0)) (reciprocal-fits? (/ 1 y) y)) (multiply! b (/ 1 y) x)]
        [(negated b x) => (lambda (z) (negate! b (divide! b z y)))]
        [(negated b y) => (lambda (z) (negate! b (divide! b x z)))]
        [(and (number? x) (not (representable? b x))) (multiply! b x (divide! b 1 y))]
        [else (do! b 'divide x y)]))

(define (negate! b x)
  (cond [(number? x) (- x)]
        [(negated b x)]
        [else (do! b 'negate x)]))

;; y if x is the value -y; or #f.
(define (negated b x)
  (define i (instruction-of b x))
  (and i
       (eq? (instruction-operation i) 'negate)
       (first-operand i)))

;; (c z) if x y is c z with a number c; or #f.
(define (scaled b x y)
  (define i (instruction-of b y))
  (define factors
    (if (and i (eq? (instruction-operation i) 'multiply)) (instruction-operands i) '(#f)))
  (define c (and (number? (car factors)) (* ((builder-constant b) x) (car factors))))
  (and c (< 1e-100 (abs c) 1e100) (cons c (cdr factors))))

;; x + y and y + x are one instruction.
(define (do-in-order! b operation x y)
  (if (before? y x) (do! b operation y x) (do! b operation x y)))

(define (before? x y)
  (cond [(number? x) (and (number? y) (< x y))]
        [(number? y) #f]
        [else (< (place-index x) (place-index y))]))

;; m π, which more digits than those of flonums are asked of only if they are kept.
(define (pi-times! b m)
  (if (flonum? ((builder-constant b) 1))
      (* m pi)
      (multiply! b m (do! b 'acos -1))))

;; ---------------------------------------------------------------------------
;; Powers: whole and half exponents by multiplication and square roots.

(define greatest-unrolled 64)

(define (power! b x n)
  (define half-turns (and (rational? n) (exact? n) (* 2 n)))
  (cond [(or (number? x) (not half-turns) (not (integer? half-turns))
             (> (abs n) greatest-unrolled))
         (do! b 'expt x n)]
        [(negative? n) (divide! b 1 (power! b x (- n)))]
        [(integer? n) (whole-power! b x n)]
        [else (multiply! b (whole-power! b x (quotient half-turns 2)) (do! b 'sqrt x))]))

(define (whole-power! b x n)
  (cond [(eqv? n 0) 1]
        [(eqv? n 1) x]
        [(even? n) (let ([root (whole-power! b x (quotient n 2))]) (multiply! b root root))]
        [else (multiply! b x (whole-power! b x (- n 1)))]))
