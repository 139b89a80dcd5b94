#lang racket/base
;; Tuples with as many parts as their pattern, grouped otherwise.

(require mechanics/lang/pattern/pattern
         (only-in mechanics/lang/pattern/mismatch regrouped)
         "../../support/checks.rkt"
         "../../support/messages.rkt")

(test-case "a flat pattern is told how the local tuple is taken apart"
  (define ((L m) (up t x y vx vy)) (list m t x y vx vy))
  (check-message
   (string-append "L: the argument does not match the pattern (up t x y vx vy): expected an up "
                  "tuple of 5, given (up 0 (up 1 2) (up 3 4)) (an up tuple of 3)\n"
                  "  a local tuple has three parts: (up t (up x y) (up vx vy))")
   ((L 'm) (up 0 (up 1 2) (up 3 4)))))

(test-case "a flat tuple is told how it is grouped"
  (define (L (up t (up x y) (up vx vy))) (list t x y vx vy))
  (check-message
   (string-append "L: the argument does not match the pattern (up t (up x y) (up vx vy)): "
                  "expected an up tuple of 3, given (up 0 1 2 3 4) (an up tuple of 5)\n"
                  "  grouped as in the pattern it is (up 0 (up 1 2) (up 3 4))")
   (L (up 0 1 2 3 4))))

(test-case "orientations are kept, and other groups are shown as well"
  (check-equal? (regrouped '(up t x y px py) (up 0 (up 1 2) (down 3 4)))
                "a local tuple has three parts: (up t (up x y) (down px py))")
  (check-equal? (regrouped '(up x y z) (up 1 (up 2 3)))
                "the tuple has 2 parts: (up x (up y z))")
  (check-equal? (regrouped '(up t (up x y) (down px _)) (up 0 'a 'b 'c 'd))
                "grouped as in the pattern it is (up 0 (up a b) (down c d))"))

(test-case "with another number of parts there is nothing to say"
  (check-false (regrouped '(up t (up x y) (up vx vy)) (up 0 1 2 3)))
  (check-false (regrouped '(up t (up x y) (up vx vy)) (up (up 0 1) (up 2 3 4))))
  (check-false (regrouped '(up t x) (up 0 1 2)))
  (check-false (regrouped '(up (up a b) c) (up 1 (up 2 3)))))
