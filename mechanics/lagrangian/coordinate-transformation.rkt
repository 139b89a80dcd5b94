#lang racket/base
;; Coordinate transformations of local tuples (SICM 1.6.1, pp. 44–48, and 1.9).
;;
;; F gives the old coordinates as a function of the new local tuple, q = F(t, q').
;; The transformation C it induces on local tuples has the total time
;; derivatives of F as its further components; the first of them,
;; ∂₀F + ∂₁F v, is the derivative of F in the direction (1, v), and one run of F
;; on dual numbers gives it together with the value.

(require "local-tuple.rkt"
         "../calculus/derivative.rkt"
         "../error/complain.rkt" "../error/hint.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/elementary.rkt"
         "../generic/function.rkt" "../generic/printed-function.rkt" "../generic/scalar.rkt"
         "../generic/up-down.rkt" "../generic/wrong-argument.rkt"
         "../value/compose.rkt" "../value/structure.rkt")

(provide F->C Gamma-bar osculating-path
         p->r r->p s->r r->s)

(define (F->C F)
  (check-argument 'F->C procedure? F "a coordinate transformation: a function of the local tuple")
  (unless (of-functions? F)
    (complain 'F->C "a coordinate transformation is a function of the local tuple; given ~a~a"
              (describe-with-value F)
              "\n  its value is such a tuple: (lambda (local) (up ...))"))
  (unless (accepts? F 1) (raise-takes-parameters F))
  (printed-function (F->C F) (local) (transform F local)))

(define (raise-takes-parameters F)
  (complain 'F->C
            (string-append "a coordinate transformation takes one argument, the local tuple, "
                           "but ~a takes ~a."
                           "\n  If it takes parameters first, supply them: (F->C (~a ...))")
            (value->text F) (arity->text F) (value->text F)))

(define (transform F local)
  (check-local-tuple local)
  (define n (s:length local))
  (if (= n 3)
      (let-values ([(q v) (value-and-derivative-along F local (drift local))])
        (up (time local) q v))
      ((Gamma-bar (lambda (q) (Gamma (compose F (Gamma q)) n))) local)))

;; At least (t, q, v), and v of the shape of q.
(define (check-local-tuple local)
  (check-local-length 'F->C local 3)
  (unless (same-shape? (coordinate local) (velocity local))
    (complain 'F->C
              (string-append "the velocities are not of the shape of the coordinates"
                             "\n  coordinates: ~a"
                             "\n  velocities: ~a~a")
              (value->text (coordinate local)) (value->text (velocity local))
              (if (same-shape? (coordinate local) (flip (velocity local)))
                  "\n  they are momenta: states of these are transformed by (F->CH F)"
                  ""))))

;; How a local tuple (t, q, v) moves: (1, v, 0).
(define (drift local)
  (up 1 (velocity local) (zero-like (velocity local))))

;; A function of paths made into a function of local tuples, by way of a path
;; that has the local tuple's derivatives at its time (SICM p. 95).
(define ((Gamma-bar f-bar) local)
  ((f-bar (osculating-path local)) (time local)))

;; q + v (t − t₀) + a (t − t₀)²/2 + ... through the local tuple (SICM p. 96).
(define (osculating-path local)
  (check-local-length 'osculating-path local 2)
  (define parts (cdr (structure->list local)))
  (lambda (t)
    (define dt (g:- t (time local)))
    (for/fold ([sum (car parts)] [coefficient 1] [k 1] #:result sum)
              ([part (in-list (cdr parts))])
      (define c (g:/ (g:* coefficient dt) k))
      (values (g:+ sum (g:* c part)) c (add1 k)))))

;; ---------------------------------------------------------------------------
;; Named transformations, from the first coordinates to the second.  Given coordinates
;; alone, n scalars in a tuple, they transform these: a local tuple has all its coordinates
;; in its second component, and is never one of n scalars for n > 1.

(define (tuple-coordinates who n given)
  (define q
    (cond [(coordinates-alone? n given) given]
          [(local-tuple? given) (coordinate given)]
          [else #f]))
  (unless (and q (tuple? q) (= (s:length q) n))
    (complain who "expected a local tuple with ~a coordinates; given ~a~a"
              n (describe-with-value given) (list-hint given "(up t q v ...)")))
  (structure->list q))

(define (coordinates-alone? n x)
  (and (up? x) (= (s:length x) n) (andmap scalar? (structure->list x))))

;; (r, φ) to (x, y)
(define (p->r local)
  (define-values (r phi) (apply values (tuple-coordinates 'p->r 2 local)))
  (up (g:* r (g:cos phi)) (g:* r (g:sin phi))))

;; (x, y) to (r, φ)
(define (r->p local)
  (define-values (x y) (apply values (tuple-coordinates 'r->p 2 local)))
  (up (g:sqrt (g:+ (g:square x) (g:square y))) (g:atan y x)))

;; (r, θ, φ), colatitude θ, to (x, y, z)
(define (s->r local)
  (define-values (r theta phi) (apply values (tuple-coordinates 's->r 3 local)))
  (define rho (g:* r (g:sin theta)))
  (up (g:* rho (g:cos phi)) (g:* rho (g:sin phi)) (g:* r (g:cos theta))))

;; (x, y, z) to (r, θ, φ)
(define (r->s local)
  (define-values (x y z) (apply values (tuple-coordinates 'r->s 3 local)))
  (define r (g:sqrt (g:+ (g:square x) (g:square y) (g:square z))))
  (up r (g:acos (g:/ z r)) (g:atan y x)))
