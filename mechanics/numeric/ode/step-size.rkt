#lang racket/base
;; How long a step should be (Hairer, Nørsett and Wanner, II.4).
;;
;; The error of a step of a method of order p grows with h^p.  If it was `error`
;; times the tolerance, a step h · error^(−1/p) would have been just right;
;; nine tenths of that are taken, and never more than six times or less than a
;; fifth of the last step, which may not be typical.

(require racket/flonum
         "stepper.rkt" "vector-formulas.rkt")

(provide next-length first-length)

(define safety 0.9)
(define greatest-growth 6.0)
(define least-growth 0.2)

;; error : in units of the tolerance; may be not a number.
(define (next-length m h error)
  (define growth
    (cond [(fl= error 0.0) greatest-growth]
          [(fl< error +inf.0)
           (fl* safety (flexpt error (fl/ -1.0 (->fl (method-order m)))))]
          [else least-growth]))
  (fl* h (flmax least-growth (flmin greatest-growth growth))))

;; A first step, not longer than `span`, from the sizes of y, of y' and of the
;; change of y' over a tiny step of Euler's method.
(define (first-length m s f! tolerance sign span)
  (define y (stepper-state s))
  (define slope ((stepper-slope s)))
  (define n (flvector-length y))
  (define (size x) (fl/ (root-mean-square x y y n) tolerance))
  (define h0
    (let ([d0 (size y)] [d1 (size slope)])
      (if (or (fl< d0 1e-5) (fl< d1 1e-5)) 1e-6 (fl* 0.01 (fl/ d0 d1)))))
  (define h (fl* sign (flmin h0 span)))
  (define w (make-flvector n))
  (define change (make-flvector n))
  (combine! n w y h [1.0 slope])
  (f! w change)
  (weighted-sum! n change [1.0 change] [-1.0 slope])
  (define d2 (fl/ (size change) (flabs h)))
  (define steepest (flmax (size slope) d2))
  (define h1
    (if (fl<= steepest 1e-15)
        (flmax 1e-6 (fl* 1e-3 h0))
        (flexpt (fl/ 0.01 steepest) (fl/ 1.0 (->fl (method-order m))))))
  (define proposed (flmin (fl* 100.0 h0) h1))
  (flmin span (if (fl< 0.0 proposed +inf.0) proposed 1e-6)))
