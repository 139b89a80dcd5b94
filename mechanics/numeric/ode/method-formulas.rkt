#lang racket/base
;; The formulas of explicit methods, as Racket code and as data that say the same.
;;
;; The code runs everywhere; machine code (method-code.rkt) and exported programs are made of the
;; data.  Slopes k are vectors, of which the code is given a vector of all, in the order of their
;; names.

(require racket/flonum
         "vector-formulas.rkt"
         "../flvector.rkt")

(provide explicit (struct-out explicit-formulas) formulas-data
         stage-names coefficient-names last-taken?)

;; Of a method whose slopes have these names: the stages of a step, its error, the stages of an
;; interpolant and the coefficients of its polynomial; final : the name of the slope at the end of
;; the step, which is that of a stage, or taken when the step is accepted
(struct explicit-formulas (names stages estimate further coefficients final) #:authentic)

(define (stage-names f) (map car (car (formulas-data f))))
(define (coefficient-names m) (map car (formulas-data (explicit-formulas-coefficients m))))

(define (last-taken? m)
  (and (memq (explicit-formulas-final m) (stage-names (explicit-formulas-stages m))) #t))

;; run : the Racket code
(struct formulas (run data) #:property prop:procedure 0 #:authentic)

;; k ... : the slopes; h : the length of a step, from the state `old` to y; i : an index
(define-syntax explicit
  (syntax-rules ()
    [(_ (k ...) final (h i old y) (_ s ...) (_ e ...) (_ t ...) (_ c ...))
     (explicit-formulas '(k ...)
                        (stages (k ...) s ...)
                        (error-estimate h (k ...) e ...)
                        (stages (k ...) t ...)
                        (coefficients (n i h) (k ...) (old y) c ...)
                        'final)]))

;; (run f! n from to w h ks) takes slopes and reaches a state:
;;
;;     k = f(w), w = from + h Σ a k    for each of the stages in turn,
;;     to = from + h Σ a k             by the sum given last; or w, the last one; if there is one.
(define-syntax stages
  (syntax-rules ()
    [(_ (k ...) ([slope term ...] ...) end)
     (formulas (lambda (f! n from to w h ks)
                 (define-elements ks k ...)
                 (begin (combine! n w from h term ...)
                        (f! w slope))
                 ...
                 (reach! n to from w h end))
               '(([slope term ...] ...) end))]))

(define-syntax reach!
  (syntax-rules ()
    [(_ n to from w h #f) (void)]
    [(_ n to from w h (term ...)) (combine! n to from h term ...)]
    [(_ n to from w h last) (flvector-copy! to w)]))

;; (run n y z h ks) -> the error of a step from y to z.  Each e is the root mean square of Σ a k
;; beside y and z; the error is a quotient of formulas in these, in h and in what else is named, and
;; 0 where the divisor is.
(define-syntax-rule (error-estimate h (k ...) ([e term ...] ...)
                      [x formula] ... (quotient dividend divisor))
  (formulas (lambda (n y z h ks)
              (define-elements ks k ...)
              (define-values (e ...) (root-mean-squares n i y z [(weighted i term ...) ...]))
              (let* ([x formula] ... [d divisor])
                (if (fl= d 0.0) 0.0 (fl/ dividend d))))
            '(([e term ...] ...) ([x formula] ...) dividend divisor)))

;; (run n h ks old y kept) stores the coefficients of a nested polynomial (vector-formulas.rkt),
;; vectors one after the other; formulas give their components of index i, and may use those before.
(define-syntax-rule (coefficients (n i h) (k ...) (old y) [c formula] ...)
  (formulas (lambda (n h ks old y kept)
              (define-elements ks k ...)
              (store-coefficients! n i kept [c formula] ...))
            '([c formula] ...)))
