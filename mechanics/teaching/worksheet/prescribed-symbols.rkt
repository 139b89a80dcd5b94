#lang racket/base
;; The symbols to which answers are applied: a function is known by its value at these.  With
;; coordinates r and phi they are
;;
;;   the time         t
;;   a local tuple    (up t (up r phi) (up rdot phidot))
;;   a state          (up t (up r phi) (down p_r p_phi))
;;   a path           (up r phi), of literal functions
;;
;; and where there is one coordinate it stands alone.

(require "../../calculus/derivative.rkt" "../../calculus/literal-function.rkt"
         "../../generic/elementary.rkt"
         "../../lagrangian/generic-state.rkt"
         "../../value/structure.rkt")

(provide local-tuple-of long-tuple-of state-of momenta-of path-of path-derivatives
         as-one)

;; xs, a list -> its only element, or a tuple of them
(define (as-one xs [make list->up]) (if (null? (cdr xs)) (car xs) (make xs)))

;; (up t q v a)
(define (long-tuple-of names) (lengthened (up 't (as-one names)) 4))

(define (local-tuple-of names)
  (list->up (for/list ([x (in-list (structure->list (long-tuple-of names)))] [_ (in-range 3)]) x)))

(define (state-of names) (up 't (as-one names) (as-one (momenta-of names) list->down)))

(define (momenta-of names)
  (for/list ([n (in-list names)]) (string->symbol (format "p_~a" n))))

(define (path-of names) (as-one (map literal-function names)))

;; The values of the path and of its derivatives at t, up to the second, each a list of expressions.
(define (path-derivatives names)
  (for/list ([order (in-range 3)])
    (for/list ([n (in-list names)]) (((g:expt D order) (literal-function n)) 't))))
