#lang racket/base
;; The pendulum H = p²/2α − β cos θ in closed form, by elliptic functions (scmutils' names).
;;
;; With ω₀ = √(β/α) and k² = (E + β)/2β the pendulum swings for E < β:
;;
;;     sin θ/2 = k sn(ω₀ t),    p = 2 α ω₀ k cn(ω₀ t),    ω = π ω₀/2K(k),
;;     I = (8/π) √(αβ) (E(k) − (1 − k²) K(k));
;;
;; for E > β it turns, with ω_R = √((E + β)/2α) and k² = 2β/(E + β):
;;
;;     sin θ/2 = sn(ω_R t),     p = 2 α ω_R dn(ω_R t),    ω = π ω_R/K(k),
;;     I = (4/π) √(αβ) E(k)/k;
;;
;; and between, on the separatrix, θ = 2 gd(ω₀ t).  Times are from θ = 0 with p > 0 on.

(require "../calculus/elliptic.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/compare.rkt" "../generic/describe.rkt"
         "../generic/elementary.rkt" "../generic/printed-function.rkt" "../generic/scalar.rkt"
         "../hamiltonian/H-state.rkt" "../hamiltonian/Hamilton-equations.rkt"
         "../lagrangian/local-tuple.rkt"
         "../numeric/constants.rkt")

(provide Hpendulum pendulum-sysder
         pendulum-frequency pendulum-oscillating-frequency pendulum-circulating-frequency
         pendulum-oscillating-angle pendulum-oscillating-angular-momentum
         pendulum-circulating-angle pendulum-circulating-angular-momentum
         pendulum-separatrix-angle pendulum-separatrix-angular-momentum
         pendulum-oscillating-action pendulum-circulating-action pendulum-separatrix-action
         gudermannian inverse-gudermannian
         ;; for phases and series
         modulus turning-modulus omega-0 omega-R swinging? check-swinging check-turning number-of)

;; ---------------------------------------------------------------------------
;; Energy and motion

(define-printed (Hpendulum alpha beta)
  (lambda (state)
    (check-H-state 'Hpendulum state)
    (g:- (g:/ (g:square (momentum state)) (g:* 2 alpha))
         (g:* beta (g:cos (coordinate state))))))

(define (pendulum-sysder alpha beta) (Hamiltonian->state-derivative (Hpendulum alpha beta)))

(define (number-of who what x)
  (define r (comparand x))
  (unless (real? r) (complain who "~a is to be a number; given ~a" what (describe-with-value x)))
  r)

;; Does it swing at that energy, rather than turn?
(define (swinging? who alpha beta E)
  (define-values (b e) (values (number-of who "beta" beta) (number-of who "the energy" E)))
  (check-parameters who alpha beta)
  (when (< e (- b))
    (complain who "the energy of a pendulum is at least -beta; given ~a, with beta = ~a" E beta))
  (when (= e b)
    (complain who "on the separatrix, with the energy beta, there is no period; given ~a" E))
  (< e b))

(define (check-parameters who alpha beta)
  (for ([x (in-list (list alpha beta))] [name (in-list '(alpha beta))])
    (define r (comparand x))
    (when (and (number? r) (not (and (real? r) (> r 0))))
      (complain who "~a is positive; given ~a" name (describe-with-value x)))
    (unless (scalar? x)
      (complain who "~a is a number or a symbol; given ~a" name (describe-with-value x)))))

(define (check-swinging who alpha beta E)
  (unless (swinging? who alpha beta E)
    (complain who "with an energy of more than beta the pendulum turns; given ~a, with beta = ~a"
              E beta)))

(define (check-turning who alpha beta E)
  (when (swinging? who alpha beta E)
    (complain who "with an energy of less than beta the pendulum swings; given ~a, with beta = ~a"
              E beta)))

;; The k of swings, and that of turns, its inverse
(define (modulus beta E) (g:sqrt (g:/ (g:+ E beta) (g:* 2.0 beta))))
(define (turning-modulus beta E) (g:/ 1 (modulus beta E)))

(define (omega-0 alpha beta) (g:sqrt (g:/ beta alpha)))
(define (omega-R alpha beta E) (g:sqrt (g:/ (g:+ E beta) (g:* 2.0 alpha))))

;; ---------------------------------------------------------------------------
;; Frequencies and actions

(define (pendulum-frequency alpha beta E)
  (if (swinging? 'pendulum-frequency alpha beta E)
      (pendulum-oscillating-frequency alpha beta E)
      (pendulum-circulating-frequency alpha beta E)))

(define (pendulum-oscillating-frequency alpha beta E)
  (check-swinging 'pendulum-oscillating-frequency alpha beta E)
  (g:/ (g:* pi (omega-0 alpha beta)) (g:* 2.0 (first-elliptic-integral (modulus beta E)))))

(define (pendulum-circulating-frequency alpha beta E)
  (check-turning 'pendulum-circulating-frequency alpha beta E)
  (g:/ (g:* pi (omega-R alpha beta E)) (first-elliptic-integral (turning-modulus beta E))))

(define (pendulum-oscillating-action alpha beta E)
  (cond
    [(separatrix? beta E) (pendulum-separatrix-action alpha beta)]
    [else
     (check-swinging 'pendulum-oscillating-action alpha beta E)
     (define k (modulus beta E))
     (elliptic-integrals
      k
      (lambda (K E)
        (g:* (/ 8.0 pi) (g:sqrt (g:* alpha beta)) (g:- E (g:* (g:- 1.0 (g:square k)) K)))))]))

(define (pendulum-circulating-action alpha beta E)
  (cond
    [(separatrix? beta E) (g:* 1/2 (pendulum-separatrix-action alpha beta))]
    [else
     (check-turning 'pendulum-circulating-action alpha beta E)
     (define k (turning-modulus beta E))
     (g:/ (g:* (/ 4.0 pi) (g:sqrt (g:* alpha beta)) (second-elliptic-integral k)) k)]))

;; There the actions have limits, which are not differentiated by the energy.
(define (separatrix? beta E) (and (real? beta) (real? E) (= beta E)))

;; The action of the separatrix, which encloses all states in which the pendulum swings
(define (pendulum-separatrix-action alpha beta)
  (check-parameters 'pendulum-separatrix-action alpha beta)
  (g:* (/ 8.0 pi) (g:sqrt (g:* alpha beta))))

;; ---------------------------------------------------------------------------
;; Motions: functions of the time since θ = 0

(define-printed (pendulum-oscillating-angle alpha beta E)
  (check-swinging 'pendulum-oscillating-angle alpha beta E)
  (define k (modulus beta E))
  (lambda (t)
    (Jacobi-elliptic-functions (g:* (omega-0 alpha beta) t) k
                               (lambda (sn cn dn) (g:* 2.0 (g:asin (g:* k sn)))))))

(define-printed (pendulum-oscillating-angular-momentum alpha beta E)
  (check-swinging 'pendulum-oscillating-angular-momentum alpha beta E)
  (define-values (k omega) (values (modulus beta E) (omega-0 alpha beta)))
  (lambda (t)
    (Jacobi-elliptic-functions (g:* omega t) k
                               (lambda (sn cn dn) (g:* 2.0 alpha omega k cn)))))

;; Between −π and π, of the turn that t is in
(define-printed (pendulum-circulating-angle alpha beta E)
  (check-turning 'pendulum-circulating-angle alpha beta E)
  (lambda (t)
    (in-turn alpha beta E t (lambda (sn cn dn) (g:* 2.0 (g:asin sn))))))

(define-printed (pendulum-circulating-angular-momentum alpha beta E)
  (check-turning 'pendulum-circulating-angular-momentum alpha beta E)
  (lambda (t)
    (in-turn alpha beta E t
             (lambda (sn cn dn) (g:* 2.0 alpha (omega-R alpha beta E) dn)))))

(define (in-turn alpha beta E t receive)
  (define omega (omega-R alpha beta E))
  (define k (turning-modulus beta E))
  (define period (g:/ (g:* 2.0 (first-elliptic-integral k)) omega))
  (define turns (round (number-of 'pendulum-circulating-angle "the time" (g:/ t period))))
  (Jacobi-elliptic-functions (g:* omega (g:- t (g:* turns period))) k receive))

(define-printed (pendulum-separatrix-angle alpha beta)
  (check-parameters 'pendulum-separatrix-angle alpha beta)
  (lambda (t)
    (g:* 2 (gudermannian (g:* (omega-0 alpha beta) t)))))

(define-printed (pendulum-separatrix-angular-momentum alpha beta)
  (check-parameters 'pendulum-separatrix-angular-momentum alpha beta)
  (lambda (t)
    (g:/ (g:* 2 (g:sqrt (g:* alpha beta))) (g:cosh (g:* (omega-0 alpha beta) t)))))

;; gd x = ∫ dx/cosh x = 2 atan eˣ − π/2
(define (gudermannian x) (g:- (g:* 2 (g:atan (g:exp x))) :pi/2))
(define (inverse-gudermannian x) (g:log (g:tan (g:+ (g:* 1/2 x) (/ :pi/2 2)))))
