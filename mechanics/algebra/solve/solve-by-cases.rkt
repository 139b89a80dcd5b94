#lang racket/base
;; Equations with absolute values and signs of unknowns, case by case.
;;
;; √(u²) is |u|, which is u on one side of u = 0 and −u on the other: each side is solved by itself,
;; and a solution counts where it is on that side.  If that depends on parameters, or on unknowns
;; that may be anything, it is a condition.  So √((x − 1)²) + √((x + 1)²) is constant between −1 and
;; 1, under two conditions on x.
;;
;; A solution counts if the equations have values there.  A condition e ≥ 0 is e > 0 if they have
;; none, or the solution has none, where e is 0.

(require racket/list
         "factors.rkt" "nonzero-conditions.rkt" "solve-equations.rkt"
         "../assumption/assumption-set.rkt" "../assumption/domain.rkt"
         (only-in "../assumption/signs.rkt" signs-within? zero)
         "../expression/constant-value.rkt" "../expression/expression.rkt"
         "../expression/nodes.rkt" "../expression/operation.rkt"
         "../expression/substitute.rkt" "../expression/symbols.rkt"
         "../simplify/declare-relations.rkt" "../simplify/known-sign.rkt"
         "../simplify/simplify-expression.rkt"
         "../../error/refusal.rkt" (only-in "../../numeric/finite-number.rkt" exact-rational?))

(provide solve-by-cases)

;; As solve-equations; a condition may be (> e 0) as well.
(define (solve-by-cases equations unknowns A)
  (define strict (with-automatic-assumptions A #f))
  (define plain (for/list ([e (in-list equations)]) (simplify-expression e strict)))
  (define found
    (if (signed-part plain unknowns)
        (solve-sides plain unknowns A '() most-cases)
        (solve-equations equations unknowns A)))
  (and found
       (remove-duplicates
        (for*/list ([s (in-list found)] #:when (all-valued? plain (car s) strict))
          (cons (car s)
                (for/list ([c (in-list (cdr s))]) (strict-condition c plain (car s) strict)))))))

;; ---------------------------------------------------------------------------
;; Sides

;; So many absolute values are taken apart, one after another.
(define most-cases 4)

;; A : with the relations of the sides chosen; sides : ((u . 1 or -1) ...), those
;; -> solutions, or #f
(define (solve-sides equations unknowns A sides left)
  (define u (signed-part equations unknowns))
  (cond [(not u)
         (define found (solve-equations equations unknowns A))
         (and found (append-map (lambda (s) (on-sides s sides A)) found))]
        [(eqv? left 0) #f]
        [else
         (define found
           (for/list ([side (in-list '(1 -1))])
             (with-handlers ([exn:algebra:contradiction? (lambda (x) '())])
               (define B (declare-relations A (list (positive (e:* side u) no-assumptions))))
               (solve-sides (on-side equations u side B) unknowns B
                            (cons (cons u side) sides) (- left 1)))))
         (and (andmap values found) (append* found))]))

;; An argument of |·| or sgn in which an unknown occurs and no other such, or #f
(define (signed-part equations unknowns)
  (define (signed? n) (or (headed? n op:abs) (headed? n op:sgn)))
  (define (varies? e) (ormap (lambda (x) (occurs? x e)) unknowns))
  (for*/first ([e (in-list equations)]
               [n (in-list (if (node? e) (nodes-in e) '()))]
               #:when (and (signed? n) (varies? n)))
    (car (node-args n))))

(define (on-side equations u side A)
  (for/list ([e (in-list equations)])
    (simplify-expression (with-sign e u side) (with-automatic-assumptions A #f))))

;; -> a list of the solution with conditions for it to be on the sides, or of none; on the border of
;; a side it may count
(define (on-sides s sides A)
  (define conditions
    (for/list ([side (in-list sides)])
      (define u (substitute-expression (car side) (car s)))
      (define e (simplify-expression (e:* (cdr side) u) no-assumptions))
      (define sign (constant-sign e))
      (cond [(not sign) (list (list '> e 0))]
            [(< sign 0) #f]
            [else '()])))
  (if (andmap values conditions)
      (list (cons (car s) (append* (cdr s) conditions)))
      '()))

(define (constant-sign e)
  (define x (if (real? e) e (constant-value e)))
  (cond [(not (real? x)) (known-sign e no-assumptions)]
        [(< (abs x) rounding) 0]
        [else (if (> x 0) 1 -1)]))

(define rounding 1e-14)

;; ---------------------------------------------------------------------------
;; Where there are values

(define (all-valued? equations solution A)
  (for/and ([e (in-list equations)])
    (define there
      (if-raised divided-by-zero? #f
        (simplify-expression (substitute-expression e solution) A)))
    (and there
         (not (and (exact-rational? there) (not (eqv? there 0))))
         (not (some-node? (lambda (n) (eqv? 0 (divisor-of n))) there)))))

(define (strict-condition c equations solution A)
  (define e (cadr c))
  (define (barred? u) (member u (barred-factors equations solution A)))
  (if (and (eq? (car c) '>=) (symbolic? e) (ormap barred? (vanishing-factors e A)))
      (list '> e 0)
      c))

;; Factors that may not be 0 if the solution, and the equations there, are to have values
(define (barred-factors equations solution A)
  (for*/list ([e (in-list (append (map cdr solution) equations))]
              [n (in-list (if (node? e) (nodes-in e) '()))]
              [r (in-list (node-relations n))]
              #:unless (signs-within? zero (relation-signs r))
              [f (in-list (bases (substitute-expression (relation-expression r) solution) A))])
    f))

;; The factors of e; of a root, a power or |·| those of its argument
(define (bases e A)
  (for*/list ([f (in-list (if (symbolic? e) (vanishing-factors e A) '()))]
              [g (in-list (if (and (node? f) (memq (node-head f) (list op:sqrt op:abs op:expt)))
                              (bases (car (node-args f)) A)
                              (list f)))])
    g))
