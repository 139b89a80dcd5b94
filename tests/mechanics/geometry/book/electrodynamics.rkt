#lang racket/base
;; Electrodynamics by forms (FDG, chapter 10): Faraday's and Maxwell's forms of unknown fields,
;; Maxwell's equations, the force of Lorentz; and fields as other observers measure them.

(require mechanics mechanics/geometry
         "../../support/checks.rkt" "../../support/messages.rkt" "../../support/session.rkt")

(define-coordinates (up ct x y z) SR)
(define an-event ((point SR) (up 'ct0 'x0 'y0 'z0)))
(define there '(up ct0 x0 y0 z0))
(define (slope i f) `(((partial ,i) ,f) ,there))

(define (unknown name) (literal-manifold-function name SR))
(define fields (map unknown '(Ex Ey Ez Bx By Bz)))
(define F (apply Faraday fields))
(define J (four-current (unknown 'rho) (unknown 'Ix) (unknown 'Iy) (unknown 'Iz) #:c 'c))

;; ---------------------------------------------------------------------------
;; Forms

(test-case "the metric"
  (check-identity SR-metric
                  (make-metric (lambda (u v)
                                 (+ (* -1 (dct u) (dct v))
                                    (* (dx u) (dx v)) (* (dy u) (dy v)) (* (dz u) (dz v)))))))

(test-case "Faraday's form"
  (define-values (Ex Ey Ez Bx By Bz) (apply values fields))
  (check-identity F (+ (* Ex (wedge dx dct)) (* Ey (wedge dy dct)) (* Ez (wedge dz dct))
                       (* Bx (wedge dy dz)) (* By (wedge dz dx)) (* Bz (wedge dx dy)))))

(test-case "its star is Maxwell's form"
  (check-identity (SR-star F) (apply Maxwell fields)))

(test-case "the star twice changes the sign of forms of even rank"
  (check-identity (SR-star (SR-star F)) (* -1 F))
  (check-identity (SR-star (SR-star J)) J))

;; ---------------------------------------------------------------------------
;; Maxwell's equations

(define (of-event w . vectors) ((apply w vectors) an-event))

(test-case "d F = 0: there are no magnetic charges, and the law of induction"
  (check-prints (of-event (d F) d/dx d/dy d/dz)
                `(+ ,(slope 1 'Bx) ,(slope 2 'By) ,(slope 3 'Bz)))
  (check-prints (of-event (d F) d/dct d/dy d/dz)
                `(+ ,(slope 0 'Bx) ,(slope 2 'Ez) (* -1 ,(slope 3 'Ey))))
  (check-prints (of-event (d F) d/dct d/dz d/dx)
                `(+ ,(slope 0 'By) ,(slope 3 'Ex) (* -1 ,(slope 1 'Ez))))
  (check-prints (of-event (d F) d/dct d/dx d/dy)
                `(+ ,(slope 0 'Bz) ,(slope 1 'Ey) (* -1 ,(slope 2 'Ex)))))

(test-case "d *F = 4 pi *J: the laws of Gauss and of Ampère and Maxwell"
  (define law (- (d (SR-star F)) (* 4 ':pi (SR-star J))))
  (check-prints (of-event law d/dx d/dy d/dz)
                `(+ ,(slope 1 'Ex) ,(slope 2 'Ey) ,(slope 3 'Ez) (* -4 :pi (rho ,there))))
  (check-prints (of-event law d/dct d/dy d/dz)
                `(+ ,(slope 0 'Ex) ,(slope 3 'By) (* -1 ,(slope 2 'Bz))
                    (/ (* 4 :pi (Ix ,there)) c)))
  (check-prints (of-event law d/dct d/dz d/dx)
                `(+ ,(slope 0 'Ey) ,(slope 1 'Bz) (* -1 ,(slope 3 'Bx))
                    (/ (* 4 :pi (Iy ,there)) c)))
  (check-prints (of-event law d/dct d/dx d/dy)
                `(+ ,(slope 0 'Ez) ,(slope 2 'Bx) (* -1 ,(slope 1 'By))
                    (/ (* 4 :pi (Iz ,there)) c))))

(test-case "a verdict names each of the four equations once"
  (check-equal? (regexp-match* #rx"component [0-9 ]+" (format "~a" (verify-equal (d F) 0)))
                '("component 0 1 2" "component 0 1 3" "component 0 2 3" "component 1 2 3")))

(test-case "charge is kept: d *J = 0 is the equation of continuity"
  (check-prints (of-event (d (SR-star J)) d/dct d/dx d/dy d/dz)
                `(+ ,(slope 0 'rho)
                    (/ ,(slope 1 'Ix) c) (/ ,(slope 2 'Iy) c) (/ ,(slope 3 'Iz) c))))

(test-case "the field of any potential satisfies d F = 0"
  (define A (literal-1form-field 'A SR))
  (check-identity (d (d A)) 0)
  (check-identity (ref (electric-field (d A)) 0)
                  (- (d/dx (A d/dct)) (d/dct (A d/dx)))))

(define (wave E2 B3) (Faraday 0 E2 0 0 0 B3))

(test-case "a wave along x satisfies both, and not with fields out of proportion"
  (define f (compose (literal-function 'f) (- x ct)))
  (check-identity (d (wave f f)) 0)
  (check-identity (d (SR-star (wave f f))) 0)
  (check-pred refuted? (verify-equal (d (wave f (* 2 f))) 0))
  (check-pred refuted? (verify-equal (d (SR-star (wave f (- f)))) 0)))

(test-case "the field of a charge at rest: no charge elsewhere"
  (define r^3 (expt (+ (square x) (square y) (square z)) 3/2))
  (define Coulomb (Faraday (/ x r^3) (/ y r^3) (/ z r^3) 0 0 0))
  (check-identity (d Coulomb) 0)
  (check-identity (d (SR-star Coulomb)) 0)
  (define wrong (Faraday (/ x r^3) (/ y r^3) (/ (* 2 z) r^3) 0 0 0))
  (check-pred refuted? (verify-equal (d (SR-star wrong)) 0)))

;; ---------------------------------------------------------------------------
;; The force of Lorentz

(define constant (Faraday 'Ex 'Ey 'Ez 'Bx 'By 'Bz))

(define (velocity beta)
  (define gamma (/ 1 (sqrt (- 1 (square beta)))))
  (+ (* gamma d/dct) (* gamma beta d/dx)))

(define (force u component) ((Lorentz-force 'q constant u component) an-event))

(test-case "on a charge at rest"
  (check-prints (force d/dct dx) '(* Ex q))
  (check-prints (force d/dct dy) '(* Ey q))
  (check-prints (force d/dct dct) 0))

(test-case "on one that moves along x"
  (define root '(sqrt (- 1 (expt v/c 2))))
  (check-prints (force (velocity 'v/c) dx) `(/ (* Ex q) ,root))
  (check-prints (force (velocity 'v/c) dy) `(/ (* q (- Ey (* Bz v/c))) ,root))
  (check-prints (force (velocity 'v/c) dz) `(/ (* q (+ (* By v/c) Ez)) ,root))
  (check-prints (force (velocity 'v/c) dct) `(/ (* Ex q v/c) ,root)))

;; ---------------------------------------------------------------------------
;; Other observers

(define (frame n v/c)
  (make-SR-frame 'A the-ether n v/c (make-SR-coordinates the-ether (up 0 0 0 0))))

(test-case "the fields as an observer measures them who moves along x"
  (define A (frame (up 1 0 0) 'v))
  (define root '(sqrt (- 1 (expt v 2))))
  (check-prints ((electric-field constant A) an-event)
                `(up Ex (/ (- Ey (* Bz v)) ,root) (/ (+ (* By v) Ez) ,root)))
  (check-prints ((magnetic-field constant A) an-event)
                `(up Bx (/ (+ By (* Ez v)) ,root) (/ (- Bz (* Ey v)) ,root))))

;; E′ = γ (E + β × B) − (γ − 1) n (n·E),  B′ = γ (B − β × E) − (γ − 1) n (n·B)
(test-case "and in any direction"
  (define n (up 2/7 3/7 6/7))
  (define A (frame n 'v))
  (define gamma (/ 1 (sqrt (- 1 (square 'v)))))
  (define-values (E B) (values (up 'Ex 'Ey 'Ez) (up 'Bx 'By 'Bz)))
  (define (boosted X other) (- (* gamma (+ X (* 'v (cross-product n other))))
                               (* (- gamma 1) (dot-product n X) n)))
  (check-identity ((electric-field constant A) an-event) (boosted E B))
  (check-identity ((magnetic-field constant A) an-event) (boosted B (* -1 E))))

(test-case "a boost pulls the form back to the one that is measured"
  (define beta (up 'u 'v 'w))
  (define boosted
    ((pullback (compose (point SR) (general-boost beta) (chart SR))) F))
  (define A (frame (up 1 0 0) 'u))
  (define along-x ((pullback (compose (point SR) (general-boost (up 'u 0 0)) (chart SR))) constant))
  (check-identity ((electric-field along-x) an-event) ((electric-field constant A) an-event))
  (check-identity ((magnetic-field along-x) an-event) ((magnetic-field constant A) an-event))
  (check-identity (SR-star boosted)
                  ((pullback (compose (point SR) (general-boost beta) (chart SR))) (SR-star F))))

(test-case "fields given in a frame are measured there, and E^2 - B^2 and E B by all alike"
  (define A (frame (up 0 3/5 4/5) 'v))
  (define F (Faraday 'Ex 'Ey 'Ez 'Bx 'By 'Bz #:in A))
  (check-prints ((electric-field F A) an-event) '(up Ex Ey Ez))
  (check-prints ((magnetic-field F A) an-event) '(up Bx By Bz))
  (define-values (E B) (values ((electric-field F) an-event) ((magnetic-field F) an-event)))
  (check-identity (dot-product E B) (dot-product (up 'Ex 'Ey 'Ez) (up 'Bx 'By 'Bz)))
  (check-identity (- (square E) (square B))
                  (- (square (up 'Ex 'Ey 'Ez)) (square (up 'Bx 'By 'Bz)))))

(test-case "the field of a charge in motion satisfies Maxwell's equations"
  (define A (frame (up 1 0 0) 'v))
  (let-coordinates ([(up ct x y z) A])
    (define r^3 (expt (+ (square x) (square y) (square z)) 3/2))
    (define Coulomb (Faraday (/ x r^3) (/ y r^3) (/ z r^3) 0 0 0 #:in A))
    (check-identity (d Coulomb) 0)
    (check-identity (d (SR-star Coulomb)) 0)
    ;; It is γ times as strong across the way as at rest.
    (check-identity ((ref (electric-field Coulomb) 1) ((point SR) (up 0 0 'r 0)))
                    (/ 1 (sqrt (- 1 (square 'v))) (square 'r) (sgn 'r)))))

(test-case "current and charge in another frame"
  (define A (frame (up 1 0 0) 'v))
  (define at-rest (four-current 'rho 0 0 0 #:in A))
  (check-identity ((at-rest d/dct) an-event) (/ (- 'rho) (sqrt (- 1 (square 'v)))))
  (check-identity (four-current 'rho 'Ix 'Iy 'Iz) (four-current 'rho 'Ix 'Iy 'Iz #:c 1))
  (check-identity ((at-rest d/dx) an-event) (/ (* 'rho 'v) (sqrt (- 1 (square 'v))))))

;; ---------------------------------------------------------------------------

(says
 [(Faraday 1 0 0 0 0 0 #:in R3-rect)
  "Faraday: expected a frame, a chart of R4; this is one of R3\n  given: R3-rect"]
 [(four-current 1 0 0 0 #:in 'A)
  "four-current: expected a coordinate system, such as R3-rect\n  given: the symbol A"]
 [(electric-field dx)
  "electric-field: expected a 2-form, such as Faraday gives\n  given: dx, a 1-form"]
 [(magnetic-field constant S2-spherical)
  "magnetic-field: expected a frame, a chart of R4; this is one of S2\n  given: S2-spherical"]
 [(Lorentz-force 'q dct d/dct dx)
  "Lorentz-force: expected a 2-form, such as Faraday gives\n  given: dct, a 1-form"]
 [(Lorentz-force 'q constant d/dct d/dx)
  "raise: expected a 1-form\n  given: d/dx, a vector field"])
