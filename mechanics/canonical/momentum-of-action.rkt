#lang racket/base
;; The momentum at a coordinate, of the motion that has a given action.
;;
;; The action grows with the momentum, but not from 0 where the coordinate is no place of rest,
;; nor without a jump at a separatrix; and beyond one a motion may not close at all, which
;; counts as an action that is too large.  So the answer is looked at before it is given.

(require "../generic/on-demand.rkt")

(require-on-demand ["../search/find-root.rkt" find-root])

(provide momentum-with-action)

(define most-rounds 60)
(define closeness 1e-6)      ; of the action found, relative to that asked for

;; action-at : p -> the action, +inf.0 where the motion does not close;  -> p, or #f if none has J
(define (momentum-with-action action-at J)
  (and (< (action-at 0.0) J)
       (let-values ([(low high) (bracket action-at J)])
         (and high
              (let ([p (find-root (lambda (p) (- (action-at p) J)) low high #:tolerance 1e-13)])
                (and (<= (abs (- (action-at p) J)) (* closeness J)) p))))))

;; -> momenta with an action below J, and one above it that is finite; or #f and #f
(define (bracket action-at J)
  (let widen ([low 0.0] [high (sqrt (* 2.0 J))] [beyond #f] [rounds most-rounds])
    (define action (action-at high))
    (cond [(or (= rounds 0) (and beyond (< (- beyond low) (* closeness beyond)))) (values #f #f)]
          [(= action +inf.0) (widen low (/ (+ low high) 2) high (sub1 rounds))]
          [(> action J) (values low high)]
          [else
           (widen high (if beyond (/ (+ high beyond) 2) (* 2 high)) beyond (sub1 rounds))])))
