#lang racket/base
;; Antiderivatives of expressions: of sums of waves, and of expressions that a substitution
;; turns into these.
;;
;; A sum of terms c xⁿ e^{px} w(ax + b), where w is 1, a cosine or a sine, and c, p, a
;; and b do not depend on x, is closed under products, since
;;
;;   cos A cos B = ½ cos(A − B) + ½ cos(A + B)      and so on;
;;
;; and its integral is such a sum again, powers of x going one by one in parts:
;;
;;   ∫ xⁿ f = xⁿ F − n ∫ xⁿ⁻¹ F,     F = e^{px} (p cos + a sin)/(p² + a²) for a cosine.
;;
;; Where some u occurs within a function in e, and e/u' depends on x through u alone, it
;; is integrated in u: x/√(x² + y²) with u = x² + y².  That is tried first, as
;; sin³x cos x looks better with u = sin x than as a sum of waves.

(require (only-in racket/list append-map remove-duplicates)
         "expression-function.rkt" "known-antiderivatives.rkt" "piecewise-antiderivative.rkt"
         "quadratic-antiderivative.rkt"
         "../algebra/expression/expression.rkt" "../algebra/expression/nodes.rkt"
         "../algebra/expression/operation.rkt"
         "../algebra/expression/substitute.rkt" "../algebra/expression/symbols.rkt"
         "../algebra/rewriting/apart.rkt" "../algebra/simplify/simplify-expression.rkt"
         "../algebra/zero/in-exponentials.rkt")

(provide antiderivative potential)

