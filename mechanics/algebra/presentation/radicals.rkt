#lang racket/base
;; A square root and the powers of its factors that stand beside it.
;;
;; In normal form a root holds no square, and factors outside stay there:
;; k/√(k m), √(G M/a)/a, ½ √(2 u/g).  All told, each factor b of the radicand has
;; a half-integer exponent f.  With f of both signs everything goes under the root,
;; √(k/m), √(G M/a³), or, f being ±n/2 throughout, becomes (k/m)^(n/2).  With f of
;; one sign integer parts stay outside: h √(2 g h), 1/√(2 g y).
;;
;; b √u is √(b² u) only if b is not negative; so a factor that goes under the root, or comes
;; out, to an odd power must not be negative, unless all of the radicand does, which
;; is not negative itself.

(require racket/list
         "term.rkt"
         "../expression/exact-numbers.rkt" "../expression/expression.rkt"
         "../expression/operation.rkt" "../expression/order.rkt"
         "../kernel/kernel.rkt")

(provide gather-under-roots)

;; The term with roots as they are best shown.
;; intern : expression -> kernel
;; not-negative? : expression -> is it known, or may it be taken, not to be negative?
(define (gather-under-roots t intern not-negative?)
  (if (ormap square-root? (map car (term-powers t)))
      (for/fold ([c (term-coefficient t)] [powers (term-powers t)]
                 #:result (make-term c powers))
                ([p (in-list (term-powers t))])
        (define factors
          (and (square-root? (car p))
               (odd? (cdr p))
               (radicand-factors (kernel-expression (car p)))))
        (if (and factors (pair? (cdr factors)))
            (gather c powers p factors intern not-negative?)
            (values c powers)))
      t))

(define (square-root? k)
  (define r (kernel-relation k))
  (and (root? r) (eqv? 2 (root-degree r)) (node? (root-radicand r))))

;; ---------------------------------------------------------------------------
;; Radicands as products

;; The factors ((expression . ±1) ...) of the radicand, a number one
;; of them perhaps; #f where it is no such product.
(define (radicand-factors e)
  (define factors
    (if (headed? e op:sqrt)
        (filter-not (lambda (f) (eqv? 1 (car f)))
                    (signed-operands (car (node-args e)) op:* op:/))
        '()))
  (and (pair? factors)
       (andmap (lambda (f) (or (symbolic? (car f)) (exact-positive-integer? (car f)))) factors)
       (not (ormap (lambda (f) (headed? (car f) op:expt)) factors))
       factors))

;; ---------------------------------------------------------------------------
;; Gathering

;; c · powers, with the root in p taken together with its factors outside, if
;; there are any or its number cancels something.
(define (gather c powers p factors intern not-negative?)
  (define n
    (for/product ([f (in-list factors)] #:when (number? (car f)))
      (expt (car f) (* (cdr p) (cdr f)))))
  (define others (filter-not (lambda (f) (number? (car f))) factors))
  (define-values (number inside) (share-number c n))
  (define (outside? q)
    (and (not (eq? q p))
         (for/or ([f (in-list others)]) (equal? (kernel-expression (car q)) (car f)))))
  (define exponents (total-exponents p others powers))
  (if (and (or (not (= number c)) (ormap outside? powers))
           (andmap not-negative? (bases-of-sign p others exponents)))
      (values number
              (append (root-powers inside exponents intern)
                      (filter-not (lambda (q) (or (eq? q p) (outside? q))) powers)))
      (values c powers)))

;; The factors on whose signs gathering depends: those of which an odd power passes
;; the root, unless one of all does.
(define (bases-of-sign p factors exponents)
  (define sign (common-sign exponents))
  (define odd-ones
    (for/list ([f (in-list factors)] [e (in-list exponents)]
               #:when (odd? (- (cdr e)
                               (* 1/2 (cdr p) (cdr f))
                               (if sign (- (cdr e) (* 1/2 sign)) 0))))
      (car f)))
  (if (= (length odd-ones) (length factors)) '() odd-ones))

;; 1 or -1 if all exponents have that sign, else #f.
(define (common-sign exponents)
  (cond [(andmap positive? (map cdr exponents)) 1]
        [(andmap negative? (map cdr exponents)) -1]
        [else #f]))

;; ((factor . half-integer) ...)
(define (total-exponents p factors powers)
  (for/list ([f (in-list factors)])
    (cons (car f)
          (for/fold ([e (* 1/2 (cdr p) (cdr f))])
                    ([q (in-list powers)] #:when (equal? (kernel-expression (car q)) (car f)))
            (+ e (cdr q))))))

;; c √n: squares leave the root, the denominator of c goes under it where that
;; cancels something.
(define (share-number c n)
  (define root
    (for/product ([f (in-list (number-factors n))]) (expt (car f) (quotient (cdr f) 2))))
  (define free (/ n (* root root)))
  (define number (* c root))
  (define q (denominator number))
  (if (> (gcd (numerator free) q) 1)
      (values (* number q) (/ free (* q q)))
      (values number free)))

;; Powers of kernels that stand for √inside ∏ bᶠ.
(define (root-powers inside exponents intern)
  (define n (abs (cdar exponents)))
  (define sign (common-sign exponents))
  (cond [sign (apart inside exponents sign intern)]
        [(and (eqv? inside 1) (> n 1/2)
              (andmap (lambda (f) (= n (abs (cdr f)))) exponents))
         (list (cons (intern (make-node op:expt (list (quotient-of 1 exponents (/ 1 n)) n))) 1))]
        [else
         (list (cons (intern (make-node op:sqrt (list (quotient-of inside exponents 2)))) 1))]))

;; Exponents of one sign: integer powers, and a root of the rest.
(define (apart inside exponents sign intern)
  (define root
    (make-node op:sqrt
               (list (quotient-of (expt inside sign)
                                  (for/list ([f (in-list exponents)]) (cons (car f) 1))
                                  1))))
  (cons (cons (intern root) sign)
        (for/list ([f (in-list exponents)] #:unless (= 1/2 (abs (cdr f))))
          (cons (intern (car f)) (- (cdr f) (* 1/2 sign))))))

;; c ∏ b^(scale f), the negative powers below, with the numerator of c above and its
;; denominator below.
(define (quotient-of c exponents scale)
  (define sorted (sort exponents expression<? #:key car))
  (define (product number sign)
    (for/fold ([product number]) ([f (in-list sorted)]
                                  #:when (positive? (* sign (cdr f))))
      (e:* product (e:expt (car f) (* sign scale (cdr f))))))
  (e:/ (product (numerator c) 1) (product (denominator c) -1)))
