#lang racket/base
;; The axisymmetric top under gravity (SICM 2.10 and 3.4): moments A, A, C about the point on
;; which it stands, gMR the product of g, mass and distance of the centre of mass from there.
;;
;; The momenta p_φ and p_ψ are conserved; a motion of θ is left, with inertia A in
;;
;;     V(θ) = (p_φ − p_ψ cos θ)²/(2 A sin²θ) + p_ψ²/(2 C) + gMR cos θ.
;;
;; Upright, with p_φ = p_ψ = p, this is p²/(2A) tan²(θ/2) + p²/(2C) + gMR cos θ: the top sleeps
;; where that is least, for p² > 4 A gMR.

(require racket/list
         "Euler-angles.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/compare.rkt" "../generic/describe.rkt"
         "../generic/elementary.rkt" "../generic/printed-function.rkt"
         "../generic/wrong-argument.rkt"
         "../numeric/optimization/golden-section.rkt")

(provide V_eff top-potential nutation-range steady-precessions critical-spin)

;; ((V_eff p A C gMR) theta), of the sleeping top
(define-printed (V_eff p A C gMR)
  (lambda (theta)
    (g:+ (g:/ (g:square p) (g:* 2 C))
         (g:* (g:/ (g:square p) (g:* 2 A)) (g:square (g:tan (g:/ theta 2))))
         (g:* gMR (g:cos theta)))))

;; ((top-potential A C gMR p_phi p_psi) theta)
(define-printed (top-potential A C gMR p_phi p_psi)
  (lambda (theta)
    (g:+ (g:/ (g:square (g:- p_phi (g:* p_psi (g:cos theta))))
              (g:* 2 A (g:square (g:sin theta))))
         (g:/ (g:square p_psi) (g:* 2 C))
         (g:* gMR (g:cos theta)))))

;; The rate of spin, C ω = p, above which the top stands upright: 2 √(A gMR)/C.  One that hangs,
;; gMR < 0, needs none.
(define (critical-spin A C gMR)
  (for ([x (in-list (list A C))] #:when (known-not-positive? x))
    (complain 'critical-spin "a moment of inertia is positive; given ~a" (describe-with-value x)))
  (if (known-not-positive? gMR)
      0
      (g:/ (g:* 2 (g:sqrt (g:* A gMR))) C)))

(define (known-not-positive? x)
  (define r (comparand x))
  (and (real? r) (<= r 0)))

;; The rates φ̇ of precession at a constant θ, with ω_c the spin along the axis: the roots of
;; A cos θ φ̇² − C ω_c φ̇ + gMR = 0, the slow one first; a list, empty if there is none.
(define (steady-precessions A C gMR theta omega_c)
  (define-values (a b) (values (g:* A (g:cos theta)) (g:* C omega_c)))
  (define discriminant (g:- (g:square b) (g:* 4 (g:* a gMR))))
  (define d (comparand discriminant))
  (cond [(and (real? d) (negative? d)) '()]
        [else
         (define root (g:sqrt discriminant))
         (define larger (if (and (real? (comparand b)) (negative? (comparand b)))
                            (g:- b root)
                            (g:+ b root)))
         (define slow (g:/ (g:* 2 gMR) larger))
         (if (g:zero? a) (list slow) (list slow (g:/ larger (g:* 2 a))))]))

;; ---------------------------------------------------------------------------
;; Nutation

;; The least and the greatest θ of the motion from a state, (list low high).  With u = cos θ,
;; θ̇ = 0 where the cubic
;;
;;     f(u) = 2 A (E' − gMR u)(1 − u²) − (p_φ − p_ψ u)² = A² u̇²,    E' = E − p_ψ²/(2 C),
;;
;; vanishes: of its three roots one lies above 1, for f(u) → ∞, and the two between −1 and 1
;; on either side of where f is greatest hold the motion.
(define (nutation-range A C gMR state)
  (define-values (f here) (cubic A C gMR state))
  (define-values (top slopeless) (greatest-between f here))
  ;; f(±1) is 0 where φ and ψ turn alike; the motion gets there if f is positive beside it.
  (define (edge end)
    (if (and (>= (f end) 0) (>= (f (* end (- 1 1e-9))) 0)) end (zero-between f slopeless end)))
  (if (<= top 0)
      (let ([theta (acos here)]) (list theta theta))
      (list (acos (edge 1.0)) (acos (edge -1.0)))))

;; -> f, and the u of the state
(define (cubic A C gMR state)
  (define-values (theta phi psi thetadot phidot psidot) (angles-and-rates 'nutation-range state))
  (for ([x (in-list (list A C gMR theta thetadot phidot psidot))])
    (check-argument 'nutation-range real? x "numbers"))
  (define u (cos (exact->inexact theta)))
  (define p_psi (* C (+ psidot (* phidot u))))
  (define s^2 (expt (sin theta) 2))
  (define p_phi (+ (* A phidot s^2) (* p_psi u)))
  (define E (+ (* 1/2 A (+ (expt thetadot 2) (* s^2 (expt phidot 2)))) (* gMR u)))
  (values (lambda (u) (- (* 2 A (- E (* gMR u)) (- 1 (* u u))) (expt (- p_phi (* p_psi u)) 2)))
          u))

;; -> the greatest value of f between −1 and 1, and where: f rises there to a maximum and falls,
;; and f(here) ≥ 0
(define (greatest-between f here)
  (define at (car (golden-section (lambda (u) (- (f u))) -1.0 1.0 (width-at-most 1e-15))))
  (define best (argmax f (list at here)))
  (values (f best) best))

;; By halves, to the last bit
(define (zero-between f inside outside)
  (let loop ([inside inside] [outside outside])
    (define middle (/ (+ inside outside) 2))
    (cond [(or (= middle inside) (= middle outside)) middle]
          [(>= (f middle) 0) (loop middle outside)]
          [else (loop inside middle)])))
