#lang racket/base
;; Orbits as streams, and the order in which their points lie on the circle (SICM 4.6).
;;
;; Of two orbits whose points come in the same order around the circle, the n-th points have
;; the same number of predecessors among the points before them.  Where these numbers differ
;; first, one orbit is ahead of the other.

(require racket/stream
         "map-of-the-plane.rkt"
         "../../generic/arithmetic.rkt" "../../generic/compare.rkt" "../../generic/describe.rkt"
         "../../generic/function.rkt" "../../generic/wrong-argument.rkt"
         "../../numeric/constants.rkt"
         "../../value/principal-value.rkt")

(provide circle-map orbit-stream position-stream compare-streams)

;; The map that turns all points by one angle.
(define (circle-map rotation-number)
  (define turn (g:* :2pi rotation-number))
  (make-function (lambda (theta J return fail) (return (whole-turn (g:+ theta turn)) J))
                 16
                 (lambda () (list 'circle-map (value->datum rotation-number)))))

(define whole-turn (principal-value :2pi))

;; The points (list x y) of an orbit; it ends where there is no image.
(define (orbit-stream map x y)
  (check-map 'orbit-stream map x y)
  (let orbit ([x x] [y y])
    (stream-cons (list x y)
                 (image-or-else 'orbit-stream map x y orbit (lambda () empty-stream)))))

;; Streams for each point of the orbit the number of earlier points with a lesser angle, all
;; angles between cut - 2 pi and cut.  before : the rising angles of points before the first
(define (position-stream cut orbit before)
  (check-stream 'position-stream orbit)
  (define wrapped (principal-value cut))
  (let positions ([orbit orbit] [before before])
    (cond [(stream-empty? orbit) empty-stream]
          [else
           (define angle (comparand (wrapped (car (stream-first orbit)))))
           (define-values (position after) (insert angle before))
           (stream-cons position (positions (stream-rest orbit) after))])))

;; -> the number of lesser ones, and the sorted list with x in it
(define (insert x sorted)
  (let loop ([count 0] [less '()] [rest sorted])
    (if (and (pair? rest) (< (car rest) x))
        (loop (+ count 1) (cons (car rest) less) (cdr rest))
        (values count (append (reverse less) (cons x rest))))))

;; -> count plus the number of leading elements that agree, negative if the first other
;; element is less in the second stream; 0 if a stream ends before.
(define (compare-streams s1 s2 count)
  (check-stream 'compare-streams s1)
  (check-stream 'compare-streams s2)
  (let loop ([s1 s1] [s2 s2] [count count])
    (if (or (stream-empty? s1) (stream-empty? s2))
        0
        (let ([a (stream-first s1)] [b (stream-first s2)])
          (cond [(= a b) (loop (stream-rest s1) (stream-rest s2) (+ count 1))]
                [(> b a) count]
                [else (- count)])))))

(define (check-stream who s)
  (check-argument who stream? s "a stream, as orbit-stream makes one"))
