#lang racket/base
;; Of orbits that pass half a turn from the start before the rotation does, or after it, which-way?
;; said the opposite: more than half of the answers over the whole range of actions were wrong,
;; and circles were said to be between no actions.

(require mechanics
         mechanics/book
         "../support/checks.rkt")

(test-case "of a rotation by J, every answer is that of J itself"
  (for* ([w (list 0.05 0.2 1/3 (sqrt 0.1) 0.38196601125 0.4787 0.5 0.618034 0.75 0.98)]
         [J (in-range 0.0531 6.2 0.131)])
    (define r (/ J :2pi))
    (when (< 1e-3 (abs (- r w)) 0.45)
      (check-equal? (which-way? w 0 J (standard-map 0)) (if (> r w) 1 -1) (format "~a ~a" w J)))))

(test-case "and where the map is kicked, outside of islands, that of the rotation number"
  (for* ([w (list 0.2 0.38196601125 0.4787 0.618034)]
         [J '(0.9 1.6 2.2 2.7 3.6 3.9 4.5 5.3)])
    (define r (rotation-value (rotation-number (standard-map 0.5) (up 0 J))))
    (when (< 5e-3 (abs (- r w)) 0.4)
      (check-equal? (which-way? w 0 J (standard-map 0.5)) (if (> r w) 1 -1) (format "~a ~a" w J)))))

(test-case "a circle near half a turn is found"
  (define w (- (sqrt 2) 0.955))
  (define J (find-invariant-curve (standard-map 0.3) w 0 2.5 3.8 1e-8))
  (check-= (rotation-value (rotation-number (standard-map 0.3) (up 0 J))) w 1e-8)
  (define c (invariant-circle (standard-map 0.3) w))
  (check-= (invariant-circle-ordinate c 0) J 1e-6))
