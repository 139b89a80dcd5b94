#lang racket/base
;; Functional Differential Geometry, appendix C: tensors.

(require mechanics
         mechanics/geometry
         "../../support/checks.rkt" "../../support/session.rkt")

;; Is T, a function of fields, linear over functions in each argument?  A list of verdicts
(define (tensor-test T types C)
  (define (field type name)
    ((if (eq? type 'vector) literal-vector-field literal-1form-field) name C))
  (define-values (f g)
    (values (literal-manifold-function 'f C) (literal-manifold-function 'g C)))
  (for/list ([type types] [k (in-naturals)])
    (define arguments
      (for/list ([t types] [i (in-naturals)]) (field t (string->symbol (format "a~a" i)))))
    (define (with x) (for/list ([a arguments] [i (in-naturals)]) (if (= i k) x a)))
    (define-values (x y) (values (field type 'x) (field type 'y)))
    (verify-equal (apply T (with (+ (* f x) (* g y))))
                  (+ (* f (apply T (with x))) (* g (apply T (with y)))))))

(define ((F nabla) omega u v) (omega ((nabla u) v)))
(define nabla (covariant-derivative (literal-Cartan 'G R3-rect)))

(test-case "curvature and torsion are tensors"
  (for ([v (tensor-test (Riemann nabla) '(1form vector vector vector) R3-rect)])
    (check-pred proved? v))
  (for ([v (tensor-test (torsion nabla) '(1form vector vector) R3-rect)])
    (check-pred proved? v)))

(test-case "so is their definition by derivatives"
  (define nabla (covariant-derivative (literal-Cartan 'G R2-rect)))
  (define (torsion-by-definition omega u v)
    (omega (- ((nabla u) v) ((nabla v) u) (commutator u v))))
  (for ([v (tensor-test torsion-by-definition '(1form vector vector) R2-rect)])
    (check-pred proved? v)))

(test-case "a covariant derivative is no tensor in what it differentiates"
  (define verdicts (tensor-test (F nabla) '(1form vector vector) R3-rect))
  (check-pred proved? (car verdicts))
  (check-pred proved? (cadr verdicts))
  (check-pred refuted? (caddr verdicts)))

(test-case "the connection of the sphere is the same by two charts"
  (define (of-chart C)
    (F (covariant-derivative
        (Christoffel->Cartan
         (metric->Christoffel-2 (coordinate-system->metric C) (coordinate-system->basis C))))))
  (define-values (omega u v)
    (values (literal-1form-field 'omega S2-spherical) (literal-vector-field 'u S2-spherical)
            (literal-vector-field 'v S2-spherical)))
  (check-prints (((- (of-chart S2-spherical) (of-chart S2-stereographic)) omega u v)
                 ((point S2-spherical) (up 'theta 'phi)))
                0))
