#lang racket/base
;; Points of the plane, many of them: two arrays of flonums that grow by doubling, so
;; that adding a point costs the same however many there are.
;;
;; Arrays are replaced by longer copies and entries are only ever added.  So the points of
;; a snapshot never change and need not be copied, and one taken while another
;; thread adds is whole if the count is read first.

(require racket/flonum
         "../../numeric/finite-number.rkt" "../../numeric/flvector.rkt")

(provide make-points points? add-point!
         (struct-out snapshot) take-snapshot
         snapshot->vectors snapshot->curves vectors->points)

(struct points ([xs #:mutable] [ys #:mutable] [count #:mutable]) #:authentic)

;; The first `count` entries of both arrays.
(struct snapshot (xs ys count) #:authentic)

(define (make-points) (points (make-flvector 16) (make-flvector 16) 0))

;; The count comes last: whoever is interrupted before has added nothing.
(define (add-point! p x y)
  (define n (points-count p))
  (when (= n (flvector-length (points-xs p))) (grow! p))
  (flvector-set! (points-xs p) n x)
  (flvector-set! (points-ys p) n y)
  (set-points-count! p (+ n 1)))

(define (grow! p)
  (define xs (longer (points-xs p)))
  (define ys (longer (points-ys p)))
  (set-points-ys! p ys)
  (set-points-xs! p xs))

(define (longer v)
  (define copy (make-flvector (* 2 (flvector-length v))))
  (flvector-copy! copy v)
  copy)

(define (take-snapshot p)
  (define count (points-count p))
  (snapshot (points-xs p) (points-ys p) count))

;; -> ((vector x y) ...)
(define (snapshot->vectors s)
  (for/list ([i (in-range (snapshot-count s))])
    (vector (flvector-ref (snapshot-xs s) i) (flvector-ref (snapshot-ys s) i))))

(define (vectors->points vectors)
  (define p (make-points))
  (for ([v (in-list vectors)]) (add-point! p (vector-ref v 0) (vector-ref v 1)))
  p)

;; The connected pieces: a point that is not finite separates two of them.
(define (snapshot->curves s)
  (define-values (pieces piece)
    (for/fold ([pieces '()] [piece '()]) ([v (in-list (snapshot->vectors s))])
      (if (and (finite? (vector-ref v 0)) (finite? (vector-ref v 1)))
          (values pieces (cons v piece))
          (values (cons piece pieces) '()))))
  (for/list ([p (in-list (reverse (cons piece pieces)))] #:unless (null? p)) (reverse p)))
