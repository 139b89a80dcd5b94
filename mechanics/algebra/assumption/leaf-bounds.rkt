#lang racket/base
;; Bounds of a symbol's values, from relations.
;;
;; A relation that is linear in a single symbol, or literal function applied,
;; bounds it from one side.  Where a point is looked for, numbers are chosen within; a proof asks
;; for bounds that are never too narrow, though a relation speaks of π.

(require racket/list
         "assumption-set.rkt" "interval.rkt" "range.rkt" "signs.rkt"
         "../expression/expression.rkt" "../expression/operation.rkt" "../expression/pi.rkt"
         "../expression/symbols.rkt")

(provide bounds-from bounds-around bounds-of)

;; -> table: leaf -> interval
(define (bounds-from relations) (bounds-with about-pi about-pi relations))

;; The same, and certainly as wide as the relations allow
(define (bounds-around relations)
  (bounds-with (interval-low around-pi) (interval-high around-pi) relations))

;; π is between the first two
(define (bounds-with less more relations)
  (for/fold ([table (hash)]) ([r (in-list relations)]) (narrow-bounds table r less more)))

(define (bounds-of table leaf) (hash-ref table leaf everything))

(define (narrow-bounds table r less more)
  (define-values (leaf a b) (affine (relation-expression r) less))
  (define-values (_ same-a c) (affine (relation-expression r) more))
  (cond [leaf
         (define bounds (list (- (/ b a)) (- (/ c a))))
         (define side (if (positive? a) (relation-signs r) (signs-negate (relation-signs r))))
         (hash-update table leaf (lambda (r) (intersection r (beyond bounds side))) everything)]
        [else table]))

;; The values on this side of a bound that is between two numbers
(define (beyond bounds side)
  (cond [(signs-within? side nonnegative) (interval (apply min bounds) +inf.0)]
        [(signs-within? side nonpositive) (interval -inf.0 (apply max bounds))]
        [else everything]))

;; Bounds are a guide, and a point is shown to people.
(define about-pi 355/113)

;; e as a · leaf + b with exact numbers, this one in the place of π, or #f #f #f.
(define (affine e pi)
  (define terms (affine-terms e pi))
  (define all (and terms (filter car terms)))
  (define leaf (and (pair? all) (caar all)))
  (define (total terms) (for/sum ([t (in-list terms)]) (inexact->exact (cdr t))))
  (if (and leaf
           (for/and ([t (in-list all)]) (equal? (car t) leaf))
           (not (eqv? 0 (total all))))
      (values leaf (total all) (total (filter-not car terms)))
      (values #f #f #f)))

;; -> ((leaf-or-#f . number) ...), whose sum e is, or #f
(define (affine-terms e pi)
  (define (terms-of e) (affine-terms e pi))
  (define head (and (node? e) (node-head e)))
  (define (scale c terms)
    (and terms (for/list ([t (in-list terms)]) (cons (car t) (* c (cdr t))))))
  (define (join parts) (and (andmap values parts) (append* parts)))
  (cond [(number? e) (and (rational? e) (list (cons #f e)))]
        [(pi-multiple e) => (lambda (k) (list (cons #f (* k pi))))]
        [(unknown? e) (list (cons e 1))]
        [(eq? head op:+) (join (map terms-of (node-args e)))]
        [(eq? head op:-)
         (join (list (terms-of (car (node-args e)))
                     (scale -1 (terms-of (cadr (node-args e))))))]
        [(and (eq? head op:*) (number? (car (node-args e))) (null? (cddr (node-args e))))
         (scale (car (node-args e)) (terms-of (cadr (node-args e))))]
        [else #f]))
