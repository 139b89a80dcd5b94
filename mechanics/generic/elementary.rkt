#lang racket/base
;; The elementary functions, generic.
;;
;; What each of them is stands in the table of operations; everything else
;; follows from its entry there: numbers are computed, expressions built,
;; functions composed, and derivatives of any order taken.

(require (for-syntax racket/base)
         racket/flonum
         "arithmetic.rkt" "branches.rkt" "compare.rkt" "dispatch.rkt" "kind.rkt" "naming.rkt"
         "record.rkt"
         "kinks-met.rkt" "singular-derivative.rkt" "up-down.rkt"
         "../algebra/expression/expression.rkt" "../algebra/expression/operation.rkt"
         "../error/complain.rkt")

(provide g:sqrt g:exp g:log g:sin g:cos g:tan g:asin g:acos g:atan
         g:sinh g:cosh g:tanh g:asinh g:acosh g:atanh g:abs g:sgn g:expt
         g:sec g:csc g:cot g:sech g:csch g:coth
         elementary-operations whole-exponent?
         (for-syntax unary-functions))

;; ---------------------------------------------------------------------------
;; Functions of one argument

;; g:sin and generic:sin from the entry of `sin`, and so on.
(define-syntax (define-elementary stx)
  (define (prefixed prefix id)
    (datum->syntax id (string->symbol (format "~a~a" prefix (syntax-e id))) id id))
  (define (all-prefixed prefix ids)
    (for/list ([id (in-list (syntax->list ids))]) (prefixed prefix id)))
  (syntax-case stx ()
    [(_ name ...)
     (with-syntax ([(procedure ...) (all-prefixed "g:" #'(name ...))]
                   [(generic ...) (all-prefixed "generic:" #'(name ...))]
                   [(op ...) (all-prefixed "op:" #'(name ...))]
                   [(define-record ...)
                    (for/list ([n (in-list (syntax->list #'(name ...)))])
                      (datum->syntax n 'define-record))])
       #'(begin
           (begin
             (define-named procedure name
               (let ([numeric (operation-numeric op)])
                 (lambda (a) (if (number? a) (numeric a) (dispatch-unary generic a)))))
             (define-record generic name 1 procedure))
           ...))]))

(define-elementary
  sqrt exp sin cos tan asin acos sinh cosh tanh asinh acosh atanh)

;; Of a tuple, its length: the root of the sum of squares.
(define-named g:abs abs
  (let ([numeric (operation-numeric op:abs)])
    (lambda (a)
      (cond [(number? a) (numeric a)]
            [(tuple? a) (g:sqrt (sum-of-squares a))]
            [else (note-sign-of! a) (dispatch-unary generic:abs a)]))))

(define-record generic:abs abs 1 g:abs)

(define-named g:sgn sgn
  (let ([numeric (operation-numeric op:sgn)])
    (lambda (a)
      (cond [(number? a) (numeric a)]
            [else (note-sign-of! a) (dispatch-unary generic:sgn a)]))))

(define-record generic:sgn sgn 1 g:sgn)

(define (note-sign-of! a)
  (when (carrier? a) (note-sign! (lambda () a))))

(define (sum-of-squares a)
  (for/fold ([sum 0]) ([x (in-vector (tuple-elements a))])
    (g:+ sum (cond [(tuple? x) (sum-of-squares x)]
                   [(and (number? x) (not (real? x))) (g:square (magnitude x))]
                   [else (g:square x)]))))

(define-named g:sec sec (lambda (x) (g:/ 1 (g:cos x))))
(define-named g:csc csc (lambda (x) (g:/ 1 (g:sin x))))
(define-named g:cot cot (lambda (x) (g:/ (g:cos x) (g:sin x))))
(define-named g:sech sech (lambda (x) (g:/ 1 (g:cosh x))))
(define-named g:csch csch (lambda (x) (g:/ 1 (g:sinh x))))
(define-named g:coth coth (lambda (x) (g:/ (g:cosh x) (g:sinh x))))

;; The language says more of a wrong number of arguments than Racket does, where
;; it sees one of these applied.
(begin-for-syntax
  (define unary-functions
    (list #'g:sqrt #'g:exp #'g:sin #'g:cos #'g:tan #'g:asin #'g:acos
          #'g:sinh #'g:cosh #'g:tanh #'g:asinh #'g:acosh #'g:atanh #'g:abs #'g:sgn
          #'g:sec #'g:csc #'g:cot #'g:sech #'g:csch #'g:coth
          #'g:square #'g:cube #'g:negate #'g:invert)))

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

(define-record generic:log log 1 natural-log)

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
    (complain 'atan "the point at the origin has no angle; given 0 and 0"))
  (atan y x))

(define-named g:atan atan
  (case-lambda [(y) (atan-1 y)] [(y x) (atan-2 y x)]))

(define-record generic:atan atan 1 atan-1)
(define-record generic:atan2 atan 2 atan-2)

;; ---------------------------------------------------------------------------
;; Powers

(define-named g:expt expt
  (lambda (b n)
    (if (and (number? b) (number? n))
        (expt b n)
        (dispatch-binary generic:expt e:expt power-of-structure b n))))

;; Tuples have the powers that repeated multiplication gives them.
(define (power-of-structure b n)
  (if (and (tuple? b) (exact-positive-integer? n))
      (for/fold ([p b]) ([_ (in-range (sub1 n))]) (g:* p b))
      (raise-inapplicable generic:expt b n)))

(define-record generic:expt expt 2 g:expt)

;; ---------------------------------------------------------------------------
;; What the table writes derivatives with

;; a/b, where b = 0 means that there is no derivative: of a b that is open it is noted.
(define (slope-at name arguments a b)
  (cond [(if (flonum? b) (fl= b 0.0) (zero-here? b)) (raise-no-derivative-at name arguments)]
        [else (apply note-kink! name arguments)
              (g:/ a b)]))

;; Is x known to be zero?  A symbol is not, and asking that does not end a trace: where its
;; number is zero, the compiled derivative is none.
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

;; ---------------------------------------------------------------------------

;; Every record above: what a test that checks each derivative goes through.
(define elementary-operations
  (list generic:sqrt generic:exp generic:log generic:sin generic:cos generic:tan
        generic:asin generic:acos generic:atan generic:atan2
        generic:sinh generic:cosh generic:tanh generic:asinh generic:acosh generic:atanh
        generic:abs generic:sgn generic:expt))
