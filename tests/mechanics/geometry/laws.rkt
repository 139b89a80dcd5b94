#lang racket/base
;; Laws that hold on every manifold and in every chart, for literal fields: proved; and what is
;; computed in two charts of a manifold agrees at seeded points.

(require mechanics
         mechanics/geometry
         "../support/checks.rkt" "../support/close.rkt"
         "../support/random.rkt"
         "../support/same.rkt" "../support/session.rkt"
         "../support/standard-charts.rkt")

(define all-charts (map entry-chart (apply append standard-charts)))

;; (for-charts "law" C body ...): a test case for each chart
(define-syntax-rule (for-charts law (C charts) body ...)
  (for ([C (in-list charts)])
    (test-case (format "~a, on ~a" law C) body ...)))

(define (at-most n) (filter (lambda (C) (<= (coordinate-system-dimension C) n)) all-charts))

(define (vectors C . names) (apply values (for/list ([n names]) (literal-vector-field n C))))
(define (forms C . names) (apply values (for/list ([n names]) (literal-1form-field n C))))
(define (functions C . names) (apply values (for/list ([n names]) (literal-manifold-function n C))))

;; ---------------------------------------------------------------------------
;; Vector fields

(for-charts "a vector field is a derivation" (C all-charts)
  (define-values (f g) (functions C 'f 'g))
  (define-values (X Y) (vectors C 'X 'Y))
  (check-identity (X (* f g)) (+ (* f (X g)) (* g (X f))))
  (check-identity ((+ X (* f Y)) g) (+ (X g) (* f (Y g))))
  (check-identity ((+ 0 X) g) (X g))
  (check-identity ((- 0 X) g) (- (X g)))
  (check-identity (X 3) 0))

