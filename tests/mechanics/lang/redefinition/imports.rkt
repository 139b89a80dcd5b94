#lang racket/base
;; Names that a `#lang mechanics` module imports and defines.

(require "../../support/checks.rkt" "../../support/run-text.rkt")

(test-case "what the language exports may be used until it is replaced"
  (check-equal? (prints "(define (f) (square 3))"
                        "(f)"
                        "(define (square x) (list 'mine x))"
                        "(f)"
                        "(define (square x) (list 'again x))"
                        "(f)"
                        "square")
                (lines "9" "'(mine 3)" "'(again 3)" "square")))

(test-case "so may a function with keywords, which is a macro with a value"
  (check-equal? (prints "(define ((L m) (up t q v)) (* 1/2 m (square v)))"
                        "(define (residual) (((Lagrange-equations (L 'm)) cube) 't))"
                        "(residual)"
                        "(define (((Lagrange-equations L) q) t) 'mine)"
                        "(residual)")
                (lines "(* 6 m t)" "mine")))

(test-case "a definition may wrap what the language exports"
  (check-equal? (prints "(define sin (compose square sin))" "(sin 't)" "(cos 't)")
                (lines "(expt (sin t) 2)" "(cos t)"))
  (check-equal? (prints "(define time (up 't 'x))" "(list (velocity (up 0 1 2)) time)")
                (lines "(list 2 (up t x))")))

(test-case "what is not used before its definition is the module's own from the start"
  (check-equal? (prints "(define (f) (square 3))" "(define (square x) 'mine)" "(f)")
                (lines "mine"))
  (check-equal? (prints "(define (square n) (if (= n 0) '(end) (square (- n 1))))" "(square 2)")
                (lines "'(end)")))

(test-case "a name of a library that is required may be defined"
  (check-equal? (prints "(require racket/list)"
                        "(define (f) (first '(1 2)))"
                        "(f)"
                        "(define (first x) 'mine)"
                        "(f)"
                        "(second '(1 2))")
                (lines "1" "mine" "2"))
  (check-equal? (prints "(require (prefix-in r: racket/list) (only-in racket/list first second))"
                        "(define first 1)"
                        "(list first (second '(1 2)) (r:first '(3)))")
                (lines "'(1 2 3)")))

(test-case "names that clash in another phase, under another name or locally do not clash"
  (check-equal? (prints "(require (for-syntax racket/base racket/list))"
                        "(define-syntax (show-first stx) (first (list #'(first 1))))"
                        "(define (first x) (list 'mine x))"
                        "(show-first)")
                (lines "'(mine 1)"))
  (check-equal? (prints "(require (only-in racket/list [first head]))"
                        "(head '(1))"
                        "(define head 3)"
                        "(define first 4)"
                        "(list head first)")
                (lines "1" "'(3 4)"))
  (check-equal? (prints "(define (f) (local-require racket/list) (first '(1)))"
                        "(define (first) 2)"
                        "(list (f) (first))")
                (lines "'(1 2)")))

(test-case "a library that does not exist is told as ever"
  (check-regexp-match #rx"^example:2:9: no-such: not a require sub-form"
                      (refusal "(require (no-such racket/list))" "(define first 1)"))
  (check-regexp-match #rx"^example:2:9: cannot open module file"
                      (refusal "(require racket/no-such)" "(define first 1)")))

;; ---------------------------------------------------------------------------
;; Requires below a definition

;; The messages while it is compiled.
(define (said . text)
  (define port (open-output-string))
  (parameterize ([current-error-port port]) (apply prints text))
  (get-output-string port))

(test-case "a definition is not replaced by what is required below, and that is said"
  (define program
    '("(define ((first x) y) 'mine)"
      "(define (f) ((first '(1 2)) 0))"
      "(define last 5)"
      "(f)"
      "(require racket/list)"
      "(list (f) ((first 0) 0) last (second '(1 2)))"))
  (check-equal? (apply prints program) (lines "mine" "'(mine mine 5 2)"))
  (check-equal? (apply said program)
                (lines "; racket/list: your own definitions stay"
                       ";   (first x), defined on line 2"
                       ";   last, defined on line 4"
                       ";   the library's: (require (prefix-in its: racket/list)), then its:first")))

(test-case "what is asked for by name replaces it, without a word"
  (define program
    '("(define (first x) 'mine)"
      "(define (f) (first '(1 2)))"
      "(f)"
      "(require (only-in racket/list first))"
      "(f)"))
  (check-equal? (apply prints program) (lines "mine" "1"))
  (check-equal? (apply said program) ""))

(test-case "a definition below what is required is nobody's mistake"
  (check-equal? (said "(require racket/list)" "(define (first x) 'mine)" "(first 1)") ""))


(test-case "a macro of the language or of a library may give way to a function"
  (check-equal? (prints "(match 1 [x (list x)])" "(define (match x) 'mine)" "(match 2)")
                (lines "'(1)" "mine"))
  (check-equal? (prints "(require racket/list)"
                        "(define (struct-of x) x)"
                        "(define range 3)"
                        "range")
                (lines "3")))

(test-case "a submodule may define what the module around it does"
  (check-equal? (run-submodule 'test language
                               "(define (f) 'outer)"
                               "(module+ test (f) (define (f) 'inner) (f) (square 2)"
                               "  (define (square x) 'inner) (square 2))"
                               "(define (g) (list (f) (square 3)))"
                               "(g)")
                (lines "'(outer 9)" "outer" "inner" "4" "inner")))
