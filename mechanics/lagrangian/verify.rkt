#lang racket/base
;; Does a proposed path solve Lagrange's equations?

(require "Lagrange-equations.rkt" "local-tuple.rkt" "../calculus/verdict.rkt")

(provide verify-solution)

;; The verdict on the residual of the path q at a symbolic time t.
(define (verify-solution L q #:force [Q #f] #:order [n 1])
  (with-handlers ([exn:fail:contract? (lambda (e) (raise (if (swapped? L q) (swap-error) e)))])
    (prove-zero ((Lagrange-equations L #:force Q #:order n) q))))

;; Would the arguments do in the other order?  Asked only when they fail in this.
(define (swapped? L q)
  (define (works? thunk) (with-handlers ([exn:fail? (lambda (e) #f)]) (thunk) #t))
  (and (procedure? L) (procedure? q)
       (not (works? (lambda () (q 't))))
       (works? (lambda () ((scalar-valued 'verify-solution q) ((Gamma L) 't))))))

(define (swap-error)
  (exn:fail:contract
   "verify-solution: the Lagrangian comes first, then the path; these look swapped"
   (current-continuation-marks)))
