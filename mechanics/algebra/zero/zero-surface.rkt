#lang racket/base
;; Where may an expression vanish, and does it vanish there on a surface?
;;
;; The zeros of a squarefree polynomial that is never negative have at least two equations: a
;; surface is where it would change its sign.  So √u has a kink on a surface where a factor of u
;; stands to an even power, as in √(x² + x⁴), and none where it stands to the first:
;; √(x² + y²) is a distance.  Factors are those of polynomials in tangents of half the angles
;; and in exponentials (half-angles.rkt), so that √(1 − cos x) has its kink.
;;
;; The argument needs independent functions, each with a variable on which no other depends.  Other
;; functions count as parameters, where some coefficient is never 0.  So it says nothing of
;; x² + sin²x, a polynomial in x and tan(x/2), which vanishes at 0 to the second power.
;;
;; It also needs parameters in general position: at h = 0 √(x² + h²) is |x|.  Exceptional values
;; of parameters are zeros of a discriminant.

(require racket/list
         "half-angles.rkt"
         "../expression/expression.rkt" "../expression/operation.rkt"
         "../expression/substitute.rkt" "../expression/symbols.rkt"
         "../rewriting/collect.rkt"
         "../simplify/simplify-expression.rkt"
         "../solve/factors.rkt" "../solve/nonzero-conditions.rkt" "../solve/solve-equations.rkt"
         "../../error/refusal.rkt")

(provide surfaces surface-zero surface-power surface-polynomial
         surface-separate? surfaces-apart? degenerate-parameters)

