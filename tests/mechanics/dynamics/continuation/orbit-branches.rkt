#lang racket/base
;; Periodic orbits found and followed, against published values.

(require racket/flonum
         mechanics
         (only-in mechanics/dynamics/continuation/curve-step
                  equations-evaluate evaluated-residual evaluated-slopes)
         (only-in mechanics/dynamics/continuation/orbit-branch orbits-from unknowns-at)
         (only-in mechanics/dynamics/continuation/orbit-equations orbit-equations)
         "../../support/checks.rkt" "../../support/close.rkt" "../../support/messages.rkt")

(define (kinds b) (map special-point-kind (branch-special-points b)))
(define (places b) (map special-point-parameter (branch-special-points b)))
(define (final xs) (car (reverse xs)))

;; x'' + (a - 2 q cos 2t) x = 0 with q = 1.  Its characteristic values: M. Abramowitz and I. Stegun,
;; Handbook of Mathematical Functions, ch. 20, and DLMF 28.
(define ((Mathieu a) s)
  (up 1 (ref s 2) (* -1 (- a (* 2 (cos (* 2 (ref s 0))))) (ref s 1))))

(test-case "Mathieu's tongues are where the characteristic values are"
  (define b (continue-periodic-orbit Mathieu (up 0 0 0) :pi -1 5))
  (check-equal? (kinds b) '(pitchfork period-doubling period-doubling pitchfork pitchfork))
  (check-close (places b) '(-0.4551386 -0.1102488 1.8591081 3.9170248 4.3713010) 1e-7))

(define (H-Henon-Heiles s)
  (define-values (x y) (values (ref (coordinate s) 0) (ref (coordinate s) 1)))
  (+ (* 1/2 (square (momentum s))) (* 1/2 (+ (square x) (square y)))
     (* (square x) y) (* -1/3 (cube y))))
(define Henon-Heiles (Hamiltonian->state-derivative H-Henon-Heiles))
(define start (up 0 (up 0 0.1) (down 0 0.1)))

;; M. Brack, Foundations of Physics 31 (2001) 209: the orbit on a straight line branches at the
;; energies 0.969309 and 0.986709, in units of that of the saddles, 1/6.
(test-case "the straight orbit of Henon and Heiles by its energy"
  (define b (continue-periodic-orbit Henon-Heiles start 6.3 0.01 0.166 #:energy H-Henon-Heiles))
  (define forks
    (for/list ([s (branch-special-points b)] #:when (eq? (special-point-kind s) 'pitchfork))
      (* 6 (special-point-parameter s))))
  (check-close forks '(0.969309 0.986709) 1e-6)
  (for ([E (branch-parameters b)] [state (branch-states b)] [T (branch-periods b)])
    (check-close (H-Henon-Heiles state) E 1e-9)
    (check-true (< 6.2 T 20))))

(test-case "an orbit at the energy of its start, with multipliers on the unit circle"
  (define o (find-periodic-orbit Henon-Heiles start 6.3 #:energy H-Henon-Heiles))
  (check-close (H-Henon-Heiles (periodic-orbit-state o)) (H-Henon-Heiles start) 1e-12)
  (check-close (real-part (apply * (periodic-orbit-multipliers o))) 1 1e-9)
  (check-true (periodic-orbit-stable? o))
  (define end
    ((state-advancer (lambda () Henon-Heiles)) (periodic-orbit-state o) (periodic-orbit-period o)))
  (check-close (coordinate end) (coordinate (periodic-orbit-state o)) 1e-9)
  (check-regexp-match #rx"^stable periodic orbit of period 6[.]33.* through [(]up 0 "
                      (format "~a" o)))

;; Earth and Moon.  The planar Lyapunov orbits at L1 lose their stability across the plane where
;; halo orbits begin.  The Jacobi constant there was computed by another program: a shooting from
;; axis to axis by Runge and Kutta's method, and Hill's equation across the plane, of trace 2.
(define mu 0.012150585609624)
(define (H-Moon s)
  (define-values (q p) (values (coordinate s) (momentum s)))
  (define-values (x y z) (values (ref q 0) (ref q 1) (ref q 2)))
  (define across (+ (square y) (square z)))
  (- (+ (* 1/2 (square p)) (* y (ref p 0)) (* -1 x (ref p 1)))
     (/ (- 1 mu) (sqrt (+ (square (+ x mu)) across)))
     (/ mu (sqrt (+ (square (+ x mu -1)) across)))))

(test-case "planar Lyapunov orbits at L1, and where halo orbits leave them"
  (define f (Hamiltonian->state-derivative H-Moon))
  (define o
    (find-periodic-orbit f (up 0 (up 0.8269 0 0) (down 0 0.9106 0)) 2.69 #:energy H-Moon))
  (check-false (periodic-orbit-stable? o))
  (define b
    (continue-periodic-orbit f (periodic-orbit-state o) (periodic-orbit-period o)
                             (H-Moon (periodic-orbit-state o)) -1.58 #:energy H-Moon))
  (check-equal? (kinds b) '(pitchfork))
  (check-close (* -2 (car (places b))) 3.1743519541 1e-9)
  (define halo (switch-branch b (car (branch-special-points b)) #:most-steps 40))
  (check-true (> (magnitude (ref (car (reverse (branch-states halo))) 1 2)) 1e-3)))

;; The pendulum of G. Baker and J. Gollub, Chaotic Dynamics (1990), with q = 2 and a drive of 2/3.
;; Where the multiplier of the lopsided orbit is -1 was computed by another program as well.
(test-case "the damped driven pendulum: broken symmetry, then a cascade of doublings"
  (define ((pendulum A) s)
    (up 1 (ref s 2)
        (+ (* -1 (sin (ref s 1))) (* -1/2 (ref s 2)) (* A (cos (* 2/3 (ref s 0)))))))
  (define T (* 3 :pi))
  (define symmetric (continue-periodic-orbit pendulum (up 0 0.5 0) T 0.5 1.12))
  (check-equal? (kinds symmetric) '(pitchfork))
  (define lopsided (switch-branch symmetric (car (branch-special-points symmetric))))
  (define mirrored
    (switch-branch symmetric (car (branch-special-points symmetric)) #:direction -1))
  (check-equal? (kinds lopsided) '(period-doubling))
  (check-close (places lopsided) (places mirrored) 1e-9)
  (check-close (places lopsided) '(1.0663728625) 1e-9)
  (define twice (switch-branch lopsided (car (branch-special-points lopsided))))
  (check-equal? (kinds twice) '(period-doubling))
  (check-close (car (branch-periods twice)) (* 2 T) 1e-9)
  (define four (switch-branch twice (car (branch-special-points twice)) #:most-steps 30))
  (define-values (first second third) (apply values (map (lambda (b) (car (places b)))
                                                         (list lopsided twice four))))
  (check-true (< 3.5 (/ (- second first) (- third second)) 6)))

(test-case "an orbit that attracts: van der Pol's, of period 6.6633 at damping 1"
  (define ((van-der-Pol m) s)
    (up (ref s 1) (- (* m (- 1 (square (ref s 0))) (ref s 1)) (ref s 0))))
  (define o (find-periodic-orbit (van-der-Pol 1) (up 2.0 0.1) 6.5))
  (check-close (periodic-orbit-period o) 6.66328686 1e-7)
  (check-true (periodic-orbit-stable? o))
  (define b (continue-periodic-orbit van-der-Pol (up 2.0 0.1) 6.5 1 2))
  (check-close (car (reverse (branch-periods b))) 7.62987448 1e-7))

;; A circle of radius 1 and period 2π, across which u + iv is multiplied by exp 2π(p + i√2) in one
;; turn: the growth p + x has the mean p.
(define ((circle-and-spiral p) s)
  (define-values (x y u v) (values (ref s 0) (ref s 1) (ref s 2) (ref s 3)))
  (define to-circle (- 1 (square x) (square y)))
  (define growth (+ p x (* -1 (square u)) (* -1 (square v))))
  (up (- (* to-circle x) y) (+ x (* to-circle y))
      (- (* growth u) (* (sqrt 2) v)) (+ (* (sqrt 2) u) (* growth v))))

(test-case "a torus leaves an orbit where a pair of multipliers crosses the unit circle"
  (define b (continue-periodic-orbit circle-and-spiral (up 1.0 0 0 0) (* 2 :pi) -0.2 0.2))
  (check-equal? (kinds b) '(torus))
  (check-close (places b) '(0) 1e-9)
  (check-equal? (list (car (branch-stabilities b)) (final (branch-stabilities b))) '(#t #f))
  (define turned (exp (* +i 2 :pi (sqrt 2))))
  (check-true (for/or ([l (special-point-spectrum (car (branch-special-points b)))])
                (< (magnitude (- l turned)) 1e-8))))

;; A circle of period 2π, across which the plane turns half round in one turn and grows by
;; exp 2π(p − u² − v²) in one direction that turns with it.
(define ((circle-and-band p) s)
  (define-values (x y u v) (values (ref s 0) (ref s 1) (ref s 2) (ref s 3)))
  (define to-circle (- 1 (square x) (square y)))
  (define growth (- p (square u) (square v)))
  (define-values (mean half) (values (* 1/2 (- growth 1)) (* 1/2 (+ growth 1))))
  (up (- (* to-circle x) y) (+ x (* to-circle y))
      (+ (* mean u) (* half (+ (* x u) (* y v))) (* -1/2 v))
      (+ (* mean v) (* half (- (* y u) (* x v))) (* 1/2 u))))

(test-case "a period doubles on a band that is twisted once: along its edge, of twice the length"
  (define b (continue-periodic-orbit circle-and-band (up 1.0 0 0 0) (* 2 :pi) -0.2 0.2))
  (check-equal? (kinds b) '(period-doubling))
  (check-close (places b) '(0) 1e-9)
  (define edge (switch-branch b (car (branch-special-points b)) #:most-steps 9))
  (for ([p (branch-parameters edge)] [s (branch-states edge)] [T (branch-periods edge)])
    (check-close T (* 4 :pi) 1e-8)
    (check-close (+ (square (ref s 2)) (square (ref s 3))) p 1e-8))
  (check-true (> (final (branch-parameters edge)) 1e-5)))

(test-case "multipliers of a driven motion meet on the unit circle: Krein's collision"
  ;; unit masses over a hill by gyroscopic forces, stable while G > 1, and shaken
  (define drive 6)
  (define ((shaken G) s)
    (define-values (q v) (values (coordinate s) (velocity s)))
    (up 1 v (up (+ (ref q 0) (* 2 G (ref v 1)) (* 1/10 (cos (* drive (time s)))))
                (- (ref q 1) (* 2 G (ref v 0))))))
  (define b
    (continue-periodic-orbit shaken (up 0 (up 0 0) (up 0 0)) (/ (* 2 :pi) drive) 1.2 0.9))
  (check-equal? (kinds b) '(Krein-collision))
  (check-close (places b) '(1) 1e-6))

(says
 [(find-periodic-orbit Henon-Heiles start 0)
  "find-periodic-orbit: expected a period that is not 0\n  given: the number 0"]
 [(find-periodic-orbit (lambda (s) (up 1 (ref s 2) (cos (* 2 (ref s 0))))) (up 0 1.0 0.0) 2.0)
  "find-periodic-orbit: the rates of the system are others after that time, which is no period\n"
  "  given: 2.0\n  rates now: (up 1 0.0 1)\n  and then: (up 1 0.0 -0.6536436208636119)\n"
  "  what goes as (cos (* omega t)) has the period (/ :2pi omega)"]
 [(find-periodic-orbit Henon-Heiles start 6.3 #:energy 3)
  "find-periodic-orbit: expected an energy, a function of the state\n  given: the number 3"])

(test-case "a period that is a part of one"
  (check-regexp-match
   (string-append
    "^continue-periodic-orbit: no periodic orbit was found near the state\n  after 2 of these "
    "periods it is back\n  state: .up 1.0 0.0.\n  period: 3.14[0-9]*\n  "
    "after it the state is off by: [12][.]?[0-9]*$")
   (message-of (continue-periodic-orbit (lambda (p) (lambda (s) (up (ref s 1) (* -1 p (ref s 0)))))
                                        (up 1.0 0.0) :pi 1 2)
               exn:fail?)))

(test-case "where all motions come to rest there is no orbit, though a state at rest comes back"
  (define (damped s) (up (ref s 1) (- (* -1 (ref s 0)) (* 0.2 (ref s 1)))))
  (check-regexp-match
   (string-append "^find-periodic-orbit: no periodic orbit was found near the state\n"
                  "  state: .up 0.1 0.\n  period: 6.3\n  after it the state is off by: 0[.]0")
   (message-of (find-periodic-orbit damped (up 0.1 0) 6.3) exn:fail?)))

(test-case "nor is there one where nothing comes back"
  (define (drifting s) (up 1 (+ 1/2 (cos (time s)))))
  (check-regexp-match
   #rx"^find-periodic-orbit: no periodic orbit was found near the state\n  state: .up 0 0.1.\n"
   (message-of (find-periodic-orbit drifting (up 0 0.1) (* 2 :pi)) exn:fail?)))

;; By differences, of an orbit that does not close
(define (check-slopes systems state period energy p)
  (define o (orbits-from 'test systems state period energy 1e-13 p))
  (define x (unknowns-at o state period p))
  (define e (orbit-equations o x 1.0))
  (define (at x) ((equations-evaluate e) x x0))
  (define x0 (flvector-copy x))
  (define (residual k h)
    (define beside (flvector-copy x))
    (flvector-set! beside k (+ h (flvector-ref x k)))
    (evaluated-residual (at beside)))
  (define h 1e-5)
  (for* ([k (flvector-length x)] [i (vector-length (evaluated-slopes (at x)))])
    (check-= (vector-ref (vector-ref (evaluated-slopes (at x)) i) k)
             (/ (- (flvector-ref (residual k h) i) (flvector-ref (residual k (- h)) i)) (* 2 h))
             1e-6)))

(test-case "the equations of an orbit have the derivatives that they say"
  (define ((van-der-Pol m) s)
    (up (ref s 1) (- (* m (- 1 (square (ref s 0))) (ref s 1)) (ref s 0))))
  (check-slopes van-der-Pol (up 2.0 0.1) 2.0 #f 1.0)
  (check-slopes (lambda (p) Henon-Heiles) start 2.0 H-Henon-Heiles (H-Henon-Heiles start))
  (check-slopes (lambda (w) (lambda (s) (up 1 (ref s 2) (- (cos (* w (time s))) (sin (ref s 1))))))
                (up 0 0.5 0.1) (lambda (w) (/ (* 2 :pi) w)) #f 3.0))

(define (mirror s) (up (- (time s)) (coordinate s) (- (momentum s))))

(test-case "an orbit that reversal of time leaves where it is starts at rest, and comes to rest"
  (define o
    (find-periodic-orbit Henon-Heiles (up 0 (up 0 0.15) (down 0 0)) 6.3
                         #:energy H-Henon-Heiles #:symmetry mirror))
  (define half (/ (periodic-orbit-period o) 2))
  (define end ((state-advancer (lambda () Henon-Heiles)) (periodic-orbit-state o) half))
  (check-close (momentum end) (down 0 0) 1e-9)
  (check-close (coordinate (periodic-orbit-state o)) (up 0 0.15) 1e-9))

(says
 [(find-periodic-orbit Henon-Heiles start 6.3 #:symmetry (lambda (s) 1))
  "find-periodic-orbit: expected a symmetry, a function from states to states\n"
  "  given: a function without a name"])
