#lang racket/base
;; Questions whose arguments are in another order: refused where that shows, else remarked.

(require mechanics
         (only-in mechanics/book L-harmonic L-pendulum)
         "../support/checks.rkt" "../support/messages.rkt")

(define L (L-harmonic 'm 'k))
(define line (up 't 'x 'v))
(define plane (up 't (up 'x 'y) (up 'vx 'vy)))
(define ((L-free m) (up t q v)) (* 1/2 m (square v)))
(define ((angular-momentum m) (up t (up x y) (up vx vy))) (* m (- (* x vy) (* y vx))))
(define (energy s) (+ (* 1/2 'm (square (velocity s))) (* 1/2 'k (square (coordinate s)))))
(define H (make-Hamiltonian (lambda (s) (+ (square (ref s 2)) (square (ref s 1))))))
(define state (up 't 'q 'p))

(define-syntax-rule (other-order [asked right] ...)
  (begin
    (check-message (format "~a: the arguments come in another order: ~a" (car 'right) 'right) asked)
    ...))

(test-case "a function comes first, and a local tuple last"
  (other-order
   [(verify-conserved L line energy)              (verify-conserved L Q local)]
   [(verify-conserved line L energy)              (verify-conserved L Q local)]
   [(verify-equilibrium 0 L)                      (verify-equilibrium L q)]
   [(equilibrium-stability (up 0 0) L)            (equilibrium-stability L q)]
   [(find-equilibrium 0 L)                        (find-equilibrium L start)]
   [(equilibria line L)                           (equilibria L local)]
   [(normal-modes 0 L)                            (normal-modes L q)]
   [(small-oscillation-frequencies 0 L)           (small-oscillation-frequencies L q)]
   [(mass-matrix 0 L)                             (mass-matrix L q)]
   [(verify-ignorable L line 'x)                  (verify-ignorable L which local)]
   [(verify-ignorable 'x L line)                  (verify-ignorable L which local)]
   [(ignorable-coordinates line L)                (ignorable-coordinates L local)]
   [(conserved-momenta line L)                    (conserved-momenta L local)]
   [(verify-total-time-derivative line L)         (verify-total-time-derivative F local)]
   [(gauge-function line L)                       (gauge-function F local)]
   [(verify-equivalent-Lagrangians L line L)      (verify-equivalent-Lagrangians L1 L2 local)]
   [(compare-Lagrangians line L L)                (compare-Lagrangians L1 L2 local)]))

(test-case "what has no inertia is no Lagrangian, where the quantity has it"
  (define swapped ": the Lagrangian comes first, then the quantity; these look swapped")
  (check-message (string-append "verify-conserved" swapped)
                 (verify-conserved (angular-momentum 'm) (L-free 'm) plane))
  (check-message (string-append "rate-of-change" swapped)
                 ((rate-of-change (angular-momentum 'm) (L-free 'm)) plane))
  (check-exn exn:fail:mechanics:singular?
             (lambda () (verify-conserved (angular-momentum 'm) coordinate plane))))

(test-case "an energy for a Lagrangian is told by its name"
  (define note (string-append "energy was taken for the Lagrangian, which comes first, "
                              "and L-harmonic for the quantity"))
  (check-equal? (verdict-remarks (verify-conserved energy L line)) (list note))
  (check-equal? (verdict-remarks (verify-conserved L energy line)) '())
  (check-equal? (length (verdict-remarks (verify-conserved (Lagrangian->energy L) L line))) 1)
  (check-equal? (verdict-remarks (verify-conserved L (Lagrangian->energy L) line)) '())
  (define (L-z s) (ref (coordinate s) 0))
  (check-equal? (verdict-remarks (verify-conserved (lambda (s) (square (velocity s))) L-z plane))
                '()))

(test-case "a Hamiltonian comes first"
  (define text "the Hamiltonian comes first; these look exchanged")
  (check-message (string-append "verify-conserved: " text) (verify-conserved coordinate H state))
  (check-message (string-append "rate-of-change: " text) (rate-of-change coordinate H))
  (check-message (string-append "verify-Hamiltonian-solution: " text)
                 (verify-Hamiltonian-solution sin cos H))
  (check-message (string-append "verify-Hamiltonian-solution: " text)
                 (verify-Hamiltonian-solution sin H cos)))

(test-case "coordinates and momenta exchanged"
  (define H (make-Hamiltonian (lambda (s) (+ (/ (square (ref s 2)) 4) (square (ref s 1))))))
  (define (q t) (* 'a (cos t)))
  (define (p t) (* -2 'a (sin t)))
  (check-pred proved? (verify-Hamiltonian-solution H q p))
  (define v (verify-Hamiltonian-solution H p q))
  (check-pred refuted? v)
  (check-equal? (verdict-remarks v)
                (list (string-append "with q and p exchanged it is proved; "
                                     "the coordinates come first, then the momenta")))
  (check-equal? (verdict-remarks (verify-Hamiltonian-solution H q q)) '()))

(test-case "substitute in the order of scmutils, with a symbol for the value"
  (check-exn #rx"^substitute: there is nothing to replace in the symbol z; the expression comes"
             (lambda () (substitute 'z 'a (+ 'a 'b))))
  (check-equal? (substitute 'a 'a (+ 'a 'b)) (+ 'a 'b))
  (check-equal? (substitute 'z 'a 'b) 'z))
