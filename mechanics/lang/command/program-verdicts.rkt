#lang racket/base
;; The verdicts that a program shows, each with the form that it is the result of.

(require "run-program.rkt" "watch.rkt"
         "../program-file.rkt"
         "../../show/document/document-piece.rkt"
         "../../verdict/verdict.rkt")

(provide program-verdicts (struct-out shown-verdict))

;; form : as a datum
(struct shown-verdict (form verdict) #:authentic)

;; who : in whose name is complained; name : of the file, as it was given
;; -> shown verdicts, and the message of the error that ended the program early, or #f
(define (program-verdicts who file name)
  (check-program who name file)
  (define stx (call-with-program file (lambda (port) (read-whole-program who name file port))))
  (define o (run-program stx file #:shown values))
  (define end (outcome-end o))
  (values (for*/list ([(form number) (in-parallel (module-forms stx)
                                                  (in-range (vector-length (outcome-found o))))]
                      [x (in-list (vector-ref (outcome-found o) number))]
                      #:when (and (result? x) (verdict? (result-shown x))))
            (shown-verdict (syntax->datum form) (result-shown x)))
          (and end (early-end-message end))))
