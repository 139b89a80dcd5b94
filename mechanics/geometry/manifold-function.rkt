#lang racket/base
;; Functions on manifolds: values that know the chart they were given in.
;;
;; A function is asked for the expression that it is in the symbols of a chart, once for each
;; chart; its value at a point is that of the expression.  The names of the coordinates in its
;; home chart are those that a verdict on it speaks of.

(require "chart-calculus.rkt" "manifold-chart.rkt" "manifold-point.rkt"
         "../calculus/literal-function.rkt"
         "../error/complain.rkt"
         "../generic/describe.rkt" "../generic/dispatch.rkt" "../generic/function.rkt"
         "../generic/kind.rkt" "../generic/on-demand.rkt" "../generic/scalar.rkt"
         "../generic/up-down.rkt"
         "../generic/value-struct.rkt" "../generic/wrong-argument.rkt"
         "../value/shape.rkt" "../value/signature.rkt")

(require-on-demand ["field-notation.rkt" field-notation])

(provide manifold-function? make-manifold-function manifold-function-home
         expression-in evaluate-structure in-symbols-of on-its-manifold
         home-of common-home function-of-points?
         judged-in datum-of-two distributed
         literal-of-coordinates literal-manifold-function constant-manifold-function
         zero-manifold-function one-manifold-function)

(define kind:manifold-function
  (make-kind #:rank rank:manifold-function
             #:describe (lambda (f) "a function on a manifold")
             #:datum (lambda (f) ((manifold-function-make-datum f)))
             #:notation (lambda (f see) (field-notation ((manifold-function-make-datum f))))
             #:arity (lambda (f) 2)
             #:judged (lambda (f) (judged-in (manifold-function-home f) f
                                             (lambda (C) (expression-in f C))))
             #:unary on-value
             #:binary on-values))

;; home : coordinate system or #f;  at : coordinate system -> expression, or a structure of such
(value-struct manifold-function (home at make-datum)
  #:kind kind:manifold-function
  #:property prop:procedure
  (case-lambda
    [(f m) (value-at-point f m)]
    [(f . ms) (complain-of-arity (value->text f) "takes a point; it was given ~a values"
                                 (length ms))]))

(define (make-manifold-function home at make-datum)
  (manifold-function home (once-a-chart (on-its-manifold home at)) make-datum))

