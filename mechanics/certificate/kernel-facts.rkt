#lang racket/base
;; The facts about kernels that a proof rests on, each with its own proof in Coq.
;;
;; To Coq's algebra a sine, a root or an exponential is a number of which it knows nothing.  So
;; those in a claim are written by a few of them, the kernels, as the library does itself: sin 2θ by
;; sin θ and cos θ, √(4x) as 2 √x; and the kernels have relations: sin²θ = 1 - cos²θ, (√x)² = x.
;; Facts about what stands within others come first.

(require racket/list
         "angle-facts.rkt" "claim-domain.rkt" "Coq-term.rkt" "kernel-fact.rkt" "linear-terms.rkt"
         "root-parts.rkt"
         "../algebra/expression/exact-numbers.rkt" "../algebra/expression/expression.rkt"
         "../algebra/expression/nodes.rkt" "../algebra/expression/operation.rkt"
         "../algebra/expression/pi.rkt" "../algebra/expression/size.rkt"
         "../algebra/expression/substitute.rkt"
         (only-in "../algebra/assumption/assumption-set.rkt" with-automatic-assumptions)
         "../algebra/rewriting/factor.rkt"
         "../algebra/simplify/known-sign.rkt" "../algebra/simplify/simplify-expression.rkt")

(provide kernel-facts)

