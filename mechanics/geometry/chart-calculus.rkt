#lang racket/base
;; Calculus of expressions in the symbols of a chart.
;;
;; Everything that geometry computes is a vector of such expressions, a graph with shared nodes.
;; Derivatives are taken of all of them in one walk for each coordinate: a node becomes itself
;; plus an infinitesimal, so that parts common to derivative and value are shared.

(require "manifold-chart.rkt" "component-array.rkt"
         (rename-in "../algebra/elimination/minors.rkt" [operations ring-of])
         "../algebra/expression/expression.rkt" "../algebra/expression/flat-graph.rkt"
         "../algebra/expression/operation.rkt"
         "../calculus/dual.rkt" "../calculus/expression-function.rkt"
         "../calculus/perturbed-value.rkt"
         "../generic/arithmetic.rkt" "../generic/up-down.rkt"
         "../generic/describe.rkt" "../generic/elementary.rkt"
         "../value/assumptions.rkt" "../value/simplify.rkt")

(provide derivatives-by-coordinates derivatives-by-coordinates-at
         evaluate-components in-place-of-symbols inverse-of-matrix determinant-of-matrix tidied
         root-of-size)

;; -> a vector with, for each coordinate of C, the vector of derivatives of the expressions
(define (derivatives-by-coordinates es C)
  (for/vector ([x (in-vector (coordinate-system-symbols C))])
    (if (for/and ([e (in-vector es)]) (number? e))
        (make-vector (vector-length es) 0)
        (derivatives-by es x))))

(define (derivatives-by es x)
  (define tag (fresh-tag))
  (for/vector #:length (vector-length es)
              ([v (in-vector (fold-all es
                                       (lambda (leaf) (if (eq? leaf x) (perturb tag x) leaf))
                                       (lambda (n arguments) (with-slope tag n arguments))))])
    (tangent-part v tag)))

(define (with-slope tag n arguments)
  (define value (apply-generically (node-head n) arguments))
  (if (tuple? value) value (make-dual tag n (tangent-part value tag))))

;; All of es folded as one graph.  A value that is being differentiated by something else, as
;; Lagrangians are, has expressions for its parts.
(define (fold-all es at-leaf at-node)
  (define (fold e)
    (node-fold e
               (lambda (leaf)
                 (if (perturbed? leaf)
                     ((parts-retag (parts-of leaf)) (perturbed-tag leaf) fold leaf)
                     (at-leaf leaf)))
               at-node))
  (structure-elements (fold (make-node op:up (vector->list es)))))

;; The same, evaluated at coordinates.
(define (derivatives-by-coordinates-at es C x)
  (for/vector ([d (in-vector (derivatives-by-coordinates es C))]) (evaluate-components d C x)))

;; The expressions with coordinates in place of the symbols of C.
;; x : the coordinates, as of a point
(define (evaluate-components es C x) (in-place-of-symbols es (coordinate-system-symbols C) x))

(define (in-place-of-symbols es symbols x)
  (define xs (if (tuple? x) (tuple-elements x) (vector x)))
  (if (for/and ([s (in-vector symbols)] [x (in-vector xs)]) (eq? s x))
      es
      (fold-all es
                (lambda (leaf)
                  (or (for/first ([s (in-vector symbols)] [x (in-vector xs)] #:when (eq? s leaf)) x)
                      leaf))
                (lambda (n arguments) (apply-generically (node-head n) arguments)))))

;; ---------------------------------------------------------------------------
;; Matrices, n by n, as components of two indices

(define ring (ring-of g:+ g:- g:*))

(define (rows-of M n)
  (for/vector #:length n ([i (in-range n)])
    (for/vector #:length n ([j (in-range n)]) (vector-ref M (+ (* n i) j)))))

(define (determinant-of-matrix M n)
  (tidied ((make-minors ring (rows-of M n)) (all-lines n) (all-lines n))))

;; complain : called where the determinant is 0
(define (inverse-of-matrix M n complain)
  (define minor (make-minors ring (rows-of M n)))
  (define d (tidied (minor (all-lines n) (all-lines n))))
  (when (eqv? d 0) (complain))
  (build-components n 2 (lambda (ij)
                          (define c (cofactor ring minor n (cadr ij) (car ij)))
                          (if (eqv? c 0) 0 (tidied (g:/ c d))))))

;; ---------------------------------------------------------------------------

;; An expression in normal form, where that is likely to be the smaller one: a zero is seen to be
;; one.  Large ones, and those that grow, stay graphs.  It is kept, so no assumption is used.
(define (tidied e)
  (cond [(or (not (node? e)) (> (graph-size e) large)) e]
        [else
         (define simple (simplify-always e))
         (if (> (graph-size simple) (* 2 (graph-size e))) e simple)]))

(define large 300)                      ; nodes

;; √|e|, given the positive values of the chart
(define (root-of-size e C)
  (call-assuming (for/list ([p (in-list (coordinate-system-positive C))])
                   (list '> (value->datum p) 0))
                 (lambda () (tidied (g:sqrt (g:abs e))))))
