#lang racket/base
;; Roundings: Racket's of numbers, constant between their jumps, without a derivative there.

(require rackunit
         mechanics/calculus/derivative
         mechanics/error/failure
         mechanics/generic/arithmetic
         mechanics/generic/rounding
         "../support/random.rkt")

(define pairs
  (list (cons g:floor floor) (cons g:ceiling ceiling)
        (cons g:truncate truncate) (cons g:round round)))

(define (jump? f x)
  (with-handlers ([exn:fail:mechanics:singular? (lambda (e) #t)])
    (check-equal? ((D f) x) 0 (format "~a at ~a" f x))
    #f))

(define (places-of-jumps f) (for/list ([x (in-range -5/2 11/4 1/4)] #:when (jump? f x)) x))

(test-case "values are those of Racket"
  (with-seed 7
    (for* ([p pairs] [_ 40])
      (define x ((if (zero? (random 2)) values exact->inexact) (random-rational)))
      (check-equal? ((car p) x) ((cdr p) x)))))

(test-case "jumps are where the value changes, and nowhere else"
  (check-equal? (places-of-jumps g:floor) '(-2 -1 0 1 2))
  (check-equal? (places-of-jumps g:ceiling) '(-2 -1 0 1 2))
  (check-equal? (places-of-jumps g:round) '(-5/2 -3/2 -1/2 1/2 3/2 5/2)))

(test-case "towards zero, both sides of zero give zero: no jump there"
  (check-equal? (places-of-jumps g:truncate) '(-2 -1 1 2))
  (for ([x '(0 0.0 -0.0 0.999 -0.999 1e-300)])
    (check-false (jump? g:truncate x)))
  (check-true (jump? g:truncate 1.0)))

(test-case "a rounded value is a number, which may be multiplied like another"
  (check-equal? ((D (lambda (x) (g:* x (g:floor x)))) 5/2) 2)
  (check-equal? ((D (lambda (x) (g:* x (g:truncate x)))) 1/2) 0)
  (check-equal? ((D (lambda (x) (g:* x (g:round x)))) -7/4) -2))

(test-case "the message names the rounding and the place"
  (check-exn #rx"^floor: has no derivative where it jumps, at 2$" (lambda () ((D g:floor) 2)))
  (check-exn #rx"^round: has no derivative where it jumps, at 1/2$" (lambda () ((D g:round) 1/2))))
