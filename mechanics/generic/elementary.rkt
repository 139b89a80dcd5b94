#lang racket/base
;; The elementary functions, generic: one entry each.
;;
;; An entry names the operation and gives its derivative, as generic code over
;; the argument and `value`, the operation's value there (so that exp and sqrt
;; share the node they are made of).  Everything else follows from the entry:
;; numbers are computed, expressions built, functions composed, and derivatives
;; of any order taken.

(require (for-syntax racket/base)
         "naming.rkt" "kind.rkt" "structure.rkt" "dispatch.rkt" "arithmetic.rkt"
         "../algebra/operation.rkt" "../algebra/expression.rkt")

(provide g:sqrt g:exp g:log g:sin g:cos g:tan g:asin g:acos g:atan
         g:sinh g:cosh g:tanh g:abs g:expt g:sec g:csc g:cot
         elementary-operations)

;; (define-elementary sin (x value) derivative) defines g:sin and generic:sin
;; from op:sin.
(define-syntax (define-elementary stx)
  (define (prefixed prefix id)
    (datum->syntax id (string->symbol (format "~a~a" prefix (syntax-e id))) id))
  (syntax-case stx ()
    [(_ name (x value) derivative)
     (with-syntax ([procedure (prefixed "g:" #'name)]
                   [generic (prefixed "generic:" #'name)]
                   [op (prefixed "op:" #'name)])
       #'(begin
           (define-named procedure name
             (let ([numeric (operation-numeric op)])
               (case-lambda
                 [(a) (if (number? a) (numeric a) (dispatch-unary generic a))]
                 [args (raise-unary-arity 'name args)])))
           (define generic
             (generic-op 'name op procedure (list (lambda (x value) derivative))))))]))

(define-elementary sqrt (x value) (g:/ 1 (g:* 2 value)))
(define-elementary exp (x value) value)
(define-elementary sin (x value) (g:cos x))
(define-elementary cos (x value) (g:negate (g:sin x)))
(define-elementary tan (x value) (g:+ 1 (g:square value)))
(define-elementary asin (x value) (g:/ 1 (g:sqrt (g:- 1 (g:square x)))))
(define-elementary acos (x value) (g:/ -1 (g:sqrt (g:- 1 (g:square x)))))
(define-elementary sinh (x value) (g:cosh x))
(define-elementary cosh (x value) (g:sinh x))
(define-elementary tanh (x value) (g:- 1 (g:square value)))
(define-elementary abs (x value) (g:/ x value))

;; ---------------------------------------------------------------------------
;; Functions of one or two arguments

(define (natural-log x)
  (if (number? x) (log x) (dispatch-unary generic:log x)))

(define-named g:log log
  (case-lambda
    [(x) (natural-log x)]
    [(x base) (g:/ (natural-log x) (natural-log base))]))

(define generic:log
  (generic-op 'log op:log natural-log (list (lambda (x value) (g:/ 1 x)))))

;; (atan y) and (atan y x), the angle of the point (x, y).
(define (atan-1 y)
  (if (number? y) (atan y) (dispatch-unary generic:atan y)))

(define (atan-2 y x)
  (if (and (number? y) (number? x))
      (angle-of-point y x)
      (dispatch-binary generic:atan2 (lambda (y x) (e:apply op:atan y x))
                       (lambda (y x) (raise-inapplicable generic:atan2 y x)) y x)))

;; The origin has no angle; at complex numbers Racket's own message will do.
(define (angle-of-point y x)
  (when (and (eqv? y 0) (eqv? x 0))
    (raise (exn:fail:contract "atan: the point at the origin has no angle; given 0 and 0"
                              (current-continuation-marks))))
  (atan y x))

(define-named g:atan atan
  (case-lambda [(y) (atan-1 y)] [(y x) (atan-2 y x)]))

(define generic:atan
  (generic-op 'atan op:atan atan-1
              (list (lambda (y value) (g:/ 1 (g:+ 1 (g:square y)))))))

(define generic:atan2
  (generic-op 'atan op:atan atan-2
              (list (lambda (y x value) (g:/ x (g:+ (g:square x) (g:square y))))
                    (lambda (y x value)
                      (g:negate (g:/ y (g:+ (g:square x) (g:square y))))))))

;; ---------------------------------------------------------------------------
;; Powers

(define-named g:expt expt
  (lambda (b n)
    (if (and (number? b) (number? n))
        (expt b n)
        (dispatch-binary generic:expt e:expt power-of-structure b n))))

;; Tuples have the powers that repeated multiplication gives them.
(define (power-of-structure b n)
  (if (and (tuple? b) (exact-positive-integer? n))
      (for/fold ([p b]) ([_ (in-range (sub1 n))]) (g:* p b))
      (raise-inapplicable generic:expt b n)))

;; The derivatives of b⁰ and of 0ⁿ are 0, where the formulas divide by 0.
(define generic:expt
  (generic-op 'expt op:expt g:expt
              (list (lambda (b n value)
                      (if (and (number? n) (zero? n)) 0 (g:* n (g:expt b (g:- n 1)))))
                    (lambda (b n value)
                      (if (and (number? value) (zero? value))
                          0
                          (g:* value (natural-log b)))))))

;; ---------------------------------------------------------------------------
;; Reciprocals

(define-named g:sec sec (lambda (x) (g:/ 1 (g:cos x))))
(define-named g:csc csc (lambda (x) (g:/ 1 (g:sin x))))
(define-named g:cot cot (lambda (x) (g:/ (g:cos x) (g:sin x))))

;; Every record above: what a test that checks each derivative goes through.
(define elementary-operations
  (list generic:sqrt generic:exp generic:log generic:sin generic:cos generic:tan
        generic:asin generic:acos generic:atan generic:atan2
        generic:sinh generic:cosh generic:tanh generic:abs generic:expt))
