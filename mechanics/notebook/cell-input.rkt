#lang racket/base
;; The input of a program in a cell.  Where it reads and nothing is there, a line is asked for; it
;; waits for an event meanwhile, so that it can be interrupted.
;;
;; Only the thread that makes the port asks: `system` has a thread copy all input to a command,
;; which may want none.

(provide make-cell-input cell-input-port give-input! forget-request!)

;; port : for the program; pipe : where given lines are written; asked? : has a line been asked
;; for that was not given?
(struct cell-input (port pipe [asked? #:mutable]))

;; ask : -> void
(define (make-cell-input ask)
  (define-values (in out) (make-pipe))
  (define evaluator (current-thread))
  (define (read! buffer)
    (define n (read-bytes-avail!* buffer in))
    (cond [(and (eqv? n 0) (not (byte-ready? in)))
           (when (and (eq? (current-thread) evaluator) (not (cell-input-asked? input)))
             (set-cell-input-asked?! input #t)
             (ask))
           (wrap-evt in (lambda (_) 0))]
          [else n]))
  (define input (cell-input (make-input-port 'cell read! #f void) out #f))
  input)

;; text : a line without its newline
(define (give-input! input text)
  (forget-request! input)
  (write-string (string-append text "\n") (cell-input-pipe input)))

;; A line that was asked for and never typed is asked for anew.
(define (forget-request! input) (set-cell-input-asked?! input #f))
