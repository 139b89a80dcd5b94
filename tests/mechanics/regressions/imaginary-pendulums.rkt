#lang racket/base
;; Pendulums and polar coordinates with parameters that are not positive had imaginary motions;
;; functions as parameters were left in results.

(require (except-in mechanics time)
         "../support/checks.rkt" "../support/close.rkt" "../support/messages.rkt")

(says
 [(polar-canonical -1) "polar-canonical: alpha is positive; given the number -1"]
 [(polar-canonical 0) "polar-canonical: alpha is positive; given the number 0"]
 [(polar-canonical +nan.0) "polar-canonical: alpha is positive; given the number +nan.0"]
 [(polar-canonical-inverse 1+2i)
  "polar-canonical-inverse: alpha is positive; given the number 1+2i"]
 [(pendulum-separatrix-action -1 9.8)
  "pendulum-separatrix-action: alpha is positive; given the number -1"]
 [(pendulum-separatrix-angle 1 +nan.0)
  "pendulum-separatrix-angle: beta is positive; given the number +nan.0"]
 [(pendulum-separatrix-angular-momentum 1 0)
  "pendulum-separatrix-angular-momentum: beta is positive; given the number 0"]
 [(pendulum-frequency sin 9.8 1)
  "pendulum-frequency: alpha is a number or a symbol; given the procedure `sin`"])

(test-case "symbols and derivatives are parameters still"
  (check-equal? (format "~a" ((polar-canonical 'alpha) (up 't 0 'I)))
                "(up t 0 (sqrt (* 2 I alpha)))")
  ;; 8 √(α β)/π
  (check-close ((D (lambda (a) (pendulum-separatrix-action a 4))) 1.0) (/ 8 pi) 1e-12)
  (check-close (ref ((D (lambda (a) ((polar-canonical a) (up 0 1.0 2.0)))) 2.0) 1)
               (* -1/4 (sqrt 2) (sin 1)) 1e-12))
