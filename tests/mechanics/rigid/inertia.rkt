#lang racket/base
;; Moments of inertia: of point masses, of bodies by formula and by quadrature, about other
;; points, and along the principal axes.

(require mechanics
         "../support/checks.rkt"
         "../support/close.rkt" "../support/messages.rkt" "../support/session.rkt")

(define (entries I) (for*/list ([i 3] [j 3]) (matrix-ref I i j)))
(define (diagonal I) (for/list ([i 3]) (matrix-ref I i i)))

;; ---------------------------------------------------------------------------
;; Point masses

(define masses '(m_1 m_2))
(define places (list (up 'x_1 'y_1 'z_1) (up 'x_2 'y_2 'z_2)))
(define I (inertia-tensor masses places))
(define omega (up 'p 'q 'r))

(test-case "the kinetic energy of points that turn is half omega I omega"
  (define T
    (for/sum ([m masses] [x places]) (* 1/2 m (square (cross-product omega x)))))
  (check-identity (* 1/2 (dot-product omega (* I omega))) T)
  (define L (for/fold ([sum (up 0 0 0)]) ([m masses] [x places])
              (+ sum (* m (cross-product x (cross-product omega x))))))
  (check-identity (* I omega) L))

(test-case "exercise 2.3: a moment is at most the sum of the two others"
  (define moment (diagonal (inertia-tensor '(m) (list (up 'x 'y 'z)))))
  (check-identity (- (+ (car moment) (cadr moment)) (caddr moment)) (* 2 'm (square 'z))))

