#lang racket/base
;; The mechanical systems of the benchmarks, as a user would write them.

(require mechanics)

(provide chain-Lagrangian chain-Lagrangian/decimal chain-Lagrangian/equal chain-path chain-state
         chain-momentum-state
         rigid-body-Lagrangian Euler-path Euler-state Euler-momentum-state
         Foucault-Lagrangian Foucault-path Foucault-state
         Foucault-Lagrangian/rectangular Foucault-state/rectangular
         three-body-Lagrangian plane-path
         Jacobi-identity)

(define (numbered name i) (string->symbol (format "~a~a" name i)))
(define (numbered-list name n)
  (for/list ([i (in-range 1 (+ n 1))]) (numbered name i)))

;; ---------------------------------------------------------------------------
;; A chain of n pendulums, each hanging from the one before: masses m1 ...,
;; lengths l1 ..., angles from the vertical.

(define ((L-particles masses g) local)
  (define q (coordinate local))
  (define v (velocity local))
  (apply + (for/list ([m (in-list masses)] [i (in-naturals)])
             (- (* 1/2 m (square (ref v i)))
                (* m g (ref q i 1))))))

(define ((angles->positions lengths) local)
  (define theta (coordinate local))
  (let loop ([ls lengths] [i 0] [x 0] [y 0] [positions '()])
    (if (null? ls)
        (apply up (reverse positions))
        (let ([x (+ x (* (car ls) (sin (ref theta i))))]
              [y (- y (* (car ls) (cos (ref theta i))))])
          (loop (cdr ls) (+ i 1) x y (cons (up x y) positions))))))

(define (chain-Lagrangian n)
  (compose (L-particles (numbered-list 'm n) 'g)
           (F->C (angles->positions (numbered-list 'l n)))))

;; The same with decimal numbers for masses, lengths and g.
(define (chain-Lagrangian/decimal n)
  (define (decimals start) (for/list ([i (in-range n)]) (+ start (* 0.37 i))))
  (compose (L-particles (decimals 1.2) 9.8)
           (F->C (angles->positions (decimals 0.7)))))

;; Masses and lengths 1, g = 9.8.
(define (chain-Lagrangian/equal n)
  (define ones (for/list ([_ (in-range n)]) 1.0))
  (compose (L-particles ones 9.8) (F->C (angles->positions ones))))

(define (chain-path n)
  (apply up (map literal-function (numbered-list 'theta n))))

(define (chain-state n)
  (up 't
      (apply up (numbered-list 'theta n))
      (apply up (numbered-list 'thetadot n))))

(define (chain-momentum-state n)
  (up 't
      (apply up (numbered-list 'theta n))
      (apply down (numbered-list 'p n))))

;; ---------------------------------------------------------------------------
;; A free rigid body with principal moments A, B, C, in Euler angles (SICM 2.8).

(define ((rigid-body-Lagrangian A B C) (up t (up theta phi psi) (up thetadot phidot psidot)))
  (define omega-a (+ (* phidot (sin theta) (sin psi)) (* thetadot (cos psi))))
  (define omega-b (- (* phidot (sin theta) (cos psi)) (* thetadot (sin psi))))
  (define omega-c (+ (* phidot (cos theta)) psidot))
  (* 1/2 (+ (* A (square omega-a)) (* B (square omega-b)) (* C (square omega-c)))))

(define (Euler-path)
  (up (literal-function 'theta) (literal-function 'phi) (literal-function 'psi)))

(define (Euler-momentum-state)
  (up 't (up 'theta 'phi 'psi) (down 'p_theta 'p_phi 'p_psi)))

(define (Euler-state)
  (up 't (up 'theta 'phi 'psi) (up 'thetadot 'phidot 'psidot)))

;; ---------------------------------------------------------------------------
;; Foucault's pendulum: mass m on a rod l at colatitude phi of a sphere of radius
;; R turning at Omega; theta from the local vertical, lambda about it.

(define ((pendulum->space l R phi Omega) (up t (up theta lambda) v))
  (in-space (* l (sin theta) (cos lambda))
            (* l (sin theta) (sin lambda))
            (- R (* l (cos theta)))
            phi (* Omega t)))

;; From local axes, the last one vertical, to axes that do not turn.
(define (in-space x y z phi angle)
  (let ([X (+ (* x (cos phi)) (* z (sin phi)))]
        [Z (- (* z (cos phi)) (* x (sin phi)))])
    (up (- (* X (cos angle)) (* y (sin angle)))
        (+ (* X (sin angle)) (* y (cos angle)))
        Z)))

(define (Foucault-Lagrangian)
  (define L-free (lambda (local) (* 1/2 'm (square (velocity local)))))
  (define weight (lambda (local) (* 'm 'g 'l (cos (ref (coordinate local) 0)))))
  (+ (compose L-free (F->C (pendulum->space 'l 'R 'phi 'Omega)))
     weight))

;; The same in the rectangular coordinates x and y of the bob, below which the
;; rod reaches down by a root.
(define ((below l) x y) (sqrt (- (square l) (square x) (square y))))

(define ((pendulum->space/rectangular l R phi Omega) (up t (up x y) v))
  (in-space x y (- R ((below l) x y)) phi (* Omega t)))

(define (Foucault-Lagrangian/rectangular)
  (define L-free (lambda (local) (* 1/2 'm (square (velocity local)))))
  (define weight
    (lambda (local)
      (define q (coordinate local))
      (* 'm 'g ((below 'l) (ref q 0) (ref q 1)))))
  (+ (compose L-free (F->C (pendulum->space/rectangular 'l 'R 'phi 'Omega)))
     weight))

(define (Foucault-state/rectangular) (up 't (up 'x 'y) (up 'xdot 'ydot)))

(define (Foucault-path) (up (literal-function 'theta) (literal-function 'lambda)))
(define (Foucault-state) (up 't (up 'theta 'lambda) (up 'thetadot 'lambdadot)))

;; ---------------------------------------------------------------------------
;; The restricted three-body problem in rotating axes (SICM 1.8.4).

(define (three-body-Lagrangian)
  (define GM (+ 'GM0 'GM1))
  (define a0 (* 'a (/ 'GM1 GM)))
  (define a1 (* 'a (/ 'GM0 GM)))
  (lambda (local)
    (define-values (x y) (apply values (structure->list (coordinate local))))
    (define-values (vx vy) (apply values (structure->list (velocity local))))
    (define r0 (sqrt (+ (square (+ x a0)) (square y))))
    (define r1 (sqrt (+ (square (- x a1)) (square y))))
    (+ (* 1/2 'm (+ (square vx) (square vy)))
       (* 1/2 'm (square 'Omega) (+ (square x) (square y)))
       (* 'm 'Omega (- (* x vy) (* vx y)))
       (/ (* 'GM0 'm) r0)
       (/ (* 'GM1 'm) r1))))

(define (plane-path) (up (literal-function 'x) (literal-function 'y)))

;; ---------------------------------------------------------------------------
;; Jacobi's identity for the Poisson brackets of three literal functions of n
;; coordinates and momenta (SICM 3.2), at a symbolic state.

(define (Jacobi-identity n)
  (define reals (for/list ([_ (in-range n)]) 'Real))
  (define signature `(-> (UP Real (UP ,@reals) (DOWN ,@reals)) Real))
  (define-values (F G H)
    (apply values (for/list ([name '(F G H)]) (literal-function name signature))))
  ((+ (Poisson-bracket F (Poisson-bracket G H))
      (Poisson-bracket G (Poisson-bracket H F))
      (Poisson-bracket H (Poisson-bracket F G)))
   (up 't (apply up (numbered-list 'q n)) (apply down (numbered-list 'p n)))))
