#lang racket/base
;; Complex numbers made of expressions: (make-rectangular 'x 'y) and its parts.
;;
;; Symbols and literal functions are real, so that an expression without a number that is
;; not real is its own real part.  Of others the parts are found operation by operation,
;;
;;   (a + ib)(c + id) = (ac − bd) + i (ad + bc),   e^(a + ib) = e^a (cos b + i sin b),
;;   sin(a + ib) = sin a cosh b + i cos a sinh b,  cos(a + ib) = cos a cosh b − i sin a sinh b,
;;
;; and so on.  The conjugate of such an operation is the operation on the conjugates.

(require (prefix-in racket: (only-in racket/base real-part imag-part))
         "../algebra/expression/expression.rkt" "../algebra/expression/nodes.rkt"
         "../algebra/expression/operation.rkt" "../algebra/expression/substitute.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/dispatch.rkt"
         "../generic/elementary.rkt" "../generic/function.rkt" "../generic/kind.rkt"
         "../generic/scalar.rkt" "../generic/up-down.rkt" "../generic/wrong-argument.rkt")

(provide conjugate
         (rename-out [make-complex make-rectangular] [make-polar-complex make-polar]
                     [real-part-of real-part] [imag-part-of imag-part]))

;; ---------------------------------------------------------------------------

