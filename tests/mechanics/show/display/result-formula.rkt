#lang racket/base
;; A result that is drawn, without a drawing: its size, and what it is in files.

(require mechanics/algebra/notation/formula
         mechanics/show/display/formula-reader
         mechanics/show/display/result-formula
         racket/class
         "../../support/checks.rkt")

(define tree (plain-datum->tree '(/ (+ a b) (* 2 c))))
(define f (formula tree '() "(/ (+ a b) (* 2 c))" "(a + b)/(2 c)" 80))

(test-case "numbers, names and words are counted, shared ones as often as they are drawn"
  (check-equal? (formula-size (plain-datum->tree 'a)) 1)
  (check-equal? (formula-size tree) 4)
  (define deep (for/fold ([t tree]) ([_ 10]) (plain-datum->tree (list '+ t t))))
  (check-equal? (formula-size deep) 4096))

(test-case "it is the same when it is read again, and other bytes are none"
  (check-equal? (bytes->formula (formula->bytes f)) f)
  (check-false (bytes->formula #"no formula")))

;; A file as it is read where there are no editors
(define (stream-of bytes)
  (new (class object% (super-new) (define/public (read-raw-bytes what) bytes))))

(test-case "in a program it is its S-expression, as text or as syntax with its place"
  (define (read text-only?)
    (send reader read-snip text-only? #f (stream-of (formula->bytes f))))
  (check-equal? (read #t) #"(/ (+ a b) (* 2 c))")
  (define s (send (read #f) read-special 'here 7 3 90))
  (check-equal? (syntax->datum s) '(/ (+ a b) (* 2 c)))
  (check-equal? (list (syntax-source s) (syntax-line s) (syntax-column s)) '(here 7 3))
  (check-equal? (send reader read-snip #f #f (stream-of #"no formula")) #"."))
