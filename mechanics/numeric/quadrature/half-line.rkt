#lang racket/base
;; Definite integrals to infinity.
;;
;; But for a beginning of about the length of its distance from zero, the range becomes
;; [0, 1] by x = b + u (1 − t)/t, dx = −u dt/t².  A function too hard for halving is taken
;; for a wave (oscillating.rkt), for one that keeps its sign (periods.rkt), or for a power or
;; a logarithm that is barely integrable (tail.rkt).

(require "finite-range.rkt" "oscillating.rkt" "periods.rkt" "tail.rkt"
         "../checked-arguments.rkt"
         "../../error/failure.rkt")

(provide half-line)

;; direction : 1.0 or -1.0, by which the integral is not affected
(define (half-line q f from direction)
  (define who (question-who q))
  (define tolerance (question-tolerance q))
  (define unit (max 1.0 (abs from)))
  (define near (+ from (* direction unit)))
  (define (peaks) (map (lambda (x) (/ unit (+ unit (abs (- x near))))) ((question-peaks q))))
  (define q* (struct-copy question q [peaks peaks]))      ; in the variable t
  (define (x t) (+ near (* direction unit (/ (- 1.0 t) t))))
  (define (h t) (/ (* unit (sample who f (x t))) t t))
  (define (along s) (sample who f (+ near (* direction s))))
  (define (beginning) (over-interval q f (min from near) (max from near)))
  (define (never-ending)
    (raise-divergent-integral who 0.0 +inf.0 (* direction +inf.0)))
  (define (far)
    (let/ec return
      (call-or-fail (lambda () (over-interval q* h 0.0 1.0 x 0)) return)
      (define endless?
        (let/ec endless
          (call-or-fail (lambda () (oscillating-quadrature along unit tolerance
                                                           (lambda () (endless #t))))
                        return)
          #f))
      (when endless? (never-ending))
      (call-or-fail (lambda () (periodic-quadrature along unit tolerance)) return)
      (call-or-fail (lambda () (barely-to-infinity q f near direction)) return)
      (over-interval q* h 0.0 1.0 x)))
  (both beginning far))

;; In u = log |x|
(define (barely-to-infinity q f near direction)
  (define start (max (exp 1.0) (* direction near)))
  (define end (* direction start))
  (define-values (value bound)
    (if (= end near)
        (values 0.0 0.0)
        (over-interval q f (min near end) (max near end))))
  (define-values (rest rest-bound)
    (tail-integral (in-logarithm f 0.0 direction 1.0) (log start) (last-logarithm 0.0)
                   (abs value) (question-tolerance q)))
  (if rest (values (+ value rest) (+ bound rest-bound)) (values #f #f)))
