#lang racket/base
;; Equations in several unknowns, where formulas are short: one equation after
;; another is factored, a factor solved for an unknown, and what was found put into
;; the others.
;;
;; A factor is solved if it is linear in an unknown, with a coefficient in which no
;; unknown occurs; and, if there is one unknown only, when it is a quadratic polynomial, in
;; the unknown, in a power of it or in an exponential of a x + b, or one of degree 1 in the
;; sine and the cosine of one angle a x + b.  Of angles all solutions within a turn of x are
;; given if a is a whole number, else those within a turn of the angle; exactly: multiples of
;; :pi are.
;;
;; Parameters are at a generic point: what depends on them is not zero.  Conditions for
;; solutions to be real are kept with them.

(require racket/list
         "factor.rkt"
         "../expression/constant-value.rkt" "../expression/expression.rkt"
         "../expression/operation.rkt" "../expression/pi.rkt" "../expression/substitute.rkt"
         "../expression/symbols.rkt"
         "../simplify/simplify-expression.rkt")

(provide solve-equations angle-of-other-period in-angle? expression-factors)

;; equations : expressions that are to vanish; unknowns : symbols; A : assumptions
;; -> a list of solutions (((unknown . expression) ...) condition ...), where an unknown
;; that is left out may be anything; #f if one of the equations cannot be solved.
;; A condition is (<= -1 e 1) or (>= e 0); solutions without come first.
(define (solve-equations equations unknowns A)
  (define flonums? (ormap flonum-in? equations))
  (let/ec return
    (unconditional-first
     (let solve ([equations equations] [found '()] [conditions '()])
       (define open (open-equations equations A))
       (define (involved e) (filter (lambda (x) (occurs? x e)) unknowns))
       (cond [(null? open) (list (cons (in-order found unknowns flonums?) conditions))]
             [(ormap (lambda (e) (null? (involved e))) open) '()]
             [else
              (define e (simplest open involved))
              (for*/list ([root (in-list (or (roots-of e involved A) (return #f)))]
                          [solution (in-list (solve (replaced (remq e open) root)
                                                    (extended found root A)
                                                    (append conditions (root-conditions root))))])
                solution)])))))

;; The roots of all factors, or else of the whole: x⁵ + 1 has a factor of degree 4.
(define (roots-of e involved A)
  (define of-factors
    (for*/list ([f (in-list (vanishing-factors e A))]
                [xs (in-value (involved f))]
                #:when (pair? xs))
      (solve-factor f xs A)))
  (define xs (involved e))
  (if (memq #f of-factors)
      (and (null? (cdr xs)) (power-roots e (car xs) A))
      (append* of-factors)))

;; x = value, under conditions.  waves : what sine and cosine are there, an alist
(struct root (x value conditions waves) #:authentic)

(define (open-equations equations A)
  (for*/list ([e (in-list equations)] [s (in-value (simplify-expression e A))]
                                      #:unless (eqv? s 0))
    s))

;; The equation with the fewest unknowns.
(define (simplest equations involved)
  (for/fold ([best (car equations)]) ([e (in-list (cdr equations))])
    (if (< (length (involved e)) (length (involved best))) e best)))

(define (replaced equations r)
  (define replacements (cons (cons (root-x r) (root-value r)) (root-waves r)))
  (for/list ([e (in-list equations)]) (substitute-expression e replacements)))

(define (extended found r A)
  (cons (cons (root-x r) (root-value r))
        (for/list ([entry (in-list found)])
          (cons (car entry)
                (simplify-expression (put (cdr entry) (root-x r) (root-value r)) A)))))

;; Factors of what has flonums are of whole numbers: in the end, a quotient of these is a
;; flonum, and so is an angle of which that is the cosine.
(define (in-order found unknowns flonums?)
  (define (presented e)
    (if (and flonums? (not (integer? e)) (not (pi-turns? e))) (or (constant-value e) e) e))
  (for*/list ([x (in-list unknowns)] [entry (in-value (assq x found))] #:when entry)
    (cons x (presented (cdr entry)))))

;; Is e a rational multiple of π?
(define (pi-turns? e) (and (symbolic? e) (number? (simplify-expression (e:/ e exact-pi)))))

(define (flonum-in? e)
  (node-fold e flonum? (lambda (n found) (ormap values found))))

(define (put e x value) (substitute-expression e (list (cons x value))))

;; Each once.
(define (unconditional-first solutions)
  (define-values (conditional others)
    (partition (lambda (s) (pair? (cdr s))) (remove-duplicates solutions)))
  (append others conditional))

;; ---------------------------------------------------------------------------
;; Factors

(define (vanishing-factors e A)
  (for/list ([f (in-list (expression-factors e A))] #:when (positive? (cdr f))) (car f)))

;; ((factor . exponent) ...), their product being e
(define (expression-factors e A)
  (define-values (product grounds) (factored-expression e A))
  (let walk ([e product] [power 1])
    (define args (if (node? e) (node-args e) '()))
    (define head (and (node? e) (node-head e)))
    (cond [(eq? head op:*) (append-map (lambda (a) (walk a power)) args)]
          [(eq? head op:/) (append (walk (car args) power) (walk (cadr args) (- power)))]
          [(and (eq? head op:expt) (exact-integer? (cadr args)))
           (walk (car args) (* power (cadr args)))]
          [else (list (cons e power))])))

;; -> roots, or #f
(define (solve-factor f xs A)
  (define (linear x) (linear-root f x xs A))
  (define root (ormap linear xs))
  (cond [root (list root)]
        [(exponential? f) '()]
        [(pair? (cdr xs)) #f]
        [else (or (quadratic-roots f (car xs) A)
                  (power-roots f (car xs) A)
                  (wave-roots f (car xs) A)
                  (exponential-roots f (car xs) A))]))

;; ---------------------------------------------------------------------------
;; Polynomials, known by their values

(define (zero-everywhere? e A) (eqv? 0 (simplify-expression e A)))

;; (a b) if e = a x + b with a ≠ 0, both without x; else #f.
(define (line e x A)
  (define b (value-at e x 0 A))
  (define a (and b (value-at (e:- e b) x 1 A)))
  (and a
       (not (eqv? a 0))
       (zero-everywhere? (e:- e (e:+ (e:* a x) b)) A)
       (list a b)))

;; The value at x, or #f where there is none.
(define (value-at e x value A)
  (with-handlers ([exn:fail:contract:divide-by-zero? (lambda (e) #f)])
    (simplify-expression (put e x value) A)))

(define (linear-root f x xs A)
  (define ab (line f x A))
  (and ab
       (not (ormap (lambda (y) (occurs? y (car ab))) xs))
       (root x (quotient-of (e:negate (cadr ab)) (car ab) A) '() '())))

(define (quotient-of a b A) (simplify-expression (e:/ a b) A))

;; a x² + b x + c
(define (quadratic-roots f x A)
  (define-values (c plus minus)
    (values (value-at f x 0 A) (value-at f x 1 A) (value-at f x -1 A)))
  (and c plus minus
       (let* ([a (simplify-expression (e:- (e:* 1/2 (e:+ plus minus)) c) A)]
              [b (simplify-expression (e:* 1/2 (e:- plus minus)) A)]
              [square (e:+ (e:* a (e:expt x 2)) (e:+ (e:* b x) c))])
         (and (not (eqv? a 0))
              (zero-everywhere? (e:- f square) A)
              (roots-of-square a b c x A)))))

(define (roots-of-square a b c x A)
  (define D (simplify-expression (e:- (e:expt (e:* 1/2 b) 2) (e:* a c)) A))
  (define (solution sign)
    (quotient-of (e:- (e:* sign (e:apply op:sqrt D)) (e:* 1/2 b)) a A))
  (define size (e:apply op:abs D))
  (define (known? sign) (zero-everywhere? (e:- D (e:* sign size)) A))
  (define conditions (if (known? 1) '() (list (list '>= D 0))))
  (if (and (known? -1) (not (known? 1)))
      '()
      (for/list ([sign '(1 -1)]) (root x (solution sign) conditions '()))))

;; a x²ⁿ + b xⁿ + c, where n is the least power of x there is; b or c may be 0
(define (power-roots f x A)
  (define powers (remove-duplicates (powers-of f x)))
  (define n (and (pair? powers) (apply min powers)))
  (define y (string->uninterned-symbol "y"))
  (define (in-y e)
    (node-map-powers e x (lambda (k) (if (zero? (remainder k n)) (e:expt y (quotient k n)) x))))
  (define g (and n (> n 1) (in-y f)))
  (define roots
    (and g
         (not (occurs? x g))
         (let ([linear (linear-root g y (list y) A)])
           (if linear (list linear) (quadratic-roots g y A)))))
  (and roots
       (append-map (lambda (r) (nth-roots (root-value r) (root-conditions r) n x A)) roots)))

;; The real x with xⁿ = value: where n is even, those of a value that is not negative
(define (nth-roots value conditions n x A)
  (define (size v) (simplify-expression (e:expt v (/ 1 n)) A))
  (define (roots values condition)
    (for/list ([v (in-list values)]) (root x v (append condition conditions) '())))
  (define sign (cond [(real? value) (sgn value)]
                     [(zero-everywhere? (e:- value (e:apply op:abs value)) A) 1]
                     [(zero-everywhere? (e:+ value (e:apply op:abs value)) A) -1]
                     [else #f]))
  (define one (if (eqv? sign -1) (e:negate (size (e:negate value))) (size value)))
  (cond [(eqv? sign 0) (roots '(0) '())]
        [(odd? n) (roots (list (if sign one (signed (size (magnitude value)) value))) '())]
        [(eqv? sign -1) '()]
        [else (roots (list one (e:negate one)) (if sign '() (list (list '>= value 0))))]))

(define (magnitude v) (e:apply op:abs v))
(define (signed size v) (e:* (e:apply op:sgn v) size))

(define (sgn v) (cond [(> v 0) 1] [(< v 0) -1] [else 0]))

;; The exponents of x in e, 1 where it stands alone.
(define (powers-of e x)
  (cond [(eq? e x) '(1)]
        [(not (node? e)) '()]
        [(power-of? e x) (list (cadr (node-args e)))]
        [else (append-map (lambda (a) (powers-of a x)) (node-args e))]))

(define (power-of? e x)
  (and (eq? (node-head e) op:expt)
       (eq? (car (node-args e)) x)
       (exact-positive-integer? (cadr (node-args e)))))

;; e with (change k) in place of each power k of x
(define (node-map-powers e x change)
  (let walk ([e e])
    (cond [(not (node? e)) e]
          [(power-of? e x) (change (cadr (node-args e)))]
          [else (rebuild (node-head e) (map walk (node-args e)))])))

;; ---------------------------------------------------------------------------
;; Exponentials

;; Of a polynomial of degree 2 at most in e^u, u = a x + b: e^u is positive.  Hyperbolic functions
;; are written by exponentials first.
(define (exponential-roots f x A)
  (define g (by-exponentials f x))
  (define us (arguments-of g x (list op:exp)))
  (define u (and (pair? us) (simplest-exponent us A)))
  (define ab (and u (line u x A)))
  (define y (string->uninterned-symbol "y"))
  (define in-y
    (and ab
         (simplify-expression
          (substitute-expression g (for/list ([v (in-list us)])
                                     (cons (make-node op:exp (list v))
                                           (e:expt y (simplify-expression (e:/ v u) A)))))
          A)))
  (define h (and in-y (not (occurs? x in-y)) (without-divisor in-y y A)))
  (define roots
    (cond [(not h) #f]
          [(not (occurs? y h)) '()]
          [(linear-root h y (list y) A) => list]
          [else (quadratic-roots h y A)]))
  (and roots (append-map (lambda (r) (logarithm-root r ab x A)) roots)))

(define (by-exponentials f x)
  (define (exponential u) (e:apply op:exp u))
  (define (hyperbolic op sign)
    (for/list ([u (in-list (arguments-of f x (list op)))])
      (cons (make-node op (list u))
            (e:* 1/2 (e:+ (exponential u) (e:* sign (exponential (e:negate u))))))))
  (substitute-expression f (append (hyperbolic op:cosh 1) (hyperbolic op:sinh -1))))

;; The one of which all others are multiples by whole numbers, or #f
(define (simplest-exponent us A)
  (for/first ([u (in-list us)]
              #:when (for/and ([v (in-list us)])
                       (exact-integer? (simplify-expression (e:/ v u) A))))
    u))

;; The numerator of what has powers of y below 0, but for powers of y
(define (without-divisor e y A)
  (define factors (expression-factors e A))
  (for/fold ([product 1]) ([f (in-list factors)] #:when (positive? (cdr f))
                                                 #:unless (eq? (car f) y))
    (e:* product (car f))))

;; x where e^(a x + b) is the root found; none where that is not positive
(define (logarithm-root r ab x A)
  (define value (root-value r))
  (define-values (a b) (apply values ab))
  (define positive? (zero-everywhere? (e:- value (e:apply op:abs value)) A))
  (if (and (real? value) (<= value 0))
      '()
      (list (root x
                  (quotient-of (e:- (e:apply op:log value) b) a A)
                  (if positive?
                      (root-conditions r)
                      (cons (list '>= value 0) (root-conditions r)))
                  '()))))

(define (exponential? e) (and (node? e) (eq? (node-head e) op:exp)))

;; ---------------------------------------------------------------------------
;; Angles

;; A cos u + B sin u + C with u = a x + b
(define (wave-roots f x A)
  (define angles (angles-of f x))
  (define u (and (pair? angles) (null? (cdr angles)) (car angles)))
  (define ab (and u (line u x A)))
  (define coefficients (and ab (wave-coefficients f x u A)))
  (define solutions (and coefficients (angles-where coefficients A)))
  (define turns (if solutions (turns-of (car ab)) 1))
  (and solutions
       (for*/list ([j (in-range turns)] [s (in-list solutions)])
         (define angle (e:+ (turn-angle s) (e:* (* 2 j) exact-pi)))
         (define value (quotient-of (e:- angle (cadr ab)) (car ab) A))
         (root x
               (if (= turns 1) value (within-turn value A))
               (turn-conditions s)
               (for/list ([op (in-list (list op:cos op:sin))]
                          [value (in-list (list (turn-cosine s) (turn-sine s)))]
                          #:when value)
                 (cons (make-node op (list u)) value))))))

;; How often a x goes round while x does once.
(define (turns-of a) (if (exact-integer? a) (abs a) 1))

;; An angle in these expressions that does not go round a whole number of times while an
;; unknown in it does once, so that a turn of the one is not a turn of the other; or #f
(define (angle-of-other-period es unknowns A)
  (for*/or ([e (in-list es)] [x (in-list unknowns)] [u (in-list (angles-of e x))])
    (define ab (line u x A))
    (and (not (and ab (exact-integer? (car ab)))) u)))

;; A multiple of π as the one above −π and up to π that differs from it by turns.
(define (within-turn angle A)
  (define parts (simplify-expression (e:/ angle exact-pi) A))
  (if (and (rational? parts) (exact? parts) (not (<= -1 parts 1)))
      (e:* (- parts (* 2 (ceiling (/ (- parts 1) 2)))) exact-pi)
      angle))

;; Does x stand in a sine or cosine?
(define (in-angle? x e) (and (expression? e) (pair? (angles-of e x))))

;; The arguments of sines and cosines in which x occurs.
(define (angles-of f x) (arguments-of f x (list op:sin op:cos)))

(define (arguments-of f x heads)
  (define found '())
  (node-fold f
             (lambda (leaf) (eq? leaf x))
             (lambda (n moves)
               (define u (car (node-args n)))
               (when (and (memq (node-head n) heads)
                          (car moves)
                          (not (member u found)))
                 (set! found (cons u found)))
               (ormap values moves)))
  found)

;; (A B C), or #f
(define (wave-coefficients f x u A)
  (define (of op) (make-node op (list u)))
  (define (with cosine sine)
    (simplify-expression
     (substitute-expression f (list (cons (of op:cos) cosine) (cons (of op:sin) sine))) A))
  (define C (with 0 0))
  (define-values (a b) (values (e:- (with 1 0) C) (e:- (with 0 1) C)))
  (define-values (cosine sine) (values (simplify-expression a A) (simplify-expression b A)))
  (define wave (e:+ (e:* cosine (of op:cos)) (e:+ (e:* sine (of op:sin)) C)))
  (and (zero-everywhere? (e:- f wave) A)
       (not (ormap (lambda (e) (occurs? x e)) (list cosine sine C)))
       (list cosine sine C)))

;; An angle with its cosine and its sine, #f for what has no short form.
(struct turn (angle cosine sine conditions) #:authentic)

;; -> a list of turns where A cos u + B sin u + C is 0, or #f
(define (angles-where coefficients A)
  (define-values (a b c) (apply values coefficients))
  (define (inverse op x)
    (simplify-expression (if (flonum? x) (e:apply op x) (make-node op (list x))) A))
  (cond [(and (eqv? a 0) (eqv? c 0)) (list (turn 0 1 0 '()) (turn exact-pi -1 0 '()))]
        [(and (eqv? b 0) (eqv? c 0))
         (list (turn (e:* 1/2 exact-pi) 0 1 '()) (turn (e:* -1/2 exact-pi) 0 -1 '()))]
        [(eqv? b 0)
         (define x (quotient-of (e:negate c) a A))
         (for/list ([sign (in-list (either x 1 -1))])
           (turn (e:* sign (inverse op:acos x)) x #f (bound-on x)))]
        [(eqv? a 0)
         (define x (quotient-of (e:negate c) b A))
         (define u (inverse op:asin x))
         (for/list ([angle (in-list (either x u (e:- exact-pi u)))])
           (turn angle #f x (bound-on x)))]
        [(eqv? c 0)
         (define u (inverse op:atan (quotient-of (e:negate a) b A)))
         (list (turn u #f #f '()) (turn (e:+ exact-pi u) #f #f '()))]
        [else
         ;; R cos(u − δ) = −C
         (define R (simplify-expression (e:apply op:sqrt (e:+ (e:* a a) (e:* b b))) A))
         (define x (quotient-of (e:negate c) R A))
         (define direction (simplify-expression (direction-of a b) A))
         (for/list ([sign (in-list (either x 1 -1))])
           (turn (e:+ direction (e:* sign (inverse op:acos x))) #f #f (bound-on x)))]))

;; The angle of the point (a, b)
(define (direction-of a b)
  (define (of . arguments)
    (if (ormap flonum? arguments) (apply e:apply op:atan arguments) (make-node op:atan arguments)))
  (if (and (real? a) (positive? a)) (of (e:/ b a)) (of b a)))

;; The two of a sine or cosine x, that are one at the ends.
(define (either x a b)
  (cond [(not (real? x)) (list a b)]
        [(< -1 x 1) (list a b)]
        [(= 1 (abs x)) (list a)]
        [else '()]))
(define (bound-on x) (if (real? x) '() (list (list '<= -1 x 1))))
