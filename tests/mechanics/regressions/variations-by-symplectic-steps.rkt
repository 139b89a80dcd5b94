#lang racket/base
;; A method that moves coordinates and velocities in turn cannot follow displacements, and said so
;; of a state that nobody had written, "takes states of a time, some coordinates and as many
;; velocities or momenta, state: (up (up 0.0 1.0 0.0) (up 0.0 0.0 0.0))", by the name state-advancer
;; for linearized-flow.

(require (except-in mechanics time)
         "../support/checks.rkt" "../support/messages.rkt")

(define ((oscillator w) s) (up 1 (ref s 2) (* -1 (square w) (ref s 1))))
(define start (up 0 1 0))

(define (by-flow method) ((linearized-flow oscillator 2) start 1 1e-11 #:method method))
(define (by-D method)
  ((D (lambda (w) ((state-advancer oscillator w) start 1 1e-11 #:method method))) 2))

(define (told who name instead)
  (string-append who ": " name " follows a state and not how it depends on where it starts\n"
                 "  use " instead ", or a method that chooses its own steps"))

(says
 [(by-flow (leapfrog 0.01)) (told "linearized-flow" "leapfrog" "(Gauss-Legendre-2 0.01)")]
 [(by-flow (Yoshida-8 0.25)) (told "linearized-flow" "Yoshida-8" "(Gauss-Legendre-6 0.25)")]
 [(by-D (leapfrog 0.01)) (told "state-advancer" "leapfrog" "(Gauss-Legendre-2 0.01)")])

(test-case "what is named instead follows them: x = cos ωt"
  (check-= (ref (by-flow (Gauss-Legendre-6 0.05)) 1 1) (cos 2.0) 1e-8)
  (check-= (ref (by-D (Gauss-Legendre-6 0.05)) 1) (- (sin 2.0)) 1e-8))

;; evolve-trajectory has a keyword for the tolerance, those that are the book's do not.
(define (place who keywords after)
  (string-append who ": there is no keyword #:tolerance here\n  its keywords: (" keywords
                 "#:longest-step #:method #:most-steps #:precision #:progress?)\n"
                 "  the tolerance is given without one, after the " after))

(says
 [((state-advancer oscillator 2) start 1 #:tolerance 1e-8)
  (place "state-advancer" "" "duration")]
 [((linearized-flow oscillator 2) start 1 #:tolerance 1e-8)
  (place "linearized-flow" "#:by-parameters? " "duration")]
 [((evolve oscillator 2) start void 1 2 #:tolerance 1e-8)
  (place "evolve" "" "final time")])
