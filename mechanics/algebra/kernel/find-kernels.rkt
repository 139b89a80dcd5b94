#lang racket/base
;; Finding the kernels of an expression.
;;
;; One walk over the graph meets every node that is not arithmetic and decides
;; its resolution: a kernel of its own, the sine or cosine of an angle, a
;; root, a product of exponentials, or another expression.  Kernels whose
;; canonical expressions are equal are one kernel.  Choices that depend on all that
;; occurs (which angles and exponents are basic) are made at the end.
;;
;; Arguments of kernels are simplified first, by the simplifier above.

(require racket/list
         "angles.rkt" (only-in "circle.rkt" signed-angle) "kernel-collector.rkt" "exponentials.rkt"
         "kernel.rkt" "logarithms.rkt" "turns.rkt"
         (only-in "../assumption/ledger.rkt" strict-sign)
         "../expression/exact-numbers.rkt" "../expression/expression.rkt"
         "../expression/operation.rkt" "../expression/order.rkt" "../expression/pi.rkt"
         "../expression/simplifier.rkt" "../expression/size.rkt"
         "../radical/radical-expression.rkt"
         "../../error/refusal.rkt")

(provide (struct-out atlas) collect-kernels imaginary-unit
         (struct-out circular) (struct-out surd) (struct-out exponential-power)
         (struct-out alias))