(for-charts "brackets: antisymmetric, a derivation, Jacobi" (C (at-most 3))
  (define-values (X Y Z) (vectors C 'X 'Y 'Z))
  (define-values (f) (functions C 'f))
  (check-identity (commutator X Y) (- (commutator Y X)))
  (check-identity ((commutator X Y) f) (- (X (Y f)) (Y (X f))))
  (check-identity (commutator X (* f Y)) (+ (* f (commutator X Y)) (* (X f) Y)))
  (check-identity (+ (commutator X (commutator Y Z)) (commutator Y (commutator Z X))
                     (commutator Z (commutator X Y)))
                  0))

;; ---------------------------------------------------------------------------
;; Forms

(for-charts "products of forms" (C all-charts)
  (define-values (a b c) (forms C 'a 'b 'c))
  (define-values (X) (vectors C 'X))
  (check-identity (wedge a b) (- (wedge b a)))
  (check-identity (wedge a (wedge b c)) (wedge (wedge a b) c))
  (check-identity ((interior-product X) (wedge a b)) (- (* (a X) b) (* (b X) a)))
  (check-identity ((interior-product X) ((interior-product X) (wedge a b))) 0))

(test-case "a function is a form of rank 0; Alt of a product of 1-forms is their wedge, over n!"
  (define-values (f g) (functions R3-cyl 'f 'g))
  (define-values (a b c) (forms R3-cyl 'a 'b 'c))
  (check-identity (wedge f g) (* f g))
  (check-identity (wedge f a) (* f a))
  (check-identity (wedge a f) (* f a))
  (define (product . ws)
    (with-argument-types (lambda vs (for/fold ([p 1]) ([w ws] [v vs]) (* p (w v))))
                         (map (lambda (w) 'vector) ws) R3-cyl))
  (check-identity (Alt (product a b)) (* 1/2 (wedge a b)))
  (check-identity (Alt (product a b c)) (* 1/6 (wedge a b c))))

(define-coordinates (up r theta phi) R3-spherical)
(define space (coordinate-system->metric R3-spherical))
(define space-basis (coordinate-system->basis R3-spherical))

;; As the form of volume of the chart prints, at a point of it
(define (printed-volume volume C)
  (define es (structure->list (coordinate-system->vector-basis C)))
  (format "~a" (simplify ((apply volume es) (typical-point C)))))

(test-case "radius and sine of the colatitude are positive: no absolute values in volumes"
  (define star (Hodge-star space space-basis))
  (check-identity (star dr) (* (square r) (sin theta) (wedge dtheta dphi)))
  (check-identity ((curl space space-basis) (* (/ 1 (square r)) d/dphi))
                  (* 2 (/ (cos theta) (square r)) d/dr))
  (check-identity (ref (orthonormalize (basis->vector-basis space-basis) space R3-spherical) 2)
                  (* (/ 1 (* r (sin theta))) d/dphi))
  (for ([C (list R2-polar R3-cyl R3-spherical R4-cyl S2-spherical S2-tilted S3-spherical
                 Euler-angles alternate-angles)])
    (define volume (volume-form (coordinate-system->metric C) (coordinate-system->basis C)))
    (check-false (regexp-match? #rx"abs" (printed-volume volume C)))))

(test-case "a proof in a chart says what is positive there"
  (define volume (volume-form space space-basis))
  (define proof (verify-equal volume (* (square r) (sin theta) (wedge dr dtheta dphi))))
  (check-true (proved? proof))
  (check-equal? (verdict-assumptions proof) '((> r 0) (> (sin theta) 0)))
  (check-equal? (verdict-assumptions (verify-equal (sqrt (square r)) r))
                '((> r 0) (> (sin theta) 0))))

(test-case "a point whose numbers have other signs is told by those of its chart"
  (define m ((point R3-spherical) (up -2 1 0.5)))
  (check-close ((chart R3-spherical) m) (list 2 (- pi 1) (- 0.5 pi)) 1e-12)
  (define same ((point R3-spherical) (up 2 (- pi 1) (- 0.5 pi))))
  (check-close ((chart R3-rect) m) ((chart R3-rect) same) 1e-12)
  (check-close ((chart S2-spherical) ((point S2-spherical) (up -0.5 0))) (list 0.5 pi) 1e-12))

(test-case "a metric is pulled back by an embedding"
  (define-coordinates (up u v) R2-rect)
  (define-coordinates (up x y z) R3-rect)
  (define (torus m)
    (define-values (a b) (values (u m) (v m)))
    ((point R3-rect) (up (* (+ 'R (* 'r (cos a))) (cos b)) (* (+ 'R (* 'r (cos a))) (sin b))
                         (* 'r (sin a)))))
  (define g ((pullback torus) space))
  (check-identity (+ g (* -1 (square 'r) (coordinate-system->metric R2-rect)))
                  (make-metric (lambda (X Y) (* (- (square (+ 'R (* 'r (cos u)))) (square 'r))
                                                (dv X) (dv Y))))))

(for-charts "d: d of d is 0, a graded derivation" (C all-charts)
  (define-values (f) (functions C 'f))
  (define-values (a b) (forms C 'a 'b))
  (check-identity (d (d f)) 0)
  (check-identity (d (d a)) 0)
  (check-identity (d (* f a)) (+ (wedge (d f) a) (* f (d a))))
  (check-identity (d (wedge a b)) (- (wedge (d a) b) (wedge a (d b)))))

(for-charts "d by its definition with fields" (C (at-most 3))
  (define-values (a) (forms C 'a))
  (define-values (X Y) (vectors C 'X 'Y))
  (check-identity ((d a) X Y) (- (X (a Y)) (Y (a X)) (a (commutator X Y)))))

(for-charts "d and the pullback commute" (C (at-most 3))
  (define mu (literal-manifold-map 'mu R2-rect C))
  (define-values (f) (functions C 'f))
  (define-values (a b) (forms C 'a 'b))
  (define-values (u v) (vectors R2-rect 'u 'v))
  (define pull (pullback mu))
  (check-identity ((pull (d f)) u) ((d (pull f)) u))
  (check-identity ((pull (d a)) u v) ((d (pull a)) u v))
  (check-identity ((pull (wedge a b)) u v) ((wedge (pull a) (pull b)) u v)))

;; ---------------------------------------------------------------------------
;; Lie derivatives

(for-charts "Lie derivatives: Leibniz, Cartan, and d" (C all-charts)
  (define-values (f) (functions C 'f))
  (define-values (a b) (forms C 'a 'b))
  (define-values (X Y) (vectors C 'X 'Y))
  (define L (Lie-derivative X))
  (check-identity (L (* f a)) (+ (* (X f) a) (* f (L a))))
  (check-identity (L (a Y)) (+ ((L a) Y) (a (L Y))))
  (check-identity (L (d a)) (d (L a)))
  (for ([w (list a (wedge a b))])
    (check-identity (L w) (+ (d ((interior-product X) w)) ((interior-product X) (d w))))))

(for-charts "Lie derivatives along a bracket" (C (at-most 3))
  (define-values (a) (forms C 'a))
  (define-values (X Y) (vectors C 'X 'Y))
  (check-identity ((Lie-derivative (commutator X Y)) a)
                  ((commutator (Lie-derivative X) (Lie-derivative Y)) a)))

;; ---------------------------------------------------------------------------
;; Connections and metrics

(for-charts "covariant derivatives: linear, Leibniz, keep contractions" (C (at-most 3))
  (define nabla (covariant-derivative (literal-Cartan 'G C)))
  (define-values (f) (functions C 'f))
  (define-values (X Y Z) (vectors C 'X 'Y 'Z))
  (define-values (a) (forms C 'a))
  (check-identity ((nabla (+ X (* f Y))) Z) (+ ((nabla X) Z) (* f ((nabla Y) Z))))
  (check-identity ((nabla X) (* f Y)) (+ (* (X f) Y) (* f ((nabla X) Y))))
  (check-identity (X (a Y)) (+ (((nabla X) a) Y) (a ((nabla X) Y)))))

(define (own-connection C)
  (metric->Cartan (coordinate-system->metric C) (coordinate-system->basis C)))

(for-charts "the metric of a chart's place: symmetric, kept, without torsion" (C all-charts)
  (define g (coordinate-system->metric C))
  (define nabla (covariant-derivative (own-connection C)))
  (define-values (X Y) (vectors C 'X 'Y))
  (check-identity (g X Y) (g Y X))
  (check-identity ((nabla X) g) 0)
  (check-identity (torsion nabla) 0))

(for-charts "literal metrics: kept, Bianchi's first identity, symmetric curvature" (C (at-most 2))
  (define g (literal-metric 'g C))
  (define nabla (covariant-derivative (metric->Cartan g (coordinate-system->basis C))))
  (define-values (X Y Z W) (vectors C 'X 'Y 'Z 'W))
  (define-values (a) (forms C 'a))
  (define-values (R S) (values (Riemann nabla) (metric->Riemann g)))
  (check-identity ((nabla X) g) 0)
  (check-identity (+ (R a X Y Z) (R a Y Z X) (R a Z X Y)) 0)
  (check-identity (S X Y Z W) (S Z W X Y))
  (check-identity (S X Y Z W) (- (S Y X Z W)))
  (check-identity (S W X Y Z) (((lower g) W) (((Riemann-curvature nabla) Y Z) X))))

(for-charts "Bianchi's second identity" (C (at-most 2))
  (define nabla (covariant-derivative (symmetrize-Cartan (literal-Cartan 'G C))))
  (define R (Riemann nabla))
  (define-values (X Y Z V) (vectors C 'X 'Y 'Z 'V))
  (define-values (a) (forms C 'a))
  (check-identity (+ (((nabla X) R) a V Y Z) (((nabla Y) R) a V Z X) (((nabla Z) R) a V X Y)) 0))

;; ---------------------------------------------------------------------------
;; Charts

(for* ([manifold (in-list standard-charts)] [entry (in-list manifold)])
  (define C (entry-chart entry))
  (test-case (format "coordinates to a point and back, on ~a" C)
    (with-seeds 20
      (define x (random-coordinates entry))
      (check-close ((chart C) ((point C) x)) x 1e-12)
      (for ([other (in-list manifold)])
        (define B (entry-chart other))
        ;; by way of the other chart, to the same point
        (define q ((point B) ((chart B) ((point C) x))))
        (check-close ((chart C) q) x 1e-9)))))

;; A fixed recipe of a field in the coordinates of C: components that mix the coordinates.
(define ((recipe k) x)
  (define xs (if (up? x) (structure->list x) (list x)))
  (define (mixed i)
    (+ (sin (* (+ i k 1) (car xs)))
       (* (apply + xs) (list-ref xs (modulo (+ i k) (length xs))))))
  (for/list ([i (in-range (length xs))]) (mixed i)))

(define (vector-in C k)
  (components->vector-field
   (lambda (x) (apply up ((recipe k) x))) C))
(define (form-in C k)
  (components->1form-field
   (lambda (x) (apply down ((recipe k) x))) C))

(for* ([manifold (in-list standard-charts)] [from (in-list manifold)] [to (in-list manifold)]
       #:unless (eq? from to))
  (define-values (A B) (values (entry-chart from) (entry-chart to)))
  (test-case (format "what is made on ~a has the same values at points of ~a" A B)
    (define-values (X Y) (values (vector-in A 1) (vector-in A 2)))
    (define a (form-in A 3))
    (define f (a Y))
    (define g (coordinate-system->metric A))
    (define made
      (append (list f (X f) (a (commutator X Y)) ((d a) X Y) (((Lie-derivative X) a) Y) (g X Y))
              (if (< (coordinate-system-dimension A) 4)
                  (let ([nabla (covariant-derivative (own-connection A))])
                    (list (a ((nabla X) Y)) ((Ricci nabla) X Y)))
                  '())))
    (with-seeds 3
      (define m ((point A) (random-coordinates from)))
      (define same ((point B) ((chart B) m)))
      (for ([h (in-list made)])
        (check-same (h same) (h m) 1e-8)))))

;; ---------------------------------------------------------------------------

(test-case "the laws refuse what is not so"
  (define-values (X Y) (vectors R3-cyl 'X 'Y))
  (define-values (a b) (forms R3-cyl 'a 'b))
  (define-values (f) (functions R3-cyl 'f))
  (for ([claim (list (cons (commutator X Y) (commutator Y X))
                     (cons (wedge a b) (wedge b a))
                     (cons (d (wedge a b)) (+ (wedge (d a) b) (wedge a (d b))))
                     (cons ((Lie-derivative X) a) ((interior-product X) (d a)))
                     (cons (commutator X (* f Y)) (* f (commutator X Y)))
                     (cons (d a) 0))])
    (check-pred refuted? (verify-equal (car claim) (cdr claim)))))
