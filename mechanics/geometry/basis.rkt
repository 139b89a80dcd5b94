#lang racket/base
;; Bases: vector fields and the 1-forms that are dual to them.

(require "chart-calculus.rkt" "component-array.rkt" "tensor-field.rkt" "manifold-chart.rkt"
         "manifold-function.rkt" "manifold-point.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/function.rkt"
         "../generic/kind.rkt" "../generic/printed-function.rkt" "../generic/up-down.rkt"
         "../generic/value-struct.rkt" "../generic/wrong-argument.rkt"
         "../value/shape.rkt")

(provide (struct-out basis-of) make-basis basis?
         basis->vector-basis basis->1form-basis basis->dimension basis->coordinate-system
         coordinate-system->basis coordinate-system->vector-basis coordinate-system->1form-basis
         vector-basis->dual Jacobian check-basis
         ;; fields by components
         components->vector-field vector-field->components
         components->1form-field 1form-field->components
         procedure->vector-field procedure->1form-field with-argument-types
         function-of-fields? changed-function
         literal-vector-field literal-1form-field
         basis-components->vector-field vector-field->basis-components
         basis-components->1form-field 1form-field->basis-components)

;; vectors : down tuple of vector fields;  forms : up tuple of 1-forms
;; system : of a coordinate basis, else #f
(value-struct basis-of (vectors forms system)
  #:datum (lambda (b)
            (define C (basis-of-system b))
            (if C
                (list 'coordinate-system->basis (value->datum C))
                (list 'make-basis (value->datum (basis-of-vectors b))
                      (value->datum (basis-of-forms b))))))

(define (basis? x) (basis-of? x))

