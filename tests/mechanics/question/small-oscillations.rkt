#lang racket/base
;; Normal modes: known systems, and the equations that modes obey, of random systems.

(require mechanics
         "../support/checks.rkt" "../support/messages.rkt" "../support/random.rkt"
         "../support/systems.rkt")

(define (L-pendulums m1 m2 l g) (L-double-pendulum m1 m2 l l g))

(define ((L-plate k Omega) (up t (up x y) (up vx vy)))
  (- (* 1/2 (+ (square (- vx (* Omega y))) (square (+ vy (* Omega x)))))
     (* 1/2 k (+ (square x) (square y)))))

(define (expressions x) (map expression x))

;; Two coordinates with these matrices, and the magnetic term of a rate g.
(define (L-of M K g)
  (define (bilinear S a b) (for*/sum ([i 2] [j 2]) (* (ref a i) (matrix-ref S i j) (ref b j))))
  (lambda (state)
    (define-values (q v) (values (coordinate state) (velocity state)))
    (+ (* 1/2 (bilinear M v v)) (* -1/2 (bilinear K q q))
       (* 1/2 g (- (* (ref q 0) (ref v 1)) (* (ref q 1) (ref v 0)))))))

(test-case "a pendulum, hanging and standing"
  (define ((L m l g) (up t theta v))
    (+ (* 1/2 m (square (* l v))) (* m g l (cos theta))))
  (check-equal? (expressions (normal-modes (L 'm 'l 'g) 0)) '((up (sqrt (/ g l)) 1)))
  (check-equal? (expressions (small-oscillation-frequencies (L 'm 'l 'g) pi))
                '((sqrt (/ (* -1 g) l)))))

(test-case "a double pendulum of equal parts: ω² = (2 ± √2) g/l"
  (check-equal? (expressions (normal-modes (L-pendulums 'm 'm 'l 'g) (up 0 0)))
                '((up (sqrt (/ (* g (- 2 (sqrt 2))) l)) (up 1 (sqrt 2)))
                  (up (sqrt (/ (* g (+ 2 (sqrt 2))) l)) (up 1 (* -1 (sqrt 2)))))))

(test-case "where both frequencies are one each coordinate is a mode, though M joins them"
  (define M (matrix-by-rows '(2 1) '(1 2)))
  (check-equal? (expressions (normal-modes (L-of M (* 'k M) 0) (up 0 0)))
                '((up (sqrt k) (up 1 0)) (up (sqrt k) (up 0 1)))))

(test-case "numbers and formulas agree"
  (define numbers (normal-modes (L-pendulums 1.0 2.0 0.5 9.8) (up 0 0)))
  (define formulas (normal-modes (L-pendulums 'm_1 'm_2 'l 'g) (up 0 0)))
  (for ([n numbers] [f formulas])
    (define value (substitute f 'm_1 1.0 'm_2 2.0 'l 0.5 'g 9.8))
    (check-= (ref value 0) (ref n 0) 1e-13)
    (check-= (ref value 1 1) (ref n 1 1) 1e-13)))

(test-case "springs: symmetric and antisymmetric"
  (define ((L k c) (up t (up x y) v))
    (- (* 1/2 (square v)) (* 1/2 k (+ (square x) (square y))) (* 1/2 c (square (- x y)))))
  (check-equal? (expressions (normal-modes (L 'k 'c) (up 0 0)))
                '((up (sqrt k) (up 1 1)) (up (sqrt (+ (* 2 c) k)) (up 1 -1))))
  (check-equal? (expressions (normal-modes (L 'k 0) (up 0 0)))
                '((up (sqrt k) (up 1 0)) (up (sqrt k) (up 0 1)))))

(test-case "a turning plate: the frequencies are shifted by the rate of turning"
  (check-equal? (expressions (normal-modes (L-plate (square 'omega) 'Omega) (up 0 0)))
                '((up (- Omega omega) (up 1 +i)) (up (+ Omega omega) (up 1 +i))))
  (define modes (normal-modes (L-plate 4.0 0.5) (up 0 0)))
  (check-= (ref (car modes) 0) 1.5 1e-14)
  (check-= (ref (cadr modes) 0) 2.5 1e-14)
  (check-= (magnitude (- (ref (cadr modes) 1 1) +i)) 0 1e-13)
  (check-= (magnitude (+ (ref (car modes) 1 1) +i)) 0 1e-13))

(test-case "Lagrange's triangle is stable up to Routh's mass ratio"
  ;; ω⁴ − ω² + 27 μ(1 − μ)/4 = 0 in units where the primaries turn at rate 1
  (define ((L mu) (up t (up x y) (up vx vy)))
    (define (distance a) (sqrt (+ (square (- x a)) (square y))))
    (+ (* 1/2 (+ (square (- vx y)) (square (+ vy x))))
       (/ (- 1 mu) (distance (- mu)))
       (/ mu (distance (- 1 mu)))))
  (define (frequencies mu)
    (small-oscillation-frequencies (L mu) (up (- 0.5 mu) (/ (sqrt 3.0) 2))))
  (for ([mu '(0.001 0.012 0.038)])
    (define squares
      (let ([root (sqrt (- 1 (* 27 mu (- 1 mu))))])
        (list (/ (- 1 root) 2) (/ (+ 1 root) 2))))
    (check-within (map square (frequencies mu)) squares 1e-10))
  (check-true (andmap real? (frequencies 0.0385)))
  (check-false (ormap real? (frequencies 0.0386))))

(test-case "frequencies that coincide where velocities act have one shape, given twice"
  ;; M = 1, K = −1, g = 2: ω⁴ − 2 ω² + 1 = 0
  (define ((L c) (up t (up x y) (up vx vy)))
    (+ (* 1/2 (+ (square vx) (square vy))) (- (* x vy) (* y vx)) (* c (+ (square x) (square y)))))
  (check-equal? (expressions (normal-modes (L 1/2) (up 0 0))) '((up 1 (up 1 +i)) (up 1 (up 1 +i))))
  ;; x ẍ-equation: ẍ − 2 ẏ − x = 0 with (x, y) = Re (1, i) e^{it}
  (check-pred proved? (verify-solution (L 1/2) (lambda (t) (up (cos t) (* -1 (sin t)))))))

(test-case "systems of two coordinates, by formulas: each mode solves the linear equations"
  (with-seed 412
    (for ([_ 12])
      (define-values (c g) (values (random-rational) (random-rational)))
      (define M (matrix-by-rows (list (+ 1 (square c)) c) (list c 1)))
      (define-values (k k01) (values (random-rational) (random-rational)))
      (define K (matrix-by-rows (list k k01) (list k01 (random-rational))))
      (for ([mode (normal-modes (L-of M K g) (up 0 0))])
        (define-values (w v) (values (ref mode 0) (ref mode 1)))
        (define S (+ K (* -1 (square w) M) (* +i w (gyroscopic-matrix (L-of M K g) (up 0 0)))))
        (for ([i 2])
          (define off
            (+ (* (matrix-ref S i 0) (ref v 0)) (* (matrix-ref S i 1) (ref v 1))))
          (check-= (magnitude (exact->inexact (simplify off))) 0 1e-8))))))

(define (chain n m l g)
  (lambda (state)
    (define-values (q v) (values (coordinate state) (velocity state)))
    (for/fold ([x 0] [y 0] [L 0] #:result L) ([i n])
      (define vx (+ x (* l (cos (ref q i)) (ref v i))))
      (define vy (+ y (* l (sin (ref q i)) (ref v i))))
      (values vx vy
              (+ L (* 1/2 m (+ (square vx) (square vy)))
                 (* (- n i) m g l (cos (ref q i))))))))

(test-case "a chain of three equal pendulums: numbers times the root of g/l"
  (define modes (normal-modes (chain 3 'm 'l 'g) (up 0 0 0)))
  ;; the squares are the zeros of Laguerre's polynomial of degree 3
  (for ([mode modes] [zero '(0.41577455678347908 2.2942803602790417 6.2899450829374792)])
    (check-= (substitute (ref mode 0) 'g 1 'l 1) (sqrt zero) 1e-13))
  (for ([mode modes] [number (normal-modes (chain 3 1.0 2.0 9.8) (up 0 0 0))])
    (check-= (substitute (ref mode 0) 'g 9.8 'l 2.0) (ref number 0) 1e-12)))

(test-case "nested coordinates give nested shapes"
  (define ((L k) (up t (up (up x y) z) v))
    (- (* 1/2 (square v)) (* 1/2 k (+ (square x) (* 2 (square (- y z)))))))
  (check-equal? (expressions (normal-modes (L 'k) (up (up 0 0) 0)))
                '((up (sqrt k) (up (up 1 0) 0))
                  (up 0 (up (up 0 1) 1))
                  (up (* 2 (sqrt k)) (up (up 0 1) -1)))))

(test-case "random systems: each mode solves the linear equations"
  (with-seed 88
    (for* ([n '(2 3 5 8)] [turning? '(#f #t)])
      (define (random-entries) (m:generate n n (lambda (i j) (- (random) 0.5))))
      (define A (random-entries))
      (define B (random-entries))
      (define M (+ (* A (transpose A)) 1.0))
      (define K (* B (transpose B)))
      (define G (if turning? (- B (transpose B)) (* 0.0 A)))
      (define (bilinear S a b)
        (for*/sum ([i n] [j n]) (* (ref a i) (matrix-ref S i j) (ref b j))))
      (define (L state)
        (define-values (q v) (values (coordinate state) (velocity state)))
        (+ (* 1/2 (bilinear M v v)) (* -1/2 (bilinear K q q)) (* 1/2 (bilinear G v q))))
      (define zero (vector->up (make-vector n 0)))
      (define modes (normal-modes L zero))
      (check-equal? (length modes) n)
      (for ([mode modes])
        (define-values (w v) (values (ref mode 0) (ref mode 1)))
        (define S (+ K (* (- (square w)) M) (* +i w G)))
        (for ([i n])
          (check-= (magnitude (for/sum ([j n]) (* (matrix-ref S i j) (ref v j)))) 0 1e-9
                   (format "n = ~a, turning ~a" n turning?)))))))

;; At rest nothing changes: neither force nor stiffness.
(define (growing-mass (up t q v)) (- (* 1/2 (+ 1 (square t)) (square v)) (* 1/2 (square q))))

(test-case "what is no equilibrium, no minimum of numbers, or no function of coordinates"
  (check-message
   (string-append "normal-modes: these coordinates are not an equilibrium; "
                  "at rest there, a force remains\n"
                  "  coordinates: (up a 0)\n"
                  "  ∂₁L: (down (* -2 g l m (sin a)) 0)")
   (normal-modes (L-pendulums 'm 'm 'l 'g) (up 'a 0)))
  (check-exn
   #rx"^small-oscillation-frequencies: the Lagrangian changes in time at these coordinates"
   (lambda ()
     (small-oscillation-frequencies
      (lambda (s) (- (square (velocity s)) (* (time s) (square (coordinate s)))))
      0)))
  (for ([ask (list normal-modes small-oscillation-frequencies)]
        [name '("normal-modes" "small-oscillation-frequencies")])
    (check-exn (regexp (string-append "^" name ": the Lagrangian changes in time at these"))
               (lambda () (ask growing-mass 0))))
  (check-exn #rx"^normal-modes: 3 coordinates act on one another, and formulas are for 1 and 2"
             (lambda ()
               (normal-modes (lambda (s)
                               (define q (coordinate s))
                               (- (square (velocity s)) (* 'a (square (ref q 0)))
                                  (* 'b (square (- (ref q 0) (ref q 1))))
                                  (square (- (ref q 1) (ref q 2)))))
                             (up 0 0 0))))
  (check-exn #rx"^normal-modes: the kinetic energy is not positive for all velocities"
             (lambda ()
               (normal-modes (lambda (s)
                               (define-values (q v) (values (coordinate s) (velocity s)))
                               (- (* 1.0 (ref v 0) (ref v 1)) (square q)))
                             (up 0 0))))
  ;; of three coordinates, with an M that is m times numbers
  (check-exn #rx"^normal-modes: the kinetic energy is not positive for all velocities"
             (lambda ()
               (normal-modes (lambda (s)
                               (define-values (q v) (values (coordinate s) (velocity s)))
                               (- (* 'm (ref v 1) (+ (ref v 0) (ref v 1) (ref v 2)))
                                  (* 'k (square q))))
                             (up 0 0 0))))
  (check-exn #rx"^mass-matrix: expected coordinates.*given: [(]0 0[)], a list"
             (lambda () (mass-matrix (L-pendulums 1 1 1 1) '(0 0)))))
