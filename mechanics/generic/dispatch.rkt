#lang racket/base
;; From a generic operation and its arguments to the code that knows them.
;;
;; Numbers never come here; the operations ask for them first.  The argument of
;; highest rank decides: expressions are the algebra's, functions combine
;; pointwise, structures follow the rule each operation hands in, and every
;; other kind brings its own methods.

(require "describe.rkt" "function.rkt" "kind.rkt" "up-down.rkt"
         "../algebra/expression/expression.rkt"
         "../error/complain.rkt" "../error/hint.rkt" "../error/message-words.rkt")

(provide dispatch-unary dispatch-binary dispatch-carriers arithmetic-value?
         raise-inapplicable raise-inapplicable-because raise-unary-arity)

(define (rank x)
  (cond [(kind-of x #f) => kind-rank]
        [(or (symbolic? x) (number? x)) rank:scalar]
        [(vector? x) rank:structure]
        [(procedure? x) rank:function]
        [else #f]))

;; Is x a value of the arithmetic?
(define (arithmetic-value? x) (and (rank x) #t))

(define (dispatch-unary op x)
  (if (carrier? x)
      ((kind-unary (carrier-kind x)) op x)
      (dispatch-unary-by-rank op x)))

(define (dispatch-unary-by-rank op x)
  (define r (rank x))
  (cond [(not r) (raise-inapplicable op x)]
        [(eqv? r rank:scalar) (e:apply (generic-op-operation op) x)]
        [(eqv? r rank:function) (compose-unary op x)]
        [else (define method (and (has-kind? x) (kind-unary (kind-of x))))
              (if method (method op x) (raise-inapplicable op x))]))

;; symbolic : combines two expressions.
;; structural : combines two values of which one is a structure.
(define (dispatch-binary op symbolic structural a b)
  (cond [(and (carrier? a) (or (carrier? b) (expression? b)))
         ((kind-binary (carrier-kind a)) op a b)]
        [(and (carrier? b) (expression? a)) ((kind-binary (carrier-kind b)) op a b)]
        [else (dispatch-binary-by-rank op symbolic structural a b)]))

;; The same for two carriers, or one and a flonum, without a call; else `other`.
(define-syntax-rule (dispatch-carriers op a b other)
  (cond [(and (carrier? a) (or (flonum? b) (carrier? b))) ((kind-binary (carrier-kind a)) op a b)]
        [(and (carrier? b) (flonum? a)) ((kind-binary (carrier-kind b)) op a b)]
        [else other]))

(define (dispatch-binary-by-rank op symbolic structural a b)
  (define ra (rank a))
  (define rb (rank b))
  (cond [(not (and ra rb)) (raise-inapplicable op a b)]
        [else
         (define r (if (> ra rb) ra rb))
         (cond [(eqv? r rank:scalar) (symbolic a b)]
               [(eqv? r rank:structure) (structural a b)]
               [(eqv? r rank:function) (combine-functions op a b)]
               [else ((kind-binary (kind-of (if (eqv? ra r) a b))) op a b)])]))

;; ---------------------------------------------------------------------------
;; Errors

(define (attempt-with-two name a b)
  (case name
    [(+) (format "cannot add ~a and ~a" a b)]
    [(-) (format "cannot subtract ~a from ~a" b a)]
    [(*) (format "cannot multiply ~a by ~a" a b)]
    [(/) (format "cannot divide ~a by ~a" a b)]
    [(expt) (format "cannot raise ~a to the power of ~a" a b)]
    [else (format "cannot be taken of ~a and ~a" a b)]))

(define (raise-inapplicable op . args)
  (raise-with-hint op args (hint args)))

(define (raise-inapplicable-because op reason . args)
  (raise-with-hint op args (string-append "\n  " reason)))

(define (raise-with-hint op args hint)
  (define name (generic-op-name op))
  (complain name "~a~a~a"
            (attempt name (map describe args))
            (joined (for/list ([a (in-list args)] [i (in-naturals 1)])
                      (format "\n  argument ~a: ~a" i (describe-with-value a)))
                    "")
            hint))

(define (attempt name kinds)
  (if (null? (cdr kinds))
      (format "cannot be taken of ~a" (car kinds))
      (attempt-with-two name (car kinds) (cadr kinds))))

(define (hint args)
  (cond [(findf pair? args) => list-hint]
        [(and (pair? (cdr args)) (ormap tuple? args) (andmap tuple? args)
              (not (= (structure-length (adopt (car args)))
                      (structure-length (adopt (cadr args))))))
         "\n  their lengths differ"]
        [(and (pair? (cdr args)) (andmap structure? args)
              (not (eq? (structure-orientation (car args)) (structure-orientation (cadr args)))))
         "\n  their orientations differ"]
        [else ""]))

(define (raise-unary-arity name args)
  (complain-of-arity name "expected 1 argument, given ~a~a~a" (length args)
                     (if (null? args) "" ": ") (joined (map describe-short args))))

(define (describe-short x)
  (if (and (procedure? x) (not (has-kind? x)))
      (describe-with-value x)
      (value->text x)))
