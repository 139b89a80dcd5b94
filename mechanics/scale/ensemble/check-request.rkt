#lang racket/base
;; Checks the arguments of evolve-ensemble before the first start is taken.

(require (only-in racket/path path-only)
         "../../error/complain.rkt"
         "../../generic/describe.rkt" "../../generic/function-check.rkt"
         "../../motion/system/check.rkt" "../../motion/method-names.rkt")

(provide check-argument-order check-settings check-callbacks)

(define who 'evolve-ensemble)

(define (check-argument-order maker starts end)
  (when (and (procedure? starts) (sequence? maker) (not (procedure? maker)))
    (complain who "the state derivative comes first, then the starts\n  given first: ~a"
              (describe-with-value maker)))
  (when (and (real? starts) (sequence? end) (not (real? end)))
    (complain who "the starts come before the time where they end\n  given second: ~a"
              (describe-with-value starts))))

(define (check-settings end tolerance method jobs batch-size file)
  (check-real who "final time" end)
  (check-tolerance who tolerance)
  (check-method who method)
  (unless (symbol? method)
    (complain who "methods are told to other processes by name\n  given: ~a" (value->text method)))
  (for ([x (in-list (list jobs batch-size))] [what (in-list '("#:jobs" "#:batch"))])
    (unless (exact-positive-integer? x)
      (complain who "~a is a positive integer\n  given: ~a" what (value->text x))))
  (unless (or (not file) (path-string? file))
    (complain who "expected the name of a file as checkpoint\n  given: ~a" (value->text file)))
  (when file (check-file-place file)))

(define (check-file-place file)
  (define folder (path-only (path->complete-path file)))
  (unless (directory-exists? folder)
    (complain who "there is no such folder for the checkpoint\n  folder: ~a" folder))
  (when (directory-exists? file)
    (complain who "the checkpoint is a file, and this is a folder\n  folder: ~a" file)))

;; initial : void if it was not given
(define (check-callbacks collect events? observe fold initial)
  (if events?
      (check-callback "#:collect" collect 2 "a state and a list of occurrences, with #:events")
      (check-callback "#:collect" collect 1 "a state"))
  (unless observe
    (complain who "#:observe is a procedure of an index and a value\n  given: #f, a boolean"))
  (check-callback "#:observe" observe 2 "an index and a value")
  (check-callback "#:fold" fold 2 "a value and what was made of those before")
  (when (and fold (void? initial))
    (complain who
              (string-append "#:fold comes with #:initial, what it is given with the first value"
                             "\n  a sum: #:fold + #:initial 0"
                             "\n  a list, the last value first: #:fold cons #:initial '()")))
  (unless (or fold (void? initial))
    (complain who
              (string-append "#:initial comes with #:fold, which is given it with the first value"
                             "\n  given: #:initial ~a\n  a sum: #:fold + #:initial 0")
              (value->text initial))))

(define (check-callback what f arguments takes)
  (unless (or (not f) (takes-arguments? f arguments))
    (complain who "~a is a procedure of ~a\n  given: ~a" what takes (describe-with-value f))))
