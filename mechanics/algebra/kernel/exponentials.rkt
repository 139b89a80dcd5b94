#lang racket/base
;; Exponentials and symbolic powers.
;;
;; e^(a + b) = e^a e^b, and bⁿ is e^(n log b): so the exponents of both are
;; linear forms over atoms, and each atom has a basic exponential, of which all others
;; are products of integer powers.  (A basis made of e^(a + b), where neither e^a nor
;; e^b occurs, would be smaller; but then 1/(1 + e^a e^-b) and 1/(1 + e^(a - b)), reduced,
;; would differ.)  A rational multiple of a logarithm in an exponent is a power:
;; e^(2 log b) = b².  So is one of i π: it turns (turns.rkt).
;;
;; Hyperbolic functions stay as they are unless their arguments depend on those
;; of exponentials; then they are written as exponentials.

(require racket/list
         "circle.rkt" "integer-lattice.rkt" "kernel.rkt" "kernel-collector.rkt" "turns.rkt"
         "../expression/exact-numbers.rkt" "../expression/expression.rkt"
         "../expression/operation.rkt" "../expression/simplifier.rkt"
         "../expression/substitute.rkt")

(provide visit-exponential! visit-symbolic-power! settle-exponentials!
         angles-of settle-multiples!
         combine-exponentials merge-exponentials
         logarithm-term? hyperbolic->exponential!)

;; (exp u)
(define (visit-exponential! c n)
  (define terms (simplifier-linear-parts (collector-simplifier c) (car (node-args n))))
  (define other (turned-exponential terms))
  (if other (resolve-alias! c n other) (visit-terms! c n terms)))

;; base^k, k not a rational number
(define (visit-symbolic-power! c n base k)
  (define exponent (make-node op:* (list k (make-node op:log (list base)))))
  (visit-terms! c n (simplifier-linear-parts (collector-simplifier c) exponent)))

