#lang racket/base
;; The normal form of a quadratic Hamiltonian of one coordinate,
;;
;;     H = (a q² + 2 c q p + b p²)/2,        D = a b − c².
;;
;; D > 0: an oscillator, ω (Q² + P²)/2 with ω = ±√D, of the sign of b.  D < 0: a saddle, λ Q P with
;; λ = √−D, along the two directions in which H vanishes.  D = 0: nothing at all, or a motion like
;; that of a free particle, p²/2, which no frequency describes.  Exact numbers stay so where the
;; roots are rational.

(provide quadratic-pair (struct-out block) (struct-out trouble) identity-blocks
         elliptic-block saddle-block)

;; frequencies : a list, of one number for each coordinate of the block.  With exponents iω they are
;;   real for an oscillator, negative where its energy is; iλ for a saddle; iλ and iλ* for four
;;   exponents ±λ, ±λ*; 0 where the block has no energy
;; qs, ps : the directions of the new coordinates and momenta, vectors (q₁ … p₁ …)
(struct block (frequencies qs ps) #:authentic)

;; Why there is no normal form: a status, 'not-semisimple or 'undecided; the frequencies concerned;
;; and the distance to a form that is not semisimple, relative to the entries of the form
(struct trouble (status frequencies distance) #:authentic)

;; The distance to D = 0 is that of an eigenvalue of the form to 0, beside the `size` of all
;; quadratic terms: up to the tolerance, 0 if all is exact, D is 0, and up to its root undecided.
;; (stop trouble) ends the work
(define (quadratic-pair a c b tolerance size stop)
  (define greatest (max (abs a) (abs b) (abs c)))
  (define D (- (* a b) (* c c)))
  (define omega (sqrt (abs D)))
  (define distance (if (zero? greatest) 0 (/ (abs D) greatest size)))
  (define (give-up status) (stop (trouble status (list omega) distance)))
  (cond [(zero? greatest) (car (identity-blocks 1))]
        [(<= distance tolerance) (give-up 'not-semisimple)]
        [(<= distance (sqrt tolerance)) (give-up 'undecided)]
        [(negative? D) (saddle a c b omega)]
        [(and (<= (abs (- a b)) (* tolerance (abs a))) (<= (abs c) (* tolerance (abs a))))
         (elliptic-block a (vector 1 0) (vector 0 1))]
        [else (oscillator c b (if (negative? b) (- omega) omega))]))

;; n coordinates that have no energy, as they are
(define (identity-blocks n)
  (define (unit k) (build-vector (* 2 n) (lambda (i) (if (= i k) 1 0))))
  (for/list ([j (in-range n)]) (block '(0) (list (unit j)) (list (unit (+ n j))))))

(define (elliptic-block omega q p) (block (list omega) (list q) (list p)))
(define (saddle-block lambda q p) (block (list (make-rectangular 0 lambda)) (list q) (list p)))

;; b (p + c/b q)² + D/b q² with q = s Q, p + c/b q = P/s
(define (oscillator c b omega)
  (define s (sqrt (/ b omega)))
  (elliptic-block omega (vector s (- (* (/ c b) s))) (vector 0 (/ s))))

;; H vanishes along (b, r) and (r, a), with r = −c ∓ λ of the sign that loses no digits.
(define (saddle a c b lambda)
  (define forward? (>= c 0))
  (define r (if forward? (- (+ c lambda)) (- lambda c)))
  (define area (* (if forward? 1 -1) (- (* r r) (* a b))))
  (define-values (grows decays)
    (if forward? (values (vector r a) (vector b r)) (values (vector b r) (vector r a))))
  (define root (sqrt (abs area)))
  (define-values (f g)                  ; their product is the area
    (if (and (exact? area) (not (exact? root))) (values 1 area) (values root (/ area root))))
  (define sign (if (negative? (vector-ref grows 0)) -1 1))
  (define (over v d) (for/vector ([x (in-vector v)]) (/ x (* sign d))))
  (saddle-block lambda (over grows f) (over decays g)))
