#lang racket/base
;; The attack:  racket main.rkt [--count N] [--seed N] [--class NAME] [--jobs N] [--only K]
;;
;; Random claims of every class are put to the library, several processes at a time, and
;; judged by an evaluator of the tests' own (judge/).  At the end come a table and, in
;; build/attack.txt, every wrong claim as a program that can be pasted; the first ones of a
;; kind are shrunk, and shown.  The exit code is 1 if any claim is wrong.

(require compiler/find-exe racket/cmdline racket/future racket/runtime-path
         "classes/all.rkt" "table.rkt" "worker.rkt")

(define-runtime-path worker "worker.rkt")

;; How many claims a class, or a mode, has: CLASS=disguised is two classes.
(define (classes-called name)
  (cond [(not name) class-names]
        [(eq? name 'disguised) '(disguised false-by-little)]
        [(memq name class-names) (list name)]
        [else (raise-user-error 'attack "no such class: ~a; there are ~a" name class-names)]))

;; ---------------------------------------------------------------------------
;; Processes

;; -> a channel of reports (see worker.rkt), and #f from each process that ended, or a text
;; from one that died
(define (start-workers classes count seed jobs)
  (define reports (make-channel))
  (define plan
    (for/list ([name (in-list classes)])
      (list name (quotient (+ count (claims-of-a-subject name) -1) (claims-of-a-subject name)))))
  (for ([job (in-range jobs)])
    (define-values (process out in err)
      (parameterize ([current-subprocess-custodian-mode 'kill])
        (apply subprocess #f #f (current-error-port) (find-exe) worker
               (map (lambda (x) (format "~s" x)) (list* seed job jobs plan)))))
    (close-output-port in)
    (thread
     (lambda ()
       (let loop ()
         (define report (read out))
         (unless (eof-object? report)
           (channel-put reports report)
           (loop)))
       (subprocess-wait process)
       (define code (subprocess-status process))
       (channel-put reports (and (not (eqv? code 0))
                                 (format "a process died with exit code ~a" code))))))
  reports)

;; visit : report ->; -> texts of processes that died
(define (for-reports reports jobs visit)
  (let loop ([running jobs] [deaths '()])
    (if (eqv? running 0)
        deaths
        (let ([report (channel-get reports)])
          (cond [(pair? report) (visit report) (loop running deaths)]
                [else (loop (- running 1) (if report (cons report deaths) deaths))])))))

;; ---------------------------------------------------------------------------
;; The run

(define (run classes count seed jobs file shown)
  (define total (* count (length classes)))
  (define start (current-inexact-milliseconds))
  (define (seconds) (/ (- (current-inexact-milliseconds) start) 1000))
  (define t (make-table))
  (define last-word 0)
  (define deaths
    (call-with-output-file file #:exists 'truncate
      (lambda (out)
        (for-reports
         (start-workers classes count seed jobs) jobs
         (lambda (report)
           (table-add! t report)
           (show-programs report t seed out shown)
           (when (> (seconds) (+ last-word 10))
             (set! last-word (seconds))
             (eprintf "~a of ~a claims, ~a wrong, ~a s\n" (table-claims t) total
                      (table-wrong t) (round* (seconds)))))))))
  (print-table t classes)
  (printf "~a claims, ~a wrong, in ~a s, seed ~a~a\n" (table-claims t) (table-wrong t)
          (round* (seconds)) seed
          (if (> (table-wrong t) 0) (format "; all wrong ones are in ~a" file) ""))
  (for ([d (in-list deaths)]) (printf "~a\n" d))
  (if (and (eqv? 0 (table-wrong t)) (null? deaths)) 0 1))

;; One subject, in this process.
(define (run-one class seed k)
  (unless (memq class class-names) (raise-user-error 'attack "--only needs a --class"))
  (define report (report-on class seed k (make-hash)))
  (writeln (caddr report))
  (for-each displayln (cdddr report))
  (if (ormap (lambda (o) (wrong-judgement? (cdr o))) (caddr report)) 1 0))

(define (round* x) (inexact->exact (round x)))

;; All go to the file, the first ones of each kind to the screen.
(define (show-programs report t seed out shown)
  (define kinds (filter told-judgement? (map cdr (caddr report))))
  (for ([program (in-list (cdddr report))] [kind (in-list kinds)])
    (define text (format "; ~a ~a of seed ~a\n~a" (car report) (cadr report) seed program))
    (displayln text out)
    (when (<= (table-count t (car report) kind) shown) (displayln text))))

(module+ main
  (define-values (count seed jobs class) (values 2000 1 (processor-count) #f))
  (define-values (file shown only) (values "build/attack.txt" 1 #f))
  (define (natural text)
    (define n (string->number text))
    (unless (exact-nonnegative-integer? n) (raise-user-error 'attack "not a number: ~a" text))
    n)
  (command-line
   #:program "attack"
   #:once-each
   [("--count") n "claims of each class (2000)" (set! count (natural n))]
   [("--seed") n "of the random numbers (1)" (set! seed (natural n))]
   [("--jobs") n "processes at a time" (set! jobs (max 1 (natural n)))]
   [("--class") name "one class alone" (set! class (string->symbol name))]
   [("--shown") n "wrong claims shown of each kind (1)" (set! shown (natural n))]
   [("--only") k "one subject of the class, by its number" (set! only (natural k))]
   [("--file") path "where all wrong claims go" (set! file path)])
  (when only (exit (run-one class seed only)))
  (define children (make-custodian))
  (define code
    (with-handlers ([exn:break? (lambda (e) (eprintf "interrupted\n") 130)])
      (parameterize ([current-custodian children])
        (run (classes-called class) count seed jobs file shown))))
  (custodian-shutdown-all children)
  (exit code))
