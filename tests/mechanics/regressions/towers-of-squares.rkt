#lang racket/base
;; Graphs of squares of squares are compared and printed at the cost of their
;; nodes; their hashes once agreed from depth 48, and what was left out of a text
;; was counted in a thousand digits.

(require mechanics/algebra/expression/expression
         mechanics/algebra/expression/write
         mechanics/show/display/layout
         "../support/checks.rkt")

(define (shared n)
  (for/fold ([e 'x]) ([_ (in-range n)]) (e:+ (e:* e e) 1)))

(test-case "towers of different height differ"
  (check-false (equal? (shared 200) (shared 201)))
  (check-true (equal? (shared 200) (shared 200)))
  (check-equal? (length (for/fold ([hashes '()]) ([n (in-range 300)])
                          (define h (expression-hash (shared n)))
                          (if (memv h hashes) hashes (cons h hashes))))
                300))

(test-case "the text of a huge expression is bounded"
  (check-true (< (string-length (format "~a" (shared 5000))) 100000))
  (check-true (< (string-length (layout (expression->datum (shared 5000)) 79)) 1000000)))

(test-case "pairs that are no lists print"
  (check-equal? (datum->text '(a . b)) "(a . b)"))
