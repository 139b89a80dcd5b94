#lang racket/base
;; Logarithms and absolute values, by the factors of their arguments.
;;
;; log eᵘ = u, log √u = 1/2 log u, log 1/u = -log u.  Else a single logarithm
;; stays as it is, but for that of a power whose base has a known sign; where several
;; occur, or an exponential is a factor, arguments are split, log(4x²y) = 2 log 2 +
;; 2 log x + log y, the factors being known or assumed not to be negative.  Where
;; nothing is known and nothing may be assumed, log x² = 2 log|x|, and factors to odd
;; powers stay together.
;;
;; The logarithm of a number not real stays as it is: log e^(it) is it up to 2πi.
;;
;; |c x²y| = |c| x² |y|, and |y|² = y²; |y| is y or -y if the sign of y is known.

(require racket/list
         "kernel.rkt" "kernel-collector.rkt"
         "../assumption/ledger.rkt"
         "../expression/exact-numbers.rkt" "../expression/expression.rkt"
         "../expression/operation.rkt" "../expression/simplifier.rkt"
         "../expression/substitute.rkt")

(provide visit-logarithm! settle-logarithms! visit-modulus!)

;; ---------------------------------------------------------------------------
;; Logarithms

(define (visit-logarithm! c n)
  (define u (simplifier-simplify (collector-simplifier c) (car (node-args n))))
  (cond [(eqv? u 1) (resolve-alias! c n 0)]
        [(not (known-real? (collector-simplifier c) u))
         (resolve! c n (intern-kernel! c (make-node op:log (list u))))]
        [(headed? u op:exp) (resolve-alias! c n (car (node-args u)))]
        [(and (symbolic-power? u)
              (taken-not-negative? (collector-simplifier c) (car (node-args u))))
         (resolve-alias! c n (e:* (cadr (node-args u))
                                  (make-node op:log (list (car (node-args u))))))]
        [else
         (hash-update! (collector-logarithms c) u (lambda (nodes) (cons n nodes)) '())]))

(define (symbolic-power? e)
  (and (headed? e op:expt) (not (number? (cadr (node-args e))))))

;; When all logarithms have been met.  The resolution of one may hold others.
(define (settle-logarithms! c)
  (define table (collector-logarithms c))
  (let loop ([several? (> (hash-count table) 1)])
    (define met (hash->list table))
    (hash-clear! table)
    (define all-parts
      (alike-squares c (for/list ([entry (in-list met)]) (logarithm-parts c (car entry)))))
    (for ([entry (in-list met)] [parts (in-list all-parts)])
      (settle-logarithm! c (car entry) parts (cdr entry) several?))
    (unless (null? met) (loop #t))))

;; (a - 1)² and (1 - a)² are the same.  If 1 - a stands in another logarithm, the square
;; is written with it: beside log(1 - a), log (a - 1)² is 2 log(1 - a).
(define (alike-squares c all-parts)
  (define single
    (for*/hash ([parts (in-list all-parts)] [p (in-list parts)] #:unless (even-power? p))
      (values (cdr p) #t)))
  (define (alike p)
    (define f (cdr p))
    (define other (and (even-power? p) (symbolic? f) (not (hash-ref single f #f)) (opposite c f)))
    (if (and other (hash-ref single other #f)) (cons (car p) other) p))
  (if (zero? (hash-count single))
      all-parts
      (for/list ([parts (in-list all-parts)]) (map alike parts))))

(define (even-power? p) (and (integer? (car p)) (even? (car p))))

;; parts : of log u, ((rational . expression) ...)
(define (settle-logarithm! c u parts nodes several?)
  (define whole (list (cons 1 u)))
  (define split? (or several? (for/or ([p (in-list parts)]) (headed? (cdr p) op:exp))))
  (define signed
    (cond [(equal? parts whole) parts]
          [(lone? parts) (if (negative-part? c (car parts)) (signed-parts c parts) parts)]
          [split? (signed-parts c parts)]
          [else (or (power-parts c parts) whole)]))
  (cond [(equal? signed whole)
         (define k (intern-kernel! c (make-node op:log (list u))))
         (for ([n (in-list nodes)]) (resolve! c n k))]
        [else
         (define sum (sum-of-logarithms c signed))
         (for ([n (in-list nodes)]) (resolve-alias! c n sum))]))

;; A single part that is not negative if the argument is not.
(define (lone? parts)
  (and (= 1 (length parts)) (not (even? (numerator (caar parts))))))

;; Then log x³ is 3 log x, but for a negative x: log -1 + 3 log(-x).
(define (negative-part? c p)
  (and (symbolic? (cdr p)) (eqv? -1 (decided-sign (collector-simplifier c) (cdr p)))))

;; The part of an even power with a base of known sign, or #f.
(define (power-parts c parts)
  (define f (and (= 1 (length parts)) (cdar parts)))
  (define sign (and f (symbolic? f) (sign-or-left-open (collector-simplifier c) f)))
  (and sign (list (cons (caar parts) (if (eqv? sign 1) f (opposite c f))))))

;; ---------------------------------------------------------------------------
;; Signs of parts

;; The same sum with logarithms of parts not negative.  Of a negative part the
;; opposite stands in it; if that changes the sign of the whole, so does one other.
(define (signed-parts c parts)
  (define s (collector-simplifier c))
  (define-values (positive negative unknown)
    (for/fold ([positive '()] [negative '()] [unknown '()]) ([p (in-list parts)])
      (define sign (if (symbolic? (cdr p)) (sign-or-assumed s (cdr p)) 1))
      (cond [(eqv? sign 1) (values (cons p positive) negative unknown)]
            [(and sign (integer? (car p))) (values positive (cons p negative) unknown)]
            [else (values positive negative (cons p unknown))])))
  (define-values (powers odd) (partition even-power? unknown))
  (define sign (expt -1 (apply + (map car negative))))
  (append (reverse positive)
          (for/list ([p (in-list powers)]) (cons (car p) (make-node op:abs (list (cdr p)))))
          (if (null? odd)
              (opposite-parts c (reverse negative) sign)
              (cons (joined-part c odd sign) (opposite-parts c (reverse negative) 1)))))

;; Parts of unknown sign as one.  A lone one is an odd power: log f³ = 3 log f.
(define (joined-part c parts sign)
  (define p (car parts))
  (if (and (null? (cdr parts)) (integer? (car p)))
      (if (eqv? sign 1) p (cons (car p) (opposite c (cdr p))))
      (cons 1 (joined c parts sign))))

;; The product of the parts' powers, and a sign.
(define (joined c parts sign)
  (simplifier-simplify
   (collector-simplifier c)
   (e:* sign (rebuild op:* (for/list ([p (in-list parts)]) (e:expt (cdr p) (car p)))))))

;; If the sign is -1, a part that is no power stays negative, or -1 is a part.
(define (opposite-parts c parts sign)
  (define kept
    (and (eqv? sign -1) (findf (lambda (p) (eqv? 1 (car p))) parts)))
  (define others
    (for/list ([p (in-list parts)] #:unless (eq? p kept)) (cons (car p) (opposite c (cdr p)))))
  (cond [kept (cons kept others)]
        [(eqv? sign -1) (cons (cons 1 -1) others)]
        [else others]))

;; ---------------------------------------------------------------------------
;; Factors

;; log u as ((rational . expression) ...), a multiple of the logarithm of each.
(define (logarithm-parts c u)
  (define-values (number factors) (simplifier-factors (collector-simplifier c) u))
  (define-values (positive signed) (absorb-sign c number factors))
  (append (number-parts positive (collector-inexact? c))
          (append-map (lambda (f) (factor-parts c (car f) (cdr f))) signed)))

;; log f^e, where f may be a root
(define (factor-parts c f e)
  (define-values (base exponent) (root-parts f))
  (if exponent
      (for/list ([p (in-list (logarithm-parts c base))])
        (cons (* e exponent (car p)) (cdr p)))
      (list (cons e f))))

(define (root-parts f)
  (cond [(headed? f op:sqrt) (values (car (node-args f)) 1/2)]
        [(and (headed? f op:expt) (rational? (cadr (node-args f))))
         (values (car (node-args f)) (cadr (node-args f)))]
        [else (values f #f)]))

;; A negative number makes the first factor to an odd power its opposite.
(define (absorb-sign c number factors)
  (define odd (findf (lambda (f) (odd? (cdr f))) factors))
  (if (and (negative? number) odd)
      (values (- number)
              (for/list ([f (in-list factors)])
                (if (eq? f odd) (cons (opposite c (car f)) (cdr f)) f)))
      (values number factors)))

(define (opposite c e) (simplifier-simplify (collector-simplifier c) (e:negate e)))

;; By primes, unless these are so large that the number was a flonum.
(define (number-parts x inexact?)
  (define factors (if (positive? x) (number-factors x) '()))
  (cond [(eqv? x 1) '()]
        [(and (pair? factors) (andmap (lambda (f) (< (car f) 1000000)) factors))
         (for/list ([f (in-list factors)]) (cons (cdr f) (car f)))]
        [else (list (cons 1 (present-number x inexact?)))]))

(define (sum-of-logarithms c parts)
  (rebuild op:+ (for/list ([p (in-list parts)]) (e:* (car p) (part-logarithm c (cdr p))))))

;; The logarithm of a factor, which is not visited again: it has no further factors.
(define (part-logarithm c f)
  (cond [(headed? f op:exp) (car (node-args f))]
        [(symbolic-power? f)
         (e:* (cadr (node-args f)) (make-node op:log (list (car (node-args f)))))]
        [else
         (define n (make-node op:log (list f)))
         (resolve! c n (intern-kernel! c n))
         n]))

;; ---------------------------------------------------------------------------
;; Absolute values

(define (visit-modulus! c n)
  (define s (collector-simplifier c))
  (define u (simplifier-simplify s (car (node-args n))))
  (define sign (decided-sign s u))
  (cond [sign (resolve-alias! c n (e:* sign u))]
        [(known-real? s u) (resolve-alias! c n (product-of-moduli c u))]
        [else (resolve! c n (intern-kernel! c (make-node op:abs (list u))))]))

(define (product-of-moduli c u)
  (define-values (number factors) (simplifier-factors (collector-simplifier c) u))
  (for/fold ([product (abs number)]) ([f (in-list factors)])
    (e:* product (modulus-power c (car f) (cdr f)))))

;; |f|^e, the kernel |f| being interned.
(define (modulus-power c f e)
  (define sign (if (even? e) 1 (sign-or-left-open (collector-simplifier c) f)))
  (cond [sign (e:* sign (e:expt f e))]
        [else
         (define n (make-node op:abs (list f)))
         (define k (intern-kernel! c n (modulus f)))
         ((collector-visit c) c f)
         (add-relation! c k)
         (resolve! c n k)
         (e:expt n e)]))
