#lang racket/base
;; The verdicts that a program shows, as results, within them or by printing or formatting them,
;; each once and with the form that showed it first.

(require "run-program.rkt" "watch.rkt"
         "../program-file.rkt"
         "../../value/structure.rkt"
         "../../verdict/verdict.rkt")

(provide program-verdicts (struct-out shown-verdict))

;; form : as a datum
;; milliseconds : of the processor since the verdict before; of the first, with compiling
(struct shown-verdict (form verdict milliseconds) #:authentic)

;; who : in whose name is complained; name : of the file, as it was given
;; -> shown verdicts, and the message of the error that ended the program early, or #f
(define (program-verdicts who file name)
  (check-program who name file)
  (define stx (call-with-program file (lambda (port) (read-whole-program who name file port))))
  ;; A module that the program requires may show verdicts before the first form begins.
  (define-values (number found start) (values 0 '() (current-process-milliseconds)))
  (define (note! v)
    (unless (assq v found)
      (define now (current-process-milliseconds))
      (set! found (cons (list v number (- now start)) found))
      (set! start now)))
  (define o
    (parameterize ([verdict-formatted note!])
      (run-program stx file #:begins (lambda (n) (set! number n))
                   #:shown (lambda (x) (for-each note! (verdicts-in x))))))
  (define end (outcome-end o))
  (define forms (list->vector (map syntax->datum (module-forms stx))))
  (values (for/list ([f (in-list (reverse found))])
            (shown-verdict (vector-ref forms (cadr f)) (car f) (caddr f)))
          (and end (early-end-message end))))

;; Verdicts in lists and other values as well
(define (verdicts-in x)
  (cond [(verdict? x) (list x)]
        [(pair? x) (append (verdicts-in (car x)) (verdicts-in (cdr x)))]
        [(vector? x) (verdicts-in (vector->list x))]
        [(box? x) (verdicts-in (unbox x))]
        [(hash? x) (verdicts-in (hash-values x))]
        [(tuple? x) (verdicts-in (structure->list x))]
        [else '()]))
