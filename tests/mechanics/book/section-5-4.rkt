#lang racket/base
;; SICM 5.4, Generating Functions (pp. 364-394).

(require mechanics
         mechanics/book
         "../support/checks.rkt" "../support/session.rkt")

(define line (up 't 'q 'p))
(define polar (up 't (up 'r 'theta) (down 'p_r 'p_theta)))

(test-case "p. 366: the polar-canonical transformation and its F1"
  (check-identity ((F1->C (F1-polar-canonical 'alpha)) (up 't 'theta 'I))
                  ((polar-canonical 'alpha) (up 't 'theta 'I))))

(test-case "the two simplest: places changed, and nothing"
  (check-prints ((F1->C F1-flip) line) '(up t (* -1 p) q))
  (check-prints ((F2->C F2-identity) line) '(up t q p)))

(test-case "pp. 372-373: F2 is the Legendre transform of F1, by the product of the new variables"
  (define (F1 t q q-prime) (* 1/2 'a (square (- q q-prime))))
  (define F2 (generating-function (F1->C F1) line #:type 2))
  (define q-prime (coordinate ((F1->C-inv F1) (up 't 'q 'P))))       ; by q and p = p' here
  (check-identity (- (F2 't 'q 'P) (F1 't 'q q-prime)) (* 'P q-prime)))

(test-case "pp. 376-377: polar coordinates by F2, with the rectangular momenta"
  (define (F2 t polar p-xy) (* p-xy (p->r (up t polar p-xy))))
  (define rectangular ((F2->C-inv F2) polar))
  (check-identity rectangular ((F->CH p->r) polar))
  (define-values (q p) (values (coordinate rectangular) (momentum rectangular)))
  (check-identity (/ (* p q) 'r) 'p_r)
  (check-identity (- (* (ref p 1) (ref q 0)) (* (ref p 0) (ref q 1))) 'p_theta))

(test-case "p. 377: rotating coordinates by F2 (5.176), and what the Hamiltonian gets (5.178)"
  (define (F2 t q p-prime)
    (* p-prime (- q (up 0 (* 'Omega t)))))
  (check-identity ((F2->C F2) polar) ((F->CH (rotating-polar 'Omega)) polar))
  (check-identity ((F2->K F2) polar) (* -1 'Omega 'p_theta))
  (check-identity ((F->K (rotating-polar 'Omega)) polar) (* -1 'Omega 'p_theta))
  (check-identity ((C->K (F->CH (rotating-polar 'Omega)) polar) polar) (* -1 'Omega 'p_theta)))

(test-case "pp. 379-381: two bodies by F2, with any weights; the centre of mass needs none"
  (define two (up 't (up 'x 'X) (down 'p 'P)))
  (define-values (m a b) (values (/ 1 (+ (/ 1 'm_1) (/ 1 'm_2))) 'a 'b))
  (define (F2 t q p-prime)
    (define-values (x1 x2) (values (ref q 0) (ref q 1)))
    (+ (* (ref p-prime 0) (- x2 x1)) (* (ref p-prime 1) (+ (* a x1) (* b x2)))))
  (define (T s)
    (+ (/ (square (ref (momentum s) 0)) (* 2 'm_1)) (/ (square (ref (momentum s) 1)) (* 2 'm_2))))
  (check-identity ((compose T (F2->C F2)) two)
                  (+ (/ (square 'p) (* 2 m))
                     (* 1/2 (square 'P) (+ (/ (square a) 'm_1) (/ (square b) 'm_2)))
                     (* 'p 'P (- (/ b 'm_2) (/ a 'm_1))))))

(test-case "pp. 390-392: a total time derivative changes the momenta, by F2 = q p' − G"
  (define G (literal-function 'G (-> (X Real Real) Real)))
  (define (F2 t q p-prime) (- (* q p-prime) (G t q)))
  (define V (literal-function 'V))
  (define (H s) (+ (/ (square (momentum s)) (* 2 'm)) (V (coordinate s))))
  (check-identity ((+ (compose H (F2->C F2)) (F2->K F2)) line)
                  (+ (/ (square (- 'p (((partial 1) G) 't 'q))) (* 2 'm))
                     (V 'q)
                     (- (((partial 0) G) 't 'q)))))

;; (5.255)-(5.259): the term of the pendulum on a moving pivot that is linear in p is removed.
;; With the signs of (5.256) and (5.257) it would double; it is G with the other one that leads to
;; (5.258), of which the last term has the square of Dy.
(test-case "pp. 392-393: the driven pendulum"
  (define y (literal-function 'y))
  (define (H s)
    (define-values (t theta p) (values (time s) (coordinate s) (momentum s)))
    (+ (/ (square p) (* 2 'm (square 'l)))
       (* -1 'm 'g 'l (cos theta))
       (* 'm 'g (y t))
       (* -1 (/ p 'l) (sin theta) ((D y) t))
       (* -1/2 'm (square (cos theta)) (square ((D y) t)))))
  (define (G t theta) (* 'm 'l (cos theta) ((D y) t)))
  (define (F2 t theta p-prime) (- (* theta p-prime) (G t theta)))
  (check-identity ((+ (compose H (F2->C F2)) (F2->K F2)) line)
                  (+ (/ (square 'p) (* 2 'm (square 'l)))
                     (* -1 'm 'l (+ 'g (((expt D 2) y) 't)) (cos 'q))
                     (* 'm 'g (y 't))
                     (* -1/2 'm (square ((D y) 't))))))
