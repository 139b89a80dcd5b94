#lang racket/base
;; Random programs against difference quotients with many digits: closures,
;; branches, loops, tuples, containers, derivatives within derivatives of numbers
;; and of functions.  A long run:  racket ../support/programs/main.rkt --count 10000

(require "../support/checks.rkt" "../support/bigfloats.rkt" "../support/skip.rkt"
         "../support/programs/check.rkt" "../support/programs/main.rkt")

(define seed 20)

(define (check-batch m count size)
  (test-case (format "random programs, ~a: derivatives agree with difference quotients"
                     (mode-name m))
    (define-values (agreed discarded failures) (run-batch m count size seed))
    (for ([f (in-list failures)])
      (define-values (program verdict) (apply shrink f))
      (with-check-info (['seed seed] ['at (caddr f)] ['program program] ['verdict verdict])
        (fail-check)))
    (check-true (> agreed (quotient count 4)) "most programs are discarded")))

(for ([m (in-list (modes))]) (check-batch m 60 50))
(skip-unless bigfloats? no-bigfloats)

(test-case "the published counter-example is written in the language, and agrees"
  (define program
    '(lambda (x)
       (let ([slope ((D (lambda (u) (lambda (f) (lambda (y) (f (+ y u)))))) 0)])
         ((slope (slope cube)) x))))
  (for ([m (in-list (modes))])
    (check-equal? (check-program m program 3/2) 'agrees)))

(test-case "a disagreement is seen, and shrunk"
  (define wrong
    (struct-copy mode (car (modes)) [ours (lambda (program x) 1/3)]))
  (define program '(lambda (x) (+ (* x x) (let ([y (sin-free x)]) y))))
  (check-equal? (check-program wrong program 2) 'discarded)
  (define-values (small verdict)
    (shrink wrong '(lambda (x) (+ (* x x) (let ([y (cube x)]) y))) 2 "differs"))
  (check-equal? small '(lambda (x) 1)))
