#lang mechanics
;; Exercise 3.16 (SICM 3.11): the restricted problem of three bodies
;; Checked: a periodic orbit on the section y = 0, and what is kept along orbits
;; How: Poincare-map of the Hamiltonian in the rotating frame; the Jacobi constant

;; Masses 1 − μ and μ at distance 1, turning once in 2π; the small body with momenta in the
;; rotating frame.  Both are equal here.
(define mu 0.5)
(define (distance x y a) (sqrt (+ (square (- x a)) (square y))))
(define (H (up t (up x y) (down px py)))
  (- (+ (* 1/2 (+ (square px) (square py))) (- (* y px) (* x py)))
     (+ (/ (- 1 mu) (distance x y (- mu)))
        (/ mu (distance x y (- 1 mu))))))

;; The section: y = 0, crossed upwards, where the Jacobi constant −2H is C.
(define next
  (Poincare-map (Hamiltonian->state-derivative H)
                (event (lambda (s) (ref (coordinate s) 1)) #:direction 'rising)))
(define C 3.5)
;; With the velocity p_y − x upwards, p_y follows from x and p_x; no state where it cannot.
(define (on-section x px)
  (define potential (+ (/ (- 1 mu) (abs (+ x mu))) (/ mu (abs (- x (- 1 mu))))))
  (define kinetic (- (+ (/ C -2) potential (* 1/2 (square x))) (* 1/2 (square px))))
  (and (>= kinetic 0)
       (up 0 (up x 0) (down px (+ x (sqrt (* 2 kinetic)))))))
(define (section x px return fail)
  (define start (on-section x px))
  (cond [start
         (define there (next start))
         (return (ref (coordinate there) 0) (ref (momentum there) 0))]
        [else (fail)]))

;; A periodic orbit around one of the bodies, against the sense of the rotation.
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
    (check-true (> (abs not-kept) 1e-4))))
