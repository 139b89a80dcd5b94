#lang racket/base
;; The process behind a notebook's kernel.  Its arguments are the two descriptors of its protocol
;; (protocol.rkt).
;;
;;   to it                                   from it
;;   cell (id, code)                         stream, shown, interaction, exploration,
;;                                           progress, input; at last done
;;   frame (id, number, values)              done: of an interaction that was shown
;;   explore (id, number, actions)           done: of a map that is explored
;;   complete, describe (id, code, cursor)   done
;;   completeness (id, code)                 done
;;   input (text)                            where it was asked for
;;   break (id)                              of a cell; where it has ended, nothing happens
;;
;; One thread reads, so that a break comes through; the main thread evaluates.  At end of file the
;; process ends, whatever it is doing.

(require ffi/unsafe
         ffi/unsafe/port
         "cell-input.rkt" "cell.rkt" "changed-pictures.rkt" "names-at-cursor.rkt"
         "progress-port.rkt" "protocol.rkt" "small-heap.rkt" "text-stream.rkt"
         "../error/complain.rkt" "../error/progress.rkt" "../error/refusal.rkt"
         "../generic/on-demand.rkt"
         "../lang/session-start.rkt"
         "../show/display/receiving-printer.rkt"
         "../show/explorer/exploration-host.rkt")

(require-on-demand ["live-interaction.rkt" frame-bundle]
                   ["live-exploration.rkt" exploration-message explored-answer])

(define-namespace-anchor here)

;; send : message -> void; output, errors : text streams; input : cell-input;
;; pictures : changed-pictures
(struct kernel (send output errors input pictures))

