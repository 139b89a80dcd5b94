#lang racket/base
;; Sums of logarithms, and sums of arcs, that vanish.
;;
;; *Logarithms.*  Real ones have positive arguments, and the exponential of real numbers is one to
;; one:
;;
;;     Σ nᵢ log uᵢ + R = 0      if      ∏ uᵢ^nᵢ · e^R = 1.
;;
;; Inverse hyperbolic functions are logarithms.
;;
;; *Arcs.*  Each is the angle of a complex number: atan u that of 1 + iu, asin u of √(1 − u²) + iu,
;; acos u of u + i√(1 − u²), the angle of the point (x, y) that of x + iy.  The sum Σ nᵢ αᵢ + R is
;; the angle of Z = ∏ zᵢ^nᵢ · (cos R + i sin R), up to whole turns.  So it is zero if Z is positive,
;; that is, if Im Z = 0 and Re Z ≥ 0, and if the range of the sum leaves no other whole turn.

(require racket/list
         "in-exponentials.rkt" "real-signs.rkt"
         "../assumption/assumption-set.rkt" "../assumption/interval.rkt"
         "../assumption/leaf-bounds.rkt" "../assumption/range.rkt" "../assumption/signs.rkt"
         "../expression/conjugate.rkt" "../expression/expression.rkt" "../expression/nodes.rkt"
         "../expression/operation.rkt"
         "../expression/substitute.rkt"
         "../simplify/simplify-expression.rkt"
         (only-in "../../numeric/finite-number.rkt" exact-rational?))

(provide in-logarithms product-of-logarithms angle-of-arcs)

;; ---------------------------------------------------------------------------
;; Inverse hyperbolic functions

