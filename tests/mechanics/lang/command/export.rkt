#lang racket/base
;; `raco mechanics export`: which systems of a program are found, how they are named, what is
;; written and what is said where there is nothing to write.

(require racket/file
         "../../support/checks.rkt"
         "../../../../mechanics/lang/command/raco.rkt")

;; for-label: compiled with this file.
(require (for-label "../../../../mechanics/lang/command/export-program.rkt"))

(define folder (make-temporary-file "export~a" 'directory))

(define (answer . arguments)
  (define out (open-output-string))
  (define status
    (parameterize ([current-output-port out] [current-error-port out]
                   [current-directory folder])
      (run-command-line (cons "export" arguments))))
  (list status (get-output-string out)))

(define (program name . lines)
  (display-lines-to-file (cons "#lang mechanics" lines) (build-path folder name)
                         #:exists 'truncate)
  name)

(define (wrote? . parts) (file-exists? (apply build-path folder parts)))
(define (text . parts) (file->string (apply build-path folder parts)))

(test-case "the one system that is followed: its folder, and a first run"
  (program "swing.rkt"
           "(define ((L-swing m l) (up t θ θdot))"
           "  (+ (* 1/2 m (square l) (square θdot)) (* m 9.8 l (cos θ))))"
           "(define (maker m l) (Lagrangian->state-derivative (L-swing m l)))"
           "((state-advancer maker 1.0 2.0) (up 0 1 0) 3)")
  (check-equal? (answer "swing.rkt")
                (list 0 (string-append
                         "maker-C\n  maker: (maker p0 p1), of swing.rkt\n"
                         "      variables t q v; parameters p0 p1\n"
                         "  cd maker-C && make && echo \"0.0 1.0 0.0 1.0 2.0\" | ./maker 10\n")))
  (check-true (wrote? "maker-C" "maker.c"))
  (check-regexp-match #rx"const double p1 = p\\[1\\]" (text "maker-C" "maker.c"))
  (check-regexp-match #rx"const double v = y\\[2\\]" (text "maker-C" "maker.c"))
  (check-equal? (answer "swing.rkt")
                (list 2 (string-append "export: the folder is there already\n  folder: maker-C\n"
                                       "  to write it anew: --replace\n")))
  (check-equal? (car (answer "swing.rkt" "--replace" "--to" "jax" "-o" "maker-C")) 0)
  (check-false (wrote? "maker-C" "maker.c"))
  (check-true (wrote? "maker-C" "maker.py")))

(test-case "what it hands to export-system is exported, and nothing else; running writes nothing"
  (program "said.rkt"
           "(define ((L-swing m l) (up t θ θdot))"
           "  (+ (* 1/2 m (square l) (square θdot)) (* m 9.8 l (cos θ))))"
           "(define motion (Lagrangian->state-derivative (L-swing 'm 'l)))"
           "(export-system motion (up 't 'θ 'θdot) #:parameters '(m l) #:name \"swing\""
           "               #:folder \"elsewhere\" #:language 'JAX)"
           "(evolve-trajectory (lambda (s) (up 1 1)) (up 0 1.0) 1)")
  (check-equal? (answer "said.rkt")
                (list 0 (string-append "swing-C\n  swing: (Lagrangian->state-derivative L-swing)\n"
                                       "      variables t θ θdot; parameters m l\n")))
  (check-false (directory-exists? (build-path folder "elsewhere")))
  (check-regexp-match #rx"const double l = p\\[1\\]" (text "swing-C" "swing.c"))
  (check-regexp-match #rx"const double thetadot = y\\[2\\]" (text "swing-C" "swing.c"))
  (check-false (regexp-match? #rx"swing_jacobian" (text "swing-C" "swing.c")))
  (check-equal? (car (answer "said.rkt" "--replace" "--derivatives")) 0)
  (check-regexp-match #rx"swing_jacobian" (text "swing-C" "swing.c")))

;; The name of the file was taken for the language.
(test-case "an option without its value"
  (for ([option '("--to" "-o")])
    (define told (answer "swing.rkt" option))
    (check-false (eqv? 0 (car told)))
    (check-regexp-match (string-append "the \"" option "\" option needs 1 argument, but 0 provided")
                        (cadr told))))

(test-case "several: they are told, and one is chosen, or all"
  (program "two.rkt"
           "(define ((L-fall g) (up t (up x y) (up vx vy)))"
           "  (- (* 1/2 (+ (square vx) (square vy))) (* g y)))"
           "(define fall (Lagrangian->state-derivative (L-fall 9.8)))"
           "(define (turn s) (up 1 (up (ref s 1 1) (- (ref s 1 0)))))"
           "(define tr (evolve-trajectory turn (up 0 (up 1.0 0.0)) 1))"
           "(define again (evolve-trajectory turn (up 0 (up 2.0 0.0)) 1))"
           "(define (jump s) (up 1 (if (> (ref s 1) 0) -1.0 1.0)))"
           "(define up-and-down (evolve-trajectory jump (up 0 1.0) 0.5))"
           "(define falls (evolve-trajectory fall (up 0 (up 0.0 0.0) (up 1.0 1.0)) 0.5))")
  (define told
    (string-append
     "  turn: turn, of two.rkt\n      variables t x1_0 x1_1; parameters none\n"
     "  jump: jump, of two.rkt\n      cannot be exported: it takes a decision by `>`\n"
     "  two: (Lagrangian->state-derivative L-fall), of two.rkt\n"
     "      variables t q0 q1 v0 v1; parameters none\n"))
  (check-equal? (answer "two.rkt" "--list") (list 0 told))
  (check-equal? (answer "two.rkt")
                (list 2 (string-append
                         "export: two.rkt has several systems; say which by --system NAME,"
                         " or --all\n"
                         told)))
  (check-equal? (answer "two.rkt" "--system" "tune")
                (list 2 (string-append "export: two.rkt has no such system\n  given: tune\n"
                                       "  its systems: turn, jump, two\n")))
  (check-equal? (answer "two.rkt" "--all" "-o" "x")
                (list 2 (string-append "export: -o names one folder, and there are 3 systems\n"
                                       "  systems: turn, jump, two\n")))
  (define all (answer "two.rkt" "--all" "--to" "jax"))
  (check-equal? (car all) 1)
  (check-regexp-match #rx"^export: jump cannot be exported: it takes a decision by `>`\n  of: jump"
                      (cadr all))
  (check-true (and (wrote? "turn-JAX" "turn.py") (wrote? "two-JAX" "two.py")))
  (check-equal? (car (answer "two.rkt" "--system" "two" "-o" "one")) 0)
  (check-true (wrote? "one" "two.c")))

(test-case "a number by which the program decides stays in the system"
  (program "pull.rkt" "(define ((pull k) s) (up 1 (if (> k 0) (* k (ref s 1)) 1)))"
           "((state-advancer pull 2.0) (up 0 1.0) 1)")
  (check-equal? (answer "pull.rkt" "--to" "jax")
                (list 0 (string-append "pull-JAX\n  pull: (pull 2.0), of pull.rkt\n"
                                       "      variables t x1; parameters none\n")))
  (check-true (wrote? "pull-JAX" "pull.py")))

(test-case "nothing to write is told, and why"
  (program "none.rkt" "(+ 'a 'b)")
  (check-equal? (answer "none.rkt")
                (list 1 (string-append
                         "export: none.rkt follows no motion and hands nothing to export-system\n"
                         "  write in it, for instance, (export-system (Lagrangian->state-derivative L)"
                         " (up 't 'q 'v));\n"
                         "  submodules, as main and test, are not run\n")))
  (program "broken.rkt" "(define x (car '()))")
  (define broken (answer "broken.rkt"))
  (check-equal? (car broken) 1)
  (check-regexp-match #rx"broken.rkt did not run to its end, nothing is written:\n.*car"
                      (cadr broken))
  (check-equal? (answer "none.rkt" "--to" "fortran")
                (list 2 (string-append "export: it can be exported --to c, --to python or"
                                       " --to jax\n  given: fortran\n")))
  (check-regexp-match #rx"there is no file nine.rkt; did you mean none.rkt"
                      (cadr (answer "nine.rkt"))))

;; A program may end itself: from its last form, or from a procedure that is called for each
;; motion of an ensemble.
(test-case "what a program did before it ended itself is exported, and that is told"
  (define lines
    '("(define (turn s) (up 1 (* 2 (ref s 1))))"
      "(define ends"
      "  (evolve-ensemble turn (list (up 0 1.0) (up 0 2.0)) 1 #:jobs 1"
      "                   #:observe (lambda (k s) (exit 3))))"
      "(define after (evolve-trajectory (lambda (s) (up 1 1)) (up 0 1.0) 1))"))
  (apply program "ending.rkt" lines)
  (check-equal? (answer "ending.rkt" "--to" "jax" "-o" "ended")
                (list 0 (string-append
                         "export: ending.rkt ended itself, by (exit); what it would do after that"
                         " is not looked at\n"
                         "ended\n  turn: turn, of ending.rkt\n"
                         "      variables t x1; parameters none\n")))
  (check-true (wrote? "ended" "turn.py"))
  (program "early.rkt" "(exit)" "(define f (Lagrangian->state-derivative (lambda (s) 1)))")
  (check-equal? (answer "early.rkt")
                (list 1 (string-append
                         "export: early.rkt ended itself, by (exit); before that it follows no"
                         " motion and hands nothing to export-system\n"
                         "  write in it, for instance, (export-system (Lagrangian->state-derivative L)"
                         " (up 't 'q 'v));\n"
                         "  submodules, as main and test, are not run\n"))))

(delete-directory/files folder)
