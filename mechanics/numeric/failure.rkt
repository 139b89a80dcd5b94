#lang racket/base
;; Mathematical failures: the question was well put and has no (findable)
;; answer.  They carry the data that shows why, so that a program may go on
;; from there.  A mistake of the user's is an `exn:fail:contract` instead.

(provide
 ;; the exceptions
 (struct-out exn:fail:mechanics)
 (struct-out exn:fail:mechanics:singular)
 (struct-out exn:fail:mechanics:singular:matrix)
 (struct-out exn:fail:mechanics:not-convergent)
 ;; raising them
 raise-singular raise-not-convergent)

(struct exn:fail:mechanics exn:fail ())

;; where : the point, matrix or state at which something is not defined.
(struct exn:fail:mechanics:singular exn:fail:mechanics (where))

;; null-vectors : tuples, a basis of what the matrix takes to zero; #f if not known.
(struct exn:fail:mechanics:singular:matrix exn:fail:mechanics:singular (null-vectors))

;; value : the best approximation found; error-estimate : how far off it may be.
(struct exn:fail:mechanics:not-convergent exn:fail:mechanics
  (value error-estimate))

;; who : symbol; fields : label value label value ...
(define (raise-singular who what where . fields)
  (raise (exn:fail:mechanics:singular (failure-message who what fields)
                                      (current-continuation-marks)
                                      where)))

(define (raise-not-convergent who what value error-estimate . fields)
  (raise (exn:fail:mechanics:not-convergent
          (failure-message who what
                           (append fields
                                   (list "best value" value
                                         "error estimate" error-estimate)))
          (current-continuation-marks)
          value
          error-estimate)))

(define (failure-message who what fields)
  (apply string-append (symbol->string who) ": " what
         (let loop ([fields fields])
           (if (null? fields)
               '()
               (cons (format "\n  ~a: ~e" (car fields) (cadr fields))
                     (loop (cddr fields)))))))
