#lang racket/base
;; Verdicts on the parts of an answer, of which all judgments are made.

(require (only-in racket/list append-map count)
         "prescribed-symbols.rkt"
         "../../algebra/expression/expression.rkt" "../../algebra/expression/substitute.rkt"
         "../../algebra/zero/vanishing.rkt"
         "../../calculus/derivative.rkt" "../../calculus/expression-function.rkt"
         "../../generic/describe.rkt" "../../generic/scalar.rkt" "../../generic/up-down.rkt"
         "../../value/assumptions.rkt" "../../value/read-expression.rkt" "../../value/rewrite.rkt"
         "../../value/matrix/matrix.rkt"
         "../../value/shape.rkt" "../../value/structure.rkt"
         "../../verdict/prove-zero.rkt" "../../verdict/verdict.rkt")

(provide alike? same? zero-value? share-proved terms-of value-function rate along-path->symbols
         replace)

(define (alike? a b)
  (cond [(and (tuple? a) (tuple? b))
         (define-values (x y) (values (adopt a) (adopt b)))
         (and (eq? (structure-orientation x) (structure-orientation y))
              (= (structure-length x) (structure-length y))
              (for/and ([p (in-vector (tuple-elements a))] [q (in-vector (tuple-elements b))])
                (alike? p q)))]
        [(and (matrix? a) (matrix? b))
         (and (= (m:num-rows a) (m:num-rows b)) (= (m:num-cols a) (m:num-cols b)))]
        [else (and (scalar? a) (scalar? b))]))

;; Are a and b proved to be equal?
(define (same? a b) (and (alike? a b) (proved? (verify-equal a b))))

;; The terms of an expression, expanded
(define (terms-of e)
  (define d (value->datum (expand e)))
  (if (and (pair? d) (eq? (car d) '+)) (map read-expression (cdr d)) (list e)))

(define (zero-value? x)
  (for/and ([e (in-list (scalars x))]) (and (expression? e) (vanishes? e (assumptions-in-force)))))

;; The share of the scalars of x that are proved to be zero.
(define (share-proved x)
  (define parts (scalars x))
  (/ (count (lambda (e) (proved? (prove-zero e))) parts) (length parts)))

;; ---------------------------------------------------------------------------
;; Values as functions

;; The function whose value at the symbols of `at` is e.
(define ((value-function e at) x)
  (define point (map cons (scalars at) (scalars x)))
  (map-leaves (lambda (leaf) (evaluate-generically leaf point)) e))

;; The derivative of e by a symbol.
(define (rate e symbol) (derivative-at (value-function e symbol) symbol))

;; e, with ((D x) t) and its like, in symbols: x, xdot, xddot.
(define (along-path->symbols e names)
  (replace e (append-map (lambda (derivatives part) (map cons derivatives (scalars part)))
                         (path-derivatives names)
                         (cdr (structure->list (long-tuple-of names))))))

;; entries : ((expression . expression) ...)
(define (replace x entries)
  (map-leaves (lambda (leaf) (substitute-expression leaf entries)) x))
