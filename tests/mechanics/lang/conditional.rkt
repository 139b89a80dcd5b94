#lang racket/base
;; `if` and its kin are Racket's, but refuse a verdict for a test.

(require mechanics
         (only-in racket/base [expand racket:expand])
         "../support/checks.rkt" "../support/messages.rkt")

(define v (prove-zero 'x))

(define (refusal who) (string-append who ": a verdict is neither true nor false; ask (proved? v)\n"
                                     "  given: refuted: the residual is not zero"))

(test-case "a verdict is no test"
  (check-message (refusal "if") (if v 'yes 'no))
  (check-message (refusal "cond") (cond [#f 1] [v 'yes] [else 'no]))
  (check-message (refusal "cond") (cond [v => list]))
  (check-message (refusal "cond") (cond [v]))
  (check-message (refusal "and") (and v #t))
  (check-message (refusal "or") (or #f v #t))
  (check-message (refusal "not") (not v))
  (check-message (refusal "not") (map not (list v)))
  (check-message (refusal "when") (when v 1))
  (check-message (refusal "unless") (unless v 1)))

(test-case "nor is another answer that is more than yes or no"
  (define (L s) (- (square (velocity s)) (square (coordinate s))))
  (check-message
   (string-append "if: how stable it is, is neither true nor false; "
                  "ask (eq? (stability-kind s) 'stable)\n  given: stable")
   (if (equilibrium-stability L 0) 1 2))
  (check-exn #rx"^if: .*ask [(]proved[?] [(]equivalence-verdict e[)][)]\n  given: equivalent"
             (lambda () (if (compare-Lagrangians L L (up 't 'x 'v)) 1 2))))

(test-case "it may be a value"
  (check-eq? (and #t v) v)
  (check-eq? (or #f v) v)
  (check-eq? (if #t v #f) v)
  (check-eq? (cond [else v]) v))

(test-case "all else is as in Racket"
  (check-eqv? (if '() 1 2) 1)
  (check-eqv? (if (proved? v) 1 2) 2)
  (check-equal? (cond [(memq 'a '(b a c)) => cdr] [else 0]) '(c))
  (check-equal? (cond [(memq 'a '(b a))]) '(a))
  (check-equal? (cond) (void))
  (check-equal? (list (and) (or) (and 1) (or 2) (and 1 2) (or #f 3)) '(#t #f 1 2 2 3))
  (check-equal? (map not '(#t #f 0)) '(#f #t #f))
  (check-equal? (when 1 2 3) 3)
  (check-equal? (unless #f 2 3) 3)
  (check-eq? (object-name not) 'not))

(define-namespace-anchor here)
(define (complaint form)
  (parameterize ([current-namespace (namespace-anchor->namespace here)])
    (message-of (racket:expand form) exn:fail:syntax?)))

(test-case "what is written wrongly is refused in Racket's words"
  (check-regexp-match #rx"^if: missing an \"else\" expression" (complaint '(if 1 2)))
  (check-regexp-match #rx"cond: bad syntax [(]clause is not a test-value pair[)]"
                      (complaint '(cond 3)))
  (check-regexp-match (string-append "cond: bad syntax [(]`else' clause must be last[)].*"
                                     " in: [(]cond [(]else 1[)] [(]#t 2[)][)]")
                      (complaint '(cond [else 1] [#t 2])))
  (check-regexp-match (string-append "cond: bad syntax [(]bad clause form with =>[)].*"
                                     " at: [(]#t => 1 2[)].* in: [(]cond [(]#t => 1 2[)][)]")
                      (complaint '(cond [#t => 1 2])))
  (for ([name '(if when unless)])
    (check-regexp-match (format "^~a: bad syntax" name) (complaint name))))
