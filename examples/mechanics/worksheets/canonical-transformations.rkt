#lang mechanics/worksheet
;; SICM 5.1 to 5.3: canonical transformations.

(title "Canonical transformations")

(text "A mass m on a spring of stiffness k.")

(given
 (define (H (up t q p)) (+ (/ (square p) (* 2 'm)) (* 1/2 'k (square q)))))

(exercise exchange canonical
  "A canonical map that exchanges coordinate and momentum, but for signs."
  (coordinates q) (key (lambda ((up t q p)) (up t p (- q)))) (points 1)
  (slip (lambda ((up t q p)) (up t p q)) "One of them needs the other sign."))

(exercise scaling canonical
  "A canonical map that makes the Hamiltonian half `(sqrt (/ k m))` times the sum of the squares."
  (coordinates q) (of-Hamiltonian H)
  (assuming '(> k 0) '(> m 0))
  (becomes (lambda ((up t q p)) (* 1/2 (sqrt (/ 'k 'm)) (+ (square p) (square q)))))
  (key (lambda ((up t q p))
         (define c (expt (* 'k 'm) 1/4))
         (up t (/ q c) (* c p))))
  (points 3)
  (hint "Stretch the coordinate; what must happen to the momentum?"))

(exercise generated expression
  "The momentum p in terms of q and Q, if the generating function is F1 = `(* q Q)`."
  (arguments q Q)
  (key (lambda (q Q) Q))
  (points 1))
