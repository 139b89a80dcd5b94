#lang mechanics
;; Exercise 1.5 (SICM 1.4): watching a search for the path
;; Checked: whether each path that the search tries is better than the one before
;; How: the actions written down as they are computed

;; An oscillator goes from 1 to 0 in a quarter of a period.  While the path of least action
;; is searched for, what becomes of the action?  (The pictures are drawn by
;; examples/mechanics/figures/exercise-1-5.rkt.)

(require mechanics/book)
(define L (L-harmonic 1. 1.))

;; All that are computed, in their order, and those of the paths that the search goes on from.
(define computed '())
(define (watched-action qs)
  (define action ((parametric-path-action L 0. 1. :pi/2 0.) qs))
  (set! computed (cons action computed))
  action)
(define best (make-path 0. 1. :pi/2 0.
                        (multidimensional-minimize watched-action (linear-interpolants 1. 0. 3))))
(define kept '())
(void (find-path L 0. 1. :pi/2 0. 3
           #:observe (lambda (path action) (set! kept (cons action kept)))))

;; How many are worse than the one before them?  That none is would be wrong: the search looks
;; around before it goes on.
(define (count-worse actions)
  (for/sum ([before actions] [after (cdr actions)])
    (if (> after before) 1 0)))
(> (count-worse (reverse computed)) 0)
(count-worse (reverse kept))

;; The cosine has the action 0, and no path has less.  How far from it is the one found?
(define error
  (for/fold ([worst 0]) ([t (in-range 0. :pi/2 0.01)])
    (max worst (abs (- (best t) (cos t))))))
(< error 1.7e-4)
(< error 1.6e-4)

(module+ test
  (require rackunit)
  (test-case "some paths are worse than the one before, none of those that are kept is"
    (check-true (> (count-worse (reverse computed)) 0))
    (check-equal? (count-worse (reverse kept)) 0))
  (test-case "no action is below the cosine's"
    (check-true (andmap positive? computed))
    (check-= (apply min kept) 5.362656e-7 1e-12))
  (test-case "the error is what the book says, and no less"
    (check-true (< 1.6e-4 error 1.7e-4))))
