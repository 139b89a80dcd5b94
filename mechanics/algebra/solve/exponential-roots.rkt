#lang racket/base
;; Roots of a polynomial, of degree 2 at most, in e^u with u = a x + b: e^u is positive.  Hyperbolic
;; functions are written by exponentials first.

(require racket/list
         "factors.rkt" "power-roots.rkt" "root.rkt"
         "../expression/expression.rkt" "../expression/operation.rkt"
         "../expression/substitute.rkt" "../expression/symbols.rkt"
         "../simplify/simplify-expression.rkt")

(provide exponential-roots)

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
  (define (divides-all? u)
    (for/and ([v (in-list us)]) (exact-integer? (simplify-expression (e:/ v u) A))))
  (findf divides-all? us))

;; The numerator of e, which has powers of y below 0, but for powers of y
(define (without-divisor e y A)
  (rebuild op:* (remq* (list y) (vanishing-factors e A))))

;; x where e^(a x + b) is the root found; none where that is not positive
(define (logarithm-root r ab x A)
  (define value (root-value r))
  (define-values (a b) (apply values ab))
  (if (and (real? value) (<= value 0))
      '()
      (list (root x
                  (quotient-of (e:- (e:apply op:log value) b) a A)
                  (if (eqv? 1 (known-branch value A))
                      (root-conditions r)
                      (cons (list '>= value 0) (root-conditions r)))
                  '()))))
