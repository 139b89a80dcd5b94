#lang racket/base
;; Metrics: symmetric tensors of two vectors, and operations by them on vectors and forms.
;;
;; A metric has one connection without torsion that keeps it (Levi-Civita),
;;
;;     Γᵃ_bk = ½ Σ gᵃᵐ (∂ₖ g_mb + ∂_b g_mk − ∂ₘ g_bk).

(require (only-in racket/vector vector-append)
         "basis.rkt" "chart-calculus.rkt" "component-array.rkt" "connection.rkt"
         "tensor-field.rkt" "manifold-chart.rkt" "manifold-function.rkt"
         "maps-between-manifolds.rkt" "standard-manifolds.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt"
         "../generic/function.rkt" "../generic/printed-function.rkt" "../generic/up-down.rkt"
         "../generic/wrong-argument.rkt"
         "../algebra/expression/expression.rkt"
         "../value/algebra.rkt" "../value/assumptions.rkt"
         (only-in "../value/matrix/matrix.rkt" matrix? matrix-rows))

(provide metric? as-metric
         literal-metric make-metric components->metric metric->components
         coordinate-system->metric make-Minkowski-metric S2-metric metric-over-map
         metric:invert inverse-metric-components
         metric->Christoffel-1 metric->Christoffel-2 metric->Cartan metric->Riemann flat-place)