;; e with logarithms for asinh, acosh and atanh, exponentials for hyperbolic functions of
;; logarithms, and a quotient for the tangent of half an arc
(define (in-logarithms e)
  (node-fold e
             values
             (lambda (n args)
               (define u (and (pair? args) (car args)))
               (define write (hash-ref as-logarithms (node-head n) #f))
               (cond [write (write u)]
                     [(and (hyperbolic? n) (pair? (applications-of op:log u)))
                      (hyperbolic-in-exponentials (rebuild (node-head n) args))]
                     [(and (eq? (node-head n) op:tan) (half-arc u)) => tangent-of-half]
                     [(andmap eq? args (node-args n)) n]
                     [else (rebuild (node-head n) args)]))))

(define (hyperbolic? n) (memq (node-head n) (list op:sinh op:cosh op:tanh)))

;; -> the arc of which u is the half, or #f
(define (half-arc u)
  (define args (if (node? u) (node-args u) '()))
  (and (= (length args) 2)
       (or (equal? (cons (node-head u) (car args)) (cons op:* 1/2))
           (equal? (cons (node-head u) (cadr args)) (cons op:/ 2)))
       (let ([arc (if (eq? (node-head u) op:*) (cadr args) (car args))])
         (and (node? arc) (memq (node-head arc) arc-heads) arc))))

(define (tangent-of-half arc)
  (define z (arc-point arc))
  (define size (e:sqrt (e:+ (square (complex-x z)) (square (complex-y z)))))
  (e:/ (complex-y z) (e:+ size (complex-x z))))

;; Of an exact number the value as it is: √2 is no decimal
(define (function op)
  (lambda (u)
    (define value (e:apply op u))
    (if (and (number? value) (inexact? value)) (make-node op (list u)) value)))

(define-values (e:sqrt e:log e:exp) (values (function op:sqrt) (function op:log) (function op:exp)))
(define-values (e:cos e:sin) (values (function op:cos) (function op:sin)))
(define (square u) (e:expt u 2))

(define as-logarithms
  (hasheq op:asinh (lambda (u) (e:log (e:+ u (e:sqrt (e:+ (square u) 1)))))
          op:acosh (lambda (u) (e:log (e:+ u (e:sqrt (e:- (square u) 1)))))
          op:atanh (lambda (u) (e:* 1/2 (e:log (e:/ (e:+ 1 u) (e:- 1 u)))))))

;; ---------------------------------------------------------------------------
;; Sums of functions

;; e = c (Σ nᵢ fᵢ + R) with whole numbers nᵢ, where R holds none of the functions
(struct whole-sum (multiples functions rest) #:authentic)

;; functions : nodes in e -> whole-sum, or #f if e is no such sum of them, as where it has no value
;; for functions that are 0 or 1
(define (sum-of e functions A)
  (with-handlers ([exn:fail:contract:divide-by-zero? (lambda (x) #f)])
    (linear-sum e functions A)))

(define (linear-sum e functions A)
  (define marks (map (lambda (f) (string->uninterned-symbol "f")) functions))
  (define marked (substitute-expression e (map cons functions marks)))
  (define (with . numbers) (substitute-expression marked (map cons marks numbers)))
  (define (simple e) (simplify-where e A))
  (define none (apply with (map (lambda (f) 0) functions)))
  (define coefficients
    (for/list ([f (in-list functions)])
      (simple (e:- (apply with (map (lambda (g) (if (eq? f g) 1 0)) functions)) none))))
  (define (linear?)
    (define rest
      (for/fold ([r (e:- marked none)]) ([m (in-list marks)] [c (in-list coefficients)])
        (e:- r (e:* c m))))
    (eqv? 0 (simple rest)))
  (define unit (findf (lambda (c) (not (eqv? c 0))) coefficients))
  (and unit
       (linear?)
       (let ([ratios (for/list ([c (in-list coefficients)]) (simple (e:/ c unit)))])
         (and (andmap exact-rational? ratios)
              (let ([n (apply lcm (map denominator ratios))])
                (whole-sum (map (lambda (q) (* n q)) ratios)
                           functions
                           (simple (e:* n (e:/ none unit)))))))))


(define (functions-in e heads)
  (remove-duplicates (append-map (lambda (head) (applications-of head e)) heads)))

;; The product of factor(f)^n over the functions; a power with a negative exponent is `inverse`.
(define (product-over s factor one times inverse)
  (for/fold ([z one]) ([n (in-list (whole-sum-multiples s))] [f (in-list (whole-sum-functions s))])
    (define u (factor f))
    (for/fold ([z z]) ([_ (in-range (abs n))]) (times z (if (> n 0) u (inverse u))))))

;; ---------------------------------------------------------------------------
;; Logarithms

;; -> an expression that is zero where e is; #f if e is no sum of logarithms
(define (product-of-logarithms e A)
  (define logs (applications-of op:log e))
  (define (log? n) (headed? n op:log))
  (define (nested? f) (some-node? log? (car (node-args f))))
  (define s (and (pair? logs) (not (ormap nested? logs)) (sum-of e logs A)))
  (and s
       (let ([product
              (product-over s (lambda (f) (car (node-args f))) 1 e:* (lambda (u) (e:/ 1 u)))])
         (e:- (e:* product (e:exp (whole-sum-rest s))) 1))))

;; ---------------------------------------------------------------------------
;; Arcs

(define arc-heads (list op:atan op:asin op:acos))

;; -> two expressions, Im Z and Re Z : e is zero where the first is 0 and the second not negative;
;; #f #f if e is no sum of arcs, or one with too wide a range
(define (angle-of-arcs e A)
  (define arcs (functions-in e arc-heads))
  (define s (and (pair? arcs) (sum-of e arcs A)))
  (cond [(and s (or (difference-of-angles? s) (within-one-turn? s A)))
         (define R (whole-sum-rest s))
         (define turned (complex (e:cos R) (e:sin R)))
         (define Z (product-over s arc-point turned complex* conjugated))
         (values (complex-y Z) (complex-x Z))]
        [else (values #f #f)]))

(struct complex (x y) #:authentic)

(define (complex* z w)
  (define-values (a b c d) (values (complex-x z) (complex-y z) (complex-x w) (complex-y w)))
  (complex (e:- (e:* a c) (e:* b d)) (e:+ (e:* a d) (e:* b c))))

(define (conjugated z) (complex (complex-x z) (e:* -1 (complex-y z))))

(define (arc-point n)
  (define u (car (node-args n)))
  (define (other) (e:sqrt (e:- 1 (square u))))
  (cond [(pair? (cdr (node-args n))) (complex (cadr (node-args n)) u)]
        [(eq? (node-head n) op:atan) (complex 1 u)]
        [(eq? (node-head n) op:asin) (complex (other) u)]
        [else (complex u (other))]))

;; Angles of points are above −π and at most π: two of them differ by less than a turn.
(define (difference-of-angles? s)
  (and (equal? (sort (whole-sum-multiples s) <) '(-1 1))
       (andmap (lambda (f) (pair? (cdr (node-args f)))) (whole-sum-functions s))
       (eqv? 0 (whole-sum-rest s))))

(define (within-one-turn? s A)
  (define bounds (bounds-around (assumptions-relations A)))
  (define (places leaf) (bounds-of bounds leaf))
  (define range
    (for/fold ([r (range-over (whole-sum-rest s) places)])
              ([n (in-list (whole-sum-multiples s))] [f (in-list (whole-sum-functions s))])
      (interval-sum r (interval-product (point-interval n) (arc-range f A places)))))
  (and (< (- turn) (interval-low range)) (< (interval-high range) turn)))

(define turn 6.28)
(define quarter 11/7)

;; The range of an arc: by that of its argument, and by its sign
(define (arc-range n A places)
  (define args (node-args n))
  (define signs (real-signs (car args) A))
  (define range (range-over n places))
  (define right (if (pair? (cdr args)) (real-signs (cadr args) A) positive))
  (define (within low high) (intersection range (interval low high)))
  (cond [(eq? (node-head n) op:acos)
         (within 0 (if (signs-within? signs nonnegative) quarter (* 2 quarter)))]
        [(signs-within? right nonnegative)
         (within (if (signs-within? signs nonnegative) 0 (- quarter))
                 (if (signs-within? signs nonpositive) 0 quarter))]
        [(signs-within? signs nonnegative) (within 0 (* 2 quarter))]
        [(signs-within? signs negative) (within (* -2 quarter) 0)]
        [else range]))
