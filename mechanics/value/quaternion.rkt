#lang racket/base
;; Quaternions: q = r + x i + y j + z k, with i² = j² = k² = i j k = −1 (SICM 2.12).
;;
;; With v = (x, y, z) for the parts that are not the real one,
;;
;;   (r, v) (s, w) = (r s − v·w, r w + s v + v × w),   q* = (r, −v),   1/q = q*/(q q*),
;;
;; and e^(r + v) = eʳ (cos |v| + v̂ sin |v|).  A number counts as the quaternion without v.

(require "structure.rkt"
         "../error/complain.rkt" "../error/hint.rkt"
         "../generic/arithmetic.rkt" "../generic/compare.rkt" "../generic/describe.rkt"
         "../generic/dispatch.rkt" "../generic/elementary.rkt" "../generic/kind.rkt"
         "../generic/notation.rkt"
         "../generic/scalar.rkt"
         "../generic/sums-and-products.rkt" "../generic/up-down.rkt" "../generic/value-struct.rkt"
         "../generic/wrong-argument.rkt")

(provide quaternion? quaternion make-quaternion real&3vector->quaternion
         quaternion->vector quaternion->3vector quaternion->real-part quaternion-ref
         q:conjugate q:magnitude q:make-unit
         check-quaternion)

;; ---------------------------------------------------------------------------
;; The kind

