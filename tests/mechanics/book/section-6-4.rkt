#lang racket/base
;; SICM 6.4 and 7.2: Lie series, with the Lie derivative written as in the book.

(require mechanics
         (only-in mechanics/book H-central-polar)
         "../support/checks.rkt"
         "../support/close.rkt" "../support/messages.rkt" "../support/session.rkt")

(define (bracket F G)
  (- (* ((partial 1) F) ((partial 2) G)) (* ((partial 2) F) ((partial 1) G))))
(define ((procedure-of H) F) (bracket F H))
(define (Lie-of H) (make-operator (procedure-of H) (list 'Lie-derivative H)))
(define (Lie-transform-of H t) (exp (* t (Lie-of H))))

(define ((H-harmonic m k) (up t q p))
  (+ (/ (square p) (* 2 m)) (* 1/2 k (square q))))

(test-case "p. 448: the Lie series of x for the harmonic oscillator"
  (define terms
    (((Lie-transform-of (H-harmonic 'm 'k) 'dt) coordinate) (up 0 'x0 'p0)))
  (define seen '())
  (series:for-each (lambda (term) (set! seen (cons term seen))) terms 6)
  (for ([term (reverse seen)]
        [expected '(x0
                    (/ (* dt p0) m)
                    (/ (* -1/2 (expt dt 2) k x0) m)
                    (/ (* -1/6 (expt dt 3) k p0) (expt m 2))
                    (/ (* 1/24 (expt dt 4) (expt k 2) x0) (expt m 2))
                    (/ (* 1/120 (expt dt 5) (expt k 2) p0) (expt m 3)))])
    (check-prints term expected)))

(test-case "p. 448: its sum is the motion"
  (define s (((Lie-transform-of (H-harmonic 2.0 8.0) 0.1) coordinate) (up 0 1.0 3.0)))
  (check-= (series:sum s 8) (+ (cos 0.2) (* 3/4 (sin 0.2))) 1e-9))

(test-case "p. 449: a function of the state along the central motion, two orders"
  (define ((H-central m V) (up t (up r phi) (down p_r p_phi)))
    (+ (/ (+ (square p_r) (square (/ p_phi r))) (* 2 m)) (V r)))
  (define state (up 0 (up 'r_0 'phi_0) (down 'p_r_0 'p_phi_0)))
  (define s
    (((Lie-transform-of (H-central 'm (literal-function 'U)) 'dt) coordinate) state))
  (check-prints (series:ref s 0) '(up r_0 phi_0))
  (check-prints (series:ref s 1)
                '(up (/ (* dt p_r_0) m) (/ (* dt p_phi_0) (* m (expt r_0 2)))))
  (check-prints (ref s 2 1) '(/ (* -1 (expt dt 2) p_phi_0 p_r_0) (* (expt m 2) (expt r_0 3)))))

;; ---------------------------------------------------------------------------
;; The library's own

(define (F s) (+ (* (coordinate s) (momentum s)) (sin (coordinate s))))
(define line (up 't 'q 'p))

(test-case "p. 448: Lie derivatives are brackets, and their powers brackets of brackets"
  (define H (literal-function 'H (Hamiltonian 1)))
  (define G (literal-function 'G (Hamiltonian 1)))
  (define L (Lie-derivative H))
  (check-identity ((L G) line) ((Poisson-bracket G H) line))
  (check-identity (((expt L 2) G) line) ((Poisson-bracket (Poisson-bracket G H) H) line))
  (check-identity (((flow-derivative H) G) line)
                  (+ (((partial 0) G) line) ((Poisson-bracket G H) line)))
  (define (rate G) (+ ((partial 0) G) (Poisson-bracket G H)))
  (check-identity (((expt (flow-derivative H) 2) G) line) ((rate (rate G)) line)))

(test-case "p. 448, footnote: the function that the operator is made of"
  (check-identity (((Lie-derivative-procedure F) coordinate) line)
                  (((Lie-derivative F) coordinate) line))
  ;; as a function its product is one of values, as an operator it is a composition
  (define L (make-operator (Lie-derivative-procedure F) 'L))
  (check-identity (((* L L) coordinate) line) (((expt (Lie-derivative F) 2) coordinate) line))
  (check-equal? (format "~a" (Lie-derivative-procedure F)) "(Lie-derivative-procedure F)"))

(test-case "the series are those of the operator written as in the book"
  (for ([Q (list coordinate momentum F)])
    (define own (((Lie-transform (H-harmonic 'm 'k) 'dt) Q) (up 0 'x0 'p0)))
    (define written (((Lie-transform-of (H-harmonic 'm 'k) 'dt) Q) (up 0 'x0 'p0)))
    (for ([a (series:head own 5)] [b (series:head written 5)]) (check-identity a b))))

(test-case "p. 449: the central motion to the order of the book, by energy and angular momentum"
  (define H (H-central-polar 'm (literal-function 'U)))
  (define state (up 0 (up 'r_0 'phi_0) (down 'p_r_0 'p_phi_0)))
  (define energy (((Lie-transform H 'dt) H) state))
  (check-identity (series:ref energy 0) (H state))
  (for ([k '(1 2 3 4)]) (check-identity (series:ref energy k) 0))
  (define p_phi (((Lie-transform H 'dt) (compose (component 1) momentum)) state))
  (check-prints (series:ref p_phi 0) 'p_phi_0)
  (check-identity (series:ref p_phi 3) 0))

(test-case "many terms are the motion, of numbers too"
  (define (H s) (- (/ (square (momentum s)) 2) (* 9.8 (cos (coordinate s)))))
  (define start (up 0 1.0 0.5))
  (define end ((state-advancer Hamiltonian->state-derivative H) start 0.125 1e-15))
  (define C (Lie-transformation H 0.125 18))
  (check-close (C start) (list 0 (coordinate end) (momentum end)) 1e-12))

(test-case "with the explicit time"
  (define (H s) (* (time s) (momentum s)))
  (define s (((flow-transform H 'e) coordinate) line))
  (check-identity (series:sum s 3) (+ 'q (* 'e 't) (/ (square 'e) 2)))
  (check-identity (series:sum (((Lie-transform H 'e) coordinate) line) 3) (+ 'q (* 'e 't))))

(test-case "a transformation by a series is canonical up to the next order, and its inverse"
  (define (W s) (* (momentum s) (square (coordinate s))))
  (define C (Lie-transformation W 'e 3))
  (check-identity (coordinate (C line)) (+ 'q (* 'e (expt 'q 2)) (* (expt 'e 2) (expt 'q 3))
                                           (* (expt 'e 3) (expt 'q 4))))
  (define excess (matrix-ref ((symplectic-transform? C) line) 0 1))
  (for ([k 4]) (check-identity (coefficient excess 'e k) 0))
  (define round-trip (coordinate ((compose C (Lie-transformation W (- 'e) 3)) line)))
  (for ([k '(1 2 3)]) (check-identity (coefficient round-trip 'e k) 0)))

(test-case "what makes nothing of symbols"
  (define (H s) (if (< (coordinate s) 0) 0 (* (momentum s) (coordinate s))))
  (define s (((Lie-transform H 0.5) coordinate) (up 0 2.0 1.0)))
  (check-close (series:head s 4) (list 2.0 1.0 0.25 (/ 0.25 6)) 1e-12))

(test-case "states that are being differentiated"
  (define H (H-harmonic 'm 'k))
  (define (second-term s) (series:ref (((Lie-transform H 'dt) coordinate) s) 2))
  (check-identity (((partial 1) second-term) line) (/ (* -1/2 (square 'dt) 'k) 'm)))

(test-case "operators print as what makes them"
  (check-equal? (format "~a" (Lie-derivative F)) "(Lie-derivative F)")
  (check-equal? (format "~a" (Lie-transform F 'dt)) "(Lie-transform F dt)")
  (check-equal? (format "~a" ((expt (Lie-derivative F) 2) coordinate))
                "((expt (Lie-derivative F) 2) coordinate)"))

(says
 [(Lie-derivative 3)
  "Lie-derivative: a Hamiltonian is a function of the state (up t q p); given the number 3"]
 [(Lie-transform F sin)
  "Lie-transform: the parameter of a Lie series is a number or a symbol; given the procedure `sin`"]
 [(Lie-derivative-procedure 3)
  "Lie-derivative-procedure: a Hamiltonian is a function of the state (up t q p); given the number 3"]
 [((Lie-derivative-procedure F) 3)
  "Lie-derivative-procedure: a quantity is a function of the state (up t q p); given the number 3"]
 [((Lie-derivative F) 3)
  "Lie-derivative: a quantity is a function of the state (up t q p); given the number 3"]
 [(((Lie-derivative F) coordinate) 3)
  "Lie-derivative: expected a Hamiltonian state (up t q p)\n  given: the number 3"]
 [(Lie-transformation F 'e 'n)
  "Lie-transformation: expected the order of the last term\n  given: the symbol n"])

;; ---------------------------------------------------------------------------
;; 7.2: the pendulum as a perturbed rotor

(define ((H0 alpha) (up t theta p)) (/ (square p) (* 2 alpha)))
(define ((H1 beta) (up t theta p)) (* -1 beta (cos theta)))
(define (H-series alpha beta epsilon) (series (H0 alpha) (* epsilon (H1 beta))))
(define ((W alpha beta) (up t theta p)) (/ (* -1 alpha beta (sin theta)) p))

(define a-state (up 't 'theta 'p))
(define H (H-series 'alpha 'beta 'epsilon))
(define L (Lie-of (W 'alpha 'beta)))

(test-case "p. 462: the generator removes the first order"
  (check-prints ((+ (L (H0 'alpha)) (H1 'beta)) a-state) 0))

(test-case "p. 463: the Hamiltonian transformed, to the second order"
  (define transformed (((exp (* 'epsilon L)) H) a-state))
  (check-prints (series:ref transformed 1) 0)
  (check-prints (series:sum transformed 2)
                '(+ (/ (* 1/2 (expt p 2)) alpha)
                    (/ (* 1/2 alpha (expt beta 2) (expt epsilon 2) (expt (sin theta) 2))
                       (expt p 2)))))

(test-case "p. 463: a transform and its inverse undo each other, order by order"
  (define there (exp (* 'epsilon L)))
  (define back (exp (* -1 'epsilon L)))
  (define s (((* there back) coordinate) a-state))
  (check-prints (list->up (series:head s 4)) '(up theta 0 0 0)))
