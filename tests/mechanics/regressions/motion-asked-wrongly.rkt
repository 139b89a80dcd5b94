#lang racket/base
;; Parameters left out or given twice, lists for states, equal times: the messages
;; showed #<procedure:...>, the place of a lambda in the library, or a division by
;; zero.

(require mechanics
         (only-in mechanics/book L-harmonic)
         "../support/checks.rkt" "../support/messages.rkt")

(define (harmonic m k) (Lagrangian->state-derivative (L-harmonic m k)))
(define unit (harmonic 1 1))
(define start (up 0.0 1.0 0.0))

(test-case "the maker of a state derivative takes the parameters that follow it"
  (for ([follow (list state-advancer evolve)] [who '("state-advancer" "evolve")])
    (check-message
     (string-append
      who ": expected as many parameters as the maker of the state derivative takes\n"
      "  maker: the procedure `harmonic`, which takes 2 arguments\n  parameters: (1.0)")
     (follow harmonic 1.0))
    (check-exn #rx"parameters: none$" (lambda () (follow harmonic)))
    (check-exn #rx"parameters: [(]1 1[)]\n  a state derivative itself is given without parameters$"
               (lambda () (follow unit 1 1)))))

(test-case "a state derivative alone, or made without parameters, is followed"
  (define there (up 1.0 (cos 1.0) (- (sin 1.0))))
  (for ([maker (list unit (lambda () unit))])
    (define reached ((state-advancer maker) start 1.0))
    (for ([k 3])
      (check-= (ref reached k) (ref there k) 1e-9))))

(test-case "what makes no trajectory is described as it was written"
  (check-message
   (string-append
    "evolve-trajectory: expected a state derivative, a function of the state\n"
    "  given: the procedure `harmonic`, which takes 2 arguments\n"
    "  parameters are supplied first: (harmonic ...)")
   (evolve-trajectory harmonic start 1.0))
  (check-message
   "evolve-trajectory: expected a state derivative, a function of the state\n  given: the number 3"
   (evolve-trajectory 3 start 1.0))
  (check-exn #rx"expected a state, .*a list is not a tuple; use [(]up t q v[)]$"
             (lambda () (evolve-trajectory unit '(0.0 1.0 0.0) 1.0)))
  (check-exn #rx"[(]event f[)] makes one.*\n  given: the procedure `coordinate`$"
             (lambda () (evolve-trajectory unit start 1.0 #:events coordinate))))

(test-case "compile-function and what it makes tell what they take"
  (define (product x y) (* x y))
  (check-message
   (string-append "compile-function: expected a function of one structure\n"
                  "  given: the procedure `product`, which takes 2 arguments\n"
                  "  parameters are supplied first: (product ...)")
   (compile-function product 1.0))
  (check-message
   "(compile-function square): takes an flvector, such as (flvector 1.0)\n  given: the number 3.0"
   ((compile-function square 1.0) 3.0))
  (check-exn #rx"such as [(]flvector 1.0 2.0 [.][.][.][)]\n  given: [(]up 2 3[)], an up tuple of 2$"
             (lambda () ((compile-function square (up 1.0 1.0)) (up 2 3)))))

(test-case "a path of least action takes time"
  (check-message "find-path: the initial and the final time are the same\n  time: 1"
                 (find-path (L-harmonic 1 1) 1 0 1 2 3)))
