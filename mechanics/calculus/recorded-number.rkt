#lang racket/base
;; Recorded numbers: the arguments of a function whose gradient is taken.
;;
;; A recorded number is a value and its differential, a factor times one of those
;; on a tape (gradient-tape.rkt).  Each operation's own derivative rule gives the factors.
;; A tape has a tag as an ε has: where derivatives nest, it decides which is
;; outermost.  The value and the factors contain only lesser tags.

(require (for-syntax racket/base)
         racket/fixnum
         racket/flonum
         "dual.rkt" "gradient-tape.rkt" "perturbed-value.rkt" "partial-derivatives.rkt"
         (only-in "../algebra/expression/expression.rkt" symbolic?)
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/kind.rkt"
         "../generic/operation-rule/operation-record.rkt")

;; Fields are read after the test for the type: no need to test again, which
;; takes half of the time.
(#%declare #:unsafe)

(provide recorded? on-tape? recorded-tape recorded-value
         make-recording record-input flonum-inputs record-sum
         derivatives value-and-derivatives)

(define kind:recorded
  (make-kind #:rank rank:dual
             #:describe describe-perturbed
             #:datum (lambda (r) (value->datum (recorded-value r)))
             #:unary record-unary
             #:binary record-binary
             #:comparand recorded-value
             #:same? same-recorded?
             #:parts (parts (lambda (r) (recorded-value r))
                            (lambda (f r) (map-parts f r))
                            (lambda (tag f r) (map-parts f r)))))

;; A value with the differential factor · dz, z being number `index` of the tape; the
;; tape is its kind.
(define (recorded? x) (and (carrier? x) (tape? (carrier-kind x))))

(define-syntax-rule (construct-recorded tape tag index factor value)
  (carrier tape tag index factor value))
(define-syntax-rule (recorded-tape r) (carrier-kind r))
(define-syntax-rule (recorded-index r) (carrier-first r))
(define-syntax-rule (recorded-factor r) (carrier-second r))
(define-syntax-rule (recorded-value r) (carrier-third r))

;; As with dual numbers, a quantity whose first derivative vanishes still varies, unless it is an
;; expression, which is taken at a generic point.
(define (record tape index factor value)
  (if (and (eq? factor 0) (symbolic? value))
      value
      (construct-recorded tape (tape-tag tape) index factor value)))

;; A new tape, for so many variables; are all of them flonums?
(define (make-recording tag inputs flonums?)
  (make-tape kind:recorded record-unary record-binary tag inputs flonums?))

;; Variable i of the tape.
(define (record-input tape i value) (record tape i (unit value) value))

;; The flonums of a vector as the variables from `first` on: index -> variable.
(define (flonum-inputs tape first flonums)
  (define tag (tape-tag tape))
  (lambda (i) (construct-recorded tape tag (fx+ first i) 1.0 (vector-ref flonums i))))

;; The factor of a value whose differential is a dz itself.
(define-syntax-rule (unit value) (if (flonum? value) 1.0 1))

;; ---------------------------------------------------------------------------
;; Arithmetic: the chain rule

;; The cost of a gradient beside its function is decided here, where a flonum's sum
;; takes 2 ns.  So squares and the four operations on flonums, which most of a run
;; consists of, are computed in place, as their entries in the table say.
(define (record-unary op r)
  (define-values (x f) (values (recorded-value r) (recorded-factor r)))
  (define-syntax-rule (in-place value slope)
    (construct-like r (fl-times slope f) value))
  (if (and (flonum? x) (flonum? f))
      (case-at-flonums op (x) in-place
        [generic:square square] [else (record-unary-generally op r x)])
      (record-unary-generally op r x)))

;; A number with a multiple of the differential of r.
(define-syntax-rule (construct-like r factor value)
  (let ([v value])
    (construct-recorded (recorded-tape r) (perturbed-tag r) (recorded-index r) factor v)))

;; slope · factor as a flonum; the slope may be a constant.
(define-syntax fl-times
  (syntax-rules ()
    [(_ 1 factor) factor]
    [(_ -1 factor) (fl* -1.0 factor)]
    [(_ slope factor) (fl* slope factor)]))

(define (record-unary-generally op r x)
  (define-values (value slope) (value-and-slope op x))
  (scaled r slope value))

;; The value whose differential is slope times that of r.
(define (scaled r slope value)
  (record (recorded-tape r) (recorded-index r) (times slope (recorded-factor r)) value))

;; Of two different tapes, and of a tape and the ε of another derivative, the
;; outermost decides; for it the other number is constant.
(define (record-binary op a b)
  (cond [(not (recorded? a)) (if (perturbed? a) (by-outermost op a b) (by-second op a b))]
        [(not (recorded? b)) (if (perturbed? b) (by-outermost op a b) (by-first op a b))]
        [(eq? (recorded-tape a) (recorded-tape b)) (by-both op a b)]
        [else (by-outermost op a b)]))

(define (by-outermost op a b)
  (define owner (outermost a b))
  (cond [(not (recorded? owner)) ((kind-binary (carrier-kind owner)) op a b)]
        [(eq? owner a) (by-first op a b)]
        [else (by-second op a b)]))

