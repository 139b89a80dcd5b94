#lang racket/base
;; Where relations hold: a guide to points that satisfy them, and a check.
;;
;; Numbers are chosen within the bounds that relations set.  All relations that concern an
;; expression are checked at a point chosen for it.

(require (only-in racket/math infinite?)
         "../ball/ball-tape.rkt" "../ball/ball-value.rkt"
         "../assumption/assumption-set.rkt" "../assumption/interval.rkt"
         "../assumption/leaf-bounds.rkt" "../assumption/signs.rkt"
         "../expression/expression.rkt" "../expression/flat-graph.rkt"
         "../expression/symbols.rkt")

(provide make-region region-free? region-place region-borders region-admits?)

;; ranges : leaf -> interval (assumption/leaf-bounds.rkt)
;; conditions : ((tape . signs) ...)
(struct region (ranges conditions) #:authentic)

;; Where the relations with a leaf in common with the tape hold, and all of A's domain has a value.
;; taken : further relations
(define (make-region A t [taken '()])
  (define relations (append (assumptions-relations A) taken))
  (define concerned
    (if (null? relations)
        '()
        (let ([items (for/hash ([e (in-vector (tape-items t))] #:when (unknown? e)) (values e #t))])
          (for/list ([r (in-list relations)]
                     #:when (for/or ([l (in-list (leaves (relation-expression r)))])
                              (hash-ref items l #f)))
            r))))
  (region (bounds-from relations)
          (append
           (for/list ([r (in-list concerned)])
             (cons (expression->tape (relation-expression r)) (relation-signs r)))
           (for/list ([e (in-list (assumptions-domain A))])
             (cons (expression->tape e) any-sign)))))

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
;; Points

;; A simple number within the bounds of the leaf, by the number n.
(define (region-place g leaf n)
  (define-values (low high) (interval-ends (bounds-of (region-ranges g) leaf)))
  (define size (abs n))
  (define next (+ (if (exact-integer? n) (floor low) low) size))
  (cond [(infinite? low) (if (infinite? high) n (- (ceiling high) size))]
        [(< next high) next]
        [else (+ low (* (- high low) (/ size (+ size 1))))]))

;; Numbers just within the bounds of the leaf
(define (region-borders g leaf)
  (define-values (low high) (interval-ends (bounds-of (region-ranges g) leaf)))
  (append (if (infinite? low) '() (list (+ low 1/3) (+ low 1/1000)))
          (if (infinite? high) '() (list (- high 1/3) (- high 1/1000)))))

;; Do the relations certainly hold where the leaves have these values?  p : the precision, in bits
(define (region-admits? g lookup p)
  (for/and ([c (in-list (region-conditions g))])
    (define value (tape-value (car c) lookup p))
    (and (not (symbol? value))
         (signs-within? (value-signs value) (cdr c)))))
