#lang racket/base
;; The result of fitting a motion to data: values with their standard deviations and covariances.

(require "../../generic/value-struct.rkt" "../../generic/wrong-argument.rkt"
         "../../value/matrix/matrix.rkt")

(provide motion-fit motion-fit?)

;; values : list of (name value) of the numbers fitted; covariance : matrix in the same order
;; start, parameters : with the values found; residuals : list of (up time residual ...)
;; chi-square : sum of squares, in units of the deviations if these were given
;; freedom : how many numbers more than unknowns; deviation : of the data, if it was estimated
(value-struct motion-fit (values covariance start parameters residuals chi-square freedom deviation)
  #:text fit->text)

(define (motion-fit-deviations f)
  (for/list ([v (in-list (motion-fit-values f))] [k (in-naturals)])
    (list (car v) (sqrt (matrix-ref (motion-fit-covariance f) k k)))))

(provide-parts motion-fit? "a fit, as fit-motion gives it"
  motion-fit-values motion-fit-deviations motion-fit-covariance motion-fit-residuals
  motion-fit-start motion-fit-parameters motion-fit-chi-square)

(define (fit->text f)
  (apply string-append
         (format "motion fitted to ~a numbers"
                 (+ (motion-fit-freedom f) (length (motion-fit-values f))))
         (append
          (for/list ([v (in-list (motion-fit-values f))] [d (in-list (motion-fit-deviations f))])
            (format "\n  ~a = ~a" (car v) (with-deviation (cadr v) (cadr d))))
          (list (if (motion-fit-deviation f)
                    (format "\n  deviation of the data ~a" (digits (motion-fit-deviation f) 3))
                    (format "\n  chi-square ~a, of ~a expected" (digits (motion-fit-chi-square f) 3)
                            (motion-fit-freedom f)))))))

;; 9.813 ± 0.021: both to the second digit of the deviation
(define (with-deviation x d)
  (cond [(< 0 d +inf.0)
         (define places (- 1 (order-of d)))
         (format "~a ± ~a" (decimal x places) (decimal d places))]
        [else (format "~a ± ~a" x d)]))

(define (order-of x) (inexact->exact (floor (/ (log (abs x)) (log 10)))))

;; With so many places behind the point; in powers of ten where there would be many zeros
(define (decimal x places)
  (define unit (expt 10 (- places)))
  (define rounded (* unit (round (/ (inexact->exact x) unit))))
  (cond [(<= 1 places 12) (real->decimal-string x places)]
        [(< places 1 (abs rounded) 1e15) (number->string rounded)]
        [else (number->string (exact->inexact rounded))]))

(define (digits x n)
  (if (< 0 x +inf.0) (decimal x (max 0 (- n 1 (order-of x)))) (number->string x)))
