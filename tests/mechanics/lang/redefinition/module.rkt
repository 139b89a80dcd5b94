#lang racket/base
;; A `#lang mechanics` module is read like a session: what is defined again, what
;; is imported and defined, what is used too early.

(require racket/file
         racket/match
         racket/port
         rackunit
         "../run.rkt")

(define language "#lang mechanics")

(define (prints . text) (apply run-module language text))
(define (refusal . text) (apply syntax-message language text))

;; The message of the exception that ends a module's run, and what it printed.
(define (failure . text)
  (define port (open-output-string))
  (define message
    (with-handlers ([exn:fail? exn-message])
      (parameterize ([current-output-port port])
        (instantiate (declare (apply lines language text))))
      "no error"))
  (list (get-output-string port) message))

;; ---------------------------------------------------------------------------
;; Defined again

(test-case "functions defined before see the new definition"
  (check-equal? (prints "(define (f x) (* 2 (g x)))"
                        "(define (g x) (+ x 1))"
                        "(f 1)"
                        "(define (g x) (* x 100))"
                        "(f 1)"
                        "(define g square)"
                        "(f 5)")
                (lines "4" "200" "50")))

(test-case "a new definition may use the value before it"
  (check-equal? (prints "(define x 1)" "(define x (+ x 1))" "x" "(define x (list x x))" "x")
                (lines "2" "'(2 2)")))

(test-case "a new definition may take other arguments, and bears the name"
  (check-equal? (prints "(define (f x) x)"
                        "(define (f x y) (list x y))"
                        "(f 1 2)"
                        "f"
                        "(define ((f m) (up t q v)) (* m v))"
                        "((f 'm) (up 't 'x 'v))"
                        "(f 'm)"
                        "(define f (let ([n 0]) (lambda () n)))"
                        "f")
                (lines "'(1 2)" "f" "(* m v)" "f" "f"))
  (check-equal? (failure "(define (f x) x)" "(define (f x y) x)" "(f 1)")
                (list "" (string-append
                          "f: arity mismatch;\n the expected number of arguments does not match"
                          " the given number\n  expected: 2\n  given: 1"))))

(test-case "functions that call each other may be replaced one at a time"
  (check-equal? (prints "(define (even-steps n) (if (= n 0) 'even (odd-steps (- n 1))))"
                        "(define (odd-steps n) (if (= n 0) 'odd (even-steps (- n 1))))"
                        "(even-steps 5)"
                        "(define (odd-steps n) (list 'stopped-at n))"
                        "(even-steps 5)")
                (lines "odd" "'(stopped-at 4)")))

(test-case "keyword arguments and patterns may be defined again"
  (check-equal? (prints "(define (f #:a a) a)"
                        "(f #:a 1)"
                        "(define (f #:b [b 2] (up c d)) (list b c d))"
                        "(f #:b 1 (up 3 4))"
                        "(f (up 3 4))"
                        "(define ((f #:c c) x) (list c x))"
                        "((f #:c 1) 2)")
                (lines "1" "'(1 3 4)" "'(2 3 4)" "'(1 2)")))

(test-case "several values may be defined again, some of them new"
  (check-equal? (prints "(define-values (p q) (values 1 2))"
                        "(define-values (q r) (values 3 4))"
                        "(list p q r)"
                        "(define-values (r q) (values q r))"
                        "(match-define (list p s) (list (list p q r) 5))"
                        "(list p q r s)")
                (lines "'(1 3 4)" "'((1 4 3) 4 3 5)")))

(test-case "definitions inside begin, and those that macros make, are definitions"
  (check-equal? (prints "(define-syntax-rule (def x e) (define x e))"
                        "(def a 1)"
                        "a"
                        "(begin (def a 2) a (begin (define a 3)))"
                        "a"
                        "(begin)")
                (lines "1" "2" "3")))

(test-case "names that a macro makes are its own"
  (check-equal? (prints "(define-syntax-rule (show e) (begin (define t e) t))"
                        "(define t 5)"
                        "(show 1)"
                        "(show 2)"
                        "t")
                (lines "1" "2" "5")))

(test-case "what is assigned, bound locally or quoted is not mixed up with it"
  (check-equal? (prints "(define x 1)"
                        "(define (next!) (set! x (+ x 1)) x)"
                        "(next!)"
                        "(define x 10)"
                        "(next!)"
                        "((lambda (x) x) 'local)"
                        "(let () (define x 'inner) (define y x) y)"
                        "'x")
                (lines "2" "11" "local" "inner" "x")))

(test-case "other modules and submodules see the last definition"
  (check-equal? (run-submodule 'inner language
                               "(provide (all-defined-out))"
                               "(define x (square 1))"
                               "(module* inner racket/base"
                               "  (require (submod \"..\"))"
                               "  (writeln (list x (f) (square 1) (g #:b 3))))"
                               "(define (f) x)"
                               "(define x 2)"
                               "(define (square x) 'mine)"
                               "(define (g #:a a) a)"
                               "(define (g #:b b) b)")
                (lines "(2 2 mine 3)"))
  (check-equal? (run-submodule 'test language
                               "(define x 1)"
                               "(module+ test x)"
                               "(define x 2)"
                               "(module+ test (define y x) y (define y 3) y)")
                (lines "2" "2" "3")))

