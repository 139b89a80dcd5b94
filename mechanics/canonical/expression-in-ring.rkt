#lang racket/base
;; Expressions read as elements of a ring, such as series of waves or polynomials: sums, products
;; and powers are those of the ring.

(require "../algebra/expression/expression.rkt" "../algebra/expression/operation.rkt")

(provide (struct-out ring) expression-in)

;; constant : expression -> element;  sum, product : two elements;  scale : number, element
(struct ring (constant sum product scale) #:authentic)

;; (base e) : the element that e is, if that is to be seen at once, or else #f; where nothing is
;; to be seen of a part, (fail part)
(define (expression-in r e base fail)
  (define-values (sum product) (values (ring-sum r) (ring-product r)))
  (define one ((ring-constant r) 1))
  (define (minus x) ((ring-scale r) -1 x))
  (let walk ([e e])
    (define (joined combine start xs)
      (for/fold ([x start]) ([y (in-list xs)]) (combine x (walk y))))
    (define (power x n) (for/fold ([p one]) ([_ (in-range n)]) (product p x)))
    (cond
      [(base e) => values]
      [(not (node? e)) (fail e)]
      [else
       (define-values (head args) (values (node-head e) (node-args e)))
       (define-values (first rest) (values (car args) (cdr args)))
       (cond
         [(eq? head op:+) (joined sum (walk first) rest)]
         [(eq? head op:*) (joined product (walk first) rest)]
         [(eq? head op:-)
          (if (null? rest)
              (minus (walk first))
              (joined (lambda (x y) (sum x (minus y))) (walk first) rest))]
         [(and (eq? head op:/) (pair? rest))
          (for/fold ([x (walk first)]) ([y (in-list rest)])
            (product x (or (base (e:/ 1 y)) (fail e))))]
         [(and (eq? head op:expt) (exact-nonnegative-integer? (car rest)))
          (power (walk first) (car rest))]
         [else (fail e)])])))
