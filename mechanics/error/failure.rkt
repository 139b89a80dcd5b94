#lang racket/base
;; Mathematical failures: the question was well put and has no (findable)
;; answer.  They carry the data that shows why, so that a program may go on
;; from there.  A mistake of the user's is an `exn:fail:contract` instead.

(require "message-words.rkt")

(provide
 ;; the exceptions
 (struct-out exn:fail:mechanics)
 (struct-out exn:fail:mechanics:singular)
 (struct-out exn:fail:mechanics:singular:matrix)
 (struct-out exn:fail:mechanics:not-convergent)
 (struct-out exn:fail:mechanics:not-convergent:integral)
 ;; raising them
 raise-no-answer raise-singular raise-without-inverse raise-not-convergent
 raise-divergent-integral raise-unknown-integral raise-rounded-integral
 ;; asking
 no-value?)

(struct exn:fail:mechanics exn:fail ())

;; where : the point, matrix or state at which something is not defined.
(struct exn:fail:mechanics:singular exn:fail:mechanics (where))

;; null-vectors : tuples, a basis of the null space; #f if not known.
(struct exn:fail:mechanics:singular:matrix exn:fail:mechanics:singular (null-vectors))

;; value : the best approximation found; error-estimate : how far off it may be.
(struct exn:fail:mechanics:not-convergent exn:fail:mechanics
  (value error-estimate))

;; where : the point near which an integrand is too much for the method.
(struct exn:fail:mechanics:not-convergent:integral exn:fail:mechanics:not-convergent (where))

;; Does the exception say that a function has no value at a point?
(define (no-value? e)
  (or (exn:fail:mechanics:singular? e) (exn:fail:contract:divide-by-zero? e)))

;; The message is made as `format` makes it.
(define (raise-no-answer who text . parts)
  (raise (exn:fail:mechanics (message-with-fields who (apply format text parts) '())
                             (current-continuation-marks))))

;; who : symbol; fields : label value label value ...
(define (raise-singular who what where . fields)
  (raise (exn:fail:mechanics:singular (message-with-fields who what fields)
                                      (current-continuation-marks)
                                      where)))

;; cause : the failure that this one explains in other words, or #f
(define (raise-without-inverse who what where null-vectors [cause #f])
  (raise (exn:fail:mechanics:singular:matrix
          (message-with-fields who what '())
          (if cause (exn-continuation-marks cause) (current-continuation-marks))
          where
          null-vectors)))

;; shown : shown in place of the value; show? : are value and error estimate shown?
(define (raise-not-convergent who what value error-estimate
                              #:shown [shown value] #:show? [show? #t] . fields)
  (define all (if show? (append fields (approximation shown error-estimate)) fields))
  (raise (exn:fail:mechanics:not-convergent
          (message-with-fields who what all)
          (current-continuation-marks)
          value
          error-estimate)))

;; raise-divergent-integral is for integrals that are seen to have no value.
(define (raise-divergent-integral who value bound where)
  (raise-no-integral who "the integral does not converge" value bound where))

(define (raise-unknown-integral who value bound where)
  (raise-no-integral who
                     (string-append "the integral was not found to the tolerance asked; "
                                    "whether it converges is not known")
                     value bound where))

(define (raise-rounded-integral who value bound where)
  (raise-no-integral who
                     (string-append "the integral was not found to the tolerance asked, for "
                                    "numbers next to each other are too far apart there")
                     value bound where))

(define (raise-no-integral who what value bound where)
  (raise (exn:fail:mechanics:not-convergent:integral
          (message-with-fields who what (list* "trouble near" where (approximation value bound)))
          (current-continuation-marks)
          value
          bound
          where)))

(define (approximation value error-estimate)
  (list "best value" value "error estimate" error-estimate))