;; find : coordinate system -> value, where the system is of the manifold of home
(define ((on-its-manifold home find) C)
  (common-home 'geometry #:of values home C)
  (find C))

;; f in the symbols of C.  A number or an expression is the constant function; a tuple, the tuple
;; of its parts; any other procedure is a function of points.
(define (expression-in f C)
  (cond [(manifold-function? f) ((manifold-function-at f) C)]
        [(tuple? f) (structure-map (lambda (part) (expression-in part C)) (adopt f))]
        [(procedure? f) (let ([m (typical-point C)]) (in-symbols-of C m (value-of-points f (f m))))]
        [else f]))

;; x : the value of the procedure f
(define (value-of-points f x)
  (unless (andmap scalar? (scalars x))
    (complain 'manifold-function
              "a function on a manifold gives a number, or a tuple of numbers\n  ~a gave: ~a"
              (value->text f) (describe-with-value x)))
  x)

(define (value-at-point f m)
  (define home (manifold-function-home f))
  (unless (and (point? m) (not home))
    (check-point m (and home (coordinate-system-manifold home))))
  (define C (point-system m))
  (evaluate-structure (expression-in f C) C (point-coordinates m)))

;; The value e of a procedure at the typical point m, in the symbols of C.  The procedure is not
;; called at these: to it the coordinates of its point may be constants, while it takes derivatives
;; by coordinates.
(define (in-symbols-of C m e)
  (structure-with e (list->vector (scalars (point-coordinates m)))
                  (coordinate-tuple (coordinate-system-symbols C))))

(define (evaluate-structure e C x) (structure-with e (coordinate-system-symbols C) x))

(define (structure-with e symbols x)
  (define es (in-place-of-symbols (list->vector (scalars e)) symbols x))
  (if (tuple? e) (list->structure e (vector->list es)) (vector-ref es 0)))

;; ---------------------------------------------------------------------------
;; Arithmetic: pointwise

(define (on-value op f)
  (define apply-op (generic-op-procedure op))
  (make-manifold-function (manifold-function-home f)
                          (lambda (C) (apply-op (expression-in f C)))
                          (lambda () (list (generic-op-name op) (value->datum f)))))

(define (on-values op f g)
  (cond [(or (tuple? f) (tuple? g)) (distributed op f g)]
        [else
         (define combine (generic-op-procedure op))
         (make-manifold-function
          (common-home (generic-op-name op) f g)
          (lambda (C) (combine (expression-in f C) (expression-in g C)))
          (lambda () (datum-of-two op f g)))]))

;; (+ a b c) of (+ a b) and c
(define (datum-of-two op f g)
  (define-values (name a b) (values (generic-op-name op) (value->datum f) (value->datum g)))
  (if (and (memq name '(+ *)) (pair? a) (eq? (car a) name))
      (append a (list b))
      (list name a b)))

(define (distributed op f g)
  (define combine (generic-op-procedure op))
  (case (generic-op-name op)
    [(* /) (if (tuple? f)
               (structure-map (lambda (x) (combine x g)) (adopt f))
               (structure-map (lambda (x) (combine f x)) (adopt g)))]
    [else (raise-inapplicable op f g)]))

;; Is f a function for expression-in: of points, or a constant?
(define (function-of-points? f)
  (or (manifold-function? f) (scalar? f)
      (and (tuple? f) (for/and ([part (in-vector (tuple-elements f))]) (function-of-points? part)))
      (and (procedure? f) (not (has-kind? f)) (accepts? f 1))
      (and (has-kind? f) (eqv? (kind-rank (kind-of f)) rank:function))))

;; ---------------------------------------------------------------------------
;; Homes

(define (home-of x) (if (manifold-function? x) (manifold-function-home x) #f))

;; The first home there is; all are of one manifold.
(define (common-home who #:of [home-of home-of] . xs)
  (for/fold ([home #f]) ([x (in-list xs)])
    (define own (home-of x))
    (cond [(not own) home]
          [(not home) own]
          [(eq? (coordinate-system-manifold own) (coordinate-system-manifold home)) home]
          [else (raise-other-manifold who home own xs)])))

(define (raise-other-manifold who home own xs)
  (complain who "these live on different manifolds, ~a and ~a\n  given: ~a"
            (value->text (coordinate-system-manifold home))
            (value->text (coordinate-system-manifold own))
            (value->text xs)))

;; For verdicts: the form of x in its home chart, in symbols of the names there; and these symbols.
;; find : coordinate system -> expression or structure
(define (judged-in home x find)
  (unless home
    (complain 'prove-zero "~a does not say on which manifold it is\n  ~a" (value->text x)
              "apply it to fields, or ask at a point: (f ((point R2-rect) (up 'x 'y)))"))
  (define symbols
    (for/vector ([s (in-vector (coordinate-system-names home))])
      (string->uninterned-symbol (symbol->string s))))
  (define at (coordinate-tuple symbols))
  (values (evaluate-structure (find home) home at)
          (vector->list symbols)
          (coordinate-system-positive home at)))

;; ---------------------------------------------------------------------------
;; Literal and constant functions

;; (literal-manifold-function 'f R2-rect): f of the coordinates there, an unknown function
(define (literal-manifold-function name C)
  (check-argument 'literal-manifold-function symbol? name "a quoted name, such as 'f")
  (check-coordinate-system 'literal-manifold-function C)
  (define f (literal-of-coordinates name C))
  (make-manifold-function C
                          (lambda (B) (f (coordinates-in C (generic-point B))))
                          (lambda () name)))

;; An unknown function of the coordinates of C
(define (literal-of-coordinates name C)
  (define n (coordinate-system-dimension C))
  (if (= n 1)
      (literal-function name)
      (literal-function name `(-> (UP ,@(for/list ([_ (in-range n)]) 'Real)) Real))))

(define (constant-manifold-function value)
  (make-manifold-function #f (lambda (C) value) (lambda () (value->datum value))))

(define zero-manifold-function (constant-manifold-function 0))
(define one-manifold-function (constant-manifold-function 1))
