#lang racket/base
;; The fate of small displacements: matrices, multipliers, exponents.

(require mechanics
         mechanics/book
         "../support/checks.rkt" "../support/close.rkt" "../support/messages.rkt")

(define omega (* 4.2 (sqrt 9.8)))
(define shaken (H-pend-sysder 1 1 9.8 .05 omega))
(define period (/ :2pi omega))

(test-case "the linearized flow of Hénon and Heiles is the derivative of where it leads"
  (define state (section->state 1/8 0.1 0))
  (define J ((linearized-flow HHsysder) state 2 1e-12))
  (define (scalars x) (if (structure? x) (apply append (map scalars (structure->list x))) (list x)))
  (check-close (scalars ((D (lambda (s) ((state-advancer HHsysder) s 2 1e-12))) state)) (scalars J)
               1e-10)
  (define columns (list (ref J 1 0) (ref J 1 1) (ref J 2 0) (ref J 2 1)))
  (define rows (for/list ([i 4]) (for/list ([c columns]) (list-ref (cdr (scalars c)) i))))
  (check-close (determinant (apply matrix-by-rows rows)) 1 1e-10))

(test-case "Floquet multipliers of the pendulum upside down: their sum is the published trace"
  (define all (Floquet-multipliers shaken (up 0 :pi 0) period))
  (check-close (apply + all) 4.63081658352 1e-10)
  (check-close (apply * all) 1 1e-10))

