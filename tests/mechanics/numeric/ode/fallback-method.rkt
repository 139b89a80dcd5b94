#lang racket/base
;; Motions through a place where their formulas are 0/0 and they are smooth.

(require mechanics "../../support/checks.rkt")

;; An upright top that turns too slowly falls, and comes back through θ = 0, where its
;; Hamiltonian has a removable singularity.
(define (system)
  (Hamiltonian->state-derivative
   (Lagrangian->Hamiltonian (L-top 6.96e-4 1.32e-4 .112))))
(define ((L-top A C gMR) (up t (up theta phi psi) (up thetadot phidot psidot)))
  (- (+ (* 1/2 A (+ (square thetadot) (* (square phidot) (square (sin theta)))))
        (* 1/2 C (square (+ psidot (* phidot (cos theta))))))
     (* gMR (cos theta))))

(define critical (sqrt (* 4 6.96e-4 .112)))

(test-case "a top that falls comes back through the vertical"
  (define p (* 1.1 critical))
  (define start (up 0 (up 0.01 0.0 0.0) (down 0.0 p p)))
  (define tr (evolve-trajectory (system) start 2))
  ;; by the faster method; the next case is bridged
  (check-eq? (trajectory-method tr) 'Dormand-Prince-853)
  (define H (Lagrangian->Hamiltonian (L-top 6.96e-4 1.32e-4 .112)))
  (check-= (H (tr 2)) (H start) 1e-10))

(test-case "x'' = -x by a formula that loses its digits where x = 0"
  (define (f s)
    (define x (ref s 1))
    (up 1 (ref s 2) (/ (* -2 (- 1 (cos x)) (square x)) (* x (square (* 2 (sin (/ x 2))))))))
  (define tr (evolve-trajectory f (up 0 1 0) 20 #:tolerance 1e-9))
  (check-eq? (trajectory-method tr) 'Taylor)
  (check-= (ref (tr 20) 1) (cos 20) 1e-5))

(test-case "it is not carried over a singularity"
  (for ([f (list (lambda (s) (up 1 (square (ref s 1)))) (lambda (s) (up 1 (/ -1 (ref s 1)))))]
        [t '(1.0 0.5)])
    (define e
      (with-handlers ([exn:fail:mechanics:singular? values]) (evolve-trajectory f (up 0 1.0) 2)))
    (check-pred exn:fail:mechanics:singular? e)
    (check-= (trajectory-end (exn:fail:mechanics:singular-where e)) t 1e-9)))
