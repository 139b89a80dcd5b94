#lang racket/base
;; Vector calculus by Hodge's star (FDG, chapter 10, first part): gradient, curl, divergence and
;; Laplacian in spherical coordinates, on an orthonormal basis; the star in three dimensions;
;; and the same operators on functions of rectangular coordinates.

(require mechanics mechanics/geometry
         "../../support/checks.rkt" "../../support/messages.rkt" "../../support/session.rkt")

(define-coordinates (up r theta phi) R3-spherical)
(define spherical-point ((point R3-spherical) (up 'r 'theta 'phi)))
(define here '(up r theta phi))
(define (slope i f) `(((partial ,i) ,f) ,here))

(define spherical-metric
  (make-metric (lambda (u v)
                 (+ (* (dr u) (dr v))
                    (* (square r) (+ (* (dtheta u) (dtheta v))
                                     (* (square (sin theta)) (dphi u) (dphi v))))))))

(define spherical-basis (coordinate-system->basis R3-spherical))
(define e_0 d/dr)
(define e_1 (* (/ 1 r) d/dtheta))
(define e_2 (* (/ 1 (* r (sin theta))) d/dphi))
(define orthonormal-vectors (down e_0 e_1 e_2))
(define orthonormal-1forms (vector-basis->dual orthonormal-vectors R3-spherical))
(define orthonormal-basis (make-basis orthonormal-vectors orthonormal-1forms))

(define f (literal-manifold-function 'f R3-spherical))
(define (component-function k)
  (literal-manifold-function (string->symbol (format "v^~a" k)) R3-spherical))
(define v
  (+ (* (component-function 0) e_0) (* (component-function 1) e_1) (* (component-function 2) e_2)))

(define (components v) ((orthonormal-1forms v) spherical-point))

;; ---------------------------------------------------------------------------

(test-case "the metric is the one of space"
  (check-identity spherical-metric (coordinate-system->metric R3-spherical)))

(test-case "the orthonormal 1-forms"
  (check-identity (ref orthonormal-1forms 1) (* r dtheta))
  (check-identity (ref orthonormal-1forms 2) (* r (sin theta) dphi)))

(test-case "gradient"
  (check-prints (components ((gradient spherical-metric spherical-basis) f))
                `(up ,(slope 0 'f)
                     (/ ,(slope 1 'f) r)
                     (/ ,(slope 2 'f) (* r (sin theta))))))

(define (v^ k) (list (string->symbol (format "v^~a" k)) here))
(define (dv i k) (slope i (string->symbol (format "v^~a" k))))
(define r*sine '(* r (sin theta)))

(test-case "curl"
  (check-prints (components ((curl spherical-metric orthonormal-basis) v))
                `(up (+ (/ ,(dv 1 2) r)
                        (/ (- (* (cos theta) ,(v^ 2)) ,(dv 2 1)) ,r*sine))
                     (+ (/ ,(dv 2 0) ,r*sine)
                        (/ (* -1 ,(v^ 2)) r)
                        (* -1 ,(dv 0 2)))
                     (+ ,(dv 0 1)
                        (/ ,(v^ 1) r)
                        (/ (* -1 ,(dv 1 0)) r)))))

(test-case "divergence"
  (check-prints (((divergence spherical-metric orthonormal-basis) v) spherical-point)
                `(+ ,(dv 0 0)
                    (/ (* 2 ,(v^ 0)) r)
                    (/ ,(dv 1 1) r)
                    (/ (+ (* (cos theta) ,(v^ 1)) ,(dv 2 2)) ,r*sine))))

(test-case "Laplacian"
  (define (second i) `(((expt (partial ,i) 2) f) ,here))
  (check-prints (((Laplacian spherical-metric orthonormal-basis) f) spherical-point)
                `(+ ,(second 0)
                    (/ (* 2 ,(slope 0 'f)) r)
                    (/ ,(second 1) (expt r 2))
                    (/ (* (cos theta) ,(slope 1 'f)) (* (expt r 2) (sin theta)))
                    (/ ,(second 2) (* (expt r 2) (expt (sin theta) 2))))))

(test-case "a gradient has no curl, a curl no divergence, whatever the basis"
  (for ([basis (list spherical-basis orthonormal-basis)])
    (check-identity ((curl spherical-metric basis) ((gradient spherical-metric basis) f)) 0)
    (check-identity ((divergence spherical-metric basis) ((curl spherical-metric basis) v)) 0)))

;; ---------------------------------------------------------------------------
;; The star

(define-coordinates (up x y z) R3-rect)
(define E3-basis (coordinate-system->basis R3-rect))
(define E3-metric (coordinate-system->metric R3-rect))
(define E3-star (Hodge-star E3-metric E3-basis))
(define g (literal-manifold-function 'g R3-rect))
(define a (literal-manifold-function 'a R3-rect))
(define b (literal-manifold-function 'b R3-rect))

(test-case "the star of functions and forms in space"
  (check-identity (E3-star g) (* g (wedge dx dy dz)))
  (check-identity (E3-star (+ (* g dx) (* a dy) (* b dz)))
                  (+ (* g (wedge dy dz)) (* a (wedge dz dx)) (* b (wedge dx dy))))
  (check-identity (E3-star (+ (* g (wedge dx dy)) (* a (wedge dy dz)) (* b (wedge dz dx))))
                  (+ (* g dz) (* a dx) (* b dy)))
  (check-identity (E3-star (wedge dx dy dz)) 1)
  (check-identity (E3-star dr) (* (square r) (sin theta) (wedge dtheta dphi))))

(test-case "the star twice is the form again"
  (for ([w (list dr (wedge dtheta dphi) (+ dx (* x dtheta)))])
    (check-identity (E3-star (E3-star w)) w)))

(test-case "the Laplacian is the star of d of the star of d"
  (check-identity (E3-star (d (E3-star (d g)))) ((Laplacian E3-metric E3-basis) g)))

;; ---------------------------------------------------------------------------
;; On functions of rectangular coordinates

(define F (apply up (for/list ([name '(F_x F_y F_z)])
                      (literal-function name '(-> (UP Real Real Real) Real)))))
(define G (literal-function 'G '(-> (UP Real Real Real) Real)))
(define q (up 'x 'y 'z))

(test-case "gradient, curl, divergence and Laplacian are those of fields in space"
  (define ((of-place f) m) (f ((chart R3-rect) m)))
  (define field (components->vector-field F R3-rect))
  (define (components v) ((vector-field->components v R3-rect) q))
  (check-identity ((Grad G) q) (components ((gradient E3-metric E3-basis) (of-place G))))
  (check-identity ((Curl F) q) (components ((curl E3-metric E3-basis) field)))
  (define m ((point R3-rect) q))
  (check-identity ((Div F) q) (((divergence E3-metric E3-basis) field) m))
  (check-identity ((Lap G) q) (((Laplacian E3-metric E3-basis) (of-place G)) m)))

;; ---------------------------------------------------------------------------

(says
 [(Hodge-star dx E3-basis)
  "volume-form: expected a metric, a tensor of two vectors\n  given: dx, a 1-form"]
 [(E3-star d/dx)
  "Hodge-star: expected a form, or a function on the manifold\n  given: d/dx, a vector field"]
 [((curl (coordinate-system->metric R2-rect) (coordinate-system->basis R2-rect))
   (literal-vector-field 'v R2-rect))
  "curl: the curl is a vector field in 3 dimensions only; this basis has 2"]
 [((divergence E3-metric E3-basis) dx)
  "divergence: expected a vector field\n  given: dx, a 1-form"])
