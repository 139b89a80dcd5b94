#lang racket/base
;; Procedures that the book's programs take from MIT Scheme.

(require mechanics racket/port "../support/checks.rkt")

(define (printed thunk) (with-output-to-string thunk))

(test-case "counting"
  (check-equal? (list (1+ 1/2) (-1+ 3)) '(3/2 2))
  (check-equal? (1+ 'n) (+ 'n 1))
  (check-equal? (iota 4) '(0 1 2 3))
  (check-equal? (iota 3 1 1/2) '(1 3/2 2))
  (check-equal? (iota 2 'a 'h) (list 'a (+ 'a 'h)))
  (check-equal? (iota 0) '())
  (check-exn #rx"^iota: .*a length, a natural number" (lambda () (iota -1))))

(test-case "values are written as they stand, on a line"
  (define x (+ (* 'a 'b) (* 'a 'b)))
  (check-equal? (printed (lambda () (write-line x))) "(+ (* a b) (* a b))\n")
  (check-equal? (printed (lambda () (write-line "a b"))) "\"a b\"\n")
  (define port (open-output-string))
  (write-line (up 1 2) port)
  (check-equal? (get-output-string port) "(up 1 2)\n"))

(test-case "or on several"
  (define long (apply up (for/list ([i 6]) (* 'amplitude (cos (+ (* i 'omega 't) 'phase))))))
  (define lines (printed (lambda () (pp long))))
  (check-true (> (length (regexp-split #rx"\n" lines)) 5))
  (check-regexp-match #rx"^[(]up [(][*] amplitude" lines)
  (check-equal? (printed (lambda () (pp '(a "b" #\c)))) "(a \"b\" #\\c)\n")
  (define port (open-output-string))
  (pp (up 1 2) port)
  (check-equal? (get-output-string port) "(up 1 2)\n"))

(test-case "time"
  (check-true (<= 0 (runtime) (begin (for ([_ 1000]) (sin 1.0)) (runtime))))
  (check-regexp-match (pregexp (string-append "^process time: \\d+ ms "
                                              "\\(-?\\d+ run \\+ \\d+ gc\\); "
                                              "real time: \\d+ ms\n$"))
                      (printed (lambda () (show-time void))))
  (parameterize ([current-output-port (open-output-nowhere)])
    (check-equal? (show-time (lambda () (+ 1 2))) 3)
    (check-equal? (call-with-values (lambda () (show-time (lambda () (values 1 2)))) list) '(1 2)))
  (check-equal? (parameterize ([current-output-port (open-output-nowhere)])
                  (list (show-time 3) (show-time (+ 1 2)) (show-time (up 1 2))
                        (map show-time (list 4))))
                (list 3 3 (up 1 2) '(4))))
