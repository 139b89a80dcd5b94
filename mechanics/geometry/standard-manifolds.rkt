#lang racket/base
;; The manifolds and charts that have names: spaces, spheres, rotations, spacetime.
;;
;; Rⁿ is its own place.  Sⁿ lies in Rⁿ⁺¹ as the vectors of length 1; SO(3) among the matrices.

(require (only-in racket/list drop drop-right last take)
         "manifold-chart.rkt"
         "../generic/arithmetic.rkt" "../generic/elementary.rkt" "../generic/sums-and-products.rkt"
         "../generic/up-down.rkt"
         "../rigid/rotation.rkt"
         "../value/matrix/matrix.rkt")

(provide R^n S^n S2-type (rename-out [S2-type S^2-type]) SO3-type
         R1 R2 R3 R4 S1 S2 S3 SO3 spacetime
         R1-rect the-real-line R2-rect R2-polar R3-rect R3-cyl R3-spherical R4-rect R4-cyl
         S1-circular S1-tilted
         S2-spherical S2-tilted S2-stereographic S2-Riemann S2-gnomonic
         S3-spherical S3-tilted S3-stereographic
         Euler-angles alternate-angles spacetime-rect spacetime-sphere)

(define (list-of x) (if (tuple? x) (vector->list (tuple-elements x)) (list x)))
(define (tuple-of xs) (coordinate-tuple (list->vector xs)))
(define (length-of xs) (g:sqrt (g:for/sum ([x (in-list xs)]) (g:square x))))

