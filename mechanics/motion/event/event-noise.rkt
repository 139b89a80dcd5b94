#lang racket/base
;; Is an event's function only noise along a step?
;;
;; A conserved function that is 0 at the start is 0 all the way, except for the errors that
;; tolerance and rounding leave, whose sign means nothing.  So where zeros are found the function is
;; evaluated once more, with each coordinate changed by its uncertainty, the tolerance relative to
;; its size: a function that is not much greater than its change cannot be told from 0.  Nothing
;; here is absolute: a motion may be as small as it likes.
;;
;; Each coordinate is changed by a share of its own, so that no symmetry keeps the function
;; from changing.  A coordinate that is linear in the time, as the time is itself, has no
;; error but rounding.

(require racket/flonum
         "../../numeric/constants.rkt")

(provide noise? vary-rows! row-size
         uncertainties vary-point!)

;; size : of the function along a step; change : of the function, by the uncertainty of the state
(define (noise? size change) (fl<= size (fl* 8.0 change)))

;; Shares between 1/2 and 1, with both signs.
(define (share i)
  (define size (* 0.5 (+ 1.0 (spread-fraction (+ i 1)))))
  (if (even? i) size (- size)))

(define (factor i tolerance) (fl+ 1.0 (fl* (share i) tolerance)))

;; ---------------------------------------------------------------------------
;; Rows of Taylor coefficients

(define (vary-rows! rows tolerance)
  (for ([row (in-vector rows)] [i (in-naturals)])
    (define c (factor i (if (linear? row) rounding (flmax rounding tolerance))))
    (for ([k (in-range (flvector-length row))])
      (flvector-set! row k (fl* c (flvector-ref row k))))))

(define (linear? row) (for/and ([x (in-flvector row 2)]) (fl= x 0.0)))

;; The greatest value of the row up to the time u, or to the unit of the coefficients: a step that
;; was cut short at the end of the motion is too short to tell.
(define (row-size row order u)
  (define reach (flmax 1.0 (flabs u)))
  (for/fold ([sum 0.0]) ([k (in-range order -1 -1)])
    (fl+ (flabs (flvector-ref row k)) (fl* reach sum))))

;; ---------------------------------------------------------------------------
;; Points of an interpolant

;; at : place flvector -> void -> the uncertainties of the coordinates, relative to their size
(define (uncertainties at n tolerance)
  (define-values (a b c) (values (make-flvector n) (make-flvector n) (make-flvector n)))
  (at 0.25 a)
  (at 0.5 b)
  (at 0.75 c)
  (for/flvector #:length n ([x (in-flvector a)] [y (in-flvector b)] [z (in-flvector c)])
    (if (fl<= (flabs (fl- (fl+ x z) (fl* 2.0 y))) (fl* (fl* 8.0 epsilon) (flabs y)))
        rounding
        (flmax rounding tolerance))))

(define (vary-point! point uncertainties)
  (for ([u (in-flvector uncertainties)] [i (in-naturals)])
    (flvector-set! point i (fl* (factor i u) (flvector-ref point i)))))
