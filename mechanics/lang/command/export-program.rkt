#lang racket/base
;; `raco mechanics export FILE`: the systems that a program follows or defines, as programs in
;; other languages.

(require racket/cmdline
         racket/path
         racket/string
         "program-systems.rkt" "system-of-program.rkt" "written-files.rkt"
         "../../error/complain.rkt" "../../error/message-words.rkt"
         "../../scale/export/export-system.rkt" "../../scale/export/exported-system.rkt")

(provide export-command)

(define who 'export)

;; systems : names; all?, list? : all of them, or only told
(struct wish (target out systems all? list? derivatives? replace?) #:authentic)

(define (export-command arguments)
  (define-values (file w) (read-arguments arguments))
  (define f
    (program-systems who (simple-form-path file) file #:derivatives? (wish-derivatives? w)))
  (define all (findings-systems f))
  (cond [(findings-error f) (tell-error file (findings-error f))]
        [(null? all) (tell-none file f)]
        [else
         (when (findings-exited? f) (note-exit file))
         (if (wish-list? w)
             (begin (print-systems all) 0)
             (write-systems (choose file all w) w))]))

(define (note-exit file)
  (eprintf "export: ~a ended itself, by (exit); what it would do after that is not looked at\n"
           file))

(define (read-arguments arguments)
  (define-values (to out systems) (values "c" #f '()))
  (define-values (all? list? derivatives? replace?) (values #f #f #f #f))
  (define file
    (command-line #:program "raco mechanics export"
                  #:argv (options-first arguments '("-o" "--to" "--system"))
                  #:once-each
                  [("--to") language "c, python or jax" (set! to language)]
                  [("-o") folder "The folder to write" (set! out folder)]
                  [("--all") "All systems, each in a folder" (set! all? #t)]
                  [("--list") "Tell the systems, and write nothing" (set! list? #t)]
                  [("--derivatives") "With the derivatives of the rates" (set! derivatives? #t)]
                  [("--replace") "Write an earlier export anew" (set! replace? #t)]
                  #:multi
                  [("--system") name "One of several" (set! systems (cons name systems))]
                  #:args (file) file))
  (values file (wish (target-named to) out (reverse systems) all? list? derivatives? replace?)))

(define targets '(("c" . C) ("python" . python) ("jax" . JAX)))

(define (target-named text)
  (define found (assoc (string-downcase text) targets))
  (unless found
    (complain who "it can be exported --to c, --to python or --to jax\n  given: ~a" text))
  (cdr found))

;; ---------------------------------------------------------------------------
;; Which

(define (choose file all w)
  (define names (wish-systems w))
  (for ([name (in-list names)])
    (unless (named name all)
      (complain who "~a has no such system\n  given: ~a\n  its systems: ~a"
                file name (joined (map found-name all)))))
  (define chosen
    (cond [(wish-all? w) all]
          [(pair? names) (for/list ([name (in-list names)]) (named name all))]
          [else all]))
  (when (and (pair? (cdr chosen)) (null? names) (not (wish-all? w))) (raise-several file all))
  (when (and (pair? (cdr chosen)) (wish-out w))
    (complain who "-o names one folder, and there are ~a systems\n  systems: ~a"
              (length chosen) (joined (map found-name chosen))))
  chosen)

(define (named name all)
  (for/first ([s (in-list all)] #:when (string=? name (found-name s))) s))

(define (raise-several file all)
  (complain who "~a has several systems; say which by --system NAME, or --all\n~a"
            file (joined (map description all) "\n")))

(define (print-systems all) (for ([s (in-list all)]) (printf "~a\n" (description s))))

(define (description s)
  (define e (found-system s))
  (format "  ~a: ~a\n      ~a" (found-name s) (found-definition s)
          (if (exported? e)
              (format "variables ~a; parameters ~a" (spaced (exported-variables e))
                      (spaced (exported-parameters e)))
              (format "cannot be exported: ~a" e))))

(define (spaced names)
  (if (null? names) "none" (string-join (map symbol->string names) " ")))

;; ---------------------------------------------------------------------------
;; Writing

;; -> status
(define (write-systems chosen w)
  (define good (filter (lambda (s) (exported? (found-system s))) chosen))
  (for ([s (in-list chosen)] #:unless (memq s good))
    (eprintf "export: ~a cannot be exported: ~a\n  of: ~a\n"
             (found-name s) (found-system s) (found-definition s)))
  (define target (wish-target w))
  (for ([s (in-list good)])
    (define folder
      (write-exported who (found-system s) target
                      (or (wish-out w) (format "~a-~a" (found-name s) target))
                      (wish-replace? w) "--replace"))
    (printf "~a\n~a\n" (short-path folder) (description s))
    (when (eq? target 'C) (print-first-run s (short-path folder))))
  (if (= (length good) (length chosen)) 0 1))

;; The program's own start, for a first run.
(define (print-first-run s folder)
  (when (found-start s)
    (printf "  cd ~a && make && echo \"~a\" | ./~a 10\n" folder
            (string-join (map number->string (append (found-start s) (found-values s))) " ")
            (found-name s))))

;; ---------------------------------------------------------------------------
;; Nothing to write

(define (tell-error file message)
  (eprintf "export: ~a did not run to its end, nothing is written:\n~a\n" file message)
  1)

(define (tell-none file f)
  (define shapeless (findings-shapeless f))
  (eprintf "export: ~a~a follows no motion~a\n" file
           (if (findings-exited? f) " ended itself, by (exit); before that it" "")
           (if (null? shapeless)
               (string-append
                " and defines no state derivative\n  one is made by (define motion"
                " (Lagrangian->state-derivative L));\n  submodules, as main and test, are not run")
               (format "; of what it defines no state is known: ~a~a"
                       (joined (map symbol->string shapeless))
                       (string-append "\n  take its arguments as (up t q v), follow a motion, or"
                                      " call export-system with a state"))))
  1)
