#lang racket/base
;; The formulas of explicit methods, as Racket code and as data that say the same.
;;
;; The code runs everywhere; machine code (method-code.rkt) and exported programs are made of the
;; data.  Slopes k are vectors, of which the code is given a vector of all, in the order of their
;; names.

(require racket/flonum
         "vector-formulas.rkt"
         "../flvector.rkt")

(provide explicit
         (struct-out explicit-formulas) (struct-out stage-formulas)
         stage-names mean-formulas error-formulas coefficient-formulas coefficient-names
         final-among-stages?)

;; Of a method whose slopes have these names: the stages of a step, its error, the stages of an
;; interpolant and the coefficients of its polynomial; final : the name of the slope at the end of
;; the step, which is that of a stage, or taken when the step is accepted
(struct explicit-formulas (names stages estimate further coefficients final) #:authentic)

;; Each of them runs as Racket code.  slopes : (slope [a k] ...) for each; end : [a k] ..., or the
;; name of the state that is the end, or #f
(struct stage-formulas (run slopes end) #:property prop:procedure 0 #:authentic)
;; means : (mean [a k] ...) for each; statements : (name formula), of which the last are the
;; dividend and the divisor
(struct estimate-formulas (run means statements) #:property prop:procedure 0 #:authentic)
;; statements : (coefficient formula)
(struct polynomial-formulas (run statements) #:property prop:procedure 0 #:authentic)

(define (stage-names f) (map car (stage-formulas-slopes f)))
(define (mean-formulas m) (estimate-formulas-means (explicit-formulas-estimate m)))
(define (error-formulas m) (estimate-formulas-statements (explicit-formulas-estimate m)))
(define (coefficient-formulas m)
  (polynomial-formulas-statements (explicit-formulas-coefficients m)))
(define (coefficient-names m) (map car (coefficient-formulas m)))

(define (final-among-stages? m)
  (and (memq (explicit-formulas-final m) (stage-names (explicit-formulas-stages m))) #t))

;; k ... : the slopes; h : the length of a step, from the state `old` to y; i : an index
(define-syntax explicit
  (syntax-rules (stages error-estimate further coefficients)
    [(_ (k ...) final (h i old y)
        (stages s ...) (error-estimate e ...) (further t ...) (coefficients c ...))
     (explicit-formulas '(k ...)
                        (make-stages (k ...) s ...)
                        (make-estimate h (k ...) e ...)
                        (make-stages (k ...) t ...)
                        (make-polynomial (n i h) (k ...) (old y) c ...)
                        'final)]))

;; (run f! n from to w h ks) takes slopes and reaches a state:
;;
;;     k = f(w), w = from + h Σ a k    for each of the stages in turn,
;;     to = from + h Σ a k             by the sum given last; or w, the last one; if there is one.
(define-syntax-rule (make-stages (k ...) ([slope term ...] ...) end)
  (stage-formulas (lambda (f! n from to w h ks)
                    (define-elements ks k ...)
                    (begin (combine! n w from h term ...)
                           (f! w slope))
                    ...
                    (reach! n to from w h end))
                  '([slope term ...] ...)
                  'end))

(define-syntax reach!
  (syntax-rules ()
    [(_ n to from w h #f) (void)]
    [(_ n to from w h (term ...)) (combine! n to from h term ...)]
    [(_ n to from w h last) (flvector-copy! to w)]))

;; (run n y z h ks) -> the error of a step from y to z.  Each e is the root mean square of Σ a k
;; beside y and z; the error is a quotient of formulas in these, in h and in other names given, and
;; 0 where the divisor is.
(define-syntax make-estimate
  (syntax-rules (quotient)
    [(_ h (k ...) ([e term ...] ...) [x formula] ... (quotient above below))
     (estimate-formulas
      (lambda (n y z h ks)
        (define-elements ks k ...)
        (define-values (e ...) (root-mean-squares n i y z [(weighted i term ...) ...]))
        (let* ([x formula] ... [divisor below])
          (if (fl= divisor 0.0) 0.0 (fl/ above divisor))))
      '([e term ...] ...)
      '([x formula] ... [dividend above] [divisor below]))]))

;; (run n h ks old y kept) stores the coefficients of a nested polynomial (vector-formulas.rkt),
;; vectors one after the other; formulas give their components of index i, and may use those before.
(define-syntax-rule (make-polynomial (n i h) (k ...) (old y) [c formula] ...)
  (polynomial-formulas (lambda (n h ks old y kept)
                         (define-elements ks k ...)
                         (store-coefficients! n i kept [c formula] ...))
                       '([c formula] ...)))
