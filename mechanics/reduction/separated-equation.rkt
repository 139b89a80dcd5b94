#lang racket/base
;; Equations that fall apart: separation of variables, on expressions.
;;
;; Along a motion G(q, p) = 0, to begin with H − E.  A coordinate that does not occur has a constant
;; momentum.  Another separates if G, multiplied by something, is the sum of a part with its q
;; and p alone and a part without them: both are constants then, and the second, with the
;; constant in place of the first, is an equation for the others.  So on until one is left.
;;
;; Multipliers to try: 1; the inverse of the coefficient of p² of a coordinate, as 2mr² for an
;; angle; and the denominator of G, as ξ + η of parabolic coordinates.

(require racket/list
         "momentum-by-energy.rkt"
         "../algebra/expression/expression.rkt" "../algebra/expression/operation.rkt"
         "../algebra/expression/symbols.rkt"
         "../calculus/derivative.rkt" "../calculus/expression-function.rkt"
         "../generic/arithmetic.rkt" "../generic/sums-and-products.rkt"
         (only-in "../value/algebra.rkt" expand-expression numerator-and-denominator)
         "../value/assumptions.rkt" "../value/simplify.rkt")

(provide split denominator-of holds? equation-at (struct-out piece) (struct-out unsplit))

;; equation : an expression in q, p and constants, 0 along the motion; integral : an expression
;; in them that is equal to `constant`, or #f of the last one; cyclic? : is it p itself?
(struct piece (q p equation constant integral cyclic?) #:authentic)

;; The pieces found, and the rest: an equation in several (q . p)
(struct unsplit (pieces equation open) #:authentic)

;; G : an expression; qs, ps : symbols; (name q) : a symbol for a constant -> pieces or unsplit
(define (split G qs ps name)
  (let loop ([G (simplify-strictly G)] [open (map cons qs ps)] [found '()])
    (define cyclic (and (pair? (cdr open)) (findf (lambda (o) (not (holds? G (car o)))) open)))
    (cond [(null? (cdr open))
           (reverse (cons (piece (caar open) (cdar open) G #f #f #f) found))]
          [cyclic
           (define c (name (car cyclic)))
           (loop (simplify-strictly (with G (cdr cyclic) c))
                 (remq cyclic open)
                 (cons (piece (car cyclic) (cdr cyclic) (g:- (cdr cyclic) c) c (cdr cyclic) #t)
                       found))]
          [(parted G open)
           => (lambda (parts)
                (define-values (o own rest) (apply values parts))
                (define c (name (car o)))
                (loop (simplify-strictly (g:+ rest c)) (remq o open)
                      (cons (piece (car o) (cdr o) (g:- own c) c own #f) found)))]
          [else (unsplit (reverse found) G open)])))

(define (with e x value) (evaluate-generically e (list (cons x value))))

;; The equation of a piece, with a value in place of its momentum
(define (equation-at x p) (with (piece-equation x) (piece-p x) p))

;; -> (list (q . p) its-part the-rest), or #f
(define (parted G open)
  (or (parted-after G open 1)
      (for/or ([o (in-list open)])
        (define c (square-coefficient G (cdr o)))
        (and c (parted-after G (list o) (g:/ 1 c) open)))
      (parted-after G open (denominator-of G))))

;; Times f, for one of the candidates
(define (parted-after G candidates f [open candidates])
  (define terms (operands-of (expanded (g:* f G)) op:+))
  (for/or ([o (in-list candidates)])
    (define (of? pair t) (or (holds? t (car pair)) (holds? t (cdr pair))))
    (define-values (own rest) (partition (lambda (t) (of? o t)) terms))
    (and (ormap (lambda (t) (holds? t (cdr o))) own)
         (not (for*/or ([t (in-list own)] [x (in-list (remq o open))]) (of? x t)))
         (list o (sum own) (sum rest)))))

(define (sum terms) (simplify-strictly (g:for/sum ([t (in-list terms)]) t)))
(define (holds? e x) (and (symbol? x) (occurs? x e)))

(define (expanded e)
  (define-values (x _assumed) (expand-expression (simplify-strictly e) (assumptions-in-force)))
  x)

;; Half the second derivative by p, or #f where that is 0 or has p in it
(define (square-coefficient G p)
  (define (f x) (with G p x))
  (and (eqv? (degree-in f p) 2)
       (simplify-strictly (g:* 1/2 (derivative-at (lambda (x) (derivative-at f x)) p)))))

(define (denominator-of G)
  (define-values (_n d _assumed) (numerator-and-denominator G (assumptions-in-force)))
  d)