(define kind:quaternion
  (make-kind #:rank rank:quaternion
             #:describe (lambda (q) "a quaternion")
             #:datum (lambda (q) (cons 'quaternion (map value->datum (parts q))))
             #:notation (lambda (q see) (quaternion-notation (parts q) see))
             #:map (lambda (f q) (scale (lambda (x) (map-leaves f x)) q))
             #:component quaternion-ref
             #:unary unary
             #:binary combine
             #:same? (lambda (same? a b) (andmap same? (parts a) (parts b)))
             #:zero? (lambda (q) (andmap g:zero? (parts q)))))

(value-struct hamilton (r x y z)
  #:kind kind:quaternion
  #:equal-by parts)

(define (parts q) (list (hamilton-r q) (hamilton-x q) (hamilton-y q) (hamilton-z q)))

(define (quaternion? x) (hamilton? x))

;; a + b i + c j + d k, the units upright and bold, without the parts that are 0; a + 0 i of a
;; real one, which is no number.
(define (quaternion-notation parts see)
  (define real? (andmap (lambda (part) (eqv? part 0)) (cdr parts)))
  (define (shown? part unit)
    (or (not (eqv? part 0)) (and real? (equal? unit "𝐢"))))
  (tree:sum
   (for/list ([part (in-list parts)] [unit (in-list '(#f "𝐢" "𝐣" "𝐤"))]
              #:when (shown? part unit))
     (if unit (tree:product (list (see part) (tree:word unit)) #f) (see part)))))

;; ---------------------------------------------------------------------------
;; Making and taking apart

(define (quaternion r x y z)
  (for ([part (in-list (list r x y z))])
    (unless (scalar? part)
      (complain 'quaternion "its four parts are numbers; given ~a~a"
                (describe-with-value part)
                (if (tuple? part) "\n  of a tuple of four, (make-quaternion (up r x y z))" ""))))
  (hamilton r x y z))

;; v : a tuple of four numbers, or a list of them
(define (make-quaternion v)
  (define four (cond [(tuple? v) (structure->list v)] [(list? v) v] [else '()]))
  (unless (= (length four) 4)
    (complain-of-argument 'make-quaternion "a tuple of 4 numbers, the real part first" v))
  (apply quaternion four))

(define (real&3vector->quaternion r v)
  (check-vector 'real&3vector->quaternion v)
  (apply quaternion r (structure->list v)))

(define (check-vector who v)
  (unless (and (tuple? v) (= (s:length v) 3))
    (complain-of-argument who "a tuple of 3 components" v (list-hint v))))

(define (check-quaternion who q)
  (unless (hamilton? q)
    (complain-of-argument who "a quaternion" q
                          (if (and (tuple? q) (= (s:length q) 4))
                              "\n  (make-quaternion ...) makes one of a tuple of 4"
                              ""))))

(define (quaternion->vector q)
  (check-quaternion 'quaternion->vector q)
  (apply up (parts q)))
(define (quaternion->3vector q)
  (check-quaternion 'quaternion->3vector q)
  (vector-part q))
(define (quaternion->real-part q)
  (check-quaternion 'quaternion->real-part q)
  (hamilton-r q))
(define (quaternion-ref q i)
  (check-quaternion 'quaternion-ref q)
  (unless (memv i '(0 1 2 3))
    (complain 'quaternion-ref "the parts of a quaternion are numbered 0 to 3; given ~a"
              (describe-with-value i)))
  (list-ref (parts q) i))

(define (vector-part q) (apply up (cdr (parts q))))
(define (of r v) (apply hamilton r (structure->list v)))

;; ---------------------------------------------------------------------------
;; Conjugate and magnitude

(define (q:conjugate q)
  (check-quaternion 'q:conjugate q)
  (of (hamilton-r q) (g:negate (vector-part q))))
(define (q:magnitude q)
  (check-quaternion 'q:magnitude q)
  (g:sqrt (norm q)))
(define (q:make-unit q)
  (check-quaternion 'q:make-unit q)
  (define size (q:magnitude q))
  (when (g:zero? size)
    (complain 'q:make-unit "the quaternion 0 has no direction"))
  (scale (lambda (x) (g:/ x size)) q))

;; q q*, a number
(define (norm q) (g:for/sum ([x (in-list (parts q))]) (g:square x)))

(define (scale f q) (apply hamilton (map f (parts q))))

;; ---------------------------------------------------------------------------
;; Arithmetic

(define (combine op a b)
  (case (generic-op-name op)
    [(+ -) (add op a b)]
    [(*) (multiply op a b)]
    [(/) (if (hamilton? b)
             (scale (lambda (x) (g:/ x (norm b))) (multiply op a (q:conjugate b)))
             (multiply op a (g:/ 1 b)))]
    [(expt) (power op a b)]
    [else (raise-inapplicable op a b)]))

(define (add op a b)
  (define (as-quaternion x)
    (cond [(hamilton? x) x]
          [(scalar? x) (hamilton x 0 0 0)]
          [else (raise-inapplicable op a b)]))
  (apply hamilton (map (generic-op-procedure op)
                       (parts (as-quaternion a)) (parts (as-quaternion b)))))

(define (multiply op a b)
  (cond [(and (hamilton? a) (hamilton? b)) (product a b)]
        [(and (hamilton? a) (scalar? b)) (scale (lambda (x) (g:* x b)) a)]
        [(and (scalar? a) (hamilton? b)) (scale (lambda (x) (g:* a x)) b)]
        [else (raise-inapplicable op a b)]))

(define (product a b)
  (define-values (r v) (values (hamilton-r a) (vector-part a)))
  (define-values (s w) (values (hamilton-r b) (vector-part b)))
  (of (g:- (g:* r s) (dot-product v w))
      (g:+ (g:* r w) (g:* s v) (cross-product v w))))

;; By repeated squaring.
(define (power op q n)
  (unless (and (hamilton? q) (exact-integer? n)) (raise-inapplicable op q n))
  (cond [(negative? n) (combine generic:/ 1 (power op q (- n)))]
        [(zero? n) (hamilton 1 0 0 0)]
        [(odd? n) (product (power op q (- n 1)) q)]
        [else (define root (power op q (quotient n 2)))
              (product root root)]))

(define (unary op q)
  (case (generic-op-name op)
    [(exp) (exponential q)]
    [(abs magnitude) (q:magnitude q)]
    [(conjugate) (q:conjugate q)]
    [(real-part) (hamilton-r q)]
    [(exact->inexact inexact->exact) (scale (generic-op-procedure op) q)]
    [else (raise-inapplicable op q)]))

(define (exponential q)
  (define size (euclidean-norm (vector-part q)))
  (define stretch (g:exp (hamilton-r q)))
  (if (g:zero? size)
      (hamilton stretch 0 0 0)
      (of (g:* stretch (g:cos size))
          (g:* (g:/ (g:* stretch (g:sin size)) size) (vector-part q)))))
