#lang racket/base
;; Results at the prompt and in `#lang mechanics` modules: simplified, bare,
;; on lines that fit; definitions at the prompt; modules among Racket's.

(require (only-in mechanics/generic/kind make-kind prop:kind rank:scalar)
         mechanics/lang/printer
         (only-in mechanics/lang/unknown-name/unknown-names install-hints!)
         racket/port
         racket/string
         "../support/checks.rkt" "../support/run-text.rkt")

;; ---------------------------------------------------------------------------
;; Modules

(test-case "a module prints its results simplified, symbols bare"
  (check-equal? (run-module "#lang mechanics"
                            "'a"
                            "(+ 'a 'a)"
                            "(up (- 'a 'a) (* 'x 'x))")
                (lines "a" "(* 2 a)" "(up 0 (expt x 2))")))

(test-case "a module may state Lagrange's equations as the book does"
  (check-equal?
   (run-module "#lang mechanics"
               "(define ((L-harmonic m k) (up t q v))"
               "  (- (* 1/2 m (square v)) (* 1/2 k (square q))))"
               "(((Lagrange-equations (L-harmonic 'm 'k)) (literal-function 'x)) 't)")
   (lines "(+ (* k (x t)) (* m (((expt D 2) x) t)))")))

(test-case "what is no mathematics prints as Racket prints it"
  (check-equal? (run-module "#lang mechanics"
                            (string-append "\"text\" #t 3.5 1/2 #\\a '(a \"b\") (void) (list 1 "
                                           "2) '#:k (vector 1 2)"))
                (lines "\"text\"" "#t" "3.5" "1/2" "#\\a" "'(a \"b\")"
                       "'(1 2)" "'#:k" "'#(1 2)")))

(test-case "the elements of a list are simplified"
  (check-equal? (run-module "#lang mechanics" "(list (+ 'a 'a) \"b\" (up (* 'x 'x)))")
                (lines "(list (* 2 a) \"b\" (up (expt x 2)))")))

(test-case "functions among the elements of a list print by name, in inner lists too"
  (check-equal? (run-module "#lang mechanics"
                            "(define ((L m) local) local)"
                            "(list sin (L 1) D (lambda (x) x) 'a)"
                            "(list (list (+ 'a 'a) square) (vector L \"b\") '(1))")
                (lines "(list sin L D <function> 'a)"
                       "(list (list (* 2 a) square) (vector L \"b\") '(1))")))

(test-case "what a simplification takes for granted stands beneath its result"
  (check-equal? (run-module "#lang mechanics"
                            "(up (sqrt (square 'r)) 1)"
                            "(verify-equal (sqrt (square 'r)) 'r)")
                (lines "(up r 1)" "; assuming (>= r 0)"
                       "proved: the residual is zero" "  assuming: (>= r 0)")))

(test-case "what a simplification left unexpanded is told beneath its result"
  (check-equal? (run-module "#lang mechanics"
                            "(define s (+ 'a 'b 'c 'd 'e 'f))"
                            "(* (expt s 60) (sqrt (square 'r)))"
                            "(verify-equal (expt s 60) (expt s 61))")
                (lines "(* r (expt (+ a b c d e f) 60))"
                       "; assuming (>= r 0)"
                       "; left unexpanded: (expt (+ a b c d e f) 60)"
                       "refuted: the residual is not zero"
                       "  residual: (- (expt (+ a b c d e f) 60) (expt (+ a b c d e f) 61))"
                       "  left unexpanded: (expt (+ a b c d e f) 60)"
                       "  at: a = 1, b = 2, c = 2, d = 1, e = 2, f = 2"
                       "  value: -9e+60")))

(test-case "functions and operators print by name"
  (check-equal? (run-module "#lang mechanics"
                            "(define (kinetic-energy v) v)"
                            "(define ((L m) local) local)"
                            "kinetic-energy (L 1) sin D (expt D 2) (D kinetic-energy)"
                            "(literal-function 'x)")
                (lines "kinetic-energy" "L" "sin" "D" "(expt D 2)" "(D kinetic-energy)" "x")))

(test-case "several values print one below the other, no value prints nothing"
  (check-equal? (run-module "#lang mechanics" "(values 'a (+ 'a 'a))" "(values)" "(void)")
                (lines "a" "(* 2 a)")))

