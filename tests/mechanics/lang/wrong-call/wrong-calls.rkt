#lang racket/base
;; Hints beneath messages about calls that a procedure of the library does not take:
;; its arguments by name, the missing ones, the keyword that may have been meant.

(require (for-label mechanics/lang/help/card-table)
         (only-in mechanics/lang/wrong-call/signature-hint
                  count-hint order-hint constraint-hint keyword-names)
         racket/string
         "../../support/checks.rkt" "../../support/run-text.rkt")

(define (text . lines) (string-join lines "\n"))

(define (arity name expected given . arguments)
  (apply text (format "~a: arity mismatch;" name)
         " the expected number of arguments does not match the given number"
         (format "  expected: ~a" expected) (format "  given: ~a" given)
         (if (null? arguments)
             '()
             (cons "  arguments...:" (map (lambda (a) (string-append "   " a)) arguments)))))

;; ---------------------------------------------------------------------------
;; Numbers of arguments

(test-case "a missing argument is named"
  (check-equal? (count-hint (arity 'verify-conserved
                                   "3 plus an optional argument with keyword #:force" 2
                                   "#<procedure:L>" "#<procedure:Q>"))
                (text ""
                      "  it is called as (verify-conserved L Q local [#:force force])"
                      "  missing: local")))

(test-case "the messages of what is loaded on demand are understood, and those of arithmetic"
  (check-equal? (count-hint (text "find-path: takes 6 arguments; it was given 2"
                                  "  its keywords: (#:observe)"))
                (text ""
                      "  it is called as (find-path L t0 q0 t1 q1 n [#:tolerance tolerance]"
                      "      [#:observe observe] [#:most-steps most]"
                      "      [#:progress? progress?])"
                      "  missing: q0, t1, q1, n"))
  (check-equal? (count-hint "minimize: takes 3 arguments; it was given none\n  its keywords: ()")
                (text ""
                      "  it is called as (minimize f low high [#:tolerance tolerance]"
                      "      [#:observe observe] [#:progress? progress?])"
                      "  missing: f, low, high"))
  (check-equal? (count-hint "sin: expected 1 argument, given 2: 1, 2")
                "\n  it is called as (sin x)")
  (check-equal? (count-hint "sin: expected 1 argument, given 0")
                "\n  it is called as (sin x)\n  missing: x")
  (check-equal? (count-hint (text "application: no case matching 0 non-keyword arguments"
                                  "  procedure: Gamma"))
                "\n  it is called as (Gamma q [n])\n  missing: q"))

(test-case "an argument too many may be meant for a keyword, which its value tells"
  (define (question . arguments)
    (define hint
      (count-hint (apply arity 'verify-solution "a different number plus optional arguments" 4
                         "#<procedure:L>" "#<procedure:q>" "#f" arguments)))
    (last-line hint))
  (define (last-line hint) (car (reverse (string-split hint "\n"))))
  (check-equal? (question "(holonomic <function>)") "  did you mean #:constraints?")
  (check-equal? (question "2") "  did you mean #:order?")
  (check-equal? (question "#<procedure:f>") "  did you mean #:force or #:multipliers?")
  (check-equal? (last-line (count-hint "evolve-trajectory: takes 3 arguments; it was given 4"))
                "      [#:progress? progress?])"))

