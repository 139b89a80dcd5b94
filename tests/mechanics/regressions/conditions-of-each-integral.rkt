#lang racket/base
;; A condition of an integral, and the note that nothing was seen of an integrand, were told once in
;; a session: the second result with the same condition stood there without it.

(require (only-in racket/port open-output-nowhere)
         (only-in mechanics/error/note end-result-of-notes! note-once note-with-result)
         "../support/checks.rkt" "../support/notes.rkt" "../support/run-text.rkt")

(define (errors-of . text)
  (told (parameterize ([current-output-port (open-output-nowhere)]) (apply prints text))))

(define positive "; definite-integral: the formula holds if (> (* a b) 0)\n")

(test-case "each integral has its conditions"
  (check-equal? (errors-of "(definite-integral (lambda (x) (/ 1 (square x))) 'a 'b)"
                           "(definite-integral (lambda (x) (/ 1 x)) 'a 'b)")
                (string-append positive positive))
  (check-equal? (errors-of "(define I (definite-integral (lambda (x) (/ 1 (square x))) 'a 'b))"
                           "(define J (definite-integral (lambda (x) (/ 1 x)) 'a 'b))")
                (string-append positive positive)))

(test-case "each integral of which nothing was seen is told, once for a result"
  (define (narrow c)
    (format "(definite-integral (lambda (x) (if (< ~a x 0.3713) 1.0 0.0)) -10 10)" c))
  (define told-once (errors-of (narrow 0.3712345)))
  (check-regexp-match #rx"^; definite-integral: the integrand was 0 at all points" told-once)
  (check-equal? (errors-of (narrow 0.3712345) (narrow 0.3712346))
                (string-append told-once told-once))
  (check-equal? (errors-of (format "(list ~a ~a)" (narrow 0.3712345) (narrow 0.3712346)))
                told-once))

(test-case "advice stays with the session, notes of results with results"
  (check-equal? (told (note-once "advice") (note-with-result "bound") (note-with-result "bound")
                      (end-result-of-notes!)
                      (note-once "advice") (note-with-result "bound"))
                "; advice\n; bound\n; bound\n"))
