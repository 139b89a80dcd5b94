#lang racket/base
;; The verdicts that a program shows, as results, within them or by printing or formatting them,
;; each once and with the form that showed it first.

(require racket/list
         "run-program.rkt" "watch.rkt"
         "../program-file.rkt"
         "../../value/structure.rkt"
         "../../verdict/verdict.rkt")

(provide program-verdicts (struct-out shown-verdict))

;; form : as a datum
(struct shown-verdict (form verdict) #:authentic)

;; who : in whose name is complained; name : of the file, as it was given
;; -> shown verdicts, and the message of the error that ended the program early, or #f
(define (program-verdicts who file name)
  (check-program who name file)
  (define stx (call-with-program file (lambda (port) (read-whole-program who name file port))))
  (define-values (number found) (values 0 '()))
  (define (note! v) (set! found (cons (cons number v) found)))
  (define o
    (parameterize ([verdict-formatted note!])
      (run-program stx file #:begins (lambda (n) (set! number n))
                   #:shown (lambda (x) (for-each note! (verdicts-in x))))))
  (define end (outcome-end o))
  (define forms (list->vector (map syntax->datum (module-forms stx))))
  (values (for/list ([f (in-list (remove-duplicates (reverse found) eq? #:key cdr))])
            (shown-verdict (vector-ref forms (car f)) (cdr f)))
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
