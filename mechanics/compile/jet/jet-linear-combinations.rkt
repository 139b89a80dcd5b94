#lang racket/base
;; Linear combinations of nodes, and operations on them.
;;
;; Of one Taylor coefficient a linear combination costs next to nothing, a product a
;; convolution.  So sums, differences and multiples are not quantities of their own but *forms*,
;; Σ c_i x_i + c, until a product or a function needs them whole; x − y and y − x are one quantity
;; with a sign.  Powers of one base are gathered, q √q in a denominator being q^(−3/2).

(require "jet-nodes.rkt")

(provide form? form-constant number-form node-form number-form?
         add scale kept whole!
         multiply! divide! power!)

;; constant + Σ coefficient node; terms : (id . coefficient) by rising id
(struct form (constant terms) #:authentic)

(define (number-form c) (form c '()))
(define (node-form id [c 1]) (if (eqv? c 0) (number-form 0) (form 0 (list (cons id c)))))
(define (number-form? f) (null? (form-terms f)))

;; A sum that is used again is a quantity of its own.
(define (kept b f shared?)
  (cond [(and shared? (not (number-form? f)))
         (define-values (c id) (single! b f))
         (node-form id c)]
        [else f]))

(define (add f g)
  (form (+ (form-constant f) (form-constant g))
        (let merge ([xs (form-terms f)] [ys (form-terms g)])
          (cond [(null? xs) ys]
                [(null? ys) xs]
                [(< (caar xs) (caar ys)) (cons (car xs) (merge (cdr xs) ys))]
                [(> (caar xs) (caar ys)) (cons (car ys) (merge xs (cdr ys)))]
                [else
                 (define c (+ (cdar xs) (cdar ys)))
                 (define rest (merge (cdr xs) (cdr ys)))
                 (if (zero? c) rest (cons (cons (caar xs) c) rest))]))))

(define (scale c f)
  (cond [(zero? c) (number-form 0)]
        [else (form (* c (form-constant f))
                    (for/list ([t (in-list (form-terms f))]) (cons (car t) (* c (cdr t)))))]))

;; f as c times a node -> c, id
(define (single! b f)
  (define terms (form-terms f))
  (cond [(null? terms) (values (form-constant f) (node! b '(one)))]
        [(and (null? (cdr terms)) (zero? (form-constant f))) (values (cdar terms) (caar terms))]
        [(< (cdar terms) 0) (values -1 (linear! b (scale -1 f)))]
        [else (values 1 (linear! b f))]))

(define (linear! b f) (node! b (list* 'linear (form-constant f) (form-terms f))))

;; The id of f itself.
(define (whole! b f)
  (define-values (c id) (single! b f))
  (if (= c 1) id (linear! b f)))

;; ---------------------------------------------------------------------------
;; Products and powers

(define (multiply! b f g)
  (cond [(number-form? f) (scale (form-constant f) g)]
        [(number-form? g) (scale (form-constant g) f)]
        [else
         (define-values (c x) (single! b f))
         (define-values (d y) (single! b g))
         (node-form (product! b x y) (* c d))]))

(define (product! b x y)
  (define-values (base m) (base-and-exponent b x))
  (define-values (other n) (base-and-exponent b y))
  (define sum (+ m n))
  (if (and (= base other) (not (whole? sum)) (not (and (whole? m) (whole? n))))
      (node! b (list 'power base sum))
      (node! b (list 'product (min x y) (max x y)))))

(define (whole? n) (exact-nonnegative-integer? n))

(define (base-and-exponent b id)
  (define n (node-of b id))
  (case (node-kind n)
    [(power) (values (cadr n) (caddr n))]
    [(product)
     (define-values (base m) (base-and-exponent b (cadr n)))
     (define-values (other k) (base-and-exponent b (caddr n)))
     (if (and (= base other) (whole? m) (whole? k)) (values base (+ m k)) (values id 1))]
    [else (values id 1)]))

;; A constant that is nothing divides as it does when the motion is followed: coefficients are
;; infinite then, which is seen where it begins.
(define (divisor c) (if (eqv? c 0) 0.0 c))

(define (divide! b f g shared?)
  (cond [(number-form? g) (scale (/ 1 (divisor (form-constant g))) f)]
        [else
         (define-values (d y) (single! b g))
         (define-values (base n) (base-and-exponent b y))
         ;; a divisor of several is inverted once
         (cond [(or (number-form? f) shared? (not (whole? n)))
                (scale (/ 1 d) (multiply! b f (node-form (power-node! b base (- n)))))]
               [else
                (define-values (c x) (single! b f))
                (node-form (node! b (list 'quotient x y)) (/ c d))])]))

(define (power-node! b id n)
  (cond [(eqv? n 1) id]
        [else
         (define-values (base m) (base-and-exponent b id))
         (if (and (not (eqv? m 1)) (integer? n) (not (whole? (* m n))))
             (node! b (list 'power base (* m n)))
             (node! b (list 'power id n)))]))

(define (power! b f n)
  (define-values (c id) (single! b f))
  (if (or (> c 0) (integer? n))
      (node-form (power-node! b id n) (if (eqv? c 1) 1 (expt (if (< n 0) (divisor c) c) n)))
      (node-form (power-node! b (linear! b f) n))))