(test-case "a function that is called in two steps, too many or too few in either"
  (define one "\n  it is called as (F->C F)")
  (define applied "\n  its value is a function, which takes what comes next: ((F->C F) ...)")
  (check-equal? (count-hint (arity 'F->C 1 2)) (string-append one applied))
  (check-equal? (count-hint (arity 'F->C 1 3)) one)
  (check-equal? (count-hint (arity 'cube 1 2)) "\n  it is called as (cube x)")
  (check-equal? (count-hint "Hamilton-equations: takes 1 argument; it was given 2")
                (text ""
                      "  it is called as (Hamilton-equations H [#:force force])"
                      "  did you mean #:force?"
                      "  its value is a function, which takes what comes next: ((Hamilton-equations H) ...)"))
  (define called "\n  it is called as ((principal-value cut) x)")
  (check-equal? (count-hint (arity 'principal-value 1 2)) called))

(test-case "several ways to call are all told"
  (check-equal? (count-hint (arity 'transpose "1 or 2" 3))
                "\n  it is called as (transpose m)\n  it is called as (transpose m right)"))

(test-case "nothing is said of what the reader or Racket defined"
  (check-false (count-hint (arity 'my-own 1 2)))
  (check-false (count-hint (arity 'map 2 0)))
  ;; Of other numbers than the manual says, or taken by it: another function.
  (check-false (count-hint (arity 'find-path 2 6)))
  (check-false (count-hint (arity 'Gamma 3 1)))
  (check-false (count-hint (arity 'square 2 3)))
  ;; The book's objects are commonly typed.
  (check-false (count-hint (arity 'L-harmonic 2 3)))
  (check-false (count-hint "arity mismatch")))

(test-case "arguments in the wrong order"
  (check-equal? (order-hint "find-path: a Lagrangian is a function of the local tuple")
                (text ""
                      "  it is called as (find-path L t0 q0 t1 q1 n [#:tolerance tolerance]"
                      "      [#:observe observe] [#:most-steps most]"
                      "      [#:progress? progress?])"))
  (check-false (order-hint "Lagrangian->energy: a Lagrangian is a function of the local tuple"))
  (check-false (order-hint "my-own: a path is a function of time")))

;; ---------------------------------------------------------------------------
;; Keywords

(test-case "keywords are those of the manual"
  (check-equal? (keyword-names 'find-path)
                '(|#:tolerance| |#:observe| |#:most-steps| |#:progress?|))
  (check-equal? (keyword-names 'map) '()))

(test-case "a constraint where none is expected"
  (define (given who value)
    (text (format "~a: expected a dissipation function: a function of the local tuple" who)
          (format "  given: ~a" value)))
  (define (hint who value) (constraint-hint (given who value)))
  (check-equal? (hint 'verify-solution "(nonholonomic blade)") "\n  did you mean #:constraints?")
  (check-false (hint 'Lagrange-equations "(holonomic rod)"))
  (check-false (hint 'verify-solution "3")))

;; ---------------------------------------------------------------------------
;; Where the reader is

(test-case "at the prompt"
  (define-values (output errors)
    (session '("-I" "mechanics")
             "(define (L local) 0)"
             "(verify-conserved L L)"
             "(verify-solution L L (holonomic (lambda (t q) q)))"
             "(find-path L 0 0 1 1 2 #:tol 1)"
             "(find-path L 0 0 1 1 2 #:observer 1)"
             "(find-path L 0 0 1 1 2 #:progess? #f)"
             "(find-path L 0 0 1 1 2 #:progress #f)"
             "(define (minimize f) f)"
             "(minimize 1 2)"
             "(Lagrangian-action L 0 1 sin)"
             "(require mechanics/book)"
             "(L-harmonic 'm)"
             "derivative-of-sine"))
  (check-equal? output '())
  (check-regexp-match #rx"#:force force[]][)]\n  missing: local\n" errors)
  (check-regexp-match #rx"given: [(]holonomic <function>[)]\n  did you mean #:constraints[?]\n"
                      errors)
  (check-regexp-match #rx"no keyword #:tol here\n.*#:tolerance[)]\n  did you mean #:tolerance[?]\n"
                      errors)
  (check-regexp-match #rx"no keyword #:observer here\n[^\n]*\n  did you mean #:observe[?]\n" errors)
  (check-regexp-match #rx"no keyword #:progess[?] here\n[^\n]*\n  did you mean #:progress[?][?]\n"
                      errors)
  ;; an earlier keyword has its own advice, and no guess beneath it
  (check-regexp-match
   #rx"no keyword #:progress here\n[^\n]*\n  it is called #:progress[?] now\n[^ ]"
   errors)
  (check-regexp-match (regexp (string-append "minimize: takes 1 argument; it was given 2\n"
                                             "  it is called as [(]minimize f[)]\n"))
                      errors)
  (check-regexp-match
   #rx"given the number 0\n[^\n]*\n  it is called as [(]Lagrangian-action L q t1 t2 "
   errors)
  (check-regexp-match #rx"  it is called as [(][(]L-harmonic m k[)] local[)]\n" errors)
  (check-regexp-match #rx"\n  as a symbol it is written 'derivative-of-sine\n" errors))

(test-case "an unknown name in a module"
  (check-regexp-match
   (regexp (string-append "derivative-of-sine: unbound identifier; "
                          "as a symbol it is written 'derivative-of-sine"))
   (refusal "(define (f x) (derivative-of-sine x))")))
