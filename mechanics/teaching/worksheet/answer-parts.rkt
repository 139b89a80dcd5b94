#lang racket/base
;; What every judgment is made of: verdicts on the parts of an answer.

(require "prescribed-symbols.rkt"
         "../../algebra/expression/expression.rkt" "../../algebra/expression/substitute.rkt"
         "../../algebra/zero/vanishing.rkt"
         "../../calculus/expression-function.rkt"
         "../../generic/describe.rkt" "../../generic/up-down.rkt"
         "../../value/assumptions.rkt"
         "../../value/matrix/matrix.rkt"
         "../../value/shape.rkt" "../../value/structure.rkt"
         "../../verdict/prove-zero.rkt" "../../verdict/verdict.rkt")

(provide alike? same? zero-value? share-proved value-function along-path->symbols
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
        [else (and (expression? a) (expression? b))]))

;; Proved to be equal?
(define (same? a b) (and (alike? a b) (proved? (verify-equal a b))))

(define (zero-value? x)
  (for/and ([e (in-list (scalars x))]) (and (expression? e) (vanishes? e (assumptions-in-force)))))

;; Which share of the scalars of x is zero?
(define (share-proved x)
  (define parts (scalars x))
  (/ (for/sum ([e (in-list parts)]) (if (proved? (prove-zero e)) 1 0)) (length parts)))

;; ---------------------------------------------------------------------------
;; Values as functions

;; The function whose value at the symbols of `at` is e.
(define ((value-function e at) x)
  (define point (map cons (scalars at) (scalars x)))
  (map-leaves (lambda (leaf) (evaluate-generically leaf point)) e))

;; e, with ((D x) t) and its like, in symbols: x, xdot, xddot.
(define (along-path->symbols e names)
  (define long (structure->list (long-tuple-of names)))
  (define entries
    (for*/list ([(derivatives values) (in-parallel (path-derivatives names) (cdr long))]
                [pair (in-list (map cons derivatives (scalars values)))])
      pair))
  (replace e entries))

;; entries : ((expression . expression) ...)
(define (replace x entries)
  (map-leaves (lambda (leaf) (substitute-expression leaf entries)) x))
