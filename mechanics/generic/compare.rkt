#lang racket/base
;; Comparison, generic.
;;
;; Numbers compare as numbers.  Equality of expressions is structural, which is
;; equality at a generic point; an order between values that are not constant
;; does not exist, and asking for it is an error that names the value.  Constants that π is in
;; are ordered by their values, exactly.

(require "arithmetic.rkt" "operation-rule/branches.rkt" "describe.rkt" "kind.rkt"
         "operation-rule/kinks-met.rkt" "naming.rkt" "on-demand.rkt" "scalar.rkt"
         "operation-rule/singular-derivative.rkt" "irrational.rkt" "tracing.rkt" "up-down.rkt"
         "../algebra/expression/constant-value.rkt" "../algebra/expression/expression.rkt"
         "../error/complain.rkt" "../error/hint.rkt")

(require-on-demand ["../algebra/simplify/simplify-expression.rkt" simplify-expression]
                   ["../algebra/zero/constant-bounds.rkt" constant-bounds])

(provide g:= g:< g:> g:<= g:>= g:zero? g:one? g:positive? g:negative?
         g:max g:min g:add1 g:sub1
         comparand)

;; ---------------------------------------------------------------------------
;; Equality

(define (equal-values? a b)
  (cond [(and (number? a) (number? b)) (= a b)]
        [(and (exact-real? a) (exact-real? b)) (equal? a b)]
        [else (note-branch! a b)
              (equal-comparands? (comparand a) (comparand b))]))

