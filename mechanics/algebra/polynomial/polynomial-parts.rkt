#lang racket/base
;; Looking into polynomials, and taking them apart along a variable.

(require "arithmetic.rkt" "monomial.rkt" "power.rkt" "ring.rkt" "term-list.rkt")

(provide
 ;; predicates
 poly-zero? poly-constant? poly-constant-value poly=? poly-hash poly-term-count
 ;; degrees
 poly-degree poly-total-degree poly-variables
 ;; terms
 poly-terms poly-term-coefficient poly-term-powers
 poly-leading-coefficient product-leading-coefficient poly-height greatest-of-terms
 ;; along one variable
 poly-coefficients poly-coefficients-over poly-from-coefficients poly-leading-coefficient-in
 poly->vector vector->poly
 poly-derivative poly-substitute)

;; ---------------------------------------------------------------------------
;; Predicates

(define (poly-zero? p) (null? p))

(define (poly-constant? p)
  (or (null? p) (monomial-one? (leading-monomial p))))

;; The value of a constant polynomial.
(define (poly-constant-value p) (poly-leading-coefficient p))

(define (poly=? p q)
  (cond [(eq? p q) #t]
        [(or (null? p) (null? q)) #f]
        [else (and (monomial=? (leading-monomial p) (leading-monomial q))
                   (eqv? (leading-coefficient p) (leading-coefficient q))
                   (poly=? (cdr p) (cdr q)))]))

(define (poly-hash p)
  (for/fold ([h 17]) ([t (in-list p)])
    (bitwise-and (+ (* 31 h)
                    (* 7 (monomial-hash (term-monomial t)))
                    (word (term-coefficient t)))
                 #xFFFFFFFFFFFF)))

(define (word x)
  (bitwise-and (if (fixnum? x) x (equal-hash-code x)) #xFFFFFFFFFFFF))

(define (poly-term-count p) (length p))

(define (poly-leading-coefficient p) (if (null? p) 0 (leading-coefficient p)))

;; Of a product of powers.
(define (product-leading-coefficient factors)
  (for/product ([f (in-list factors)])
    (expt (poly-leading-coefficient (power-base f)) (power-exponent f))))

;; The greatest magnitude of a coefficient.
(define (poly-height p) (greatest-of-terms p (lambda (t) (abs (term-coefficient t)))))

;; The greatest (f term), at least 0
(define (greatest-of-terms p f) (for/fold ([most 0]) ([t (in-list p)]) (max most (f t))))

;; ---------------------------------------------------------------------------
;; Degrees; those of zero are 0

(define (poly-degree R p i)
  (greatest-of-terms p (lambda (t) (monomial-exponent R (term-monomial t) i))))

(define (poly-total-degree R p)
  (if (null? p) 0 (monomial-degree R (leading-monomial p))))

;; The indices of the variables that occur, ascending.
(define (poly-variables R p)
  (define present
    (for/fold ([m (ring-one R)]) ([t (in-list p)]) (monomial-join m (term-monomial t))))
  (map power-base (monomial-factors R present)))

;; ---------------------------------------------------------------------------
;; Terms

;; ((coefficient . powers of variables) ...)
(define (poly-terms R p)
  (for/list ([t (in-list p)])
    (cons (term-coefficient t) (monomial-factors R (term-monomial t)))))

(define poly-term-coefficient car)
(define poly-term-powers cdr)

;; ---------------------------------------------------------------------------
;; Along one variable

;; The slices of p (term-list.rkt): ((degree . coefficient) ...) by decreasing degree in
;; variable i, the coefficients nonzero and free of it.
(define (poly-coefficients R p i)
  (define table (make-hasheqv))
  (for ([t (in-list p)])
    (define m (term-monomial t))
    (define e (monomial-exponent R m i))
    (define reduced
      (if (eq? e 0)
          t
          (make-term (monomial- m (variable-power R i e)) (term-coefficient t))))
    (hash-set! table e (cons reduced (hash-ref table e '()))))
  (for/list ([e (in-list (sort (hash-keys table) >))])
    (make-slice e (reverse (hash-ref table e)))))

;; That of the highest power of variable i; p is not zero.
(define (poly-leading-coefficient-in R p i)
  (define degree (poly-degree R p i))
  (define power (variable-power R i degree))
  (for/list ([t (in-list p)]
             #:when (eq? degree (monomial-exponent R (term-monomial t) i)))
    (make-term (monomial- (term-monomial t) power) (term-coefficient t))))

;; The nonzero coefficients of p as a polynomial in several variables.
(define (poly-coefficients-over R p variables)
  (cond [(null? variables) (list p)]
        [else
         (define part (monomial-part R variables))
         (define table (make-monomial-hash R))
         (for ([t (in-list p)])
           (define m (part (term-monomial t)))
           (define reduced (make-term (monomial- (term-monomial t) m) (term-coefficient t)))
           (hash-set! table m (cons reduced (hash-ref table m '()))))
         (for/list ([terms (in-hash-values table)]) (reverse terms))]))

(define (poly-from-coefficients R i slices)
  (poly-sum R
            (for*/list ([s (in-list slices)]
                        [c (in-value (slice-coefficient s))]
                        #:unless (null? c))
              (define m (variable-monomial R i (slice-degree s)))
              (check-monomial R (monomial+ m (leading-monomial c)))
              (shift-terms m 1 c))))

;; The numbers at the powers of variable i, by ascending degree, when p has no other.
(define (poly->vector R p i)
  (define v (make-vector (+ 1 (poly-degree R p i)) 0))
  (for ([t (in-list p)])
    (vector-set! v (monomial-exponent R (term-monomial t) i) (term-coefficient t)))
  v)

;; The polynomial in variable i with these numbers, times the monomial m.
(define (vector->poly R v i [m (ring-one R)])
  (poly-sum R
            (for/list ([c (in-vector v)] [e (in-naturals)] #:unless (eqv? c 0))
              (list (make-term (monomial+ m (variable-power R i e)) c)))))

(define (poly-derivative R p i)
  (define unit (variable-unit R i))
  (for*/list ([t (in-list p)]
              [e (in-value (monomial-exponent R (term-monomial t) i))]
              #:unless (eq? e 0))
    (make-term (monomial- (term-monomial t) unit) (* e (term-coefficient t)))))

;; p with the polynomial q in the place of variable i, by Horner's rule.
(define (poly-substitute R p i q)
  (let loop ([cs (poly-coefficients R p i)] [value '()] [at #f])
    (define (times-power v k) (if (eqv? k 0) v (poly* R v (poly-expt R q k))))
    (cond [(null? cs) (if at (times-power value at) value)]
          [else
           (define e (slice-degree (car cs)))
           (define c (slice-coefficient (car cs)))
           (loop (cdr cs) (poly+ R (if at (times-power value (- at e)) value) c) e)])))