(test-case "a long result is broken over lines of at most 79 columns"
  (define output
    (run-module "#lang mechanics"
                "(up (+ (* 'alpha 'beta) (sin (* 'omega 't)) (cos 'phi))"
                "    (+ (* 'gamma 'delta) (sin (* 'Omega 't)) (cos 'psi)))"))
  (define printed (string-split output "\n"))
  (check-equal? (length printed) 2)
  (for ([l printed]) (check-true (<= (string-length l) 79)))
  (check-regexp-match #rx"^\\(up \\(" (car printed))
  (check-regexp-match #rx"^    \\(" (cadr printed)))

(test-case "a result goes through the printer of whoever runs the module"
  (define name (declare "#lang mechanics\n(+ 'a 'a)\n\"text\"\n"))
  (define seen '())
  (parameterize ([current-print (lambda (v) (set! seen (cons (format "~a" v) seen)))])
    (instantiate name))
  (check-equal? (reverse seen) '("(* 2 a)" "text")))

(test-case "definitions, submodules and macros are as in Racket"
  (check-equal? (run-module "#lang mechanics"
                            "(require racket/list)"
                            "(define-syntax-rule (define-and-show x e) (begin (define x e) x))"
                            "(define-and-show a (first '(1 2)))"
                            "(struct point (x y))"
                            "(point-x (point 'u 'v))"
                            "(module+ main (displayln \"not run\"))"
                            "(match (up 1 2) [(up x y) (list y x)])")
                (lines "1" "u" "'(2 1)")))

(test-case "a program run from the module has our session, unless it brings its own"
  (define (configuration . text)
    (define name (declare (apply lines text)))
    (parameterize ([current-namespace (namespace)])
      (module-declared? `(submod ',name configure-runtime) #f)))
  (check-true (configuration "#lang mechanics" "1"))
  (check-equal? (run-module "#lang mechanics"
                            "(module configure-runtime racket/base)"
                            "1")
                (lines "1")))

(test-case "(require mechanics) goes with racket/base and with racket"
  (for ([language '("racket/base" "racket")])
    (check-equal? (run-module (string-append "#lang " language)
                              "(require mechanics)"
                              "(define ((f m) (up t q)) (* m q (sin t)))"
                              "((f 'm) (up 0 'x))"
                              "(match (up 1 2) [(up a b) (+ a b)])"
                              "(displayln (up 'a (+ 'b 'c)))")
                  (lines "0" "3" "(up a (+ b c))"))))

;; ---------------------------------------------------------------------------
;; Names without a definition

(test-case "an unbound name in a module is located and told from a symbol"
  (check-equal?
   (syntax-message "#lang mechanics" "(define ((L m) (up t q v)) (* m v))" "(L m)")
   "example:3:3: m: unbound identifier; as a symbol it is written 'm\n  in: m")
  (check-exn exn:fail:syntax:unbound?
             (lambda () (declare (lines "#lang mechanics" "(define (f) (+ y 1))")))))

(test-case "an unbound name that is nearly spelt as one that is known is told from it"
  (check-equal?
   (syntax-message "#lang mechanics" "(Lagrange-equation 'L)")
   (string-append "example:2:1: Lagrange-equation: unbound identifier; "
                  "did you mean Lagrange-equations? as a symbol it is written "
                  "'Lagrange-equation\n  in: Lagrange-equation"))
  (check-regexp-match
   #rx"did you mean kinetic-energy[?]"
   (syntax-message "#lang mechanics" "(define (kinetic-energy v) v)" "(kinetic-enrgy 'v)")))

(test-case "an unbound name that another library of the package defines is told from a symbol"
  (check-equal?
   (syntax-message "#lang mechanics" "(define f (frame 0 1 0 1))")
   (string-append "example:2:11: frame: unbound identifier; (require mechanics/plot) defines it; "
                  "as a symbol it is written 'frame\n  in: frame"))
  (check-regexp-match #rx"[(]require mechanics/book[)] defines it; "
                      (syntax-message "#lang mechanics" "(LR3B 1 2 3 4)"))
  ;; the operator before its arguments, which nothing defines either
  (check-regexp-match #rx"^example:2:1: define-coordinates: .*[(]require mechanics/geometry[)]"
                      (syntax-message "#lang mechanics" "(define-coordinates (up x y) R2-rect)")))

(test-case "names may be defined further down, in modules, submodules and bodies"
  (check-equal? (run-module "#lang mechanics"
                            "(define (f) (g y))"
                            "(define (g z) (define (a) b) (define b z) (a))"
                            "(define-syntax-rule (m) (list y))"
                            "(define y 3)"
                            "(f)"
                            "(m)"
                            "(module* inner #f (h) (define (h) (k y)) (define k values))")
                (lines "3" "'(3)")))

(test-case "eval in a module's namespace finds what is defined later"
  (check-equal? (run-module "#lang mechanics"
                            "(define-namespace-anchor here)"
                            "(define n (namespace-anchor->namespace here))"
                            "(eval '(define (p) q) n)"
                            "(eval '(define q 7) n)"
                            "(eval '(p) n)")
                (lines "7")))

;; ---------------------------------------------------------------------------
;; The prompt

;; One prompt for what disturbs nothing that follows.
(define ask (open-prompt "-I" "mechanics"))

(define (answers . input)
  (define-values (output errors) (apply ask input))
  output)

(test-case "racket -I mechanics simplifies, defines and redefines"
  (check-equal? (answers "(define x 3)"
                         "x"
                         "(define x 4)"
                         "x"
                         "'a"
                         "(+ 'a 'a)"
                         "((D (literal-function 'f)) 't)"
                         "(define ((L m) (up t q v)) (* m v))"
                         "((L 'm) (up 't 'x 'v))"
                         "D"
                         "L"
                         "(values 1 'b)"
                         "\"text\""
                         "(void)")
                '("3" "4" "a" "(* 2 a)" "((D f) t)" "(* m v)" "D" "L" "1" "b" "\"text\"")))

(test-case "the prompt accepts require, begin, structs and macros"
  (check-equal? (answers "(require racket/list)"
                         "(first '(1 2))"
                         "(begin (define p 'q) (list p))"
                         "(struct point (x y))"
                         "(point-y (point 1 'v))"
                         "(define-syntax-rule (twice e) (list e e))"
                         "(twice 1)")
                '("1" "'(q)" "v" "'(1 1)")))

(test-case "the printer comes with the first form where nothing was configured"
  (define-values (output errors)
    (session '("-i" "-l" "racket/base" "-l" "mechanics") "(+ 'a 'a)" "'b"))
  (check-equal? output '("(* 2 a)" "b")))

(test-case "an error leaves the prompt usable and speaks our language"
  (define-values (output errors)
    (ask "(define (f (up a b)) a)"
         "(f 3)"
         "('x 't)"
         "(f (up 'u 1))"))
  (check-equal? output '("u"))
  (check-regexp-match #rx"f: the argument does not match the pattern \\(up a b\\)" errors)
  (check-regexp-match #rx"the symbol x is a number here, not a function" errors))

(test-case "an unbound name at the prompt is told from a symbol; it may be defined later"
  (for ([ask (list ask (open-prompt "-i" "-l" "racket/base" "-l" "mechanics"))])
    (define-values (output errors)
      (ask "(define ((L m) (up t q v)) (* m v))"
           "(L m)"
           "(define (f) (g 1))"
           "(define (g x) x)"
           "(f)"))
    (check-equal? output '("1"))
    (check-regexp-match #rx"m: undefined;.*top-level\n.*  as a symbol it is written 'm\n" errors)
    (check-false (regexp-match? #rx"'g" errors))))

(test-case "an unknown name at the prompt that is nearly spelt as a known one"
  (define-values (output errors)
    (ask "(determinent 'M)"
         "(define (kinetic-energy v) v)"
         "(kinetic-enrgy 'v)"))
  (check-equal? output '())
  (check-regexp-match
   #rx"did you mean determinant[?]\n.*as a symbol it is written 'determinent" errors)
  (check-regexp-match #rx"did you mean kinetic-energy[?]" errors))

(test-case "an unknown name at the prompt that another library of the package defines"
  (define-values (output errors)
    (ask "(plot-function 1)"
         "(L-central-polar 'm 'U)"
         "(require mechanics/book)"
         "((L-free-particle 'm) (up 't 'x 'v))"))
  (check-equal? output '("(* 1/2 m (expt v 2))"))
  (check-regexp-match #rx"top-level\n.*[(]require mechanics/plot[)] defines it\n.*'plot-function\n"
                      errors)
  (check-regexp-match #rx"[(]require mechanics/book[)] defines it\n" errors))

(test-case "a keyword at the prompt, or a number of arguments, that the procedure does not take"
  (define-values (output errors)
    (ask "(define (swing #:amplitude [a 1] #:phase [p 0]) a)"
         "(swing #:amplitud 3)"
         "(swing #:mass 3)"
         "(define (fall height [speed 0] #:drag [drag 0]) height)"
         "(fall)"
         "(fall #:drag 1)"
         "(swing #:phase 3)"))
  (check-equal? output '("1"))
  (check-regexp-match #rx"given keyword: #:amplitud\n.*did you mean #:amplitude[?]\n" errors)
  (define fall
    (lines "fall: takes 1 or 2 arguments; it was given none"
           "  it is called as (fall height [speed 0] [#:drag drag])"
           "  missing: height"))
  (check-regexp-match (regexp-quote (string-append fall fall)) errors)
  (check-regexp-match #rx"given keyword: #:mass\n.*its keywords: [(]#:amplitude #:phase[)]\n"
                      errors))

(test-case "a function that is undefined is noticed before its arguments are evaluated"
  (define-values (output errors)
    (ask "(undefined-f (displayln 1))"
         "(define (f x) (undefined-g (displayln x)))"
         "(f 2)"
         "(define (undefined-g y) 'done)"
         "(undefined-g (displayln 3))"
         "(f 4)"))
  (check-equal? output '("3" "done" "4" "done"))
  (check-regexp-match #rx"undefined-f: undefined;.*undefined-g: undefined;" errors))

(test-case "a name of a module that is used too early is told from no symbol"
  (define e (exn:fail:contract:variable
             (string-append "x: undefined;\n cannot reference an identifier before its "
                            "definition\n  in module: \"a.rkt\"")
             (current-continuation-marks) 'x))
  (define shown '())
  (parameterize ([error-display-handler (lambda (message e) (set! shown (list message e)))])
    (install-hints!)
    ((error-display-handler) (exn-message e) e))
  (check-equal? shown (list (exn-message e) e)))

;; ---------------------------------------------------------------------------
;; Simplification that fails

;; A value that prints as `name`, and does this when it is simplified.
(struct troublesome (name act)
  #:property prop:kind
  (make-kind #:rank rank:scalar
             #:describe (lambda (x) "a troublesome value")
             #:datum (lambda (x) (troublesome-name x))
             #:map (lambda (f x) ((troublesome-act x)))))

;; The text of the prompt's printer, to output and to the error port.
(define (prompt-prints x)
  (define out (open-output-string))
  (define err (open-output-string))
  (parameterize ([current-print (current-print)]
                 [current-output-port out]
                 [current-error-port err])
    (install-printer!)
    ((current-print) x))
  (list (get-output-string out) (get-output-string err)))

(test-case "where simplification raises, the value is printed as it is, and why"
  (define x (troublesome 'stubborn (lambda () (raise-user-error 'simplify "gave up"))))
  (check-equal? (prompt-prints x)
                '("stubborn\n" "; the result could not be simplified (simplify: gave up)\n")))

(test-case "a break during simplification prints the value as it is"
  (define x (troublesome 'slow (lambda () (break-thread (current-thread)) (sleep 30) 'done)))
  (check-equal? (prompt-prints x)
                '("slow\n" "; interrupted; the result as computed:\n")))

(test-case "a break while a module's result is simplified stops the module"
  (define x (troublesome 'slow (lambda () (break-thread (current-thread)) (sleep 30) 'done)))
  (check-exn exn:break? (lambda () (with-output-to-string (lambda () (print-result x))))))

(test-case "a text of several lines says once how they are seen"
  (define-values (output errors)
    (ask "(->text (/ 'a 'b))" "\"a\\nb\"" "\"plain\\n\""))
  (check-equal? errors "; a text of several lines: (display ...) shows them as lines\n"))

(test-case "equal? of what = could find equal says so, once, where it says no"
  (define-values (output errors)
    (ask "(equal? 'a 'b)" "(equal? (* 2 'x) (* 2 'x))"
         "(equal? (* 2 'a 'b) (+ (* 'a 'b) (* 'a 'b)))" "(equal? (up 1 'a) (up 1 (+ 'a 1)))"
         "(define (equal? a b) 'mine)" "(equal? (* 2 'x) 'x)"))
  (check-equal? output '("#f" "#t" "#f" "#f" "mine"))
  (check-equal? (car (string-split errors "\n"))
                "; equal? compares how values are made; (= a b) asks whether they are equal")
  (check-equal? (length (string-split errors "\n")) 2))

(test-case "installing the printer again changes nothing"
  (parameterize ([current-print (current-print)])
    (install-printer!)
    (define printer (current-print))
    (install-printer!)
    (check-eq? (current-print) printer)))
