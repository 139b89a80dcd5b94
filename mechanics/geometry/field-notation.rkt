#lang racket/base
;; Fields as they are typeset: ∂/∂x, dx ∧ dy, [X, Y], £_X ω, ∇_v u.
;;
;; A field prints as the expression that makes it; a part with a sign of its own in print becomes a
;; tree in this expression, the rest is written as any formula.

(require "../algebra/notation/name.rkt" "../algebra/notation/tree.rkt"
         "../generic/notation.rkt")

(provide field-notation)

(define (field-notation datum) (tree:datum (with-signs datum)))

(define (with-signs d)
  (cond [(symbol? d) (or (coordinate-field d) d)]
        [(and (pair? d) (list? d)) (or (signed d) (map with-signs d))]
        [else d]))

;; d/dx and dx, where x may be a coordinate: a name of one letter or two
(define (coordinate-field s)
  (define m (regexp-match #rx"^(d/d|d)([^/]+)$" (symbol->string s)))
  (define x (and m (string->symbol (caddr m))))
  (cond [(not (and m (<= (string-length (parts-base (name-parts x))) 2))) #f]
        [(string=? (cadr m) "d") (row (list (word "d") (name x)))]
        [else (fraction (word "∂") (row (list (word "∂") (name x))))]))

(define (tree-of d) (tree:datum (with-signs d)))
(define (operand d)
  (define t (tree-of d))
  (if (or (sum? t) (product? t)) (parenthesized t) t))

(define (signed d)
  (define-values (head arguments) (values (car d) (cdr d)))
  (cond [(and (eq? head 'wedge) (pair? arguments))
         (for/fold ([t (operand (car arguments))]) ([a (in-list (cdr arguments))])
           (relation t "∧" (operand a)))]
        [(and (eq? head 'd) (one? arguments)) (row (list (word "d") (operand (car arguments))))]
        [(and (eq? head 'commutator) (two? arguments))
         (row (list (word "[") (tree-of (car arguments)) (word ", ") (tree-of (cadr arguments))
                    (word "]")))]
        [(and (one? arguments) (derivative-sign head))
         => (lambda (sign) (row (list sign (word " ") (operand (car arguments)))))]
        [else #f]))

(define (one? xs) (and (pair? xs) (null? (cdr xs))))
(define (two? xs) (and (pair? xs) (one? (cdr xs))))

;; (Lie-derivative X) and ((covariant-derivative …) v): a sign with the direction below
(define (derivative-sign head)
  (cond [(not (and (list? head) (= (length head) 2))) #f]
        [(eq? (car head) 'Lie-derivative) (with-direction "£" (cadr head))]
        [(and (pair? (car head)) (eq? (caar head) 'covariant-derivative))
         (with-direction "∇" (cadr head))]
        [else #f]))

;; ∂/∂x is the direction x.
(define (with-direction sign v)
  (define text (and (symbol? v) (regexp-replace #rx"^d/d" (symbol->string v) "")))
  (if text
      (name (string->symbol (string-append sign "_" text)))
      (row (list (word sign) (parenthesized (tree-of v))))))
