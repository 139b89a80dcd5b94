#lang racket/base
;; Expressions read as elements of a ring, such as series of waves or polynomials: sums, products
;; and powers are those of the ring.

(require "../../algebra/expression/expression.rkt" "../../algebra/expression/operation.rkt")

(provide (struct-out ring) expression-in)

;; constant : expression -> element;  sum, product : two elements;  scale : number, element
(struct ring (constant sum product scale) #:authentic)

;; (base e) : the element that e is, if that is to be seen at once, or else #f; where nothing is
;; to be seen of a part, (fail part)
(define (expression-in r e base fail)
  (let walk ([e e])
    (cond [(base e) => values]
          [(node? e)
           (define (none) (fail e))
           (operation r (node-head e) (node-args e) walk base none)]
          [else (fail e)])))

;; walk : expression -> element
(define (operation r head args walk base none)
  (define-values (sum product) (values (ring-sum r) (ring-product r)))
  (define-values (first rest) (values (car args) (cdr args)))
  (define (minus x) ((ring-scale r) -1 x))
  (define (joined combine) (for/fold ([x (walk first)]) ([y (in-list rest)]) (combine x (walk y))))
  (cond
    [(eq? head op:+) (joined sum)]
    [(eq? head op:*) (joined product)]
    [(and (eq? head op:-) (null? rest)) (minus (walk first))]
    [(eq? head op:-) (joined (lambda (x y) (sum x (minus y))))]
    [(and (eq? head op:/) (pair? rest))
     (for/fold ([x (walk first)]) ([y (in-list rest)])
       (product x (or (base (e:/ 1 y)) (none))))]
    [(and (eq? head op:expt) (exact-nonnegative-integer? (car rest)))
     (define x (walk first))
     (for/fold ([power ((ring-constant r) 1)]) ([_ (in-range (car rest))]) (product power x))]
    [else (none)]))
