#lang racket/base
;; Literal functions: functions of which only the name and the shape are known.
;;
;; Applied to plain values, a literal function gives the expression `(f x)`;
;; applied to dual numbers it obeys the chain rule, its partial derivatives
;; being further literal functions.  One whose range is a structure is that
;; structure of literal functions: `f^0 f^1` when up, `f_0 f_1` when down.

(require (only-in racket/string string-join)
         "dual.rkt" "Taylor-number.rkt" "perturbed-value.rkt" "recorded-number.rkt"
         "../algebra/expression/expression.rkt" "../algebra/expression/operation.rkt"
         "../algebra/expression/write.rkt"
         "../error/complain.rkt" "../error/hint.rkt" "../error/message-words.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/function.rkt"
         "../generic/kind.rkt" "../generic/notation.rkt" "../generic/operation-rule/recurrence.rkt"
         "../generic/sums-and-products.rkt" "../generic/irrational.rkt"
         "../generic/up-down.rkt"
         "../generic/value-struct.rkt" "../generic/wrong-argument.rkt"
         "../value/signature.rkt"
         "../value/series/coefficients.rkt" "../value/series/series.rkt")

(provide literal-function literal-function? literal-function-takes?
         literal-up literal-down literal-number
         ;; for expressions that are evaluated
         apply-head)