;; An expression that is being differentiated passes for unequal to another that it equals at
;; single points only.
(define (note-branch! a b)
  (when (or (carrier? a) (carrier? b)) (note-kink! '= a b)))

(define (equal-comparands? a b)
  (cond [(and (number? a) (number? b)) (= a b)]
        [(and (expression? a) (expression? b)) (look-inside '=) (expression=? a b)]
        [(and (tuple? a) (tuple? b))
         (define s (adopt a))
         (define t (adopt b))
         (and (compatible? s t)
              (for/and ([x (in-vector (structure-elements s))]
                        [y (in-vector (structure-elements t))])
                (equal-values? x y)))]
        [(same-kind a b)
         => (lambda (k) (if (kind-same? k) ((kind-same? k) equal-values? a b) (equal? a b)))]
        [else (equal? a b)]))

(define (same-kind a b)
  (and (has-kind? a) (has-kind? b) (eq? (kind-of a) (kind-of b)) (kind-of a)))

(define-named g:= =
  (case-lambda
    [(a b) (equal-values? a b)]
    [(a) #t]
    [(a b . more) (and (equal-values? a b) (apply g:= b more))]))

(define-named g:zero? zero?
  (lambda (x)
    (define c (comparand x))
    (cond [(number? c) (zero? c)]
          [(tuple? c) (for/and ([e (in-vector (tuple-elements c))]) (g:zero? e))]
          [(has-kind? c) ((kind-zero? (kind-of c)) c)]
          [(symbolic? c) (look-inside 'zero?) (note-branch! x 0) #f]
          [(procedure? c) #f]
          [else (raise-with-value 'zero? "expected a value of the arithmetic" c)])))

(define-named g:one? one?
  (lambda (x)
    (define c (comparand x))
    (if (number? c)
        (= c 1)
        (and (symbolic? c) (begin (look-inside 'one?) (note-branch! x 1) #f)))))

;; ---------------------------------------------------------------------------
;; Order

(define-syntax-rule (define-order id name compare)
  (begin
    (define (two a b)
      (cond [(and (real? a) (real? b)) (compare a b)]
            [(and (exact-real? a) (exact-real? b)) (compare (comparand (g:- a b)) 0)]
            [else
             (note-difference! a b)
             (compared 'name compare (ordered 'name a b a) (ordered 'name a b b))]))
    (define-named id name
      (case-lambda
        [(a b) (two a b)]
        [(a) (and (real-comparand 'name a) #t)]
        [(a b . more) (and (two a b) (apply id b more))]))))

;; Of values that are being differentiated.
(define (note-difference! a b)
  (when (or (carrier? a) (carrier? b)) (note-sign! (lambda () (g:- a b)))))

(define-order g:< < <)
(define-order g:> > >)
(define-order g:<= <= <=)
(define-order g:>= >= >=)

;; x, y : real numbers or constants
(define (compared who compare x y)
  (if (and (real? x) (real? y))
      (compare x y)
      (let ([sign (constant-order who x y)]) (and sign (compare sign 0)))))

;; x, one of a and b, as a number or a constant.  Other relations may be meant as assumptions.
(define (ordered who a b x)
  (define u (comparand a))
  (define v (comparand b))
  (cond [(and (symbolic? (comparand x)) (expression? u) (expression? v)
              (not (constant-value (comparand x))))
         (look-inside who)
         (raise-with-value
          who
          (format "~a\n  as an assumption, the relation is quoted: (assume '~a)"
                  no-order (value->text (list who u v)))
          (comparand x))]
        [else (real-comparand who x)]))

(define no-order
  (string-append "an expression that is not a number has no order; " values-first))

;; A real number, or a constant.
(define (real-comparand who x)
  (define c (comparand x))
  (cond [(real? c) c]
        [(and (symbolic? c) (constant-value c)) c]
        [else (raise-no-order who c)]))

(define (raise-no-order who x)
  (when (symbolic? x) (look-inside who))
  (raise-with-value
   who
   (if (symbolic? x) no-order "expected real numbers")
   x))

(define (raise-with-value who what x)
  (complain who "~a\n  value: ~a" what (describe-with-value x)))

(define-named g:positive? positive?
  (lambda (x)
    (note-difference! x 0)
    (compared 'positive? > (real-comparand 'positive? x) 0)))
(define-named g:negative? negative?
  (lambda (x)
    (note-difference! x 0)
    (compared 'negative? < (real-comparand 'negative? x) 0)))

;; The argument itself is the value, so that its derivative comes along.  Where
;; two are equal there is a kink, unless they are the same with their derivatives.
(define-syntax-rule (define-extreme id name numeric beyond?)
  (begin
    (define (two a b)
      (cond [(and (real? a) (real? b)) (numeric a b)]
            [else
             (define-values (x y)
               (if (and (exact-real? a) (exact-real? b))
                   (values (comparand (g:- a b)) 0)
                   (values (real-comparand 'name a) (real-comparand 'name b))))
             (note-difference! a b)
             (cond [(compared 'name beyond? y x) b]
                   [(and (compared 'name = x y) (not (identical? a b)))
                    (raise-no-derivative-at 'name (list a b) "where two arguments are equal")]
                   [else a])]))
    (define-named id name
      (case-lambda
        [(a b) (two a b)]
        [(a) (begin (real-comparand 'name a) a)]
        [(a b . more) (apply id (two a b) more)]))))

;; Equal in all their parts: of numbers being differentiated, the derivatives too.
(define (identical? a b)
  (cond [(same-kind a b)
         => (lambda (k) (if (kind-same? k) ((kind-same? k) identical? a b) (equal? a b)))]
        [else (or (eq? a b) (and (plain-number? a) (plain-number? b) (equal-values? a b)))]))

(define-extreme g:max max max >)
(define-extreme g:min min min <)

(define-named g:add1 add1 (lambda (x) (g:+ x 1)))
(define-named g:sub1 sub1 (lambda (x) (g:- x 1)))

;; ---------------------------------------------------------------------------
;; Which of two constants is greater, where π is in one: not by flonums, which are equal for
;; π and its first sixteen digits, and have few digits left where large numbers cancel.

;; a, b : real numbers, or expressions that constant-value knows -> the sign of a − b
(define (constant-order who a b)
  (cond [(and (rational-constant? a) (rational-constant? b))
         (sign-of who (e:- (exactly a) (exactly b)))]
        [else (order (flonum-of a) (flonum-of b))]))      ; one is infinite, or no number

(define (rational-constant? x) (or (not (number? x)) (rational? x)))
(define (exactly x) (if (number? x) (inexact->exact x) x))
(define (flonum-of x) (if (number? x) x (constant-value x)))

;; #f if one is no number
(define (order a b) (cond [(< a b) -1] [(> a b) 1] [(= a b) 0] [else #f]))

;; Bounds that zero is not between; if none are, it is zero by its form.
(define (sign-of who e)
  (define (sign low high) (cond [(> low 0) 1] [(< high 0) -1] [else #f]))
  (cond [(real? e) (order e 0)]
        [(constant-bounds e sign)]
        [else
         (define simple (simplify-expression e))
         (if (real? simple)
             (order simple 0)
             (complain who "two constants are too close to be told apart by their decimals"))]))
