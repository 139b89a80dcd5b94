#lang racket/base
;; Messages of export-system on systems it cannot export; it leaves nothing behind.

(require racket/file
         (only-in racket/path simple-form-path)
         racket/string
         mechanics mechanics/book
         tests/mechanics/support/messages tests/mechanics/support/skip
         "../../support/checks.rkt")

(define free (Lagrangian->state-derivative (L-pendulum 'g 'm 'l)))
(define state (up 't 'theta 'thetadot))

(says
 [(export-system 3 state)
  "export-system: expected a state derivative, a function of one state\n  given: the number 3"]
 [(export-system free state #:language 'Fortran)
  "export-system: there is no such target\n  targets: 'C, 'python, 'JAX\n  given: Fortran"]
 [(export-system free state #:name "my pendulum")
  "export-system: expected a name of letters, digits and _ that is no word of C or Python, for"
  " files and functions\n  given: \"my pendulum\""]
 [(export-system free state #:name "import")
  "export-system: expected a name of letters, digits and _ that is no word of C or Python, for"
  " files and functions\n  given: \"import\""]
 [(export-system free state #:parameters '(g m l g))
  "export-system: a parameter is there twice\n  parameter: g"]
 [(export-system (L-pendulum 'g 'm 'l) state)
  "export-system: the state derivative is of another shape than the state\n"
  "  state: (up t theta thetadot)\n"
  "  derivative: (+ (* 1/2 m l thetadot l thetadot) (* m g l (cos theta)))\n"
  "  (Lagrangian->state-derivative L) makes a state derivative of a Lagrangian"]
 [(export-system free (up 't 'theta 'm))
  "export-system: the symbol m is a parameter of the state derivative, and names a variable of"
  " the state, too\n  give one of them another name"]
 [(export-system free (up 't 'theta 'theta))
  "export-system: two variables of the state have one name\n  name: theta\n"
  "  given: (up t theta theta)"]
 [(export-system free state #:parameters '(m g))
  "export-system: the state derivative holds a symbol that is not among the parameters\n"
  "  symbol: l\n  parameters: (m g)"]
 [(export-system free state #:parameters 'm)
  "export-system: expected the parameters as a list of symbols, such as '(m l g)\n  given: m"]
 [(export-system (lambda (s) (up 1 (if (> (ref s 1) 0) 1 -1))) (up 't 'x))
  "export-system: this state derivative has no code in other languages\n  of: <function>\n"
  "  reason: it takes a decision by `>`"]
 [(export-system (lambda (s) (up 1 ((literal-function 'f) (ref s 1)))) (up 't 'x))
  "export-system: (f x), a number-like expression is left in the function's value, but has no numeric value\n"
  "  a literal function stands for any function; put a definite one in its place"]
 [(export-system free '(t theta thetadot))
  "export-system: the example is a state, a tuple such as (up 't 'q 'v)\n"
  "  given: (t theta thetadot), a list\n  a list is not a tuple; use (up x y ...)"]
 [(export-system free 3)
  "export-system: the example is a state, a tuple such as (up 't 'q 'v)\n  given: the number 3"]
 [(export-system state free)
  "export-system: the state derivative comes first, then an example of a state\n"
  "  given first: (up t theta thetadot), an up tuple of 3"]
 [(export-system free state #:parameters '(g m l t))
  "export-system: the symbol t is a parameter of the state derivative, and names a variable of"
  " the state, too\n  give one of them another name"]
 [(export-system (lambda (s) (up 1 (* (random) (ref s 1)))) (up 't 'x))
  "export-system: this state derivative has no code in other languages\n  of: <function>\n"
  "  reason: it is another one each time it is called"]
 [(export-system (lambda (s) (up 1 2 3)) (up 't 'x))
  "export-system: the state derivative is of another shape than the state\n"
  "  state: (up t x)\n  derivative: (up 1 2 3)"])

;; Nobody makes folders in /proc, not even root.
(test-case "a folder that cannot be written is told by its name"
  (skip-unless (directory-exists? "/proc") "exports: there is no /proc"
    (check-exn #rx"export-system: the folder cannot be written\n  folder: /proc/it\n  reason: "
               (lambda () (export-system free state #:folder "/proc/it")))))

(define-syntax-rule (in-new-folder folder body ...)
  (let ([folder (make-temporary-file "export~a" 'directory)])
    (dynamic-wind void (lambda () body ...) (lambda () (delete-directory/files folder)))))

(test-case "a folder that is there is kept unless it is to be replaced; nothing is left beside"
  (in-new-folder folder
    (define to (build-path folder "it"))
    (define (export . more) (keyword-apply export-system '(#:folder) (list to) free state more))
    (export)
    (define before (directory-list to))
    (check-exn #rx"^export-system: the folder is there already.*#:replace[?] #t" export)
    (check-equal? (directory-list to) before)
    (export-system free state #:folder to #:replace? #t #:language 'JAX #:name "pendulum")
    (check-equal? (map path->string (directory-list to)) '(".exported" "pendulum.py"))
    ;; what is not of an export is never touched
    (define notes (build-path to "notes.txt"))
    (call-with-output-file notes (lambda (port) (write-string "mine" port)))
    (export-system free state #:folder to #:replace? #t #:name "other" #:language 'JAX)
    (check-equal? (map path->string (directory-list to)) '(".exported" "notes.txt" "other.py"))
    (delete-file (build-path to ".exported"))
    (check-exn #rx"^export-system: the folder holds something else than an exported system"
               (lambda () (export-system free state #:folder to #:replace? #t)))
    (check-equal? (file->string notes) "mine")
    (check-equal? (map path->string (directory-list to)) '("notes.txt" "other.py"))
    (check-exn #rx"no such folder"
               (lambda () (export-system free state #:folder (build-path folder "a" "b"))))
    (check-equal? (map path->string (directory-list folder)) '("it"))))

(test-case "the folder is called as system and language, unless another one is given"
  (in-new-folder folder
    (parameterize ([current-directory folder])
      (check-equal? (export-system free state #:language 'JAX #:name "pendulum")
                    (path->string (simple-form-path "pendulum-JAX")))
      (check-true (file-exists? (build-path "pendulum-JAX" "pendulum.py"))))))

(test-case "names that other languages cannot have, or have already, are changed"
  (in-new-folder folder
    (define to (build-path folder "it"))
    (define (rates s) (up 1 (* 'double (ref s 2)) (+ 'v7 (* 'λ-1 (ref s 1)) 'sin)))
    (export-system rates (up 't 'θ 'y) #:folder to #:derivatives? #t)
    (define text (file->string (build-path to "motion.c")))
    (for ([name '("double_" "v7_" "lambda_1" "sin_" "theta" "y_")])
      (check-regexp-match (string-append "const double " name " = ") text))))

(define (C-text folder rates example)
  (define to (build-path folder "it"))
  (export-system rates example #:folder to #:replace? #t)
  (file->string (build-path to "motion.c")))

(test-case "a suggested name that a parameter has is another one"
  (in-new-folder folder
    (define (L s) (- (* 1/2 (square (velocity s))) (* 't 'q (coordinate s))))
    (define text (C-text folder (Lagrangian->state-derivative L) (up 0 1 2)))
    (check-regexp-match #rx"variables: y.0. = t_, y.1. = q_, y.2. = v\n" text)
    (check-regexp-match #rx"parameters: p.0. = q, p.1. = t [*]/" text)))

(test-case "a name neither breaks the line of a comment nor ends it"
  (in-new-folder folder
    (define (rates s) (up 1 (* (string->symbol "k\n*/ x") (ref s 1))))
    (define text (C-text folder rates (up (string->symbol "a\nb") 'x)))
    (check-regexp-match #rx"y.0. = a b, y.1. = x\n   parameters: p.0. = k [*] / x [*]/\n" text)))

;; The body of its derivative, without the arrays' types
(define (JAX-text rates example)
  (in-new-folder folder
    (export-system rates example #:language 'JAX #:folder (build-path folder "it"))
    (define text (file->string (build-path folder "it" "motion.py")))
    (regexp-replace* #rx"jnp.asarray[(](.*?), jnp.float64[)]"
                     (cadr (regexp-match #rx"each variable changes.\"\"\"\n(.*?)\n\n" text))
                     "\\1")))

;; The names, numbers and signs between two commas, in any order; those of results are all "v".
(define (words text)
  (for/list ([part (in-list (string-split (regexp-replace* #px"\\bv[0-9]+\\b" text "v") ","))])
    (sort (regexp-match* #px"[\\w.]+|[-+*=]" part) string<?)))
(define-syntax-rule (check-words text expected) (check-equal? (words text) (words expected)))

(define (four s)
  (define x (ref s 1))
  (define m (matrix-by-rows (list (+ 4 x) x 1 0) (list x 5 0 1) (list x 1 3 x) (list 0 x x 6)))
  (define solved (solve-linear-left m (up x 5 6 7)))
  (up 1 (ref solved 2)))

(test-case "the rates as C has them: variables, parameters, systems, parentheses about sums"
  (in-new-folder folder
    (define (rates s) (up 1 (* 3 'k (ref s 2)) (* (+ (ref s 1) 'a) (ref s 2) (sin (ref s 2)))))
    (define text (C-text folder rates (up 't 'x 'y)))
    (for ([line '("double x = y[1];" "double y_ = y[2];" "double a = p[0];" "double k = p[1];"
                  "dy[0] = 1.0;")])
      (check-true (string-contains? text line) line))
    (check-false (regexp-match #px"[-=*+(] *[(][\\w.]+[)]" text))
    (define solving (C-text folder four (up 't 'x)))
    (for ([line '("double v3_matrix[16], v3[4];" "v3_matrix[4] = x;" "v3_matrix[13] = x;"
                  "v3_matrix[15] = 6.0;" "v3[3] = 7.0;" "solve(4, v3_matrix, v3);"
                  "dy[1] = v3[2];")])
      (check-true (string-contains? solving line) line))))

(test-case "the rates as JAX has them: variables, parameters, what is no number, systems"
  (define (rates s) (up 1 (* 'k (ref s 2) +inf.0) (+ (ref s 1) +nan.0 (* -inf.0 'k))))
  (check-words (JAX-text rates (up 't 'x 'y))
               (string-append
                "    t = y[0]\n    x = y[1]\n    y_ = y[2]\n    k = p[0]\n"
                "    return jnp.stack([1.0, y_ * (INFINITY * k), (-INFINITY) * k + (NAN + x)])"))
  (check-words (JAX-text four (up 't 'x))
               (string-append
                "    t = y[0]\n    x = y[1]\n"
                "    v3 = jnp.linalg.solve(jnp.array([[4.0 + x, x, 1.0, 0.0], [x, 5.0, 0.0, 1.0], "
                "[x, 1.0, 3.0, x], [0.0, x, x, 6.0]]), jnp.array([x, 5.0, 6.0, 7.0]))\n"
                "    return jnp.stack([1.0, v3[2]])")))
