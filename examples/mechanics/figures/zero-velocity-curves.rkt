#lang mechanics
;; Where a third body cannot go  (SICM 1.8.3, p. 88)
;;
;; Two bodies circle about each other; on axes that turn with them the energy of a third
;; one is constant, and a curve on which its velocity would vanish is a wall.  Drawn are
;; the three energies at which a gap opens: between the two bodies, behind the lighter
;; one, and behind the heavier one.

(require mechanics/plot mechanics/book)

(define m0 0.8)
(define m1 0.2)
(define energy (Lagrangian->energy (LR3B 1. 1. m0 m1)))

;; The energy at rest; with G = 1 and the distance 1, the bodies are at -m1 and m0.
(define (wall x y) (energy (up 0. (up x y) (up 0. 0.))))

;; On the line through the bodies the walls are highest at the gaps.
(define (gap from to)
  (car (minimize (lambda (x) (- (wall x 0.))) from to)))

(define gaps
  (list (gap (+ (- m1) 0.05) (- m0 0.05)) (gap (+ m0 0.05) 2.) (gap -2. (- (- m1) 0.05))))

(define picture
  (frame -1.8 1.8 -1.8 2.6 #:aspect-ratio 'equal #:x-label "x" #:y-label "y"))

(for ([x gaps]
      [color '(blue darkgreen red)]
      [label '("between the two" "behind the lighter" "behind the heavier")])
  (plot-contours picture wall (wall x 0.) #:samples 161 #:color color #:label label)
  (plot-point picture x 0. #:size 4 #:color color))
(plot-point picture (- m1) 0. #:size 8)
(plot-point picture m0 0. #:size 5)

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "zero-velocity-curves.png"))

(module+ test
  (require rackunit)
  (define (force x) (ref ((D (lambda (q) (wall (ref q 0) (ref q 1)))) (up x 0.)) 0))
  (test-case "at the gaps a body can stay at rest"
    (for ([x gaps]) (check-= (force x) 0 1e-5)))
  (test-case "the gaps open in this order"
    (define levels (map (lambda (x) (wall x 0.)) gaps))
    (check-equal? (sort levels <) levels)))
