#lang racket/base
;; Fields: vector fields, forms and tensors of any type, by their components.
;;
;; A field of k arguments has n^k components in every chart: its values at basis vectors, where it
;; takes a vector, and at basis 1-forms, where it takes a 1-form.  (A vector field takes a
;; 1-form.)  They are expressions in the chart's symbols, found once for each chart.
;;
;; A field *over a map* μ from M to N has a tensor of N at each point of M: the velocity of a curve
;; is one.  Its components in a chart of M refer to the chart of N in which μ gives its points.
;; All else is the case that μ is the identity.

(require (only-in racket/list splitf-at)
         "chart-calculus.rkt" "component-array.rkt" "manifold-chart.rkt" "manifold-function.rkt"
         "manifold-point.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/dispatch.rkt"
         "../generic/function.rkt" "../generic/kind.rkt" "../generic/on-demand.rkt"
         "../generic/scalar.rkt"
         "../generic/up-down.rkt" "../generic/value-struct.rkt"
         "../value/operator.rkt" "../value/shape.rkt")

(require-on-demand ["field-notation.rkt" field-notation])

(provide field? make-field native-field
         field-home field-over field-types field-form? field-rank field-datum
         vector-field? form-field?
         components-in components-over place-over place-slopes target-dimension
         common-over common-field-home check-on-manifold
         derivative-along apply-field
         (struct-out place))

;; ---------------------------------------------------------------------------
;; The struct

