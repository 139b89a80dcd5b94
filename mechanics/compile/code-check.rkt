#lang racket/base
;; Is the code of a function the function?
;;
;; Racket's own tests, `number?` in a file that is not written in mechanics, say,
;; see that a placeholder is no number.  So the code is compared with the function, at
;; the example, beside it, and on the other side of zero.

(require racket/flonum
         "../error/failure.rkt" "../error/refusal.rkt"
         "../numeric/constants.rkt"
         "../value/shape.rkt")

(provide right? points-about agrees?)

;; code : flvector -> flvector; value-at : flvector -> the value of the function; point : the
;; example, of which the first `varying` scalars may be others; value : that there, if known
(define (right? code value-at point varying value)
  (and (agree? code (if value (lambda (v) value) value-at) point)
       (for/and ([v (in-list (points-about point varying))]) (agree? code value-at v))))

(define (points-about v varying) (list (moved nearby v varying) (moved opposite v varying)))

;; Each scalar goes its own way, for equal ones to become different.
(define (moved to v varying)
  (for/flvector #:length (flvector-length v) ([x (in-flvector v)] [k (in-naturals)])
    (if (< k varying)
        (to x (+ 0.1 (* 0.3 (spread-fraction k))))
        x)))
(define (opposite x d) (- (* -1.1 x) d))
(define (nearby x d) (+ x (* 0.1 d (+ 1.0 (abs x)))))

(define (agree? code value-at v)
  (agrees? (lambda () (structure->flvector (value-at v) (lambda (x) +nan.0)))
           (lambda () (code v))
           #:same? (lambda (xs ys)
                     (and (= (flvector-length xs) (flvector-length ys))
                          (for/and ([x (in-flvector xs)] [y (in-flvector ys)]) (close? x y))))
           #:numbers? (lambda (ys) (for/and ([y (in-flvector ys)]) (rational? y)))))

;; Where the function has no value, nothing is known.  Where it fails in another way the
;; program must not go on with numbers, or the user would never hear of it; if the program's
;; value is no number, the generic arithmetic may have complained of a complex one.
;;
;; (value), (made) : values of the function and of the program at the point
;; (same? value made), (numbers? made) -> boolean
(define (agrees? value made #:same? same? #:numbers? numbers?)
  (define v
    (with-handlers ([no-value? (lambda (e) 'none)]
                    [raised? (lambda (x) 'failure)])
      (value)))
  (case v
    [(none) #t]
    [(failure) (not (numbers? (made)))]
    [else (same? v (made))]))

;; x : of the function, y : of the code; up to rounding where the order of
;; operations differs.  An x that is not finite tells nothing.
(define (close? x y)
  (or (not (rational? x))
      (<= (abs (- x y)) (* 1e-6 (+ 1e-3 (abs x) (abs y))))))
