#lang racket/base
;; The formulas of a method, as Racket code and as data that say the same.
;;
;; The code runs everywhere; of the data machine code is made where there can be
;; (machine-method.rkt).  Slopes k are vectors, of which the code is given a vector of all, in the
;; order of their names.

(require racket/flonum
         "vector-formulas.rkt"
         "../flvector.rkt")

(provide define-stages define-error define-polynomial)

;; (name f! n from to w h ks) takes slopes and reaches a state:
;;
;;     k = f(w), w = from + h Σ a k    for each of the stages in turn,
;;     to = from + h Σ a k             by the sum given last; or w, the last one; if there is one.
(define-syntax define-stages
  (syntax-rules ()
    [(_ (name data) (k ...) ([slope term ...] ...))
     (define-stages (name data) (k ...) ([slope term ...] ...) #f)]
    [(_ (name data) (k ...) ([slope term ...] ...) end)
     (begin
       (define (name f! n from to w h ks)
         (define-elements ks k ...)
         (begin (combine! n w from h term ...)
                (f! w slope))
         ...
         (reach! n to from w h end))
       (define data '(([slope term ...] ...) end)))]))

(define-syntax reach!
  (syntax-rules ()
    [(_ n to from w h #f) (void)]
    [(_ n to from w h (term ...)) (combine! n to from h term ...)]
    [(_ n to from w h last) (flvector-copy! to w)]))

;; (name n y z h ks) -> the error of a step from y to z.  Each e is the root mean square of Σ a k
;; beside y and z; the error is a quotient of formulas in these, in h and in what else is named, and
;; 0 where the divisor is.
(define-syntax-rule (define-error (name data) (h) (k ...) ([e term ...] ...)
                      [x formula] ... (quotient dividend divisor))
  (begin
    (define (name n y z h ks)
      (define-elements ks k ...)
      (define-values (e ...) (root-mean-squares n i y z [(weighted i term ...) ...]))
      (let* ([x formula] ... [d divisor])
        (if (fl= d 0.0) 0.0 (fl/ dividend d))))
    (define data '(([e term ...] ...) ([x formula] ...) dividend divisor))))

;; (name n h ks v ...) -> interpolant (stepper.rkt), a nested polynomial (vector-formulas.rkt); the
;; components of its coefficients are given by formulas in those of index i
(define-syntax-rule (define-polynomial (name data) (n i h) (k ...) (v ...) [c formula] ...)
  (begin
    (define (name n h ks v ...)
      (define-elements ks k ...)
      (nested-polynomial n i [c formula] ...))
    (define data '([c formula] ...))))
