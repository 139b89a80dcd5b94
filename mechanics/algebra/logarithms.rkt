#lang racket/base
;; Logarithms and absolute values, by the factors of their arguments.
;;
;; log eᵘ = u.  A single logarithm stays as it is; where several occur their
;; arguments are split, log(x²y) = 2 log x + log y, and that the factors are
;; not negative is assumed.  |c x²y| = |c| x² |y|, and |y|² = y².

(require "operation.rkt" "expression.rkt" "kernel.rkt" "services.rkt" "collector.rkt")

(provide visit-logarithm! settle-logarithms! visit-modulus!)

;; ---------------------------------------------------------------------------
;; Logarithms

(define (visit-logarithm! c n)
  (define u ((services-simplify (collector-services c)) (car (node-args n))))
  (cond [(eqv? u 1) (resolve-alias! c n 0)]
        [(headed? u op:exp) (resolve-alias! c n (car (node-args u)))]
        [(symbolic-power? u)
         ((services-assume! (collector-services c)) (car (node-args u)))
         (resolve-alias! c n (e:* (cadr (node-args u))
                                  (make-node op:log (list (car (node-args u))))))]
        [else
         (hash-update! (collector-logarithms c) u (lambda (nodes) (cons n nodes)) '())]))

(define (headed? e op) (and (node? e) (eq? (node-head e) op)))

(define (symbolic-power? e)
  (and (headed? e op:expt) (not (number? (cadr (node-args e))))))

;; When all logarithms have been met.
(define (settle-logarithms! c)
  (define table (collector-logarithms c))
  (define several? (> (hash-count table) 1))
  (for* ([(u nodes) (in-hash table)])
    (define parts (if several? (logarithm-parts c u) (list (cons 1 u))))
    (cond [(whole? parts u)
           (define k (intern-kernel! c (make-node op:log (list u))))
           (for ([n (in-list nodes)]) (resolve! c n k))]
          [else
           (define sum (sum-of-logarithms c parts))
           (for ([n (in-list nodes)]) (resolve-alias! c n sum))])))

(define (whole? parts u)
  (and (null? (cdr parts)) (eqv? (caar parts) 1)))

;; log u as ((integer . expression) ...), a multiple of each logarithm.
(define (logarithm-parts c u)
  (define s (collector-services c))
  (define-values (number factors) ((services-factors s) u))
  (define all (if (eqv? number 1) factors (cons (cons number 1) factors)))
  (unless (and (pair? all) (null? (cdr all)) (eqv? 1 (cdar all)))
    (for ([f (in-list factors)]) ((services-assume! s) (car f))))
  (for/list ([f (in-list all)]) (cons (cdr f) (car f))))

(define (sum-of-logarithms c parts)
  (for/fold ([sum 0]) ([p (in-list parts)])
    (define n (make-node op:log (list (cdr p))))
    (resolve! c n (intern-kernel! c n))
    (e:+ sum (e:* (car p) n))))

;; ---------------------------------------------------------------------------
;; Absolute values

(define (visit-modulus! c n)
  (define s (collector-services c))
  (define u ((services-simplify s) (car (node-args n))))
  (define-values (number factors) ((services-factors s) u))
  (resolve-alias! c n
                  (for/fold ([product (abs number)]) ([f (in-list factors)])
                    (e:* product (modulus-power c (car f) (cdr f))))))

;; |f|^e, the kernel |f| being interned.
(define (modulus-power c f e)
  (cond [(or (even? e) (never-negative? f)) (e:expt f e)]
        [else
         (define n (make-node op:abs (list f)))
         (define k (intern-kernel! c n (modulus f)))
         ((collector-visit c) c f)
         (add-relation! c k)
         (resolve! c n k)
         (e:expt n e)]))

(define (never-negative? f)
  (and (node? f) (memq (node-head f) (list op:exp op:sqrt op:abs op:cosh)) #t))
