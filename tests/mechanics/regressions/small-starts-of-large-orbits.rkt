#lang racket/base
;; An orbit that only begins where coordinates are small, next to a saddle or a flank, was followed
;; in units of where it began, and did not close; and what a small orbit that was given up had come
;; to was told in units of its own.

(require mechanics "../support/checks.rkt")

(define (double-well (up t q p)) (+ (/ (square p) 2) (* -1/2 (square q)) (* 1/4 (expt q 4))))
(define (shifted (up t q p)) (+ (/ (square p) 2) (* 1/2 (square (+ q 1)))))
(define (oscillator (up t q p)) (* 1/2 (+ (square p) (square q))))

(define (mean-of-Gauss a b)
  (if (< (abs (- a b)) (* 1e-15 a)) a (mean-of-Gauss (/ (+ a b) 2) (sqrt (* a b)))))

;; p² = (q² - a²)(b² - q²)/2 between the ends a and b of a swing.  Its energy is -a²/2, which a
;; tolerance of 1e-10 hardly knows at 1e-5: it closes all the same.
(test-case "in one of two wells, from next to the saddle between them"
  (for ([a '(5e-3 9e-4 1e-4 1e-5)])
    (define b (sqrt (- 2 (square a))))
    (define frequency (* (sqrt 2) b (mean-of-Gauss 1 (/ a b))))
    (check-= (/ (frequency-of-orbit double-well (up 0 a 0)) frequency) 1 1e-4)
    (check-= (/ (frequency-of-orbit double-well (up 0 a 0) #:tolerance 1e-14) frequency)
             1 1e-6)))

(test-case "about a place of rest that is not small"
  (for ([a '(1e-4 1e-7 1e-10)])
    (check-= (action-of-orbit shifted (up 0 a 0)) (* 1/2 (square (+ a 1))) 1e-9)
    (check-= (frequency-of-orbit shifted (up 0 a 0)) 1 1e-9)))

(test-case "where a small orbit came to when it was given up"
  (define e
    (with-handlers ([exn:fail:mechanics:not-convergent? values])
      (action-of-orbit oscillator (up 0 1e-10 0) #:longest-time 0.5)))
  (define there (ref (exn:fail:mechanics:not-convergent-value e) 1))
  (check-= (/ (ref there 0) 1e-10) (cos 0.5) 1e-8)
  (check-= (/ (ref there 1) 1e-10) (- (sin 0.5)) 1e-8))