(define kind:field
  (make-kind #:rank rank:field
             #:describe (lambda (T) (describe-field T))
             #:datum field-datum
             #:notation (lambda (T see) (field-notation (field-datum T)))
             #:judged (lambda (T) (judge-field T))
             #:arity (lambda (T) (arithmetic-shift 1 (if (vector-field? T) 1 (field-rank T))))
             #:unary (lambda (op T) (of-field op T))
             #:binary (lambda (op a b) (of-fields op a b))))

;; home : coordinate system or #f;  over : a map, #f for the identity
;; types : list of 'vector and '1form, the arguments
;; form? : is it a form, antisymmetric?  components : coordinate system -> vector
(value-struct field (home over types form? components make-datum)
  #:kind kind:field
  #:property prop:procedure (lambda (T . arguments) (apply-field T arguments)))

(define (field-datum T) ((field-make-datum T)))
(define (field-rank T) (length (field-types T)))

(define (make-field home types find make-datum #:over [over #f] #:form? [form? #f])
  (field home over types form? (once-a-chart (on-its-manifold home find)) make-datum))

(define (vector-field? x) (and (field? x) (equal? (field-types x) '(1form))))
(define (form-field? x) (and (field? x) (field-form? x)))

(define (describe-field T)
  (define over (if (field-over T) " over a map" ""))
  (cond [(vector-field? T) (string-append "a vector field" over)]
        [(form-field? T) (format "a ~a-form~a" (field-rank T) over)]
        [else (format "a tensor field of ~a arguments~a" (field-rank T) over)]))

;; ---------------------------------------------------------------------------
;; Components

;; In the chart C of the manifold that the field is on, or of its map's source.
(define (components-in T C) ((field-components T) C))

;; Where the point of a map is: in which chart, at which coordinates, in the symbols of C
(struct place (system coordinates) #:authentic)

(define (place-over map C)
  (define m (if map (typical-point C) (generic-point C)))
  (define image (if map (map m) m))
  (unless (point? image)
    (complain 'manifold-map "a map between manifolds gives points~a\n  map: ~a\n  it gave: ~a"
              ", such as ((point R2-rect) (up 1 2))"
              (value->text map) (describe-with-value image)))
  (place (point-system image)
         (if map (in-symbols-of C m (point-coordinates image)) (point-coordinates image))))

(define (target-dimension p) (coordinate-system-dimension (place-system p)))

;; [k][i] = ∂xᵢ/∂cₖ, of the coordinates x of the place by those of C
(define (place-slopes p C)
  (derivatives-by-coordinates (list->vector (scalars (place-coordinates p))) C))

;; The components of T at the points of a map, which T is over or is taken along.
(define (components-over T map C)
  (cond [(or (not map) (field-over T)) (components-in T C)]
        [else
         (define p (place-over map C))
         (evaluate-components (components-in T (place-system p)) (place-system p)
                              (place-coordinates p))]))

;; The map that fields are over; a field that is over none is taken along.
(define (common-over who fields)
  (for/fold ([over #f]) ([T (in-list fields)])
    (define own (and (field? T) (field-over T)))
    (cond [(not own) over]
          [(or (not over) (eq? own over)) own]
          [else (complain who "these are over different maps\n  maps: ~a and ~a"
                          (value->text over) (value->text own))])))

;; For operations that fields over a map lack
(define (check-on-manifold who T)
  (when (field-over T)
    (complain who "expected a field on a manifold; this one is over a map\n  given: ~a"
              (describe-with-value T))))

;; The home of a value made of these fields and functions: of those over the map, if there is one.
(define (common-field-home who xs)
  (define over (common-over who xs))
  (define (home x)
    (cond [(field? x) (and (eq? (field-over x) over) (field-home x))]
          [else (home-of x)]))
  (define all (apply common-home who #:of home xs))
  (or (for/or ([x (in-list xs)]) (and (field? x) (home x))) all))

;; A field of which the components in the chart A are known.
;; find : -> vector of expressions in the symbols of A
(define (native-field A types find make-datum #:form? [form? #f])
  (make-field A types
              (lambda (C) (if (same-chart? A C) (find) (carried-over (find) types A C)))
              make-datum #:form? form?))

;; Components in A become those in C: an index of a vector goes with ∂x/∂c, one of a 1-form with
;; the inverse of that.
(define (carried-over components types A C)
  (define n (coordinate-system-dimension C))
  (define x (coordinates-in A (generic-point C)))
  (define slopes (place-slopes (place A x) C))
  (define (slope i j) (vector-ref (vector-ref slopes j) i))
  (define inverse
    (and (memq '1form types)
         (inverse-of-matrix (build-components n 2 (lambda (ij) (apply slope ij))) n
                            (lambda () (complain 'geometry "the charts ~a and ~a do not agree"
                                                 (value->text A) (value->text C))))))
  (define k (length types))
  (for/fold ([T (evaluate-components components A x)]) ([type (in-list types)] [p (in-naturals)])
    (apply-to-index T n k p
                    (if (eq? type 'vector)
                        (lambda (j i) (slope i j))
                        (lambda (j i) (component inverse n (list j i)))))))

;; ---------------------------------------------------------------------------
;; Application: of vector fields to functions, of all others to as many fields as they take

(define (apply-field T arguments)
  (cond [(vector-field? T)
         (unless (= (length arguments) 1)
           (complain-of-arity (value->text T) "a vector field takes 1 function; it was given ~a"
                              (length arguments)))
         (derivative-along T (car arguments))]
        [(memf tuple? arguments) (applied-to-tuple T arguments)]
        [else
         (check-arguments T arguments)
         (contracted T arguments)]))

;; Of a tuple of fields, the tuple of values
(define (applied-to-tuple T arguments)
  (define-values (before tuple-and-after) (splitf-at arguments (lambda (a) (not (tuple? a)))))
  (structure-map (lambda (part) (apply T (append before (list part) (cdr tuple-and-after))))
                 (adopt (car tuple-and-after))))

(define (contracted T arguments)
  (define who (value->text T))
  (define all (cons T arguments))
  (define over (common-over who all))
  (make-manifold-function
   (common-field-home who all)
   (lambda (C)
     (define n (target-dimension (place-over over C)))
     (define vectors (for/list ([a (in-list arguments)]) (components-over a over C)))
     (vector-ref (contract-all (components-over T over C) n vectors) 0))
   (lambda () (cons (value->datum T) (map value->datum arguments)))))

(define (check-arguments T arguments)
  (define types (field-types T))
  (unless (= (length types) (length arguments))
    (complain-of-arity (value->text T) "~a takes ~a: ~a\n  it was given ~a" (describe-field T)
                       (if (= (length types) 1) "1 field" (format "~a fields" (length types)))
                       types (length arguments)))
  (for ([a (in-list arguments)] [type (in-list types)] [i (in-naturals 1)])
    (define right?
      (if (eq? type 'vector)
          (vector-field? a)
          (and (field? a) (equal? (field-types a) '(vector)))))
    (unless right?
      (complain (value->text T) "argument ~a: expected ~a\n  given: ~a" i
                (if (eq? type 'vector) "a vector field" "a 1-form")
                (describe-with-value a)))))

;; v f = Σᵢ vⁱ ∂ᵢf; of a tuple of functions, the tuple.
(define (derivative-along v f)
  (if (tuple? f)
      (structure-map (lambda (part) (derivative-along v part)) (adopt f))
      (derivative-of-function v f)))

(define (derivative-of-function v f)
  (unless (function-of-points? f)
    (complain (value->text v) "a vector field acts on functions on a manifold\n  given: ~a~a"
              (if (procedure? f) (describe-function f) (describe-with-value f))
              (if (field? f) "\n  fields have a Lie-derivative and a covariant-derivative" "")))
  (define over (field-over v))
  (define home (if over (field-home v) (common-field-home (value->text v) (list v f))))
  (make-manifold-function
   home
   (lambda (C)
     (define p (place-over over C))
     (define e (expression-in f (place-system p)))
     (define es (list->vector (scalars e)))
     (define slopes
       (derivatives-by-coordinates-at es (place-system p) (place-coordinates p)))
     (list->structure e (vector->list (rates-along (components-in v C) slopes))))
   (lambda () (list (value->datum v) (value->datum f)))))

;; ---------------------------------------------------------------------------
;; Arithmetic

(define (of-fields op a b)
  (case (generic-op-name op)
    [(+ -) (cond [(eqv? b 0) a]
                 [(and (eqv? a 0) (field? b))
                  (if (eq? (generic-op-name op) '+) b (multiple op -1 b))]
                 [(and (field? a) (field? b)) (sum op a b)]
                 [else (with-operators op a b)])]
    [(*) (cond [(and (field? a) (field? b)) (product op a b)]
               [(or (tuple? a) (tuple? b)) (distributed op a b)]
               [(and (field? b) (function-of-points? a)) (multiple op a b)]
               [(and (field? a) (if (vector-field? a) (scalar? b) (function-of-points? b)))
                (multiple op b a)]
               [else (with-operators op a b)])]
    [(/) (if (and (field? a) (function-of-points? b))
             (multiple op (g:/ 1 b) a)
             (raise-inapplicable op a b))]
    [else (with-operators op a b)]))

(define (sum op a b)
  (unless (equal? (field-types a) (field-types b))
    (raise-inapplicable-because op "fields are added that take the same arguments" a b))
  (define combine (generic-op-procedure op))
  (define over (common-over (generic-op-name op) (list a b)))
  (make-field (common-field-home (generic-op-name op) (list a b)) (field-types a)
              (lambda (C)
                (for/vector ([x (in-vector (components-over a over C))]
                             [y (in-vector (components-over b over C))])
                  (combine x y)))
              (lambda () (datum-of-two op a b))
              #:over over #:form? (and (field-form? a) (field-form? b))))

(define (multiple op f T)
  (make-field (common-field-home '* (list T f)) (field-types T)
              (lambda (C)
                (define c (expression-in f C))
                (for/vector ([x (in-vector (components-in T C))])
                  (if (eqv? x 0) 0 (g:* c x))))
              (lambda () (list '* (value->datum f) (value->datum T)))
              #:over (field-over T) #:form? (field-form? T)))

;; Forms multiply as `wedge` says, which asks for this product; vector fields as operators.
(define (product op a b)
  (if (and (vector-field? a) (vector-field? b))
      (with-operators op a b)
      (raise-inapplicable-because op "forms are multiplied by wedge" a b)))

(define (with-operators op a b)
  (define (other? x) (and (field? x) (not (vector-field? x))))
  (when (or (other? a) (other? b)) (raise-inapplicable op a b))
  ((generic-op-procedure op) (as-operator a) (as-operator b)))

(define (as-operator x)
  (if (vector-field? x)
      (make-primitive-operator (lambda (f) (derivative-along x f)) (lambda () (value->datum x)))
      x))

(define (of-field op T)
  (case (generic-op-name op)
    [(negate) (multiple op -1 T)]
    [(exp) (if (vector-field? T)
               ((generic-op-procedure op) (as-operator T))
               (raise-inapplicable op T))]
    [else (raise-inapplicable op T)]))

;; ---------------------------------------------------------------------------
;; Verdicts: on the components in the home chart, a tuple of tuples, one level for each argument

(define (judge-field T)
  (judged-in (field-home T) T
             (lambda (C)
               (define n (target-dimension (place-over (field-over T) C)))
               (nested (if (field-form? T) (ascending-alone T n C) (components-in T C)) n
                       (field-types T)))))

;; The components of a form, with 0 for those that others decide.
(define (ascending-alone T n C)
  (define Ts (components-in T C))
  (build-components n (field-rank T)
                    (lambda (is) (if (apply < is) (component Ts n is) 0))))

(define (nested components n types)
  (define (part i)
    (if (null? (cdr types))
        (vector-ref components i)
        (nested (components-from components n i) n (cdr types))))
  ((if (eq? (car types) 'vector) down-of up-of) (build-vector n part)))
