#lang racket/base
;; Ensembles that are interrupted and taken up again, and checkpoints that are not theirs.

(require racket/file
         racket/port
         racket/runtime-path
         racket/system
         (only-in racket/list take)
         mechanics/book
         mechanics
         compiler/find-exe
         (only-in mechanics/error/note start-session-of-notes!)
         (only-in mechanics/scale/ensemble/prepare-task make-task)
         (only-in mechanics/scale/ensemble/task batch send)
         tests/mechanics/support/patience
         tests/mechanics/support/skip
         "../../support/checks.rkt")

(define-runtime-path worker-file "../../../../mechanics/scale/ensemble/worker.rkt")

(define (pendulum m l g) (Lagrangian->state-derivative (L-pendulum g m l)))
(define count 100)
(define starts (for/list ([k count]) (up 0 (* 0.02 k) 0.1)))
(define parameters (for/list ([k count]) (list 1.0 (+ 1 (* 0.01 k)) 9.8)))
(define bottom (event (lambda (s) (ref s 1)) #:name 'bottom #:direction 'falling))

(define (follow #:jobs [jobs 2] #:checkpoint [file #f] #:observe [each void]
                #:starts [starts starts] #:batch [batch 16])
  (evolve-ensemble pendulum starts 5 #:parameters (take parameters (length starts)) #:jobs jobs
                   #:batch batch #:checkpoint file #:observe each))

(define alone (follow #:jobs 1))

(define-syntax-rule (with-file file body ...)
  (let ([file (make-temporary-file "ensemble~a")])
    (dynamic-wind void
                  (lambda () (delete-file file) body ...)
                  (lambda () (when (file-exists? file) (delete-file file))))))

(test-case "an interrupted run goes on where it was, though its last words were cut off"
  (with-file file
    (check-exn #rx"enough"
               (lambda ()
                 (follow #:jobs 1 #:checkpoint file
                         #:observe (lambda (k v) (when (= k 47) (error "enough"))))))
    (define kept (file-size file))
    (check-true (> kept 1000))
    (call-with-output-file file #:exists 'append (lambda (port) (write-bytes #"\5\0\0\0" port)))
    (check-equal? (follow #:checkpoint file) alone)
    ;; all of it is there now
    (define whole (file-size file))
    (check-equal? (follow #:jobs 1 #:checkpoint file) alone)
    (check-equal? (file-size file) whole)))

(test-case "a run that goes on says how much is done"
  (define (check-said done again text)
    (with-file file
      (follow #:jobs 1 #:checkpoint file #:starts (take starts done))
      (define said (open-output-string))
      (define (in-session)
        (start-session-of-notes!)
        (follow #:jobs 1 #:checkpoint file #:starts again))
      (parameterize ([current-error-port said])
        (thread-wait (thread in-session)))
      (check-equal? (get-output-string said)
                    (format (string-append "; evolve-ensemble: goes on from a checkpoint, where ~a "
                                           "followed already\n;   file: ~a\n")
                            text file))))
  (check-said 32 starts "32 starts are")
  (check-said 1 (take starts 1) "1 start is"))

(test-case "a worker whose parent has died ends in the middle of a batch, without a word"
  (define-values (t _shape)
    (make-task 'test (pendulum 1 1 9.8) (up 0 1 0) '() '() #f 1e12 1e-10 'auto))
  (define-values (process out in errors) (subprocess #f #f #f (find-exe) worker-file))
  (send t in)
  (send (batch 0 '(#(0.0 1.0 0.0)) '(#())) in)
  (check-false (sync/timeout 1 out))
  (close-output-port in)
  (check-eq? (sync/patience 60 process) process)
  (check-equal? (subprocess-status process) 0)
  (check-equal? (list (port->string errors) (port->bytes out)) '("" #"")))

(test-case "a break in mid-run leaves a checkpoint that the same call goes on from"
  (with-file file
    (define here (current-thread))
    (define broken?
      (with-handlers ([exn:break? (lambda (e) #t)])
        (follow #:checkpoint file #:observe (lambda (k v) (when (= k 40) (break-thread here))))
        #f))
    (check-true broken?)
    (define kept (file-size file))
    (check-true (> kept 1000))
    (define seen 0)
    (check-equal? (follow #:checkpoint file #:observe (lambda (k v) (set! seen (+ seen 1)))) alone)
    (check-equal? seen count)
    (check-true (>= (file-size file) kept))))

(test-case "a checkpoint of another system, or of other events, is refused"
  (with-file file
    (define (sideways m l g) (Lagrangian->state-derivative (L-pendulum (* -1 g) m l)))
    (define (again #:maker [maker pendulum] #:events [events '()] #:tolerance [tolerance 1e-10])
      (evolve-ensemble maker starts 5 #:parameters parameters #:jobs 1 #:checkpoint file
                       #:events events #:tolerance tolerance))
    (again)
    (define before (file->bytes file))
    (for ([call (list (lambda () (again #:maker sideways)) (lambda () (again #:events bottom))
                      (lambda () (again #:tolerance 1e-6)))])
      (check-exn #rx"^evolve-ensemble: the checkpoint is of another ensemble" call)
      (check-equal? (file->bytes file) before))))

(test-case "a checkpoint of something else is refused and left as it is"
  (with-file file
    (follow #:jobs 1 #:checkpoint file)
    (define before (file->bytes file))
    (check-exn #rx"checkpoint is of another ensemble"
               (lambda () (evolve-ensemble pendulum starts 6 #:parameters parameters
                                           #:checkpoint file)))
    (check-exn #rx"other starts or parameters, from start 0"
               (lambda () (evolve-ensemble pendulum (reverse starts) 5 #:parameters parameters
                                           #:checkpoint file)))
    (check-equal? (file->bytes file) before)
    (call-with-output-file file #:exists 'truncate (lambda (port) (write-string "my notes" port)))
    (check-exn #rx"no checkpoint" (lambda () (follow #:checkpoint file)))
    (check-equal? (file->string file) "my notes")))

(test-case "an ensemble of more starts goes on from the checkpoint of fewer"
  (with-file file
    (define few (take starts 40))       ; the last batch is of 8
    (check-equal? (follow #:jobs 1 #:checkpoint file #:starts few) (take alone 40))
    (check-equal? (follow #:jobs 1 #:checkpoint file) alone)
    (define whole (file-size file))
    (check-equal? (follow #:jobs 1 #:checkpoint file) alone)
    (check-equal? (file-size file) whole)))

(test-case "batches of another size are told, and change nothing"
  (with-file file
    (follow #:jobs 1 #:checkpoint file)
    (define before (file->bytes file))
    (check-exn #rx"checkpoint has batches of 16 where there are 7 now, from start 0 on"
               (lambda () (follow #:jobs 1 #:checkpoint file #:batch 7)))
    (check-equal? (file->bytes file) before)))

(test-case "what another #:collect gives is not in the checkpoint"
  (with-file file
    (define (collected f)
      (evolve-ensemble pendulum starts 5 #:parameters parameters #:collect f #:jobs 1
                       #:checkpoint file))
    (collected coordinate)
    (check-exn #rx"of another ensemble: .*#:collect or #:events; it is left as it is"
               (lambda () (collected velocity)))))

(test-case "where a checkpoint cannot be written is told"
  (define folder (make-temporary-file "ensemble~a" 'directory))
  (check-exn #rx"the checkpoint is a file, and this is a folder"
             (lambda () (follow #:checkpoint folder)))
  (delete-directory folder)
  (skip-unless (file-exists? "/dev/full") "ensembles: there is no /dev/full"
    (check-exn #rx"evolve-ensemble: the checkpoint cannot be written\n  file: /dev/full\n  reason: "
               (lambda () (follow #:checkpoint "/dev/full")))))

;; A limit on the size of files stands for a full disk.
(define-runtime-path small-ensemble "../../support/ensembles/small-ensemble.rkt")
(define shell (find-executable-path "sh"))

(test-case "a disk that is full ends the run, and what was kept is good"
  (skip-unless shell "ensembles: no shell to limit the size of files"
    (with-file file
      (define racket (find-system-path 'exec-file))
      (define program (find-executable-path racket))
      (define out (open-output-string))
      (parameterize ([current-error-port out])
        (system* shell "-c" "trap '' XFSZ; ulimit -f 4; exec \"$0\" \"$1\" \"$2\""
                 program small-ensemble file))
      (check-regexp-match
       #rx"evolve-ensemble: the checkpoint cannot be written; the batches that are in it stay there"
       (get-output-string out))
      (define kept (file-size file))
      (check-true (> kept 1000))
      (define again
        (parameterize ([current-error-port (open-output-nowhere)])
          (with-output-to-string (lambda () (system* program small-ensemble file)))))
      (check-equal? again "400")
      (check-true (> (file-size file) kept)))))
