#lang racket/base
;; Parts and conjugates of complex expressions, against Racket's complex numbers.

(require (prefix-in racket: (only-in racket/base real-part imag-part))
         mechanics
         "../support/checks.rkt" "../support/messages.rkt")

(define z (+ 'x (* +i 'y)))
(define (at-point e) (exact->inexact (substitute (substitute e 'x 0.3) 'y 1.2)))

(test-case "they are those of the value at a point"
  (for ([e (list z (* z z) (/ z (+ 1 z)) (expt z 3) (expt z -2) (exp z) (sin z) (cos z) (sinh z)
                 (cosh z) (- 'x (* z (sin 'x))) (* 2.5 z (sqrt 'y)))])
    (define value (at-point e))
    (check-= (at-point (real-part e)) (racket:real-part value) 1e-12)
    (check-= (at-point (imag-part e)) (racket:imag-part value) 1e-12)
    (check-= (at-point (conjugate e)) (conjugate value) 1e-12)))

(test-case "what is real stays as it is"
  (define e (sqrt (+ 'x ((literal-function 'f) 'y))))
  (check-eq? (conjugate e) e)
  (check-eq? (real-part e) e)
  (check-equal? (imag-part e) 0))

;; Each step doubles what it is written out.
(define (shared depth) (for/fold ([e z]) ([_ (in-range depth)]) (+ (sin e) (cos e))))

(test-case "parts that an expression shares are looked at once"
  (check-equal? (conjugate (conjugate (shared 10))) (shared 10))
  (for ([part (list conjugate real-part imag-part)])
    (check-false (equal? (part (shared 60)) 0))))

(test-case "of other functions they are not known"
  (check-message
   (string-append "real-part: the parts are known of sums, products, whole powers, exp, sin, cos, "
                  "sinh and cosh of complex expressions; given (+ 1 (sqrt (+ x (* 0+1i y))))")
   (real-part (+ 1 (sqrt z)))))
