#lang racket/base
;; SICM 7.2, Pendulum as a Perturbed Rotor (pp. 460–478), in the reader's own language.

(require mechanics)

(provide H0 H1 H-pendulum-series W C C-inv solution0 solution)

(define ((H0 alpha) (up t theta p)) ; a free rotor (p. 462)
  (/ (square p) (* 2 alpha)))

(define ((H1 beta) (up t theta p)) ; and what makes it a pendulum
  (* -1 beta (cos theta)))

(define (H-pendulum-series alpha beta epsilon)
  (series (H0 alpha) (* epsilon (H1 beta))))

;; The generator that removes the first order (p. 462): {H0, W} + H1 = 0.
(define ((W alpha beta) (up t theta p))
  (/ (* -1 alpha beta (sin theta)) p))

;; The transformation from new states to old ones, and back, to an order (p. 464)
(define ((C alpha beta epsilon order) state)
  (series:sum (((Lie-transform (W alpha beta) epsilon) identity) state) order))

(define (C-inv alpha beta epsilon order)
  (C alpha beta (- epsilon) order))

;; The rotor's state at the time t.
(define (((solution0 alpha beta) t) (up t0 theta0 p0))
  (up t
      (+ theta0 (/ (* p0 (- t t0)) alpha))
      p0))

;; The pendulum's: into the new state, on with the rotor, and back.
(define ((((solution epsilon order) alpha beta) t) state)
  ((compose (C alpha beta epsilon order)
            ((solution0 alpha beta) t)
            (C-inv alpha beta epsilon order))
   state))