;; zero : vanishes there; it varies            power : of the factor
;; polynomial : the factor in symbols     kernels : ((kernel variable ...) ...), its varying parts
;; stand-ins : values of its symbols (half-angles.rkt)     variables : symbols
(struct surface (zero power polynomial kernels stand-ins variables) #:authentic)

;; The factors of u that vary; a factor that is a product with squares in tangents is taken apart.
(define (surfaces u variables A)
  (for*/list ([f (in-list (if (node? u) (expression-factors u A) (list (cons u 1))))]
              [g (in-list (parts-of (car f) variables A))])
    (struct-copy surface g [power (* (cdr f) (surface-power g))])))

(define (parts-of f variables A)
  (define-values (rational stand-ins) (rationalized f))
  (define (part zero power polynomial)
    (define kernels
      (for*/list ([k (in-list (kernels-of polynomial))]
                  [vs (in-value (variables-of k variables stand-ins))]
                  #:when (pair? vs))
        (cons k vs)))
    (surface zero power polynomial kernels stand-ins variables))
  (define factors
    (if (null? stand-ins) (list (cons f 1)) (expression-factors rational A)))
  (define parts
    (for/list ([g (in-list (append factors (at-infinity factors stand-ins A)))]
               #:when (positive? (cdr g))
               #:unless (exponential? (car g) stand-ins)
               #:when (pair? (variables-of (car g) variables stand-ins)))
      g))
  (define (all-single?) (andmap (lambda (g) (eqv? 1 (cdr g))) parts))
  (cond [(null? parts) '()]
        [(all-single?)
         (list (part f 1 (rebuild op:* (map car parts))))]
        [else
         (for/list ([g (in-list parts)])
           (part (original (car g) stand-ins A) (cdr g) (car g)))]))

;; Where a cosine of half an angle is 0 its tangent is infinite: 1 + cos x is 2/(1 + T²).
(define (at-infinity factors stand-ins A)
  (for*/list ([t (in-list stand-ins)]
              #:unless (exponential-stand-in? t)
              [power (in-value (for/sum ([f (in-list factors)])
                                 (* -1 (cdr f) (degree (car f) (stand-in-symbol t) A))))]
              #:unless (eqv? power 0))
    (cons (stand-in-under t) power)))

(define (exponential? e stand-ins)
  (for/or ([t (in-list stand-ins)])
    (and (eq? e (stand-in-symbol t)) (exponential-stand-in? t))))

(define (degree e k A)
  (for/last ([n (in-range (add1 most-degree))] #:unless (eqv? 0 (coefficient e k n A))) n))

;; The quotients put in, as a numerator.
(define (original e stand-ins A)
  (define used (filter (lambda (t) (occurs? (stand-in-symbol t) e)) stand-ins))
  (cond [(null? used) e]
        [(eq? e (stand-in-symbol (car used))) (stand-in-over (car used))]
        [else
         (define whole
           (substitute-expression
            e (for/list ([t (in-list used)])
                (cons (stand-in-symbol t) (e:/ (stand-in-over t) (stand-in-under t))))))
         (rebuild op:* (for/list ([f (in-list (expression-factors whole A))]
                                  #:unless (real? (car f))
                                  #:when (positive? (cdr f)))
                         (e:expt (car f) (cdr f))))]))

;; The variables on which e depends.
(define (variables-of e variables stand-ins)
  (filter (lambda (v)
            (or (occurs? v e)
                (for/or ([t (in-list stand-ins)])
                  (and (occurs? (stand-in-symbol t) e) (occurs? v (stand-in-over t))))))
          variables))

;; Symbols, and parts between them that are no arithmetic.
(define (kernels-of e)
  (remove-duplicates
   (let walk ([e e])
     (cond [(symbol? e) (list e)]
           [(not (node? e)) '()]
           [(arithmetic-node? e) (append-map walk (node-args e))]
           [else (list e)]))))

;; ---------------------------------------------------------------------------
;; Independent functions

;; If the factor stands to an odd power and is never negative, has its zero more than one equation?
(define (surface-separate? f A)
  (define own (independent (surface-kernels f) (surface-stand-ins f) (surface-variables f)))
  (define all (map car (surface-kernels f)))
  (cond [(null? own) #f]
        [(= (length own) (length all)) #t]
        [else
         (for/or ([c (in-list (coefficients (surface-polynomial f) own A))])
           (and (not (has-kernel? c all)) (null? (not-zero c A))))]))

;; Does one of the kernels stand in e?
(define (has-kernel? e kernels)
  (ormap (lambda (k) (and (member k kernels) #t)) (kernels-of e)))

;; kernels : ((kernel variable ...) ...) -> those that have a variable of their own, and are no
;; roots, which may have a least value
(define (independent kernels stand-ins variables)
  (for/list ([k (in-list kernels)]
             #:when (monotonic? (car k) stand-ins variables)
             #:when (for/or ([v (in-list (cdr k))])
                      (for/and ([other (in-list kernels)])
                        (or (eq? other k) (not (memq v (cdr other)))))))
    (car k)))

;; Do factors that stand to odd powers have no surface in common?  x and sin x have one.
(define (surfaces-apart? fs)
  (define kernels (remove-duplicates (append-map surface-kernels fs)))
  (define (alone? k)
    (for/and ([other (in-list kernels)])
      (or (equal? k other) (null? (filter (lambda (v) (memq v (cdr other))) (cdr k))))))
  (or (null? fs) (null? (cdr fs)) (andmap alone? kernels)))

;; Has the kernel no least value that it may touch: is it a symbol, an unknown function, or a
;; tangent or exponential of a multiple of a variable?
(define (monotonic? k stand-ins variables)
  (define t (findf (lambda (t) (eq? k (stand-in-symbol t))) stand-ins))
  (cond [t (multiple-of-variable? (car (node-args (stand-in-over t))) variables)]
        [else (or (symbol? k) (literal-head? (node-head k)))]))

(define (multiple-of-variable? e variables)
  (define (varies? e) (ormap (lambda (v) (occurs? v e)) variables))
  (cond [(symbol? e) #t]
        [(headed? e op:*)
         (define moving (filter varies? (node-args e)))
         (and (= 1 (length moving)) (multiple-of-variable? (car moving) variables))]
        [(headed? e op:/)
         (and (not (varies? (cadr (node-args e))))
              (multiple-of-variable? (car (node-args e)) variables))]
        [else (literal-head? (node-head e))]))

;; The coefficients of all products of powers of the kernels
(define (coefficients e kernels A)
  (for/fold ([es (list e)]) ([k (in-list kernels)])
    (append-map (lambda (e) (powers-of e k A)) es)))

;; The coefficients of the powers of k in e, from the 0th.
(define (powers-of e k A)
  (for*/list ([n (in-range (add1 most-degree))]
              [c (in-value (coefficient e k n A))]
              #:unless (eqv? c 0))
    c))

(define most-degree 8)

(define (coefficient e k n A)
  (define-values (c _) (expression-coefficient e k n A))
  (or c 0))

;; ---------------------------------------------------------------------------
;; Parameters

;; -> expressions in parameters: where one is 0 a discriminant vanishes, and the factor is a square
(define (degenerate-parameters f A)
  (define kernels (map car (surface-kernels f)))
  (remove-duplicates
   (for/list ([u (in-list (append (discriminant-factors f kernels A) (parameters-of f)))]
              #:when (square-where-0? u f A))
     (original u (surface-stand-ins f) A))))

(define (discriminant-factors f kernels A)
  (for*/list ([k (in-list kernels)]
              [d (in-value (discriminant (surface-polynomial f) k A))]
              #:when d
              [u (in-list (factors-of (list d) A))]
              #:unless (has-kernel? u kernels))
    u))

(define (parameters-of f)
  (filter (lambda (x) (not (memq x (surface-variables f)))) (symbols-in (surface-zero f))))

;; Of the second degree in k; else #f
(define (discriminant e k A)
  (define (of n) (coefficient e k n A))
  (and (eqv? 0 (of 3)) (eqv? 0 (of 4)) (not (eqv? 0 (of 2)))
       (simplify-expression (e:- (e:expt (of 1) 2) (e:* 4 (e:* (of 0) (of 2)))) A)))

;; May the factor, where u is 0, be a square of something that varies?
(define (square-where-0? u f A)
  (define roots
    (for/or ([x (in-list (symbols-in u))]) (solve-equations (list u) (list x) A)))
  (or (not roots)
      (for/or ([r (in-list roots)])
        (define there
          (if-raised divided-by-zero? #f (substitute-expression (surface-zero f) (car r))))
        (and there
             (for/or ([g (in-list (surfaces there (surface-variables f) A))])
               (even? (surface-power g)))))))
