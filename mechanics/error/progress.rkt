#lang racket/base
;; Word of how far a long computation has come, for someone who waits at a prompt.
;;
;; After a few seconds one line appears on the terminal; it is written anew a few
;; times a second and erased in the end, be that a result, an error or a break.
;; Nothing is said where no prompt has asked for it, in a module or a test, nor where
;; the computation writes something itself, and nothing is computed differently where
;; it is.

(provide report-progress call-with-progress note-progress
         call-counting counting-search counted-values
         ;; for the prompt
         (struct-out reporter) current-reporter terminal-reporter)

;; Is word of progress wanted?
(define report-progress (make-parameter #t (lambda (x) (and x #t))))

;; port : where to write; clock : -> milliseconds
(struct reporter (port clock) #:authentic)

;; #f where nobody waits.
(define current-reporter (make-parameter #f))

(define (terminal-reporter)
  (define port (current-error-port))
  (and (terminal-port? port) (reporter port current-inexact-milliseconds)))

(define patience 3000)
(define interval 250)

;; Calls (body note!); body calls (note! (lambda () text)) now and then, as note-progress does.
;; note! is #f where no progress is reported.
(define (call-with-progress wanted? body)
  (define r (and wanted? (current-reporter)))
  (if r (report-while r body) (body #f)))

(define-syntax-rule (note-progress note! text)
  (when note! (note! (lambda () text))))

(define (report-while r body)
  (define clock (reporter-clock r))
  (define port (reporter-port r))
  (define before (written))
  (define due (+ (clock) patience))
  (define shown? #f)
  (define (note! text)
    (define now (clock))
    (when (and (>= now due) (eqv? (written) before))
      (set! due (+ now interval))
      (set! shown? #t)
      (write-line port (text))))
  (dynamic-wind
   void
   (lambda () (body note!))
   (lambda () (when shown? (write-line port "")))))

;; How much has been written to standard output.
(define (written) (file-position (current-output-port)))

;; From the first column on, in place of the former text.
(define (write-line port text)
  (write-string (string-append "\r" text "\e[K") port)
  (flush-output port))

;; Calls (body count!); (count! k) reports that k of `total` things, named by `noun`, are done.
;; total : #f where it is not known
(define (call-counting who noun total body)
  (call-with-progress
   (report-progress)
   (lambda (note!)
     (body (lambda (k)
             (note-progress note! (format "~a: ~a~a ~a" who k
                                          (if total (format " of ~a" total) "") noun)))))))

;; -> a procedure that a search calls with each point reached and the value there: it reports the
;; count of points, and calls `observe`
(define (counting-search note! who observe)
  (define steps 0)
  (lambda (x value)
    (set! steps (+ steps 1))
    (note-progress note! (format "~a: ~a steps, value ~a" who steps value))
    (observe x value)))

;; f with such a report at each evaluation.
(define (counted-values note! who f)
  (define note (counting-search note! who void))
  (lambda (x)
    (define y (f x))
    (note x y)
    y))
