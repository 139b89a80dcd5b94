#lang mechanics/worksheet
;; SICM 6.2 to 6.5: time evolution as a canonical map, Lie series, products of exponentials.

(title "Lie transforms")

(text "The Lie derivative of F by the generator W is their Poisson bracket {F, W}. The Lie "
      "transform of F is the exponential series F + `epsilon` {F, W} + ...; it is F where W, "
      "taken for a Hamiltonian, moves the state in the time `epsilon`. There is one coordinate q.")

(define (T (up t q p)) (/ (square p) (* 2 'm)))
(define (V (up t q p)) (* 1/2 'k (square q)))
(define (circle (up t q p)) (* 1/2 (+ (square q) (square p))))

(exercise turning Hamiltonian
  "The generator of a rotation: q becomes `(+ (* q (cos epsilon)) (* p (sin epsilon)))`."
  (coordinates q) (key circle) (points 2)
  (slip (- circle) "It turns the other way: look at the sign of {q, W}."))

(exercise stretching expression "What W = `(* q p)` makes of the state: (up q p)."
  (arguments q p)
  (key (lambda (q p) (up (* q (exp 'epsilon)) (* p (exp (- 'epsilon)))))) (points 2)
  (slip (lambda (q p) (up (* q (+ 1 'epsilon)) (* p (- 1 'epsilon))))
        "That is the series to first order; sum all of it." #:credit 1/2))

(exercise second-order expression
  "The coordinate after the time `epsilon`, to second order, for
   H = `(+ (/ (square p) (* 2 m)) (* 1/2 k (square q)))`."
  (arguments q p)
  (key (lambda (q p)
         (series:sum (((Lie-transform (+ T V) 'epsilon) coordinate) (up 't q p)) 2)))
  (points 2)
  (slip (lambda (q p) (- (+ q (/ (* 'epsilon p) 'm)) (/ (* (square 'epsilon) 'k q) 'm)))
        "The second term of an exponential series is divided by 2." #:credit 1/2))

(exercise evolution canonical
  "With m = k = 1: the canonical map that takes each state to the one after the time `tau`."
  (coordinates q)
  (of-Hamiltonian circle) (becomes circle)
  (key (lambda ((up t q p))
         (up t
             (+ (* q (cos 'tau)) (* p (sin 'tau)))
             (- (* p (cos 'tau)) (* q (sin 'tau))))))
  (points 2))

(text "Let A = `(* 1/2 (square q))` and B = `(* 1/2 (square p))`.")

(define (A (up t q p)) (* 1/2 (square q)))
(define (B (up t q p)) (* 1/2 (square p)))

(exercise commuted Hamiltonian
  "The generator whose Lie derivative is the commutator of the Lie derivatives by A and B."
  (coordinates q)
  (key (Poisson-bracket B A))
  (points 2)
  (hint "Apply both products to q; or use Jacobi's identity."))

(exercise correction Hamiltonian
  "The product of the Lie transforms with A and B is that with
   W = A + B + ...: the term of first order in `epsilon`."
  (coordinates q)
  (key (* 1/2 'epsilon (Poisson-bracket B A)))
  (points 2)
  (hint "It is half of a commutator."))

(exercise why reason "Why does a series that is cut off give a map that is not quite canonical?")
