#lang racket/base
;; Curvature of metrics: black holes, a universe that expands, and a metric of which nothing is
;; known.
;;
;; The algebra is loaded by the task, as a reader meets it.

(require mechanics mechanics/geometry
         "task.rkt")

(provide curvature-tasks
         Schwarzschild-metric Kerr-Newman-metric expanding-metric
         Ricci-of field-equations Friedmann-equations literal-curvature curvature-identities)

(define-coordinates (up t r theta phi) spacetime-sphere)
(define basis (coordinate-system->basis spacetime-sphere))
(define here ((point spacetime-sphere) (up 't 'r 'theta 'phi)))

(define (Ricci-of g) (Ricci (covariant-derivative (metric->Cartan g basis)) basis))

(define sine^2 (square (sin theta)))

;; Σ cᵢ wᵢ ⊗ wᵢ, of coefficients and 1-forms in turn
(define (diagonal . cs-and-ws)
  (make-metric
   (lambda (u v)
     (let loop ([rest cs-and-ws])
       (if (null? rest)
           0
           (+ (* (car rest) ((cadr rest) u) ((cadr rest) v)) (loop (cddr rest))))))))

(define (Schwarzschild-metric)
  (define A (- 1 (/ (* 2 'M) r)))
  (diagonal (- A) dt (/ 1 A) dr (square r) dtheta (* (square r) sine^2) dphi))

;; In the coordinates of Boyer and Lindquist, and the potential of its field
(define Sigma (+ (square r) (* (square 'a) (square (cos theta)))))
(define along (- dt (* 'a sine^2 dphi)))

(define (Kerr-Newman-metric charge)
  (define Delta (+ (square r) (* -2 'M r) (square 'a) (square charge)))
  (define around (- (* (+ (square r) (square 'a)) dphi) (* 'a dt)))
  (diagonal (- (/ Delta Sigma)) along (/ sine^2 Sigma) around
            (/ Sigma Delta) dr Sigma dtheta))

(define (potential charge) (* -1 (/ (* charge r) Sigma) along))

;; Ricci's tensor less what the energy of the field makes of it
(define (field-equations g F)
  (define up-again (raise g basis))
  (define F*F
    (with-argument-types
     (lambda (u v) (contract (lambda (e w) (* (F u e) (F v (up-again w)))) basis))
     '(vector vector) spacetime-sphere))
  (- (Ricci-of g) (- (* 2 F*F) (* 1/2 ((trace2down g) F*F) g))))

(define (expanding-metric)
  (define a^2 (square (compose (literal-function 'a) t)))
  (diagonal -1 dt (/ a^2 (- 1 (* 'k (square r)))) dr
            (* a^2 (square r)) dtheta (* a^2 (square r) sine^2) dphi))

(define (Friedmann-equations)
  (define G (Einstein-tensor (expanding-metric) basis))
  (simplify (up ((G d/dt d/dt) here) ((G d/dr d/dr) here))))

;; ---------------------------------------------------------------------------

(define (literal-curvature) (metric->Riemann (literal-metric 'g R4-rect)))

;; The pair symmetry and the first of Bianchi's
(define (curvature-identities R)
  (define (tensor f)
    (with-argument-types f '(vector vector vector vector) R4-rect))
  (list (tensor (lambda (p q r s) (- (R p q r s) (R r s p q))))
        (tensor (lambda (p q r s) (+ (R p q r s) (R p r s q) (R p s q r))))))

(define (proof-task name title make)
  (make-task name (string-append title ", proved") (lambda () (verify-equal (make) 0))
             #:size verdict-status))

(define curvature-tasks
  (list
   (proof-task 'K1 "Ricci's tensor of Schwarzschild's metric is 0"
               (lambda () (Ricci-of (Schwarzschild-metric))))
   (proof-task 'K2 "Ricci's tensor of Kerr's metric is 0"
               (lambda () (Ricci-of (Kerr-Newman-metric 0))))
   (proof-task 'K3 "Kerr and Newman's metric with its field satisfies Einstein's equations"
               (lambda () (field-equations (Kerr-Newman-metric 'Q) (d (potential 'Q)))))
   (make-task 'K4 "Friedmann's equations from the metric, simplified" Friedmann-equations)
   (make-task 'K5 "a literal metric of 4 dimensions: Riemann's tensor, 2 of its identities proved"
              (lambda ()
                (for/list ([T (in-list (curvature-identities (literal-curvature)))])
                  (verdict-status (verify-equal T 0))))
              #:size (lambda (statuses) (format "~a" statuses)))))