;; A system for manifolds of the type, at the patch, of one of the dimensions (#f: any): the same
;; two maps between lists for all of them, and the values that are positive.
(define (attach name patch type dimensions to from names [positive (lambda (x) '())])
  (define ((on-tuples f) n) (lambda (x) (tuple-of (f (list-of x)))))
  (attach-coordinate-system name patch type (on-tuples to) (on-tuples from)
                            #:dimensions dimensions #:names names
                            #:positive (lambda (n) (lambda (x) (positive (list-of x))))))

(define ((first-of names) n) (take names n))

;; ---------------------------------------------------------------------------
;; Rⁿ

(define R^n (make-manifold-type 'R^n 'origin))

(define (rectangular-names n)
  (case n
    [(1) '(t)]
    [(2 3) (take '(x y z) n)]
    [else (for/list ([k (in-range n)]) (string->symbol (format "x~a" k)))]))

(attach 'rectangular 'origin R^n #f values values rectangular-names)

(define (polar->place x)
  (list* (g:* (car x) (g:cos (cadr x))) (g:* (car x) (g:sin (cadr x))) (cddr x)))

(define (place->polar x)
  (list* (length-of (take x 2)) (g:atan (cadr x) (car x)) (cddr x)))

(attach 'polar/cylindrical 'origin R^n '(2 3 4) polar->place place->polar
        (first-of '(r theta z w)) (lambda (x) (list (car x))))

;; r, the colatitude θ and the longitude φ
(define (spherical->place x)
  (for/list ([u (in-list (angles->unit (cdr x)))]) (g:* (car x) u)))

(define (place->spherical x)
  (define r (length-of x))
  (list r (g:acos (g:/ (caddr x) r)) (g:atan (cadr x) (car x))))

(define (radius-and-sine x) (list (car x) (g:sin (cadr x))))

(attach 'spherical/polar 'origin R^n '(3) spherical->place place->spherical
        (first-of '(r theta phi)) radius-and-sine)

;; Beside the time
(attach 'spacetime-rectangular 'origin R^n '(4) values values (first-of '(t x y z)))

(attach 'spacetime-spherical 'origin R^n '(4)
        (lambda (x) (cons (car x) (spherical->place (cdr x))))
        (lambda (x) (cons (car x) (place->spherical (cdr x))))
        (first-of '(t r theta phi)) (lambda (x) (radius-and-sine (cdr x))))

;; ---------------------------------------------------------------------------
;; Spheres.  Colatitudes first, the longitude last: the point of S² at (θ, φ) is
;; (sin θ cos φ, sin θ sin φ, cos θ), and the last place of Sⁿ is the cosine of the first angle.

(define S^n (make-manifold-type 'S^n 'north-pole 'south-pole 'tilted))

(define (angles->unit angles)
  (define s (g:sin (car angles)))
  (define c (g:cos (car angles)))
  (if (null? (cdr angles))
      (list c s)
      (append (for/list ([u (in-list (angles->unit (cdr angles)))]) (g:* s u)) (list c))))

(define (unit->angles u)
  (define n (sub1 (length u)))
  (if (= n 1)
      (list (g:atan (cadr u) (car u)))
      (let ([others (take u n)])
        (cons (g:atan (length-of others) (list-ref u n)) (unit->angles others)))))

(define (sphere-names n)
  (case n
    [(1) '(theta)]
    [(2 3) (drop '(psi theta phi) (- 3 n))]
    [else (for/list ([k (in-range n)]) (string->symbol (format "theta~a" k)))]))

;; The sines of colatitudes
(define (sines x) (map g:sin (drop-right x 1)))

(attach 'spherical 'north-pole S^n #f angles->unit unit->angles sphere-names sines)

;; The axis of the angles lies along the first axis of space.
(define (turned u) (cons (last u) (drop-right u 1)))
(define (turned-back u) (append (drop u 1) (take u 1)))

(attach 'spherical 'tilted S^n #f
        (lambda (x) (turned (angles->unit x))) (lambda (u) (unit->angles (turned-back u)))
        sphere-names sines)

;; From a pole onto the plane of the equator.  sign : of the pole's last place
(define ((stereographic->unit sign) x)
  (define r^2 (g:for/sum ([a (in-list x)]) (g:square a)))
  (define d (g:+ 1 r^2))
  (append (for/list ([a (in-list x)]) (g:/ (g:* 2 a) d))
          (list (g:* sign (g:/ (g:- r^2 1) d)))))

(define ((unit->stereographic sign) u)
  (define n (sub1 (length u)))
  (define d (g:- 1 (g:* sign (list-ref u n))))
  (for/list ([a (in-list (take u n))]) (g:/ a d)))

(for ([pole (in-list '(north-pole south-pole))] [sign (in-list '(1 -1))])
  (attach 'stereographic pole S^n #f
          (stereographic->unit sign) (unit->stereographic sign) rectangular-names))

;; From the centre onto the plane that touches the sphere at the north pole: great circles become
;; lines.  Half of the sphere has such coordinates.
(attach 'gnomonic 'north-pole S^n #f
        (lambda (x)
          (define d (length-of (cons 1 x)))
          (append (for/list ([a (in-list x)]) (g:/ a d)) (list (g:/ 1 d))))
        (lambda (u)
          (define height (last u))      ; 0 divides by 0: outside the chart
          (define z (if (and (real? height) (<= height 0)) 0 height))
          (for/list ([a (in-list (drop-right u 1))]) (g:/ a z)))
        rectangular-names)

(define S2-type S^n)

;; ---------------------------------------------------------------------------
;; Rotations.  Euler's angles (θ, φ, ψ) give Rz(φ) Rx(θ) Rz(ψ), singular at θ = 0; the other ones
;; Rz(φ) Rx(θ) Ry(ψ), singular at θ = ±π/2.

(define SO3-type (make-manifold-type 'SO3 'Euler-patch 'alternate-patch))

(define (attach-angles name patch last-turn read positive)
  (attach-coordinate-system
   name patch SO3-type
   (lambda (n)
     (lambda (x)
       (define-values (theta phi psi) (apply values (list-of x)))
       (g:* (rotate-z-matrix phi) (g:* (rotate-x-matrix theta) (last-turn psi)))))
   (lambda (n) (lambda (M) (read (lambda (i j) (matrix-ref M i j)))))
   #:dimensions '(3) #:names (first-of '(theta phi psi))
   #:positive (lambda (n) (lambda (x) (list (positive (car (list-of x))))))))

(attach-angles 'Euler 'Euler-patch rotate-z-matrix
               (lambda (M)
                 (up (g:acos (M 2 2)) (g:atan (M 0 2) (g:negate (M 1 2)))
                     (g:atan (M 2 0) (M 2 1))))
               g:sin)

(attach-angles 'alternate 'alternate-patch rotate-y-matrix
               (lambda (M)
                 (up (g:asin (M 2 1)) (g:atan (g:negate (M 0 1)) (M 1 1))
                     (g:atan (g:negate (M 2 0)) (M 2 2))))
               g:cos)

;; ---------------------------------------------------------------------------
;; Named manifolds

(define-syntax-rule (define-manifold manifold (type n) [chart system patch] ...)
  (begin (define manifold (make-manifold type n 'manifold))
         (define chart (coordinate-system-at 'system 'patch manifold 'chart)) ...))

(define-manifold R1 (R^n 1) [R1-rect rectangular origin])
(define the-real-line R1-rect)
(define-manifold R2 (R^n 2) [R2-rect rectangular origin] [R2-polar polar/cylindrical origin])
(define-manifold R3 (R^n 3)
  [R3-rect rectangular origin] [R3-cyl polar/cylindrical origin]
  [R3-spherical spherical/polar origin])
(define-manifold R4 (R^n 4) [R4-rect rectangular origin] [R4-cyl polar/cylindrical origin])
(define-manifold spacetime (R^n 4)
  [spacetime-rect spacetime-rectangular origin] [spacetime-sphere spacetime-spherical origin])
(define-manifold S1 (S^n 1) [S1-circular spherical north-pole] [S1-tilted spherical tilted])
(define-manifold S2 (S^n 2)
  [S2-spherical spherical north-pole] [S2-tilted spherical tilted]
  [S2-stereographic stereographic north-pole] [S2-gnomonic gnomonic north-pole])
(define S2-Riemann S2-stereographic)
(define-manifold S3 (S^n 3)
  [S3-spherical spherical north-pole] [S3-tilted spherical tilted]
  [S3-stereographic stereographic north-pole])
(define-manifold SO3 (SO3-type 3)
  [Euler-angles Euler Euler-patch] [alternate-angles alternate alternate-patch])
