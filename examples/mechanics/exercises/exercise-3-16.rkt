#lang mechanics
;; Exercise 3.16 (SICM 3.11): the restricted problem of three bodies
;; Checked: the Hamiltonian, where motion is allowed, a periodic orbit on the section y = 0
;; How: from the book's Lagrangian; walls of the Jacobi constant; Poincare-map of H

(require mechanics/book)

;; Masses GM₀ and GM₁ on the axis, at −a₀ and a₁; a small body of mass 1, with momenta in the
;; frame that turns with them at the rate Ω.
(define (distance x y a) (sqrt (+ (square (- x a)) (square y))))
(define ((rotating a0 a1 Omega GM0 GM1) (up t (up x y) (down px py)))
  (- (+ (* 1/2 (+ (square px) (square py))) (* Omega (- (* y px) (* x py))))
     (+ (/ GM0 (distance x y (- a0))) (/ GM1 (distance x y a1)))))

;; (a) It is that of the Lagrangian (1.150).
(define derived
  (verify-equal ((Lagrangian->Hamiltonian (LR3B1 1 'a_0 'a_1 'Omega 'GM_0 'GM_1))
                 (up 't (up 'x 'y) (down 'p_x 'p_y)))
                ((rotating 'a_0 'a_1 'Omega 'GM_0 'GM_1) (up 't (up 'x 'y) (down 'p_x 'p_y)))))
derived

;; Here both masses are equal, their distance 1, and a turn takes 2π.
(define H (rotating 0.5 0.5 1 0.5 0.5))
(define (potential x)
  (- (+ (* 1/2 (square x)) (/ 0.5 (abs (+ x 0.5))) (/ 0.5 (abs (- x 0.5))))))

;; The section: y = 0, crossed upwards, where the Jacobi constant −2H is C.
(define next
  (Poincare-map (Hamiltonian->state-derivative H)
                (event (lambda (s) (ref (coordinate s) 1)) #:direction 'rising)))
(define C 3.5)
;; With the velocity p_y − x upwards, p_y follows from x and p_x; no state where it cannot.
(define (on-section x px)
  (define kinetic (- (/ C -2) (potential x) (* 1/2 (square px))))
  (and (>= kinetic 0)
       (up 0 (up x 0) (down px (+ x (sqrt (* 2 kinetic)))))))
(define (section x px return fail)
  (define start (on-section x px))
  (cond [start
         (define there (next start))
         (return (ref (coordinate there) 0) (ref (momentum there) 0))]
        [else (fail)]))

;; (b), (c) Where motion is allowed: about both bodies, with a gap between them, for the energy
;; −C/2 = −1.75 is above that at rest in the middle, −2; and far out.  Between there is a wall.
(define (allowed? x) (and (on-section x 0) #t))
(map allowed? '(0. 0.3 0.9 1.2 1.5 2.))
(define (wall from to) (bisect (lambda (x) (+ (potential x) (/ C 2))) from to 1e-10))
(define-values (inner outer) (values (wall 0.9 1.15) (wall 1.25 2.)))
(list inner outer)
(define passing
  (evolve-trajectory (Hamiltonian->state-derivative H) (on-section 0. 0.3) 20. #:tolerance 1e-11))
(define abscissas (for/list ([k 401]) (ref (passing (* k 0.05)) 1 0)))
(list (apply min abscissas) (apply max abscissas))

;; (d) A periodic orbit around one of the bodies, against the sense of the rotation.
(define orbit (find-fixed-point section (up 0.3 0.)))
(list (fixed-point-coordinates orbit) (fixed-point-kind orbit))

;; An attempt: the Jacobi constant is kept, and the energy in the frame at rest; a slip: that
;; the angular momentum is.
(define start (on-section 0.3 0.1))
(define end (for/fold ([s start]) ([k 20]) (next s)))
(define kept (- (H end) (H start)))
(define (angular-momentum s)
  (- (* (ref (coordinate s) 0) (ref (momentum s) 1))
     (* (ref (coordinate s) 1) (ref (momentum s) 0))))
(define not-kept (- (angular-momentum end) (angular-momentum start)))
(< (abs kept) 1e-10)
not-kept

(module+ test
  (require rackunit)
  (test-case "a stable periodic orbit; the section keeps areas"
    (check-equal? (fixed-point-kind orbit) 'elliptic)
    (check-= (fixed-point-determinant orbit) 1 1e-8)
    (check-= (ref (fixed-point-coordinates orbit) 1) 0 1e-9))
  (test-case "what is kept"
    (check-= kept 0 1e-10)
    (check-true (> (abs not-kept) 1e-4)))
  (test-case "the Hamiltonian of the Lagrangian"
    (check-pred proved? derived))
  (test-case "walls, and an orbit that passes from one body to the other within them"
    (check-equal? (map allowed? '(0. 0.3 0.9 1.2 1.5 2.)) '(#t #t #t #f #t #t))
    (check-true (< (apply min abscissas) -0.5))
    (check-true (> (apply max abscissas) 0.5))
    (for ([x abscissas]) (check-true (< (abs x) inner)))))
