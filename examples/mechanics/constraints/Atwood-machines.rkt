#lang mechanics
;; Atwood's machine, and one that hangs from another
;;
;; Weights on strings over pulleys without friction or inertia.  Depths are counted
;; downwards.  The length of each string is a constraint, and its multiplier is minus the
;; tension.

(require mechanics/plot)
(provide picture)

;; Two weights on one string.
(define ((L-two m1 m2 g) (up t (up x1 x2) (up v1 v2)))
  (+ (* 1/2 m1 (square v1)) (* 1/2 m2 (square v2)) (* g (+ (* m1 x1) (* m2 x2)))))
(define one-string (holonomic (lambda (t (up x1 x2)) (- (+ x1 x2) 'l))))

((constrained-accelerations (L-two 'm_1 'm_2 'g) one-string)
 (up 't (up 'x_1 'x_2) (up 'v_1 'v_2)))

;; In place of the second weight a pulley at the depth y, with two weights on a string of
;; its own.  The pulley has no inertia: only the constraints tell how it moves.
(define ((L-three m1 m2 m3 g) (up t (up x1 y x2 x3) (up v1 vy v2 v3)))
  (+ (* 1/2 m1 (square v1)) (* 1/2 m2 (square v2)) (* 1/2 m3 (square v3))
     (* g (+ (* m1 x1) (* m2 x2) (* m3 x3)))))
(define two-strings
  (list (holonomic (lambda (t (up x1 y x2 x3)) (- (+ x1 y) 'l)))
        (holonomic (lambda (t (up x1 y x2 x3)) (- (+ (- x2 y) (- x3 y)) 'k)))))

(define (solution m1 m2 m3 g)
  ((constrained-accelerations (L-three m1 m2 m3 g) two-strings)
   (up 't (up 'x_1 'y 'x_2 'x_3) (up 'v_1 'v_y 'v_2 'v_3))))

(define acceleration-of-first (ref (solution 'm_1 'm_2 'm_3 'g) 0 0))
(define tensions (* -1 (ref (solution 'm_1 'm_2 'm_3 'g) 1)))
acceleration-of-first
tensions

;; The upper string carries twice what the lower one does.
(verify-equal (ref tensions 0) (* 2 (ref tensions 1)))

;; Does a weight as heavy as the two others together hold them in balance?
(prove-zero (substitute acceleration-of-first 'm_1 (+ 'm_2 'm_3)))

;; The harmonic mean of the two counts, doubled.
(prove-zero (substitute acceleration-of-first 'm_1 (/ 4 (+ (/ 'm_2) (/ 'm_3)))))

;; The acceleration of a weight 1 against two whose sum is 1, over the share of one.
(define (falling share) (ref (solution 1 share (- 1 share) 1) 0 0))

(define picture
  (frame 0. 1. 0. 1. #:width 500 #:height 300
         #:x-label "m₂, with m₂ + m₃ = m₁ = 1" #:y-label "acceleration of m₁, in g"))
(plot-function picture falling 0. 1. 0.01)
picture

(module+ main
  (require "../figures/save.rkt")
  (save-figure picture "Atwood-machines.png"))

(module+ test
  (require rackunit)
  (define-syntax-rule (check-status status verdict)
    (check-eq? (verdict-status verdict) status))
  (define all (+ (* 'm_1 (+ 'm_2 'm_3)) (* 4 'm_2 'm_3)))
  (test-case "the acceleration of the first weight, and the tensions"
    (check-status 'proved
                  (verify-equal acceleration-of-first
                                (/ (* 'g (- (* 'm_1 (+ 'm_2 'm_3)) (* 4 'm_2 'm_3))) all)))
    (check-status 'proved
                  (verify-equal tensions
                                (* (/ (* 4 'm_1 'm_2 'm_3 'g) all) (up 2 1)))))
  (test-case "without the pulley's string the weights are Newton's: force over mass"
    (define a (ref (solution 'm_1 'm_2 'm_3 'g) 0))
    (for ([x (list (ref a 0) (ref a 2) (ref a 3))]
          [m '(m_1 m_2 m_3)]
          [pull (list (ref tensions 0) (ref tensions 1) (ref tensions 1))])
      (check-status 'proved (verify-equal (* m x) (- (* m 'g) pull)))))
  (test-case "equal weights do not balance, but for equal halves"
    (check-status 'refuted (prove-zero (substitute acceleration-of-first 'm_1 (+ 'm_2 'm_3))))
    (check-equal? (falling 1/2) 0)
    (check-equal? (falling 1/3) 1/17))
  (test-case "the picture"
    (check-equal? (length (car (frame-curves picture))) 101)))
