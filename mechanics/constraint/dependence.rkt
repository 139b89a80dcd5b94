#lang racket/base
;; Constraints that depend on each other, and directions without inertia: why a motion or
;; its multipliers are not determined, in words.

(require "../error/failure.rkt" "../error/message-words.rkt"
         "../generic/arithmetic.rkt" "../generic/up-down.rkt"
         "../value/simplify.rkt"
         "../value/matrix/row-systems.rkt"
         (only-in "../value/matrix/singular-matrix.rkt" last-by-others))

(provide raise-undetermined independent-rows dependences dependences->text)

;; J : list of rows of the Jacobian; e : the failure
(define (raise-undetermined who J e)
  (define found (dependences who J))
  (raise-without-inverse
   who
   (if (pair? found)
       (string-append "the constraints are redundant; their multipliers are not determined"
                      (dependences->text found))
       (string-append "the mass matrix and the constraints do not determine the accelerations"
                      "\n  a motion that the constraints allow has no inertia"))
   (exn:fail:mechanics:singular-where e)
   (map up-of found)
   e))

;; A basis of the y with Σ yⱼ (row j) = 0, vectors; empty if elimination fails.
(define (dependences who J)
  (with-handlers ([exn:fail:mechanics? (lambda (e) '())])
    (rows-null-space who J (rows-transpose (list->vector J)))))

(define (dependences->text ys)
  (joined (for/list ([y (in-list ys)]) (format "\n  ~a" (dependence->text y))) ""))

;; The last constraint in the dependence y, as a combination of the others.
(define (dependence->text y)
  (define-values (end others)
    (last-by-others y "constraint" (lambda (a b) (readable (simplify (g:negate (g:/ a b)))))))
  (format "constraint ~a demands ~a" end
          (if others
              (string-append "the same as " others)
              "nothing here: its derivatives by the coordinates are zero")))

;; Without the last digits of a flonum, which are those of rounding.
(define (readable x)
  (if (and (real? x) (inexact? x)) (/ (round (* x 1e12)) 1e12) x))

;; The indices of rows that together demand as much as all of them, the first ones first.
(define (independent-rows who J)
  (for/fold ([kept '()] [rank 0] #:result (reverse kept)) ([k (in-range (length J))])
    (define with-it
      (rows-rank who J (list->vector (for/list ([i (in-list (cons k kept))]) (list-ref J i)))))
    (if (> with-it rank) (values (cons k kept) with-it) (values kept rank))))
