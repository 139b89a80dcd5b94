#lang racket/base
;; The equations of a step of Radau IIA (radau.rkt), and Newton's iteration for them.
;;
;; The distances zᵢ of the three stages from y, at the fractions c₁, c₂ and c₃ = 1 of a step
;; of length h, are to satisfy z = h A f(y + z), with A the matrix of coefficients of the
;; method.  Newton's method with the derivatives J of f at y would take a system of 3n
;; equations; but T⁻¹ A⁻¹ T is
;;
;;     γ   0   0
;;     0   α  −β
;;     0   β   α
;;
;; and so, for w = T⁻¹ z, it falls apart into one of n and one of 2n:
;;
;;     (γ/h − J) Δw₁ = (T⁻¹ f)₁ − γ/h w₁,
;;
;; and its like.
;;
;; The iteration ends when its remaining error, judged by the rate at which it converges, is
;; not to be seen beside the error that is tolerated.  J only decides that rate.  So it stays
;; for the next step where convergence was fast.

(require racket/flonum
         "rates-with-jacobian.rkt" "implicit-matrices.rkt" "vector-formulas.rkt"
         (only-in "../constants.rkt" rounding) "../record-fields.rkt" "../flvector.rkt")

(provide make-equations solve-equations! equations-zs
         solve-real-equation! slope-at! failed-slope?
         state-moved! renew-derivatives! converged-fast? equations-iterations
         root6 c1 c2 most-iterations)

(define root6 (flsqrt 6.0))
(define c1 (fl/ (fl- 4.0 root6) 10.0))
(define c2 (fl/ (fl+ 4.0 root6) 10.0))

;; γ is the real eigenvalue of A⁻¹, α ± iβ are the other ones.
(define-values (gamma alpha beta)
  (let* ([p (expt 81.0 (/ 1.0 3.0))]
         [q (expt 9.0 (/ 1.0 3.0))]
         [a (/ (+ 12.0 (- q p)) 60.0)]
         [b (/ (* (+ p q) (sqrt 3.0)) 60.0)]
         [size (+ (* a a) (* b b))])
    (values (/ 30.0 (+ 6.0 (- p q))) (/ a size) (/ b size))))

(define-syntax-rule (times-T! n (z1 z2 z3) (w1 w2 w3))
  (begin
    (weighted-sum! n z1 [0.09123239487089294 w1] [-0.14125529502095421 w2]
                   [-0.030029194105147424 w3])
    (weighted-sum! n z2 [0.241717932707107 w1] [0.20412935229379994 w2]
                   [0.3829421127572619 w3])
    (weighted-sum! n z3 [0.966048182615093 w1] [1.0 w2])))

(define-syntax-rule (times-inverse-T! n (w1 w2 w3) (z1 z2 z3))
  (begin
    (weighted-sum! n w1 [4.325579890063155 z1] [0.33919925181580984 z2]
                   [0.5417705399358749 z3])
    (weighted-sum! n w2 [-4.178718591551905 z1] [-0.3276828207610624 z2]
                   [0.47662355450055044 z3])
    (weighted-sum! n w3 [-0.5028726349457868 z1] [2.571926949855605 z2]
                   [-0.5960392048282249 z3])))

(define most-iterations 10)
(define beside-error 1e-3)              ; error left by Newton's iteration
(define fast 1e-3)                      ; the rate of convergence at which J is kept

;; ---------------------------------------------------------------------------