;; use : value derivative ... -> form
(define-syntax-rule (case-arithmetic op x y use general)
  (case-at-flonums op (x y) use
    [generic:+ +] [generic:* *] [generic:- -] [generic:/ /] [else general]))

(define (by-first op a y)
  (define-values (x f) (values (recorded-value a) (recorded-factor a)))
  (define-syntax-rule (in-place value by-x by-y) (construct-like a (fl-times by-x f) value))
  (if (and (flonum? x) (flonum? y) (flonum? f))
      (case-arithmetic op x y in-place (by-first-generally op a x y))
      (by-first-generally op a x y)))

(define (by-first-generally op a x y)
  (define value ((generic-op-procedure op) x y))
  (define slope (first-slope op x y value))
  (if (and (eq? slope 0) (constant? slope #f x y)) value (scaled a slope value)))

(define (by-second op x b)
  (define-values (y f) (values (recorded-value b) (recorded-factor b)))
  (define-syntax-rule (in-place value by-x by-y) (construct-like b (fl-times by-y f) value))
  (if (and (flonum? x) (flonum? y) (flonum? f))
      (case-arithmetic op x y in-place (by-second-generally op x b y))
      (by-second-generally op x b y)))

(define (by-second-generally op x b y)
  (define value ((generic-op-procedure op) x y))
  (define slope (second-slope op x y value))
  (if (and (eq? slope 0) (constant? #f slope x y)) value (scaled b slope value)))

(define (by-both op a b)
  (define-values (x y) (values (recorded-value a) (recorded-value b)))
  (define-values (i j) (values (recorded-index a) (recorded-index b)))
  (define-values (f g) (values (recorded-factor a) (recorded-factor b)))
  (define-syntax-rule (in-place value by-x by-y)
    (let* ([tape (recorded-tape a)]
           [v value]
           [k (join-flonums! tape i (fl-times by-x f) j (fl-times by-y g))])
      (construct-recorded tape (perturbed-tag a) k 1.0 v)))
  (if (and (flonum? x) (flonum? y) (flonum? f) (flonum? g) (not (eq? i j)))
      (case-arithmetic op x y in-place (by-both-generally op a b))
      (by-both-generally op a b)))

(define (by-both-generally op a b)
  (define-values (value by-a by-b) (value-and-slopes op (recorded-value a) (recorded-value b)))
  (join (recorded-tape a)
        (recorded-index a) (times by-a (recorded-factor a))
        (recorded-index b) (times by-b (recorded-factor b))
        value))

;; The value with the differential a dzᵢ + b dzⱼ.
(define (join tape i a j b value)
  (cond [(eq? i j) (record tape i (g:+ a b) value)]
        [(eq? a 0) (record tape j b value)]
        [(eq? b 0) (record tape i a value)]
        [else (record tape (join! tape i a j b) (unit value) value)]))

;; The value whose differential is the sum of those of the recorded numbers of
;; one tape, each times its slope.
(define (record-sum value slopes rs)
  (for/fold ([sum value]) ([slope (in-list slopes)] [r (in-list rs)])
    (define part (times slope (recorded-factor r)))
    (define tape (recorded-tape r))
    (if (and (recorded? sum) (eq? (recorded-tape sum) tape))
        (join tape (recorded-index sum) (recorded-factor sum) (recorded-index r) part value)
        (record tape (recorded-index r) part value))))

;; ---------------------------------------------------------------------------
;; Derivatives

;; The derivatives of the scalar y by the variables of the tape, in a vector.
(define (derivatives tape y)
  (cond [(on-tape? y tape) (derivatives-of y)]
        [(and (perturbed? y) (> (perturbed-tag y) (tape-tag tape)))
         (for/vector #:length (tape-inputs tape) ([i (in-range (tape-inputs tape))])
           ((parts-map (parts-of y)) (lambda (part) (vector-ref (derivatives tape part) i)) y))]
        [else (make-vector (tape-inputs tape) 0)]))

(define (value-and-derivatives tape y)
  (values (if (on-tape? y tape) (recorded-value y) y) (derivatives tape y)))

(define (on-tape? x tape) (and (recorded? x) (eq? (recorded-tape x) tape)))

(define (derivatives-of r) (sweep (recorded-tape r) (recorded-index r) (recorded-factor r)))

;; r with its parts changed by a linear map: its value, and its derivatives by all variables.
(define (map-parts f r)
  (define tape (recorded-tape r))
  (define index (recorded-index r))
  (define (part i slope) (g:* (f slope) (record-input tape i 0)))
  (define value (f (recorded-value r)))
  (cond [(< index (tape-inputs tape)) (g:+ value (part index (recorded-factor r)))]
        [else
         (for/fold ([sum value]) ([slope (in-vector (derivatives-of r))] [i (in-naturals)]
                                  #:unless (eqv? 0 slope))
           (g:+ sum (part i slope)))]))

;; Of one tape, with equal values and equal derivatives by all variables?
(define (same-recorded? same? a b)
  (and (eq? (recorded-tape a) (recorded-tape b))
       (same? (recorded-value a) (recorded-value b))
       (or (and (eqv? (recorded-index a) (recorded-index b))
                (same? (recorded-factor a) (recorded-factor b)))
           (for/and ([x (in-vector (derivatives-of a))] [y (in-vector (derivatives-of b))])
             (same? x y)))))
