#lang racket/base
;; Random expressions of the class that simplification decides, and beyond.

(require mechanics/algebra/expression/expression
         mechanics/algebra/expression/operation)

(provide random-expression random-leaf choose application classes class-kinds class-depth)

(define (choose . xs) (list-ref xs (random (length xs))))
(define (choose-from xs) (list-ref xs (random (length xs))))

;; A literal function of t, differentiated by the paths given.
(define (application name arguments . paths)
  (make-node (for/fold ([head (make-literal-head name)]) ([p (in-list paths)])
               (literal-head-derivative head p))
             arguments))

(define literals
  (list (application 'q '(t)) (application 'q '(t) '()) (application 'q '(t) '() '())
        (application 'V '(a x) '(0)) (application 'V '(a x) '(1) '(0))
        (application 'r '(t)) (application 'r '(t) '())))

(define symbols '(a b c x))

(define (random-leaf kinds)
  (case (random 8)
    [(0 1) (if (and (memq 'flonum kinds) (zero? (random 3)))
               (choose 0.5 1.5 9.8 -0.1 2.0)
               (choose 1 2 -1 1/2 3 -2/3 4))]
    [(2 3) (if (memq 'literal kinds) (choose-from literals) (choose-from symbols))]
    [else (choose-from symbols)]))

;; kinds : a subset of '(rational trigonometric hyperbolic exponential power logarithm
;; radical root nested inverse modulus literal flonum)
(define (random-expression depth kinds)
  (define (sub) (random-expression (- depth 1) kinds))
  (if (eqv? depth 0)
      (random-leaf kinds)
      (case (random 9)
        [(0 1) (node op:+ (sub) (sub))]
        [(2 3) (node op:* (sub) (sub))]
        [(4) (node op:- (sub) (sub))]
        [(5) (node op:expt (sub) (choose 2 2 3 -1))]
        [else (random-function depth kinds sub)])))

;; By the constructors or raw, as results of programs are and as they are not.
(define (node op . args)
  (cond [(andmap number? args) (choose-from symbols)]
        [(eqv? 0 (random 3)) (make-node op args)]
        [(eq? op op:+) (apply e:+ args)]
        [(eq? op op:*) (apply e:* args)]
        [(eq? op op:-) (apply e:- args)]
        [(eq? op op:expt) (if (eqv? 0 (car args)) 'a (apply e:expt args))]
        [else (make-node op args)]))

(define (f op . args) (make-node op args))

(define (random-function depth kinds sub)
  (define useful (filter (lambda (k) (not (memq k '(literal flonum)))) kinds))
  (case (if (null? useful) 'none (choose-from useful))
    [(rational) (f op:/ (sub) (nonzero (sub)))]
    [(trigonometric) (f (choose op:sin op:cos op:sin op:cos op:tan) (random-angle kinds))]
    [(hyperbolic) (f (choose op:sinh op:cosh op:tanh) (random-angle kinds))]
    [(exponential) (f op:exp (random-angle kinds))]
    [(power) (f op:expt (choose-from '(a b c)) (random-exponent))]
    [(logarithm) (f op:log (random-radicand kinds))]
    [(radical) (random-root (random-radicand kinds) '(1/2 1/2 3/2 -1/2))]
    [(root) (random-root (random-radicand kinds) '(1/2 1/3 2/3 -1/4 3/4 5/2 -2/3))]
    [(nested) (random-root (sub) '(1/2 1/2 1/3))]
    [(inverse) (random-inverse kinds)]
    [(modulus) (f op:abs (sub))]
    [else (random-leaf kinds)]))

(define (nonzero e) (if (eqv? e 0) 'b e))

(define (random-root u exponents)
  (define k (choose-from exponents))
  (if (and (eqv? k 1/2) (zero? (random 2))) (f op:sqrt u) (f op:expt u k)))

;; Sums and multiples of few atoms, so that angles depend on each other.
(define (random-angle kinds)
  (for/fold ([u (random-multiple kinds)]) ([i (in-range (random 3))])
    (e:+ u (random-multiple kinds))))

(define (random-multiple kinds)
  (define atoms
    (append (list 'a 'a 'b 'b (f op:* 'c 'x) 1)
            (if (memq 'literal kinds) (list (application 'q '(t)) (application 'q '(t))) '())
            (if (memq 'radical kinds) (list (f op:sqrt 'x)) '())))
  (e:* (choose 1 1 1 2 -1 1/2 -1/3 3 2/3) (choose-from atoms)))

(define (random-exponent)
  (e:+ (e:* (choose 1 1 2 -1 1/2) (choose 'n 'x)) (choose 0 0 1 -1 'n)))

;; Products and sums that roots are taken of; many are positive.
(define (random-radicand kinds)
  (define (symbol) (choose-from symbols))
  (case (random 10)
    [(0) (choose 2 3 6 8 12 3/4)]
    [(1 2) (symbol)]
    [(3) (f op:* (symbol) (symbol))]
    [(4) (f op:/ (symbol) (symbol))]
    [(5) (f op:+ (e:expt (symbol) 2) (e:expt (symbol) 2))]
    [(6) (f op:- (e:expt (symbol) 2) (e:expt (symbol) 2))]
    [(7) (f op:* (choose 2 4 1/2 9) (f op:expt (f (choose op:+ op:-) (symbol) 'b) (choose 1 2 3)))]
    [(8) (random-expression 1 (filter (lambda (k) (memq k '(rational literal flonum))) kinds))]
    [else (f op:+ (symbol) (choose 1 2 'b (f op:* 'a 'b)))]))

;; Under a sine or cosine mostly.
(define (random-inverse kinds)
  (define y (random-leaf kinds))
  (define x (random-leaf kinds))
  (define angle
    (choose (f op:asin y) (f op:acos y) (f op:atan y) (f op:atan y x) (f op:atan y x)))
  (case (random 5)
    [(0) angle]
    [(1) (f (choose op:sin op:cos) (f op:* 2 angle))]
    [(2) (f (choose op:sin op:cos op:tan) (f op:+ angle 'b))]
    [else (f (choose op:sin op:cos op:tan) angle)]))

;; ---------------------------------------------------------------------------

;; (depth kind ...)
(define classes
  '((4 rational) (3 rational literal)
    (4 trigonometric) (3 trigonometric rational literal) (3 trigonometric hyperbolic)
    (4 radical) (3 radical rational literal) (3 root) (3 radical trigonometric)
    (4 exponential) (3 exponential hyperbolic rational) (3 power) (3 logarithm)
    (3 exponential logarithm power)
    (3 inverse) (3 inverse trigonometric) (3 modulus) (3 modulus radical literal)
    (3 flonum rational) (3 flonum trigonometric) (3 flonum radical)
    (2 nested radical)
    (3 rational trigonometric radical exponential literal)
    (3 rational trigonometric hyperbolic exponential power logarithm radical root inverse
       modulus literal)
    (2 rational trigonometric hyperbolic exponential power logarithm radical root nested
       inverse modulus literal flonum)))

(define class-depth car)
(define class-kinds cdr)
