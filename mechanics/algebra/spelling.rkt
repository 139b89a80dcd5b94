#lang racket/base
;; In which angles a polynomial is written.
;;
;; Choosing between sin² and cos², and contracting products, finds most short
;; forms, but not sin²(θ - φ), which is spread over four terms in sines and
;; cosines of θ and φ.  So where two angles occur to the second degree, the terms
;; that agree in all else are also written in δ = θ ± φ and φ, by
;;
;;     sin θ = sin δ cos φ ∓ cos δ sin φ,   cos θ = cos δ cos φ ± sin δ sin φ,
;;
;; and the form with fewest terms is kept.

(require "kernel.rkt" "field.rkt" "squares.rkt" "contract.rkt"
         "polynomial/polynomial.rkt" "polynomial/fraction.rkt" "polynomial/ring.rkt")

(provide spell)

;; -> ((coefficient . ((kernel . exponent) ...)) ...), a sum equal to p modulo
;; the relations.
(define (spell F p)
  (define circles (field-circular-circles F))
  (define-values (dense rest)
    (if (or (null? circles) (null? (cdr circles)))
        (values '() p)
        (dense-groups F p circles)))
  (append (spell-as-is F rest)
          (apply append (map (lambda (g) (spell-group F g circles)) dense))))

(define (spell-as-is F p)
  (if (null? p)
      '()
      (contract-angles F
                       (shortest-squares F p)
                       (lambda (a b sign) (field-circle-sum F a b sign))
                       (lambda (o) (field-doubled? F o)))))

(define (field-circular-circles F)
  (for*/list ([k (in-vector (field-kernels F))]
              [o (in-value (kernel-relation k))]
              #:when (and (circle? o) (eqv? 1 (circle-sign o))))
    o))

(define (sine-index o) (kernel-index (circle-sine o)))
(define (cosine-index o) (kernel-index (circle-cosine o)))

;; ---------------------------------------------------------------------------
;; Dense groups

;; -> the groups of terms that agree outside the circles and have two circles to
;; the second degree, each with those circles; and the other terms, a polynomial.
(define (dense-groups F p circles)
  (define R (field-ring F))
  (define square (ormap (lambda (t) (>= (square-count R t circles) 1)) p))
  (if square
      (split-dense R p circles)
      (values '() p)))

(define (square-count R t circles)
  (for/sum ([o (in-list circles)]) (if (>= (angular-degree R t o) 2) 1 0)))

(define (angular-degree R t o)
  (+ (monomial-exponent R (car t) (sine-index o)) (monomial-exponent R (car t) (cosine-index o))))

(define (split-dense R p circles)
  (define groups (groups-outside R p circles))
  (for/fold ([dense '()] [rest '()] #:result (values (reverse dense) (poly-sum R rest)))
            ([g (in-list groups)])
    (define squared
      (for/list ([o (in-list circles)]
                 #:when (for/or ([t (in-list g)]) (>= (angular-degree R t o) 2)))
        o))
    (if (and (pair? squared) (pair? (cdr squared)) (> (length g) 2))
        (values (cons (cons g squared) dense) rest)
        (values dense (cons g rest)))))

(define (groups-outside R p circles)
  (define inside (append (map sine-index circles) (map cosine-index circles)))
  (define outside
    (monomial-part R (for/list ([i (in-range (ring-size R))] #:unless (memv i inside)) i)))
  (define table (make-monomial-hash R))
  (define order
    (for/fold ([order '()]) ([t (in-list p)])
      (define m (outside (car t)))
      (define group (hash-ref table m '()))
      (hash-set! table m (cons t group))
      (if (null? group) (cons m order) order)))
  (for/list ([m (in-list (reverse order))]) (reverse (hash-ref table m))))

;; ---------------------------------------------------------------------------
;; Other angles

;; group : (terms . circles)
(define (spell-group F group circles)
  (define p (car group))
  (define usual (spell-as-is F p))
  (if (<= (length usual) 2)
      usual
      (for*/fold ([best usual])
                 ([a (in-list (cdr group))] [b (in-list (cdr group))]
                  #:unless (eq? a b)
                  [sign (in-list '(-1 1))])
        (define other (spell-in F p a b sign))
        (if (and other (< (length other) (length best))) other best))))

;; p written in δ = a + sign b and b, or #f if that passes the ring's degree.
;; The variables of a stand for δ then.
(define (spell-in F p a b sign)
  (define sum (field-circle-sum F a b sign))
  (define turned
    (with-handlers ([exn:algebra:degree-overflow? (lambda (x) #f)])
      (substitute-angle F p a b sign (cdr sum))))
  (and turned
       (spell-as-is (rename-circle F a (car sum)) turned)))

;; orientation : 1 if δ is the angle of the circle the variables will stand for,
;; -1 if it is the opposite.
(define (substitute-angle F p a b sign orientation)
  (define R (field-ring F))
  (define (variable i) (poly-variable R i))
  (define sine-δ (poly-scale R orientation (variable (sine-index a))))
  (define cosine-δ (variable (cosine-index a)))
  (define sine-b (variable (sine-index b)))
  (define cosine-b (variable (cosine-index b)))
  (define sine
    (poly- R (poly* R sine-δ cosine-b) (poly-scale R sign (poly* R cosine-δ sine-b))))
  (define cosine
    (poly+ R (poly* R cosine-δ cosine-b) (poly-scale R sign (poly* R sine-δ sine-b))))
  (define turned
    (poly-sum R
      (for*/list ([s (in-list (poly-coefficients R p (sine-index a)))]
                  [c (in-list (poly-coefficients R (cdr s) (cosine-index a)))])
        (poly* R (cdr c)
               (poly* R (poly-expt R sine (car s)) (poly-expt R cosine (car c)))))))
  (fraction-numerator (reduce-poly F turned)))

;; The field with the variables of circle a standing for those of another.
(define (rename-circle F a new)
  (define kernels (vector-copy (field-kernels F)))
  (define (rename! i k)
    (set-kernel-index! k i)
    (vector-set! kernels i k))
  (rename! (sine-index a) (circle-sine new))
  (rename! (cosine-index a) (circle-cosine new))
  (struct-copy field F [kernels kernels]))

(define (vector-copy v)
  (define new (make-vector (vector-length v)))
  (vector-copy! new 0 v)
  new)