(test-case "Mathieu's oscillator, stable and not"
  (define ((Mathieu a q) s)
    (define-values (t x v) (values (time s) (coordinate s) (momentum s)))
    (up 1 v (* -1 (- a (* 2 q (cos (* 2 t)))) x)))
  (define (sizes a q) (map magnitude (Floquet-multipliers (Mathieu a q) (up 0 0 0) :pi)))
  (check-close (sizes 2 0.5) '(1 1) 1e-10)
  (check-true (> (car (sizes 1 0.5)) 1.1)))

(test-case "a cat's exponent is the logarithm of its multiplier"
  (define turn (principal-value :2pi))
  (define (cat x y return fail) (return (turn (+ (* 2 x) y)) (turn (+ x y))))
  (define e (maximal-Lyapunov-exponent cat (up 1 2) 20000))
  (check-close (car (Lyapunov-values e)) (log (/ (+ 3 (sqrt 5)) 2)) 1e-4)
  (check-true (< (Lyapunov-change e) 1e-3)))

;; The displacement (0.6, 0.8) becomes (0.6 · 2^n, 0.8 / 2^n).
(test-case "of a saddle it is known after any number of steps"
  (define (saddle x y return fail) (return (* 2 x) (/ y 2)))
  (define e (maximal-Lyapunov-exponent saddle (up 0 0) 10))
  (check-close (Lyapunov-values e)
               (list (/ (log (sqrt (+ (square (* 0.6 1024)) (square (/ 0.8 1024))))) 10))
               1e-12))

;; Chirikov: about log K/2 where kicks are strong.
(test-case "the standard map, chaotic and not"
  (define (exponent K x y)
    (car (Lyapunov-values (maximal-Lyapunov-exponent (standard-map K) (up x y) 50000))))
  (check-close (exponent 10 0.1 0.1) (log 5) 0.05)
  (check-true (< (exponent 0.6 0.1 2) 1e-3)))

(test-case "exponents of a Hamiltonian motion come in pairs, those of a linear one are exact"
  (define all (Lyapunov-values (Lyapunov-exponents (HHsysder) (section->state 1/8 0.1 0) 100)))
  (check-equal? (length all) 4)
  (check-close (for/list ([a all] [b (reverse all)]) (+ a b)) '(0 0 0 0) 1e-3)
  (define (linear s) (up 1 (up (* 0.5 (ref s 1 0)) (* -2 (ref s 1 1)))))
  (check-close (Lyapunov-values (Lyapunov-exponents linear (up 0 (up 1 1)) 50)) '(0.5 -2) 1e-6))

(test-case "only the first of them; the greater one is there in any case"
  (define (linear s) (up 1 (up (* -2 (ref s 1 0)) (* 0.5 (ref s 1 1)))))
  (define e (maximal-Lyapunov-exponent linear (up 0 (up 1 1)) 50))
  (check-close (Lyapunov-values e) '(0.5) 0.05)
  (check-equal? (length (Lyapunov-history e)) 1000)
  (check-equal? (car (list-ref (Lyapunov-history e) 999)) 50.0)
  (check-true (Lyapunov? e))
  (check-regexp-match #rx"^Lyapunov exponent 0[.]4.* after 50[.]0\n  changed by" (format "~a" e)))

;; A displacement that begins with length 1 and is c exp(λt) later has the exponent λ + log c/t.
(test-case "a growing coordinate is met wherever it stands; its change halves with the time"
  (for ([rates '((0.5 -2 -3) (-3 0.5 -2) (-2 -3 0.5))])
    (define (linear s) (up 1 (apply up (map * rates (structure->list (ref s 1))))))
    (define e (maximal-Lyapunov-exponent linear (up 0 (up 1 1 1)) 50))
    (check-close (Lyapunov-values e) '(0.5) 0.05)
    (check-close (Lyapunov-change e) (abs (- (car (Lyapunov-values e)) 0.5)) 1e-3)))

(define (hole x y return fail) (if (< x 3) (return (+ x 1) y) (fail)))

(says
 [(Floquet-multipliers shaken (up 0 :pi 0) (up 1 2))
  "Floquet-multipliers: expected a period that is a real number\n  given: (up 1 2), an up tuple of 2"]
 [(Lyapunov-exponents (HHsysder) (section->state 1/8 0.1 0) -1)
  "Lyapunov-exponents: expected a positive duration\n  given: the number -1"]
 [(Lyapunov-exponents (HHsysder) (section->state 1/8 0.1 0) 10 #:count 7)
  "Lyapunov-exponents: expected how many exponents, at most 4\n  given: the number 7"]
 [(maximal-Lyapunov-exponent (standard-map 1) (up 0 0) 1.5)
  "maximal-Lyapunov-exponent: expected "
  "how many steps of the map, a positive integer\n  given: the number 1.5"])

(test-case "an orbit that is not closed has no multipliers"
  (check-exn (regexp (string-append "Floquet-multipliers: the orbit is not closed after "
                                    "that period; its ends are 3.3059"))
             (lambda () (Floquet-multipliers shaken (up 0 1 0) period))))

;; Of x' = v an orbit of period 1 is open by v; of x' = 1 + x² it ends at π/2.
(test-case "an orbit is closed within a millionth, and one that ends is none"
  (define ((drift v) s) (up 1 v))
  (check-close (Floquet-multipliers (drift 0.6e-6) (up 0 0) 1) '(1) 1e-9)
  (check-exn #rx"not closed after that period; its ends are 1[.]5"
             (lambda () (Floquet-multipliers (drift 1.5e-6) (up 0 0) 1)))
  (check-exn #rx"^Floquet-multipliers: the motion cannot be followed any further"
             (lambda ()
               (Floquet-multipliers (lambda (s) (up 1 (+ 1 (square (ref s 1))))) (up 0 0) 2))))

(test-case "an orbit that ends has no exponent"
  (check-exn #rx"maximal-Lyapunov-exponent: the map has no image of a point that is needed"
             (lambda () (maximal-Lyapunov-exponent hole (up 0.5 0) 1000))))

;; A momentum that has grown by 2π is not the same again; an angle is.
(test-case "whole turns close an orbit in angles only"
  (define (drifting s) (up 1 (- (momentum s) :pi) :2pi))
  (check-exn #rx"the orbit is not closed after that period; its ends are 6.283"
             (lambda () (Floquet-multipliers drifting (up 0 0 0) 1)))
  (define around
    (fixed-point-coordinates
     (find-fixed-point (driven-pendulum-map 1 1 9.8 .05 omega) (up 3.1 13))))
  (define all (Floquet-multipliers shaken (up 0 (abscissa around) (ordinate around)) period))
  (check-close (map magnitude all) '(1 1) 1e-9)
  (define (turning-back s) (up 1 (velocity s) 0))
  (check-close (Floquet-multipliers turning-back (up 0 1 -2) :pi) '(1 1) 1e-7))
