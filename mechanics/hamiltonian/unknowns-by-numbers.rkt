#lang racket/base
;; Unknowns from equations f(x) = y by numbers, with Newton's method; and when none are found.

(require "../algebra/expression/symbols.rkt"
         "../error/complain.rkt" "../error/failure.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/on-demand.rkt"
         "../generic/up-down.rkt"
         "../value/shape.rkt")

(require-on-demand
 ["../search/find-root.rkt" find-root]
 ["../search/implicit-root.rkt" plain])

(provide unknowns-by-numbers raise-none-found free-of?)

;; unknowns : their name, such as "velocities"; of : from what they follow, as far as it is said
(define (unknowns-by-numbers who unknowns f y start #:of [of ""])
  (for ([x (in-list (scalars (plain (up y (f start) start))))])
    (unless (number? x) (raise-no-formula who unknowns x)))
  (with-handlers ([exn:fail:mechanics:not-convergent?
                   (lambda (e)
                     (raise-none-found who unknowns of y
                                       (exn:fail:mechanics:not-convergent-value e)
                                       (exn:fail:mechanics:not-convergent-error-estimate e)))])
    (find-root (lambda (x) (g:- (f x) y)) start)))

(define (raise-no-formula who unknowns x)
  (complain who
            (string-append "no formula was found for the ~a, and numbers are not found with "
                           "symbols left\n  one of them: ~a"
                           "\n  give the parameters and the state as numbers")
            unknowns (value->text x)))

(define (raise-none-found who unknowns of y reached estimate)
  (raise-not-convergent who
                        (format "no ~a were found for ~a~a" unknowns of (value->text (plain y)))
                        reached estimate #:show? #f))

;; Do the scalars of x not depend on the names?
(define (free-of? x names)
  (not (for*/or ([e (in-list (scalars x))] [name (in-list names)]) (occurs? name e))))
