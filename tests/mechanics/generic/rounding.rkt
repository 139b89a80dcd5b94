#lang racket/base
;; Roundings: Racket's of numbers, constant between their jumps, without a derivative there.

(require mechanics/calculus/derivative
         mechanics/error/failure
         mechanics/generic/arithmetic
         mechanics/generic/describe
         mechanics/generic/rounding
         mechanics/value/matrix/matrix
         mechanics/value/structure
         "../support/checks.rkt" "../support/messages.rkt" "../support/random.rkt")

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

;; ---------------------------------------------------------------------------
;; Exact and inexact

(test-case "each part of a value is converted"
  (define m (matrix-by-rows '(1/2 1) '(2 x)))
  (define decimals (matrix-by-rows '(0.5 1.0) '(2.0 x)))
  (check-equal? (g:exact->inexact m) decimals)
  (check-equal? (g:inexact->exact decimals) m)
  (check-equal? (g:exact->inexact (up 1/2 m)) (up 0.5 decimals))
  (check-equal? (g:inexact->exact (down 0.5 (up 'x 2.0))) (down 1/2 (up 'x 2)))
  (check-equal? (g:inexact->exact 0.5+2.0i) 1/2+2i)
  (check-equal? ((g:inexact->exact g:square) 1.5) 9/4))

(test-case "an expression gets exact numbers"
  (check-equal? (value->text (g:inexact->exact (g:* 0.5 (g:square 'x))))
                "(* 1/2 x x)"))

(test-case "a derivative passes through"
  (check-equal? ((D (lambda (x) (g:* x (g:inexact->exact x)))) 3) 6))

(test-case "what has no exact value is refused"
  (check-message "inexact->exact: +inf.0 has no exact value" (g:inexact->exact +inf.0))
  (check-message "inexact->exact: +nan.0 has no exact value" (g:inexact->exact (up 1.0 +nan.0)))
  (check-message
   (string-append "inexact->exact: cannot be taken of a list\n  argument 1: (1.0 2), a list\n"
                  "  a list is not a tuple; use (up x y ...)")
   (g:inexact->exact '(1.0 2))))
