#lang racket/base
;; Normal forms at equilibria that are not made of oscillators already, against formulas and numbers
;; of the literature, and against H itself.

(require mechanics
         "../support/checks.rkt" "../support/close.rkt" "../support/messages.rkt"
         "../support/session.rkt")

(define line (up 't 'q 'p))
(define plane (up 't (up 'x 'y) (down 'p_x 'p_y)))
(define space (up 't (up 'x 'y 'z) (down 'p_x 'p_y 'p_z)))

(define ((attraction part x0) x y [z 0])
  (/ part (sqrt (+ (square (- x x0)) (square y) (square z)))))

;; The restricted problem in the turning frame
(define ((restricted mu) (up t (up x y) (down a b)))
  (+ (* 1/2 (+ (square a) (square b))) (* y a) (* -1 x b)
     (* -1 ((attraction (- 1 mu) (* -1 mu)) x y)) (* -1 ((attraction mu (- 1 mu)) x y))))
(define (triangle mu)
  (up 0 (up (- 1/2 mu) (/ (sqrt 3) 2)) (down (/ (sqrt 3) -2) (- 1/2 mu))))
(define (form mu [degree 4])
  (Birkhoff-normal-form (restricted mu) plane #:degree degree #:at (triangle mu)))

(define Earth-Moon 0.0121505856)

;; The value of a term at actions
(define ((of-actions N degree) a b)
  ((series:ref (normal-form-Hamiltonian N) (- degree 2))
   (up 0 (up (sqrt (* 2 a)) (sqrt (* 2 b))) (down 0 0))))

(define (frequencies-at-triangle mu)
  (define root (sqrt (- 1 (* 27 mu (- 1 mu)))))
  (values (sqrt (/ (- 1 root) 2)) (sqrt (/ (+ 1 root) 2))))

(test-case "L4 of Earth and Moon: the slow oscillator has negative energy"
  (define-values (slow fast) (frequencies-at-triangle Earth-Moon))
  (check-close (list slow fast) '(0.29821 0.95450) 1e-5)
  (check-close (normal-form-frequencies (form Earth-Moon 3)) (list (- slow) fast) 1e-12))

;; Deprit and Deprit-Bartholomé 1967: ½ A I₁² + B I₁ I₂ + ½ C I₂² beside ω₁ I₁ − ω₂ I₂, ω₁ the
;; fast one
(test-case "terms of degree 4 at L4, by the formulas of Deprit and Deprit-Bartholomé"
  (for ([mu '(0.001 0.0121505856 0.03)])
    (define-values (slow fast) (frequencies-at-triangle mu))
    (define (own w v)
      (/ (* (square v) (+ 81 (* -696 (square w)) (* 124 (expt w 4))))
         (* 72 (square (- 1 (* 2 (square w)))) (- 1 (* 5 (square w))))))
    (define p (square (* slow fast)))
    (define mixed (/ (* -1 slow fast (+ 43 (* 64 p))) (* 6 (- (* 4 p) 1) (- (* 25 p) 4))))
    (define H4 (of-actions (form mu) 4))
    (check-close (H4 1 0) (/ (own slow fast) 2) 1e-9)
    (check-close (H4 0 1) (/ (own fast slow) 2) 1e-9)
    (check-close (- (H4 1 1) (H4 1 0) (H4 0 1)) mixed 1e-9)))

(test-case "the mass ratio at which Arnold's determinant vanishes"
  (define (Arnold mu)
    (define N (form mu))
    (define w (normal-form-frequencies N))
    ((of-actions N 4) (cadr w) (- (car w))))
  (check-close (find-root Arnold 0.0105 0.0113) 0.010913667677 1e-11))

;; ω₁ = k ω₂, with ω₁² + ω₂² = 1 and ω₁² ω₂² = 27 μ (1 − μ)/4
(define (resonant-ratio k)
  (define w (/ 1.0 (+ 1 (square k))))
  (/ (- 1 (sqrt (- 1 (* 16/27 (square (* k w)))))) 2))

(test-case "the resonances 1:2 and 1:3 at L4 keep their terms"
  (check-close (map resonant-ratio '(2 3)) '(0.024293897 0.013516016) 1e-9)
  (check-equal? (normal-form-resonances (form (resonant-ratio 2) 3)) '((2 1)))
  (check-equal? (normal-form-resonances (form (resonant-ratio 3) 3)) '())
  (check-equal? (normal-form-resonances (form (resonant-ratio 3) 4)) '((3 1)))
  (check-regexp-match #rx"\n  near resonances, undecided: [(][(][(]2 1[)] 1[.]25[0-9]*e-0?9[)][)]$"
                      (format "~a" (form 0.0242938971 3)))
  (check-equal? (normal-form-resonances
                 (Birkhoff-normal-form (restricted 0.0242938971) plane #:degree 3
                                       #:at (triangle 0.0242938971) #:tolerance 1e-8))
                '((2 1))))

(define (quadratic mu)
  (symplectic-normal-form (restricted mu) plane #:at (triangle mu)))

(test-case "Routh's ratio: undecided beside it, complex beyond"
  (define Routh (quadratic 0.0385208965))
  (check-equal? (quadratic-normal-form-status Routh) 'undecided)
  (check-false (quadratic-normal-form-matrix Routh))
  (check-close (quadratic-normal-form-distance Routh) 1.1e-11 1e-12)
  (check-equal? (quadratic-normal-form-status (quadratic (/ (- 1 (sqrt 23/27)) 2)))
                'not-semisimple)
  (check-equal? (quadratic-normal-form-status (quadratic 0.0385)) 'found)
  (define beyond (car (quadratic-normal-form-blocks (quadratic 0.05))))
  (check-equal? (car beyond) 'complex)
  ;; (α + iβ)² = −1/2 ± i √(27 μ (1 − μ) − 1)/2
  (define-values (a b) (apply values (cdr beyond)))
  (check-close (list (- (square a) (square b)) (* 2 a b))
               (list -0.5 (/ (sqrt (- (* 27 0.05 0.95) 1)) 2)) 1e-12)
  (check-message
   (string-append "Birkhoff-normal-form: undecided whether the quadratic terms are semisimple\n"
                  "  frequencies: 0.707103016 and 0.707110546\n"
                  "  distance to terms that are not, beside the greatest: 1.1e-11")
   (form 0.0385208965)))

;; Frequencies of the linear motion at L1 from the literature (Szebehely 1967)
(test-case "L1: an oscillator and a saddle, found from a place near it"
  (define N (Birkhoff-normal-form (restricted Earth-Moon) plane
                                  #:at (up 0 (up 0.8369 0) (down 0 0.8369))))
  (check-close (coordinate (normal-form-equilibrium N)) (up 0.8369151 0) 1e-7)
  (define-values (oscillator saddle) (apply values (normal-form-frequencies N)))
  (check-close (list oscillator (real-part saddle) (imag-part saddle)) '(2.334386 0 2.932056) 1e-6)
  (check-equal? (normal-form-resonances N) '()))

;; H(C(z)) − N(z) is of the degree after the last
(define (off N H z last)
  (abs (- (H ((normal-form-transformation N) z)) (H (normal-form-equilibrium N))
          (for/sum ([k (- last 1)]) ((series:ref (normal-form-Hamiltonian N) k) z)))))

(define (check-is-form N H z last)
  (define (state r) (up 0 (* r (coordinate z)) (* r (momentum z))))
  (check-true (> (/ (off N H (state 1.0) last) (off N H (state 0.5) last)) (expt 1.9 (+ last 1))))
  (check-close ((normal-form-inverse N) ((normal-form-transformation N) (state 0.01))) (state 0.01)
               1e-9))

(define small-plane (up 0 (up 0.05 0.03) (down -0.02 0.04)))

(test-case "H in the new state is the normal form: centre, saddle and complex exponents"
  (check-is-form (form Earth-Moon 5) (restricted Earth-Moon) small-plane 5)
  (check-is-form (form 0.1 4) (restricted 0.1) (up 0 (up 0.01 0.006) (down -0.004 0.008)) 4)
  (check-is-form (Birkhoff-normal-form (restricted Earth-Moon) plane #:degree 4
                                       #:at (up 0 (up 0.8369 0) (down 0 0.8369)))
                 (restricted Earth-Moon) (up 0 (up 0.01 0.006) (down -0.004 0.008)) 4))

(test-case "its derivatives are symplectic"
  (define M
    (qp-submatrix ((D-as-matrix (normal-form-transformation (form Earth-Moon 6)))
                   (up 0 (up 0.0002 0.0001) (down -0.0001 0.0002)))))
  (define rest (symplectic-matrix? M))
  (check-close (for*/list ([i 4] [j 4]) (matrix-ref rest i j)) (for*/list ([i 4] [j 4]) 0) 1e-8))

(test-case "degree 8 of three degrees of freedom"
  (define ((restricted-in-space mu) (up t (up x y z) (down a b c)))
    (+ (* 1/2 (+ (square a) (square b) (square c))) (* y a) (* -1 x b)
       (* -1 ((attraction (- 1 mu) (* -1 mu)) x y z)) (* -1 ((attraction mu (- 1 mu)) x y z))))
  (define at
    (up 0 (up (- 1/2 Earth-Moon) (/ (sqrt 3) 2) 0) (down (/ (sqrt 3) -2) (- 1/2 Earth-Moon) 0)))
  (define H (restricted-in-space Earth-Moon))
  (define N (Birkhoff-normal-form H space #:degree 8 #:at at))
  (check-close (caddr (normal-form-frequencies N)) 1 1e-12)
  (check-is-form N H (up 0 (up 0.04 0.03 0.02) (down -0.02 0.04 0.03)) 8))

;; By hand: ρ(θ²/2 − p²) leaves ¾·½ (q (θ² − p²) + 2 p_r θ p)/√2.
(test-case "a spring pendulum, 2:1"
  (define (H (up t (up r theta) (down a b)))
    (+ (* 1/2 (+ (square a) (square (/ b r)))) (* 2 (square (- r 3/4))) (* -1 r (cos theta))))
  (define N (Birkhoff-normal-form H plane #:at (up 0 (up 0.9 0) (down 0 0)) #:degree 3))
  (check-equal? (normal-form-equilibrium N) (up 't (up 1 0) (down 0 0)))
  (check-equal? (normal-form-frequencies N) '(2 1))
  (check-equal? (normal-form-resonances N) '((1 -2)))
  (define (H3 q th a b) ((series:ref (normal-form-Hamiltonian N) 1) (up 0 (up q th) (down a b))))
  (for ([z '((1 1 0 0) (1 0 0 1) (0 1 1 1) (1 2 3 4))])
    (define-values (q th a b) (apply values z))
    (check-close (H3 q th a b)
                 (* 3/8 (sqrt 1/2) (+ (* q (- (square th) (square b))) (* 2 a th b))) 1e-12)))

;; E = J − J²/16 − J³/256 of the pendulum, continued to J = −q p, E = −H
(test-case "the pendulum upside down"
  (define N (Birkhoff-normal-form (lambda (s) (+ (/ (square (momentum s)) 2) (cos (coordinate s))))
                                  line #:degree 6))
  (check-equal? (normal-form-frequencies N) '(+i))
  (for ([k '(0 2 4)] [c '(1 1/16 -1/256)] [n '(1 2 3)])
    (check-identity (series:ref ((normal-form-Hamiltonian N) line) k) (* c (expt (* 'q 'p) n)))))

(test-case "exact where it can be, and rounding is no obstacle"
  (define (H s)
    (define x (- (coordinate s) 3))
    (+ (* 1/2 (square (momentum s))) (* 8 (square x)) (expt x 4)))
  (define N (Birkhoff-normal-form H line))
  (check-equal? (normal-form-equilibrium N) (up 't 3 0))
  (check-equal? (normal-form-frequencies N) '(4))
  (check-equal? (quadratic-normal-form-matrix (symplectic-normal-form H line))
                (matrix-by-rows '(1/2 0) '(0 2)))
  (define rounded
    (Birkhoff-normal-form (lambda (s) (+ (square (momentum s)) (* 1e-16 (coordinate s))
                                         (* 1/2 (sqrt 2.0) (sqrt 2.0) (square (coordinate s)))))
                          line))
  (check-close (normal-form-frequencies rounded) '(2) 1e-15)
  (check-close ((normal-form-transformation rounded) (up 0 1 2)) (up 0 1 2) 1e-15))

(says
 [(Birkhoff-normal-form (lambda (s) (square (momentum s))) line #:at (up 0 'x 0))
  "Birkhoff-normal-form: the equilibrium is a state of numbers; given (up 0 x 0), an up tuple of 3"]
 [(form 0.1 64)
  "Birkhoff-normal-form: expected the degree of the last terms, from 3 to 63\n"
  "  given: the number 64"]
 [(Birkhoff-normal-form (lambda (s) (+ (square (momentum s)) (square (- (coordinate s) 3)))) line
                        #:at (up 0 1 0))
  "Birkhoff-normal-form: there is no equilibrium of <function> at (up t 1 0)\n"
  "  derivatives there: (-4 0)\n"
  "  one is at (up t 3.0 0.0)"])

;; ---------------------------------------------------------------------------
;; Equilibria found

(define (swing s) (- (/ (square (momentum s)) 2) (cos (coordinate s))))

(test-case "an equilibrium next to the state named, or to the origin"
  (define (shifted s)
    (+ (coordinate s) (/ (square (coordinate s)) 2) (/ (square (momentum s)) 2)))
  (define (near q) (coordinate (normal-form-equilibrium
                                (Birkhoff-normal-form swing line #:degree 3 #:at (up 0 q 0)))))
  (check-equal? (coordinate (normal-form-equilibrium (Birkhoff-normal-form shifted line))) -1)
  (check-equal? (near 0.1) 0)
  (check-= (near 3.1) pi 1e-12)
  (check-= (near 6.2) (* 2 pi) 1e-12))

(says
 [(Birkhoff-normal-form swing line #:at (up 0 0.15 0))
  "Birkhoff-normal-form: there is no equilibrium of swing at (up t 0.15 0)\n"
  "  derivatives there: (0.14943813247359922 0)\n  one is at (up t 0.0 0.0)"])
