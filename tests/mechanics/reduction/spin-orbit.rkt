#lang racket/base
;; Spin and orbit, reduced: the resonances of a moon's rotation, by the angle that turns slowly.
;;
;; On an orbit of small eccentricity e the torque has the waves 2θ − k φ, φ = n t; to the first
;; order in e with the strengths 1, 7e/2 and −e/2 for k = 2, 3 and 1 (Murray and Dermott 1999, 5.4).

(require mechanics
         "../support/checks.rkt" "../support/close.rkt" "../support/session.rkt")

(define line (up 't 'theta 'p))
(define two (up 't (up 'phi 'theta) (down 'P 'p)))

;; The Hamiltonian with the orbit to the first order in e: R = a (1 − e cos φ), f = φ + 2 e sin φ
(define ((H-spin-orbit C n epsilon e) s)
  (define phi (* n (time s)))
  (define-values (a/R f) (values (+ 1 (* e (cos phi))) (+ phi (* 2 e (sin phi)))))
  ((Lagrangian->Hamiltonian (L-spin-orbit C n epsilon (lambda (t) a/R) (lambda (t) f))) s))

;; Terms of the order 0 and 1 in e, as functions of the state
(define (of-order k)
  (define e (simplify (coefficient (expand-in-e) 'e k)))
  (lambda (s)
    (substitute e 'phi (ref s 1 0) 'theta (ref s 1 1) 'P (ref s 2 0) 'p (ref s 2 1))))
(define (expand-in-e)
  (define (H e) ((periodic-extension (H-spin-orbit 'C 'n 'epsilon e) 'n) two))
  (+ (H 0) (* 'e ((D H) 0))))

(define rotor (lambda (s) (+ (/ (square (ref s 2 1)) (* 2 'C)) (* 'n (ref s 2 0)))))
(define torque (lambda (s) (- (+ ((of-order 0) s) (* 'e ((of-order 1) s))) (rotor s))))

(test-case "the waves of the first order in e, by their integers"
  (define P (perturbation-series rotor torque two #:parameter 'delta
                                 #:keep '((-2 2) (-3 2) (-1 2))))
  (define strength (* -1/4 'C (square (* 'n 'epsilon))))
  (define waves
    (for/list ([r (perturbation-resonances P)]) (cons (cadr r) (caddr r))))
  (define (wave k)
    (cdr (or (assoc (list (- k) 2) waves) (assoc (list k -2) waves))))
  (check-identity (wave 2) (* strength (cos (- (* 2 'theta) (* 2 'phi)))))
  (check-identity (wave 3) (* strength 7/2 'e (cos (- (* 2 'theta) (* 3 'phi)))))
  (check-identity (wave 1) (* strength -1/2 'e (cos (- (* 2 'theta) 'phi)))))

;; Half the width in θ̇ of the resonance 3:2 is ε n √(7e/2), in the synchronous one ε n.
(test-case "how far they reach"
  (define (width k)
    (define w (ref (resonance-width rotor torque (list (- k) 2) two) 1))
    (expression (simplify (substitute w 'C 2.0 'n 3.0 'epsilon 0.1 'e 0.04))))
  (check-close (width 3) (* 2 0.1 3 (sqrt (* 7/2 0.04))) 1e-12)
  (check-close (width 2) (* 2 0.1 3) 1e-12)
  (check-identity (resonance-center rotor '(-3 2) two 1) (* 3/2 'C 'n)))

;; The slow angle ψ = θ − 3nt/2 for coordinate: what is left with the time averages to 0.
(test-case "the reduction to a pendulum by a coordinate that turns with the resonance"
  (define (slow s) (+ (coordinate s) (* 3/2 'n (time s))))
  (define C (F->CH slow))
  (define H (H-spin-orbit 'C 'n 'epsilon 'e))
  (define new-H (+ (compose H C) (C->K C line)))
  (check-identity ((C->K C line) line) (* -3/2 'n 'p))
  ;; averaged over two turns of the orbit: (p − 3nC/2)²/2C, and a pendulum in 2ψ
  (define (numbers t psi)
    (substitute (simplify (new-H line)) 't t 'theta psi 'p 2.0 'C 2.0 'n 1.0 'epsilon 0.3 'e 0.01))
  (define (average psi)
    (/ (for/sum ([k 64]) (expression (simplify (numbers (* 4 pi (/ k 64)) psi)))) 64))
  (check-close (- (average 0.0) (average 0.7))
               (* -1/4 2.0 (square 0.3) 7/2 0.01 (- 1 (cos 1.4)))
               1e-5))

;; Independent: on an orbit with its eccentricity not expanded, what starts within the width
;; stays with the resonance, what starts beyond leaves it.
(test-case "the width, in the motion"
  (define-values (epsilon e) (values 0.1 0.04))
  (define width (* epsilon (sqrt (* 7/2 e))))
  (define (drift excess)
    (define end
      ((state-advancer spin-orbit-sysder 1.0 epsilon e)
       (up 0.0 0.0 (+ 1.5 (* excess width)) 0.0) 400.0 1e-9))
    (abs (- (ref end 1) (* 1.5 400.0))))
  (check-true (< (drift 0.7) 2))
  (check-true (< (drift -0.7) 2))
  (check-true (> (drift 1.5) 6)))