(test-case "macros see the last definition, code for-syntax is apart"
  (check-equal? (prints "(require (for-syntax racket/base))"
                        "(define-syntax (value stx) #'(list x))"
                        "(define-for-syntax x 'other)"
                        "(define x 1)"
                        "(value)"
                        "(define x 2)"
                        "(value)"
                        "(define-syntax (other stx) #`'#,x)"
                        "(other)")
                (lines "'(1)" "'(2)" "other")))

(test-case "a structure's functions may be replaced, a structure or a macro may not"
  (check-equal? (prints "(struct point (x y))"
                        "(define (point-x p) 'mine)"
                        "(point-x (point 1 2))"
                        "(point-y (point 1 2))")
                (lines "mine" "2"))
  (define (message place name)
    (string-append
     "example:" place ": " name ": already defined, on line 2; in a module only variables"
     " and functions may be defined again, not macros or structure types\n  in: " name))
  (check-equal? (refusal "(struct point (x y))" "(struct point (x y z))")
                (message "3:8" "point"))
  (check-equal? (refusal "(struct point (x y))" "(define (point x y) x)")
                (message "3:9" "point"))
  (check-equal? (refusal "(define-syntax-rule (twice x) (+ x x))" "(define (twice x) x)")
                (message "3:9" "twice"))
  (check-equal? (refusal "(define (twice x) x)" "(define-syntax-rule (twice x) (+ x x))")
                (message "3:21" "twice"))
  (check-equal? (refusal "(define-syntax-rule (twice x) x)" "(define-syntax-rule (twice x) (+ x x))")
                (message "3:21" "twice")))

