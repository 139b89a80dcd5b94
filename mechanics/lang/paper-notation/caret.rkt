#lang racket/base
;; x ^ 2 and (^ x 2), as other programs write powers.  At Racket's prompt `^` would be the last
;; result, which does not help a reader who means a power.  In a signature it is a power:
;; (^ Real 3) is the domain of a function of three numbers.

(require (for-syntax racket/base)
         "../../value/signature.rkt")

(provide ^)

(define-syntax (^ stx)
  (syntax-case stx ()
    [(_ shape n) (shape? #'shape) #'(list '^ shape n)]
    [_ (raise-syntax-error '^ "powers are (expt x 2)" stx)]))

(begin-for-syntax
  ;; Real, or (UP Real Real)
  (define (shape? stx)
    (define head (syntax-case stx () [(head . _) #'head] [_ stx]))
    (and (identifier? head)
         (for/or ([known (list #'Real #'Any #'UP #'UP* #'DOWN #'DOWN* #'X #'X* #'^)])
           (free-identifier=? head known)))))
