#lang racket/base
;; Equations in several unknowns, where formulas are short: one equation after
;; another is factored, a factor solved for an unknown, and the solution put into
;; the others.
;;
;; A factor is solved if it is linear in an unknown, with a coefficient in which no
;; unknown occurs; and, if there is one unknown only, when it is a quadratic polynomial, in
;; the unknown, in a power of it or in an exponential of a x + b, or one of degree 1 in the
;; sine and the cosine of one angle a x + b, or such a one when a square root is squared away.
;; Of angles all solutions within a turn of x are given if a is a whole number, else those within
;; a turn of the angle; exactly: multiples of :pi are.
;;
;; Parameters are at a generic point: expressions in them are not zero.  Conditions for
;; solutions to be real are kept with them.

(require racket/list
         "angle-roots.rkt" "exponential-roots.rkt" "factors.rkt" "power-roots.rkt"
         "radical-roots.rkt" "root.rkt"
         "../expression/constant-value.rkt" "../expression/expression.rkt"
         (only-in "../expression/operation.rkt" op:exp) "../expression/pi.rkt"
         "../expression/substitute.rkt" "../expression/symbols.rkt"
         "../simplify/simplify-expression.rkt")

(provide solve-equations)

;; equations : expressions that are to vanish; unknowns : symbols; A : assumptions
;; -> a list of solutions (((unknown . expression) ...) condition ...), where an unknown
;; that is left out may be anything; #f if one of the equations cannot be solved.
;; A condition is (<= -1 e 1) or (>= e 0); solutions without come first.
(define (solve-equations equations unknowns A)
  (define flonums? (ormap (lambda (e) (some-leaf? flonum? e)) equations))
  (let/ec return
    (unconditional-first
     (let solve ([equations equations] [found '()] [conditions '()])
       (define open (open-equations equations A))
       (define (involved e) (filter (lambda (x) (occurs? x e)) unknowns))
       (cond [(null? open) (list (cons (in-order found unknowns flonums?) conditions))]
             [(ormap (lambda (e) (null? (involved e))) open) '()]
             [else
              (define e (simplest open involved))
              (for*/list ([root (in-list (or (roots-of e involved A) (return #f)))]
                          #:when (value-at e (root-x root) (root-value root) A)
                          [solution (in-list (solve (replaced (remq e open) root)
                                                    (extended found root A)
                                                    (append conditions (root-conditions root))))])
                solution)])))))

;; The roots of all factors, or else of the whole: x⁵ + 1 has a factor of degree 4.
(define (roots-of e involved A)
  (define of-factors
    (for*/list ([f (in-list (vanishing-factors e A))]
                [xs (in-value (involved f))]
                #:when (pair? xs))
      (solve-factor f xs A)))
  (define xs (involved e))
  (if (memq #f of-factors)
      (and (null? (cdr xs)) (power-roots e (car xs) A))
      (append* of-factors)))

;; -> roots, or #f
(define (solve-factor f xs A)
  (define (linear x) (linear-root f x xs A))
  (define root (ormap linear xs))
  (cond [root (list root)]
        [(headed? f op:exp) '()]
        [(pair? (cdr xs)) #f]
        [else (or (quadratic-roots f (car xs) A)
                  (power-roots f (car xs) A)
                  (angle-roots f (car xs) A)
                  (exponential-roots f (car xs) A)
                  (radical-roots f (car xs) A (lambda (g) (solve-factor g xs A))))]))

(define (open-equations equations A)
  (remv* '(0) (for/list ([e (in-list equations)]) (simplify-expression e A))))

;; The equation with the fewest unknowns.
(define (simplest equations involved)
  (argmin (lambda (e) (length (involved e))) equations))

(define (replaced equations r)
  (define replacements (cons (cons (root-x r) (root-value r)) (root-waves r)))
  (for/list ([e (in-list equations)]) (substitute-expression e replacements)))

(define (extended found r A)
  (cons (cons (root-x r) (root-value r))
        (for/list ([entry (in-list found)])
          (cons (car entry)
                (simplify-expression (put (cdr entry) (root-x r) (root-value r)) A)))))

;; Factors of expressions with flonums have whole numbers: in the end, a quotient of these is a
;; flonum, and so is an angle of which that is the cosine.
(define (in-order found unknowns flonums?)
  (define (presented e)
    (if (and flonums? (not (integer? e)) (not (pi-turns? e))) (or (constant-value e) e) e))
  (for*/list ([x (in-list unknowns)] [entry (in-value (assq x found))] #:when entry)
    (cons x (presented (cdr entry)))))

;; Is e a rational multiple of π?
(define (pi-turns? e) (and (symbolic? e) (number? (simplify-expression (e:/ e exact-pi)))))

;; Each once.
(define (unconditional-first solutions)
  (define-values (conditional others)
    (partition (lambda (s) (pair? (cdr s))) (remove-duplicates solutions)))
  (append others conditional))