(test-case "a definition that is wrong is refused as ever, the second time too"
  (check-equal? (refusal "(define f 1)" "(define (f x))")
                "example:3:0: define: no expressions for procedure body\n  in: (define (f x))")
  (check-regexp-match #rx"^example:3:0: define: bad syntax" (refusal "(define f 1)" "(define f)"))
  (check-regexp-match #rx"^example:3:11: define: \\(x y z\\) is no argument"
                      (refusal "(define f 1)" "(define (f (x y z)) x)")))

;; ---------------------------------------------------------------------------
;; What stays as it is

;; How often the core forms `define-values` and `set!` of a name stand in the
;; expansion of a module: (list definitions assignments).
(define (expanded name . text)
  (define module-text (apply lines language text))
  (define expansion
    (parameterize ([current-namespace (namespace)]
                   [read-accept-reader #t]
                   [read-accept-lang #t])
      (syntax->datum (expand (read-syntax 'example (open-input-string module-text))))))
  (define (count head)
    (let count ([form expansion])
      (match form
        [(list (== head) (or (== name) (list _ ... (== name) _ ...)) _) 1]
        [(? list?) (apply + (map count form))]
        [_ 0])))
  (list (count 'define-values) (count 'set!)))

(test-case "only what is defined again, or replaced after it was used, is assigned"
  (define once '(1 0))
  (define (assigned n) (list 1 n))
  (define (check expected name . text)
    (check-equal? (apply expanded name text) expected (format "~a in ~s" name text)))
  (check once 'f "(define (f) (g))" "(define (g) (f))")
  (check once 'g "(define (f) (g))" "(define (g) (f))" "(define (f) 1)")
  (check (assigned 1) 'f "(define (f) (g))" "(define (g) (f))" "(define (f) 1)")
  (check (assigned 2) 'x "(define x 1)" "(define x 2)" "(define x 3)")
  (check once 'square "(define (f) (square 1))" "(define (square x) x)" "(f)")
  (check once 'square "'square" "(define (square x) (square x))")
  (check (assigned 1) 'square "(define (f) (square 1))" "(f)" "(define (square x) x)")
  (for ([use '("(define (f square) (square 1)) (f list)"
               "(define ((f a) (up b square) [c square]) (square 1)) (f 2)"
               "(define ((f square) a) (square 1)) ((f list) 1)"
               "((lambda square square) 1)"
               "(let* ([square 1] [cube square] [(up a b) (up square 2)]) cube)"
               "(let square ([n 2]) (if (= n 0) 'end (square (- n 1))))"
               "(define (f) (define (square) 1) (define cube square) (cube)) (f)"
               "(define (f) (square 1))"
               "(define (f) (g)) (define (g) (square 1)) '(f)"
               "(struct point (square))")])
    (check once 'square use "(define (square x) x)"))
  (for ([use '("(define (f [a (square 1)] [square 2]) a) (f)"
               "(define (f) (g)) (define (g) (square 1)) (define y (f))"
               "(let ([square (square 1)]) square)"
               "(define f (list square))"
               "(define-syntax-rule (f) (square 1)) (f)"
               "(begin (define (f) (square 1)) (f))"
               "((lambda (f) (f 1)) square)")])
    (check (assigned 1) 'square use "(define (square x) x)"))
  (check once 'first "(require racket/list)" "(define (first x) x)" "(first 1)")
  (check (assigned 1) 'first "(require racket/list)" "(first '(1))" "(define (first x) x)"))

;; ---------------------------------------------------------------------------
;; Imported and defined

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

(test-case "what is required after a definition replaces it"
  (check-equal? (prints "(define (first x) 'mine)"
                        "(define (f) (first '(1 2)))"
                        "(f)"
                        "(require racket/list)"
                        "(f)")
                (lines "mine" "1")))

(test-case "a macro of the language or of a library may give way to a function"
  (check-equal? (prints "(match 1 [x (list x)])" "(define (match x) 'mine)" "(match 2)")
                (lines "'(1)" "mine"))
  (check-equal? (prints "(require racket/list)" "(define (struct-of x) x)" "(define range 3)" "range")
                (lines "3")))

(test-case "a submodule may define what the module around it does"
  (check-equal? (run-submodule 'test language
                               "(define (f) 'outer)"
                               "(module+ test (f) (define (f) 'inner) (f) (square 2)"
                               "  (define (square x) 'inner) (square 2))"
                               "(define (g) (list (f) (square 3)))"
                               "(g)")
                (lines "'(outer 9)" "outer" "inner" "4" "inner")))

;; ---------------------------------------------------------------------------
;; Used too early

(define (early name line)
  (format "~a: used before its definition, which is on line ~a; a module is run from top to bottom"
          name line))

(test-case "a name that is used before its definition is told from where it is defined"
  (check-equal? (failure "'before" "(list x)" "(define x 1)")
                (list (lines "before") (early 'x 4)))
  (check-equal? (failure "(define y (+ x 1))" "(define x 1)")
                (list "" (early 'x 3)))
  (check-equal? (failure "(define x (+ x 1))") (list "" (early 'x 2))))

(test-case "so is one that a function uses which is called too early"
  (check-equal? (failure "(define (f) (h))" "(define (h) (g 1))" "(f)" "(define (g x) x)")
                (list "" (early 'g 5)))
  (check-equal? (failure "(define (f) (g 1))" "(define y (f))" "(define (g x) x)")
                (list "" (early 'g 4))))

(test-case "a program may notice that a name has no value yet"
  (check-equal? (prints "(define (f) (g))"
                        "(with-handlers ([exn:fail:contract:variable? exn:fail:contract:variable-id]) (f))"
                        "(define (g) 1)"
                        "(f)")
                (lines "g" "1")))

;; ---------------------------------------------------------------------------
;; Compiled modules, and prompts inside modules

(define (call-with-program text proc)
  (define directory (make-temporary-file "mechanics~a" 'directory))
  (define file (build-path directory "program.rkt"))
  (display-to-file text file)
  (dynamic-wind
   void
   (lambda () (proc (path->string file)))
   (lambda () (delete-directory/files directory))))

(define program
  (lines language
         "(define (f x) (g x))"
         "(define (g x) (square x))"
         "(f 'a)"
         "(define (square x) (list 'mine x))"
         "(f 'b)"
         "(define (g x) (list 'new x))"))

(test-case "a prompt inside a module defines its names again"
  (call-with-program program
    (lambda (file)
      (define-values (output errors)
        (session '("-i" "-l" "racket/base" "-l" "racket/enter")
                 (format "(enter! (file ~s))" file)
                 "(f 'c)"
                 "(define (g x) (list 'newer x))"
                 "(f 'd)"
                 "(define (f x y) (list x y (square x)))"
                 "(f 1 2)"
                 "(define (square x) (* x x))"
                 "(f 3 4)"))
      (check-equal? (map (lambda (line) (regexp-replace #rx"^(\"[^\"]*\"> )*" line "")) output)
                    '("(expt a 2)" "'(mine b)" "'(new c)" "'(newer d)"
                      "'(1 2 (mine 1))" "'(3 4 9)"))
      (check-equal? errors ""))))

(test-case "where it cannot, for the module is compiled as it is, it says what to do"
  (call-with-program (lines language "(define (f) 1)")
    (lambda (file)
      (define-values (output errors)
        (session '("-I" "mechanics")
                 (format "(require (file ~s))" file)
                 (format "(current-namespace (module->namespace '(file ~s)))" file)
                 "(define (f) 2)"))
      (check-regexp-match
       #rx"cannot re-define a constant\n.*the module was compiled with f as it is: change it there"
       errors))))

(test-case "a module that is compiled to a file runs as it does from its text"
  (call-with-program program
    (lambda (file)
      (define (output)
        (with-output-to-string
          (lambda ()
            (parameterize ([current-namespace (make-base-namespace)])
              (dynamic-require (string->path file) #f)))))
      (define from-text (output))
      (check-equal? from-text (lines "(expt a 2)" "'(mine b)"))
      (parameterize ([current-namespace (make-base-namespace)])
        ((dynamic-require 'compiler/cm 'managed-compile-zo) file))
      (check-equal? (output) from-text))))