;; The findings.  resolutions : node, symbol or odd number -> kernel, circular,
;; surd, exponential-power or alias.  tower : roots, and kernels of absolute
;; values, those within others after them.  doubled : circles of which twice the
;; angle occurred.  dependent? : were there angles that are not basic?
;; inexact? : did a flonum occur?
(struct atlas (kernels resolutions tower doubled dependent? inexact? simplifier)
  #:authentic)

;; blocked : nodes to be taken as they simplify by themselves, not expanded; if e
;; is one, its operands are simplified.
(define (collect-kernels e s [blocked '()])
  (define c (make-collector s visit! e blocked))
  (visit! c e)
  (settle-logarithms! c)
  (settle-exponentials! c)
  (settle-angles! c 'circular 1)
  (settle-angles! c 'hyperbolic -1)
  (settle-roots! c)
  (atlas (hash-values (collector-kernels c))
         (collector-resolutions c)
         (collector-tower c)
         (doubled-circles c)
         (dependent-angles? c)
         (collector-inexact? c)
         s))

;; ---------------------------------------------------------------------------
;; The walk

(define (visit! c e)
  (cond [(number? e) (visit-number! c e)]
        [(hash-ref (collector-resolutions c) e #f) (void)]
        [(pi-alias? e) (resolve-alias! c e (pi-expression e))]
        [(symbol? e) (resolve! c e (intern-kernel! c e))]
        [else
         (resolve! c e #t)
         (if (memq e (collector-blocked c))
             (visit-blocked! c e)
             (visit-node! c e))]))

;; The multiple of :pi that a name such as :2pi stands for.
(define (pi-expression s) (e:* (pi-multiple s) exact-pi))

(define (visit-number! c e)
  (cond [(exact-constant? e)
         (unless (exact? e) (set-collector-inexact?! c #t))
         (unless (real? e)
           (resolve! c imaginary-unit (surd 1 (intern-root! c -1 2) 2 1)))]
        [else (resolve! c e (intern-kernel! c e))]))

(define (visit-node! c n)
  (define head (node-head n))
  (define args (node-args n))
  (cond [(literal-head? head) (visit-kernel! c n)]
        [(memq head arithmetic) (for ([a (in-list args)]) (visit! c a))]
        [(eq? head op:expt) (visit-power! c n (car args) (cadr args))]
        [(eq? head op:sqrt) (visit-root! c n (car args) 1/2)]
        [(memq head functions-of-angles) (visit-angle! c n)]
        [(eq? head op:exp) (visit-exponential! c n)]
        [(eq? head op:log) (visit-logarithm! c n)]
        [(eq? head op:abs) (visit-modulus! c n)]
        [(eq? head op:sgn) (visit-sign! c n)]
        [else (visit-function! c n)]))

(define arithmetic (list op:+ op:- op:* op:/))
(define inverse (operations-where arc))
(define odd (cons op:atan (operations-where odd)))

;; A blocked node's simplified form stands for it; a sum as one kernel.
(define (visit-blocked! c n)
  (define simple
    (if (eq? n (collector-root c))
        (simplify-arguments c n)
        (simplifier-simplify (collector-simplifier c) n)))
  (if (and (node? simple) (memq (node-head simple) (list op:+ op:- (node-head n))))
      (resolve! c n (intern-kernel! c simple))
      (resolve-alias! c n simple)))

;; ---------------------------------------------------------------------------
;; Kernels of their own

(define (visit-kernel! c n)
  (resolve! c n (intern-kernel! c (simplify-arguments c n))))

;; sgn u is a number where the sign of u is known.
(define (visit-sign! c n)
  (define s (collector-simplifier c))
  (define sign (strict-sign s (simplifier-simplify s (car (node-args n)))))
  (if sign (resolve-alias! c n sign) (visit-function! c n)))

(define (visit-function! c n)
  (define simple (simplify-arguments c n))
  (define x
    (or (exact-value simple)
        (and (memq (node-head simple) inverse)
             (inverse-multiple (collector-simplifier c) simple))
        (opposite-value (collector-simplifier c) simple)))
  (if x
      (resolve-alias! c n x)
      (resolve! c n (intern-kernel! c simple))))

;; -f(-u) for an odd f of a u with a negative leading term, else #f.
(define (opposite-value s n)
  (define (of u) (make-node (node-head n) (list u)))
  (define args (node-args n))
  (define signed
    (and (null? (cdr args)) (memq (node-head n) odd) (signed-angle s (car args) of)))
  (and signed (eqv? (cdr signed) -1) (e:negate (car signed))))

;; The value of a function of exact numbers if that is exact, as atan 0 and acos 1 are;
;; else #f.
(define (exact-value n)
  (define numeric (and (not (literal-head? (node-head n))) (operation-numeric (node-head n))))
  (define args (node-args n))
  (define x
    (and numeric
         (andmap (lambda (a) (and (real? a) (exact? a))) args)
         (not (equal? args '(0 0)))             ; atan 0 0
         (if-raised divided-by-zero? #f (apply numeric args))))
  (and x (real? x) (exact? x) x))

;; n with its arguments simplified; structured arguments by components.
(define (simplify-arguments c n)
  (with-operands n (for/list ([a (in-list (node-args n))]) (simplify-argument c a))))

(define (simplify-argument c a)
  (cond [(pi-alias? a) (pi-expression a)]
        [(not (node? a)) a]
        [(memq (node-head a) (list op:up op:down)) (simplify-arguments c a)]
        [else (simplifier-simplify (collector-simplifier c) a)]))

;; ---------------------------------------------------------------------------
;; Powers and roots

(define (visit-power! c n base exponent)
  (define k (exact-exponent exponent))
  (cond [(integer? k) (visit! c base)]
        [k (visit-root! c n base k)]
        [(symbolic? exponent) (visit-symbolic-power! c n base exponent)]
        [else (visit-kernel! c n)]))

(define (visit-root! c n base k)
  (define number (and (node? base) (power-of-constant base k)))
  (if number (resolve-alias! c n number) (visit-split-root! c n base k)))

(define (visit-split-root! c n base k)
  (define degree (denominator k))
  (define-values (outer roots)
    (simplifier-split-root (collector-simplifier c) base degree))
  (cond [(or (null? roots) (and (null? (cdr roots)) (eqv? (cdar roots) (/ 1 degree))))
         (visit-surd! c n base k outer (and (pair? roots) (caar roots)))]
        [else (resolve-alias! c n (root-product outer roots (numerator k)))]))

;; outer^k times inner^(k/degree); no inner if that is #f
(define (visit-surd! c n base k outer inner)
  (define degree (denominator k))
  (define r (and inner (intern-root! c inner degree)))
  (when (and r (eqv? degree 2)) (consider-radicand! c r outer inner base))
  (visit! c outer)
  (resolve! c n (surd outer r degree (numerator k))))

(define (root-product outer roots power)
  (for/fold ([product (if (eqv? outer 1) 1 (make-node op:expt (list outer power)))])
            ([r (in-list roots)])
    (e:* product (make-node op:expt (list (car r) (* power (cdr r)))))))

;; Roots of one radicand are powers of one root.
(define (intern-root! c radicand degree)
  (define roots (collector-roots c))
  (define known (hash-ref roots radicand #f))
  (cond [known
         (set-root-degree! known (lcm degree (root-degree known)))
         known]
        [else
         (visit! c radicand)
         (define r (root radicand degree 1 '() #f))
         (hash-set! roots radicand r)
         (add-relation! c r)
         r]))

;; A sum of squares is kept as it was written, if that is shorter, with its
;; denominator under the root: distances have such radicands.
(define (consider-radicand! c r outer inner base)
  (when (and (sum? base) (reciprocal? outer))
    (define tidy (tidy-sum c base))
    (when (< (expression-size tidy) (expression-size inner))
      (visit! c tidy)
      (visit! c outer)
      (set-root-candidates! r (cons (cons tidy outer) (root-candidates r))))))

(define (reciprocal? e)
  (or (eqv? e 1)
      (and (headed? e op:/) (eqv? 1 (car (node-args e))))))

;; The sum of the operands, each simplified, powers of sums not expanded; the
;; longest first.
(define (tidy-sum c e)
  (define compare (make-order))
  (define (before? a b)
    (define d (- (expression-size (cdr b)) (expression-size (cdr a))))
    (or (< d 0) (and (eqv? d 0) (< (compare (cdr a) (cdr b)) 0))))
  (signed-sum
   (sort (for/list ([a (in-list (signed-operands e op:+ op:-))])
           (cons (cdr a) (tidy-power c (car a))))
         before?)))

(define (signed-sum operands)
  (define (of sign) (filter (lambda (a) (eqv? sign (car a))) operands))
  (define plus (of 1))
  (define minus (of -1))
  (if (and (= 1 (length plus)) (= 1 (length minus)))
      (make-node op:- (list (cdar plus) (cdar minus)))
      (make-node op:+ (append (map cdr plus) (map (lambda (a) (e:negate (cdr a))) minus)))))

(define (tidy-power c e)
  (define (simplify e) (simplifier-simplify (collector-simplifier c) e))
  (define base+exponent (power-parts e))
  (if base+exponent
      (e:expt (simplify (car base+exponent)) (cdr base+exponent))
      (simplify e)))

;; (base . exponent) if e is a power, or a product of equal factors; else #f.
(define (power-parts e)
  (define args (if (node? e) (node-args e) '()))
  (cond [(null? args) #f]
        [(eq? (node-head e) op:expt)
         (and (exact-integer? (cadr args)) (cons (car args) (cadr args)))]
        [else
         (and (eq? (node-head e) op:*)
              (= 1 (length (remove-duplicates args)))
              (cons (car args) (length args)))]))

(define (settle-roots! c)
  (for ([r (in-hash-values (collector-roots c))])
    (choose-radicand! r)
    (set-root-kernel! r (intern-kernel! c (root-expression r) r))))

;; The shortest of the candidates, if the degree has not grown meanwhile.
(define (choose-radicand! r)
  (define candidates (sort (root-candidates r) shorter-expression? #:key car))
  (when (and (pair? candidates) (eqv? 2 (root-degree r)))
    (define best (car candidates))
    (set-root-radicand! r (car best))
    (set-root-scale! r (cdr best))))

(define (root-expression r)
  (define u (root-radicand r))
  (cond [(not (eqv? (root-degree r) 2)) (make-node op:expt (list u (/ 1 (root-degree r))))]
        [(eqv? u -1) imaginary-unit]
        [else (make-node op:sqrt (list u))]))

(define imaginary-unit +i)