;; plans  : node -> (expression . script) or #f, what stands for it
;; facts  : in the order they are proved, the last first
;; angles, exponents : nodes of sines and cosines, and of exponentials, the last met first
;; heads  : literal functions applied, the last met first
(struct collector (assumptions names plans [met #:mutable] [angles #:mutable]
                               [exponents #:mutable] [applied #:mutable])
  #:authentic)

;; es : expressions; A : assumptions; ns : names of all in them; divisors : expressions that are not
;; 0 -> facts
(define (kernel-facts es A ns [divisors '()])
  (define c (collector A ns (make-hash) '() '() '() '()))
  (for ([e (in-list es)]) (visit-all! c e))
  (define simpler
    (for*/list ([d (in-list divisors)] [e (in-value (simpler-divisor d A))] #:when e) (cons d e)))
  (for ([s (in-list simpler)]) (visit-all! c (cdr s)))
  (settle-arcs! c)
  (define circles (settle-angles! c))
  (define exponentials (settle-exponents! c))
  (append circles
          exponentials
          (append-map (lambda (n) (facts-of c n)) (reverse (collector-met c)))
          (remove-duplicates (append-map (lambda (d) (root-facts c d)) divisors)
                             #:key fact-left)
          (append-map (lambda (s) (divisor-facts c (car s) (cdr s)))
                      (append simpler
                              (for*/list ([d (in-list divisors)] #:unless (assoc d simpler)
                                          [e (in-value (resolved-divisor c d))] #:when e)
                                (cons d e))))))

;; ---------------------------------------------------------------------------
;; Divisors: simpler forms of them, so that `field` asks for little, and their factors

;; d, a sum, as a product, if that is smaller, or if there are divisors in d; else #f
(define (simpler-divisor d A)
  (define-values (e _)
    (if (sum? d) (factored-expression d (with-automatic-assumptions A #f)) (values d #f)))
  (and (or (< (expression-size e) (expression-size d))
           (and (not (equal? e d)) (some-node? (lambda (n) (headed? n op:/)) d)))
       e))

;; d as a product of exponentials, if these stand for its parts; else #f
(define (resolved-divisor c d)
  (define A (collector-assumptions c))
  (define r (resolved c d))
  (define exponentials (filter (lambda (n) (headed? n op:exp)) (nodes-in r)))
  (define powers                        ; of sinh, as symbols, of which the algebra knows no more
    (if (some-node? (lambda (n) (memq (node-head n) (list op:sinh op:cosh op:tanh))) d)
        (for/list ([n (in-list (remove-duplicates exponentials))])
          (cons n (string->uninterned-symbol "e")))
        '()))
  (define-values (factored _)
    (if (or (equal? r d) (null? exponentials))
        (values #f #f)
        (factored-expression (in-place-of powers r) (with-automatic-assumptions A #f))))
  (define e
    (and factored (in-place-of (for/list ([p (in-list powers)]) (cons (cdr p) (car p))) factored)))
  (and e
       (not (equal? e d))
       (for/and ([n (in-list (nodes-in e))])
         (or (arithmetic-node? n) (hash-has-key? (collector-plans c) n)))
       e))

(define (divisor-facts c d e)
  (define ns (collector-names c))
  (cons (fact 'divisor d e '(identity))
        (for/list ([f (in-list (product-factors e))])
          (fact 'factor f (cons '<> 0)
                (list (format (string-append
                               "let Z := fresh in let G := fresh in intro Z; "
                               "assert (G : ~a <> 0) by assumption; apply G; transitivity (~a); [")
                              (term d ns 2) (term e ns))
                      'identity "| rewrite Z; unfold Rdiv; ring]")))))

;; Facts about a root of a sum by which the root d is written: it is not 0, as d is not.
(define (root-facts c d)
  (define plan (and (headed? d op:sqrt) (hash-ref (collector-plans c) d #f)))
  (define (root-of-sum? e) (and (headed? e op:sqrt) (sum? (car (node-args e)))))
  (if plan
      (filter (lambda (f) (root-of-sum? (fact-left f))) (cdr (divisor-facts c d (car plan))))
      '()))

;; Of the numerator, without numbers and powers
(define (product-factors e)
  (define args (if (node? e) (node-args e) '()))
  (cond [(number? e) '()]
        [(headed? e op:*) (append-map product-factors args)]
        [(headed? e op:/) (product-factors (car args))]
        [(and (node? e) (integer-power? e)) (product-factors (car args))]
        [else (list e)]))

(define (visit-all! c e) (for ([n (in-list (nodes-in e))]) (visit! c n)))

(define (visit! c n)
  (unless (hash-has-key? (collector-plans c) n)
    (hash-set! (collector-plans c) n #f)
    (make-plan! c n)
    (add-met! c n)))

(define (add-met! c x) (set-collector-met! c (cons x (collector-met c))))

;; e stands for n; script : the proof of n = e
(define (plan! c n e . script)
  (visit-all! c e)
  (hash-set! (collector-plans c) n (cons e script)))

(define (make-plan! c n)
  (define head (node-head n))
  (define a (and (pair? (node-args n)) (car (node-args n))))
  (define (of op e) (make-node op (list e)))
  (define (half op)
    (make-node op:/ (list (make-node op (list (of op:exp a) (of op:exp (e:negate a)))) 2)))
  (define (by-exponentials name)
    (define ns (collector-names c))
    (format "unfold ~a; replace (- (~a)) with (~a) by first [ring | field; nonzero]; reflexivity."
            name (term a ns) (term (e:negate a) ns)))
  (cond [(memq head (list op:sin op:cos)) (set-collector-angles! c (cons n (collector-angles c)))]
        [(eq? head op:exp) (set-collector-exponents! c (cons n (collector-exponents c)))]
        [(angle-of-point? n) (plan-angle-of-point! c n a (cadr (node-args n)))]
        [(eq? head op:tan) (plan! c n (e:/ (of op:sin a) (of op:cos a)) "reflexivity.")]
        [(eq? head op:sinh) (plan! c n (half op:-) (by-exponentials "sinh"))]
        [(eq? head op:cosh) (plan! c n (half op:+) (by-exponentials "cosh"))]
        [(eq? head op:tanh) (plan! c n (e:/ (of op:sinh a) (of op:cosh a)) "reflexivity.")]
        [(eq? head op:abs) (plan-modulus! c n a)]
        [(eq? head op:sqrt) (plan-root! c n a)]
        [(eq? head op:log) (plan-logarithm! c n a)]
        [(eq? head op:expt) (plan-power! c n a (cadr (node-args n)))]
        [(literal-head? head) (plan-application! c n)]))

;; The expression that stands for e where all that is known so far is used.
(define (resolved c e)
  (let walk ([e e])
    (cond [(not (node? e)) e]
          [(hash-ref (collector-plans c) e #f) => (lambda (plan) (walk (car plan)))]
          [(angle-of-point? e) e]
          [else (rebuild (node-head e) (map walk (node-args e)))])))

;; ---------------------------------------------------------------------------
;; Absolute values, roots, powers, unknown functions

(define (plan-modulus! c n u)
  (define A (collector-assumptions c))
  (define-values (number factors) (factors-of u A))
  (define product
    (for/fold ([e (abs number)]) ([f (in-list factors)])
      (define s (weak-sign (car f) A))
      (e:* e (e:expt (if s (e:* s (car f)) (make-node op:abs (list (car f)))) (cdr f)))))
  (unless (or (equal? product n) (some-node? (lambda (m) (equal? m n)) product))
    (plan! c n product "apply modulus_is; [nonnegative | " 'identity "].")))

(define (plan-root! c n u)
  (define-values (outer known rest) (root-parts u (collector-assumptions c)))
  (define radicands (append known (if rest (list rest) '())))
  (define (root r) (make-node op:sqrt (list r)))
  (define product (for/fold ([e outer]) ([r (in-list radicands)]) (e:* e (root r))))
  (unless (equal? product n)
    (for ([r (in-list radicands)]) (visit-all! c r))
    (when (and (or rest (= 1 (length radicands)))
               (not (said-not-negative? c (last radicands))))
      (add-met! c (rest-fact c (last radicands) u outer (drop-right radicands 1))))
    (for ([r (in-list radicands)] #:unless (hash-has-key? (collector-plans c) (root r)))
      (hash-set! (collector-plans c) (root r) #f)
      (add-met! c (if (known-as-divisor? r u)
                      (root-relation (root r) sign-of-divisor)
                      (root r))))
    (plan! c n product "apply sqrt_lem_1. " "- nonnegative. - nonnegative. - " 'identity ".")))

;; 0 <= rest, as rest = u over the square of what else is in the root
(define (rest-fact c rest u outer others)
  (define square
    (for/fold ([e (e:expt outer 2)]) ([r (in-list others)]) (e:* e r)))
  (visit-all! c square)
  (define ns (collector-names c))
  (fact 'known 0 (cons '<= rest)
        (list (format "first [replace (~a) with (~a); [nonnegative | "
                      (term rest ns) (term (e:/ u square) ns))
              'identity "] | solve [nonnegative]].")))

;; Is there a fact that e is not negative?
(define (said-not-negative? c e)
  (for/or ([f (in-list (collector-met c))])
    (and (fact? f) (equal? (fact-right f) (cons '<= e)))))

;; Is u, which is not negative, a number divided by r?
(define (known-as-divisor? r u)
  (and (headed? u op:/) (number? (car (node-args u))) (equal? r (cadr (node-args u)))))
(define sign-of-divisor
  (string-append "first [lra | apply Rnot_lt_le; let N := fresh in intro N; "
                 "apply Rinv_lt_0_compat in N; unfold Rdiv in *; lra]."))

;; The angle of (x, y) is atan y/x where x is known to be positive.
(define (plan-angle-of-point! c n y x)
  (if (eqv? 1 (known-sign x (collector-assumptions c)))
      (plan! c n (make-node op:atan (list (e:/ y x)))
             "unfold atan2; destruct Rlt_dec; [reflexivity | lra].")
      (visit-all! c (make-node op:sqrt (list (square-of-distance n))))))

;; log u as a sum, where u is a power of e, or a product of what is positive
(define (plan-logarithm! c n u)
  (define A (collector-assumptions c))
  (define-values (number factors) (factors-of u A))
  (define all
    (append (if (rational? number) (number-factors (abs number)) '())
            (append-map (lambda (f) (parts-of-modulus c f)) factors)))
  (define (of e) (make-node op:log (list e)))
  (define (positive-factor? f)
    (and (<= (abs (cdr f)) greatest-multiple) (eqv? 1 (weak-sign (car f) A))))
  (define sum
    (for/fold ([sum 0]) ([f (in-list all)]) (e:+ sum (e:* (cdr f) (of (car f))))))
  (cond [(headed? u op:exp) (plan! c n (car (node-args u)) "apply ln_exp.")]
        [(and (positive? number) (andmap positive-factor? all) (not (equal? sum n)))
         (for ([f (in-list all)]) (visit-all! c (car f)))
         (for ([f (in-list all)] #:when (node? (of (car f))))
           (hash-ref! (collector-plans c) (of (car f)) #f))
         (if (and (hash-ref (collector-plans c) u #f) (= 1 (length all)) (eqv? 1 (cdar all)))
             (plan! c n sum "f_equal; " 'identity ".")
             (plan! c n sum
                    (format "replace (~a) with (~a); [logarithms | " (term u (collector-names c))
                            (product-text all (collector-names c)))
                    'identity "]."))]))

;; f : (base . exponent) -> a list of f, or of the factors of an absolute value that is a product
(define (parts-of-modulus c f)
  (cond [(headed? (car f) op:abs)
         (visit-all! c (car f))
         (define-values (number factors) (product-parts (resolved c (car f))))
         (if (eqv? number 1)
             (for/list ([g (in-list factors)]) (cons (car g) (* (cdr f) (cdr g))))
             (list f))]
        [else (list f)]))

;; x * x * / y
(define (product-text factors ns)
  (define (power-texts f)
    (for/list ([_ (in-range (abs (cdr f)))])
      (format "~a(~a)" (if (negative? (cdr f)) "/ " "") (term (car f) ns))))
  (define texts (append-map power-texts factors))
  (if (null? texts)
      "1"
      (for/fold ([text (car texts)]) ([t (in-list (cdr texts))]) (string-append text " * " t))))

(define (plan-power! c n base k)
  (define-values (kind p) (split-power k))
  (define root (make-node op:sqrt (list base)))
  (case kind
    [(root) (visit-all! c root)]
    [(exponential)
     (define exponent (e:* k (make-node op:log (list base))))
     (plan! c n (make-node op:exp (list exponent))
            "unfold Rpower; f_equal; " 'identity ".")]))

;; Applications of one function to equal arguments become one.
(define (plan-application! c n)
  (define same
    (for/first ([m (in-list (collector-applied c))] #:when (same-application? c m n)) m))
  (if same
      (plan! c n same "f_equal; " 'identity ".")
      (set-collector-applied! c (cons n (collector-applied c)))))

(define (same-application? c m n)
  (and (head=? (node-head m) (node-head n))
       (= (length (node-args m)) (length (node-args n)))
       (for/and ([a (in-list (node-args m))] [b (in-list (node-args n))])
         (and (expression? a) (expression? b)
              (or (equal? a b)
                  (eqv? 0 (simplify-expression (e:- a b) (collector-assumptions c))))))))

;; ---------------------------------------------------------------------------
;; Arcs

;; Beside asin x, acos x is π/2 - asin x; beside atan x, atan (1/x) is π/2 - atan x, where 0 < x.
(define (settle-arcs! c)
  (define A (collector-assumptions c))
  (define nodes (filter node? (reverse (collector-met c))))
  (define (complement! n m . script)
    (apply plan! c n (e:- (e:* 1/2 exact-pi) m) script))
  (for ([n (in-list nodes)] #:when (headed? n op:acos))
    (define m (make-node op:asin (node-args n)))
    (when (member m nodes)
      (complement! n m "rewrite acos_asin by (split; lra); field.")))
  (define atans
    (filter (lambda (n) (and (headed? n op:atan) (not (angle-of-point? n)))) nodes))
  (for ([m (in-list atans)] [k (in-naturals 1)])
    (define x (car (node-args m)))
    (for ([n (in-list (list-tail atans k))]
          #:when (and (eqv? 1 (weak-sign x A))
                      (equal? 1 (simplify-expression (e:* x (car (node-args n))) A))))
      (complement! n m (format "replace (~a) with (/ ~a); [rewrite atan_inv by positive; field | "
                               (term (car (node-args n)) (collector-names c))
                               (term x (collector-names c) 2))
                   'identity "]."))))

;; ---------------------------------------------------------------------------
;; Angles

;; A sine of a greater multiple of a basic angle than this is not expanded.
(define greatest-multiple 8)

;; Plans for sines and cosines; -> the relations of those of basic angles
(define (settle-angles! c)
  (define nodes (reverse (collector-angles c)))
  (define forms (for/list ([n (in-list nodes)]) (linear-terms (resolved c (car (node-args n))))))
  (define-values (turns plain) (values (map turn-of forms) (map without-turn forms)))
  (define b (basic-forms plain greatest-multiple #f))
  (define unit (turn-unit turns))
  (define angles (named-angles (basics-expressions b) nodes turns (basics-multiples b)))
  (for ([n (in-list nodes)] [t (in-list turns)] [ms (in-list (basics-multiples b))])
    (define all
      (append (for/list ([m (in-list ms)]) (cons (list-ref angles (car m)) (cdr m)))
              (if (eqv? t 0) '() (list (cons (e:* unit exact-pi) (/ t unit))))))
    (plan-angle! c n all))
  (append (append-map circle-facts angles)
          (if unit (turn-facts unit) '())))

;; The multiple of π in a form, and the form without it
(define turn-monomial (list (cons exact-pi 1)))
(define (turn? t) (equal? (cdr t) turn-monomial))
(define (turn-of form)
  (define t (findf turn? form))
  (if t (car t) 0))
(define (without-turn form) (filter (lambda (t) (not (turn? t))) form))

;; The part of π that all turns are multiples of, or #f
(define (turn-unit turns)
  (define found (filter (lambda (t) (not (eqv? t 0))) turns))
  (cond [(null? found) #f]
        [else
         (define q (apply lcm (map denominator found)))
         (unless (memv q '(1 2 3 4 6)) (give-up "it holds sines of π/~a" q))
         (/ 1 q)]))

;; Basic angles as they are written in the claim, if they are
(define (named-angles expressions nodes turns multiples)
  (for/list ([e (in-list expressions)] [i (in-naturals)])
    (define (alone sign)
      (for/first ([n (in-list nodes)] [t (in-list turns)] [ms (in-list multiples)]
                  #:when (and (eqv? t 0) (equal? ms (list (cons i sign)))))
        (car (node-args n))))
    (or (alone 1) e)))

;; multiples : ((angle . integer) ...)
(define (plan-angle! c n multiples)
  (define sine? (eq? op:sin (node-head n)))
  (define cosine+sine
    (for/fold ([turn '(1 . 0)]) ([m (in-list multiples)])
      (turn-product turn (multiple-turn (car m) (cdr m)))))
  (define e ((if sine? cdr car) cosine+sine))
  (unless (equal? e n)
    (define ns (collector-names c))
    (plan! c n e
           (format "transitivity (~a (~a)); [f_equal; "
                   (if sine? "sin" "cos") (sum-text multiples ns))
           'identity
           (format "| ~a]." (generic-proof "turns" multiples ns)))))

(define (multiple-turn angle k)
  (define (of op) (make-node op (list angle)))
  (define t
    (for/fold ([turn '(1 . 0)]) ([_ (in-range (abs k))])
      (turn-product turn (cons (of op:cos) (of op:sin)))))
  (if (negative? k) (cons (car t) (e:negate (cdr t))) t))

;; turns : (cosine . sine)
(define (turn-product t u)
  (cons (e:- (e:* (car t) (car u)) (e:* (cdr t) (cdr u)))
        (e:+ (e:* (cdr t) (car u)) (e:* (car t) (cdr u)))))

;; a + a + - b
(define (sum-text multiples ns)
  (define terms
    (for*/list ([m (in-list multiples)] [_ (in-range (abs (cdr m)))])
      (format "~a(~a)" (if (negative? (cdr m)) "- " "") (term (car m) ns))))
  (if (null? terms)
      "0"
      (for/fold ([text (car terms)]) ([t (in-list (cdr terms))]) (string-append text " + " t))))

;; The addition formulas hold for any angles, which are generalized, those that hold others first;
;; a number is not, which may stand elsewhere.
(define (generic-proof tactic multiples ns)
  (define texts
    (for/list ([m (in-list multiples)] #:unless (number? (car m))) (term (car m) ns)))
  (format "~aintros; ~a"
          (apply string-append (for/list ([t (in-list (sort texts > #:key string-length))])
                                 (format "generalize (~a); " t)))
          tactic))

;; ---------------------------------------------------------------------------
;; Exponentials

(define (settle-exponents! c)
  (define nodes (reverse (collector-exponents c)))
  (define forms (for/list ([n (in-list nodes)]) (linear-terms (resolved c (car (node-args n))))))
  (define alone (logarithms forms))
  (define b (basic-forms (append alone forms) greatest-multiple #t))
  (for ([n (in-list nodes)] [ms (in-list (list-tail (basics-multiples b) (length alone)))])
    (plan-exponential! c n (for/list ([m (in-list ms)])
                             (cons (list-ref (basics-expressions b) (car m)) (cdr m)))))
  (append-map exponential-facts (basics-expressions b)))

(define (plan-exponential! c n multiples)
  (define e
    (for/fold ([product 1]) ([m (in-list multiples)])
      (e:* product (e:expt (make-node op:exp (list (car m))) (cdr m)))))
  (unless (equal? e n)
    (define ns (collector-names c))
    (plan! c n e
           (format "transitivity (exp (~a)); [f_equal; " (sum-text multiples ns))
           'identity
           (format "| ~a]." (generic-proof "exponents" multiples ns)))))

;; exp b is not 0; where b is a part of a logarithm a power of it is known.
(define (exponential-facts b)
  (define e (make-node op:exp (list b)))
  (define terms (linear-terms b))
  (define l (and (= 1 (length terms)) (logarithm-of (cdar terms))))
  (define q (and l (/ 1 (caar terms))))
  (cons (fact 'known e (cons '<> 0) '("apply Rgt_not_eq; apply exp_pos."))
        (cond [(eqv? q 1) (list (fact 'value e l '("apply exp_ln; positive.")))]
              [(and (exact-integer? q) (<= 2 q 6))
               (list (fact 'relation (e:expt e q) l
                           (list (format "apply exp_part_~a; [positive | field]." q))))]
              [else '()])))

;; Of the logarithms in forms themselves, so that powers of e to them are whole ones.
(define (logarithms forms)
  (for*/list ([f (in-list forms)] [t (in-list f)] #:when (logarithm-of (cdr t)))
    (list (cons 1 (cdr t)))))

(define (logarithm-of monomial)
  (and (= 1 (length monomial))
       (eqv? 1 (cdar monomial))
       (headed? (caar monomial) op:log)
       (car (node-args (caar monomial)))))

;; ---------------------------------------------------------------------------

;; n : a node that was met, or a fact that was put among them
(define (facts-of c n)
  (define plan (and (node? n) (hash-ref (collector-plans c) n #f)))
  (cond [(fact? n) (list n)]
        [plan (list (fact 'value n (car plan) (cdr plan)))]
        [(headed? n op:sqrt) (list (root-relation n))]
        [(headed? n op:abs) (list (modulus-relation n))]
        [else '()]))