;; An expression whose derivative by the symbol x is e, or #f if none was found.
;; A : assumptions; branches? : may it have arcs, atan and asin, which jump where their
;; arguments are infinite, or have ends, and absolute values?
(define (antiderivative e x A [branches? #f])
  (define simple (simplify-expression e A))
  (define (further e) (antiderivative e x A branches?))
  (or (integral-by-substitution simple x A)
      (integral-of-waves simple x A)
      (and branches?
           (or (integral-of-quadratic simple x A)
               (integral-of-known simple x A)
               (integral-by-sides simple x A further)))
      (integral-term-by-term simple further)
      (and branches? (integral-of-other-form simple x A further))))

;; An expression whose derivatives by the symbols are the slopes, if they are those of any; the
;; value of (fail slope x) where an antiderivative was not found.
(define (potential slopes xs A [fail (lambda (slope x) #f)])
  (let/ec return
    (for/fold ([F 0]) ([slope (in-list slopes)] [x (in-list xs)])
      (define left (simplify-expression (e:- slope (expression-derivative F x)) A))
      (define integral (or (antiderivative left x A) (return (fail left x))))
      (simplify-expression (e:+ F integral) A))))

(define (integral-term-by-term e antiderivative)
  (and (sum? e)
       (let ([integrals (map antiderivative (node-args e))])
         (and (andmap values integrals) (rebuild (node-head e) integrals)))))

;; By partial fractions, or by exponentials in place of hyperbolic functions
(define (integral-of-other-form e x A antiderivative)
  (define-values (fractions _) (partial-fractions e x A))
  (or (and (not (equal? fractions e)) (integral-term-by-term fractions antiderivative))
      (let ([f (hyperbolic-in-exponentials e)])
        (and (not (eq? f e)) (integral-of-waves f x A)))))

;; ---------------------------------------------------------------------------
;; Terms

;; c xⁿ e^{px} w(ax + b), w ∈ one cosine sine
(struct term (c n p w a b) #:authentic)

(define (constant c) (term c 0 0 'one 0 0))
(define (plain? u) (and (eq? (term-w u) 'one) (eqv? (term-p u) 0)))

(define (scaled k u)
  (struct-copy term u [c (e:* k (term-c u))]))

;; The term in a list; a wave that does not depend on x joins the coefficient.
(define (wave c n p w a b)
  (define (of op) (e:apply op b))
  (cond [(eq? w 'one) (list (term c n p 'one 0 0))]
        [(not (eqv? a 0)) (list (term c n p w a b))]
        [(eq? w 'cosine) (list (term (e:* c (of op:cos)) n p 'one 0 0))]
        [else
         (define s (of op:sin))
         (if (eqv? s 0) '() (list (term (e:* c s) n p 'one 0 0)))]))

(define (term->expression u x)
  (define (factor op . args) (apply e:apply op args))
  (define angle (e:+ (e:* (term-a u) x) (term-b u)))
  (e:* (e:* (term-c u) (e:expt x (term-n u)))
       (e:* (if (eqv? (term-p u) 0) 1 (factor op:exp (e:* (term-p u) x)))
            (case (term-w u)
              [(one) 1]
              [(cosine) (factor op:cos angle)]
              [(sine) (factor op:sin angle)]))))

;; ---------------------------------------------------------------------------
;; Products

;; Products of more terms than these are not made.
(define most-terms 2000)

(define (product us vs A)
  (when (> (* (length us) (length vs)) most-terms) (fail))
  (for*/list ([u (in-list us)] [v (in-list vs)] [w (in-list (product-of-two u v A))]) w))

(define (product-of-two u v A)
  (define (simple e) (simplify-expression e A))
  (define c (e:* (term-c u) (term-c v)))
  (define n (simple (e:+ (term-n u) (term-n v))))
  (define p (simple (e:+ (term-p u) (term-p v))))
  (define (waves k w sign)
    (define (both part) (simple (e:+ (part u) (e:* sign (part v)))))
    (wave (e:* k c) n p w (both term-a) (both term-b)))
  (define-values (wu wv) (values (term-w u) (term-w v)))
  (cond [(eq? wv 'one) (waves 1 wu 1)]
        [(eq? wu 'one) (waves 1 wv 1)]
        [(and (eq? wu 'cosine) (eq? wv 'cosine))
         (append (waves 1/2 'cosine -1) (waves 1/2 'cosine 1))]
        [(and (eq? wu 'sine) (eq? wv 'sine))
         (append (waves 1/2 'cosine -1) (waves -1/2 'cosine 1))]
        [(eq? wu 'sine) (append (waves 1/2 'sine 1) (waves 1/2 'sine -1))]
        [else (product-of-two v u A)]))

;; The power r of a single term without a wave; of others only r = 1, 2, 3 ...  A power of x may
;; have any exponent without x, as n in xⁿ.
(define (power us r A)
  (define u (and (pair? us) (null? (cdr us)) (car us)))
  (cond [(exact-positive-integer? r)
         (for/fold ([result us]) ([_ (in-range (sub1 r))]) (product result us A))]
        [(and u (eq? (term-w u) 'one) (rational? r) (exact? r)
              (or (integer? r) (and (plain? u) (eqv? (term-c u) 1))))
         (list (term (e:expt (term-c u) r) (e:* r (term-n u)) (e:* r (term-p u)) 'one 0 0))]
        [(and u (plain? u) (eqv? (term-c u) 1) (symbolic? r))
         (list (term 1 (e:* r (term-n u)) 0 'one 0 0))]
        [else (fail)]))

;; ---------------------------------------------------------------------------
;; From expressions

(define (integral-of-waves e x A)
  (with-handlers ([no-sum-of-waves? (lambda (_) #f)])
    (simplify-expression
     (rebuild op:+ (for/list ([u (in-list (terms-of e x A))]) (term-integral u x)))
     A)))

;; Raised if an expression is no sum of waves, or its integral is none.
(struct no-sum-of-waves ())
(define (fail) (raise (no-sum-of-waves)))

(define (terms-of e x A)
  (define (combine n arguments)
    (define head (node-head n))
    (define args (map (lambda (us k) (or us (list (constant k)))) arguments (node-args n)))
    (define (argument k) (list-ref args k))
    (cond [(not (ormap values arguments)) #f]
          [(eq? head op:+) (apply append args)]
          [(eq? head op:-)
           (append (argument 0) (for/list ([u (in-list (argument 1))]) (scaled -1 u)))]
          [(eq? head op:*)
           (for/fold ([result (car args)]) ([us (in-list (cdr args))]) (product result us A))]
          [(eq? head op:/) (product (argument 0) (power (argument 1) -1 A) A)]
          [(and (eq? head op:expt) (not (cadr arguments)))
           (power (argument 0) (cadr (node-args n)) A)]
          [(eq? head op:sqrt) (power (argument 0) 1/2 A)]
          [(memq head (list op:exp op:sin op:cos)) (function-of-line head (argument 0) A)]
          [else (fail)]))
  (or (node-fold e
                 (lambda (leaf) (and (eq? leaf x) (list (term 1 1 0 'one 0 0))))
                 combine)
      (list (constant e))))

;; Of an argument a x + b.
(define (function-of-line head us A)
  (define (coefficient n)
    (for/fold ([sum 0] #:result (simplify-expression sum A)) ([u (in-list us)])
      (if (eqv? (term-n u) n) (e:+ sum (term-c u)) sum)))
  (unless (andmap (lambda (u) (and (plain? u) (memv (term-n u) '(0 1)))) us) (fail))
  (define-values (a b) (values (coefficient 1) (coefficient 0)))
  (cond [(eq? head op:exp) (list (term (e:apply op:exp b) 0 a 'one 0 0))]
        [else (wave 1 0 0 (if (eq? head op:sin) 'sine 'cosine) a b)]))

;; ---------------------------------------------------------------------------
;; Integrals

;; -> an expression
(define (term-integral u x)
  (define-values (c n) (values (term-c u) (term-n u)))
  (cond [(not (plain? u))
         (unless (exact-nonnegative-integer? n) (fail))
         (rebuild op:+ (for/list ([v (in-list (integral-in-parts u n))])
                         (term->expression v x)))]
        [(eqv? n -1) (e:* c (e:apply op:log x))]
        [else (e:* (e:/ c (e:+ n 1)) (e:expt x (e:+ n 1)))]))

(define (integral-in-parts u n)
  (define F (integral-of-wave u))
  (append (map (lambda (v) (struct-copy term v [n n])) F)
          (if (zero? n)
              '()
              (for*/list ([v (in-list F)] [w (in-list (integral-in-parts v (- n 1)))])
                (scaled (- n) w)))))

;; ∫ c e^{px} w(ax + b) without the power of x
(define (integral-of-wave u)
  (define-values (c p a) (values (term-c u) (term-p u) (term-a u)))
  (define square (e:+ (e:expt p 2) (e:expt a 2)))
  (define (part k w) (struct-copy term u [c (e:/ (e:* k c) square)] [w w]))
  (define both
    (case (term-w u)
      [(one) (list (struct-copy term u [c (e:/ c p)]))]
      [(cosine) (list (part p 'cosine) (part a 'sine))]
      [else (list (part p 'sine) (part (e:negate a) 'cosine))]))
  (filter (lambda (v) (not (eqv? (term-c v) 0))) both))

;; ---------------------------------------------------------------------------
;; Substitution

(define (integral-by-substitution e x A)
  (for/or ([u (in-list (arguments-within e x))])
    (define slope (simplify-expression (expression-derivative u x) A))
    (and (not (eqv? slope 0)) (integral-in u slope e x A))))

;; ∫ e/u' du, if e/u' depends on x through u alone.  Of a line u, x itself is one in u.
(define (integral-in u slope e x A)
  (define y (string->uninterned-symbol "u"))
  (define x-by-y
    (and (not (occurs? x slope)) (e:/ (e:- y (substitute-expression u (list (cons x 0)))) slope)))
  (define in-y
    (if x-by-y
        (substitute-expression e (list (cons u y) (cons x x-by-y)))
        (substitute-expression (simplify-expression (e:/ e slope) A) (list (cons u y)))))
  (define (of-whole e) (or (integral-of-waves e y A) (integral-of-known e y A)))
  (define integral
    (and (not (occurs? x in-y))
         (of-whole (if x-by-y (simplify-expression (e:/ in-y slope) A) in-y))))
  (and integral (simplify-expression (substitute-expression integral (list (cons y u))) A)))

;; Candidates for a substitution, the innermost first: arguments, other than x, of functions and
;; powers in e that depend on x, these functions themselves, functions of which literal functions
;; are derivatives, and denominators.
(define (arguments-within e x)
  (define (moving es) (filter (lambda (u) (occurs? x u)) es))
  (define (candidates n)
    (define args (node-args n))
    (cond [(null? (moving args)) '()]
          [(headed? n op:/) (moving (cdr args))]
          [(memq (node-head n) (list op:+ op:- op:*)) '()]
          [else (append (moving args) (lowered n) (list n))]))
  (define (good? u) (not (or (eq? u x) (tuple-of-arguments? u))))
  (remove-duplicates (filter good? (append-map candidates (nodes-in e)))))

(define (tuple-of-arguments? u)
  (or (headed? u op:up) (headed? u op:down)))

;; The applied literal functions of which n may be a derivative.
(define (lowered n)
  (define head (node-head n))
  (for/list ([entry (in-list (if (literal-head? head) (literal-head-index head) '()))])
    (define index
      (for*/list ([other (in-list (literal-head-index head))]
                  [count (in-value (if (eq? other entry) (sub1 (cdr other)) (cdr other)))]
                  #:unless (zero? count))
        (cons (car other) count)))
    (make-node (make-literal-head (literal-head-name head) index) (node-args n))))
