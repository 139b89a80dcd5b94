#lang racket/base
;; Perturbed values: what differentiation runs a function on, a value plus
;; multiples of powers of an infinitesimal ε.
;;
;; Every ε carries a tag of its own, fresh for each application of a derivative,
;; so that those of nested derivatives are not taken for each other.  The tag of
;; greatest number is outermost: the parts of a perturbed value, the
;; coefficients of its ε, contain only lesser tags.

(require "../generic/kind.rkt" "../generic/describe.rkt")

(provide (struct-out perturbed) (struct-out parts) prop:parts parts-of
         fresh-tag outermost innermost)

(struct perturbed carrier (tag)
  #:authentic
  #:property prop:custom-print-quotable 'never
  #:property prop:custom-write (lambda (x port mode) (write-value x port)))

;; What code that works on perturbed values of every type knows of one:
;; value : x -> the part without ε
;; map   : (part -> part) x -> the same with its parts changed, by a linear map
;; retag : tag (part -> part) x -> the same with another ε, whatever its tag
(struct parts (value map retag) #:authentic)

(define-values (prop:parts has-parts? parts-of) (make-struct-type-property 'parts))

(define counter (box 0))

(define (fresh-tag)
  (define n (unbox counter))
  (if (box-cas! counter n (add1 n)) n (fresh-tag)))

;; Of two values, one of them perturbed, the one with the outermost ε.
(define (outermost a b)
  (cond [(not (perturbed? a)) b]
        [(not (perturbed? b)) a]
        [(< (perturbed-tag a) (perturbed-tag b)) b]
        [else a]))

;; What stands in the place of x when no derivative is taken.
(define (innermost x)
  (if (perturbed? x) (innermost ((parts-value (parts-of x)) x)) x))
