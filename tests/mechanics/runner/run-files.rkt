#lang racket/base
;; Runs test files in several processes side by side, many files in each.
;;
;; `raco test --process` too runs files side by side.  But it mixes what they print, with that of
;; those that pass; a file that ends its process early or tests nothing passes for it; it cannot
;; count skips; and what a file started lives on when its time is over.

(require compiler/find-exe
         racket/port
         racket/runtime-path
         "../support/patience.rkt" "result.rkt")

(provide run-files              ; paths, jobs, seconds, report -> (listof outcome)
         outcome-file outcome-output
         outcome-passed outcome-failed outcome-reason outcome-skips outcome-seconds outcome-files)

(define-runtime-path worker-file "worker.rkt")

;; output : text, what it printed
(struct outcome (file result output))

(define (outcome-passed o) (result-passed (outcome-result o)))
(define (outcome-seconds o) (result-seconds (outcome-result o)))
(define (outcome-skips o) (result-skips (outcome-result o)))
(define (outcome-files o) (result-files (outcome-result o)))

;; That a file did not end properly, or tested nothing, is one failure more.
(define (outcome-failed o)
  (+ (result-failed (outcome-result o)) (if (outcome-reason o) 1 0)))

(define (outcome-reason o)
  (define r (outcome-result o))
  (or (result-ending r)
      (and (null? (result-skips r))
           (eqv? 0 (+ (result-passed r) (result-failed r)))
           "ran no test")))

;; Each file is handed to the next of `jobs` processes that has nothing to do; report is called with
;; each outcome.  limit : seconds that one file may take, more on a machine that is slow or busy
(define (run-files files jobs limit report)
  (define to-do (make-channel))
  (define done (make-channel))
  (for ([_ (in-range jobs)])
    (thread (lambda () (work to-do (lambda (o) (channel-put done o)) limit))))
  (thread (lambda () (for ([f (in-list files)]) (channel-put to-do f))))
  (for/list ([_ (in-list files)])
    (define o (channel-get done))
    (report o)
    o))

(define (work to-do report limit)
  (let next ([idle #f])
    (define file (channel-get to-do))
    (define w (or idle (start-worker)))
    (report (ask-to-run w file limit))
    (cond [(usable? w) (next w)]
          [else (stop w) (next #f)])))

;; ---------------------------------------------------------------------------
;; Processes

;; mark : what begins the line of a result; files : how many it has run
(struct worker (process in out mark [files #:mutable]))

(define most-files 80)           ; in one process, so that its memory stays small

(define (usable? w)
  (and (not (port-closed? (worker-out w)))
       (eq? 'running (subprocess-status (worker-process w)))
       (< (worker-files w) most-files)))

;; It has a group of its own, so that what its files started ends with it.
(define (start-worker)
  (define mark (format "result-~a" (random 1000000000)))
  (define-values (process out in err)
    (parameterize ([subprocess-group-enabled #t] [current-subprocess-custodian-mode 'kill])
      (subprocess #f #f 'stdout (find-exe) worker-file mark)))
  (worker process in out (string->bytes/utf-8 mark) 0))

(define (stop w)
  (subprocess-kill (worker-process w) #t)
  (close-output-port (worker-in w))
  (close-input-port (worker-out w)))

(define (ask-to-run w file limit)
  (define start (current-inexact-milliseconds))
  (define written (open-output-bytes))
  (define found #f)
  (set-worker-files! w (+ 1 (worker-files w)))
  (ask w file)
  (define reader (thread (lambda () (set! found (read-result w written)))))
  (unless (or (sync/timeout limit reader) (sync/timeout (- (clock-seconds limit) limit) reader))
    (kill-thread reader)
    (stop w))
  (define (unfinished how)
    (result 0 0 '() how (/ (- (current-inexact-milliseconds) start) 1000) '()))
  (outcome file
           (cond [(not found) (unfinished (format over-limit limit))]
                 [(eof-object? found) (unfinished (format "died with exit code ~a" (exit-code w)))]
                 [else found])
           (bytes->string/utf-8 (get-output-bytes written) #\?)))

(define over-limit "stopped: it takes more than ~a s on an idle machine")

;; One that has died takes no question.
(define (ask w file)
  (with-handlers ([exn:fail? void])
    (writeln (path->string file) (worker-in w))
    (flush-output (worker-in w))))

;; written : port for what is printed before the result -> result, or eof if the process ended
(define (read-result w written)
  (define result-line (bytes-append (worker-mark w) #" "))
  (let loop ()
    (define line (sync (line-evt w)))
    (cond [(eof-object? line) line]
          [(bytes-prefix? line result-line)
           (read (open-input-bytes (subbytes line (bytes-length result-line))))]
          [else (write-bytes line written) (newline written) (loop)])))

;; The next line, or eof.  Programs that outlive the process would keep its output open: they
;; are ended when it has ended.
(define (line-evt w)
  (define line (read-bytes-line-evt (worker-out w)))
  (choice-evt line
              (replace-evt (worker-process w)
                           (lambda (process)
                             (subprocess-kill process #t)
                             line))))

(define (bytes-prefix? bytes prefix)
  (define n (bytes-length prefix))
  (and (<= n (bytes-length bytes)) (equal? prefix (subbytes bytes 0 n))))

(define (exit-code w)
  (subprocess-wait (worker-process w))
  (subprocess-status (worker-process w)))