(define (make-complex x y)
  (check-parts 'make-rectangular x y)
  (if (and (real? x) (real? y)) (make-rectangular x y) (g:+ x (g:* +i y))))

;; r e^(i φ)
(define (make-polar-complex r phi)
  (check-parts 'make-polar r phi)
  (if (and (real? r) (real? phi))
      (make-polar r phi)
      (make-complex (g:* r (g:cos phi)) (g:* r (g:sin phi)))))

(define (check-parts who . parts)
  (for ([x (in-list parts)])
    (check-argument who scalar? x "two numbers")))

(define (real-part-of x) (of-leaves generic:real-part x (lambda (re im) re)))
(define (imag-part-of x) (of-leaves generic:imag-part x (lambda (re im) im)))
(define (conjugate x)
  (of-leaves generic:conjugate x (lambda (re im) (g:- re (g:* +i im))) conjugate-expression))

(define generic:real-part (operation-by-values 'real-part real-part-of))
(define generic:imag-part (operation-by-values 'imag-part imag-part-of))
(define generic:conjugate (operation-by-values 'conjugate conjugate))

;; choose : real and imaginary part -> value, at each scalar of x; of-expression : expression
;; that may not be real -> value.  A quaternion has a conjugate that is not that of its parts.
(define (of-leaves op x choose [of-expression (of-parts (generic-op-name op) choose)])
  (define (of-leaf leaf)
    (cond [(symbolic? leaf)
           (if (real-leaves? leaf) (choose leaf 0) (of-expression leaf))]
          [(number? leaf) (choose (racket:real-part leaf) (racket:imag-part leaf))]
          [(pointwise? leaf) (compose-unary op leaf)]
          [(scalar? leaf) (choose leaf 0)]
          [else (raise-inapplicable op leaf)]))
  (let walk ([x x])
    (cond [(tuple? x) (structure-map walk (adopt x))]
          [(and (has-kind? x) (eqv? (kind-rank (kind-of x)) rank:quaternion))
           (dispatch-unary op x)]
          [else (map-leaves of-leaf x)])))

(define ((of-parts who choose) e)
  (call-with-values (lambda () (parts who e)) choose))

;; ---------------------------------------------------------------------------
;; Conjugates of expressions

;; The operations that are real for real arguments, and have no branches
(define conjugated-inside
  (append (list op:+ op:- op:* op:/) (operations-where meromorphic)))

(define (conjugate-expression e)
  (node-fold e
             (lambda (leaf)
               (if (or (symbol? leaf) (real? leaf))
                   leaf
                   (g:- (racket:real-part leaf) (g:* +i (racket:imag-part leaf)))))
             (lambda (n arguments)
               (cond [(andmap eqv? arguments (node-args n)) n]        ; it is real
                     [(conjugated-inside? n) (rebuild (node-head n) arguments)]
                     [else (raise-no-parts 'conjugate n)]))))

(define (conjugated-inside? e)
  (or (memq (node-head e) conjugated-inside)
      (integer-power? e)))

;; ---------------------------------------------------------------------------
;; Parts of expressions

;; Real and imaginary part
(struct rectangular (re im) #:authentic)

;; -> real and imaginary part
(define (parts who e)
  (define found
    (node-fold e leaf-parts
               (lambda (n arguments)
                 (node-parts n arguments (lambda () (raise-no-parts who e))))))
  (values (rectangular-re found) (rectangular-im found)))

(define (leaf-parts leaf)
  (if (number? leaf)
      (rectangular (racket:real-part leaf) (racket:imag-part leaf))
      (rectangular leaf 0)))

;; arguments : the parts of the node's
(define (node-parts n arguments fail)
  (if (andmap (lambda (a given) (eqv? (rectangular-re a) given)) arguments (node-args n))
      (rectangular n 0)                 ; it is real
      (call-with-values (lambda () (parts-of-operation n arguments fail)) rectangular)))

(define (parts-of-operation n arguments fail)
  (define head (node-head n))
  (define-values (a b) (both (car arguments)))
  (define (with-second operation)
    (define-values (c d) (both (cadr arguments)))
    (operation a b c d))
  (cond [(eq? head op:+) (fold-parts sum 0 arguments)]
        [(eq? head op:*) (fold-parts product 1 arguments)]
        [(eq? head op:-) (with-second difference)]
        [(eq? head op:/) (with-second quotient-of)]
        [(and (eq? head op:expt) (exact-integer? (cadr (node-args n))))
         (power a b (cadr (node-args n)))]
        [(eq? head op:exp) (exponential a b)]
        [(eq? head op:sin) (values (g:* (g:sin a) (g:cosh b)) (g:* (g:cos a) (g:sinh b)))]
        [(eq? head op:cos)
         (values (g:* (g:cos a) (g:cosh b)) (g:negate (g:* (g:sin a) (g:sinh b))))]
        [(eq? head op:sinh) (values (g:* (g:sinh a) (g:cos b)) (g:* (g:cosh a) (g:sin b)))]
        [(eq? head op:cosh) (values (g:* (g:cosh a) (g:cos b)) (g:* (g:sinh a) (g:sin b)))]
        [else (fail)]))

(define (both x) (values (rectangular-re x) (rectangular-im x)))

(define (fold-parts operation start arguments)
  (for/fold ([a start] [b 0]) ([x (in-list arguments)])
    (operation a b (rectangular-re x) (rectangular-im x))))

(define (sum a b c d) (values (g:+ a c) (g:+ b d)))
(define (difference a b c d) (values (g:- a c) (g:- b d)))
(define (product a b c d)
  (values (g:- (g:* a c) (g:* b d)) (g:+ (g:* a d) (g:* b c))))
(define (quotient-of a b c d)
  (define size (g:+ (g:square c) (g:square d)))
  (values (g:/ (g:+ (g:* a c) (g:* b d)) size)
          (g:/ (g:- (g:* b c) (g:* a d)) size)))
(define (exponential a b)
  (values (g:* (g:exp a) (g:cos b)) (g:* (g:exp a) (g:sin b))))

(define (power a b n)
  (cond [(negative? n)
         (define-values (c d) (power a b (- n)))
         (quotient-of 1 0 c d)]
        [else (for/fold ([c 1] [d 0]) ([_ (in-range n)]) (product a b c d))]))

(define (raise-no-parts who e)
  (complain who
            (string-append "the parts are known of sums, products, whole powers, exp, sin, cos, "
                           "sinh and cosh of complex expressions; given ~a")
            (value->text e)))