(define (make-basis vectors forms)
  (check-argument 'make-basis (tuple-of? vector-field?) vectors "a down tuple of vector fields")
  (check-argument 'make-basis (tuple-of? 1form?) forms "an up tuple of 1-forms")
  (define-values (es ws) (values (tuple-elements vectors) (tuple-elements forms)))
  (unless (= (vector-length es) (vector-length ws))
    (complain 'make-basis "a basis has as many 1-forms as vector fields\n  given: ~a and ~a"
              (value->text vectors) (value->text forms)))
  (basis-of (down-of es) (up-of ws) #f))

(define ((tuple-of? good?) x)
  (and (tuple? x) (for/and ([e (in-vector (tuple-elements x))]) (good? e))))

(define (1form? x) (and (field? x) (equal? (field-types x) '(vector))))

(define (check-basis who b)
  (check-argument who basis-of? b "a basis, such as (coordinate-system->basis R3-rect)"))

(define (basis->vector-basis b) (check-basis 'basis->vector-basis b) (basis-of-vectors b))
(define (basis->1form-basis b) (check-basis 'basis->1form-basis b) (basis-of-forms b))
(define (basis->dimension b)
  (check-basis 'basis->dimension b)
  (structure-length (basis-of-vectors b)))
(define (basis->coordinate-system b)
  (check-basis 'basis->coordinate-system b)
  (or (basis-of-system b)
      (complain 'basis->coordinate-system "this is no coordinate basis\n  given: ~a"
                (value->text b))))

;; ---------------------------------------------------------------------------
;; Coordinate bases

(define (coordinate-system->basis C)
  (check-coordinate-system 'coordinate-system->basis C)
  (basis-of (coordinate-system->vector-basis C) (coordinate-system->1form-basis C) C))

(define (coordinate-system->vector-basis C)
  (check-coordinate-system 'coordinate-system->vector-basis C)
  (down-of (unit-fields C '(1form) "d/d~a")))

(define (coordinate-system->1form-basis C)
  (check-coordinate-system 'coordinate-system->1form-basis C)
  (up-of (unit-fields C '(vector) "d~a")))

(define (unit-fields C types pattern)
  (define n (coordinate-system-dimension C))
  (for/vector #:length n ([name (in-vector (coordinate-system-names C))] [k (in-naturals)])
    (native-field C types
                  (lambda () (for/vector #:length n ([i (in-range n)]) (if (= i k) 1 0)))
                  (lambda () (string->symbol (format pattern name)))
                  #:form? (equal? types '(vector)))))

;; The 1-forms dual to vector fields that are a basis.
(define (vector-basis->dual vectors C)
  (check-argument 'vector-basis->dual (tuple-of? vector-field?) vectors
                  "a tuple of vector fields")
  (check-coordinate-system 'vector-basis->dual C)
  (define vs (tuple-elements vectors))
  (define n (coordinate-system-dimension C))
  (unless (= n (vector-length vs))
    (complain 'vector-basis->dual "a basis has ~a vector field~a in ~a\n  given: ~a" n
              (if (= n 1) "" "s") (value->text C) (value->text vectors)))
  (define (refuse)
    (complain 'vector-basis->dual "these vector fields are not independent\n  given: ~a"
              (value->text vectors)))
  (define inverse
    (once-a-chart
     (lambda (B)
       (define rows (for/vector ([v (in-vector vs)]) (components-in v B)))
       (define (entry i k) (vector-ref (vector-ref rows k) i))
       (inverse-of-matrix (build-components n 2 (lambda (ik) (apply entry ik))) n refuse))))
  (up-of (for/vector #:length n ([k (in-range n)])
           (make-field C '(vector)
                       (lambda (B)
                         (define M (inverse B))
                         (for/vector #:length n ([i (in-range n)]) (component M n (list k i))))
                       (lambda () `(ref (vector-basis->dual ,(value->datum vectors)
                                                            ,(value->datum C)) ,k))
                       #:form? #t))))

;; The matrix by which components in one basis become those in another: values of the 1-forms of
;; `to` on the vectors of `from`, a down tuple (by vectors) of up tuples.
(define (Jacobian to from)
  (check-basis 'Jacobian to)
  (check-basis 'Jacobian from)
  (structure-map (lambda (v) (structure-map (lambda (w) (w v)) (basis-of-forms to)))
                 (basis-of-vectors from)))

;; ---------------------------------------------------------------------------
;; Fields whose components in a chart are functions of its coordinates

(define ((by-components who types make word) components C [name #f])
  (check-coordinate-system who C)
  (define n (coordinate-system-dimension C))
  (define (check-shape x given)
    (unless (and (tuple? x) (eq? (structure-orientation (adopt x)) (if (eq? make up-of) 'up 'down))
                 (= (structure-length (adopt x)) n))
      (complain who "expected ~a of ~a components, functions of the coordinates of ~a\n  given: ~a"
                word n (value->text C) (describe-with-value given))))
  (cond [(tuple? components) (check-shape components components)]
        [else
         (check-argument who (lambda (f) (and (procedure? f) (accepts? f 1))) components
                         (string-append word " of components, or a function of coordinates"))])
  (define (value-at x)
    (define value
      (if (tuple? components)
          (structure-map (lambda (f) (if (procedure? f) (f x) f)) (adopt components))
          (components x)))
    (check-shape value value)
    value)
  (define (find)
    (define m (typical-point C))
    (tuple-elements (in-symbols-of C m (value-at (point-coordinates m)))))
  (native-field C types find
                (lambda () (or name (list who (value->datum components) (value->datum C))))
                #:form? (equal? types '(vector))))

(define components->vector-field
  (by-components 'components->vector-field '(1form) up-of "an up tuple"))
(define components->1form-field
  (by-components 'components->1form-field '(vector) down-of "a down tuple"))

;; The function of the coordinates whose values are the components.
(define ((components-of who good? make word) T C)
  (check-argument who good? T word)
  (check-coordinate-system who C)
  (unary-function (lambda () (list who (value->datum T) (value->datum C))) (x)
    (make (evaluate-components (components-in T C) C (point-coordinates ((point C) x))))))

(define vector-field->components
  (components-of 'vector-field->components vector-field? up-of "a vector field"))
(define 1form-field->components
  (components-of '1form-field->components 1form? down-of "a 1-form"))

(define (literal-vector-field name C)
  (literal-field 'literal-vector-field components->vector-field up-of "~a^~a" name C))
(define (literal-1form-field name C)
  (literal-field 'literal-1form-field components->1form-field down-of "~a_~a" name C))

(define (literal-field who make-from tuple pattern name C)
  (check-argument who symbol? name "a quoted name, such as 'v")
  (check-coordinate-system who C)
  (make-from (tuple (for/vector ([i (in-range (coordinate-system-dimension C))])
                      (literal-of-coordinates (string->symbol (format pattern name i)) C)))
             C name))

;; ---------------------------------------------------------------------------
;; Fields that a procedure gives

;; action : function on the manifold -> function on it, a derivation
(define (procedure->vector-field action [name #f])
  (check-argument 'procedure->vector-field procedure? action "a function of functions")
  (make-field #f '(1form)
              (lambda (C)
                (define e (expression-in (action (chart C)) C))
                (unless (same-shape? e (coordinate-tuple (coordinate-system-symbols C)))
                  (complain 'procedure->vector-field
                            "expected a derivation, as v(f g) = v(f) g + f v(g)\n  ~a makes of ~a: ~a"
                            (value->text action) (value->text (chart C)) (describe-with-value e)))
                (list->vector (scalars e)))
              (lambda () (or name (list 'procedure->vector-field (value->datum action))))))

(define (procedure->1form-field action [name #f])
  (define w (with-argument-types action '(vector)))
  (make-field #f '(vector) (lambda (C) (components-in w C))
              (lambda () (or name (list 'procedure->1form-field (value->datum action))))
              #:form? #t))

;; action : fields -> function on the manifold, linear in each;  types : list of 'vector and '1form
(define (with-argument-types action types [home #f]
                             [make-datum (call-datum 'with-argument-types action types)])
  (define who 'with-argument-types)
  (check-argument who procedure? action "a function of fields")
  (check-argument who (lambda (t) (and (pair? t) (list? t)
                                       (for/and ([x (in-list t)]) (memq x '(vector 1form)))))
                  types "a list of 'vector and '1form")
  (make-field home types
              (lambda (C)
                (define vectors (tuple-elements (coordinate-system->vector-basis C)))
                (define forms (tuple-elements (coordinate-system->1form-basis C)))
                (build-components
                 (coordinate-system-dimension C) (length types)
                 (lambda (indices)
                   (expression-in
                    (apply action (for/list ([i (in-list indices)] [t (in-list types)])
                                    (vector-ref (if (eq? t 'vector) vectors forms) i)))
                    C))))
              make-datum))

;; A procedure that the reader wrote, of two fields or more
(define (function-of-fields? f)
  (and (procedure? f) (not (has-kind? f)) (not (accepts? f 1))))

;; The operator `change` of tensors, applied to such a function when it meets its arguments, which
;; tell their types.
(define ((changed-function change f) . arguments)
  (define types (for/list ([a (in-list arguments)]) (if (vector-field? a) 'vector '1form)))
  (apply (change (with-argument-types f types)) arguments))

;; ---------------------------------------------------------------------------
;; Components with respect to a basis: functions on the manifold

(define (basis-components->vector-field components vectors) (g:* components vectors))
(define (basis-components->1form-field components forms) (g:* components forms))

(define (vector-field->basis-components v forms)
  (structure-map (lambda (w) (w v)) (adopt forms)))
(define (1form-field->basis-components w vectors)
  (structure-map (lambda (v) (w v)) (adopt vectors)))