(define kind:unknown
  (make-kind #:rank rank:function
             #:closed? #t
             #:describe (lambda (f) (format "a literal function ~a" (signature->text f)))
             #:datum (lambda (f) (head->datum (unknown-head f)))
             #:notation (lambda (f see) (unknown-notation f))
             #:arity (lambda (f) (signature-arity-mask (unknown-signature f)))))

(value-struct unknown (head signature)
  #:kind kind:unknown
  #:equality (lambda (f g recur) (head=? (unknown-head f) (unknown-head g)))
             (lambda (f recur) (head-hash (unknown-head f)))
  #:property prop:procedure
  (case-lambda
    [(f x) (if (eq? (unknown-signature f) default-signature)
               (apply-to-scalar f x)
               (apply-unknown f (list x)))]
    [(f . args) (apply-unknown f args)]))

(define (literal-function? x) (unknown? x))
(define (signature->text f) (datum->text (signature-datum (unknown-signature f))))

;; The function with its signature, unless that is the default one of a function of time.
(define (unknown-notation f)
  (define s (unknown-signature f))
  (define shown (tree:datum (head->datum (unknown-head f))))
  (if (or (eq? s default-signature) (pair? (literal-head-index (unknown-head f))))
      shown
      (tree:relation shown ":" (tree:word (signature->line (signature-datum s))))))

;; up(ℝ, ℝ) → ℝ
(define (signature->line d)
  (define (listed ds separator)
    (string-join (map signature->line ds) separator))
  (cond [(eq? d 'Real) "ℝ"]
        [(not (and (pair? d) (list? d))) (datum->text d)]
        [else
         (case (car d)
           [(->) (listed (cdr d) " → ")]
           [(X) (listed (cdr d) " × ")]
           [(UP DOWN) (format "~a(~a)" (if (eq? (car d) 'UP) "up" "down") (listed (cdr d) ", "))]
           [else (datum->text d)])]))

;; (literal-function 'f), or with a signature such as (-> (UP Real Real) Real).
(define (literal-function name [signature-datum #f])
  (check-argument 'literal-function symbol? name "a quoted name, such as 'f")
  (if signature-datum
      (let ([s (parse-signature signature-datum)])
        (literal-of-range name s (signature-range s)))
      (unknown (make-literal-head name) default-signature)))

(define (literal-of-range name s range)
  (cond [(structure? range)
         (name-components name range (lambda (n shape) (literal-of-range n s shape)))]
        [(signature? range) (function-valued name s range)]
        [else (unknown (make-literal-head name) s)]))

;; A function whose values are functions knows all their arguments: ((f x) y) is (f x y).
(define (function-valued name s range)
  (define-values (outer inner) (values (signature-domain s) (signature-domain range)))
  (unless (and (list? outer) (list? inner))
    (complain 'literal-function
              "a function whose values are functions has a known number of arguments\n  given: ~a"
              (datum->text (signature-datum s))))
  (define all-at-once
    (literal-of-range name
                      (signature (append outer inner) (signature-range range) (signature-datum s))
                      (signature-range range)))
  (define declared (unknown (make-literal-head name) s))
  (make-function
   (lambda args
     (unless (literal-function-takes? declared args) (raise-misfit declared args))
     (make-function (lambda more (apply all-at-once (append args more)))
                    (signature-arity-mask range)
                    (lambda () (cons name (map value->datum args)))))
   (signature-arity-mask s)
   (lambda () name)))

;; The structure like `shape` whose components are (make component-name part).
(define (name-components name shape make)
  (define mark (if (up? shape) "^" "_"))
  (same-orientation
   shape
   (for/vector ([part (in-vector (structure-elements shape))] [i (in-naturals)])
     (make (string->symbol (format "~a~a~a" name mark i)) part))))

(define (literal-up name n) (literal-tuple 'literal-up up name n))
(define (literal-down name n) (literal-tuple 'literal-down down name n))

(define (literal-tuple who make name n)
  (check-argument who symbol? name "a quoted name, such as 'x")
  (check-argument who exact-nonnegative-integer? n "a number of components")
  (name-components name (apply make (for/list ([_ (in-range n)]) 'Real))
                   (lambda (component shape) component)))

(define (literal-number name)
  (check-argument 'literal-number symbol? name "a quoted name, such as 'm")
  name)

;; ---------------------------------------------------------------------------
;; Application

;; f at x, for the common case of a function of one real variable
(define (apply-to-scalar f x)
  (cond [(expression? x) (make-node (unknown-head f) (list x))]
        [(or (perturbed? x) (other-number? x)) (apply-head (unknown-head f) (list x))]
        [(series? x) (apply-to-series f x)]
        [else (raise-misfit f (list x))]))

;; f(x₀ + x₁ + ⋯) is its Taylor series about x₀, of the increment x₁ + ⋯.
(define (apply-to-series f x)
  (define point (list (series-term x 0)))
  (define (coefficient k)
    (define-values (head factorial)
      (for/fold ([head (unknown-head f)] [factorial 1]) ([j (in-range 1 (add1 k))])
        (values (literal-head-derivative head '()) (* j factorial))))
    (g:/ (apply-head head point) factorial))
  (define (increment k) (if (eqv? k 0) 0 (series-term x k)))
  ((power-series-of (make-coefficients coefficient))
   (like-series x (make-coefficients increment (series-length x)))))

(define (apply-unknown f args)
  (unless (literal-function-takes? f args) (raise-misfit f args))
  (apply-head (unknown-head f) args))

;; Do the arguments fit the signature?
(define (literal-function-takes? f args)
  (and (right-count? f args)
       (let-values ([(slot shape) (first-misfit (unknown-signature f) args)])
         (not slot))))

(define (right-count? f args)
  (bitwise-bit-set? (signature-arity-mask (unknown-signature f)) (length args)))

;; The outermost ε among the arguments decides how derivatives are taken.
(define (apply-head head args)
  (define leaves (argument-leaves args))
  (define outer
    (for/fold ([outer #f]) ([leaf (in-list leaves)] #:when (perturbed? (cdr leaf)))
      (if outer (outermost outer (cdr leaf)) (cdr leaf))))
  (cond [(not outer) (make-node head (map value->expression args))]
        [(jet? outer) (apply-to-jets head args leaves (perturbed-tag outer) (jet-order outer))]
        [(recorded? outer) (apply-to-recorded head args leaves (recorded-tape outer))]
        [else (apply-to-duals head args leaves (perturbed-tag outer))]))

;; f(x + x' ε) = f(x) + Σ ∂f/∂xᵢ(x) xᵢ' ε, over the scalars xᵢ of the arguments.
(define (apply-to-duals head args leaves tag)
  (define point (map-scalars (lambda (x) (primal-part x tag)) args))
  (make-dual
   tag
   (apply-head head point)
   (g:for*/sum ([leaf (in-list leaves)]
                [t (in-value (tangent-part (cdr leaf) tag))]
                #:unless (eqv? t 0))
     (g:* (apply-head (literal-head-derivative head (car leaf)) point) t))))

;; r = f(x₁, x₂, …) has r' = Σ ∂f/∂xᵢ xᵢ', whose coefficients are
;; k r_k = Σᵢ Σ_j j xᵢ_j (∂f/∂xᵢ)_{k-j}, those of ∂f/∂xᵢ being found alike, to an
;; order less; each mixed derivative once, by whatever route it is reached.
(define (apply-to-jets head args leaves tag order)
  (define point (map-scalars (lambda (x) (jet-value x tag)) args))
  (define varying
    (for/list ([leaf (in-list leaves)] #:when (jet-with-tag? (cdr leaf) tag)) leaf))
  (define known (make-hash))            ; index of a derivative -> its coefficients
  (define (coefficients head order)
    (define found (hash-ref known (literal-head-index head) #f))
    (cond [(and found (> (vector-length found) order)) found]
          [else
           (define r (make-vector (add1 order) 0))
           (vector-set! r 0 (apply-head head point))
           (for ([k (in-range 1 (add1 order))])
             (vector-set! r k (g:/ (g:for/sum ([leaf (in-list varying)])
                                     (weighted leaf head (sub1 order) k))
                                   k)))
           (hash-set! known (literal-head-index head) r)
           r]))
  (define (weighted leaf head order k)
    (define x (cdr leaf))
    (define slopes (coefficients (literal-head-derivative head (car leaf)) order))
    (weighted-convolution (lambda (j) (jet-coefficient x j)) +inf.0
                          (lambda (j) (vector-ref slopes j))
                          k))
  (make-jet tag order (coefficients head order)))

;; df = Σ ∂f/∂xᵢ dxᵢ
(define (apply-to-recorded head args leaves tape)
  (define point (map-scalars (lambda (x) (if (on-tape? x tape) (recorded-value x) x)) args))
  (define varying (for/list ([leaf (in-list leaves)] #:when (on-tape? (cdr leaf) tape)) leaf))
  (record-sum (apply-head head point)
              (for/list ([leaf (in-list varying)])
                (apply-head (literal-head-derivative head (car leaf)) point))
              (map cdr varying)))

(define (map-scalars f args)
  (for/list ([a (in-list args)]) (map-leaves f a)))

;; The scalars of the arguments, each with the path that `partial` takes to it.
(define (argument-leaves args)
  (define (walk x path leaves)
    (if (tuple? x)
        (for/fold ([leaves leaves])
                  ([e (in-vector (tuple-elements x))] [i (in-naturals)])
          (walk e (cons i path) leaves))
        (cons (cons (reverse path) x) leaves)))
  (if (null? (cdr args))
      (walk (car args) '() '())
      (for/fold ([leaves '()]) ([a (in-list args)] [i (in-naturals)])
        (walk a (list i) leaves))))

(define (value->expression x)
  (cond [(tuple? x)
         (define s (adopt x))
         (make-node (if (up? s) op:up op:down)
                    (for/list ([e (in-vector (structure-elements s))])
                      (value->expression e)))]
        [(other-number? x) (other-number->expression x)]
        [else x]))

;; ---------------------------------------------------------------------------
;; Errors

(define (raise-misfit f args)
  (define name (value->text f))
  (unless (right-count? f args) (raise-other-count f name args))
  (define-values (slot shape) (first-misfit (unknown-signature f) args))
  (define a (list-ref args slot))
  (complain name "was declared ~a; slot ~a got ~a~a" (signature->text f) slot
            (describe-with-value a) (remedy name shape a (null? (cdr args)))))

(define (raise-other-count f name args)
  (define domain (signature-domain (unknown-signature f)))
  (complain name "was declared ~a, which takes ~a; given ~a: ~a" (signature->text f)
            (if (list? domain) (counted (length domain) "argument") "at least 1 argument")
            (length args) (value->text args)))

(define (remedy name shape x alone?)
  (cond [(and (eq? shape 'Real) (tuple? x))
         (format "\n  a signature such as (-> ~a Real) declares a function of tuples"
                 (datum->text (shape->datum (shape-of x))))]
        [(and (eq? shape 'Real) alone? (procedure? x))
         (format "\n  what takes it of the values of a function is (compose ~a ~a)" name
                 (value->text x))]
        [else (list-hint x)]))

(define (shape-of x)
  (if (tuple? x) (structure-map shape-of (adopt x)) 'Real))
