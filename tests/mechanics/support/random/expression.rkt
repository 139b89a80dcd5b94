#lang racket/base
;; Random expressions of the class that simplification decides, random points,
;; and random rewrites, sound and unsound.

(require mechanics/algebra/expression/expression
         mechanics/algebra/expression/operation
         mechanics/algebra/expression/substitute
         "../evaluate.rkt")

(provide random-expression random-lookup value-at
         sound-rewrites unsound-rewrites rewrite)

(define (choose xs) (list-ref xs (random (length xs))))

;; ---------------------------------------------------------------------------
;; Expressions

(define symbols '(a b c x))
(define (application name . path)
  (define head (make-literal-head name))
  (make-node (if (null? path) head (literal-head-derivative head (car path))) '(t)))

(define leaves
  (list 'a 'b 'c 'x (application 'q) (application 'q '())))

;; kinds : a subset of '(rational trigonometric radical exponential)
(define (random-expression depth kinds)
  (define (sub) (random-expression (- depth 1) kinds))
  (define (leaf) (if (zero? (random 4)) (choose '(1 2 -1 1/2 3 -2/3)) (choose leaves)))
  (define (function)
    (case (if (null? kinds) 'none (choose kinds))
      [(rational) (divide (sub) (sub))]
      [(trigonometric) (make-node (choose (list op:sin op:cos)) (list (random-angle)))]
      [(radical) (power (e:+ (e:* (leaf) (leaf)) (choose (list 'a 'b 3)))
                        (choose '(1/2 1/2 3/2 -1/2)))]
      [(exponential) (make-node op:exp (list (random-angle)))]
      [else (leaf)]))
  (if (zero? depth)
      (leaf)
      (case (random 8)
        [(0 1) (e:+ (sub) (sub))]
        [(2 3) (e:* (sub) (sub))]
        [(4) (e:- (sub) (sub))]
        [(5) (e:expt (sub) (choose '(2 2 3)))]
        [else (function)])))

(define (divide u v) (if (eqv? v 0) u (e:/ u v)))
(define (power u n) (if (number? u) 2 (make-node op:expt (list u n))))

;; Sums and small multiples of few atoms, so that angles depend on each other.
(define (random-angle)
  (for/fold ([u (e:* (choose '(1 1 1 2 -1)) (choose '(a b)))]) ([i (in-range (random 2))])
    (e:+ u (e:* (choose '(1 -1)) (choose (list 'a 'b (application 'q)))))))

;; ---------------------------------------------------------------------------
;; Values

;; A lookup giving every leaf a flonum of its own between 0.3 and 2.3.
(define (random-lookup)
  (define table (make-hash))
  (lambda (leaf arguments)
    (hash-ref! table (if (symbol? leaf) leaf (list (head->datum (node-head leaf)) arguments))
               (lambda () (+ 0.3 (* 2 (random)))))))

;; The value, or #f where there is none.
(define (value-at e lookup)
  (define v
    (with-handlers ([exn:fail? (lambda (x) #f)])
      (evaluate-expression e lookup)))
  (and v (real? v) (rational? v) (< (abs v) 1e12) v))

;; ---------------------------------------------------------------------------
;; Rewrites of a node: rule : node -> expression or #f

(define (headed? n op k) (and (eq? (node-head n) op) (= k (length (node-args n)))))

(define-syntax-rule (define-rules id [name pattern-op count (arg ...) result] ...)
  (define id
    (list (cons 'name
                (lambda (n)
                  (and (headed? n pattern-op count)
                       (apply (lambda (arg ...) result) (node-args n))))) ...)))

(define (f op . args) (make-node op args))

(define-rules sound-rewrites
  [distribute op:* 2 (u v)
    (and (node? v) (eq? (node-head v) op:+)
         (for/fold ([sum 0]) ([w (in-list (node-args v))]) (e:+ sum (e:* u w))))]
  [square-of-difference op:- 2 (u v) (e:/ (e:- (e:* u u) (e:* v v)) (e:+ u v))]
  [pythagoras op:sin 1 (u) (e:* (f op:sin u) (e:+ (e:expt (f op:sin u) 2) (e:expt (f op:cos u) 2)))]
  [double-angle op:cos 1 (u) (e:- 1 (e:* 2 (e:expt (f op:sin (e:* 1/2 u)) 2)))]
  [sine-of-sum op:sin 1 (u)
    (e:+ (e:* (f op:sin (e:+ u 'b)) (f op:cos 'b))
         (e:negate (e:* (f op:cos (e:+ u 'b)) (f op:sin 'b))))]
  [double-sine op:sin 1 (u) (e:* 2 (e:* (f op:sin (e:* 1/2 u)) (f op:cos (e:* 1/2 u))))]
  [swap-difference op:- 2 (u v) (e:negate (make-node op:- (list v u)))]
  [cube op:expt 2 (u n) (e:* u (e:expt u (if (exact-integer? n) (- n 1) (- n 1))))])

(define-rules unsound-rewrites
  [sum-of-squares op:expt 2 (u n)
    (and (eqv? n 2) (node? u) (eq? (node-head u) op:+)
         (for/fold ([sum 0]) ([w (in-list (node-args u))]) (e:+ sum (e:expt w 2))))]
  [sine-linear op:sin 1 (u)
    (and (node? u) (eq? (node-head u) op:+)
         (for/fold ([sum 0]) ([w (in-list (node-args u))]) (e:+ sum (f op:sin w))))]
  [wrong-sign op:- 2 (u v) (e:- v u)]
  [wrong-cosine op:cos 1 (u) (e:negate (f op:cos u))])

;; e with the rule applied at every node it fits.
(define (rewrite e rule)
  (node-fold e values
             (lambda (n args)
               (define rebuilt (rebuild (node-head n) args))
               (or (and (node? rebuilt) ((cdr rule) rebuilt)) rebuilt))))
