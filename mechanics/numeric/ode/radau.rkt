#lang racket/base
;; Radau IIA, the implicit Runge–Kutta method of order 5 for stiff systems (Hairer and
;; Wanner, Solving Ordinary Differential Equations II, 2nd ed. 1996, IV.8).
;;
;; A cubic through y that satisfies y' = f(y) at the fractions c₁, c₂ and c₃ = 1 of the
;; step leads to the new state.  With zᵢ its distance from y at cᵢ and A the matrix of
;; coefficients of the method, z = h A f(y + z).  Newton's method with the derivatives J
;; of f at y would take a system of 3n equations; but T⁻¹ A⁻¹ T is
;;
;;     γ   0   0
;;     0   α  −β
;;     0   β   α
;;
;; and so, for w = T⁻¹ z, it falls apart into one of n and one of 2n:
;;
;;     (γ/h − J) Δw₁ = (T⁻¹ f)₁ − γ/h w₁,
;;
;; and its like.  An embedded formula of order 3 gives the error
;;
;;     e = (γ/h − J)⁻¹ (f(y) + (d₁ z₁ + d₂ z₂ + d₃ z₃)/h),
;;
;; and once more with f(y + e) for f(y), or it would be far too large where hJ is.
;; Motions that die out within a small part of a step are damped entirely, as if h were
;; infinite for them.
;;
;; Newton's iteration ends when what is left of it, judged by the rate at which it
;; converges, is not to be seen beside the error that is tolerated.  J only decides that
;; rate.  So it stays for the next step where convergence was fast; and if the step is to
;; be hardly longer it keeps its length, so that the matrices stay as well.

(require racket/fixnum
         racket/flonum
         "differentiated.rkt" "implicit-matrices.rkt" "predictive.rkt" "stepper.rkt"
         "vectors.rkt"
         "../flvector.rkt"
         "../linear/factored-system.rkt")

(provide radau-iia-5)

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

(define d1 (fl/ (fl- -13.0 (fl* 7.0 root6)) 3.0))
(define d2 (fl/ (fl+ -13.0 (fl* 7.0 root6)) 3.0))
(define d3 (fl/ -1.0 3.0))

(define rounding 4e-16)
(define most-iterations 10)
(define beside-error 1e-3)              ; what may be left of Newton's iteration
(define fast 1e-3)                      ; the rate of convergence at which J is kept
(define hardly-longer 1.2)

;; ---------------------------------------------------------------------------

