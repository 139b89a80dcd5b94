#lang racket/base
;; Unknowns from equations f(x) = y, as generating functions give them.
;;
;; How to find x is settled once, at symbols, for all arguments of a shape:
;;
;;   exactly     where f is of degree 1 in x
;;   by formula  where the equations can be solved (solution-formula.rkt)
;;   by numbers  elsewhere, by Newton's method; derivatives are those of the inverse function
;;
;; Where the derivatives of f have no inverse x is not determined; their determinant is 0 then.

(require "solution-formula.rkt"
         "../calculus/derivative.rkt"
         "../error/failure.rkt" "../error/refusal.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/on-demand.rkt"
         "../hamiltonian/unknowns-by-numbers.rkt"
         "../value/by-shape.rkt" "../value/shape.rkt"
         "../value/simplify.rkt"
         "../value/structure.rkt"
         "../value/matrix/linear-algebra.rkt")

(require-on-demand
 ["../calculus/expression-function.rkt" evaluate-at]
 ["../search/implicit-root.rkt" plain])

(provide make-solver solution-at)

;; who : complains; unknowns, data : strings, the unknowns follow from the data
;; f : given, x -> value
;; no-formula : called where there is no formula, by callers who need one; or #f
;; how : (up given like y) -> 'exactly, 'by-numbers or a formula
(struct solver (who unknowns data f no-formula how) #:authentic)

;; place : (up given y) of symbols; x : the unknowns in terms of these
(struct formula (place x) #:authentic)

(define (make-solver who unknowns data f [no-formula #f])
  (define s
    (solver who unknowns data f no-formula
            (by-shape (lambda (all) (settle s (ref all 0) (ref all 1) (ref all 2))))))
  s)

;; The x of the shape `like` with f(given, x) = y
(define (solution-at s given like y)
  (define how ((solver-how s) (up given like y)))
  (define (f x) ((solver-f s) given x))
  (cond [(eq? how 'exactly) (linear-solution s f like y)]
        [(and (eq? how 'by-numbers) (solver-no-formula s)) ((solver-no-formula s))]
        [(eq? how 'by-numbers)
         (unknowns-by-numbers (solver-who s) (solver-unknowns s) f y (plain like)
                              #:of (format "~a: " (solver-data s)))]
        [else (evaluate-at (formula-x how) (formula-place how) (up given y))]))

;; ---------------------------------------------------------------------------
;; Settling the way

(define (settle s given like y)
  (define-values (place x target)
    (values (symbols-like given "g") (symbols-like like "x") (symbols-like y "y")))
  (define (f x) ((solver-f s) place x))
  (define equations
    (with-handlers ([raised? (lambda (e) #f)]) (cons (f x) (derivative-at f x))))
  (cond [(not equations) 'by-numbers]
        [else
         (define slopes (simplify-strictly (cdr equations)))
         (check-determinant s slopes like)
         (if (free-of? slopes (scalars x))
             'exactly
             (or (find-formula (car equations) place x target) 'by-numbers))]))

(define (find-formula values place x target)
  (define found (solution-formula values target (scalars x)))
  (and found (formula (up place target) (list->structure x found))))

;; ---------------------------------------------------------------------------
;; The ways

(define (linear-solution s f like y)
  (define zero (zero-like like))
  (solved s (derivative-at f zero) (g:- y (f zero)) like))

;; ---------------------------------------------------------------------------
;; Failures

(define (solved s M y like)
  (with-handlers ([exn:fail:mechanics:singular:matrix?
                   (lambda (e) (raise-not-determined s M e))])
    (list->structure like (scalars (solve-linear-left M y)))))

;; slopes : at symbols
(define (check-determinant s slopes like)
  (define d (with-handlers ([raised? (lambda (e) 1)]) (simplify-strictly (determinant slopes))))
  (when (eqv? d 0) (raise-not-determined s slopes #f)))

(define (raise-not-determined s M e)
  (raise-without-inverse
   (solver-who s)
   (format (string-append "it generates no transformation: the ~a do not follow from ~a"
                          "\n  the determinant of the mixed second derivatives is 0"
                          "\n  mixed second derivatives: ~a")
           (solver-unknowns s) (solver-data s) (value->text (simplify M)))
   M
   (and e (exn:fail:mechanics:singular:matrix-null-vectors e))
   e))
