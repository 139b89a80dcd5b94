#lang racket/base
;; Unknowns x from equations f(given, x) = y, as Legendre transforms and generating functions have
;; them.
;;
;; How to find x is settled once, at symbols, for all arguments of a shape:
;;
;;   exactly     where f is of degree 1 in x: M x = y − f(0), with the derivatives M
;;   by formula  where the equations can be solved
;;   by numbers  elsewhere, by Newton's method; the derivatives of x are those of the inverse
;;               function
;;
;; Where M has no inverse x is not determined.

(require "../algebra/expression/symbols.rkt"
         "../calculus/derivative.rkt"
         "../error/complain.rkt" "../error/failure.rkt" "../error/refusal.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/on-demand.rkt"
         "../generic/up-down.rkt"
         "../value/shape.rkt" "../value/simplify.rkt"
         "../value/structure.rkt"
         "../value/matrix/linear-algebra.rkt")

(require-on-demand
 ["../calculus/expression-function.rkt" evaluate-at]
 ["../search/find-root.rkt" find-root]
 ["../search/implicit-root.rkt" plain])

(provide make-solver solution-at solved-exactly? linear-solution linear-equations solved
         solution-by-numbers raise-none-found)

;; who : complains
;; f : given, x -> value
;; find-formula : f(x), its derivatives, x, y, of symbols -> expressions for x, or #f
;; by-numbers : solver, given, like, y -> x
;; raise-singular : M, exception -> raises
;; how : (up given like y) -> 'exactly, 'by-numbers or a formula, which may rest on declared
;; assumptions
(struct solver (who f find-formula by-numbers raise-singular how) #:authentic)

(define (make-solver who f find-formula by-numbers raise-singular)
  (define s
    (solver who f find-formula by-numbers raise-singular
            (by-shape (lambda (all) (settle s (ref all 0) (ref all 1) (ref all 2)))
                      #:lasting? (lambda (how) (eq? how 'exactly)))))
  s)

;; The x of the shape `like` with f(given, x) = y
(define (solution-at s given like y)
  (define how (how-to s given like y))
  (case how
    [(exactly) (linear-solution s given like y)]
    [(by-numbers) ((solver-by-numbers s) s given like y)]
    [else (evaluate-at (formula-x how) (formula-place how) (up given y))]))

(define (how-to s given like y) ((solver-how s) (up given like y)))
(define (solved-exactly? s given like y) (eq? (how-to s given like y) 'exactly))

;; -> M and y − f(0)
(define (linear-equations s given like y)
  (define (f x) ((solver-f s) given x))
  (define zero (zero-like like))
  (values (derivative-at f zero) (g:- y (f zero))))

(define (linear-solution s given like y)
  (define-values (M push) (linear-equations s given like y))
  (list->structure like (scalars (solved s M push))))

(define (solved s M y)
  (with-handlers ([exn:fail:mechanics:singular:matrix?
                   (lambda (e) ((solver-raise-singular s) M e))])
    (solve-linear-left M y)))

;; ---------------------------------------------------------------------------
;; Settling the way

;; place : (up given y) of symbols; x : the unknowns in terms of these
(struct formula (place x) #:authentic)

;; f may fail at symbols; then x is found by numbers.
(define (settle s given like y)
  (define-values (place x target)
    (values (symbols-like given "q") (symbols-like like "v") (symbols-like y "w")))
  (define (f x) ((solver-f s) place x))
  (define-values (value slopes)
    (if-raised raised? (values #f #f) (values (f x) (derivative-at f x))))
  (cond [(not value) 'by-numbers]
        [(independent? slopes x) 'exactly]
        [else
         (solved s slopes target)
         (define found ((solver-find-formula s) value slopes x target))
         (if found (formula (up place target) (list->structure x found)) 'by-numbers)]))

;; Often it is seen before they are simplified that slopes do not depend on x; to simplify must
;; not take for granted that x is positive, as in the root of x².
(define (independent? slopes x)
  (define (free? slopes)
    (not (for*/or ([e (in-list (scalars slopes))] [name (in-list (scalars x))]) (occurs? name e))))
  (or (free? slopes) (free? (simplify-strictly slopes))))

;; ---------------------------------------------------------------------------
;; By numbers

;; unknowns : their name, such as "velocities"; of : the values they follow from, if that is said
(define (solution-by-numbers s unknowns given y start #:of [of ""])
  (define who (solver-who s))
  (define (f x) ((solver-f s) given x))
  (for ([x (in-list (scalars (plain (up y (f start) start))))])
    (unless (number? x) (raise-no-formula who unknowns x)))
  (with-handlers ([exn:fail:mechanics:not-convergent?
                   (lambda (e)
                     (raise-none-found who unknowns y
                                       (exn:fail:mechanics:not-convergent-value e)
                                       (exn:fail:mechanics:not-convergent-error-estimate e)
                                       #:of of))])
    (find-root (lambda (x) (g:- (f x) y)) start)))

(define (raise-no-formula who unknowns x)
  (complain who
            (string-append "no formula was found for the ~a, and numbers are not found with "
                           "symbols left\n  one of them: ~a"
                           "\n  give the parameters and the state as numbers")
            unknowns (value->text x)))

(define (raise-none-found who unknowns y reached estimate #:of [of ""])
  (raise-not-convergent who
                        (format "no ~a were found for ~a~a" unknowns of (value->text (plain y)))
                        reached estimate #:show? #f))
