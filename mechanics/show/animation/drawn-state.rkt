#lang racket/base
;; States as drawings read them: the time, and all coordinates in a row, as flonums.

(require (only-in racket/list split-at-right)
         "../../error/complain.rkt" "../../error/hint.rkt" "../../error/message-words.rkt"
         "../../generic/describe.rkt" "../../generic/up-down.rkt"
         "../../lagrangian/local-tuple.rkt"
         "../../value/shape.rkt"
         "../plot/plotted-number.rkt")

(provide read-state slot-components)

;; counts : list of allowed numbers of coordinates, or #f for any number
;; -> the time, a flonum, and the coordinates, a vector of flonums
(define (read-state who state counts)
  (unless (local-tuple? state)
    (complain who "expected a state, such as (up t q v)\n  given: ~a~a"
              (describe-with-value state) (list-hint state "(up t q v)")))
  (define q (slot-components who state 1))
  (unless (or (not counts) (memv (vector-length q) counts))
    (complain who "draws a system of ~a; this state has ~a\n  state: ~a"
              (counted-coordinates counts) (vector-length q) (value->text state)))
  (values (coordinate-of who "the time of the state" (time state)) q))

;; "1 coordinate", "1 or 2 coordinates"
(define (counted-coordinates counts)
  (define-values (others greatest) (split-at-right counts 1))
  (string-append (if (null? others) "" (format "~a or " (joined (map number->string others))))
                 (counted (car greatest) "coordinate")))

;; The components of a part of the state, whatever tuples they are in.
(define (slot-components who state slot)
  (for/vector ([x (in-list (scalars (vector-ref (tuple-elements (adopt state)) slot)))]
               [i (in-naturals)])
    (coordinate-of who
                   (lambda () (format "component ~a of ~a" i
                                      (if (= slot 1) "the coordinates" "the velocities")))
                   x)))
