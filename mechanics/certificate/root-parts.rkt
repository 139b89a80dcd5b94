#lang racket/base
;; A square root as a product: √(4 x²y) = 2 |x| √y.
;;
;; The radicand is factored.  A factor of which the sign is known leaves the root with half of its
;; exponent; of unknown ones even powers leave it as absolute values, and what is left stays under
;; one root, without divisors.

(require racket/list
         "Coq-term.rkt"
         (only-in "../algebra/assumption/assumption-set.rkt"
                  no-assumptions with-automatic-assumptions)
         "../algebra/expression/exact-numbers.rkt" "../algebra/expression/expression.rkt"
         "../algebra/expression/nodes.rkt" "../algebra/expression/operation.rkt"
         "../algebra/field/field.rkt" "../algebra/kernel/kernel.rkt"
         "../algebra/polynomial/fraction.rkt" "../algebra/polynomial/polynomial.rkt"
         "../algebra/rewriting/factor.rkt"
         "../algebra/simplify/simplify-expression.rkt")

(provide root-parts factors-of product-parts weak-sign)

;; u : radicand; A : assumptions
;; -> what stands before the root, the radicands of the roots that are left, all but the last known
;; not to be negative, and the last or #f
(define (root-parts u A)
  (define-values (number factors) (factors-of u A))
  (define-values (outer roots rest sign)
    (for/fold ([outer 1] [roots '()] [rest 1] [sign (if (negative? number) -1 1)])
              ([f (in-list factors)])
      (define-values (base k) (values (car f) (cdr f)))
      (define s (weak-sign base A))
      (define size (e:* (or s 1) base))
      (define half (floor (/ k 2)))
      (define whole (e:expt (if s size (make-node op:abs (list base))) half))
      (cond [(even? k) (values (e:* outer whole) roots rest sign)]
            [s (values (e:* outer whole) (cons size roots) rest (* s sign))]
            [else (values (e:* outer whole) roots (e:* rest base) sign)])))
  (when (and (eqv? rest 1) (eqv? sign -1)) (give-up "a radicand is negative"))
  (define-values (whole primes) (number-root (abs number)))
  (values (e:* whole outer)
          (append primes (reverse roots))
          (and (not (eqv? rest 1)) (e:* sign rest))))

;; -> the number in u, and its factors ((base . exponent) ...); a power in u stays a power, also
;; where sin²θ = 1 - cos²θ makes a sum of it
(define (factors-of u A)
  (define-values (factored _) (factored-expression u (with-automatic-assumptions A #f)))
  (define-values (number factors) (product-parts factored))
  (define-values (own-number own) (own-parts u))
  (if (and (equal? (map cdr factors) '(1)) (not (equal? (map cdr own) '(1))))
      (values own-number own)
      (values number factors)))

;; The number and the factors of u as it stands, equal bases together
(define (own-parts u)
  (define-values (number factors) (product-parts u))
  (values number
          (for/fold ([all '()]) ([f (in-list factors)])
            (define same (assoc (car f) all))
            (cons (cons (car f) (+ (cdr f) (if same (cdr same) 0)))
                  (if same (remove same all) all)))))

;; √q = whole √p₁ √p₂ ...
(define (number-root q)
  (for/fold ([whole 1] [primes '()]) ([f (in-list (number-factors q))])
    (values (* whole (expt (car f) (floor (/ (cdr f) 2))))
            (if (odd? (cdr f)) (cons (car f) primes) primes))))

;; -> the number, and ((base . exponent) ...)
;; plain? : are divisors within kernels the only ones left in sums?
(define (product-parts e [k 1] [plain? #f])
  (define args (if (node? e) (node-args e) '()))
  (define (all es ks)
    (for/fold ([number 1] [factors '()]) ([a (in-list es)] [k (in-list ks)])
      (define-values (n more) (product-parts a k plain?))
      (values (* number n) (append factors more))))
  (cond [(number? e) (values (expt (rational-constant e) k) '())]
        [(headed? e op:*) (all args (map (lambda (_) k) args))]
        [(headed? e op:/) (all args (list k (- k)))]
        [(and (node? e) (integer-power? e)) (product-parts (car args) (* k (cadr args)) plain?)]
        [(and (not plain?) (some-node? (lambda (n) (headed? n op:/)) e))
         (define-values (above below) (plain-fraction e))
         (product-parts (e:/ above below) k #t)]
        [else (values 1 (list (cons e k)))]))

;; Numerator and denominator as sums of terms, without divisors in them: a/b - 1 is (a - b)/b.
(define (plain-fraction e)
  (define-values (F f _) (normal-form e (with-automatic-assumptions no-assumptions #f)))
  (define (plain p)
    (for/fold ([sum 0]) ([t (in-list (summands F p))])
      (e:+ sum
           (for/fold ([product (car t)]) ([x (in-list (cdr t))])
             (e:* product (e:expt (kernel-expression (power-base x)) (power-exponent x)))))))
  (values (plain (fraction-numerator f))
          (for/fold ([product 1]) ([h (in-list (fraction-denominator-factors f))])
            (e:* product (e:expt (plain (power-base h)) (power-exponent h))))))

;; 1 if e is known not to be negative, -1 if not to be positive, else #f
(define (weak-sign e A)
  (define B (with-automatic-assumptions A #f))
  (define (simple x) (simplify-expression x B))
  (define size (simple (make-node op:abs (list e))))
  (cond [(equal? size (simple e)) 1]
        [(equal? size (simple (e:negate e))) -1]
        [else #f]))
