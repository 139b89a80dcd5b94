#lang racket/base
;; Expressions read as elements of a ring, such as series of waves or polynomials: sums, products
;; and powers are those of the ring.

(require "../../algebra/expression/expression.rkt" "../../algebra/expression/operation.rkt")

(provide (struct-out ring) expression-in)

;; constant : expression -> element;  sum, product : two elements;  scale : number, element
(struct ring (constant sum product scale) #:authentic)

;; base : expression -> its element, or #f if the parts of the expression must be read
;; -> the element of e; (fail part) where a part has none
(define (expression-in r e base fail)
  (let walk ([e e])
    (or (base e)
        (if (node? e)
            (operation r (node-head e) (node-args e) walk base (lambda () (fail e)))
            (fail e)))))

;; walk : expression -> element
(define (operation r head args walk base none)
  (define-values (sum product) (values (ring-sum r) (ring-product r)))
  (define others (cdr args))
  (define (leading) (walk (car args)))
  (define (minus x) ((ring-scale r) -1 x))
  (define (joined combine) (for/fold ([x (leading)]) ([y (in-list others)]) (combine x (walk y))))
  (cond
    [(eq? head op:+) (joined sum)]
    [(eq? head op:*) (joined product)]
    [(and (eq? head op:-) (null? others)) (minus (leading))]
    [(eq? head op:-) (joined (lambda (x y) (sum x (minus y))))]
    [(and (eq? head op:/) (pair? others))
     (for/fold ([x (leading)]) ([y (in-list others)])
       (product x (or (base (e:/ 1 y)) (none))))]
    [(and (eq? head op:expt) (exact-nonnegative-integer? (car others)))
     (define x (leading))
     (for/fold ([power ((ring-constant r) 1)]) ([_ (in-range (car others))]) (product power x))]
    [else (none)]))
