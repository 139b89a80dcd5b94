#lang racket/base
;; Perturbed values: arguments for a function to be differentiated, a value plus
;; multiples of powers of an infinitesimal ε.
;;
;; Every ε carries a tag of its own, fresh for each application of a derivative,
;; so that those of nested derivatives are not taken for each other.  The tag of
;; greatest number is outermost: the parts of a perturbed value, the
;; coefficients of its ε, contain only lesser tags.

(require "../generic/describe.rkt" "../generic/kind.rkt")

(provide (rename-out [carrier? perturbed?] [carrier-tag perturbed-tag])
         (struct-out parts) parts-of
         fresh-tag outermost innermost describe-perturbed)

;; Access for code that works on perturbed values x of every type:
;; value : x -> the part without ε
;; map   : (part -> part) x -> the same with its parts changed, by a linear map
;; retag : tag (part -> part) x -> the same with another ε, whatever its tag
(struct parts (value map retag) #:authentic)

(define (parts-of x) (kind-parts (carrier-kind x)))

(define counter (box 0))

(define (fresh-tag)
  (define n (unbox counter))
  (if (box-cas! counter n (add1 n)) n (fresh-tag)))

;; Of two values, one of them perturbed, the one with the outermost ε.
(define (outermost a b)
  (cond [(not (carrier? a)) b]
        [(not (carrier? b)) a]
        [(< (carrier-tag a) (carrier-tag b)) b]
        [else a]))

;; x without any ε: its value when no derivative is taken.
(define (innermost x)
  (if (carrier? x) (innermost ((parts-value (parts-of x)) x)) x))

(define (describe-perturbed x) (string-append (describe (innermost x)) " being differentiated"))