(define (metric? x) (and (field? x) (equal? (field-types x) '(vector vector))))
;; A function of two vector fields is a metric as well: that of the basis's manifold.
;; basis : #f where none was given
(define (as-metric who g [basis #f])
  (when basis (check-basis who basis))
  (cond [(metric? g)
         (when basis (common-home who #:of field-home g (first-vector basis)))
         g]
        [(and (function-of-fields? g) (accepts? g 2))
         (make-metric g (home-of-basis basis))]
        [else (complain-of-argument who "a metric, a tensor of two vectors" g)]))

;; ---------------------------------------------------------------------------
;; Metrics

;; (literal-metric 'g R2-rect): components g_00, g_01 …, functions of the coordinates
(define (literal-metric name C)
  (check-argument 'literal-metric symbol? name "a quoted name, such as 'g")
  (check-coordinate-system 'literal-metric C)
  (define n (coordinate-system-dimension C))
  (define x (coordinate-tuple (coordinate-system-symbols C)))
  (define (find)
    (build-components
     n 2 (lambda (ij)
           (define-values (i j) (apply values (sort ij <)))
           ((literal-of-coordinates (string->symbol (format "~a_~a~a" name i j)) C) x))))
  (native-field C '(vector vector) find (lambda () name)))

;; g : vector fields u, v -> function
(define (make-metric g [home #f])
  (check-argument 'make-metric procedure? g "a function of two vector fields")
  (with-argument-types g '(vector vector) home (call-datum 'make-metric g)))

;; components : a tuple of tuples of functions on the manifold
(define (components->metric components basis)
  (check-basis 'components->metric basis)
  (define forms (vector->list (tuple-elements (basis-of-forms basis))))
  (define n (length forms))
  (define (of-size? x) (and (tuple? x) (= n (vector-length (tuple-elements x)))))
  (unless (and (of-size? components) (andmap of-size? (vector->list (tuple-elements components))))
    (complain 'components->metric "expected ~a tuples of ~a components\n  given: ~a" n n
              (describe-with-value components)))
  (define fs (for/vector ([row (in-vector (tuple-elements components))]) (tuple-elements row)))
  (make-field (field-home (car forms)) '(vector vector)
              (lambda (C)
                (define ws (for/vector ([w (in-list forms)]) (components-in w C)))
                (define gs
                  (build-components n 2 (lambda (ij)
                                          (expression-in (vector-ref (vector-ref fs (car ij))
                                                                     (cadr ij)) C))))
                (for/fold ([T gs]) ([p (in-range 2)])
                  (apply-to-index T n 2 p (lambda (a i) (vector-ref (vector-ref ws i) a)))))
              (lambda () (list 'components->metric (value->datum components)
                               (value->datum basis)))))

(define (metric->components metric basis)
  (define g (as-metric 'metric->components metric basis))
  (define es (basis-of-vectors basis))
  (structure-map (lambda (u) (structure-map (lambda (v) (g u v)) es)) es))

;; The metric that the manifold has from the space its places are in.
(define (coordinate-system->metric C)
  (check-coordinate-system 'coordinate-system->metric C)
  (induced-metric C (lambda (k) 1) (call-datum 'coordinate-system->metric C)))

;; −c² dt² + dx² + dy² + dz², in the coordinates of any chart of such a manifold
(define (make-Minkowski-metric C [c 1])
  (check-coordinate-system 'make-Minkowski-metric C)
  (induced-metric C (lambda (k) (if (eqv? k 0) (g:- (g:square c)) 1))
                  (call-datum 'make-Minkowski-metric C c)))

;; weight : of the square of the place's number k
(define (induced-metric C weight make-datum)
  (define (find B)
    (define x (coordinates->place B (coordinate-tuple (coordinate-system-symbols B))))
    (define slopes (derivatives-by-coordinates (flat-place x) B))
    (define n (coordinate-system-dimension B))
    (build-components
     n 2 (lambda (ij)
           (define-values (a b) (values (vector-ref slopes (car ij)) (vector-ref slopes (cadr ij))))
           (tidied (sum-of-products (vector-length a)
                                    (lambda (k) (g:* (weight k) (vector-ref a k)))
                                    (lambda (k) (vector-ref b k)))))))
  (make-field C '(vector vector) find make-datum))

(define (flat-place x)
  (cond [(matrix? x) (apply vector-append (vector->list (matrix-rows x)))]
        [(tuple? x) (tuple-elements x)]
        [else (vector x)]))

(define S2-metric (induced-metric S2-spherical (lambda (k) 1) (lambda () 'S2-metric)))

(define (metric-over-map map metric)
  (define g (as-metric 'metric-over-map metric))
  ((form-field->form-field-over-map map) g))

;; ---------------------------------------------------------------------------
;; Its inverse and its connection

(define (inverse-metric-components g C)
  (check-symmetric g (components-in g C) (coordinate-system-dimension C))
  ((hash-ref! inverses g (lambda () (once-a-chart (lambda (C) (inverted g C))))) C))

;; metric -> its inverse, a function of charts
(define inverses (make-ephemeron-hasheq))

(define (inverted g C)
  (inverse-of-matrix (components-in g C) (coordinate-system-dimension C)
                     (lambda ()
                       (complain 'metric "~a\n  given: ~a"
                                 "this metric is degenerate: its determinant is 0"
                                 (value->text g)))))

;; Curvature and all else is worked out for a symmetric one, with half of the components.
(define (check-symmetric g gs n)
  (for* ([i (in-range n)] [j (in-range i)])
    (define-values (a b) (values (component gs n (list i j)) (component gs n (list j i))))
    (define difference (if (equal? a b) 0 (tidied (g:- a b))))
    (when (and (expression? difference)
               (eq? 'refuted (zero-test-status (zero-test difference (assumptions-in-force)))))
      (complain 'metric
                "a metric is symmetric; of this one two components are ~a and ~a\n  given: ~a"
                (value->text a) (value->text b) (value->text g)))))

;; A tensor of two 1-forms
(define (metric:invert metric [basis #f])
  (define g (as-metric 'metric:invert metric basis))
  (make-field (or (field-home g) (home-of-basis basis)) '(1form 1form)
              (lambda (C) (inverse-metric-components g C))
              (lambda () (list 'metric:invert (value->datum g)))))

(define (home-of-basis basis) (and basis (field-home (first-vector basis))))
(define (first-vector basis) (vector-ref (tuple-elements (basis-of-vectors basis)) 0))

;; The connection in the basis
(define (metric->Cartan metric basis)
  (define g (as-metric 'metric->Cartan metric basis))
  (make-connection (lambda (C) (Levi-Civita g C)) basis (call-datum 'metric->Cartan g basis)))

(define (Levi-Civita g C)
  (define n (coordinate-system-dimension C))
  (define inverse (inverse-metric-components g C))
  (define lowered (symbols-below g C n))
  (symmetric-symbols
   n (lambda (a b k)
       (tidied (sum-of-products n (lambda (m) (component inverse n (list a m)))
                                (lambda (m) (component lowered n (list m b k))))))))

;; ½ (∂ₖ g_mb + ∂_b g_mk − ∂ₘ g_bk), of the indices m, b, k
(define (symbols-below g C n)
  (define slopes (derivatives-by-coordinates (components-in g C) C))
  (define (slope k i j) (component (vector-ref slopes k) n (list i j)))
  (symmetric-symbols
   n (lambda (m b k) (g:* 1/2 (g:- (g:+ (slope k m b) (slope b m k)) (slope m b k))))))

;; Components of three indices that are f for b ≤ k, and symmetric in these.
(define (symmetric-symbols n f)
  (define known
    (build-components n 3 (lambda (abk)
                            (define-values (a b k) (apply values abk))
                            (if (<= b k) (f a b k) 0))))
  (build-components n 3 (lambda (abk)
                          (define-values (a b k) (apply values abk))
                          (component known n (list a (min b k) (max b k))))))

(define (metric->Christoffel-2 g basis) (Cartan->Christoffel (metric->Cartan g basis)))

;; With the index lowered: g(∇_k e_j, e_i)
(define (metric->Christoffel-1 g basis)
  (define second (metric->Christoffel-2 g basis))
  (define es (basis-of-vectors basis))
  (make-Christoffel
   (structure-map
    (lambda (by-j)
      (structure-map
       (lambda (by-i)
         (structure-map (lambda (e)
                          (apply g:+ (for/list ([Gamma (in-vector (tuple-elements by-i))]
                                                [e_m (in-vector (tuple-elements es))])
                                       (g:* Gamma (g e_m e)))))
                        es))
       by-j))
    (Christoffel->symbols second))
   basis))

;; ---------------------------------------------------------------------------
;; Its curvature, with all indices below: ((metric->Riemann g) W V X Y) is g(W, R(X, Y) V).  Its
;; components need no more of the inverse than the products of symbols,
;;
;;     R_abkl = ∂ₖΓ_abl − ∂ₗΓ_abk + Σ gᵐⁿ (Γ_mal Γ_nbk − Γ_mak Γ_nbl).

(define (metric->Riemann metric [basis #f])
  (define g (as-metric 'metric->Riemann metric basis))
  (make-field (or (field-home g) (home-of-basis basis)) '(vector vector vector vector)
              (lambda (C) (curvature-below g C (coordinate-system-dimension C)))
              (lambda () (list 'metric->Riemann (value->datum g)))))

(define (curvature-below g C n)
  (define inverse (inverse-metric-components g C))
  (define lowered (symbols-below g C n))
  (define slopes (derivatives-by-coordinates lowered C))
  (define (symbol . is) (component lowered n is))
  (define (slope k . is) (component (vector-ref slopes k) n is))
  (define (product a l b k)
    (sum-over n (lambda (m)
                  (sum-of-products n (lambda (p) (component inverse n (list m p)))
                                   (lambda (p) (times (symbol m a l) (symbol p b k)))))))
  (define (entry a b k l)
    (tidied (g:+ (g:- (slope k a b l) (slope l a b k))
                 (g:- (product a l b k) (product a k b l)))))
  (with-antisymmetric-ends n entry))

;; Components of four indices that f gives for a < b and k < l, antisymmetric in each pair
(define (with-antisymmetric-ends n f)
  (define known
    (build-components n 4 (lambda (abkl)
                            (define-values (a b k l) (apply values abkl))
                            (if (and (< a b) (< k l)) (f a b k l) 0))))
  (define (sorted x y z) (if (< x y) z (g:- z)))
  (build-components
   n 4 (lambda (abkl)
         (define-values (a b k l) (apply values abkl))
         (define z (component known n (list (min a b) (max a b) (min k l) (max k l))))
         (if (eqv? z 0) 0 (sorted a b (sorted k l z))))))