(test-case "lists and tuples of masses and of positions are the same"
  (check-equal? (inertia-tensor (up 1 2) (up (up 1 2 3) (up 4 5 6)))
                (inertia-tensor '(1 2) (list (up 1 2 3) (up 4 5 6)))))

(test-case "about a turned set of axes it is turned"
  (define M (Euler->M (up 'theta 'phi 'psi)))
  (check-identity (inertia-tensor masses (for/list ([x places]) (* M x)))
                  (* M (* I (transpose M)))))

(test-case "about another point, by the theorem of parallel axes"
  (define center
    (/ (for/fold ([sum (up 0 0 0)]) ([m masses] [x places]) (+ sum (* m x))) (apply + masses)))
  (define about-center (inertia-tensor masses (for/list ([x places]) (- x center))))
  (check-identity (parallel-axes about-center (apply + masses) center) I)
  (check-prints (matrix-ref (parallel-axes (ball-inertia 'M 'R) 'M (up 'R 0 0)) 1 1)
                '(* 7/5 M (expt R 2))))

;; ---------------------------------------------------------------------------
;; Formulas, against quadrature

(define (circle R) (lambda (x . _) (define h (sqrt (max 0 (- (* R R) (* x x))))) (list (- h) h)))
(define (disc R) (list (list (- R) R) (circle R)))

(define-check (check-body formula body tolerance)
  (with-check-info (['formula formula] ['body body])
    (unless (for/and ([a (entries formula)] [b (entries (body-inertia body))])
              (< (abs (- a b)) tolerance))
      (fail-check))))

(test-case "a box"
  (define box (density->body 2 '(-1/2 1/2) '(-1 1) '(-3/2 3/2)))
  (check-= (body-mass box) 12 1e-12)
  (check-body (box-inertia 12 1 2 3) box 1e-10))

(test-case "a box away from the origin has the same about its centre"
  (define box (density->body 2 '(0 1) '(1 3) '(-3 0)))
  (check-close (body-center box) (up 1/2 2 -3/2) 1e-12)
  (check-body (box-inertia 12 1 2 3) box 1e-9))

(test-case "a cylinder and a cone"
  (define-values (R h) (values 0.5 2.0))
  (define cylinder (density->body 1 (car (disc R)) (cadr (disc R)) (list (/ h -2) (/ h 2))))
  (check-body (cylinder-inertia (* pi R R h) R h) cylinder 1e-6)
  ;; from the tip up, with z first
  (define (width z) (define r (/ (* R z) h)) (list (- r) r))
  (define (depth z x)
    (define d (sqrt (max 0 (- (square (/ (* R z) h)) (* x x)))))
    (list (- d) d))
  (define cone (density->body 1 (list 0 h) width depth))
  (check-= (body-mass cone) (/ (* pi R R h) 3) 1e-6)
  (check-close (body-center cone) (up (* 3/4 h) 0 0) 1e-6)
  (define formula (diagonal (cone-inertia (body-mass cone) R h)))
  (check-close (diagonal (body-inertia cone)) (reverse formula) 1e-6))

(test-case "an ellipsoid, and a ball"
  (define (half x) (sqrt (max 0 (- 1 x))))
  (define (ys x) (define b (* 2 (half (* x x)))) (list (- b) b))
  (define (zs x y) (define c (* 3 (half (+ (* x x) (* 1/4 y y))))) (list (- c) c))
  (define body (density->body 1 '(-1 1) ys zs #:tolerance 1e-6))
  (check-body (ellipsoid-inertia (body-mass body) 1 2 3) body 1e-4)
  (check-equal? (ellipsoid-inertia 'M 'R 'R 'R) (ball-inertia 'M 'R)))

(test-case "formulas of one body that are those of another at an edge"
  (check-equal? (diagonal (box-inertia 12 0 0 1)) (diagonal (rod-inertia 12 1)))
  (check-identity (shell-inertia 'M 'R)            ; the derivative of balls of equal density
                  (* (/ 'M (* 3 (square 'R)))
                     ((D (lambda (R) (ball-inertia (cube R) R))) 'R)))
  (check-identity (cylinder-inertia 'M 0 'l) (rod-inertia 'M 'l)))

(test-case "a torus, by discs that go round"
  (define-values (R r) (values 2 1))
  (define (moment weigh)
    (definite-integral
      (lambda (rho)
        (define h (sqrt (max 0 (- (* r r) (square (- rho R))))))
        (* 4 pi rho h (weigh rho h)))
      (- R r) (+ R r)))
  (define M (moment (lambda (rho h) 1)))
  (check-= M (* 2 pi pi R r r) 1e-6)
  (check-close (diagonal (torus-inertia M R r))
               (let ([across (moment (lambda (rho h) (+ (* 1/2 rho rho) (* 1/3 h h))))])
                 (list across across (moment (lambda (rho h) (* rho rho)))))
               1e-6))

(test-case "a density that changes"
  (define body (density->body (lambda (x y z) (+ 1 x)) '(0 1) '(0 1) '(0 1)))
  (check-true (body? body))
  (check-= (body-mass body) 3/2 1e-12)
  (check-close (body-center body) (up 5/9 1/2 1/2) 1e-12))

;; ---------------------------------------------------------------------------
;; Principal axes

(define-check (check-principal I)
  (define M (principal-axes I))
  (define turned (* (transpose M) (* I M)))
  (define moments (structure->list (principal-moments I)))
  (with-check-info (['axes M] ['moments moments])
    (unless (and (< (abs (- (determinant M) 1)) 1e-12)
                 (equal? moments (sort moments <))
                 (for*/and ([i 3] [j 3])
                   (< (abs (- (matrix-ref turned i j) (if (= i j) (list-ref moments i) 0)))
                      1e-12)))
      (fail-check))))

(test-case "they are a rotation that makes the tensor diagonal, the moments rising"
  (check-principal (matrix-by-rows '(2. 1. 1.) '(1. 2. 0.) '(1. 0. 5.)))
  (check-principal (matrix-by-rows '(2 1 1) '(1 2 0) '(1 0 5)))
  (check-principal (matrix-by-rows '(3 0 0) '(0 2 0) '(0 0 1)))
  (check-principal (matrix-by-rows '(2. 0. 0.) '(0. 2. 0.) '(0. 0. 1.)))
  (define at-corner (parallel-axes (box-inertia 12 1. 2. 3.) 12 (up 0.5 1. 1.5)))
  (check-principal at-corner))

(test-case "exact where the moments are rational, equal ones too"
  (define I (matrix-by-rows '(2 1 1) '(1 2 1) '(1 1 2)))
  (check-equal? (principal-moments I) (up 1 1 4))
  (define M (principal-axes I))
  (check-pred proved? (verify-rotation M))
  (check-identity (* (transpose M) (* I M)) (matrix-by-rows '(1 0 0) '(0 1 0) '(0 0 4))))

(test-case "of symbols, by formula"
  (define I (matrix-by-rows '(a b 0) '(b a 0) '(0 0 c)))
  (check-equal? (map expression (structure->list (principal-moments I))) '((+ a b) (- a b) c))
  (define M (principal-axes I))
  (check-pred proved? (verify-rotation M))
  (check-identity (* (transpose M) (* I M))
                  (matrix-by-rows (list (+ 'a 'b) 0 0) (list 0 (- 'a 'b) 0) '(0 0 c)))
  (define coupled (matrix-by-rows '(2 b 0) '(b 2 0) '(0 0 5)))
  (check-equal? (map expression (structure->list (principal-moments coupled)))
                '((+ 2 b) (- 2 b) 5)))

;; ---------------------------------------------------------------------------

(says
 [(inertia-tensor 'm (list (up 1 2 3)))
  "inertia-tensor: expected a list of masses; given the symbol m"]
 [(inertia-tensor '(m) places)
  "inertia-tensor: each mass has a position; given 1 masses and 2 positions"]
 [(inertia-tensor '() '()) "inertia-tensor: expected at least one mass"]
 [(inertia-tensor '(m) (list (up 'x 'y)))
  "inertia-tensor: expected a position, a tuple of 3 components; "
  "given (up x y), an up tuple of 2"]
 [(principal-moments (matrix-by-rows '(1 2 0) '(0 1 0) '(0 0 1)))
  "principal-moments: an inertia tensor is symmetric; given "
  "(matrix-by-rows (list 1 2 0) (list 0 1 0) (list 0 0 1)), a 3 by 3 matrix"]
 [(principal-moments (matrix-by-rows '(1 0 0) '(2 1 0) '(0 0 1)))
  "principal-moments: an inertia tensor is symmetric; given "
  "(matrix-by-rows (list 1 0 0) (list 2 1 0) (list 0 0 1)), a 3 by 3 matrix"]
 [(principal-axes (up 1 2 3))
  "principal-axes: expected an inertia tensor, a 3 by 3 matrix\n"
  "  given: (up 1 2 3), an up tuple of 3"]
 [(parallel-axes 'I 'M (up 1 0 0))
  "parallel-axes: expected an inertia tensor, a 3 by 3 matrix\n  given: the symbol I"]
 [(box-inertia 'M (up 1 2 3) 1 1)
  "box-inertia: the mass and lengths are numbers; given (up 1 2 3), an up tuple of 3"]
 [(density->body 'rho '(0 1) '(0 1) '(0 1))
  "density->body: a density is a number or a function of x, y and z; given the symbol rho"]
 [(density->body 1 '(1 0) '(0 1) '(0 1))
  "density->body: the mass is not positive: -1.0\n  are limits in the wrong order?"]
 [(density->body 1 '(0 1) '(0 1 2) '(0 1))
  "density->body: limits are a list of two, or a function of the coordinates before; "
  "given (0 1 2), a list"])
