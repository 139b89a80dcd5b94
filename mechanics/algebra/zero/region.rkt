#lang racket/base
;; Where relations hold: a guide to points that satisfy them, and a check.
;;
;; A relation that is linear in a single symbol, or literal function applied,
;; bounds it from one side; numbers are chosen within those bounds.  All
;; relations that concern an expression are checked at a point chosen for it.

(require racket/list
         "approximate.rkt"
         "../assumption/assumption-set.rkt" "../assumption/signs.rkt"
         "../expression/expression.rkt" "../expression/flat-graph.rkt"
         "../expression/operation.rkt" "../expression/symbols.rkt")

(provide make-region region-free? region-place region-admits?)

;; ranges : leaf -> (low . high), #f where there is no bound
;; conditions : ((tape . signs) ...)
(struct region (ranges conditions) #:authentic)

;; The relations with a leaf in common with the tape.
(define (make-region relations t)
  (define concerned
    (if (null? relations)
        '()
        (let ([items (for/hash ([e (in-vector (tape-items t))] #:when (unknown? e)) (values e #t))])
          (for/list ([r (in-list relations)]
                     #:when (for/or ([l (in-list (leaves (relation-expression r)))])
                              (hash-ref items l #f)))
            r))))
  (region (for/fold ([ranges (hash)]) ([r (in-list relations)]) (narrow-range ranges r))
          (for/list ([r (in-list concerned)])
            (cons (expression->tape (relation-expression r)) (relation-signs r)))))

(define (region-free? g) (null? (region-conditions g)))

;; The leaves of e that are not within others.
(define (leaves e)
  (define found (make-hash))
  (define memo (make-memo))
  (let walk ([e e])
    (cond [(unknown? e) (hash-set! found e #t)]
          [(node? e) (memo e (lambda () (for-each walk (node-args e))))]))
  (hash-keys found))

;; ---------------------------------------------------------------------------
;; Bounds

(define (narrow-range ranges r)
  (define-values (leaf a b) (affine (relation-expression r)))
  (cond [leaf
         (define bound (- (/ b a)))
         (define side (if (positive? a) (relation-signs r) (signs-negate (relation-signs r))))
         (hash-update ranges leaf (lambda (range) (cut range side bound)) unbounded)]
        [else ranges]))

(define unbounded (cons #f #f))

;; The part of the range on this side of the bound.
(define (cut range side bound)
  (define (closer choose old) (if old (choose old bound) bound))
  (cond [(signs-within? side nonnegative) (cons (closer max (car range)) (cdr range))]
        [(signs-within? side nonpositive) (cons (car range) (closer min (cdr range)))]
        [else range]))

;; e as a · leaf + b with exact numbers, or #f #f #f.
(define (affine e)
  (define terms (affine-terms e))
  (define all (and terms (filter car terms)))
  (define leaf (and (pair? all) (caar all)))
  (define (total terms) (for/sum ([t (in-list terms)]) (inexact->exact (cdr t))))
  (if (and leaf
           (for/and ([t (in-list all)]) (equal? (car t) leaf))
           (not (eqv? 0 (total all))))
      (values leaf (total all) (total (filter (lambda (t) (not (car t))) terms)))
      (values #f #f #f)))

;; -> ((leaf-or-#f . number) ...), whose sum e is, or #f
(define (affine-terms e)
  (define head (and (node? e) (node-head e)))
  (define (scale c terms)
    (and terms (for/list ([t (in-list terms)]) (cons (car t) (* c (cdr t))))))
  (define (join parts) (and (andmap values parts) (append* parts)))
  (cond [(number? e) (and (rational? e) (list (cons #f e)))]
        [(unknown? e) (list (cons e 1))]
        [(eq? head op:+) (join (map affine-terms (node-args e)))]
        [(eq? head op:-)
         (join (list (affine-terms (car (node-args e)))
                     (scale -1 (affine-terms (cadr (node-args e))))))]
        [(and (eq? head op:*) (number? (car (node-args e))) (null? (cddr (node-args e))))
         (scale (car (node-args e)) (affine-terms (cadr (node-args e))))]
        [else #f]))

;; ---------------------------------------------------------------------------
;; Points

;; A simple number within the bounds of the leaf, by the integer n.
(define (region-place g leaf n)
  (define range (hash-ref (region-ranges g) leaf unbounded))
  (define low (car range))
  (define high (cdr range))
  (define size (abs n))
  (define next (and low (+ (floor low) size)))
  (cond [(and low (or (not high) (< next high))) next]
        [(and low (< (+ (floor low) 1) high)) (+ (floor low) 1)]
        [low (+ low (* (- high low) (/ size (+ size 1))))]
        [high (- (ceiling high) size)]
        [else n]))

;; Do the relations hold where the leaves have these values?
(define (region-admits? g lookup)
  (for/and ([c (in-list (region-conditions g))])
    (define-values (value error) (approximate-tape (car c) lookup))
    (and (real? value)
         (or (eqv? error 0) (> (abs value) error))
         (signs-within? (number-signs value) (cdr c)))))