;; tolerance : of the error of a step
(define (start f! y0 [tolerance 1e-12])
  (define n (flvector-length y0))
  (define y (flvector-copy y0))
  (define-vectors n next old slope z1 z2 z3 w1 w2 w3 k1 k2 k3 g1 g2 g3 u defect e)
  (define-vectors (* 2 n) pair)
  (define-vectors (* n n) J real)
  (define-vectors (* 4 n n) complex)
  (define real-exchanges (make-fxvector n))
  (define complex-exchanges (make-fxvector (* 2 n)))
  (define jacobian! (jacobian-of f! n))
  (define control (make-controller most-iterations))
  (define here? #f)                     ; is J that at y?
  (define factored #f)                  ; the length of step for which J was factored
  (define rate 1.0)                     ; at which Newton's iteration converged last,
  (define iterations 0)                 ; and in how many
  (define tried 0.0)                    ; the length of the step tried last
  (define step 0.0)                     ; and of the one accepted last,
  (define cubic #f)                     ; with its interpolant

  (define (factor-matrices! h)
    (shifted! real n J (fl/ gamma h))
    (shifted-pair! complex n J (fl/ alpha h) (fl/ beta h))
    (set! factored (and (factor! real n real-exchanges)
                        (factor! complex (* 2 n) complex-exchanges)
                        h))
    factored)

  (define (differentiate!)
    (jacobian! y J)
    (set! here? #t)
    (set! factored #f))

  ;; The last cubic, continued, is where to begin.
  (define (begin! h)
    (define (continue! z c)
      (cond [cubic
             (cubic (fl+ 1.0 (fl* c (fl/ h step))) z)
             (weighted-sum! n z [1.0 z] [-1.0 y])]
            [else (scale! z 0.0)]))
    (continue! z1 c1)
    (continue! z2 c2)
    (continue! z3 1.0)
    (times-inverse-T! n (w1 w2 w3) (z1 z2 z3)))

  (define (slope-at! k z)
    (weighted-sum! n u [1.0 y] [1.0 z])
    (f! u k))

  ;; -> how far w has moved, beside y
  (define (newton-step! h)
    (slope-at! k1 z1)
    (slope-at! k2 z2)
    (slope-at! k3 z3)
    (times-inverse-T! n (g1 g2 g3) (k1 k2 k3))
    (define-values (c a b) (values (fl/ gamma h) (fl/ alpha h) (fl/ beta h)))
    (weighted-sum! n g1 [1.0 g1] [(fl- 0.0 c) w1])
    (weighted-sum! n g2 [1.0 g2] [(fl- 0.0 a) w2] [b w3])
    (weighted-sum! n g3 [1.0 g3] [(fl- 0.0 b) w2] [(fl- 0.0 a) w3])
    (solve-factored! real n real-exchanges g1)
    (join! pair g2 g3 n)
    (solve-factored! complex (* 2 n) complex-exchanges pair)
    (part! pair g2 g3 n)
    (weighted-sum! n w1 [1.0 w1] [1.0 g1])
    (weighted-sum! n w2 [1.0 w2] [1.0 g2])
    (weighted-sum! n w3 [1.0 w3] [1.0 g3])
    (times-T! n (z1 z2 z3) (w1 w2 w3))
    (flmax (root-mean-square g1 y y n)
           (flmax (root-mean-square g2 y y n) (root-mean-square g3 y y n))))

  ;; -> did Newton's iteration converge?
  (define (iterate! h)
    (define enough (flmax rounding (fl* beside-error tolerance)))
    ;; The rate of another step is no more than a guess.
    (define (left size count)
      (define r (if (= count 1) (flmax fast rate) rate))
      (fl* size (fl/ r (fl- 1.0 r))))
    (let loop ([count 1] [last +inf.0])
      (define size (newton-step! h))
      (set! iterations count)
      (unless (= count 1) (set! rate (flmax 1e-16 (fl/ size last))))
      (cond [(fl<= size rounding) #t]
            [(not (fl< size +inf.0)) #f]
            [(fl>= rate 1.0)                           ; rounding goes on for ever
             (if (= count 1) (loop 2 size) (fl<= size 1e-13))]
            [(fl<= (left size count) enough) #t]
            [(= count most-iterations) #f]
            [else (loop (+ count 1) size)])))

  (define (error-from! k h)
    (define r (fl/ 1.0 h))
    (weighted-sum! n defect [1.0 k] [(fl* r d1) z1] [(fl* r d2) z2] [(fl* r d3) z3])
    (flvector-copy! e defect)
    (solve-factored! real n real-exchanges e)
    (root-mean-square e y y n))

  ;; -> was the step solved for?  If not with the J of an earlier state, then with that
  ;; at y.
  (define (solve! h)
    (define again? (not here?))
    (when (and again? (fl> rate fast)) (differentiate!))
    (or (and (or (eqv? factored h) (factor-matrices! h))
             (begin (begin! h)
                    (iterate! h)))
        (begin (set! rate 1.0)
               (and again? (not here?) (solve! h)))))

  (define (try! h)
    (set! tried h)
    (cond [(solve! h)
           (error-from! slope h)
           (slope-at! k1 e)
           (weighted-sum! n next [1.0 y] [1.0 z3])
           (error-from! k1 h)]
          [(flvector-finite? k3) unsolved]
          [else +nan.0]))

  (define (accept!)
    (set! step tried)
    (set! here? #f)
    (flvector-copy! old y)
    (flvector-copy! y next)
    (set! cubic (make-cubic n old z1 z2 z3))
    (f! y slope))

  ;; A step that was not solved for tells nothing of its error.
  (define (propose h error)
    (unless (or (fl<= error 1.0) here?) (set! rate 1.0))
    (define length (if (fl< error too-large) (control h error iterations) (fl* 0.5 h)))
    (if (and (fl<= rate fast) (fl<= h length) (fl<= length (fl* hardly-longer h)))
        h
        length))

  (f! y slope)
  (controlled-stepper y (lambda () slope) try! accept! (lambda () cubic) propose))

;; The error of a step that was not solved for.
(define unsolved 1e100)
(define too-large 1e50)

;; y + θ (a + (θ − c₁) (b + (θ − c₂) c)), by divided differences at 0, c₁, c₂ and 1
(define (make-cubic n y z1 z2 z3)
  (define from (flvector-copy y))
  (define-vectors n a b c)
  (define p (fl/ 1.0 (fl- c2 c1)))
  (define q (fl/ 1.0 (fl- 1.0 c2)))
  (weighted-sum! n a [(fl/ 1.0 c1) z1])
  (weighted-sum! n b [(fl/ p c2) z2] [(fl/ (fl- 0.0 p) c2) z1] [(fl/ -1.0 c2) a])
  (define r (fl/ 1.0 (fl- 1.0 c1)))
  (weighted-sum! n c [(fl* r q) z3] [(fl* r (fl- 0.0 (fl+ q p))) z2] [(fl* r p) z1] [-1.0 b])
  (lambda (theta out)
    (define s (fl* theta (fl- theta c1)))
    (combine! n out from 1.0 [theta a] [s b] [(fl* s (fl- theta c2)) c])))

(define radau-iia-5 (adaptive-method 'Radau-IIA-5 4 start #:jacobian? #t))
