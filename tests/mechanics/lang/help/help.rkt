#lang racket/base
;; The output of `help`.

(require (for-label mechanics/lang/help/card-table)
         mechanics
         mechanics/lang/help/help-answer
         mechanics/lang/help/card
         mechanics/lang/help/card-lines
         mechanics/lang/help/cards
         mechanics/lang/help/finding
         mechanics/lang/help/search
         (only-in racket/list take)
         (only-in racket/port with-output-to-string)
         (only-in racket/string string-contains? string-join string-prefix?)
         (only-in "../../support/run-text.rkt" lines prints refusal session)
         "../../support/checks.rkt")

(define (text about) (string-join (help-lines about) "\n"))

;; Names among what is found.
(define (found text)
  (define-values (all fit?) (find-in-table (table-of-search) text))
  (for/list ([f (in-list all)] #:when (eq? (finding-kind f) 'name))
    (string->symbol (finding-title f))))

(test-case "the card of a function"
  (check-equal? (text 'iota)
                #<<end
(iota n [start] [step])  → list
  The list of n values from start on, each larger by step.

  n       0, 1, 2 …
  start   0 unless given
  step    1 unless given

  > (iota 4)
  '(0 1 2 3)

  Manual: The language.
  See also: list-head, -1+.
end
                ))

(test-case "a card with definitions, a keyword and a place in the book"
  (check-equal? (text 'verify-solution)
                #<<end
(verify-solution L q [dissipation] [#:force force] [#:order n]
      [#:constraints constraints] [#:multipliers lambda])  → verdict
  Whether the path q satisfies Lagrange's equations of L at all times.

  L             Lagrangian
  q             path
  dissipation   function
  force         function
  n             1, 2, 3 …; 1 unless given
  constraints   constraint, list or up
  lambda        path

  (define ((L-free m) (up t q v)) (* 1/2 m (square v)))
  > (verify-solution (L-free 'm) (lambda (t) (up (* 'a t) 'b)))
  proved: the residual is zero

  Book: 1.5, p. 36. Manual: Verdicts.
  See also: Lagrange-equations, verdict-kinks, constrained-Lagrange-equations,
  eliminate-multipliers, verify-again.
end
                ))

(test-case "arguments of functions are listed by commas, and sequences tell of what"
  (define card (text 'evolve-ensemble))
  (for ([line '("  fold         value, so far → so far\n" "  starts       sequence of states\n"
                "  parameters   sequence of lists of parameters\n")])
    (check-true (string-contains? card line) line)))

(test-case "the card of a name of another library says which"
  (check-true (string-contains? (text 'L-harmonic) "\n  (require mechanics/book) provides it.\n")))

(test-case "a page that comes to a library further down has names of both"
  (check-false (string-contains? (text 'read-infix) "provides it"))
  (check-true (string-contains? (text '->pict) "\n  (require mechanics/pict) provides it.\n")))

;; They show messages, which are not broken into lines.
(define refusals '(^ graphics-save unequal-contraction))

;; cards.rkt measures what examples print.
(test-case "no line of any card, but of examples, is longer than 80"
  (for* ([c (in-list (all-cards))]
         #:unless (memq (card-name c) refusals)
         [line (in-list (card-lines (struct-copy card c [demonstration #f]) 80))]
         #:unless (regexp-match? #rx"^  .*[()0-9]" line))
    (check-true (<= (string-length line) 80) line)))

;; ---------------------------------------------------------------------------
;; Names without a card

(test-case "a name that is spelt nearly so, or like nothing"
  (check-equal? (text 'cubbe) "cubbe is not a name of mechanics.  Did you mean cube?")
  (check-equal? (text 'Poison-bracket)
                "Poison-bracket is not a name of mechanics.  Did you mean Poisson-bracket?")
  (check-equal? (text 'arctan) "arctan is not a name of mechanics: its name is atan.")
  (check-equal? (text 'x^2) "x^2 is not a name of mechanics: operations come first, (expt x 2).")
  (check-equal? (text '’x) "’x is not a name of mechanics: ’ in it is a curly quote; type 'x.")
  (check-equal? (text 'zzyzx) "zzyzx is not a name of mechanics."))

(test-case "what other programs have a name for is told for a text, too"
  (define said
    (string-append "degrees is not a name of mechanics: angles are in radians: 30 degrees are "
                   "(* 30\n(/ pi 180))."))
  (check-equal? (text 'degrees) said)
  (check-true (string-prefix? (text "degrees") (string-append said "\n")))
  (check-true (string-contains? (text "degrees") "\nDegrees, units, "))
  (check-not-false (memq 'degrees-of-freedom (found "degrees")))
  (check-equal? (text "arctan") "arctan is not a name of mechanics: its name is atan."))

(test-case "Racket's names"
  (check-equal? (text 'map)
                (string-append "map is Racket's own, and means here what it means there.\n"
                               "  https://docs.racket-lang.org/search/?q=map"))
  (check-true (string-contains? (text 'match) "Racket's own"))
  (check-true (string-contains? (text 'sin) "(sin x)  → value")))

;; ---------------------------------------------------------------------------
;; Texts

(test-case "a text finds the names that have its words, those with all of them in the name first"
  (check-eq? (car (found "constraint")) 'constraint-forces)
  (for ([name '(constraint? constraint-integral)])
    (check-not-false (memq name (take (found "constraint") 4))))
  (check-equal? (take (found "conserved") 2) '(verify-conserved conserved-momenta))
  (check-not-false (memq 'holonomic (found "constraints")))
  (check-not-false (memq 'Frobenius-test (found "Constraints velocity")))
  (check-equal? (found "spline hermite") '(Hermite-spline))
  (check-equal? (found "no such thing here") '()))

;; A minimum by golden sections came first, and for an integral the failures to find one.
(test-case "of what has the words, that comes first which is about them, and is used most"
  (define (page-of name) (card-page (card-of name)))
  (for ([text '("section" "map" "matrix")]
        [page '(#rx"aps" #rx"aps" #rx"^Matrices and linear")])
    (for ([name (take (found text) 5)]) (check-regexp-match page (page-of name) text)))
  (check-not-false (memq 'golden-section-min (found "section")))
  (check-eq? (car (found "integral")) 'definite-integral)
  (for ([name (take (found "integral") 10)])
    (check-false (regexp-match? #rx"^exn:" (symbol->string name)))))

;; sin is what singular begins with, and nothing has Lagrange's written so in its name.
(test-case "words are found with other endings, and before what only begins like them"
  (for ([text '("sine" "Lagrange's equations" "Lagrange’s equation" "simplification")]
        [name '(sin Lagrange-equations Lagrange-equations simplify)])
    (check-eq? (car (found text)) name))
  (check-not-false (memq 'Noether-integral (found "angular momentum conservation"))))

;; "of" is in hardly any entry of what it is asked for with.
(test-case "words that only join others are not looked for, unless there are no others"
  (check-equal? (found "what is the fixed point of a map") (found "fixed point map"))
  (check-not-false (memq 'simplify (take (found "how do I simplify an expression") 5)))
  (check-eq? (car (found "what is a Lagrangian")) 'Lagrangian)
  (check-pred pair? (found "the"))
  (check-equal? (found "the section's") (found "section")))

(test-case "what is called as the text is comes first of all"
  (for ([name '(Lagrangian derivative sqrt up UP velocity)])
    (check-eq? (car (found (symbol->string name))) name)))

(test-case "accents may be typed or not"
  (for ([with '("Poincaré" "Hénon" "POINCARE\u301")] [without '("Poincare" "Henon" "poincare")])
    (check-pred pair? (found with))
    (check-equal? (found with) (found without))))

(test-case "where few are found, what the manual says beyond its first sentence finds more"
  (check-not-false (andmap (lambda (name) (memq name (found "projection")))
                           '(consistent-state constrained-state-derivative S2-stereographic)))
  (check-equal? (found "constraint projection")
                '(consistent-state constrained-state-derivative))
  (check-not-false (memq 'constrained-state-derivative (found "drift")))
  (check-equal? (car (found "drift")) 'constrained-state-derivative))

(test-case "what is found stands in lines of 80 columns"
  (for ([words '("constraint" "tuple" "a" "energy")])
    (for ([line (in-list (help-lines words))])
      (check-true (<= (string-length line) 80) line))))

(test-case "what is too much is counted; what is nothing is said"
  (check-regexp-match #rx"\n[.][.][.] and [0-9]+ more, less near; another word finds fewer[.]\n"
                      (text "energy"))
  (check-equal? (text "xyzzy plugh")
                "Nothing is found for \"xyzzy plugh\"; (help) tells what can be asked.")
  (check-equal? (text " ") (text #f)))

(test-case "ten answers at most, each with how to open it"
  (check-equal? (length (regexp-match* #rx"(?m:^[^ .].*$)" (text "pendulum")))
                11)                    ; and the line of pages
  (check-equal? (text "exercise 7.5")
                #<<end
Exercise 7.5: spin and orbit.
  make run FILE=examples/mechanics/exercises/exercise-7-5.rkt
end
                )
  (check-regexp-match #rx"^Friction, in: From Newton to Lagrange\n  manual: Newton-to-L.*.html\n"
                      (text "friction"))
  (check-regexp-match #rx"\n\nPages of the manual: make docs, .*$" (text "friction"))
  (check-regexp-match #rx"(?m:^mechanics/animate  *a library: [(]require mechanics/animate[)]$)"
                      (text "animate")))

(test-case "of words that are not all together somewhere, what has most of them is told"
  (check-regexp-match #rx"^Nothing has all words of \"quaternion homework\"; these have some.\n"
                      (text "quaternion homework")))

(test-case "a word that is misspelt finds what the right one does"
  (check-equal? (text "pendulm")
                (string-append "Nothing is found for \"pendulm\"; did you mean \"pendulum\"?\n"
                               (text "pendulum"))))

;; ---------------------------------------------------------------------------
;; The form

(define-syntax-rule (printed e) (with-output-to-string (lambda () e)))

(test-case "a name may be quoted, and need not have a value"
  (check-equal? (printed (help iota)) (printed (help 'iota)))
  (check-equal? (printed (help #%app)) (string-append (text '#%app) "\n"))
  (check-equal? (printed (help no-such-name)) "no-such-name is not a name of mechanics.\n")
  (check-equal? (printed (help "spline hermite")) (string-append (text "spline hermite") "\n"))
  (check-regexp-match #rx"^[(]help name[)]" (printed (help))))

(test-case "anything else is no question"
  (for ([program '("(help 3)" "(define x help)" "(help a b)")])
    (check-regexp-match #rx": help: ask [(]help[)], [(]help verify-solution[)] or [(]help \"constr"
                        (refusal program))))

(test-case "the reader's own definitions are not disturbed, nor disturb"
  (check-equal? (prints "(define (cube x) 0)" "(help cube)" "(cube 2)")
                (string-append (text 'cube) "\n0\n"))
  (check-equal? (prints "(help cube)" "(define (help x) (* 2 x))" "(help 3)")
                (string-append (text 'cube) "\n6\n")))

(test-case "at a prompt, in this language and in Racket's"
  (define-values (ours our-errors)
    (session '("-I" "mechanics") "(define L 3)" "(help iota)" "L"))
  (check-equal? (take ours 1) '("(iota n [start] [step])  → list"))
  (check-equal? our-errors "")
  (define-values (theirs their-errors)
    (session '("-i") "(require mechanics)" "(help iota)"))
  (check-equal? (take theirs 1) '("(iota n [start] [step])  → list")))

(test-case "of the reader's own definition it tells how that is called, and what it hides"
  (define-values (output errors)
    (session '("-I" "mechanics") "(define ((L-z m) s) (* m s))" "(define mass 3)" "(help L-z)"
             "(help mass)" "(define (cube x) 0)" "(help cube)"))
  (check-equal? (take output 5)
                '("L-z is your own definition; it is called as ((L-z m) s)"
                  "mass is your own definition."
                  "cube is your own definition; it is called as (cube x)"
                  "What it hides:" "(cube x)  → value")))
