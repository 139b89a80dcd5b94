#lang racket/base
;; States of Routhians, (t, (x, y), (ẋ, p_y)), and what is wrong with those that are none.

(require "H-state.rkt"
         "../error/complain.rkt" "../error/hint.rkt"
         "../generic/describe.rkt" "../generic/function.rkt" "../generic/up-down.rkt"
         "../lagrangian/local-tuple.rkt"
         "../value/structure.rkt")

(provide part check-Routhian check-two-parts check-Routhian-state)

(define (part state i j) (ref state i j))

(define (check-Routhian who R)
  (unless (and (procedure? R) (accepts? R 1))
    (complain who "a Routhian is a function of the state (up t (up x y) (up vx p_y)); given ~a"
              (describe-function R))))

(define (check-two-parts who state)
  (define (pair? x) (and (up? x) (= (s:length x) 2)))
  (unless (and (up? state) (= (s:length state) 3) (pair? (ref state 1)) (pair? (ref state 2)))
    (complain who "~a\n  given: ~a~a~a"
              (string-append "expected coordinates in two parts, of which the second has momenta: "
                             "(up t (up x y) (up vx p_y))")
              (value->text state)
              "\n  more coordinates are tuples within: (up theta (up phi psi))"
              (list-hint state "(up t (up x y) (up vx p_y))"))))

(define (check-Routhian-state who state)
  (check-two-parts who state)
  (define-values (y p) (values (ref state 1 1) (ref state 2 1)))
  (unless (H-state? (up (time state) y p))
    (complain who "the momenta of a Routhian state are dual to their coordinates~a~a~a"
              (format "\n  coordinates: ~a" (value->text y))
              (format "\n  in the place of momenta: ~a" (value->text p))
              (if (and (tuple? p) (same-shape? y p))
                  (format "\n  momenta are written ~a" (value->text (flip p)))
                  ""))))
