#lang racket/base
;; Unknowns from equations f(x) = y, as generating functions give them
;; (hamiltonian/equation-solver.rkt).
;;
;; Where the derivatives of f have no inverse x is not determined; their determinant is 0 then.

(require "inverse-formula.rkt"
         "../error/failure.rkt"
         "../generic/describe.rkt" "../generic/on-demand.rkt"
         "../hamiltonian/equation-solver.rkt"
         "../value/shape.rkt" "../value/simplify.rkt")

(require-on-demand ["../search/implicit-root.rkt" plain])

(provide mixed-variable-solver solution-at)

;; who : complains; unknowns, data : strings, the unknowns follow from the data
;; f : given, x -> value
;; no-formula : called where there is no formula, by callers who need one; or #f
(define (mixed-variable-solver who unknowns data f [no-formula #f])
  (define (find-formula value slopes x y) (solution-formula value y (scalars x)))
  (define (by-numbers s given like y)
    (if no-formula
        (no-formula)
        (solution-by-numbers s unknowns given y (plain like) #:of (format "~a: " data))))
  (make-solver who f find-formula by-numbers
               (lambda (M e) (raise-not-determined who unknowns data M e))))

(define (raise-not-determined who unknowns data M e)
  (raise-without-inverse
   who
   (format (string-append "it generates no transformation: the ~a do not follow from ~a"
                          "\n  the determinant of the mixed second derivatives is 0"
                          "\n  mixed second derivatives: ~a")
           unknowns data (value->text (simplify M)))
   M
   (exn:fail:mechanics:singular:matrix-null-vectors e)
   e))
