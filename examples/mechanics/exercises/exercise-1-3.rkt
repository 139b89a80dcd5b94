#lang mechanics
;; Exercise 1.3 (SICM 1.3): light takes the quickest way
;; Checked: the laws of reflection and refraction
;; How: the derivative of the time of travel, by the place where the light turns

;; Light goes from (0, a) to (d, b) by way of a point (x, 0) of a mirror, or to (d, -b) through
;; the surface of a medium there.  Its speed is c/n_1 before and c/n_2 after that point.  Where
;; is the time of travel stationary?

(define ((time-of-travel a b d c n_1 n_2) x)
  (+ (* (/ n_1 c) (sqrt (+ (square x) (square a))))
     (* (/ n_2 c) (sqrt (+ (square (- d x)) (square b))))))

(define (slope n_1 n_2) ((D (time-of-travel 'a 'b 'd 'c n_1 n_2)) 'x))

;; The sines of the angles to the normal, before and after.
(define (sine-before a x) (/ x (sqrt (+ (square x) (square a)))))
(define (sine-after b d x) (sine-before b (- d x)))

;; A mirror: the angles are equal.
(define (law n_1 n_2)
  (/ (- (* n_1 (sine-before 'a 'x)) (* n_2 (sine-after 'b 'd 'x))) 'c))
(define mirror (verify-equal (slope 'n 'n) (law 'n 'n)))
mirror

;; A surface, with Snell's law; and a slip, with the indices exchanged.
(define Snell (verify-equal (slope 'n_1 'n_2) (law 'n_1 'n_2)))
(define exchanged (verify-equal (slope 'n_1 'n_2) (law 'n_2 'n_1)))
Snell
(verdict-status exchanged)
(verdict-conditions exchanged)

;; By numbers, from air into water: the ratio of the sines on the quickest way.
(define best (car (minimize (time-of-travel 1. 2. 3. 1. 1. 4/3) 0. 3.)))
(define ratio (/ (sine-before 1. best) (sine-after 2. 3. best)))
ratio

(module+ test
  (require rackunit)
  (test-case "stationary where the laws hold"
    (check-pred proved? mirror)
    (check-pred proved? Snell))
  (test-case "the slip is right where there is nothing to refract"
    (check-pred refuted? exchanged)
    (check-equal? (map expression (verdict-conditions exchanged)) '((= n_1 n_2))))
  (test-case "the quickest way into water"
    (check-= ratio 4/3 1e-6)))
