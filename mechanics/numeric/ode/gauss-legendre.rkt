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
         "../flvector.rkt")

(provide gauss-legendre-2 gauss-legendre-4 gauss-legendre-6)

(define repetitions 100)
(define rounding 4e-16)

;; A : rows of coefficients; b : weights
(define ((start A b) f! y0)
  (define n (flvector-length y0))
  (define y (flvector-copy y0))
  (define-vectors n z old w change new first)
  (define ks (for/list ([_ (in-list b)]) (make-flvector n)))
  (define step 0.0)

  (define (add-slopes! out h coefficients)
    (flvector-copy! out y)
    (for ([a (in-list coefficients)] [k (in-list ks)])
      (combine! n out out (fl* h a) [1.0 k])))

  ;; One repetition -> the greatest change of a slope, relative to y.
  (define (repeat! h)
    (for/fold ([greatest 0.0]) ([row (in-list A)] [k (in-list ks)])
      (add-slopes! w h row)
      (f! w new)
      (weighted-sum! n change [h new] [(fl- 0.0 h) k])
      (flvector-copy! k new)
      (flmax greatest (root-mean-square change y y n))))

  (define (try! h)
    (set! step h)
    (define converged?
      (let loop ([count 0] [last +inf.0])
        (define c (repeat! h))
        (cond [(fl<= c rounding) #t]
              [(or (= count repetitions) (not (fl< c +inf.0))) #f]
              [(and (fl< c 1e-12) (fl>= c last)) #t]      ; rounding goes on for ever
              [else (loop (+ count 1) c)])))
    (add-slopes! z h b)
    (if (and converged? (flvector-finite? z)) 0.0 +nan.0))

  (define (accept!)
    (flvector-copy! old y)
    (flvector-copy! y z))

  (define (slope)
    (f! y first)
    first)

  (define between (by-shorter-steps (start A b) f!))
  (define (interpolant) (between old y step))

  (for ([k (in-list ks)]) (f! y k))
  (stepper y slope try! accept! interpolant))

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
