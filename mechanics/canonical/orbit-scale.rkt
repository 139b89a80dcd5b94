#lang racket/base
;; Small orbits in their own scale.
;;
;; Integration takes 1 for the size of things that may vanish, and knows nothing of an orbit of
;; 1e-15.  With q in units of a, p in units of b, and H in those of a b, the motion is the same in
;; the same time.  Near a place of rest H is (H_pp p² + H_qq q²)/2 but for a constant, so that p is
;; about r q with r² = H_qq/H_pp, and H_q/H_qq is how far away that place is.  Where H_qq/H_pp is
;; not positive, as about a saddle, orbits that come near go far, and nothing is scaled.
;;
;; Scales are powers of 2, by which nothing is rounded.

(require (only-in racket/math sgn)
         "../calculus/derivative.rkt"
         "../error/refusal.rkt"
         "../generic/arithmetic.rkt" "../generic/up-down.rkt"
         "../hamiltonian/H-state.rkt"
         "../lagrangian/local-tuple.rkt")

(provide scale-of-orbit scale-coordinate scale-action in-scale out-of-scale Hamiltonian-in-scale)

;; The units of coordinate and momentum
(struct scale (coordinate momentum) #:authentic)

(define as-it-is (scale 1.0 1.0))
(define small 1e-3)

(define (scale-action c) (* (scale-coordinate c) (scale-momentum c)))

;; state : in flonums, the orbit's
(define (scale-of-orbit H state)
  (define near? (< 0.0 (max (abs (coordinate state)) (abs (momentum state))) small))
  (define-values (a b) (if near? (size-of-orbit H state) (values 1.0 1.0)))
  (if (and (< 1e-150 a small) (< 1e-150 b small))
      (scale (power-of-2 a) (power-of-2 b))
      as-it-is))

(define (power-of-2 x) (expt 2.0 (round (/ (log x) (log 2.0)))))

;; How large coordinate and momentum become, about; 1.0 where that is not known
(define (size-of-orbit H state)
  (define-values (q p) (values (coordinate state) (momentum state)))
  (define-values (H_q H_qq) (slope-and-bend (lambda (q) (H (up 0.0 q p))) q))
  (define-values (H_p H_pp) (slope-and-bend (lambda (p) (H (up 0.0 q p))) p))
  (cond [(and H_qq H_pp (positive? (* (sgn H_qq) (sgn H_pp))))
         (define r (sqrt (/ H_qq H_pp)))
         (define a (max (abs q) (abs (/ H_q H_qq)) (/ (max (abs p) (abs (/ H_p H_pp))) r)))
         (values a (* r a))]
        [else (values 1.0 1.0)]))

;; -> the first and second derivative, flonums; or #f and #f
(define (slope-and-bend f x)
  (define-values (slope bend)
    (with-handlers ([refusal? (lambda (e) (values #f #f))])
      (values (derivative-at f x)
              (derivative-at (lambda (y) (derivative-at f y)) x))))
  (if (and (real? slope) (rational? slope) (real? bend) (rational? bend))
      (values (exact->inexact slope) (exact->inexact bend))
      (values #f #f)))

(define (in-scale c s)
  (up (time s) (g:/ (coordinate s) (scale-coordinate c)) (g:/ (momentum s) (scale-momentum c))))

(define (out-of-scale c s)
  (up (time s) (g:* (scale-coordinate c) (coordinate s)) (g:* (scale-momentum c) (momentum s))))

(define (Hamiltonian-in-scale H c)
  (if (eq? c as-it-is) H (lambda (s) (g:/ (H (out-of-scale c s)) (scale-action c)))))
