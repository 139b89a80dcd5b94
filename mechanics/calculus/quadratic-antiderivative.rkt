#lang racket/base
;; Antiderivatives of forms in one quadratic polynomial Q = c₀ + c₁x + c₂x², its root, and
;; a line: (αx + β)/Q, (αx + β)/√Q, β√Q, β/(x√Q) and β√Q/x.  With Δ = 4c₀c₂ − c₁² and Q' = 2c₂x + c₁
;;
;;     ∫ dx/Q  = 2/√Δ atan(Q'/√Δ),   or   1/√−Δ log((Q' − √−Δ)/(Q' + √−Δ)),
;;     ∫ dx/√Q = 1/√−c₂ asin(−Q'/√−Δ),   or   1/√c₂ log(2√c₂√Q + Q'),
;;     ∫ √Q dx = Q'√Q/4c₂ + Δ/8c₂ ∫ dx/√Q,
;;     ∫ √Q dx/x = √Q + c₀ ∫ dx/(x√Q) + c₁/2 ∫ dx/√Q,
;;     ∫ dx/(x√Q) = 1/√−c₀ asin((2c₀ + c₁x)/(x√−Δ)),   or   −2√Q/(c₁x) where c₀ = 0,
;;
;; by the signs of Δ and c₂; where Δ is a square s², s serves for its root, whatever its sign.
;; (Gradshteyn and Ryzhik, 2.172, 2.261, 2.262, 2.266, 2.267.)

(require "expression-function.rkt"
         "../algebra/expression/expression.rkt" "../algebra/expression/nodes.rkt"
         "../algebra/expression/operation.rkt"
                 "../algebra/expression/substitute.rkt" "../algebra/expression/symbols.rkt"
         "../algebra/simplify/known-sign.rkt" "../algebra/simplify/simplify-expression.rkt")

(provide integral-of-quadratic root-of)

;; An expression, or #f
(define (integral-of-quadratic e x A)
  (define found (radicands-and-denominators e x))
  (for*/or ([Q (in-list found)] [power (in-list '(0 2))])
    (define q (read-quadratic (simple (e:* Q (e:expt x power)) A) x A))
    (and q (or (over-quadratic e q x A) (over-root e q x A) (times-root e q x A)
               (over-variable-and-root e q x A) (root-over-variable e q x A)))))

(define (simple e A) (simplify-expression e A))
(define (root e) (e:apply op:sqrt e))

(define (radicands-and-denominators e x)
  (define (part n)
    (define args (node-args n))
    (cond [(headed? n op:/) (cadr args)]
          [(memq (node-head n) (list op:sqrt op:expt)) (car args)]
          [else #f]))
  (filter (lambda (u) (occurs? x u)) (parts-in e part)))

;; ---------------------------------------------------------------------------
;; Polynomials

;; slope : Q'; delta : Δ
(struct quadratic (all c0 c1 c2 slope delta) #:authentic)

(define ((signed-in x) n) (and (memq (node-head n) (list op:abs op:sgn)) (occurs? x n)))

;; Coefficients of a polynomial of degree n at most, or #f; |x| is none
(define (coefficients e x n A)
  (define derivatives
    (for/fold ([es (list e)]) ([_ (in-range (+ n 1))])
      (cons (simple (expression-derivative (car es) x) A) es)))
  (and (eqv? 0 (car derivatives))
       (not (some-node? (signed-in x) e))
       (for/list ([d (in-list (reverse (cdr derivatives)))] [factorial (in-list '(1 1 2))])
         (simple (e:/ (substitute-expression d (list (cons x 0))) factorial) A))))

(define (read-quadratic Q x A)
  (define cs (coefficients Q x 2 A))
  (cond [(and cs (not (eqv? 0 (caddr cs))))
         (define-values (c0 c1 c2) (apply values cs))
         (quadratic Q c0 c1 c2
                    (e:+ (e:* 2 (e:* c2 x)) c1)
                    (simple (e:- (e:* 4 (e:* c0 c2)) (e:* c1 c1)) A))]
        [else #f]))

;; The number β and α of a line, or #f
(define (read-line e x A) (coefficients (simple e A) x 1 A))

;; s with s² = e, where there is one without a root; else √e if e is known to be positive; or #f
(define (root-of e A)
  (define s (simple (root e) A))
  (define plain (strip-abs s))
  (cond [(and (real-leaves? plain)
              (not (has-root? plain))
              (eqv? 0 (simple (e:- (e:* plain plain) e) A)))
         plain]
        [(eqv? 1 (known-sign e A)) s]
        [else #f]))

(define (strip-abs e) (if (headed? e op:abs) (car (node-args e)) e))

(define (has-root? e)
  (some-node? (lambda (n)
                (or (headed? n op:sqrt) (and (headed? n op:expt) (not (integer-power? n)))))
              e))

;; ---------------------------------------------------------------------------
;; The three kinds

;; β + αx = α/2c₂ Q' + (β − αc₁/2c₂)
(define (split line q)
  (define-values (b a) (apply values line))
  (define k (e:/ a (e:* 2 (quadratic-c2 q))))
  (values k (e:- b (e:* k (quadratic-c1 q)))))

(define (over-quadratic e q x A)
  (define Q (quadratic-all q))
  (over Q (e:apply op:log Q) reciprocal-integral e q x A))

(define (over-root e q x A)
  (define r (root (quadratic-all q)))
  (over r (e:* 2 r) reciprocal-root-integral e q x A))

;; slope-integral : ∫ Q'/divisor; find-integral : q A -> ∫ 1/divisor, or #f
(define (over divisor slope-integral find-integral e q x A)
  (define line (read-line (e:* e divisor) x A))
  (define J (and line (find-integral q A)))
  (cond [J
         (define-values (k rest) (split line q))
         (checked (e:+ (e:* k slope-integral) (e:* rest J)) e x A)]
        [else #f]))

(define (reciprocal-integral q A)
  (define slope (quadratic-slope q))
  (define delta (quadratic-delta q))
  (define s (root-of delta A))
  (define r (and (not s) (root-of (e:negate delta) A)))
  (cond [(or (eqv? s 0) (eqv? r 0)) #f]
        [s (e:* (e:/ 2 s) (e:apply op:atan (e:/ slope s)))]
        [r (e:/ (e:apply op:log (e:/ (e:- slope r) (e:+ slope r))) r)]
        [else #f]))

(define (reciprocal-root-integral q A)
  (define c2 (quadratic-c2 q))
  (define slope (quadratic-slope q))
  (case (known-sign c2 A)
    [(1)
     (define r (root c2))
     (e:/ (e:apply op:log (e:+ (e:* (e:* 2 r) (root (quadratic-all q))) slope)) r)]
    [(-1)
     (define s (simple (root (e:negate (quadratic-delta q))) A))
     (e:/ (e:apply op:asin (e:/ (e:negate slope) s)) (root (e:negate c2)))]
    [else #f]))

(define (times-root e q x A)
  (define Q (quadratic-all q))
  (define factor (simple (e:/ e (root Q)) A))
  (define J (and (not (occurs? x factor)) (reciprocal-root-integral q A)))
  (define c2 (quadratic-c2 q))
  (and J
       (checked (e:* factor
                     (e:+ (e:/ (e:* (quadratic-slope q) (root Q)) (e:* 4 c2))
                          (e:* (e:/ (quadratic-delta q) (e:* 8 c2)) J)))
                e x A)))

;; β/(x√Q)
(define (over-variable-and-root e q x A)
  (define factor (simple (e:* e (e:* x (root (quadratic-all q)))) A))
  (define J (and (not (occurs? x factor)) (reciprocal-root-over-variable q x A)))
  (and J (checked (e:* factor J) e x A)))

;; β√Q/x
(define (root-over-variable e q x A)
  (define r (root (quadratic-all q)))
  (define factor (simple (e:/ (e:* e x) r) A))
  (define (both)
    (values (if (eqv? (quadratic-c0 q) 0) 0 (reciprocal-root-over-variable q x A))
            (reciprocal-root-integral q A)))
  (define-values (J0 J1) (if (occurs? x factor) (values #f #f) (both)))
  (and J0
       J1
       (checked (e:* factor (e:+ r (e:+ (e:* (quadratic-c0 q) J0)
                                        (e:* (e:/ (quadratic-c1 q) 2) J1))))
                e x A)))

;; ∫ dx/(x√Q), or #f
(define (reciprocal-root-over-variable q x A)
  (define-values (c0 c1) (values (quadratic-c0 q) (quadratic-c1 q)))
  (define s (simple (root (e:negate (quadratic-delta q))) A))
  (cond [(eqv? c0 0) (e:/ (e:* -2 (root (quadratic-all q))) (e:* c1 x))]
        [(eqv? -1 (known-sign c0 A))
         (e:/ (e:apply op:asin (e:/ (e:+ (e:* 2 c0) (e:* c1 x)) (e:* s x))) (root (e:negate c0)))]
        [else #f]))

;; Its derivative tells whether it is right.
(define (checked F e x A)
  (define simplified (simple F A))
  (and (eqv? 0 (simple (e:- (expression-derivative simplified x) e) A))
       simplified))
