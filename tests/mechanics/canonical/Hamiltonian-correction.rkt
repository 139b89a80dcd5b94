#lang racket/base
;; The K that a canonical transformation with the time in it adds to a Hamiltonian, found from the
;; transformation alone; against F->K, generating functions and motions.

(require mechanics
         mechanics/book
         "../support/checks.rkt" "../support/notes.rkt" "../support/session.rkt")

(define line (up 't 'q 'p))
(define plane (up 't (up 'x 'y) (down 'p_x 'p_y)))

(test-case "of point transformations it is F->K"
  (for ([F (list (rotating->inertial 'Omega)
                 (lambda (s) (+ (coordinate s) (* (time s) (up 'u 'v))))
                 (lambda (s) (* (exp (* 'r (time s))) (coordinate s))))])
    (check-identity ((C->K (F->CH F) plane) plane) ((F->K F) plane))))

(test-case "of generated ones it is the derivative of F by the time, but for a function of it"
  (define (F2 t q P) (+ (* q P) (* (sin t) (square q)) (* t P)))
  (define difference (- (C->K (F2->C F2) line) (F2->K F2)))
  (check-identity (((partial 1) difference) line) 0)
  (check-identity (((partial 2) difference) line) 0))

;; An oscillator's motion, seen as a transformation from the states at the time 0, leaves nothing
;; to move: H∘C + K = 0.
(test-case "of a motion it is minus the Hamiltonian"
  (define (motion s)
    (define-values (c s1) (values (cos (* 'omega (time s))) (sin (* 'omega (time s)))))
    (define-values (q p) (values (coordinate s) (momentum s)))
    (up (time s)
        (+ (* q c) (/ (* p s1) (* 'm 'omega)))
        (- (* p c) (* 'm 'omega q s1))))
  (define H (H-harmonic 'm (* 'm (square 'omega))))
  (define K (C->K motion line))
  (check-identity ((+ (compose H motion) K) line) 0)
  (check-pred proved? (verify-canonical motion H (+ (compose H motion) K) line)))

(test-case "without the time there is nothing to add"
  (check-identity ((C->K (polar-canonical 'alpha) (up 't 'theta 'I)) (up 't 'theta 'I)) 0)
  (check-equal? (format "~a" (C->K (shift-t 0) line)) "(C->K (shift-t 0))"))

(test-case "a sign that it takes for granted is told"
  (define ((pushed speed) s)
    (up (time s) (+ (coordinate s) (* (time s) (speed (momentum s)))) (momentum s)))
  (define C (pushed (lambda (p) (sqrt (square p)))))
  (check-equal? (told (C->K C line)) "; C->K: this K is that of states with (>= p 0)\n")
  (check-equal? (told (C->K (pushed (lambda (p) (sqrt (square (- p 1))))) line))
                "; C->K: this K is that of states with (>= (- p 1) 0)\n")
  (check-equal? (told (assuming ('(< p 0)) (C->K C line))
                      (C->K (pushed square) line))
                "")
  (check-identity (assuming ('(< p 0)) ((C->K C line) line)) (* 1/2 (square 'p))))