;; y       : the present state
;; enough  : the error that may be left of the iteration
;; zs, ws  : z and w; ks : the slopes at the stages; gs : the changes of w; u : a stage
;; current? : are the derivatives those at y?
;; factored : the length of step for which the matrices were made, or #f
;; rate    : at which the iteration converged last, and in how many `iterations`
(struct equations (f! n y jacobian! matrices enough zs ws ks gs u
                   [current? #:mutable] [factored #:mutable]
                   [rate #:mutable] [iterations #:mutable])
  #:authentic)

;; tolerance : of the error of a step
(define (make-equations f! y tolerance)
  (define n (flvector-length y))
  (define enough (flmax rounding (fl* beside-error tolerance)))
  (define (three) (make-vectors 3 n))
  (equations f! n y (jacobian-of f! n) (make-matrices n) enough
             (three) (three) (three) (three) (make-flvector n)
             #f #f 1.0 0))

;; (guess! c z) stores in z where the iteration is to begin at the fraction c of the step.
;; -> was the step solved for?  If not with the J of an earlier state, then with that at y.
(define (solve-equations! q h guess!)
  (define again? (not (equations-current? q)))
  (unless (or (equations-current? q) (converged-fast? q)) (differentiate! q))
  (or (and (ready? q h)
           (begin (begin! q guess!)
                  (iterate! q h)))
      (begin (set-equations-rate! q 1.0)
             (and again? (not (equations-current? q)) (solve-equations! q h guess!)))))

;; The state is another: the derivatives are those at an earlier one.
(define (state-moved! q) (set-equations-current?! q #f))

;; Derivatives at y, unless they are there, before the equations are solved again.
(define (renew-derivatives! q)
  (unless (equations-current? q) (set-equations-rate! q 1.0)))

(define (converged-fast? q) (fl<= (equations-rate q) fast))

(define (differentiate! q)
  (define jacobian! (equations-jacobian! q))
  (jacobian! (equations-y q) (matrices-J (equations-matrices q)))
  (set-equations-current?! q #t)
  (set-equations-factored! q #f))

;; -> are the matrices those of a step of length h?
(define (ready? q h)
  (or (eqv? (equations-factored q) h)
      (let ([made? (factor-matrices! (equations-matrices q)
                                     (fl/ gamma h) (fl/ alpha h) (fl/ beta h))])
        (set-equations-factored! q (and made? h))
        made?)))

(define (begin! q guess!)
  (define-fields equations q n zs ws)
  (define-elements zs z1 z2 z3)
  (define-elements ws w1 w2 w3)
  (guess! c1 z1)
  (guess! c2 z2)
  (guess! 1.0 z3)
  (times-inverse-T! n (w1 w2 w3) (z1 z2 z3)))

;; -> did Newton's iteration converge?
(define (iterate! q h)
  (define-fields equations q n y gs enough)
  ;; The rate of another step is no more than a guess.
  (define (left size count)
    (define rate (equations-rate q))
    (define r (if (= count 1) (flmax fast rate) rate))
    (fl* size (fl/ r (fl- 1.0 r))))
  (let loop ([count 1] [last +inf.0])
    (newton-step! q h)
    (define size                        ; how far w has moved, beside y
      (for/fold ([most 0.0]) ([g (in-vector gs)]) (flmax most (root-mean-square g y y n))))
    (set-equations-iterations! q count)
    (unless (= count 1) (set-equations-rate! q (flmax 1e-16 (fl/ size last))))
    (cond [(fl<= size rounding) #t]
          [(not (fl< size +inf.0)) #f]
          [(fl>= (equations-rate q) 1.0)               ; rounding goes on for ever
           (if (= count 1) (loop 2 size) (fl<= size 1e-13))]
          [(fl<= (left size count) enough) #t]
          [(= count most-iterations) #f]
          [else (loop (+ count 1) size)])))

(define (newton-step! q h)
  (define-fields equations q n matrices zs ws ks gs)
  (define-elements zs z1 z2 z3)
  (define-elements ws w1 w2 w3)
  (define-elements ks k1 k2 k3)
  (define-elements gs g1 g2 g3)
  (slope-at! q k1 z1)
  (slope-at! q k2 z2)
  (slope-at! q k3 z3)
  (times-inverse-T! n (g1 g2 g3) (k1 k2 k3))
  (define-values (c a b) (values (fl/ gamma h) (fl/ alpha h) (fl/ beta h)))
  (weighted-sum! n g1 [1.0 g1] [(fl- 0.0 c) w1])
  (weighted-sum! n g2 [1.0 g2] [(fl- 0.0 a) w2] [b w3])
  (weighted-sum! n g3 [1.0 g3] [(fl- 0.0 b) w2] [(fl- 0.0 a) w3])
  (solve-real! matrices c g1)
  (solve-complex! matrices a b g2 g3)
  (weighted-sum! n w1 [1.0 w1] [1.0 g1])
  (weighted-sum! n w2 [1.0 w2] [1.0 g2])
  (weighted-sum! n w3 [1.0 w3] [1.0 g3])
  (times-T! n (z1 z2 z3) (w1 w2 w3)))

;; k = f(y + z)
(define (slope-at! q k z)
  (define-fields equations q f! n y u)
  (weighted-sum! n u [1.0 y] [1.0 z])
  (f! u k))

;; v = (γ/h − J)⁻¹ v
(define (solve-real-equation! q v)
  (define-fields equations q matrices factored)
  (solve-real! matrices (fl/ gamma factored) v))

;; Was f not finite at the end of the step?
(define (failed-slope? q) (not (flvector-finite? (vector-ref (equations-ks q) 2))))
