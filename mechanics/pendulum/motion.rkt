#lang racket/base
;; The pendulum's motion through any state: by elliptic functions, by integration, and as a
;; Fourier series (scmutils' names).

(require "pendulum.rkt" "phase.rkt"
         "../calculus/elliptic.rkt"
         "../generic/arithmetic.rkt" "../generic/elementary.rkt" "../generic/function.rkt"
         "../generic/on-demand.rkt" "../generic/printed-function.rkt" "../generic/up-down.rkt"
         "../hamiltonian/H-state.rkt"
         "../lagrangian/local-tuple.rkt"
         "../value/series/series-access.rkt")

(require-on-demand ["../motion/evolution.rkt" state-advancer])

(provide pendulum-advance pendulum-integration pendulum-solution-series)

;; (((pendulum-advance α β) state) t) : the state at the time t
(define-of-state (pendulum-advance alpha beta) (state)
  (define who 'pendulum-advance)
  (define E (energy alpha beta state))
  (define swings? (swinging? who alpha beta E))
  (define at
    (cond [(at-rest? who beta E)
           (lambda (t) (up t (in-turn (coordinate state)) (momentum state)))]
          [swings?
           (moving state (pendulum-oscillating-angle alpha beta E)
                   (pendulum-oscillating-angular-momentum alpha beta E)
                   (pendulum-oscillating-dt alpha beta))]
          [else
           (moving state (pendulum-circulating-angle alpha beta E)
                   (pendulum-circulating-angular-momentum alpha beta E)
                   (pendulum-circulating-dt alpha beta)
                   (downwards? who state))]))
  (unary-function (call-datum who state) (t) (at t)))

;; -> t ↦ the state;  angle, momentum-of : functions of the time since θ = 0;  dt : the time of a
;; state since then;  down? : is the motion mirrored, so that it turns upwards?
(define (moving state angle momentum-of dt [down? #f])
  (define (seen s) (if down? (mirrored s) s))
  (define start (dt (seen state)))
  (lambda (t)
    (define since (g:+ start (g:- t (time state))))
    (seen (up t (angle since) (momentum-of since)))))

;; The same by integration
(define-of-state (pendulum-integration alpha beta tolerance) (state)
  (printed-function (pendulum-integration state) (t)
    (define there
      ((state-advancer pendulum-sysder alpha beta) state (g:- t (time state)) tolerance))
    (up (time there) (in-turn (coordinate there)) (momentum there))))

;; (((pendulum-solution-series α β) state) t) : the Fourier series of θ, t from θ = 0 on
(define-of-state (pendulum-solution-series alpha beta) (state)
  (define E (energy alpha beta state))
  (define omega (pendulum-frequency alpha beta E))
  (define swings? (swinging? 'pendulum-solution-series alpha beta E))
  (define-values (k rate)
    (if swings?
        (values (modulus beta E) (omega-0 alpha beta))
        (values (turning-modulus beta E) (omega-R alpha beta E))))
  (define K* (first-elliptic-integral (g:sqrt (g:- 1 (g:square k)))))
  (define (wave n t)
    (define omega-n (g:* n omega))
    (g:/ (g:* omega (g:sin (g:* omega-n t)))
         (g:* omega-n (g:cosh (g:/ (g:* omega-n K*) rate)))))
  (printed-function (pendulum-solution-series state) (t)
    (series:generate
     (lambda (i)
       (cond [swings? (g:* 4 (wave (+ (* 2 i) 1) t))]
             [(= i 0) (g:+ (g:* omega t) (g:* 2 (wave 1 t)))]
             [else (g:* 2 (wave (+ i 1) t))])))))
