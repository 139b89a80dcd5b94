#lang racket/base
;; Small orbits in their own scale.
;;
;; Integration takes 1 for the size of things that may vanish, and knows nothing of an orbit of
;; 1e-15.  With q in units of a, p in units of b, and H in those of a b, the motion is the same in
;; the same time.  Near a place of rest H = (H_pp p² + H_qq q²)/2, so that p is about r q with
;; r² = |H_qq/H_pp|; where that is no number, nothing is scaled.
;;
;; Scales are powers of 2, by which nothing is rounded.

(require "../calculus/derivative.rkt"
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
  (define-values (q p) (values (abs (coordinate state)) (abs (momentum state))))
  (define r (and (< 0.0 (max q p) small) (momentum-per-coordinate H state)))
  (define a (if r (max q (/ p r)) 1.0))
  (if (and r (< 1e-150 a small) (< 1e-150 (* r a) small))
      (scale (power-of-2 a) (power-of-2 (* r a)))
      as-it-is))

(define (power-of-2 x) (expt 2.0 (round (/ (log x) (log 2.0)))))

;; r, or #f
(define (momentum-per-coordinate H state)
  (define-values (q p) (values (coordinate state) (momentum state)))
  (define (bend f x) (derivative-at (lambda (y) (derivative-at f y)) x))
  (with-handlers ([refusal? (lambda (e) #f)])
    (define H_qq (bend (lambda (q) (H (up 0.0 q p))) q))
    (define H_pp (bend (lambda (p) (H (up 0.0 q p))) p))
    (and (real? H_qq) (rational? H_qq) (real? H_pp) (rational? H_pp)
         (not (zero? H_qq)) (not (zero? H_pp))
         (sqrt (abs (/ (exact->inexact H_qq) H_pp))))))

(define (in-scale c s)
  (up (time s) (g:/ (coordinate s) (scale-coordinate c)) (g:/ (momentum s) (scale-momentum c))))

(define (out-of-scale c s)
  (up (time s) (g:* (scale-coordinate c) (coordinate s)) (g:* (scale-momentum c) (momentum s))))

(define (Hamiltonian-in-scale H c)
  (if (eq? c as-it-is) H (lambda (s) (g:/ (H (out-of-scale c s)) (scale-action c)))))