;; e to the sum of the terms ((rational . expression) ...) stands for n.
(define (visit-terms! c n terms)
  (define-values (powers others) (partition logarithm-term? terms))
  (cond [(null? powers)
         (resolve! c n (exponential-power (intern-angle! c 'exponential (linear-form c others))))]
        [else
         (resolve-alias! c n
                         (for/fold ([product (exponential-of (sum-of-terms others))])
                                   ([t (in-list powers)])
                           (e:* product (logarithm-power t))))]))

;; e^(k log b) = b^k
(define (logarithm-power t)
  (make-node op:expt (list (car (node-args (cdr t))) (exact-exponent (car t)))))

(define (logarithm-term? t)
  (and (headed? (cdr t) op:log) (exact-exponent (car t)) #t))

;; ---------------------------------------------------------------------------
;; Basic exponentials

;; Powers of an exponential up to this are taken for powers.
(define power-limit 1000)

(define (settle-exponentials! c)
  (settle-hyperbolics! c)
  (define angles (angles-of c 'exponential))
  (define-values (basis coordinates) (modest-basis/atoms (map angle-form angles) power-limit))
  (define s (collector-simplifier c))
  (settle-multiples! c angles basis coordinates
                     (lambda (u)
                       (intern-kernel! c (exponential-expression s u) (exponential u s)))))

;; make : expression -> resolution of a basic angle, of which the others are multiples
(define (settle-multiples! c angles basis coordinates make)
  (define basics
    (for/vector ([form (in-list basis)])
      (signed-angle (collector-simplifier c) (form->expression c form) make)))
  (for ([a (in-list angles)] [v (in-list coordinates)])
    (set-angle-multiples! a
      (for/list ([x (in-list v)])
        (define basic (vector-ref basics (car x)))
        (cons (car basic) (* (cdr basic) (cdr x)))))))

(define (angles-of c kind)
  (for/list ([(key a) (in-hash (collector-angles c))] #:when (eq? (car key) kind)) a))

;; e^u, as bⁿ if u is n log b.
(define (exponential-expression s u)
  (define terms (simplifier-linear-parts s u))
  (define b (common-base terms))
  (if b
      (make-node op:expt
                 (list b (simplifier-simplify
                          s
                          (sum-of-terms (for/list ([t (in-list terms)])
                                          (cons (car t) (without-logarithm (cdr t))))))))
      (make-node op:exp (list u))))

;; The b such that every term is a multiple of (log b), or #f.
(define (common-base terms)
  (define bases (for/list ([t (in-list terms)]) (logarithm-base (cdr t))))
  (and (= 1 (length (remove-duplicates bases))) (car bases)))

;; The logarithm among the factors of e, or #f.
(define (logarithm-in e)
  (and (headed? e op:*) (findf (lambda (f) (headed? f op:log)) (node-args e))))

(define (logarithm-base e)
  (define logarithm (logarithm-in e))
  (and logarithm (car (node-args logarithm))))

(define (without-logarithm e)
  (rebuild op:* (remq (logarithm-in e) (node-args e))))

;; ---------------------------------------------------------------------------
;; Combining for presentation

;; powers : ((kernel . exponent) ...) -> one expression for the product of the
;; exponentials among them, or #f, and the other powers.  A power of b goes
;; into the exponent of bⁿ.
(define (combine-exponentials powers)
  (define-values (es others) (exponentials-apart powers))
  (if (null? es) (values #f powers) (absorb-base (exponential-product es) others)))

(define (exponentials-apart powers)
  (partition (lambda (p) (exponential-kernel? (car p))) powers))

(define (exponential-product es)
  (define total (total-exponential es))
  (if (and (null? (cdr es)) (eqv? 1 (cdar es)))
      (kernel-expression (caar es))
      (exponential-expression (exponential-simplifier total) (exponential-exponent total))))

;; The product of powers of exponentials, as an exponential.
(define (total-exponential es)
  (define s (exponential-simplifier (kernel-relation (caar es))))
  (define sum
    (sum-of-terms (for/list ([p (in-list es)])
                    (cons (cdr p) (exponential-exponent (kernel-relation (car p)))))))
  (exponential (simplifier-simplify s sum) s))

;; The powers with the product of their exponentials as one kernel.
;; intern : expression relation -> kernel
(define (merge-exponentials powers intern)
  (define-values (e others) (combine-exponentials powers))
  (define-values (es _) (exponentials-apart powers))
  (if e
      (cons (cons (intern e (total-exponential es)) 1) others)
      powers))

(define (absorb-base e others)
  (define base
    (and (headed? e op:expt)
         (findf (lambda (p) (equal? (kernel-expression (car p)) (car (node-args e)))) others)))
  (if base
      (values (make-node op:expt
                         (list (car (node-args e))
                               (simple-sum (cdr base) (cadr (node-args e)))))
              (remq base others))
      (values e others)))

;; An integer and a simplified exponent added.
(define (simple-sum k n)
  (cond [(headed? n op:+) (e:+ k n)]
        [(positive? k) (make-node op:+ (list k n))]
        [else (make-node op:- (list n (- k)))]))

;; ---------------------------------------------------------------------------
;; Hyperbolic functions

;; Hyperbolics with arguments that depend on exponents become exponentials, all or none.
(define (settle-hyperbolics! c)
  (define hyperbolic (angles-of c 'hyperbolic))
  (define exponents (angles-of c 'exponential))
  (unless (or (null? hyperbolic) (null? exponents)
              (= (rank (append hyperbolic exponents))
                 (+ (rank hyperbolic) (rank exponents))))
    (for ([(n r) (in-hash (hash-copy (collector-resolutions c)))]
          #:when (and (circular? r) (memq (circular-angle r) hyperbolic)))
      (hyperbolic->exponential! c n))
    (for ([a (in-list hyperbolic)])
      (hash-remove! (collector-angles c) (cons 'hyperbolic (angle-form a))))))

(define (rank angles)
  (define-values (basis coordinates) (integer-basis (map angle-form angles)))
  (length basis))

;; The node, of a hyperbolic function, by exponentials.
(define (hyperbolic->exponential! c n)
  (define u (car (node-args n)))
  (define up (make-node op:exp (list u)))
  (define down (make-node op:exp (list (e:negate u))))
  (define sine (e:* 1/2 (e:- up down)))
  (define cosine (e:* 1/2 (e:+ up down)))
  (resolve-alias! c n (function-value (node-head n) sine cosine)))
