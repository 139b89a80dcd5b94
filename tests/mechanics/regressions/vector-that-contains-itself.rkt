#lang racket/base
;; To print a vector that is its own element, the prompt walked through it without end.

(require mechanics
         mechanics/generic/cyclic-data
         (only-in mechanics/lang/printer print-result)
         "../support/checks.rkt" "../support/patience.rkt")

(define (vector-in-itself)
  (define v (vector 'a 0))
  (vector-set! v 1 v)
  v)

(define (list-in-itself)
  (define p (make-placeholder #f))
  (placeholder-set! p (list 'a p))
  (make-reader-graph p))

;; The text written; #f if it does not end
(define (written thunk)
  (define out (open-output-string))
  (value-within 60 1000
                (lambda ()
                  (parameterize ([current-output-port out]) (thunk))
                  (get-output-string out))
                #f))

(define-check (check-written thunk expected)
  (define text (written thunk))
  (unless (equal? text expected)
    (with-check-info (['written text] ['expected expected]) (fail-check))))

(test-case "a vector that contains itself is printed as Racket prints it"
  (define v (vector-in-itself))
  (check-written (lambda () (print-expression v)) "#0='#(a #0#)\n")
  (check-written (lambda () (print-expression (list 1 v))) "'(1 #0=#(a #0#))\n"))

(for ([x (list (vector-in-itself) (list-in-itself) (list 'a (vector-in-itself)))])
  (test-case "what contains itself is left to Racket at the prompt and where it is displayed"
    (check-true (cyclic? x))
    (for ([show (list print-result display (lambda (y) (display (format "~a" y))))])
      (check-regexp-match #rx"#0=" (written (lambda () (show x)))))))

(test-case "what is shared alone does not contain itself, however often"
  (define shared (for/fold ([x (vector 1 2)]) ([_ (in-range 60)]) (vector x (list x))))
  (check-false (cyclic? shared))
  (check-false (cyclic? '(1 (2 . 3) #(4)))))
