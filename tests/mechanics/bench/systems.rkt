#lang racket/base
;; The mechanical systems of the benchmarks, as a user would write them.

(require mechanics)

(provide chain-Lagrangian chain-path chain-state
         rigid-body-Lagrangian Euler-path Euler-state
         Foucault-Lagrangian Foucault-path Foucault-state
         three-body-Lagrangian plane-path)

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

(define (chain-path n)
  (apply up (map literal-function (numbered-list 'theta n))))

(define (chain-state n)
  (up 't
      (apply up (numbered-list 'theta n))
      (apply up (numbered-list 'thetadot n))))

;; ---------------------------------------------------------------------------
;; A free rigid body with principal moments A, B, C, in Euler angles (SICM 2.8).

(define ((rigid-body-Lagrangian A B C) (up t (up theta phi psi) (up thetadot phidot psidot)))
  (define omega-a (+ (* phidot (sin theta) (sin psi)) (* thetadot (cos psi))))
  (define omega-b (- (* phidot (sin theta) (cos psi)) (* thetadot (sin psi))))
  (define omega-c (+ (* phidot (cos theta)) psidot))
  (* 1/2 (+ (* A (square omega-a)) (* B (square omega-b)) (* C (square omega-c)))))

(define (Euler-path)
  (up (literal-function 'theta) (literal-function 'phi) (literal-function 'psi)))

(define (Euler-state)
  (up 't (up 'theta 'phi 'psi) (up 'thetadot 'phidot 'psidot)))

;; ---------------------------------------------------------------------------
;; Foucault's pendulum: mass m on a rod l at colatitude phi of a sphere of radius
;; R turning at Omega; theta from the local vertical, lambda about it.

(define ((pendulum->space l R phi Omega) (up t (up theta lambda) v))
  (let* ([x (* l (sin theta) (cos lambda))]
         [y (* l (sin theta) (sin lambda))]
         [z (- R (* l (cos theta)))]
         [X (+ (* x (cos phi)) (* z (sin phi)))]
         [Z (- (* z (cos phi)) (* x (sin phi)))])
    (up (- (* X (cos (* Omega t))) (* y (sin (* Omega t))))
        (+ (* X (sin (* Omega t))) (* y (cos (* Omega t))))
        Z)))

(define (Foucault-Lagrangian)
  (define L-free (lambda (local) (* 1/2 'm (square (velocity local)))))
  (define weight (lambda (local) (* 'm 'g 'l (cos (ref (coordinate local) 0)))))
  (+ (compose L-free (F->C (pendulum->space 'l 'R 'phi 'Omega)))
     weight))

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
