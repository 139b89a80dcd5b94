#lang racket/base
;; A quick verdict on zero, modulo primes.
;;
;; The kernels of e are given random residues modulo a prime p that satisfy the
;; relations among them:
;;
;;     cos θ = (1 - t²)/(1 + t²),  sin θ = 2t/(1 + t²)   for basic angles
;;     cosh u = (1 + t²)/(1 - t²), sinh u = 2t/(1 - t²)
;;     √u, that root of u which is itself a square, for p ≡ 3 (mod 4)
;;
;; and e is evaluated in one walk.  For rational functions of symbols, literal
;; applications, sines, cosines and exponentials a residue other than 0 *proves*
;; that e is not zero.  By the theorem of Schwartz and Zippel an expression
;; that is not zero has the residue 0 with a probability of about its degree
;; over p; several zeros, modulo different primes, are good evidence.

(require "operation.rkt" "expression.rkt" "kernel.rkt" "collect.rkt" "normalize.rkt" "walk.rkt"
         "polynomial/modular.rkt")

(provide fingerprint)

;; Primes below 2^30 that are 3 modulo 4.
(define primes (list 1073741783 1073741723 1073741719))

;; Points that fail, for a division by zero or a root that is not there, are
;; replaced, so often.
(define attempts 24)

;; -> 'zero : e is 0 at a point modulo each prime.
;;    'nonzero : e is not zero.
;;    'unknown : no point was found, or what was found does not decide.
(define (fingerprint e)
  (define atlas (workspace-atlas (make-workspace) e))
  (define kernels (place-kernels! (atlas-kernels atlas)))
  (define residues (for/list ([p (in-list primes)]) (residue-at-some-point e atlas kernels p)))
  (cond [(andmap (lambda (r) (eqv? r 0)) residues) 'zero]
        [(and (decidable? atlas kernels)
              (for/or ([r (in-list residues)]) (and r (not (eqv? r 0)))))
         'nonzero]
        [else 'unknown]))

;; Are the kernels independent but for the relations of sines?  So it is when they
;; are made of symbols, literal functions, sines and exponentials by rational
;; operations alone: then equal arguments have equal canonical forms.
(define (decidable? atlas kernels)
  (and (null? (atlas-tower atlas))
       (for/and ([k (in-vector kernels)]) (plain? (kernel-expression k)))))

(define (plain? e)
  (node-fold e
             (lambda (leaf) (or (symbol? leaf) (exact? leaf)))
             (lambda (n plain)
               (define head (node-head n))
               (and (andmap values plain)
                    (or (literal-head? head)
                        (and (memq head plain-operations) #t)
                        (and (eq? head op:expt) (exact-integer? (cadr (node-args n)))))))))

(define plain-operations
  (list op:+ op:- op:* op:/ op:sin op:cos op:tan op:sinh op:cosh op:tanh op:exp
        op:up op:down))

;; The residue, or #f.
(define (residue-at-some-point e atlas kernels p)
  (for/or ([seed (in-range attempts)])
    (with-handlers ([stuck? (lambda (s) #f)])
      (define point (random-point atlas kernels seed p))
      (and point
           (evaluate-in (modular-arithmetic point p) atlas e)))))

;; ---------------------------------------------------------------------------
;; Points

;; A vector of residues by index, or #f if a radicand is no square there.
(define (random-point atlas kernels seed p)
  (define point (make-vector (vector-length kernels) 0))
  (define (put! k value) (vector-set! point (kernel-index k) value))
  (define (at k) (sample-residue seed (kernel-index k) p))
  (for ([k (in-vector kernels)]) (put! k (at k)))
  (for ([k (in-vector kernels)] #:when (circle? (kernel-relation k)))
    (put-circle! put! (kernel-relation k) (at k) p))
  (and (for/and ([r (in-list (reverse (atlas-tower atlas)))])
         (put-root! put! point atlas r p))
       point))

(define (put-circle! put! o t p)
  (define square (mod* t t p))
  (define plus (mod+ 1 square p))
  (define minus (mod- 1 square p))
  (define circular? (eqv? 1 (circle-sign o)))
  (define inverse (invert (if circular? plus minus) p))
  (put! (circle-sine o) (mod* (mod* 2 t p) inverse p))
  (put! (circle-cosine o) (mod* (if circular? minus plus) inverse p)))

;; -> was there a root?
(define (put-root! put! point atlas r p)
  (define (value e) (evaluate-in (modular-arithmetic point p) atlas e))
  (cond [(kernel? r)
         (put! r (value (modulus-argument (kernel-relation r))))
         #t]
        [(eqv? 2 (root-degree r))
         (define u (value (root-radicand r)))
         (define root (mod-expt u (quotient (+ p 1) 4) p))
         (put! (root-kernel r) root)
         (= u (mod* root root p))]
        [else #f]))

;; ---------------------------------------------------------------------------
;; Arithmetic

(define (invert x p)
  (if (eqv? x 0) (raise-obstacle) (mod-inverse x p)))

(define (modular-arithmetic point p)
  (define (power x k)
    (if (negative? k)
        (mod-expt (invert x p) (- k) p)
        (mod-expt x k p)))
  (arithmetic
   (lambda (c)
     (when (zero? (modulo (denominator c) p)) (raise-obstacle))
     (residue c p))
   (lambda (k) (vector-ref point (kernel-index k)))
   (lambda (xs) (for/fold ([sum 0]) ([x (in-list xs)]) (mod+ sum x p)))
   (lambda (xs) (for/fold ([product 1]) ([x (in-list xs)]) (mod* product x p)))
   (lambda (x y) (mod- x y p))
   (lambda (x y) (mod* x (invert y p) p))
   power))
