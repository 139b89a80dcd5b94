#lang racket/base
;; Roots of A cos u + B sin u + C with u = a x + b: all within a turn of x where a is a whole
;; number, else those within a turn of u.  Multiples of :pi are exact.

(require "angles-in.rkt" "root.rkt"
         "../expression/constant-value.rkt" "../expression/expression.rkt"
         "../expression/operation.rkt" "../expression/pi.rkt"
         "../expression/substitute.rkt" "../expression/symbols.rkt"
         "../simplify/simplify-expression.rkt")

(provide angle-roots)

(define (angle-roots f x A)
  (define angles (angles-of f x))
  (define u (and (= 1 (length angles)) (car angles)))
  (define ab (and u (line u x A)))
  (define coefficients (and ab (wave-coefficients f x u A)))
  (define solutions (and coefficients (angles-where coefficients A)))
  (define turns (if solutions (turns-of (car ab)) 1))
  (and solutions
       (for*/list ([j (in-range turns)] [s (in-list solutions)])
         (define angle (e:+ (turn-angle s) (e:* (* 2 j) exact-pi)))
         (define value (quotient-of (e:- angle (cadr ab)) (car ab) A))
         (root x
               (if (= turns 1) value (within-turn value A))
               (turn-conditions s)
               (for/list ([op (in-list (list op:cos op:sin))]
                          [value (in-list (list (turn-cosine s) (turn-sine s)))]
                          #:when value)
                 (cons (make-node op (list u)) value))))))

;; How often a x goes round while x does once.
(define (turns-of a) (if (exact-integer? a) (abs a) 1))

;; A multiple of π as the one above −π and up to π that differs from it by turns.
(define (within-turn angle A)
  (define parts (simplify-expression (e:/ angle exact-pi) A))
  (if (and (rational? parts) (exact? parts) (not (<= -1 parts 1)))
      (e:* (- parts (* 2 (ceiling (/ (- parts 1) 2)))) exact-pi)
      angle))

;; ---------------------------------------------------------------------------
;; The angle u

;; (A B C), or #f
(define (wave-coefficients f x u A)
  (define (of op) (make-node op (list u)))
  (define (with cosine sine)
    (simplify-expression
     (substitute-expression f (list (cons (of op:cos) cosine) (cons (of op:sin) sine))) A))
  (define C (with 0 0))
  (define (coefficient value) (simplify-expression (e:- value C) A))
  (define cosine (coefficient (with 1 0)))
  (define sine (coefficient (with 0 1)))
  (define wave (e:+ (e:* cosine (of op:cos)) (e:+ (e:* sine (of op:sin)) C)))
  (and (zero-everywhere? (e:- f wave) A)
       (not (ormap (lambda (e) (occurs? x e)) (list cosine sine C)))
       (list cosine sine C)))

;; An angle with its cosine and its sine, #f for one without a short form.
(struct turn (angle cosine sine conditions) #:authentic)

;; -> a list of turns where A cos u + B sin u + C is 0
(define (angles-where coefficients A)
  (define-values (a b c) (apply values coefficients))
  (cond [(eqv? b 0) (if (eqv? c 0) (list upwards downwards) (cosine-is (ratio-of c a A) A))]
        [(eqv? a 0) (if (eqv? c 0) (list ahead behind) (sine-is (ratio-of c b A) A))]
        [(eqv? c 0) (tangent-is (ratio-of a b A) A)]
        [else (cosine-from-direction a b c A)]))

(define (ratio-of b a A) (quotient-of (e:negate b) a A))

(define-values (ahead behind upwards downwards)
  (values (turn 0 1 0 '()) (turn exact-pi -1 0 '())
          (turn (e:* 1/2 exact-pi) 0 1 '()) (turn (e:* -1/2 exact-pi) 0 -1 '())))

(define (cosine-is x A)
  (for/list ([sign (in-list (either x 1 -1))])
    (turn (e:* sign (inverse op:acos x A)) x #f (bound-on x))))

(define (sine-is x A)
  (define u (inverse op:asin x A))
  (for/list ([angle (in-list (either x u (e:- exact-pi u)))])
    (turn angle #f x (bound-on x))))

(define (tangent-is x A)
  (define u (inverse op:atan x A))
  (list (turn u #f #f '()) (turn (e:+ exact-pi u) #f #f '())))

;; R cos(u − δ) = −C
(define (cosine-from-direction a b c A)
  (define R (simplify-expression (applied op:sqrt (e:+ (e:* a a) (e:* b b))) A))
  (define direction (simplify-expression (direction-of a b) A))
  (for/list ([t (in-list (cosine-is (ratio-of c R A) A))])
    (turn (e:+ direction (turn-angle t)) #f #f (turn-conditions t))))

(define (inverse op x A)
  (simplify-expression (applied op x) A))

;; The angle of the point (a, b)
(define (direction-of a b)
  (if (and (real? a) (positive? a)) (applied op:atan (e:/ b a)) (applied op:atan b a)))

;; The two of a sine or cosine x, that are one at the ends.
(define (either x a b)
  (define n (number-of x))
  (cond [(or (not n) (< -1 n 1)) (list a b)]
        [(= 1 (abs n)) (list a)]
        [else '()]))
(define (bound-on x) (if (number-of x) '() (list (list '<= -1 x 1))))

;; -> a number, or #f where there are unknowns
(define (number-of x) (if (real? x) x (constant-value x)))
