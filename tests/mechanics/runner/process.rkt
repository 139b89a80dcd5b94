#lang racket/base
;; Running test files, each in a process of its own, several at a time.
;;
;; A process gets a time limit and its own process group, so that what it
;; started ends with it.  All belong to the custodian current at the call:
;; shutting that down, as the runner does on a break, kills them.

(require compiler/find-exe
         racket/file
         racket/port
         racket/runtime-path)

(provide (struct-out outcome)
         run-files)         ; calls back with each outcome, in order of ending

;; reason : #f, or a string saying how the process ended if not properly;
;; output : bytes, what it wrote.
(struct outcome (file passed failed skips reason output seconds))

(define-runtime-path child "child.rkt")

;; run-files : (listof path) positive-integer seconds (outcome -> any) -> void
(define (run-files files jobs limit report)
  (define results (make-channel))
  (define queue (make-queue files))
  (for ([_ (in-range jobs)])
    (thread (lambda ()
              (let loop ()
                (define file (queue))
                (when file
                  (channel-put results (run-file file limit))
                  (loop))))))
  (for ([_ (in-list files)])
    (report (channel-get results))))

;; A procedure that gives one file at each call and #f in the end.
(define (make-queue files)
  (define lock (make-semaphore 1))
  (lambda ()
    (call-with-semaphore
     lock
     (lambda ()
       (and (pair? files)
            (begin0 (car files)
                    (set! files (cdr files))))))))

(define (run-file file limit)
  (define result-file (make-temporary-file "mechanics-test-~a"))
  (define start (current-inexact-milliseconds))
  (define-values (code output) (run-child result-file file limit))
  (define result (read-result result-file))
  (delete-file result-file)
  (judge file code result limit output
         (/ (- (current-inexact-milliseconds) start) 1000.0)))

(define (read-result result-file)
  (with-handlers ([exn:fail? (lambda (e) #f)])
    (define result (file->value result-file))
    (and (list? result) result)))

;; Exit code, or 'timeout; and what the process wrote.
(define (run-child result-file file limit)
  (define-values (process out in err)
    (parameterize ([subprocess-group-enabled #t]
                   [current-subprocess-custodian-mode 'kill])
      (subprocess #f #f 'stdout (find-exe) child result-file file)))
  (close-output-port in)
  (define written (open-output-bytes))
  (define reader (thread (lambda () (copy-port out written))))
  (define ended? (sync/timeout limit process))
  (subprocess-kill process #t)              ; and whatever it left running
  (sync/timeout 2 reader)
  (close-input-port out)
  (values (if ended? (subprocess-status process) 'timeout)
          (get-output-bytes written)))

(define (judge file code result limit output seconds)
  (define-values (passed failed skips)
    (if result (apply values result) (values 0 0 '())))
  (define reason
    (cond [(eq? code 'timeout) (format "stopped after ~a s" limit)]
          [(not result) (format "died with exit code ~a" code)]
          [(not (eqv? code 0)) (format "exited with code ~a" code)]
          [else #f]))
  (outcome file passed (if (and reason (eqv? failed 0)) 1 failed) skips
           reason output seconds))
