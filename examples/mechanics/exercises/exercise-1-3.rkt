#lang mechanics
;; Exercise 1.3 (SICM 1.3): light takes the quickest way
;; Checked: the laws of reflection and refraction
;; How: the derivative of the time of travel, by the place where the light turns

;; Light goes from (0, a) to (d, b) by way of a point (x, 0) of a mirror, or to (d, -b) through
;; the surface of a medium there.  Its speed is c/n_1 above and c/n_2 below the surface.  Where
;; is the time of travel stationary?

(define (time-of-travel n_1 n_2)
  (lambda (x)
    (+ (* (/ n_1 'c) (sqrt (+ (square x) (square 'a))))
       (* (/ n_2 'c) (sqrt (+ (square (- 'd x)) (square 'b)))))))

;; The sines of the angles to the normal, before and after.
(define sine-before (/ 'x (sqrt (+ (square 'x) (square 'a)))))
(define sine-after (/ (- 'd 'x) (sqrt (+ (square (- 'd 'x)) (square 'b)))))

;; A mirror: the angles are equal.
(define mirror
  (verify-equal ((D (time-of-travel 'n 'n)) 'x)
                (* (/ 'n 'c) (- sine-before sine-after))))
mirror

;; A surface, with Snell's law; and a slip, with the indices exchanged.
(define slope ((D (time-of-travel 'n_1 'n_2)) 'x))
(define Snell
  (verify-equal slope (/ (- (* 'n_1 sine-before) (* 'n_2 sine-after)) 'c)))
(define exchanged
  (verify-equal slope (/ (- (* 'n_2 sine-before) (* 'n_1 sine-after)) 'c)))
Snell
(verdict-status exchanged)
(verdict-conditions exchanged)

;; By numbers: from air into water.
(define (in-numbers f)
  (for/fold ([f f]) ([s '(a b c d n_1 n_2)] [value '(1. 2. 1. 3. 1. 4/3)])
    (substitute f s value)))
(define best
  (car (minimize (lambda (x) (in-numbers (substitute ((time-of-travel 'n_1 'n_2) 'x) 'x x)))
                 0. 3.)))
(define (ratio-at x) (in-numbers (substitute (/ sine-before sine-after) 'x x)))
(ratio-at best)

(module+ test
  (require rackunit)
  (test-case "stationary where the laws hold"
    (check-pred proved? mirror)
    (check-pred proved? Snell))
  (test-case "the slip is right where there is nothing to refract"
    (check-pred refuted? exchanged)
    (check-equal? (map expression (verdict-conditions exchanged)) '((= n_1 n_2))))
  (test-case "the quickest way into water"
    (check-= (ratio-at best) 4/3 1e-6)))
