#lang racket/base
;; Spin and orbit (SICM 2.11): the rotation of a moon, about an axis across the plane of its
;; orbit, under the gravity of its planet.
;;
;; With θ the angle of the axis of least moment of inertia, f the true anomaly, R the distance
;; and a its half axis, n the mean motion and ε² = 3 (B − A)/C,
;;
;;     θ̈ = −½ n² ε² (a/R)³ sin 2(θ − f),
;;     a/R = (1 + e cos f)/(1 − e²),      ḟ = n √(1 − e²) (a/R)².

(require "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/compare.rkt" "../generic/describe.rkt"
         "../generic/elementary.rkt" "../generic/function-check.rkt"
         "../generic/printed-function.rkt" "../generic/wrong-argument.rkt"
         "../lagrangian/local-tuple.rkt"
         "../value/structure.rkt")

(provide L-spin-orbit spin-orbit-sysder out-of-roundness)

;; a/R and f are functions of the time.
(define-printed (L-spin-orbit C n epsilon a/R f)
  (for ([g (in-list (list a/R f))])
    (check-takes 'L-spin-orbit g 1 "a/R and f are functions of the time"))
  (lambda (local)
    (check-local-length 'L-spin-orbit local 3)
    (define-values (t theta thetadot) (state-parts local))
    (g:+ (g:* 1/2 C (g:square thetadot))
         (g:* 1/4 (g:square (g:* n epsilon)) C
              (g:* (g:cube (a/R t)) (g:cos (g:* 2 (g:- theta (f t)))))))))

;; The motion of states (up t theta thetadot f) on an orbit of eccentricity e, for evolve
(define-printed (spin-orbit-sysder n epsilon e)
  (check-eccentricity e)
  (lambda (state)
    (unless (and (up? state) (= (s:length state) 4))
      (complain-of-argument 'spin-orbit-sysder "a state (up t theta thetadot f)" state))
    (define-values (_t theta thetadot f) (apply values (structure->list state)))
    (define a/R (g:/ (g:+ 1 (g:* e (g:cos f))) (g:- 1 (g:square e))))
    (up 1
        thetadot
        (g:* -1/2 (g:square (g:* n epsilon))
             (g:* (g:cube a/R) (g:sin (g:* 2 (g:- theta f)))))
        (g:* n (g:* (g:sqrt (g:- 1 (g:square e))) (g:square a/R))))))

(define (check-eccentricity e)
  (define value (comparand e))
  (when (and (real? value) (not (and (<= 0 value) (< value 1))))
    (complain 'spin-orbit-sysder
              "the eccentricity of an orbit that closes is 0 or more and less than 1; given ~a"
              (describe-with-value e))))

;; ε of a body with A ≤ B ≤ C
(define (out-of-roundness A B C) (g:sqrt (g:/ (g:* 3 (g:- B A)) C)))
