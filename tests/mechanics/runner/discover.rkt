#lang racket/base
;; Which files are tests: every module under tests/mechanics except the runner,
;; the benchmarks, the helpers in support/ and attack/ and package information; and
;; every helper with a `test` submodule.  Those of the examples are run by some of the tests,
;; many in a process (support/example-programs.rkt).
;;
;; Four suites have commands of their own, for they take minutes and see little of what is
;; changed from day to day: the manual, the figures, exports in foreign languages, and attacks, on
;; answers of students, verdicts, certificates and the tests themselves.

(require racket/file
         racket/list
         racket/path
         racket/runtime-path
         (only-in racket/string string-prefix?)
         (only-in (file "../../../.ci/compile.rkt") files-under))

(provide suites          ; (listof string): their names
         suite-files     ; name -> (listof path)
         test-files      ; -> (listof path): those of all suites
         example-files   ; -> (listof path): examples with tests
         long-test?      ; path -> boolean
         short-name      ; path -> string: from the top folder, if it is below it
         from-top        ; string, a short name -> path
         within-top?)    ; path -> boolean: is it below the top folder?

(define-runtime-path top-folder "../../..")
(define top (simplify-path top-folder))
(define tests (build-path top "tests" "mechanics"))
(define examples (build-path top "examples" "mechanics"))

(define (short-name file)
  (define text (path->string file))
  (if (within-top? file) (substring text (string-length top-text)) text))
(define (from-top name) (simplify-path (build-path top name)))

(define (within-top? file) (string-prefix? (path->string file) top-text))
(define top-text (path->string (path->directory-path top)))

;; ---------------------------------------------------------------------------
;; Suites

(define special-suites
  '(("manual" "manual.rkt" "guide-notebooks.rkt")
    ("figures" "show/plot/figures.rkt")
    ("export" "scale/export/C.rkt" "scale/export/python.rkt")
    ("attacks" "attack.rkt" "mutants.rkt" "algebra/mutants.rkt" "certificate/checked-by-Coq.rkt"
               "teaching/class/hostile.rkt" "teaching/class/hostile-notebooks.rkt")))

(define everyday "everyday")
(define suites (cons everyday (map car special-suites)))

(define (suite-files name)
  (define (paths suite) (for/list ([file (in-list (cdr suite))]) (build-path tests file)))
  (if (equal? name everyday)
      (remove* (append-map paths special-suites) (test-files))
      (paths (assoc name special-suites))))

;; Files that take longest are begun first where nothing is known of an earlier run.
(define long-test
  '("manual.rkt" "show/plot/figures.rkt" "teaching/class/hostile.rkt" "scale/export/C.rkt"
    "certificate/checked-by-Coq.rkt" "teaching/class/hostile-notebooks.rkt" "attack.rkt"
    "lang/command/class-commands.rkt" "lang/help/cards.rkt" "show/display/program-end.rkt"
    "exercises.rkt" "examples.rkt" "scale/export/python.rkt" "test-runner.rkt"
    "dynamics/invariant-curve/circles-of-motions.rkt"))

(define (long-test? file)
  (and (member (path->string (find-relative-path tests file)) long-test) #t))

;; ---------------------------------------------------------------------------

(define (test-files)
  (filter test? (files-under tests)))

(define (test? file)
  (define place (path->string (find-relative-path tests file)))
  (cond [(regexp-match? #rx"^(runner|bench)/" place) #f]
        [(regexp-match? #rx"^(support|attack)/" place) (has-tests? file)]
        [else #t]))

(define (example-files) (filter has-tests? (files-under examples)))

;; Read off the text, so that a file that does not compile is found too.
(define (has-tests? file) (regexp-match? #px"\\(module[+*]?\\s+test\\b" (file->string file)))
