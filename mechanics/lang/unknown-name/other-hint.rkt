#lang racket/base
;; Hints beneath messages of Racket's own procedures and forms.

(provide hint-for-syntax hint-for-value hint-for-module)

;; pattern of the message, hint
(define for-syntax-errors
  `((#rx"unquote: not in quasiquote"
     "no comma separates arguments, and a decimal has a point: (up 1 2.5)")
    (#rx"missing procedure expression" "f() is written (f); the empty list is '()")
    (#rx"(^|: )let: bad syntax" "it is written (let ([m 3]) (* 2 m))")
    (#rx"(^|: )let[*]: bad syntax" "it is written (let* ([m 3] [k (* 2 m)]) (+ m k))")
    (#rx"(^|: )if: " ,(string-append "it is written (if (> x 0) x (- x)), with a value for either "
                                     "case; for one, (when (> x 0) x)"))
    (#rx"(^|: )cond: bad" "it is written (cond [(> x 0) x] [else (- x)])")
    (#rx"#%app: bad syntax\n[^\n]* [.] " "no dot stands between the parts of a call: (square 2)")
    (#rx"require: bad module-path string"
     "a file by its full path is (require (file \"/home/me/system.rkt\"))")
    (#rx"==: this match expander" "equality is (= a b)")
    (#rx"the last form is not an expression" "a definition has no value; an expression comes last")
    (#rx"(^|: )for[/a-z*]*: bad " "it is written (for/list ([i 10]) (* i i))")
    (#rx"identifier already defined"
     "a module of Racket defines a name once; in #lang mechanics it may be defined again")
    (#rx"identifier already required"
     "two libraries have the name; one is left out by (require (except-in library name))")
    (#rx"bad require spec" "as in (require mechanics/plot)")))

;; A number was expected, and one made of exact numbers and roots was given.
(define exact-root-given
  (pregexp
   (string-append "contract violation\n  expected: [^\n]*(?:number|real|rational|flonum)[?][^\n]*\n"
                  "  given: (?=[^\n]*(?:sqrt|expt) )(?:sqrt|expt|[-+*/0-9 ()])+(?:\n|$)")))

(define for-values
  `((#rx"\n  (expected: (list|pair)[?][^\n]*\n  given|index: [^\n]*\n  in): [(](up|down) "
     "a tuple is no list: (ref s 0) is a component, (structure->list s) a list of them")
    (#px"^(?:sinh|cosh|tanh|sgn|conjugate): contract violation\n  expected: number[?]"
     "this one is Racket's, of numbers alone; (require (except-in racket/math ...)) leaves it out")
    (,exact-root-given "it is exact; (exact->inexact x) is its decimal")
    (#rx"^Gtk initialization failed"
     "curves are drawn without a window by (require mechanics/plot)")
    (#rx"^set!: assignment disallowed" "a definition is (define x 3)")))

;; Where a file was named, newer versions of Racket write the module path as #<path:...>.
(define for-modules
  '((#rx"cannot open module file\n  module path: ([^\n]*/)?mechanics(/[a-zA-Z-]*)?>?\n"
     "the libraries are mechanics, mechanics/plot, mechanics/book and mechanics/geometry")
    (#rx"cannot open module file\n.*system error: no such file"
     "there is no such file; its place is told from that of the file that requires it")))

(define ((hint-from table) message)
  (for/or ([entry (in-list table)])
    (and (regexp-match? (car entry) message) (string-append "\n  " (cadr entry)))))

(define hint-for-syntax (hint-from for-syntax-errors))
(define hint-for-value (hint-from for-values))
(define hint-for-module (hint-from for-modules))
