#lang racket/base
;; Components are found once and kept: they do not rest on assumptions that are withdrawn later, do
;; not hold charts that nobody else has, and do not take the coordinates that a procedure read from
;; its point for those that derivatives are taken by.

(require mechanics mechanics/geometry
         (only-in mechanics/geometry/manifold-chart coordinate-system-symbols)
         "../support/checks.rkt" "../support/messages.rkt" "../support/session.rkt")

(define-coordinates (up x y) R2-rect)
(define-coordinates t R1-rect)
(define basis (coordinate-system->basis R2-rect))
(define g (literal-metric 'g R2-rect))
(define f (literal-manifold-function 'f R2-rect))
(define m ((point R2-rect) (up 3 4)))

(define (refuted? a b) (eq? (verdict-status (verify-equal a b)) 'refuted))

(test-case "components that were found under an assumption do not rest on it"
  (define root (components->metric (down (down (sqrt (square 'a)) 0) (down 0 1)) basis))
  (define inverse (metric:invert root))
  (assume '(> a 0))
  (check-identity (inverse dx dx) (/ 1 'a))
  (forget-assumptions '(> a 0))
  (check-true (refuted? (inverse dx dx) (/ 1 'a))))

;; c = x(m) is a constant in ∂²(c x²)/∂x².
(define (twice-x m) ((d/dx (d/dx (* (x m) (square x)))) m))

(test-case "what a procedure reads from its point is a constant for derivatives inside"
  (check-equal? (twice-x m) 6)
  (check-equal? ((d/dx twice-x) m) 2)
  (check-identity (+ zero-manifold-function twice-x) (* 2 x))
  (check-true (refuted? (+ zero-manifold-function twice-x) (* 6 x)))
  (check-identity (d/dx ((pullback (lambda (m) ((point R2-rect) (up (twice-x m) (y m))))) x)) 2))

(test-case "components given by a function of coordinates"
  (define v (components->vector-field (lambda (q) (up (twice-x ((point R2-rect) q)) 0)) R2-rect))
  (check-identity (v x) (* 2 x)))

(define mu (literal-manifold-map 'mu R2-rect R2-rect))
(define along (vector-field->vector-field-over-map mu))
(define w (literal-1form-field 'w R2-rect))
(define v (literal-vector-field 'v R2-rect))
(define w/mu ((form-field->form-field-over-map mu) w))
(define star (Hodge-star g basis))

(test-case "Hodge's star and traces over a map are those at the points of the map"
  (define somewhere ((point R2-rect) (up 'a 'b)))
  (check-identity (((star w/mu) (along v)) somewhere) (((star w) v) (mu somewhere)))
  (check-identity (((trace2down g basis) ((form-field->form-field-over-map mu) g)) somewhere) 2))

(define-coordinates (up X Y Z) R3-rect)
(define gamma (literal-manifold-map 'gamma R1-rect S2-spherical))
(define at-0 ((point R1-rect) 0))

(says
 [((codifferential g basis) w/mu)
  "codifferential: expected a field on a manifold; this one is over a map\n"
  "  given: ((form-field->form-field-over-map mu) w), a 1-form over a map"]
 [((divergence g basis) (along v))
  "divergence: expected a field on a manifold; this one is over a map\n"
  "  given: ((vector-field->vector-field-over-map mu) v), a vector field over a map"]
 [((pullback (lambda (m) m)) w/mu)
  "pullback: expected a field on a manifold; this one is over a map\n"
  "  given: ((form-field->form-field-over-map mu) w), a 1-form over a map"]
 [(((pullback gamma) X) at-0)
  "geometry: these live on different manifolds, R3 and S2\n  given: (R3-rect S2-spherical)"]
 [((((differential gamma) d/dt) X) at-0)
  "geometry: these live on different manifolds, R3 and S2\n  given: (R3-rect S2-spherical)"])

(test-case "what is made of fields over a map is over it"
  (define w2/mu ((form-field->form-field-over-map mu) (wedge w dx)))
  (define R (Riemann-curvature (covariant-derivative (literal-Cartan 'G R2-rect))))
  (define (refused make field) (message-of ((make g basis) field)))
  (check-regexp-match #rx"one is over a map\n.*, a 1-form over a map$"
                      (refused codifferential ((interior-product (along v)) w2/mu)))
  (check-regexp-match #rx"^divergence: expected a field on a manifold; this one is over a map\n"
                      (refused divergence ((R (along v) (along v)) (along v))))
  (define elsewhere
    ((vector-field->vector-field-over-map (literal-manifold-map 'nu R2-rect R2-rect)) v))
  (check-regexp-match #rx"^Riemann-curvature: these are over different maps\n  maps: "
                      (message-of ((R (along v) elsewhere) (along v)))))

;; dr² + (r − 1)² dφ², of which the area is |r − 1|
(test-case "an area is positive on either side of where it is 0"
  (define-coordinates (up r phi) R2-polar)
  (define h
    (make-metric (lambda (u v) (+ (* (dr u) (dr v)) (* (square (- r 1)) (dphi u) (dphi v))))
                 R2-polar))
  (define area
    (((Hodge-star h (coordinate-system->basis R2-polar)) (+ 1 zero-manifold-function))
     d/dr d/dphi))
  (for ([at '(1/2 4)] [expected '(1/2 3)])
    (check-equal? (area ((point R2-polar) (up at 0))) expected)))

(test-case "the components in a chart go with it"
  (define (frame) (make-SR-frame 'moving the-ether (up 1 0 0) 3/5 (up 0 0 0 0)))
  (define kept
    (for/list ([_ 5])
      (define C (frame))
      (define u (components->vector-field (up 1 0 0 0) C))
      (check-identity ((SR-metric u u) ((point C) (up 0 0 0 0))) -1)
      (make-weak-box (coordinate-system-symbols C))))
  (collect-garbage)
  (collect-garbage)
  (check-true (< (for/sum ([b kept]) (if (weak-box-value b) 1 0)) 2)))
