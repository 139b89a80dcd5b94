#lang racket/base
;; The range of a polynomial in one unknown, by Horner's rule: x (x − 2) + 2 does not forget
;; that x² and 2 x are of the same x, as the sum of their ranges does.

(require racket/list
         "interval.rkt"
         "../expression/expression.rkt" "../expression/operation.rkt"
         "../expression/symbols.rkt")

(provide polynomial-range)

;; places : unknown -> the interval it is in
;; -> interval, or #f if e is no polynomial in one unknown with exact coefficients
(define (polynomial-range e places)
  (let/ec return
    (define unknown #f)
    (define (variable x)
      (unless unknown (set! unknown x))
      (if (equal? x unknown) '(0 1) (return #f)))
    (define coefficients
      (node-fold e
                 (lambda (leaf)
                   (cond [(symbol? leaf) (variable leaf)]
                         [(and (rational? leaf) (exact? leaf)) (list leaf)]
                         [else (return #f)]))
                 (lambda (n parts)
                   (or (if (unknown? n) (variable n) (combined n parts)) (return #f)))))
    (and unknown (Horner coefficients (places unknown)))))

;; Coefficients of an operation on polynomials, the constant one first; or #f.
(define (combined n parts)
  (define head (node-head n))
  (define (all f) (for/fold ([p (car parts)]) ([q (in-list (cdr parts))]) (f p q)))
  (cond [(eq? head op:+) (all plus)]
        [(eq? head op:-) (plus (car parts) (map - (cadr parts)))]
        [(eq? head op:*) (all times)]
        [(and (eq? head op:expt) (exact-nonnegative-integer? (cadr (node-args n)))
              (<= (cadr (node-args n)) most-power))
         (for/fold ([p '(1)]) ([_ (in-range (cadr (node-args n)))]) (times p (car parts)))]
        [else #f]))

(define most-power 12)

(define (plus p q)
  (cond [(null? p) q]
        [(null? q) p]
        [else (cons (+ (car p) (car q)) (plus (cdr p) (cdr q)))]))

(define (times p q)
  (for/fold ([sum '()]) ([c (in-list p)] [k (in-naturals)])
    (plus sum (append (make-list k 0) (map (lambda (x) (* c x)) q)))))

(define (Horner coefficients r)
  (for/fold ([value (point-interval 0)]) ([c (in-list (reverse coefficients))])
    (interval-sum (interval-product value r) (point-interval c))))
