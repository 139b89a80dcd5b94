#lang racket/base
;; `raco mechanics export FILE`: the systems of a program as programs in other languages.

(require (only-in racket/list partition)
         racket/path
         racket/string
         "program-systems.rkt" "written-files.rkt"
         "../../error/complain.rkt" "../../error/message-words.rkt"
         "../../scale/export/export-system.rkt" "../../scale/export/exported-system.rkt")

(provide export-command)

(define who 'export)

(define (export-command arguments)
  (define-values (file option)
    (read-arguments who arguments
                    #:valued '("-o" "--to")
                    #:switches '("--all" "--list" "--derivatives" "--replace")
                    #:repeated '("--system")))
  (define target (target-named (or (option "--to") "c")))
  (define f (program-systems who (simple-form-path file) file))
  (define all (findings-systems f))
  (cond [(findings-error f) (tell-error file (findings-error f))]
        [(null? all) (tell-none file f)]
        [else
         (when (findings-exited? f)
           (eprintf "export: ~a ended itself, by (exit); ~a\n" file
                    "what it would do after that is not looked at"))
         (if (option "--list")
             (begin (print-systems all) 0)
             (write-systems (choose file all option) target option))]))

(define targets '(("c" . C) ("python" . python) ("jax" . JAX)))

(define (target-named text)
  (define found (assoc (string-downcase text) targets))
  (unless found
    (complain who "it can be exported --to c, --to python or --to jax\n  given: ~a" text))
  (cdr found))

;; ---------------------------------------------------------------------------
;; The choice among several systems

(define (choose file all option)
  (define named (for/list ([name (in-list (option "--system"))]) (system-named name file all)))
  (define all? (or (option "--all") (null? named)))
  (define chosen (if all? all named))
  (when (pair? (cdr chosen))
    (unless (or (option "--all") (pair? named))
      (complain who "~a has several systems; say which by --system NAME, or --all\n~a"
                file (joined (map description all) "\n")))
    (when (option "-o")
      (complain who "-o names one folder, and there are ~a systems\n  systems: ~a"
                (length chosen) (joined (map candidate-name chosen)))))
  chosen)

(define (system-named name file all)
  (or (findf (lambda (s) (string=? name (candidate-name s))) all)
      (complain who "~a has no such system\n  given: ~a\n  its systems: ~a"
                file name (joined (map candidate-name all)))))

(define (print-systems all) (for ([s (in-list all)]) (printf "~a\n" (description s))))

(define (description s)
  (define e (candidate-system s))
  (format "  ~a: ~a\n      ~a" (candidate-name s) (candidate-definition s)
          (if (exported? e)
              (format "variables ~a; parameters ~a" (spaced (exported-variables e))
                      (spaced (exported-parameters e)))
              (format "cannot be exported: ~a" e))))

(define (spaced names)
  (if (null? names) "none" (string-join (map symbol->string names) " ")))

;; ---------------------------------------------------------------------------
;; Writing

;; -> status
(define (write-systems chosen target option)
  (define-values (good others) (partition (lambda (s) (exported? (candidate-system s))) chosen))
  (for ([s (in-list others)])
    (eprintf "export: ~a cannot be exported: ~a\n  of: ~a\n"
             (candidate-name s) (candidate-system s) (candidate-definition s)))
  (for ([s (in-list good)])
    (define system
      (if (option "--derivatives") (with-jacobian (candidate-system s)) (candidate-system s)))
    (define folder
      (short-path (write-exported who system target
                                  (or (option "-o") (format "~a-~a" (candidate-name s) target))
                                  (option "--replace") "--replace")))
    (printf "~a\n~a\n" folder (description s))
    (when (eq? target 'C) (print-first-run s folder)))
  (if (null? others) 0 1))

;; A command for a first run, from the program's own start.
(define (print-first-run s folder)
  (when (candidate-start s)
    (printf "  cd ~a && make && echo \"~a\" | ./~a 10\n" folder
            (string-join (map number->string (candidate-start s)) " ") (candidate-name s))))

;; ---------------------------------------------------------------------------
;; Nothing to write

(define (tell-error file message)
  (eprintf "export: ~a did not run to its end, nothing is written:\n~a\n" file message)
  1)

(define (tell-none file f)
  (eprintf "export: ~a~a follows no motion and hands nothing to export-system\n~a~a\n" file
           (if (findings-exited? f) " ended itself, by (exit); before that it" "")
           "  write in it, for instance, (export-system (Lagrangian->state-derivative L) (up 't 'q 'v));\n"
           "  submodules, as main and test, are not run")
  1)
