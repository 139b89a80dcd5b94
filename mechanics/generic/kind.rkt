#lang racket/base
;; Kinds of value: the needs of the generic operations on a value that is not a
;; number.
;;
;; A struct type joins the arithmetic by carrying `prop:kind`, a record of a
;; few primitives; everything else is derived from them once.  When two kinds
;; meet, the one of higher rank decides: a number times a tuple is the tuple's
;; affair, a tuple plus a function the function's.

(require (for-syntax racket/base)
         (only-in "../algebra/expression/write.rkt" write-datum))

(provide
 (struct-out kind) make-kind prop:kind has-kind? kind-of (struct-out carrier)
 (struct-out generic-op) operation-by-values
 other-number? comparand
 rank:scalar rank:number rank:dual rank:structure rank:matrix rank:quaternion rank:function
 rank:operator rank:series
 rank:manifold-function rank:field)

;; rank      : where it stands when kinds meet
;; describe  : value -> string, as error messages name it ("an up tuple of 2")
;; datum     : value -> the S-expression it prints as
;; map       : (leaf -> leaf) value -> value of the same shape; #f for a leaf
;; unary     : generic-op value -> value
;; binary    : generic-op value value -> value; one of the two is of this kind
;; comparand : value -> the value that comparisons look at, or #f
;; zero?     : value -> boolean
;; same?     : (value value -> boolean) value value -> are these two, both of this
;;             kind, equal when their parts are compared so; #f: `equal?` decides
;; arity     : value -> arity mask, for kinds of function; #f: the procedure's own
;; closed?   : #t for kinds of function that can have captured no value
;; component : value index -> the part that `ref` gives; #f where there is none
;; parts     : of carriers, a record for their own floor
;; order     : of carriers, value -> the highest power of its infinitesimal that is kept
;; judged    : value -> the value that a verdict judges, a structure of expressions, the list
;;             of symbols that stand there for any value, and expressions in these that are
;;             positive; #f: the value itself
;; notation  : value (value -> tree) -> the tree it is typeset by (notation.rkt); #f: that of
;;             its datum
(struct kind (rank describe datum map unary binary comparand zero? same? arity closed?
              component parts notation order judged)
  #:authentic)

(define (make #:rank rank #:describe describe #:datum datum
              #:map [map #f] #:unary [unary #f] #:binary [binary #f]
              #:comparand [comparand #f] #:zero? [zero? (lambda (x) #f)]
              #:same? [same? #f] #:arity [arity #f] #:closed? [closed? #f]
              #:component [component #f] #:parts [parts #f] #:notation [notation #f]
              #:order [order (lambda (x) 1)] #:judged [judged #f])
  (kind rank describe datum map unary binary comparand zero? same? arity closed? component parts
        notation order judged))

;; (make-kind #:rank rank #:describe describe ...): the procedures may be defined after the kind.
(define-syntax (make-kind stx)
  (define arguments
    #hasheq([#:describe . (x)] [#:datum . (x)] [#:map . (f x)]
            [#:unary . (op x)] [#:binary . (op a b)] [#:comparand . (x)] [#:zero? . (x)]
            [#:same? . (same? a b)] [#:arity . (x)] [#:component . (x i)]
            [#:notation . (x see)] [#:order . (x)] [#:judged . (x)]))
  (define (later option f)
    (define xs (and (identifier? f) (hash-ref arguments (syntax-e option) #f)))
    (if xs #`(lambda #,xs (#,f . #,xs)) f))
  (syntax-case stx ()
    [(_ option-or-value ...)
     #`(make #,@(let loop ([parts (syntax->list #'(option-or-value ...))])
                  (if (null? parts)
                      '()
                      (list* (car parts) (later (car parts) (cadr parts)) (loop (cddr parts))))))]))

(define-values (prop:kind has-kind? kind-of-type) (make-struct-type-property 'kind))

;; A scalar that carries its kind in a field, where it is found in a quarter of the
;; time: the numbers that derivatives are computed with.  The kind names the other fields.
;; One type without subtypes serves them all, since that is recognized fastest,
;; by comparing one word.
(struct carrier (kind tag first second third)
  #:authentic
  #:sealed
  #:property prop:kind #f                  ; it is the field
  #:property prop:custom-print-quotable 'never
  #:property prop:custom-write
  (lambda (c port mode) (write-datum ((kind-datum (carrier-kind c)) c) port))
  #:property prop:equal+hash
  (list (lambda (a b recur)
          (and (eq? (carrier-kind a) (carrier-kind b))
               (eqv? (carrier-tag a) (carrier-tag b))
               (recur (carrier-first a) (carrier-first b))
               (recur (carrier-second a) (carrier-second b))
               (recur (carrier-third a) (carrier-third b))))
        (lambda (c recur) (recur (carrier-first c)))
        (lambda (c recur) (recur (carrier-first c)))))

(define kind-of
  (case-lambda
    [(x) (if (carrier? x) (carrier-kind x) (kind-of-type x))]
    [(x otherwise) (if (carrier? x) (carrier-kind x) (kind-of-type x otherwise))]))

(define rank:scalar 0)
(define rank:number 1)
(define rank:dual 2)
(define rank:structure 3)
(define rank:matrix 4)
(define rank:quaternion 5)
(define rank:function 6)
(define rank:operator 7)
(define rank:series 8)
(define rank:manifold-function 13/2)    ; takes functions in, and is taken by operators
(define rank:field 15/2)                ; a vector field takes operators in

;; Is x a real number of another type than Racket's?  Its comparand is Racket's number of
;; the same value.
(define (other-number? x)
  (and (has-kind? x) (eqv? (kind-rank (kind-of x)) rank:number)))

;; The part that comparisons look at: of a dual number its value.
(define (comparand x)
  (define look (and (has-kind? x) (kind-comparand (kind-of x))))
  (if look (comparand (look x)) x))

;; A generic operation as kinds see it: its name, the operation that heads
;; symbolic expressions, the generic procedure itself, its partial derivatives,
;; one generic procedure for each argument, which takes the arguments and the
;; operation's value there; of flonums only, a procedure that gives the value and
;; all derivatives in one call, or #f; and for each argument an interval (low high)
;; on which the operation is real and smooth.
(struct generic-op (name operation procedure partials at-flonums domain)
  #:authentic)

;; One that only functions meet, whose values it is taken of.
(define (operation-by-values name procedure) (generic-op name #f procedure '() #f '()))
