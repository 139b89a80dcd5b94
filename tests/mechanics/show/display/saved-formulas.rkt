#lang racket/base
;; Formulas in files, read by programs that have no editors: each is the S-expression that it was
;; saved with, and bytes that are none are refused.

(require mechanics/algebra/notation/tree
         (only-in mechanics/generic/value-tree value->tree)
         (only-in mechanics/show/display/formula-reader reader)
         mechanics/show/display/result-formula
         racket/class
         racket/fasl
         "../../support/checks.rkt")

(define (formula-of program) (formula (value->tree 1 #t) '() program program 79))

;; What stands in a program for the bytes of a file; text-only? : is only their text wanted?
(define (read-from bytes [text-only? #f])
  (define stream (new (class object% (super-new) (define/public (read-raw-bytes who) bytes))))
  (send reader read-snip text-only? 1 stream))

(define (read-in-program program)
  (syntax->datum (send (read-from (formula->bytes (formula-of program))) read-special 'here 1 2 3)))

(test-case "a formula is its one S-expression, and words are a string"
  (check-equal? (read-in-program "(/ r theta_1)") '(/ r theta_1))
  (check-equal? (read-in-program "proved: it is zero") "proved: it is zero")
  (check-equal? (read-in-program "(open") "(open"))

(test-case "where only the text is wanted it is this; a point stands for what is no formula"
  (check-equal? (read-from (formula->bytes (formula-of "(/ a b)")) #t) #"(/ a b)")
  (check-equal? (read-from #"nothing of ours") #".")
  (check-equal? (read-from #"nothing of ours" #t) #"."))

(test-case "bytes of other values are no formula"
  (for ([x (list 'a (formula-of 7))]) (check-false (bytes->formula (s-exp->fasl x))))
  (check-equal? (formula-program (bytes->formula (formula->bytes (formula-of "x")))) "x"))

(test-case "a tree has as many parts as are drawn, shared ones each time"
  (define part (value->tree 2 #t))
  (check-equal? (formula-size part) 1)
  (check-equal? (formula-size (listing (list part part (listing (list part part))))) 4))
