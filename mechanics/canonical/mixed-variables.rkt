#lang racket/base
;; Unknowns from equations f(x) = y: how generating functions are taken at their word.
;;
;; How to find x is settled once, at symbols, for all arguments of a shape:
;;
;;   exactly     where f is of degree 1 in x
;;   by formula  where the equations can be solved (solution-formula.rkt)
;;   by numbers  elsewhere, by Newton's method; derivatives are those of the inverse function
;;
;; Where the derivatives of f have no inverse the x is not determined, and the determinant says
;; so.

(require "solution-formula.rkt"
         "../algebra/expression/expression.rkt" "../algebra/expression/symbols.rkt"
         "../calculus/derivative.rkt"
         "../error/complain.rkt" "../error/failure.rkt" "../error/refusal.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/on-demand.rkt"
         "../generic/up-down.rkt"
         "../value/assumptions.rkt" "../value/shape.rkt" "../value/simplify.rkt"
         "../value/structure.rkt" "../value/symbols-like.rkt"
         "../value/matrix/linear-algebra.rkt")

(require-on-demand
 ["../calculus/expression-function.rkt" evaluate-generically]
 ["../search/find-root.rkt" find-root]
 ["../search/implicit-root.rkt" plain])

(provide make-solver solution-at)

;; who : complains, of unknowns that are to follow from data, two strings
;; f : given, x -> value;  no-formula : -> an error of those who can use none but formulas, or #f
;; known : way or #f
(struct solver (who unknowns data f no-formula [known #:mutable]) #:authentic)
(struct way (shape how declared) #:authentic)
(struct formula (given y x) #:authentic)

(define (make-solver who unknowns data f [no-formula #f])
  (solver who unknowns data f no-formula #f))

;; The x of the shape `like` with f(given, x) = y
(define (solution-at s given like y)
  (define how (how-to s given like y))
  (define (f x) ((solver-f s) given x))
  (cond [(eq? how 'exactly) (linear-solution s f like y)]
        [(and (eq? how 'by-numbers) (solver-no-formula s)) ((solver-no-formula s))]
        [(eq? how 'by-numbers) (numeric-solution s f like y)]
        [else (formula-at how given y)]))

;; ---------------------------------------------------------------------------
;; Settling the way

(define (how-to s given like y)
  (define shape (up given like y))
  (define known (solver-known s))
  (cond [(and known (same-shape? shape (way-shape known))
              (equal? (way-declared known) (assumptions 'declared)))
         (way-how known)]
        [else
         (define how (settle s given like y))
         (set-solver-known! s (way shape how (assumptions 'declared)))
         how]))

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
  (and found
       (formula place target (scalars->structure x (lambda (k) (list-ref found k))))))

(define (free-of? x names)
  (not (for*/or ([e (in-list (scalars x))] [name (in-list names)])
         (and (expression? e) (occurs? name e)))))

;; ---------------------------------------------------------------------------
;; The ways

(define (linear-solution s f like y)
  (define zero (scalars->structure like (lambda (k) 0)))
  (solved s (derivative-at f zero) (g:- y (f zero)) like))

(define (formula-at found given y)
  (define point
    (map cons
         (append (scalars (formula-given found)) (scalars (formula-y found)))
         (append (scalars given) (scalars y))))
  (define xs (scalars (formula-x found)))
  (scalars->structure (formula-x found)
                      (lambda (k) (evaluate-generically (list-ref xs k) point))))

(define (numeric-solution s f like y)
  (define start (plain like))
  (for ([x (in-list (append (scalars start) (scalars (plain y)) (scalars (plain (f start)))))])
    (unless (number? x) (raise-no-formula s x)))
  (with-handlers ([exn:fail:mechanics:not-convergent? (lambda (e) (raise-none-found s y e))])
    (find-root (lambda (x) (g:- (f x) y)) start)))

;; ---------------------------------------------------------------------------
;; Failures

(define (solved s M y like)
  (with-handlers ([exn:fail:mechanics:singular:matrix?
                   (lambda (e) (raise-not-determined s M e))])
    (define x (solve-linear-left M y))
    (scalars->structure like (let ([xs (scalars x)]) (lambda (k) (list-ref xs k))))))

;; slopes : at symbols
(define (check-determinant s slopes like)
  (define d (with-handlers ([raised? (lambda (e) 1)]) (simplify-strictly (determinant slopes))))
  (when (eqv? d 0) (raise-not-determined s slopes #f)))

(define (raise-not-determined s M e)
  (raise-without-inverse
   (solver-who s)
   (format (string-append "it generates no transformation: ~a do not follow from ~a"
                          "\n  the determinant of the mixed second derivatives is 0"
                          "\n  mixed second derivatives: ~a")
           (solver-unknowns s) (solver-data s) (value->text (simplify M)))
   M
   (and e (exn:fail:mechanics:singular:matrix-null-vectors e))
   e))

(define (raise-no-formula s x)
  (complain (solver-who s)
            (string-append "no formula was found for ~a, and numbers are not found with symbols "
                           "left\n  one of them: ~a"
                           "\n  give the parameters and the state as numbers")
            (solver-unknowns s) (value->text x)))

(define (raise-none-found s y e)
  (raise-not-convergent (solver-who s)
                        (format "no ~a were found for ~a: ~a" (solver-unknowns s)
                                (solver-data s) (value->text (plain y)))
                        (exn:fail:mechanics:not-convergent-value e)
                        (exn:fail:mechanics:not-convergent-error-estimate e)
                        #:show? #f))
