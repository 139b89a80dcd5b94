#lang racket/base
;; `up` and `down` in programs: each is one binding that constructs a tuple in an expression, takes
;; one apart as a `match` pattern, and marks a structure pattern among the arguments of `define`
;; and its kin.

(require racket/match
         (for-syntax racket/base)
         (prefix-in make- (only-in "../../generic/up-down.rkt" up down))
         (only-in "../../generic/up-down.rkt" structure? structure-orientation structure-elements))

(provide up down)

;; The components of x, a vector, if x is a tuple of that orientation, else #f.
(define (up-components x)
  (cond [(structure? x)
         (and (eq? (structure-orientation x) 'up) (structure-elements x))]
        [else (and (vector? x) x)]))

(define (down-components x)
  (and (structure? x)
       (eq? (structure-orientation x) 'down)
       (structure-elements x)))

(begin-for-syntax
  ;; A use of the name as an expression: an application, or the bare name.
  (define ((constructor-use make) stx)
    (syntax-case stx ()
      [(_ . arguments)
       (syntax->list #'arguments)
       (datum->syntax stx (cons make #'arguments) stx stx)]
      [(_ . arguments)
       (raise-syntax-error #f "the components are separated by spaces, without a dot" stx)]
      [_ make])))

(define-syntax-rule (define-tuple name components make)
  (define-match-expander name
    (lambda (stx)
      (syntax-case stx ()
        [(_ . patterns) #'(app components (vector . patterns))]))
    (constructor-use #'make)))

(define-tuple up up-components make-up)
(define-tuple down down-components make-down)
