#lang racket/base
;; Unknowns from equations f(x) = y: how generating functions are taken at their word.
;;
;; How to find x is settled once, at symbols, for all arguments of a shape:
;;
;;   exactly     where f is of degree 1 in x
;;   by formula  where the equations can be solved (algebra/rewriting/solve.rkt)
;;               of which a root that holds the unknown may go by squaring
;;   by numbers  elsewhere, by Newton's method; derivatives are those of the inverse function
;;
;; Where the derivatives of f have no inverse the x is not determined, and the determinant says
;; so.

(require racket/list
         "../algebra/expression/constant-value.rkt" "../algebra/expression/expression.rkt"
         "../algebra/expression/operation.rkt" "../algebra/expression/substitute.rkt"
         "../algebra/expression/symbols.rkt"
         "../calculus/derivative.rkt"
         "../error/complain.rkt" "../error/failure.rkt" "../error/refusal.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/on-demand.rkt"
         "../generic/up-down.rkt"
         "../value/assumptions.rkt" "../value/shape.rkt" "../value/simplify.rkt"
         "../value/structure.rkt" "../value/symbols-like.rkt"
         "../value/linear/linear-algebra.rkt")

(require-on-demand
 ["../algebra/rewriting/solve.rkt" solve-equations]
 ["../calculus/expression-function.rkt" evaluate-generically]
 ["../hamiltonian/velocity-formula.rkt" without-root]
 ["../search/find-root.rkt" find-root]
 ["../search/implicit.rkt" plain])

(provide make-solver solution-at)

;; who : complains, of unknowns that are to follow from data, two strings
;; f : given, x -> value;  known : way or #f
(struct solver (who unknowns data f [known #:mutable]) #:authentic)
(struct way (shape how declared) #:authentic)
(struct formula (given y x) #:authentic)

(define (make-solver who unknowns data f) (solver who unknowns data f #f))

;; The x of the shape `like` with f(given, x) = y
(define (solution-at s given like y)
  (define how (how-to s given like y))
  (define (f x) ((solver-f s) given x))
  (cond [(eq? how 'exactly) (linear-solution s f like y)]
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

(define (free-of? x names)
  (not (for*/or ([e (in-list (scalars x))] [name (in-list names)])
         (and (expression? e) (occurs? name e)))))

;; Of several solutions the one that leads back to a positive x, or else the first one.
(define (find-formula values place x target)
  (define unknowns (scalars x))
  (define equations (map g:- (scalars values) (scalars target)))
  (define good? (leads-back? values unknowns target))
  (define complete (complete-solutions equations unknowns))
  (define chosen
    (or (findf good? complete)
        (and (pair? complete) (car complete))
        (findf good? (complete-solutions (map (rootless unknowns) equations) unknowns))))
  (and chosen
       (formula place target (scalars->structure x (lambda (k) (list-ref chosen k))))))

;; -> lists of expressions for the unknowns
(define (complete-solutions equations unknowns)
  (define found
    (and (andmap values equations)
         (parameterize ([automatic-assumptions #f])
           (solve-equations equations unknowns (assumptions-in-force)))))
  (for*/list ([solution (in-list (or found '()))]
              #:when (for/and ([u (in-list unknowns)]) (assq u (car solution))))
    (smoothed (for/list ([u (in-list unknowns)]) (cdr (assq u (car solution))))
              unknowns equations)))

;; What is squared has more solutions; those that lead back are solutions where signs are as
;; there.
(define ((rootless unknowns) e)
  (define involved (filter (lambda (u) (occurs? u e)) unknowns))
  (and (pair? involved)
       (null? (cdr involved))
       (parameterize ([automatic-assumptions #f])
         (without-root e (car involved) (string->uninterned-symbol "R")))))

;; Roots of squares come as |u|: the two of them are solutions together, and so is one with u
;; for |u|, which has no kink.
(define (smoothed xs unknowns equations)
  (define smooth (map without-absolute-values xs))
  (define (solves? e)
    (eqv? 0 (simplify-strictly (substitute-expression e (map cons unknowns smooth)))))
  (if (andmap solves? equations) smooth xs))

(define (without-absolute-values e)
  (node-fold e
             (lambda (leaf) leaf)
             (lambda (n parts)
               (if (eq? (node-head n) op:abs) (car parts) (apply e:apply (node-head n) parts)))))

;; Does the solution give x again for y = f(x), at one point with positive x and parameters?
(define ((leads-back? values unknowns target) xs)
  (define ys (scalars target))
  (define names (remove-duplicates (append unknowns (append-map symbols-of (scalars values))
                                           (remove* ys (append-map symbols-of xs)))))
  (define point (for/list ([s (in-list names)] [k (in-naturals)]) (cons s (/ (+ 3 k) (+ 5 k)))))
  (define (number-at e p) (constant-value (substitute-expression e p)))
  (define images (for/list ([e (in-list (scalars values))]) (number-at e point)))
  (and (andmap real? images)
       (let ([back (append (map cons ys images) point)])
         (for/and ([e (in-list xs)] [u (in-list unknowns)])
           (define x (number-at e back))
           (and x (< (abs (- x (cdr (assq u point)))) 1e-9))))))

(define (symbols-of e) (if (expression? e) (symbols-in e) '()))

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
