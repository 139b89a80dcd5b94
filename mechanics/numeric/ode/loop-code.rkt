#lang racket/base
;; The formulas of a method as loops over vectors, two components at a time
;; (numeric/machine/elements.rkt), the rates being a procedure that is called in between.
;;
;; Code within a procedure (method-memory.rkt): h is on the stack, and vectors are in their places.

(require racket/list
         "method-memory.rkt"
         "../machine/assembler.rkt" "../machine/elements.rkt" "../machine/executable.rkt")

(provide call-rates! write-stages! write-error! write-coefficients! write-value!)

;; ---------------------------------------------------------------------------
;; Slopes

;; rates : label of a procedure (numeric/machine/straight-code.rkt)
(define (call-rates! a places from to rates)
  (lea! a rdi (vector-start places from))
  (lea! a rsi (vector-start places to))
  (lea! a rdx (vector-start places 'parameters))
  (call! a rates))

;; stages : as method-formulas.rkt has them
(define (write-stages! a n places from to stages rates)
  (define (reach! name terms)
    (emit-elements! a n (with-length a places)
                    `((store ,name (fl+ (at ,from i) (fl* h (weighted i ,@terms)))))))
  (for ([s (in-list (first stages))])
    (reach! 'w (cdr s))
    (call-rates! a places 'w (car s) rates))
  (define end (second stages))
  (cond [(pair? end) (reach! to end)]
        [end (emit-elements! a n places `((store ,to (at w i))))]))

;; ---------------------------------------------------------------------------
;; The error of a step

;; Sums of squares first, component after component.
(define (write-error! a n places error)
  (define-values (means formulas dividend divisor) (apply values error))
  (define sums (for/list ([m (in-list means)] [r (in-naturals 13)]) (number-in r)))
  (for ([s (in-list sums)])
    (xorpd! a (number-in-register s) (number-in-register s)))
  (define with-sums
    (for/fold ([places places]) ([m (in-list means)] [s (in-list sums)])
      (hash-set places (first m) s)))
  (emit-elements! a n with-sums
                  `((local scale (fl+ 1.0 (flmax (flabs (at y i)) (flabs (at z i)))))
                    ,@(append*
                       (for/list ([m (in-list means)])
                         `((local x (fl/ (weighted i ,@(rest m)) scale))
                           (total ,(first m) (fl* x x)))))))
  (emit-elements! a 1
                  (with-length a with-sums)
                  `(,@(for/list ([m (in-list means)])
                        `(local ,(first m) (flsqrt (fl/ ,(first m) ,n))))
                    ,@(for/list ([f (in-list formulas)]) (cons 'local f))
                    (local d ,divisor)
                    (store divisor d)
                    (store error (fl/ ,dividend d)))))

;; ---------------------------------------------------------------------------
;; Interpolants

;; A coefficient that others are made of stays in a register as well.
(define (write-coefficients! a n places coefficients)
  (define used (flatten (map rest coefficients)))
  (emit-elements! a n (with-length a places)
                  (append*
                   (for/list ([c (in-list coefficients)])
                     (define-values (name formula) (values (first c) (second c)))
                     (if (memq name used)
                         `((local ,name ,formula) (store ,(kept-name name) ,name))
                         `((store ,(kept-name name) ,formula)))))))

;; A procedure, of theta kept out: x + θ (c₀ + (1 − θ) (c₁ + θ (c₂ + ...)))
(define (write-value! a n formulas)
  (define-values (theta other) (values 15 14))
  (unpcklpd! a 0 0)
  (movapd! a theta 0)
  (movapd! a other (constant 1.0))
  (subpd! a other theta)
  (add! a rdi flvector-data)
  (add! a rsi flvector-data)
  (emit-elements! a n
                  (with-coefficients formulas n
                    (hasheq 'out (vector-at rsi 0)
                            'theta (number-in theta) 'other (number-in other))
                    rdi)
                  `((store out ,(nested (map first (method-formulas-coefficients formulas))))))
  (ret! a))

(define (nested names [factor 'theta] [other 'other])
  (define c `(at ,(kept-name (first names)) i))
  (if (null? (rest names))
      c
      `(fl+ ,c (fl* ,factor ,(nested (rest names) other factor)))))
