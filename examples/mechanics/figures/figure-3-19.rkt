#lang mechanics
;; A section of the motion of Hénon and Heiles  (SICM 3.6.3, Figure 3.19)
;;
;; Energy 1/12: the points of each orbit lie on curves, as if there were another conserved
;; quantity.

(require mechanics/plot "star.rkt")

(define T (star-map 1/12))
(define win
  (star-section 1/12 '((0. 0.1) (0.1 0.) (0.2 0.) (0.3 0.) (-0.1 0.) (-0.2 0.) (-0.3 0.)
                          (0. 0.25) (0. -0.25) (0.3 0.2))
                300))

win

(module+ main
  (require "save.rkt")
  (save-figure win "figure-3-19.png"))

(module+ test
  (require rackunit)
  (test-case "the first crossings"
    (define first-three
      (for/fold ([all '()] [y 0.1] [p 0.] #:result (reverse all)) ([k 3])
        (T y p (lambda (y p) (values (cons (list y p) all) y p)) void)))
    (check-= (car (list-ref first-three 0)) 0.1723588468181 1e-9)
    (check-= (cadr (list-ref first-three 1)) -0.08703493045268 1e-9)
    (check-= (car (list-ref first-three 2)) 0.3881287410275 1e-9))
  (test-case "orbits are regular"
    (for ([y '(0.1 0.3)])
      (check-true (rotation-regular? (rotation-number T (up y 0.) 400 #:about (up 0.2 0.)))))))
