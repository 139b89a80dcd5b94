#lang racket/base
;; Conversion and rounding, generic: functions of numbers only, which neither
;; stop a derivative on its way nor enter expressions.
;;
;; exact->inexact and its inverse are the identity as far as the mathematics goes.  Roundings are
;; constant between their jumps, where they have no derivative: their values are
;; plain numbers, which may count and index.  Exact constants have exact ones: π is rounded
;; down to 3.

(require "arithmetic.rkt" "compare.rkt" "describe.rkt" "dispatch.rkt" "elementary.rkt"
         "irrational.rkt" "kind.rkt" "naming.rkt" "on-demand.rkt" "up-down.rkt"
         "operation-rule/branches.rkt" "operation-rule/operation-record.rkt"
         "operation-rule/singular-derivative.rkt"
         "../algebra/expression/constant-value.rkt" "../algebra/expression/expression.rkt"
         (only-in "../algebra/expression/substitute.rkt" rebuild)
         "../error/complain.rkt")

(require-on-demand ["../algebra/simplify/simplify-expression.rkt" simplify-expression]
                   ["../algebra/zero/constant-bounds.rkt" constant-bounds])

(provide g:exact->inexact g:inexact->exact g:number->string
         g:floor g:ceiling g:truncate g:round g:magnitude
         rounding-operations)

;; A symbol stands for an inexact number as well as for an exact one, but an expression in
;; numbers and π alone has a value.
(define-named g:exact->inexact exact->inexact
  (lambda (x)
    (cond [(number? x) (exact->inexact x)]
          [(expression? x) (or (constant-value x) x)]
          [(tuple? x) (structure-map g:exact->inexact (adopt x))]
          [else (dispatch-unary generic:exact->inexact x)])))

(define-record generic:exact->inexact exact->inexact g:exact->inexact)

;; In an expression, each of its numbers.
(define-named g:inexact->exact inexact->exact
  (lambda (x)
    (cond [(number? x) (exact x)]
          [(expression? x) (with-exact-numbers x)]
          [(tuple? x) (structure-map g:inexact->exact (adopt x))]
          [else (dispatch-unary generic:inexact->exact x)])))

(define (with-exact-numbers e)
  (node-fold e
             (lambda (leaf) (if (number? leaf) (exact leaf) leaf))
             (lambda (node parts) (rebuild (node-head node) parts))))

(define (exact x)
  (unless (and (rational? (real-part x)) (rational? (imag-part x)))
    (complain 'inexact->exact "~a has no exact value" x))
  (inexact->exact x))

(define generic:inexact->exact
  (generic-op 'inexact->exact #f g:inexact->exact (list (lambda (x value) 1)) #f '((-2.0 2.0))))

;; An irrational number has the digits of its decimal.
(define-named g:number->string number->string
  (lambda (x [radix 10]) (number->string (irrational-as-decimal x) radix)))

(define-named g:magnitude magnitude
  (lambda (x) (if (number? x) (magnitude x) (g:abs x))))

;; jump : x and its rounded value -> a number that is zero where the rounding jumps
(define-syntax-rule (define-rounding id generic name numeric jump)
  (begin
    (define-named id name
      (lambda (x)
        (define c (comparand x))
        (cond [(real? x) (numeric x)]
              [(irrational? x) (rounded-irrational 'name numeric c (irrational->expression x))]
              [(other-number? x) (numeric c)]
              [(and (symbolic? c) (constant-value c))
               (define value (rounded-constant 'name numeric c))
               (if (or (eq? c x) (not (g:zero? (jump x value))))
                   value
                   (raise-at-jump 'name x))]
              [(real? c)                        ; x, of value c, is being differentiated
               (define value (numeric c))
               (note-rounding! x value (lambda (one other) (boundary numeric one other)))
               (if (g:zero? (jump c value)) (raise-at-jump 'name x) value)]
              [(expression? x) (raise-inapplicable generic x)]
              [else (dispatch-unary generic x)])))
    (define generic
      (generic-op 'name #f id
                  (list (lambda (x value)
                          (if (g:zero? (jump x value)) (raise-at-jump 'name x) 0)))
                  #f
                  '((-0.9 -0.6))))))

(define-rounding g:floor generic:floor floor floor g:-)
(define-rounding g:ceiling generic:ceiling ceiling ceiling g:-)
(define-rounding g:truncate generic:truncate truncate truncate
  (lambda (x value) (if (g:zero? value) 1 (g:- x value))))
(define-rounding g:round generic:round round round
  (lambda (x value) (g:- (g:abs (g:- x value)) 1/2)))

;; Where a rounding goes from one whole number to the next
(define (boundary numeric one other)
  (define-values (low high) (values (min one other) (max one other)))
  (cond [(= (numeric (+ low 1/4)) high) low]
        [(= (numeric (+ low 3/4)) low) high]
        [else (* 1/2 (+ low high))]))

;; A constant of numbers and π is simplified first, as 2 sin(π/6) is 1.  Else bounds of
;; its value tell, unless it is nearer to a jump than they come.
(define (rounded-constant who numeric e)
  (define simple (simplify-expression e))
  (define (alike low high)
    (define value (numeric low))
    (and (= value (numeric high)) value))
  (cond [(real? simple) (numeric simple)]
        [(constant-bounds simple alike)]
        [else
         (complain who "too near to where it jumps to be told by its decimals
  value: ~a"
                   (describe-with-value e))]))

;; Its decimal, right to 50 bits, may be too near to a jump.
(define (rounded-irrational who numeric decimal e)
  (define x (inexact->exact decimal))
  (define low (numeric (* x (- 1 (expt 2 -50)))))
  (if (= low (numeric (* x (+ 1 (expt 2 -50))))) low (rounded-constant who numeric e)))

(define (raise-at-jump who x)
  (raise-no-derivative-at who (list x) "where it jumps"))

;; Every record above, for a test that checks each derivative.
(define rounding-operations
  (list generic:exact->inexact generic:inexact->exact
        generic:floor generic:ceiling generic:truncate generic:round))
