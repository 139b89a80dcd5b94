#lang racket/base
;; Integrations that rounding in the right-hand side would keep going for ever.

(require racket/flonum
         mechanics/error/failure
         mechanics/numeric/ode/dormand-prince-54
         mechanics/numeric/ode/integrate
         mechanics/numeric/ode/roundoff-detection
         tests/mechanics/support/rates
         "../../support/checks.rkt")

;; x' = -1 and y' near 14, by a formula for the latter that is 0/0 where x = 0
(define (passing! y dy)
  (define x (flvector-ref y 0))
  (flvector-set! dy 0 -1.0)
  (flvector-set! dy 1 (/ (* 28.0 (- 1.0 (cos x))) (* x (sin x)))))

(define start (flvector 1.0 0.0))

(test-case "a tolerance below the rounding near 0/0 ends the integration before that place"
  (define-values (t why)
    (let/ec return
      (integrate dormand-prince-54 passing! start 0.0 2.0 #:tolerance 1e-15
                 #:stuck (lambda (t y why) (return t why)))))
  (check-equal? why 'lost-digits)
  (check-true (< 0.99 t 1.0)))

;; From here the same steps lead to where it failed when that is to be the end, not all others do.
(define late-start (flvector 1.11 0.0))

(test-case "what has come to its end has not failed"
  (define steps 0)
  (define (counted from to interpolant) (set! steps (+ steps 1)))
  (define end
    (let/ec return
      (integrate dormand-prince-54 passing! late-start 0.0 2.0 #:tolerance 1e-15 #:visit counted
                 #:stuck (lambda (t y why) (return t)))))
  (define till-it-failed steps)
  (set! steps 0)
  (define-values (t y)
    (integrate dormand-prince-54 passing! late-start 0.0 end #:tolerance 1e-15 #:visit counted))
  (check-equal? t end)
  (check-equal? steps till-it-failed))

(test-case "one above it does not"
  (define-values (t y) (integrate dormand-prince-54 passing! start 0.0 2.0 #:tolerance 1e-12))
  (check-equal? t 2.0))

(test-case "the failure says so"
  (check-exn (lambda (e)
               (and (exn:fail:mechanics:singular? e)
                    (regexp-match? #rx"reason: 'lost-digits" (exn-message e))))
             (lambda ()
               (integrate dormand-prince-54 passing! start 0.0 2.0 #:tolerance 1e-15))))

(test-case "close encounters, of as short steps, go on"
  ;; a comet of eccentricity 1 - 1e-5
  (define v (sqrt (/ 1e-5 (- 2.0 1e-5))))
  (define least 1.0)
  (define-values (t y)
    (integrate dormand-prince-54 kepler! (flvector (- 2.0 1e-5) 0.0 0.0 v) 0.0 6.0
               #:tolerance 1e-13
               #:visit (lambda (from to interpolant) (set! least (min least (- to from))) #t)))
  (check-true (< least 1e-8))
  (check-equal? t 6.0))

;; Its steps are limited by stability, and what rounding makes of the rates there is a fair part of
;; the tolerance; but they get no shorter, and lead to the end.
(test-case "a system that becomes stiff goes on"
  (define (stiffening! y dy)
    (define t (flvector-ref y 0))
    (define-values (slope goal)
      (if (> t 100.0) (values -3e4 (+ 1.0 (* 1e-3 (cos (- t 100.0))))) (values -0.01 1.0)))
    (flvector-set! dy 0 1.0)
    (flvector-set! dy 1 (* slope (- (flvector-ref y 1) goal))))
  (define-values (t y)
    (integrate dormand-prince-54 stiffening! (flvector 0.0 1.0) 0.0 102.0
               #:clock 0 #:tolerance 1e-14))
  (check-equal? t 102.0)
  (check-= (flvector-ref y 1) (+ 1.0 (* 1e-3 (cos (- 2.0 (/ 1.0 3e4))))) 1e-11))

(test-case "what is a long row of short steps that get shorter"
  (define c (make-crawl))
  (define (short-steps count h) (for ([_ (in-range count)]) (check-false (crawls? c h))))
  (check-false (crawls? c 1.0))
  (short-steps 500 1e-5)
  (short-steps 499 8e-6)
  (check-true (crawls? c 8e-6))
  (short-steps 999 7e-6)                ; beside 9e-6
  (check-true (crawls? c 7e-6))
  (check-false (crawls? c 1e-3))
  (short-steps 999 1e-7)
  (check-false (crawls? c 1e-3)))

(test-case "lengths that fall slowly fall, and those that stay do not"
  (define (first-crawl length-of most)
    (define c (make-crawl))
    (crawls? c 1.0)
    (for/first ([k (in-range most)] #:when (crawls? c (length-of k))) k))
  (check-equal? (first-crawl (lambda (k) (/ 100.0 (expt (+ 3e4 k) 2.0))) 10000) 3999)
  (check-false (first-crawl (lambda (k) (* 1e-5 (+ 1.0 (* 0.5 (sin k))))) 200000)))

(test-case "rounding that exceeds the tolerance of a step"
  (define near (flvector 1e-5 0.0))
  (check-true (rounding-exceeds? passing! near 1e-6 1e-16))
  (check-false (rounding-exceeds? passing! near 1e-6 1e-9))
  (check-false (rounding-exceeds? passing! start 1e-6 1e-16)))

;; y' = 1/(π − y)³: one unit in the last place of y counts where π − y is small.
(test-case "a state of too few digits is told when the steps get longer again"
  (define (steep! y dy) (flvector-set! dy 0 (expt (- (acos -1.0) (flvector-ref y 0)) -3.0)))
  (define (asked distance tolerated . lengths)
    (define c (make-crawl))
    (define y (flvector (- (acos -1.0) distance)))
    (crawls? c 1.0)
    (for/last ([h (in-list lengths)] [t (in-naturals)])
      (define found (state-too-coarse c steep! t y h tolerated))
      (and found (list (car found) (equal? (cdr found) y)))))
  (check-equal? (asked 1e-4 1e-12 1e-4 1e-5 5e-5) '(1 #t))      ; where they were the shortest
  (check-equal? (asked 1e-4 1e-12 1e-5 3e-5) #f)                ; not four times as long yet
  (check-equal? (asked 1e-4 1e-12 1e-5 1e-6) #f)
  (check-equal? (asked 0.1 1e-12 1e-5 1e-3 1e-2) #f)            ; digits enough
  (check-equal? (asked 1e-4 1e-5 1e-5 5e-5) #f)                 ; for this tolerance
  (check-equal? (asked 1e-4 1e-12 1e-2 1e-1) #f))               ; no short steps
