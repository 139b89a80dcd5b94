#lang racket/base
;; Sound rewrites: truths about numbers, read in one direction, one rule a law.
;;
;; A rule maps a node it fits to an expression of the same value.  The
;; condition for it to be true is its kind:
;;
;;   always    wherever both sides are defined
;;   positive  for positive operands, as simplification takes roots and
;;             logarithms; it says so among its assumptions
;;   respelt   always, with angles or exponents that did not occur, or denominators
;;             too long to be freed of roots: results may print otherwise
;;   outside   the same, where the expression is not under another function

(require mechanics/algebra/expression/expression
         mechanics/algebra/expression/operation)

(provide (struct-out rule) rules rule-named)

(struct rule (name kind procedure) #:authentic)

(define (f op . args) (make-node op args))
(define (+: . es) (make-node op:+ es))
(define (*: . es) (make-node op:* es))
(define (-: u v) (make-node op:- (list u v)))
(define (/: u v) (make-node op:/ (list u v)))
(define (^: u n) (make-node op:expt (list u n)))
(define (neg u) (*: -1 u))
(define (sin: u) (f op:sin u))
(define (cos: u) (f op:cos u))
(define (tan: u) (f op:tan u))
(define (exp: u) (f op:exp u))
(define (log: u) (f op:log u))
(define (sqrt: u) (f op:sqrt u))
(define (abs: u) (f op:abs u))
(define (sinh: u) (f op:sinh u))
(define (cosh: u) (f op:cosh u))

(define (first-arg e) (car (node-args e)))
(define (second-arg e) (cadr (node-args e)))
(define (sum? e) (and (headed? e op:+) (pair? (cdr (node-args e)))))
(define (rest-sum e)
  (define rest (cdr (node-args e)))
  (if (null? (cdr rest)) (car rest) (make-node op:+ rest)))
(define (rest-product e)
  (define rest (cdr (node-args e)))
  (if (null? (cdr rest)) (car rest) (make-node op:* rest)))
(define (fraction? k) (and (number? k) (exact? k) (not (integer? k))))

;; [name kind (operation arg ...) result]: a node of that operation with so many
;; operands; [name kind e result]: any.  No result is #f.
(define-syntax define-rules
  (syntax-rules ()
    [(_ id [name kind pattern result] ...)
     (define id (list (make-rule name kind pattern result) ...))]))

(define-syntax make-rule
  (syntax-rules ()
    [(_ name kind (op arg ...) result)
     (rule 'name 'kind
           (lambda (n)
             (and (headed? n op)
                  (= (length (node-args n)) (length '(arg ...)))
                  (apply (lambda (arg ...) result) (node-args n)))))]
    [(_ name kind n result)
     (rule 'name 'kind (lambda (n) result))]))

;; ---------------------------------------------------------------------------
;; Any expression

(define-rules neutral-rules
  [add-zero always e (+: e 0)]
  [add-a-difference always e (+: e (-: (+: 'a 'b) (+: 'b 'a)))]
  [times-one always e (*: 1 e)]
  [times-quotient always e (*: e (/: (+: 'a 'b) (+: 'b 'a)))]
  [first-power always e (^: e 1)]
  [minus-minus always e (neg (neg e))]
  [reciprocal-of-reciprocal always e (/: 1 (/: 1 e))]
  [two-halves always e (+: (/: e 2) (*: 1/2 e))]
  [add-and-subtract always e (-: (+: e 'c) 'c)]
  [times-pythagoras always e (*: e (+: (^: (sin: 'c) 2) (^: (cos: 'c) 2)))]
  [times-hyperbolic-one respelt e (*: e (-: (^: (cosh: 'c) 2) (^: (sinh: 'c) 2)))]
  [times-secant respelt e (*: e (-: (/: 1 (^: (cos: 'b) 2)) (^: (tan: 'b) 2)))]
  [times-exponentials respelt e (*: e (exp: 'c) (exp: (neg 'c)))]
  [times-root positive e (/: (*: e (sqrt: 'c) (sqrt: 'c)) 'c)]
  [difference-of-squares always e (+: (/: (-: (^: e 2) (^: 'c 2)) (+: e 'c)) 'c)]
  [logarithm-of-exponential always e (log: (exp: e))]
  [sine-of-inverse-sine positive e (and (symbol? e) (sin: (f op:asin e)))]
  [cosine-of-inverse-cosine positive e (and (symbol? e) (cos: (f op:acos e)))]
  [tangent-of-inverse-tangent always e (tan: (f op:atan e))]
  [exponential-of-logarithm positive e (and (symbol? e) (exp: (log: e)))]
  [root-of-square positive e (and (symbol? e) (sqrt: (^: e 2)))]
  [square-of-root positive e (and (symbol? e) (^: (sqrt: e) 2))]
  [cube-of-root positive e (and (symbol? e) (^: (^: e 1/3) 3))])

;; ---------------------------------------------------------------------------
;; Sums, products, quotients, powers

(define-rules rational-rules
  [commute-sum always e (and (headed? e op:+) (make-node op:+ (reverse (node-args e))))]
  [associate-sum always e
    (and (sum? e) (+: (first-arg e) (rest-sum e)))]
  [commute-product always e (and (headed? e op:*) (make-node op:* (reverse (node-args e))))]
  [associate-product always e
    (and (headed? e op:*) (pair? (cdr (node-args e))) (*: (rest-product e) (first-arg e)))]
  [sum-as-difference always e (and (sum? e) (-: (first-arg e) (neg (rest-sum e))))]
  [factor-first-out always e
    (and (sum? e) (*: (first-arg e) (+: 1 (/: (rest-sum e) (first-arg e)))))]
  [sum-by-squares always e
    (and (sum? e)
         (/: (-: (^: (first-arg e) 2) (^: (rest-sum e) 2)) (-: (first-arg e) (rest-sum e))))]
  [difference-as-sum always (op:- u v) (+: u (neg v))]
  [swap-difference always (op:- u v) (neg (-: v u))]
  [difference-by-squares always (op:- u v) (/: (-: (*: u u) (*: v v)) (+: u v))]
  [difference-by-cubes respelt (op:- u v)
    (/: (-: (^: u 3) (^: v 3)) (+: (*: u u) (*: u v) (*: v v)))]
  [distribute always (op:* u v)
    (cond [(sum? v) (make-node op:+ (for/list ([w (in-list (node-args v))]) (*: u w)))]
          [(sum? u) (make-node op:+ (for/list ([w (in-list (node-args u))]) (*: w v)))]
          [(headed? v op:-) (-: (*: u (first-arg v)) (*: u (second-arg v)))]
          [else #f])]
  [product-by-squares always (op:* u v) (/: (-: (^: (+: u v) 2) (^: (-: u v) 2)) 4)]
  [product-as-quotient always (op:* u v) (/: u (/: 1 v))]
  [quotient-as-power always (op:/ u v) (*: u (^: v -1))]
  [split-fraction always (op:/ u v)
    (and (sum? u) (+: (/: (first-arg u) v) (/: (rest-sum u) v)))]
  [expand-fraction always (op:/ u v) (/: (*: u (+: 'c 'x)) (*: (+: 'x 'c) v))]
  [invert-fraction always (op:/ u v) (/: 1 (/: v u))]
  [partial-fractions always (op:/ u v)
    (-: (/: u v) (-: (/: 1 (*: 'a (+: 'a 1))) (-: (/: 1 'a) (/: 1 (+: 'a 1)))))]
  [unroll-power always (op:expt u n)
    (and (exact-integer? n) (*: u (^: u (- n 1))))]
  [power-of-square always (op:expt u n)
    (and (exact-integer? n) (even? n) (^: (^: u 2) (quotient n 2)))]
  [power-below always (op:expt u n) (and (exact-integer? n) (/: 1 (^: u (- n))))]
  [binomial always (op:expt u n)
    (and (eqv? n 2) (sum? u)
         (let ([v (first-arg u)] [w (rest-sum u)])
           (+: (^: v 2) (*: 2 v w) (^: w 2))))]
  [binomial-cube always (op:expt u n)
    (and (eqv? n 3) (headed? u op:-)
         (let ([v (first-arg u)] [w (second-arg u)])
           (+: (^: v 3) (*: -3 v v w) (*: 3 v w w) (neg (^: w 3)))))])

;; ---------------------------------------------------------------------------
;; Roots

(define (root-of e)            ; -> radicand and exponent, or #f #f
  (cond [(headed? e op:sqrt) (values (first-arg e) 1/2)]
        [(and (headed? e op:expt) (fraction? (second-arg e)))
         (values (first-arg e) (second-arg e))]
        [else (values #f #f)]))

(define-syntax-rule (with-root e (u k) result)
  (let-values ([(u k) (root-of e)])
    (and u result)))

(define-rules root-rules
  [root-as-power always (op:sqrt u) (^: u 1/2)]
  [half-power-as-root always (op:expt u k) (and (eqv? k 1/2) (sqrt: u))]
  [power-of-root always e (with-root e (u k) (^: (^: u (/ 1 (denominator k))) (numerator k)))]
  [root-of-root positive e (with-root e (u k) (^: (sqrt: u) (* 2 k)))]
  [fourth-roots positive e (with-root e (u k) (^: (^: u (/ k 2)) 2))]
  [integer-power-out always e (with-root e (u k) (*: u (^: u (- k 1))))]
  [root-below always e (with-root e (u k) (/: 1 (^: u (- k))))]
  [square-into-root positive e (with-root e (u k) (/: (^: (*: u (^: 'x 2)) k) (^: 'x (* 2 k))))]
  [number-into-root always e (with-root e (u k) (/: (^: (*: 64 u) k) (^: 64 k)))]
  [root-of-product positive e
    (with-root e (u k)
      (and (headed? u op:*) (pair? (cdr (node-args u)))
           (*: (^: (first-arg u) k) (^: (rest-product u) k))))]
  [root-of-quotient positive e
    (with-root e (u k)
      (and (headed? u op:/) (/: (^: (first-arg u) k) (^: (second-arg u) k))))]
  [rationalise always (op:/ u v)
    (and (headed? v op:sqrt) (/: (*: u v) (first-arg v)))]
  [rationalise-a-sum always e
    (with-root e (u k)
      (and (eqv? k 1/2)
           (*: (-: u (^: 'c 2)) (/: 1 (-: e 'c)) (/: e (+: e 'c)))))])

;; ---------------------------------------------------------------------------
;; Circular functions

;; Halves of inverse functions are outside the class.
(define (divisible? u)
  (not (node-fold u
                  (lambda (leaf) #f)
                  (lambda (n parts)
                    (or (memq (node-head n) (list op:asin op:acos op:atan))
                        (ormap values parts))))))

(define (even-power? n) (and (exact-integer? n) (even? n) (positive? n)))

(define-rules circular-rules
  [sine-squared always (op:expt u n)
    (and (even-power? n) (headed? u op:sin)
         (^: (-: 1 (^: (cos: (first-arg u)) 2)) (quotient n 2)))]
  [cosine-squared always (op:expt u n)
    (and (even-power? n) (headed? u op:cos)
         (^: (-: 1 (^: (sin: (first-arg u)) 2)) (quotient n 2)))]
  [sine-squared-by-double respelt (op:expt u n)
    (and (eqv? n 2) (headed? u op:sin) (/: (-: 1 (cos: (*: 2 (first-arg u)))) 2))]
  [cosine-squared-by-double respelt (op:expt u n)
    (and (eqv? n 2) (headed? u op:cos) (/: (+: 1 (cos: (*: 2 (first-arg u)))) 2))]
  [secant-squared always (op:/ u v)
    (and (headed? v op:cos) (*: u v (+: 1 (^: (tan: (first-arg v)) 2))))]
  [sine-of-sum respelt (op:sin u)
    (and (sum? u)
         (let ([v (first-arg u)] [w (rest-sum u)])
           (+: (*: (sin: v) (cos: w)) (*: (cos: v) (sin: w)))))]
  [cosine-of-sum respelt (op:cos u)
    (and (sum? u)
         (let ([v (first-arg u)] [w (rest-sum u)])
           (-: (*: (cos: v) (cos: w)) (*: (sin: v) (sin: w)))))]
  [tangent-of-sum respelt (op:tan u)
    (and (sum? u)
         (let ([v (first-arg u)] [w (rest-sum u)])
           (/: (+: (tan: v) (tan: w)) (-: 1 (*: (tan: v) (tan: w))))))]
  [tangent-defined always (op:tan u) (/: (sin: u) (cos: u))]
  [sine-by-tangent always (op:sin u) (*: (tan: u) (cos: u))]
  [double-sine respelt (op:sin u)
    (and (divisible? u) (*: 2 (sin: (*: 1/2 u)) (cos: (*: 1/2 u))))]
  [double-cosine respelt (op:cos u)
    (and (divisible? u) (-: (^: (cos: (*: 1/2 u)) 2) (^: (sin: (*: 1/2 u)) 2)))]
  [double-tangent respelt (op:tan u)
    (and (divisible? u) (/: (*: 2 (tan: (/: u 2))) (-: 1 (^: (tan: (/: u 2)) 2))))]
  [triple-sine respelt (op:sin u)
    (and (divisible? u) (let ([v (/: u 3)]) (-: (*: 3 (sin: v)) (*: 4 (^: (sin: v) 3)))))]
  [triple-cosine respelt (op:cos u)
    (and (divisible? u) (let ([v (/: u 3)]) (-: (*: 4 (^: (cos: v) 3)) (*: 3 (cos: v)))))]
  [sine-by-half-tangent respelt (op:sin u)
    (and (divisible? u) (let ([t (tan: (*: 1/2 u))]) (/: (*: 2 t) (+: 1 (*: t t)))))]
  [cosine-by-half-tangent respelt (op:cos u)
    (and (divisible? u) (let ([t (tan: (*: 1/2 u))]) (/: (-: 1 (*: t t)) (+: 1 (*: t t)))))]
  [sine-odd always (op:sin u) (neg (sin: (neg u)))]
  [cosine-even always (op:cos u) (cos: (neg u))]
  [tangent-odd always (op:tan u) (neg (tan: (-: 0 u)))]
  [sine-shifted respelt (op:sin u)
    (-: (*: (sin: (+: u 'b)) (cos: 'b)) (*: (cos: (+: u 'b)) (sin: 'b)))]
  [cosine-shifted respelt (op:cos u)
    (+: (*: (cos: (-: u 'a)) (cos: 'a)) (neg (*: (sin: (-: u 'a)) (sin: 'a))))]
  [product-to-sum respelt (op:* u v)
    (and (headed? u op:sin) (headed? v op:cos)
         (let ([a (first-arg u)] [b (first-arg v)])
           (*: 1/2 (+: (sin: (+: a b)) (sin: (-: a b))))))]
  [cosines-to-sum respelt (op:* u v)
    (and (headed? u op:cos) (headed? v op:cos)
         (let ([a (first-arg u)] [b (first-arg v)])
           (*: 1/2 (+: (cos: (+: a b)) (cos: (-: a b))))))]
  [sum-to-product respelt (op:+ u v)
    (and (headed? u op:sin) (headed? v op:sin)
         (let ([a (first-arg u)] [b (first-arg v)])
           (*: 2 (sin: (*: 1/2 (+: a b))) (cos: (*: 1/2 (-: a b))))))]
  [cosine-of-arc always (op:cos u)
    (and (headed? u op:atan) (pair? (cdr (node-args u)))
         (let ([y (first-arg u)] [x (second-arg u)])
           (/: x (sqrt: (+: (*: x x) (*: y y))))))]
  [sine-of-arc always (op:sin u)
    (and (headed? u op:atan) (pair? (cdr (node-args u)))
         (let ([y (first-arg u)] [x (second-arg u)])
           (/: y (sqrt: (+: (*: x x) (*: y y))))))])

;; ---------------------------------------------------------------------------
;; Exponentials, hyperbolic functions, powers, logarithms, absolute values

(define-rules exponential-rules
  [exponential-of-sum always (op:exp u)
    (and (sum? u) (*: (exp: (first-arg u)) (exp: (rest-sum u))))]
  [exponential-squared respelt (op:exp u) (^: (exp: (*: 1/2 u)) 2)]
  [exponential-cubed respelt (op:exp u) (^: (exp: (/: u 3)) 3)]
  [exponential-below always (op:exp u) (/: 1 (exp: (neg u)))]
  [exponential-by-hyperbolics outside (op:exp u) (+: (cosh: u) (sinh: u))]
  [hyperbolic-cosine respelt (op:cosh u) (/: (+: (exp: u) (exp: (neg u))) 2)]
  [hyperbolic-sine respelt (op:sinh u) (*: 1/2 (-: (exp: u) (/: 1 (exp: u))))]
  [hyperbolic-tangent always (op:tanh u) (/: (sinh: u) (cosh: u))]
  [hyperbolic-tangent-by-exponentials respelt (op:tanh u)
    (/: (-: (exp: (*: 2 u)) 1) (+: (exp: (*: 2 u)) 1))]
  [hyperbolic-cosine-doubled respelt (op:cosh u)
    (+: 1 (*: 2 (^: (sinh: (*: 1/2 u)) 2)))]
  [hyperbolic-sine-of-sum respelt (op:sinh u)
    (and (sum? u)
         (let ([v (first-arg u)] [w (rest-sum u)])
           (+: (*: (sinh: v) (cosh: w)) (*: (cosh: v) (sinh: w)))))]
  [hyperbolic-sine-odd always (op:sinh u) (neg (sinh: (neg u)))]
  [hyperbolic-cosine-even always (op:cosh u) (cosh: (neg u))]
  [power-of-sum always (op:expt b n)
    (and (sum? n) (symbol? b) (*: (^: b (first-arg n)) (^: b (rest-sum n))))]
  [power-as-exponential positive (op:expt b n)
    (and (symbol? b) (not (number? n)) (exp: (*: n (log: b))))]
  [power-halved positive (op:expt b n) (and (symbol? b) (not (number? n)) (^: (^: b (*: 1/2 n)) 2))]
  [power-below-one positive (op:expt b n) (and (not (number? n)) (/: 1 (^: b (neg n))))]
  [power-up positive (op:expt b n) (and (not (number? n)) (/: (^: b (+: n 1)) b))]
  [logarithm-of-product positive (op:log u)
    (and (headed? u op:*) (pair? (cdr (node-args u)))
         (+: (log: (first-arg u)) (log: (rest-product u))))]
  [logarithm-of-quotient positive (op:log u)
    (and (headed? u op:/) (-: (log: (first-arg u)) (log: (second-arg u))))]
  [logarithm-of-power positive (op:log u)
    (and (headed? u op:expt) (*: (second-arg u) (log: (first-arg u))))]
  [logarithm-of-reciprocal positive (op:log u) (neg (log: (/: 1 u)))]
  [logarithm-of-square positive (op:log u) (/: (log: (^: u 2)) 2)]
  [logarithm-of-root positive (op:log u) (*: 2 (log: (sqrt: u)))]
  [modulus-of-negative always (op:abs u) (abs: (neg u))]
  [modulus-of-product always (op:abs u)
    (and (headed? u op:*) (pair? (cdr (node-args u)))
         (*: (abs: (first-arg u)) (abs: (rest-product u))))]
  [modulus-squared always (op:expt u n)
    (and (eqv? n 2) (headed? u op:abs) (^: (first-arg u) 2))]
  [modulus-as-quotient always (op:abs u) (/: (^: u 2) (abs: u))]
  [modulus-twice always (op:abs u) (abs: (abs: u))])

(define rules
  (append neutral-rules rational-rules root-rules circular-rules exponential-rules))

(define (rule-named name)
  (for/first ([r (in-list rules)] #:when (eq? (rule-name r) name)) r))
