#lang racket/base
;; SICM 5.2, General Canonical Transformations (pp. 342-357).

(require mechanics
         mechanics/scmutils
         mechanics/book
         "../support/checks.rkt"
         "../support/close.rkt" "../support/messages.rkt" "../support/session.rkt")

(define line (up 't 'theta 'I))
(define polar (up 't (up 'r 'phi) (down 'p_r 'p_phi)))
(define space (up 't (up 'x 'y 'z) (down 'p_x 'p_y 'p_z)))
(define plane (up 't (up 'x 'y) (down 'p_x 'p_y)))
(define two-particles
  (up 't
      (up (up 'x_1 'y_1) (up 'x_2 'y_2))
      (down (down 'p_x_1 'p_y_1) (down 'p_x_2 'p_y_2))))

(define (zeros-like state) (* 0 state))
(define (no-entries n) (* 0 (identity-matrix n)))

(test-case "p. 344: polar coordinates are canonical for a central field"
  (define H (H-central 'm (literal-function 'V)))
  (check-identity ((canonical? (F->CH p->r) H (compose H (F->CH p->r))) polar) (zeros-like polar))
  (check-identity ((compositional-canonical? (F->CH p->r) H) polar) (zeros-like polar)))

(test-case "pp. 345-346: the oscillator in its polar-canonical coordinates"
  (define H (H-harmonic 'm 'k))
  (define C (polar-canonical 'alpha))
  (check-prints ((canonical? C H (compose H C)) line) '(up 0 0 0))
  (check-prints ((compose H (polar-canonical (sqrt (* 'k 'm)))) line) '(* I (sqrt (/ k m))))
  (check-identity ((compose (polar-canonical 'alpha) (polar-canonical-inverse 'alpha))
                   (up 't 'x 'p))
                  (up 't 'x 'p))
  (check-close ((compose (polar-canonical-inverse 2.0) (polar-canonical 2.0)) (up 0 1.25 3.0))
               '(0 1.25 3.0) 1e-14))

(test-case "of several coordinates each is taken by itself"
  (define state (up 't (up 'a 'b) (down 'I 'J)))
  (check-identity ((symplectic-transform? (polar-canonical 'alpha)) state) (no-entries 4)))

(test-case "p. 348: turning coordinates, for any Hamiltonian"
  (define C (C-rotating 'n))
  (check-prints ((rotating 'n) space)
                '(up (- (* x (cos (* n t))) (* y (sin (* n t))))
                     (+ (* x (sin (* n t))) (* y (cos (* n t))))
                     z))
  (check-prints ((F->K (rotating 'n)) space) '(- (* n p_x y) (* n p_y x)))
  (check-identity ((canonical-H? C H-arbitrary) space) (zeros-like space))
  (check-identity ((canonical-K? C (K-rotating 'n)) space) (zeros-like space))
  (check-identity ((canonical-K? C (F->K (rotating 'n))) space) (zeros-like space))
  (check-pred refuted? (prove-zero ((canonical-K? C (- (K-rotating 'n))) space)))
  (check-pred proved? (verify-canonical C H-arbitrary
                                        (+ (compose H-arbitrary C) (K-rotating 'n)) space))
  (check-pred refuted? (verify-canonical C H-arbitrary (compose H-arbitrary C) space)))

(test-case "p. 347: the terms of the equations"
  (check-prints (T-func polar) '(up 1 (up 0 0) (down 0 0)))
  (check-prints (J-func (down 'a (down 'b 'c) (up 'd 'e)))
                '(up 0 (up d e) (down (* -1 b) (* -1 c))))
  (check-identity (J-func ((D (H-harmonic 'm 'k)) (up 't 'x 'p)))
                  ((D-phase-space (H-harmonic 'm 'k)) (up 't 'x 'p))))

(test-case "pp. 351-352: without a Hamiltonian"
  (define zeros ((canonical-transform? (F->CH p->r)) polar))
  (check-prints zeros
                '(up (up 0 (up 0 0) (down 0 0))
                     (up (up 0 (up 0 0) (down 0 0)) (up 0 (up 0 0) (down 0 0)))
                     (down (up 0 (up 0 0) (down 0 0)) (up 0 (up 0 0) (down 0 0)))))
  (check-prints ((canonical-transform? (polar-canonical 'alpha)) line)
                '(up (up 0 0 0) (up 0 0 0) (up 0 0 0)))
  (check-prints ((canonical-transform? a-non-canonical-transform) (up 't 'theta 'p))
                '(up (up 0 0 0) (up 0 0 (- p 1)) (up 0 (- 1 p) 0))))

(test-case "the residual is J − DC J DCᵀ, contracted as structures"
  (define s (up 't 'theta 'p))
  (define DC ((D a-non-canonical-transform) s))
  (define J ((D J-func) (compatible-shape s)))
  (check-identity ((canonical-transform? a-non-canonical-transform) s)
                  (- J (* DC (* J ((multiplicative-transpose (compatible-shape s)) DC))))))

(test-case "p. 353: J is the matrix of the shuffle of derivatives; p. 355: without the time"
  (define gradient (compatible-shape plane))
  (check-equal? (simplify (s->m gradient ((D J-func) gradient) gradient)) (J-matrix 2))
  (check-equal? (J-matrix 2)
                (matrix-by-rows '(0 0 0 0 0)
                                '(0 0 0 1 0) '(0 0 0 0 1) '(0 -1 0 0 0) '(0 0 -1 0 0)))
  (check-equal? (symplectic-unit 2)
                (matrix-by-rows '(0 0 1 0) '(0 0 0 1) '(-1 0 0 0) '(0 -1 0 0)))
  (check-equal? (qp-submatrix (J-matrix 3)) (symplectic-unit 3))
  (check-identity (symplectic-matrix? (symplectic-unit 3)) (no-entries 6))
  (check-identity (symplectic-matrix? (* 2 (symplectic-unit 1))) (* -3 (symplectic-unit 1))))

(test-case "p. 355: the transpose of the symplectic unit is its inverse and its negative"
  (define J (symplectic-unit 2))
  (check-identity (transpose J) (- J))
  (check-identity (/ J) (- J)))

(test-case "the brackets are those of the matrix product"
  (define M (m:generate 4 4 (lambda (i j) (string->symbol (format "m_~a~a" i j)))))
  (define J (symplectic-unit 2))
  (check-identity (symplectic-matrix? M) (- J (* M J (transpose M)))))

;; pp. 354-356: residuals as structures, and as matrices
(define (as-matrix residual)
  (define gradient (compatible-shape plane))
  (simplify (s->m gradient residual gradient)))

(test-case "p. 354: where the time is a function of the time alone, only q and p matter"
  (check-prints (time (C-simple-time plane)) '(tau t))
  (define residual (as-matrix ((canonical-transform? C-simple-time) plane)))
  (check-prints (m:nth-row residual 0) '(down 0 0 0 0 0))
  (check-prints (m:nth-col residual 0) '(up 0 0 0 0 0))
  (check-equal? (as-matrix ((canonical-transform? C-simple-time) plane))
                (simplify ((symplectic? C-simple-time) plane)))
  (check-pred refuted? (prove-zero (m:nth-row ((symplectic? C-general) plane) 0))))

(test-case "p. 356: the two conditions are one, for any transformation"
  (check-identity (- (qp-submatrix (as-matrix ((canonical-transform? C-general) plane)))
                     ((symplectic-transform? C-general) plane))
                  (no-entries 4)))

;; The condition written out, with the transpose of a structure that is given its neighbour.
(test-case "p. 351: J − DC J DCᵀ"
  (define ((canonical-condition C) s)
    (define-values (J DC) (values ((D J-func) (compatible-shape s)) ((D C) s)))
    (- J (* DC J (transpose DC s))))
  (for ([C (list C-general (polar-canonical 'alpha) a-non-canonical-transform)]
        [s (list plane line (up 't 'theta 'p))])
    (check-equal? (simplify ((canonical-transform? C) s)) (simplify ((canonical-condition C) s)))))

(test-case "the matrices of a transformation that changes the time"
  (define M ((D-as-matrix C-general) polar))
  (check-identity (qp-submatrix ((symplectic? C-general) polar))
                  (symplectic-matrix? (qp-submatrix M))))

(test-case "p. 355: point transformations are symplectic"
  (define (F state)
    (define f (lambda (name) (literal-function name (-> (X Real Real Real) Real))))
    (define-values (q) (coordinate state))
    (up ((f 'f) (time state) (ref q 0) (ref q 1)) ((f 'g) (time state) (ref q 0) (ref q 1))))
  (check-identity ((symplectic-transform? (F->CH F)) polar) (no-entries 4))
  (check-pred proved? (verify-symplectic (F->CH F) polar))
  (check-prints ((symplectic-transform? a-non-canonical-transform) (up 't 'theta 'p))
                '(matrix-by-rows (list 0 (- 1 p)) (list (- p 1) 0))))

(test-case "the tests of the first edition"
  (check-identity ((time-independent-canonical? (F->CT p->r)) polar) (zeros-like polar))
  (check-identity ((time-independent-canonical? (polar-canonical 'alpha)) line) (up 0 0 0))
  (check-identity ((time-independent-canonical? a-non-canonical-transform) (up 't 'theta 'p))
                  (up 0 (* (- 1 'p) 'x2) (* (- 'p 1) 'x1)))
  (check-identity ((qp-canonical? (F->CT p->r) (H-central 'm (literal-function 'V))) polar)
                  (zeros-like polar)))

(test-case "two particles and their centre of mass"
  (define C (two-particle-center-of-mass-canonical 'm_1 'm_2))
  (check-identity (coordinate (C two-particles))
                  ((two-particle-center-of-mass 'm_1 'm_2) two-particles))
  (check-pred proved? (verify-canonical C two-particles))
  ;; F->CH takes the coordinates the other way: F gives the old ones
  (define (back state)
    (define-values (X x) (values (ref (coordinate state) 0) (ref (coordinate state) 1)))
    (up (- X (* (/ 'm_2 (+ 'm_1 'm_2)) x)) (+ X (* (/ 'm_1 (+ 'm_1 'm_2)) x))))
  (check-identity ((compose C (F->CH back)) two-particles) two-particles))

(test-case "linear functions and their multipliers"
  (define A (down (up 'a 'c) (up 'b 'd)))
  (define-values (p v) (values (down 'p_x 'p_y) (up 'v_x 'v_y)))
  (check-identity ((Phi A) v) (* A v))
  (check-identity ((Phi* A) p) (* p A))
  (check-identity ((transpose-function A) p) (* p A))
  (check-identity (linear-function->multiplier (Phi A) v) A)
  (check-identity (* (* ((multiplicative-transpose p) A) p) v) (* p (* A v))))

;; ---------------------------------------------------------------------------
;; Verdicts

(test-case "canonical or not, with a witness and a condition"
  (check-pred proved? (verify-canonical (F->CH p->r) polar))
  (define v (verify-canonical a-non-canonical-transform (up 't 'theta 'p)))
  (check-pred refuted? v)
  (check-equal? (map car (verdict-witness v)) '(p))
  (define (stretched state) (up (time state) (* 'a (coordinate state)) (/ (momentum state) 'b)))
  (define w (verify-canonical stretched (up 't 'q 'p)))
  (check-equal? (verdict-conditions w) '((= a b)))
  (check-equal? (verdict-remarks w)
                (list (string-append
                       "all Poisson brackets are multiplied by (/ a b), a constant: the motion "
                       "is that of the Hamiltonian H∘C divided by it"))))

(test-case "which power makes x = Iᵃ sin θ, p = Iᵃ cos θ canonical?"
  (define ((powers a) (up t theta I)) (up t (* (expt I a) (sin theta)) (* (expt I a) (cos theta))))
  (check-pred refuted? (verify-canonical (powers 1) line))
  (define root (lambda (state) (up (time state)
                                   (* 'c (sqrt (momentum state)) (sin (coordinate state)))
                                   (* 'c (sqrt (momentum state)) (cos (coordinate state))))))
  (check-equal? (verdict-alternatives (verify-canonical root line))
                '(((= (expt c 2) 2)))))

(test-case "matrices"
  (check-pred proved? (verify-symplectic (symplectic-unit 2)))
  (check-pred proved? (verify-symplectic (identity-matrix 2)))
  (check-pred refuted? (verify-symplectic (* 2 (identity-matrix 2)))))

;; ---------------------------------------------------------------------------
;; Mistakes

(define (no-momenta state) (up (time state) (coordinate state)))
(define (dropped (up t (up x y) (down p_x p_y))) (up t x p_x))

(says
 [((canonical-transform? p->r) polar)
  "canonical-transform?: a transformation takes a state (up t q p) to another one; p->r gives "
  "(up (* r (cos phi)) (* r (sin phi))), an up tuple of 2\n"
  "  a transformation of the coordinates alone is extended by (F->CH F)"]
 [((symplectic-transform? state->qp) polar)
  "symplectic-transform?: a transformation takes a state (up t q p) to another one; "
  "state->qp gives (up (up r phi) (down p_r p_phi)), an up tuple of 2\n  the time is missing: (up t q p)"]
 [(verify-canonical polar-canonical line)
  "polar-canonical: alpha is a number or a symbol; given (up t theta I), an up tuple of 3\n"
  "  was a parameter left out? the state comes after it"]
 [((canonical? dropped (H-harmonic 'm 'k) (H-harmonic 'm 'k)) polar)
  "canonical?: dropped takes 2 coordinates to 1; a canonical transformation keeps their number"]
 [(canonical? 'C (H-harmonic 'm 'k) (H-harmonic 'm 'k))
  "canonical?: expected a transformation, a function of the state (up t q p); given the symbol C"]
 [(canonical-H? (F->CH p->r) 3)
  "canonical-H?: a Hamiltonian is a function of the state (up t q p); given the number 3"]
 [(verify-canonical (F->CH p->r) (up 't (up 'r 'r) (down 'a 'b)))
  "verify-canonical: the state must be made of symbols, each there once, to stand for any state\n"
  "  given: (up t (up r r) (down a b))\n  more than once: r"]
 [(verify-canonical (polar-canonical 'I) line)
  "verify-canonical: the symbol I is a parameter of (polar-canonical I), and stands in the "
  "state, too\n  state: (up t theta I)\n  give one of them another name"]
 [(verify-canonical (F->CH p->r) (H-harmonic 'm 'k) polar)
  "verify-canonical: takes a transformation and a state, or a transformation, the old and the "
  "new Hamiltonian and a state; it was given 3 arguments"]
 [(symplectic-matrix? (identity-matrix 3))
  "symplectic-matrix?: a symplectic matrix is square, with an even number of rows; given "
  "(matrix-by-rows (list 1 0 0) (list 0 1 0) (list 0 0 1)), a 3 by 3 matrix"]
 [(J-matrix 0)
  "J-matrix: expected a number of coordinates, at least 1\n  given: the number 0"]
 [(symplectic-unit 'n)
  "symplectic-unit: expected a number of coordinates, at least 1\n"
  "  given: the symbol n"]
 [((two-particle-center-of-mass 1 2) (up 't 'x 'p))
  "two-particle-center-of-mass: expected the state of two particles, (up t (up x1 x2) (down p1 p2))"
  "\n  given: the symbol x"])
