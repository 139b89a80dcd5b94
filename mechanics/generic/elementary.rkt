#lang racket/base
;; The elementary functions, generic.
;;
;; Each is defined by its entry in the table of operations, from which everything
;; else follows: numbers are computed, expressions built,
;; functions composed, and derivatives of any order taken.

(require (for-syntax racket/base "../operation/operation-table.rkt")
         racket/flonum
         "arithmetic.rkt" "compare.rkt" "dispatch.rkt" "irrational.rkt" "kind.rkt" "naming.rkt"
         "operation-rule/branches.rkt" "operation-rule/kinks-met.rkt"
         "operation-rule/operation-record.rkt" "operation-rule/singular-derivative.rkt"
         "up-down.rkt"
         "../algebra/expression/expression.rkt" "../algebra/expression/operation.rkt"
         "../algebra/expression/pi.rkt"
         "../error/complain.rkt"
         "sums-and-products.rkt")

;; Provided where they are defined: g:sin and the like, g:sec and the like.
(provide g:sqrt g:abs g:sgn g:log g:atan g:expt
         elementary-operations elementary-operation whole-exponent?
         (for-syntax unary-functions))

;; ---------------------------------------------------------------------------
;; Functions of one argument

(begin-for-syntax
  (define (all-prefixed context prefix names)
    (for/list ([n (in-list names)])
      (datum->syntax context (string->symbol (format "~a~a" prefix n)))))
  (define function-keys (map entry-key (entries-where 'function))))

;; g:sin and generic:sin from the entry of `sin`, and so on, but for those defined below.
(define-syntax (define-elementary stx)
  (syntax-case stx ()
    [(_ below ...)
     (let ([names (filter (lambda (k) (not (memq k (syntax->datum #'(below ...))))) function-keys)])
       (with-syntax ([(name ...) (all-prefixed stx "" names)]
                     [(procedure ...) (all-prefixed stx "g:" names)]
                     [(generic ...) (all-prefixed stx "generic:" names)]
                     [define-record (datum->syntax stx 'define-record)])
         #'(begin
             (provide procedure ...)
             (begin
               (define-named procedure name
                 (let ([numeric (operation-numeric (find-operation 'name))])
                   (lambda (a) (if (number? a) (numeric a) (dispatch-unary generic a)))))
               (define-record generic name procedure))
             ...)))]))

(define-elementary sqrt abs sgn log atan atan2)

;; Of an exact number an exact one, if it is real.
(define-named g:sqrt sqrt
  (lambda (a)
    (cond [(flonum? a) (sqrt a)]
          [(number? a) (root-of-number a)]
          [else (dispatch-unary generic:sqrt a)])))

(define (root-of-number a)
  (define root (sqrt a))
  (if (or (exact? root) (not (rational? root)) (not (exact? a))) root (irrational-power a 1/2)))

(define-record generic:sqrt sqrt g:sqrt)

;; Of a tuple, its length: the root of the sum of squares.
(define-named g:abs abs
  (let ([numeric (operation-numeric op:abs)])
    (lambda (a)
      (cond [(number? a) (numeric a)]
            [(tuple? a) (g:sqrt (sum-of-squares a))]
            [else (note-sign-of! a) (dispatch-unary generic:abs a)]))))

(define-record generic:abs abs g:abs)

(define-named g:sgn sgn
  (let ([numeric (operation-numeric op:sgn)])
    (lambda (a)
      (cond [(number? a) (numeric a)]
            [else (note-sign-of! a) (dispatch-unary generic:sgn a)]))))

(define-record generic:sgn sgn g:sgn)

(define (note-sign-of! a)
  (when (carrier? a) (note-sign! (lambda () a))))

(define (sum-of-squares a)
  (g:for/sum ([x (in-vector (tuple-elements a))])
    (cond [(tuple? x) (sum-of-squares x)]
          [(and (number? x) (not (real? x))) (g:square (magnitude x))]
          [else (g:square x)])))

(define-syntax (define-reciprocals stx)
  (with-syntax ([(name ...) (map car reciprocals)]
                [(procedure ...) (all-prefixed stx "g:" (map car reciprocals))]
                [(quotient ...) (datum->syntax stx (map caddr reciprocals))]
                [x (datum->syntax stx 'x)])
    #'(begin
        (provide procedure ...)
        (define-named procedure name (lambda (x) quotient)) ...)))

(define-reciprocals)

;; The language says more of a wrong number of arguments than Racket does, where
;; it sees one of these applied.
(define-for-syntax unary-functions
  (all-prefixed #'here "g:"
                (append (filter (lambda (k) (not (memq k '(log atan atan2)))) function-keys)
                        (map car reciprocals)
                        '(square cube negate invert))))

;; ---------------------------------------------------------------------------
;; Functions of one or two arguments

(define (natural-log x)
  (cond [(eq? x 0) (raise-division-by-zero 'log "the logarithm of 0 has no value")]
        [(number? x) (log x)]
        [else (dispatch-unary generic:log x)]))

(define-named g:log log
  (case-lambda
    [(x) (natural-log x)]
    [(x base) (g:/ (natural-log x) (natural-log (as-precise base x)))]))

;; A number as one of higher precision, if x is.
(define (as-precise base x)
  (if (and (number? base) (other-number? x)) (g:+ base (g:- x x)) base))

(define-record generic:log log natural-log)

;; (atan y) and (atan y x), the angle of the point (x, y).
(define (atan-1 y)
  (if (number? y) (atan y) (dispatch-unary generic:atan y)))

(define (atan-2 y x)
  (if (and (number? y) (number? x))
      (angle-of-point y x)
      (dispatch-binary generic:atan2 (lambda (y x) (e:apply op:atan y x))
                       (lambda (y x) (raise-inapplicable generic:atan2 y x)) y x)))

;; The origin has no angle; at complex numbers Racket's own message will do.
(define (angle-of-point y x)
  (when (and (eqv? y 0) (eqv? x 0))
    (raise-division-by-zero 'atan "the point at the origin has no angle; given 0 and 0"))
  (atan y x))

(define-named g:atan atan
  (case-lambda [(y) (atan-1 y)] [(y x) (atan-2 y x)]))

(define-record generic:atan atan atan-1)
(define-record generic:atan2 atan2 atan-2)

;; ---------------------------------------------------------------------------
;; Powers

(define-named g:expt expt
  (lambda (b n)
    (if (and (number? b) (number? n))
        (if (or (fixnum? n) (flonum? n)) (expt b n) (power-of-number b n))
        (dispatch-binary generic:expt e:expt power-of-structure b n))))

;; n : neither a small integer nor a flonum
(define (power-of-number b n)
  (define power (expt b n))
  (if (or (exact? power) (not (rational? power)) (not (exact? b)) (not (exact? n)))
      power
      (irrational-power b n)))

;; Tuples have the powers that repeated multiplication gives them.
(define (power-of-structure b n)
  (if (and (tuple? b) (exact-positive-integer? n))
      (for/fold ([p b]) ([_ (in-range (sub1 n))]) (g:* p b))
      (raise-inapplicable generic:expt b n)))

(define-record generic:expt expt g:expt)

;; ---------------------------------------------------------------------------
;; Words that derivatives in the table are written with

;; a/b; where b = 0 there is no derivative.  Of a symbolic b a kink is noted.
(define (slope-at name arguments a b)
  (cond [(if (flonum? b) (fl= b 0.0) (zero-here? b)) (raise-no-derivative-at name arguments)]
        [else (apply note-kink! name arguments)
              (g:/ a b)]))

;; Is x known to be zero?  A placeholder is not, and the question does not end its trace: where its
;; number is zero, the compiled derivative is not a number.
(define (zero-here? x)
  (define c (comparand x))
  (and (or (number? c) (has-kind? c)) (g:zero? c)))

;; The value of a function that has a derivative at real x only.
(define (real-value name value x)
  (define c (comparand x))
  (if (and (number? c) (not (real? c)))
      (raise-no-derivative-at name (list x))
      value))

;; ∂(bⁿ)/∂b = n bⁿ⁻¹.  It is 0 for n = 0, where the formula may divide by 0, and
;; for other n < 1 there is none at b = 0.
(define (power-by-base b n)
  (define exponent (comparand n))
  (cond [(eqv? n 0) 0]
        [(and (real? exponent) (< exponent 1) (zero-here? b))
         (if (zero? exponent) 0 (raise-no-derivative-at 'expt (list b n)))]
        [else (unless (whole-exponent? exponent) (note-kink! 'expt b n))
              (g:* n (g:expt b (g:- n 1)))]))

;; 0, 1, 2, …, also written as decimals
(define (whole-exponent? n)
  (or (exact-nonnegative-integer? n) (and (flonum? n) (>= n 0.0) (integer? n))))

;; ∂(bⁿ)/∂n = bⁿ log b, which is 0 at b = 0 as long as bⁿ is; but 0ⁿ jumps from
;; 0 to 1 at n = 0.
(define (power-by-exponent b n value)
  (cond [(zero-here? value) 0]
        [(zero-here? b) (raise-no-derivative-at 'expt (list b n))]
        [else (g:* value (natural-log b))]))

;; 2/√π, as exact as x; a series is as exact as its first coefficient
(define (two-over-root-pi given)
  (define component (and (has-kind? given) (kind-component (kind-of given))))
  (define x (if component (component given 0) given))
  (cond [(number? x) 1.1283791670955126]
        [(symbolic? (comparand x)) (e:/ 2 (e:apply op:sqrt exact-pi))]
        [else (g:/ 2 (g:sqrt (g:* 4 (atan-1 (g:+ 1 (g:- x x))))))]))

;; ---------------------------------------------------------------------------

;; Every record above.
(define elementary-operations
  (let-syntax ([records (lambda (stx) #`(list #,@(all-prefixed #'here "generic:" function-keys)))])
    (append (records) (list generic:expt))))

;; The record of the operation of that name and number of arguments, or #f.
(define (elementary-operation name arguments)
  (for/first ([r (in-list elementary-operations)]
              #:when (and (eq? name (generic-op-name r))
                          (= arguments (length (generic-op-partials r)))))
    r))
