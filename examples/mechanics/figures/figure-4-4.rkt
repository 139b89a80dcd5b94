#lang mechanics
;; Multipliers of a map that keeps areas  (SICM 4.2.2, Figure 4.4)
;;
;; Multipliers of the standard map at rest, in the complex plane: each with its inverse.  At θ = π,
;; as K grows, black, they go around the unit circle until both are −1, at K = 4, and then part
;; along the negative axis; at θ = 0 they are positive, gray.  In colours, one pair of each kind.

(require mechanics/plot mechanics/book
         (only-in racket/base real-part imag-part))

(define (rest K theta) (find-fixed-point (standard-map K) (up theta 0.)))
(define (multipliers K theta) (fixed-point-multipliers (rest K theta)))
(define picture
  (frame -3. 3. -1.5 3. #:width 500 #:height 400 #:aspect-ratio 'equal
         #:x-label "real part" #:y-label "imaginary part"))
(define (draw K theta #:color color #:size size #:label [label #f])
  (for ([z (multipliers K theta)])
    (plot-point picture (real-part z) (imag-part z) #:color color #:size size #:label label)))

(plot-parametric picture (up cos sin) 0 :2pi #:style 'dot)
(for ([K (in-range 0.1 5. 0.1)] #:unless (= (round (* 10 K)) 40))
  (draw K :pi #:color 'black #:size 2)
  (when (< K 1.5) (draw K 0. #:color 'gray #:size 2)))
(draw 1. :pi #:color 'blue #:size 8 #:label "elliptic")
(draw 0.6 0. #:color 'red #:size 8 #:label "hyperbolic")
(draw 4.4 :pi #:color "dark green" #:size 8 #:label "with reflection")

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-4-4.png"))

(module+ test
  (require rackunit)
  (define all
    (for*/list ([K '(0.3 1. 2.2 3.9 4.1 4.9)] [theta (list 0. :pi)]) (multipliers K theta)))
  (test-case "the inverse of each is the other"
    (for ([pair all]) (check-= (magnitude (- (* (car pair) (cadr pair)) 1)) 0 1e-12)))
  (test-case "they are real, or on the unit circle, each the conjugate of the other"
    (for ([pair all])
      (if (= (imag-part (car pair)) 0)
          (check-= (imag-part (cadr pair)) 0 0)
          (for ([z pair])
            (check-= (magnitude z) 1 1e-12)
            (check-= (real-part z) (real-part (car pair)) 1e-12)))))
  (test-case "the kinds"
    (define (kind K theta) (fixed-point-kind (rest K theta)))
    (check-equal? (list (kind 1. :pi) (kind 0.6 0.) (kind 4.4 :pi) (kind 4. :pi))
                  '(elliptic hyperbolic reflection-hyperbolic parabolic))))
