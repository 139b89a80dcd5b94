#lang racket/base
;; A formula for the unknowns of equations f(x) = y: of several solutions the one that leads back
;; to a positive x, or else the first one.
;;
;; A root that holds the unknown may go by squaring; of the results then only one that leads back is
;; a solution.  An angle (atan b a) = θ is two equations of degree 1, b = ρ sin θ and a = ρ cos θ,
;; with one more unknown: so rectangular coordinates follow from polar ones.

(require racket/list
         "../algebra/expression/constant-value.rkt" "../algebra/expression/expression.rkt"
         "../algebra/expression/operation.rkt" "../algebra/expression/substitute.rkt"
         "../algebra/expression/symbols.rkt"
         "../generic/arithmetic.rkt" "../generic/elementary.rkt" "../generic/on-demand.rkt"
         "../value/assumptions.rkt" "../value/shape.rkt" "../value/simplify.rkt")

(require-on-demand
 ["../algebra/solve/solve-equations.rkt" solve-equations]
 ["../hamiltonian/velocity-formula.rkt" without-root])

(provide solution-formula)

;; values, target : structures; unknowns : symbols
;; -> expressions of the unknowns, or #f
(define (solution-formula values target unknowns)
  (define equations (map g:- (scalars values) (scalars target)))
  (define good? (leads-back? values unknowns target))
  (define complete (complete-solutions equations unknowns))
  (or (findf good? complete)
      (and (pair? complete) (car complete))
      (findf good? (complete-solutions (map (rootless unknowns) equations) unknowns))
      (findf good? (solutions-by-angle values target unknowns))))

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

;; The equations of angles come first, for their solutions make the others simple; the ρ are left
;; out of the result.
(define (solutions-by-angle images target unknowns)
  (define-values (angles others)
    (partition (lambda (pair) (angle? (car pair))) (map cons (scalars images) (scalars target))))
  (define radii (for/list ([_ (in-list angles)]) (string->uninterned-symbol "rho")))
  (define equations
    (append (append-map polar-equations angles radii)
            (for/list ([o (in-list others)]) (g:- (car o) (cdr o)))))
  (if (null? angles)
      '()
      (for/list ([found (in-list (call-assuming
                                  (for/list ([rho (in-list radii)]) `(>= ,rho 0))
                                  (lambda ()
                                    (complete-solutions equations (append unknowns radii)))))])
        (take found (length unknowns)))))

;; ((atan b a) . θ) and ρ -> a − ρ cos θ and b − ρ sin θ
(define (polar-equations angle rho)
  (define-values (b a) (apply values (node-args (car angle))))
  (list (g:- a (g:* rho (g:cos (cdr angle)))) (g:- b (g:* rho (g:sin (cdr angle))))))

(define (angle? e)
  (and (headed? e op:atan)
       (= (length (node-args e)) 2)))

;; Squaring adds solutions; those that lead back (leads-back?) are solutions where signs are
;; as at its point.
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
  (define names (remove-duplicates (append unknowns (append-map symbols-in (scalars values))
                                           (remove* ys (append-map symbols-in xs)))))
  (define point (for/list ([s (in-list names)] [k (in-naturals)]) (cons s (/ (+ 3 k) (+ 5 k)))))
  (define (number-at e p) (constant-value (substitute-expression e p)))
  (define images (for/list ([e (in-list (scalars values))]) (number-at e point)))
  (and (andmap real? images)
       (let ([back (append (map cons ys images) point)])
         (for/and ([e (in-list xs)] [u (in-list unknowns)])
           (define x (number-at e back))
           (and x (< (abs (- x (cdr (assq u point)))) 1e-9))))))
