#lang racket/base
;; Looking into polynomials, and taking them apart along a variable.

(require "arithmetic.rkt" "monomial.rkt" "ring.rkt")

(provide
 ;; predicates
 poly-zero? poly-constant? poly-constant-value poly=? poly-hash poly-term-count
 ;; degrees
 poly-degree poly-total-degree poly-variables
 ;; terms
 poly-terms poly-for-each-term
 poly-leading-coefficient
 ;; along one variable
 poly-coefficients poly-coefficients-over poly-from-coefficients poly-derivative poly-substitute)

;; ---------------------------------------------------------------------------
;; Predicates

(define (poly-zero? p) (null? p))

(define (poly-constant? p)
  (or (null? p) (monomial-one? (caar p))))

;; The value of a constant polynomial.
(define (poly-constant-value p) (if (null? p) 0 (cdar p)))

(define (poly=? p q)
  (cond [(eq? p q) #t]
        [(or (null? p) (null? q)) #f]
        [else (and (monomial=? (caar p) (caar q))
                   (eqv? (cdar p) (cdar q))
                   (poly=? (cdr p) (cdr q)))]))

(define (poly-hash p)
  (for/fold ([h 17]) ([t (in-list p)])
    (bitwise-and (+ (* 31 h) (* 7 (monomial-hash (car t))) (word (cdr t)))
                 #xFFFFFFFFFFFF)))

(define (word x)
  (bitwise-and (if (fixnum? x) x (equal-hash-code x)) #xFFFFFFFFFFFF))

(define (poly-term-count p) (length p))

(define (poly-leading-coefficient p) (if (null? p) 0 (cdar p)))

;; ---------------------------------------------------------------------------
;; Degrees; those of zero are 0

(define (poly-degree R p i)
  (for/fold ([d 0]) ([t (in-list p)])
    (max d (monomial-exponent R (car t) i))))

(define (poly-total-degree R p)
  (if (null? p) 0 (monomial-degree R (caar p))))

;; The indices of the variables that occur, ascending.
(define (poly-variables R p)
  (define present
    (for/fold ([m (ring-one R)]) ([t (in-list p)]) (monomial-join m (car t))))
  (map car (monomial-factors R present)))

;; ---------------------------------------------------------------------------
;; Terms

;; ((coefficient . ((index . exponent) ...)) ...)
(define (poly-terms R p)
  (for/list ([t (in-list p)])
    (cons (cdr t) (monomial-factors R (car t)))))

(define (poly-for-each-term R p visit)
  (for ([t (in-list p)])
    (visit (cdr t) (monomial-exponents R (car t)))))

;; ---------------------------------------------------------------------------
;; Along one variable

;; ((degree . coefficient) ...) by decreasing degree in variable i, the
;; coefficients nonzero and free of it.
(define (poly-coefficients R p i)
  (define table (make-hasheqv))
  (for ([t (in-list p)])
    (define e (monomial-exponent R (car t) i))
    (define reduced
      (if (eq? e 0) t (cons (monomial- (car t) (variable-power R i e)) (cdr t))))
    (hash-set! table e (cons reduced (hash-ref table e '()))))
  (for/list ([e (in-list (sort (hash-keys table) >))])
    (cons e (reverse (hash-ref table e)))))

;; The nonzero coefficients of p as a polynomial in several variables.
(define (poly-coefficients-over R p variables)
  (cond [(null? variables) (list p)]
        [else
         (define part (monomial-part R variables))
         (define table (make-monomial-hash R))
         (for ([t (in-list p)])
           (define m (part (car t)))
           (hash-set! table m (cons (cons (monomial- (car t) m) (cdr t)) (hash-ref table m '()))))
         (for/list ([terms (in-hash-values table)]) (reverse terms))]))

(define (poly-from-coefficients R i alist)
  (poly-sum R
            (for/list ([entry (in-list alist)] #:unless (null? (cdr entry)))
              (define m (variable-monomial R i (car entry)))
              (check-monomial R (monomial+ m (caar (cdr entry))))
              (shift-terms m 1 (cdr entry)))))

(define (poly-derivative R p i)
  (define unit (variable-unit R i))
  (let loop ([p p])
    (cond [(null? p) '()]
          [else
           (define m (caar p))
           (define e (monomial-exponent R m i))
           (if (eq? e 0)
               (loop (cdr p))
               (cons (cons (monomial- m unit) (* e (cdar p))) (loop (cdr p))))])))

;; p with the polynomial q in the place of variable i, by Horner's rule.
(define (poly-substitute R p i q)
  (let loop ([cs (poly-coefficients R p i)] [value '()] [at #f])
    (define (times-power v k) (if (eqv? k 0) v (poly* R v (poly-expt R q k))))
    (cond [(null? cs) (if at (times-power value at) value)]
          [else
           (define e (caar cs))
           (loop (cdr cs)
                 (poly+ R (if at (times-power value (- at e)) value) (cdar cs))
                 e)])))
