#lang racket/base
;; Gauss–Legendre methods of orders 2, 4 and 6: implicit, and symplectic for
;; Hamiltonian systems of any kind (Hairer, Lubich and Wanner, Geometric Numerical
;; Integration, 2nd ed. 2006, II.1.3 and VI.4).
;;
;; The slopes at s points, the zeros of a Legendre polynomial, solve
;;
;;     kᵢ = f(y + h Σⱼ aᵢⱼ kⱼ)
;;
;; and lead to y + h Σ bᵢ kᵢ.  They are found by repetition from the slopes of the
;; step before, until they change by rounding only.  Of order 2 it is the implicit
;; midpoint rule.

(require racket/flonum
         "shorter-step.rkt" "stepper.rkt" "vectors.rkt"
         (only-in "../constants.rkt" rounding) "../fields.rkt" "../flvector.rkt")

(provide gauss-legendre-2 gauss-legendre-4 gauss-legendre-6)

(define repetitions 100)

;; y : the present state; A : rows of coefficients; ks : the slopes, as they are found
(struct equations (f! n y A ks w new change) #:authentic)

;; b : weights
(define ((start A b) f! y0)
  (define n (flvector-length y0))
  (define y (flvector-copy y0))
  (define-vectors n z w new change first)
  (define ks (for/list ([_ (in-list b)]) (make-flvector n)))
  (define q (equations f! n y A ks w new change))
  (define (try! h)
    (define solved? (solve! q h))
    (add-slopes! q z h b)
    (if (and solved? (flvector-finite? z)) 0.0 +nan.0))
  (define (slope)
    (f! y first)
    first)
  (for ([k (in-list ks)]) (f! y k))
  (make-stepper y z slope try! (by-shorter-steps (start A b) f! y)))

;; -> did the repetitions converge?
(define (solve! q h)
  (define-fields equations q f! n y A ks w new change)
  ;; -> the greatest change of a slope, relative to y
  (define (repeat!)
    (for/fold ([most 0.0]) ([row (in-list A)] [k (in-list ks)])
      (add-slopes! q w h row)
      (f! w new)
      (weighted-sum! n change [h new] [(fl- 0.0 h) k])
      (flvector-copy! k new)
      (flmax most (root-mean-square change y y n))))
  (let loop ([count 0] [last +inf.0])
    (define size (repeat!))
    (cond [(fl<= size rounding) #t]
          [(or (= count repetitions) (not (fl< size +inf.0))) #f]
          [(and (fl< size 1e-12) (fl>= size last)) #t]      ; rounding goes on for ever
          [else (loop (+ count 1) size)])))

;; out = y + h (a₁ k₁ + a₂ k₂ + ...)
(define (add-slopes! q out h coefficients)
  (define-fields equations q n y ks)
  (flvector-copy! out y)
  (for ([a (in-list coefficients)] [k (in-list ks)])
    (combine! n out out (fl* h a) [1.0 k])))

(define ((implicit name order A b) h) (fixed-step-method name order h (start A b)))

(define gauss-legendre-2
  (implicit 'Gauss-Legendre-2 2 '((0.5)) '(1.0)))

(define gauss-legendre-4
  (let ([r (/ (sqrt 3.0) 6.0)])
    (implicit 'Gauss-Legendre-4 4
              (list (list 0.25 (- 0.25 r))
                    (list (+ 0.25 r) 0.25))
              '(0.5 0.5))))

(define gauss-legendre-6
  (let ([r (sqrt 15.0)])
    (implicit 'Gauss-Legendre-6 6
              (list (list (/ 5.0 36.0) (- (/ 2.0 9.0) (/ r 15.0)) (- (/ 5.0 36.0) (/ r 30.0)))
                    (list (+ (/ 5.0 36.0) (/ r 24.0)) (/ 2.0 9.0) (- (/ 5.0 36.0) (/ r 24.0)))
                    (list (+ (/ 5.0 36.0) (/ r 30.0)) (+ (/ 2.0 9.0) (/ r 15.0)) (/ 5.0 36.0)))
              (list (/ 5.0 18.0) (/ 4.0 9.0) (/ 5.0 18.0)))))
