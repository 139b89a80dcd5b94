#lang mechanics
;; Sections of the standard map, for the figures of sections 3.9 and 4.6.

(require mechanics/plot mechanics/book)

(provide kicked-section kicks-after golden golden-circle densities)

(define (kicked-section K n)
  (define win (frame 0 :2pi 0 :2pi #:x-label "θ" #:y-label "I"))
  (explore-map win (standard-map K) n
               #:starts (for/list ([k 16])
                        (up (if (= (modulo k 2) 0) 0.1 3.) (* k (/ :2pi 16))))))

;; From (1, 1).
(define (kicks-after K n) ((iterated-map (standard-map K) n) 1. 1. list void))

(define golden (- 1 (/ 1 golden-ratio)))
(define (golden-circle K) (invariant-circle (standard-map K) golden #:most-modes 16384))

;; How often orbits on a circle come near its points, (list abscissa density) for n of them: an
;; orbit visits angles evenly, so between two neighbours it is as long whatever their distance.
(define (densities circle n)
  (define h (/ :2pi n))
  (define (abscissa-at k) (ref (circle (* k h)) 0))
  (define-values (all last)
    (for/fold ([all '()] [x (abscissa-at 0)]) ([k n])
      (define next (abscissa-at (+ k 1)))
      (values (cons (list (/ (+ x next) 2) (/ h (- next x))) all) next)))
  (reverse all))
