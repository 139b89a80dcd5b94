#lang racket/base
;; Formulas as picts: their measures, on which putting them together rests.

(require mechanics
         (only-in mechanics/pict ->pict)
         (only-in mechanics/show/plot/on-demand why-not)
         "../../support/checks.rkt" "../../support/messages.rkt" "../../support/skip.rkt")

(define (of-pict name) (dynamic-require 'pict name))

(define (width p) ((of-pict 'pict-width) p))
(define (height p) ((of-pict 'pict-height) p))
(define (descent p) ((of-pict 'pict-descent) p))

;; Is a point of the picture painted?  Coordinates are fractions of width and height.
(define (column-painted? p x)
  (define bitmap ((of-pict 'pict->argb-pixels) p))
  (define w (inexact->exact (ceiling (width p))))
  (define h (quotient (bytes-length bitmap) (* 4 w)))
  (for/or ([y (in-range h)])
    (> (bytes-ref bitmap (* 4 (+ (* y w) (min (sub1 w) (inexact->exact (floor (* x w))))))) 0)))

;; The painted columns of a row of pixels, at a fraction of the height, as fractions of the width.
(define (painted-columns p at)
  (define bitmap ((of-pict 'pict->argb-pixels) p))
  (define w (inexact->exact (ceiling (width p))))
  (define row (inexact->exact (floor (* at (quotient (bytes-length bitmap) (* 4 w))))))
  (for/list ([x (in-range w)] #:when (> (bytes-ref bitmap (* 4 (+ (* row w) x))) 0)) (/ x w 1.0)))

;; Is a point of the upper quarter painted?
(define (top-painted? p)
  (define bitmap ((of-pict 'pict->argb-pixels) p))
  (for/or ([alpha (in-bytes bitmap 0 (quotient (bytes-length bitmap) 4) 4)]) (> alpha 0)))

(skip-unless (not (why-not)) "nothing can be drawn here"
  (test-case "a quotient is taller than its parts, and its bar stands above the base line"
    (define f (->pict (/ 'a 'b)))
    (check-true (> (height f) (* 1.5 (height (->pict 'a)))))
    (check-true (< 0 (descent f) (/ (height f) 2))))
  (test-case "an exponent makes it taller, and leaves the base line"
    (define-values (base power) (values (->pict 'x) (->pict (square 'x))))
    (check-true (> (width power) (width base)))
    (check-= (descent power) (descent base) 0.001))
  (test-case "letters are as large as one wishes"
    (check-true (> (height (->pict 'x #:size 40)) (* 2 (height (->pict 'x #:size 16))))))
  (test-case "a dot over a letter makes no room beside it"
    (check-= (width (->pict 'theta)) (width (->pict 'thetadot)) 0.001)
    (check-true (< -0.001 (- (height (->pict 'thetadot)) (height (->pict 'theta)))
                   (* 0.3 (height (->pict 'theta))))))
  (test-case "two dots are above their letter"
    (define-values (plain dotted) (values (->pict 'x #:size 40) (->pict 'xdotdot #:size 40)))
    (check-= (width dotted) (width plain) 0.001)
    (check-true (top-painted? dotted))
    (check-false (top-painted? plain)))
  (test-case "factors are next to each other, less than half a letter apart"
    (define (wide x) (width (->pict x #:size 40)))
    (check-true (< 0 (- (wide (* 'a 'b)) (wide 'a) (wide 'b)) 20)))
  (test-case "a long sum is broken within its width"
    (define long (expand (expt (+ 'a 'b 'c) 7)))
    (check-true (< (width (->pict long #:width 40)) (/ (width (->pict long #:width #f)) 3)))
    (check-true (> (height (->pict long #:width 40)) (* 5 (height (->pict long #:width #f))))))
  (test-case "something is drawn"
    (define p (->pict (sqrt (/ 'a 'b)) #:size 40))
    (check-true (for/and ([x '(0.3 0.5 0.7)]) (column-painted? p x)))
    (check-true (> (width (->pict '|</mi>|)) 10)))
  (test-case "brackets stand at either side of a matrix, and open towards it"
    (define p (->pict (matrix-by-rows '(1 a) '(0 2) '(0 b)) #:size 40))
    (define-values (ends strokes) (values (painted-columns p 0.005) (painted-columns p 0.34)))
    (for ([columns (list ends strokes)])
      (check-equal? (apply min columns) (apply min strokes))
      (check-equal? (apply max columns) (apply max strokes)))
    (check-true (< (apply min strokes) 0.1 0.9 (apply max strokes)))
    (check-true (> (length ends) (* 4 (length strokes)))))
  (test-case "an empty tuple, a matrix, a verdict and what is no formula are picts"
    (for ([x (list (up) (down) (matrix-by-rows '(1 a) '(0 2)) (verify-equal 'x 'x)
                   (lambda (x) x) "text" (void) '|| '|\n|)])
      (check-true ((of-pict 'pict?) (->pict x)))))
  (says
   [(->pict 'x #:size 0)
    "->pict: expected a size of letters, a number between 0 and 1000\n  given: 0"]
   [(->pict 'x #:width 'wide)
    "->pict: expected a width in columns, or #f for lines of any length\n  given: the symbol wide"]))