;; The id of the cell that is evaluated, or #f; and of the last that is to be broken, which may not
;; have begun.  Both threads look at them in turn.
(define running (box #f))
(define to-break (box #f))
(define turn (make-semaphore 1))

(define (serve in out)
  (define send (make-sender out))
  (define (stream name)
    (make-text-stream (lambda (text) (send (hasheq 'kind "stream" 'name name 'text text)))))
  (define k
    (kernel send (stream "stdout") (stream "stderr")
            (make-cell-input (lambda () (send (hasheq 'kind "input"))))
            (make-changed-pictures)))
  (define evaluator (current-thread))
  (define end (exit-handler))
  (thread (lambda () (read-requests k in evaluator end)))
  (parameterize ([current-namespace (namespace-anchor->empty-namespace here)]
                 [current-input-port (cell-input-port (kernel-input k))]
                 [current-output-port (text-stream-port (kernel-output k))]
                 [current-error-port (text-stream-port (kernel-errors k))])
    (start! k)
    (let loop ()
      (answer k (thread-receive))
      (loop))))

;; A session as at a prompt, whose results are sent.
(define (start! k)
  (namespace-require 'mechanics)
  (error-display-handler (lambda (message e) (eprintf "~a\n" message)))
  (current-print (output-receiver (lambda (x) (show! k x)) (current-output-port)))
  (current-reporter (reporter (progress-port (kernel-send k)) current-inexact-milliseconds))
  (current-exploration-host
   (lambda (who f . more)
     (note-explored! (kernel-pictures k) f (lambda () (apply exploration-message who f more)))))
  (exit-handler refuse-exit)
  (start-session!)
  (keep-heap-small!)
  ((kernel-send k) (hasheq 'kind "ready")))

(define (refuse-exit code)
  (complain 'exit end-in-menu))

;; ---------------------------------------------------------------------------
;; Requests

(define (read-requests k in evaluator end)
  (define m (with-handlers ([exn:fail? (lambda (e) eof)]) (read-message in)))
  (cond [(eof-object? m) (end 0)]
        [else
         (case (hash-ref m 'do)
           [("break") (break-cell (hash-ref m 'id) evaluator)]
           [("input") (give-input! (kernel-input k) (hash-ref m 'text))]
           [else (thread-send evaluator m)])
         (read-requests k in evaluator end)]))

(define (break-cell id evaluator)
  (in-turn (lambda ()
             (set-box! to-break id)
             (when (equal? id (unbox running)) (break-thread evaluator)))))

(define (in-turn f) (parameterize-break #f (call-with-semaphore turn f)))

(define (answer k m)
  (define fields
    (with-handlers ([raised? (lambda (e) (hasheq 'status "error" 'line 'null 'interrupted #f
                                                 'message (told e)))])
      (answer-fields k m)))
  ((kernel-send k) (hash-set* fields 'kind "done" 'id (hash-ref m 'id))))

(define (answer-fields k m)
  (define (code) (hash-ref m 'code))
  (define (cursor) (hash-ref m 'cursor))
  (case (hash-ref m 'do)
    [("cell") (run-cell k (hash-ref m 'id) (code))]
    [("frame") (run-frame k (hash-ref m 'id) (hash-ref m 'number) (hash-ref m 'values))]
    [("explore") (run-exploration k (hash-ref m 'id) (hash-ref m 'number) (hash-ref m 'actions))]
    [("complete") (completion (code) (cursor))]
    [("describe") (description (code) (cursor))]
    [else (hasheq 'status (cell-completeness (code)))]))

;; ---------------------------------------------------------------------------
;; Cells

(define (run-cell k id code)
  (forget-request! (kernel-input k))
  (for-each begin-cell! (list (kernel-output k) (kernel-errors k)))
  (define failed
    (call-breakably id
                    (lambda ()
                      (call-showing-changes (kernel-pictures k)
                                            (lambda () (evaluate-cell code))
                                            (lambda (x) (show! k x #t))))
                    (lambda () (failure "interrupted" #f #t))))
  (flush-C-output)
  (send-output! k)
  (send-left-out k)
  (if failed
      (hasheq 'status "error" 'message (failure-message failed)
              'line (or (failure-line failed) 'null)
              'interrupted (failure-interrupted? failed))
      (hasheq 'status "ok")))

(define (run-frame k id number values)
  (define data (call-breakably id (lambda () (frame-bundle number values)) (lambda () 'null)))
  (send-output! k)
  (hasheq 'status "ok" 'data data))

;; The reader's map runs in a thread of its own; a break leaves its picture to the next answer.
(define (run-exploration k id number actions)
  (define answer
    (call-breakably id (lambda () (explored-answer number actions)) (lambda () (hasheq))))
  (send-output! k)
  (hash-set answer 'status "ok"))

;; Breaks are for the work of this id alone: one that comes as it ends is forgotten.
(define (call-breakably id work otherwise)
  (parameterize-break #f
    (in-turn (lambda ()
               (set-box! running id)
               (when (equal? id (unbox to-break)) (break-thread (current-thread)))))
    (begin0 (with-handlers ([exn:break? (lambda (e) (otherwise))])
              (parameterize-break #t (work)))
            (in-turn (lambda () (set-box! running #f)))
            (forget-break))))

(define (forget-break)
  (with-handlers ([exn:break? void]) (parameterize-break #t (void))))

(define (send-output! k)
  (send-rest! (kernel-output k))
  (send-rest! (kernel-errors k)))

(define (send-left-out k)
  (define n (+ (left-out (kernel-output k)) (left-out (kernel-errors k))))
  (when (positive? n)
    ((kernel-send k)
     (hasheq 'kind "stream" 'name "stderr"
             'text (format "\n; ~a more bytes of output are left out; write them to a file\n" n)))))

;; Output of libraries in C waits in buffers of their own.
(define (flush-C-output)
  (define flush (get-ffi-obj 'fflush #f (_fun _pointer -> _int) (lambda () void)))
  (flush #f))

;; in-place? : where it was shown before, if it was
(define (show! k x [in-place? #f])
  (unless (void? x)
    (define m (result-message (kernel-pictures k) x in-place?))
    (send-output! k)
    ((kernel-send k) m)
    (note-shown! (kernel-pictures k) x)))

(module+ main
  (define (descriptor k mode)
    (define number (string->number (vector-ref (current-command-line-arguments) k)))
    (unsafe-file-descriptor->port number 'protocol (list mode)))
  (serve (descriptor 0 'read) (descriptor 1 'write)))
