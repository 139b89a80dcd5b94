#lang racket/base
;; gradient, jacobian and their products agree with D: on every operation, on
;; random programs, on what they are used for, and where derivatives nest.

(require mechanics/generic/arithmetic
         mechanics/generic/compare
         mechanics/generic/elementary
         mechanics/generic/kind
         mechanics/generic/sums-and-products
         mechanics/generic/rounding
         mechanics/value/matrix/matrix
         mechanics/value/operator
         mechanics/value/signature
         mechanics/value/structure
         mechanics/value/simplify
         mechanics/calculus/derivative
         mechanics/calculus/gradient
         mechanics/compile/definite-integral
         mechanics/calculus/literal-function
         mechanics/error/failure
         "../support/checks.rkt"
         "../support/close.rkt" "../support/random.rkt" "../support/same.rkt"
         "../support/laws/derivation.rkt" "../support/laws/law.rkt"
         "../support/random/element.rkt" "../support/random/program.rkt")

(define-syntax-rule (check-agrees f x ...)
  (let ([point (list x ...)])
    (check-same (apply (gradient f) point) (apply (D f) point))))

(define F (literal-function 'F (-> (UP Real (UP Real Real) (DOWN Real Real)) Real)))

;; ---------------------------------------------------------------------------
;; Every rule

(define records (append arithmetic-operations elementary-operations rounding-operations))

(for ([r (in-list records)])
  (define f (generic-op-procedure r))
  (define (argument interval) (+ (car interval) (* (- (cadr interval) (car interval)) (random))))
  (test-case (format "~a of ~a has one rule in both modes"
                     (generic-op-name r) (length (generic-op-partials r)))
    (with-seed 451
      (for ([_ (in-range 10)])
        (define args (map argument (generic-op-domain r)))
        (check-same (apply (gradient f) args) (apply (D f) args))
        ;; both arguments made of both variables
        (define (mixed s)
          (define x (g:+ (ref s 0) (g:* 1/100 (ref s 1))))
          (define y (g:- (ref s 1) (g:* 1/100 (ref s 0))))
          (if (null? (cdr args)) (f x) (f x y)))
        (define point (if (null? (cdr args)) (up (car args) 0.5) (apply up args)))
        (check-agrees mixed point))))
  (unless (memq r rounding-operations)
    (test-case (format "~a of ~a, of symbols" (generic-op-name r) (length (generic-op-partials r)))
      (define symbols (if (null? (cdr (generic-op-partials r))) '(x) '(x y)))
      (check-equal? (simplify (apply (gradient f) symbols)) (simplify (apply (D f) symbols))))))

;; ---------------------------------------------------------------------------
;; Shapes

(test-case "the gradient has the shape of the derivative"
  (check-equal? ((gradient (lambda (s) (g:* (ref s 0) (g:square (ref s 1))))) (up 2 3)) (down 9 12))
  (check-equal? ((gradient (lambda (s) (g:* (ref s 0) (g:square (ref s 1))))) (down 2 3)) (up 9 12))
  (check-equal? ((gradient (lambda (s) (g:* (ref s 0) (g:square (ref s 1))))) (vector 2 3))
                (down 9 12))
  (check-equal? ((gradient (lambda (s) (g:* (ref s 0) (ref s 1 0) (ref s 2 1))))
                 (up 2 (up 3 0) (down 0 5)))
                (down 15 (down 10 0) (up 0 6)))
  (check-equal? ((gradient g:cube) 2) 12)
  (check-equal? ((gradient (lambda (s) 3)) (up)) (down)))

(test-case "several arguments are one up tuple"
  (check-equal? ((gradient (lambda (x y z) (g:* x y z))) 2 3 5) (down 15 10 6))
  (check-equal? ((gradient (lambda (s t) (g:* (ref s 0) (ref s 1) t))) (up 2 3) 5)
                (down (down 15 10) 6)))

(test-case "by a matrix it is the tuple of its columns, as D's is"
  (define m (matrix-by-rows (list 1 'a 'b) (list 3 4 5)))
  (define (bilinear m) (g:* (down 5 'y) (g:* m (up 'u 7 'v))))
  (check-equal? ((gradient bilinear) m)
                (up (down (g:* 5 'u) (g:* 'y 'u))
                    (down 35 (g:* 7 'y))
                    (down (g:* 5 'v) (g:* 'y 'v))))
  (check-agrees bilinear m)
  (check-agrees (lambda (s) (g:* (ref s 0) (g:square (matrix-ref (ref s 1) 0 1)) (ref s 2)))
                (up 2 m 'z))
  (check-same ((jacobian (lambda (m) (g:* m (up 1 2 3)))) m)
              ((D (lambda (m) (g:* m (up 1 2 3)))) m)))

(test-case "exact points have exact gradients, flonum points flonum ones"
  (check-equal? ((gradient (lambda (x y) (g:/ x y))) 1 3) (down 1/3 -1/9))
  (check-equal? ((gradient (lambda (x y) (g:+ (g:* 2 x) (g:* 1/2 y)))) 1.0 3.0) (down 2.0 0.5))
  (check-equal? ((gradient (lambda (x y) (g:* 2 x))) 1.0 3.0) (down 2.0 0))
  (check-equal? ((gradient (lambda (x y) (g:* x y))) 1.0 'a) (down 'a 1.0))
  (check-equal? ((gradient (lambda (x y) (g:* x x y))) +i 2) (down +4i -1)))

(test-case "what the value does not depend on has derivative 0"
  (check-equal? ((gradient (lambda (x y z) (g:* x z))) 2.0 3.0 4.0) (down 4.0 0 2.0))
  (check-equal? ((gradient (lambda (x y) 7)) 1.0 2.0) (down 0 0))
  (check-equal? ((gradient (lambda (x y) (g:* 0 x))) 'a 'b) (down 0 0)))

;; ---------------------------------------------------------------------------
;; Values

(test-case "symbolic gradients have the canonical form that D's have"
  (define (V s)
    (define r (g:sqrt (g:+ (g:square (ref s 0)) (g:square (ref s 1)))))
    (g:+ (g:/ 'k r) (g:* 'a (g:sin (g:* (ref s 0) (ref s 1))) (g:expt r 'n))))
  (check-equal? (simplify ((gradient V) (up 'x 'y))) (simplify ((D V) (up 'x 'y)))))

(test-case "literal functions of any signature"
  (check-equal? ((gradient (literal-function 'f)) 't) ((D (literal-function 'f)) 't))
  (check-equal? ((gradient F) (up 't (up 'x 'y) (down 'p 'q)))
                ((D F) (up 't (up 'x 'y) (down 'p 'q))))
  (define (along s)
    (define x (ref s 0))
    (define y (ref s 1))
    (F (up (g:* x y) (up (g:square x) y) (down (g:sin y) 'c))))
  (check-agrees along (up 'a 'b))
  (check-agrees (lambda (s) (F (up 1 (up (ref s 0) 2) (down (ref s 0) (ref s 0))))) (up 'a 'b)))

(test-case "programs: loops, recursion, conditions, early exits, state of one's own"
  (define (power x n) (if (zero? n) 1 (g:* x (power x (sub1 n)))))
  (check-agrees (lambda (x y) (g:+ (power x 5) (power y 4))) 1.5 'b)
  (define (collatz x y) (if (g:< x y) (g:* x (g:square y)) (g:- x y)))
  (check-agrees collatz 1.0 2.0)
  (check-agrees collatz 2.0 1.0)
  (define (leave x y) (let/ec return (g:for/sum ([n 10]) (when (= n 3) (return (g:expt x n))) y)))
  (check-agrees leave 2.0 3.0)
  (define (fill x y)
    (define v (make-vector 5 x))
    (for ([i 4]) (vector-set! v (add1 i) (g:* y (g:+ (vector-ref v i) i))))
    (vector-ref v 4))
  (check-agrees fill 2 3)
  (check-agrees (lambda (x y) (g:* (g:max x y) (g:min x (g:* 2 y)) (g:abs (g:- x y)))) 1.0 3.0)
  (check-agrees (lambda (x y) (if (g:zero? (g:- x x)) (g:* x y) 0)) 1.0 3.0))

(test-case "of equal values neither is the greater, unless their derivatives are equal too"
  (check-exn exn:fail:mechanics:singular? (lambda () ((gradient g:max) 1.0 1.0)))
  (check-exn exn:fail:mechanics:singular?
             (lambda () ((gradient (lambda (x y) (g:abs (g:- x y)))) 1.0 1.0)))
  (check-equal? ((gradient (lambda (x y) (g:max (g:* x y) (g:* y x)))) 2.0 3.0) (down 3.0 2.0)))

(test-case "a root of what varies has no derivative at 0, even where the first one vanishes"
  (for ([d (list D gradient)])
    (check-exn exn:fail:mechanics:singular?
               (lambda () ((d (lambda (x y) (g:sqrt (g:square x)))) 0 1)))
    (check-equal? ((d (lambda (x y) (g:* x (g:sqrt (g:* 0 y))))) 3 1) (down 0 0))))

(test-case "integrals, with the variables in the integrand and in the limits"
  (define (f s) (definite-integral (lambda (t) (g:* (ref s 0) (g:exp (g:* -1 t (ref s 1)))))
                  (g:* 1/2 (ref s 1)) (ref s 2)))
  (check-agrees f (up 2.0 0.5 3.0))
  (check-agrees (lambda (s) (g:* (f s) (ref s 0))) (up 2.0 0.5 3.0))
  (check-same ((Hessian-vector-product f) (up 2.0 0.5 3.0) (up 1 2 3))
              (g:* (((g:expt D 2) f) (up 2.0 0.5 3.0)) (up 1 2 3))))

(with-seed 452
  (for ([i (in-range 60)])
    (define-values (program inputs) (random-program))
    (define (f s) (program (structure-elements s)))
    (define flonums (list->up (for/list ([_ (in-range inputs)]) (random-flonum))))
    (test-case (format "random program ~a" i)
      (check-agrees f flonums)
      (check-same ((gradient f) (s:map inexact->exact flonums)) ((D f) flonums))
      (define v (list->up (for/list ([_ (in-range inputs)]) (random-flonum))))
      (check-same ((Hessian-vector-product f) flonums v) (g:* (((g:expt D 2) f) flonums) v)))))

(with-seed 453
  (for ([i (in-range 20)])
    (define-values (program inputs) (random-program #:length 6 #:conditions? #f))
    (define (f s) (program (structure-elements s)))
    (define symbols (list->up (for/list ([s (in-list '(a b c d e))] [_ (in-range inputs)]) s)))
    (test-case (format "random program ~a of symbols" i)
      (check-agrees f symbols))))

;; ---------------------------------------------------------------------------
;; Laws

(define reverse-derivation
  (derivation gradient (lambda (i f) (lambda (x y) (ref ((gradient f) x y) i)))))

(for ([title '("flonums" "exact rationals" "symbols" "dual numbers" "complex numbers")]
      [number (list random-flonum random-rational (lambda () (random-choice 'a 'b 'c)) random-dual
                    (lambda () (/ (random-complex) 4)))]
      [seed (in-naturals 461)])
  (check-laws (string-append "gradient at " title) derivation-laws reverse-derivation
              (draw-functions number random-function) same? #:seed seed)
  (check-laws (string-append "components of gradients at " title) partial-laws reverse-derivation
              (draw-functions number random-function-of-two) same? #:seed (+ 10 seed)))

;; ---------------------------------------------------------------------------
;; Uses

(define (Rosenbrock s)
  (g:for/sum ([i (in-range (sub1 (s:length s)))])
    (define x (ref s i))
    (g:+ (g:* 100 (g:square (g:- (ref s (add1 i)) (g:square x)))) (g:square (g:- 1 x)))))

(define (log-sum-exp s) (g:log (g:for/sum ([x s]) (g:exp x))))

;; A network of two layers, its weights a tuple of two matrices as tuples of rows.
(define (network weights)
  (define (layer rows xs)
    (for/list ([row rows])
      (g:tanh (g:for/sum ([w row] [x xs]) (g:* w x)))))
  (define output (layer (ref weights 1) (layer (ref weights 0) '(0.3 -1.2 0.7))))
  (g:for/sum ([y output] [target '(0.5 -0.25)]) (g:square (g:- y target))))

;; Gravitational energy of bodies of masses 1 2 3 ... at these positions.
(define (gravitational-energy positions)
  (define n (s:length positions))
  (g:- (g:for*/sum ([i (in-range n)] [j (in-range i)])
         (g:/ (* (add1 i) (add1 j)) (euclidean-norm (g:- (ref positions i) (ref positions j)))))))

(define (gravitational-force positions i)
  (for/fold ([force (up 0 0 0)]) ([j (in-range (s:length positions))] #:unless (= i j))
    (define r (g:- (ref positions j) (ref positions i)))
    (g:+ force (g:* (/ (* (add1 i) (add1 j)) (g:cube (euclidean-norm r))) r))))

(define (random-tuple n [scalar random-flonum]) (list->up (for/list ([_ (in-range n)]) (scalar))))
(define (random-position) (random-tuple 3))

(test-case "Rosenbrock's function: the derivative, at its minimum zero"
  (with-seed 471 (check-agrees Rosenbrock (random-tuple 8)))
  (check-same ((gradient Rosenbrock) (random-tuple 6 (lambda () 1.0)))
              (flip (random-tuple 6 (lambda () 0)))))

(test-case "the gradient of log Σ exp sums to 1"
  (with-seed 472
    (define slope ((gradient log-sum-exp) (random-tuple 50)))
    (check-= (for/sum ([p slope]) p) 1.0 1e-12)))

(test-case "a network of tanh neurons"
  (with-seed 473
    (define (weights m n) (random-tuple m (lambda () (random-tuple n))))
    (check-agrees network (up (weights 4 3) (weights 2 4)))))

(test-case "the gradient of the energy of bodies is minus the forces on them"
  (with-seed 474
    (define positions (random-tuple 6 random-position))
    (define forces (list->up (for/list ([i (in-range 6)]) (gravitational-force positions i))))
    (check-same ((gradient gravitational-energy) positions) (g:* -1 (flip forces)))))

(test-case "a hundred thousand variables"
  (define n 100000)
  (define point (s:generate n 'up (lambda (i) (+ 0.5 (/ (modulo (* 7919 i) 1000) 1000.0)))))
  (define slope ((gradient Rosenbrock) point))
  (define (by-hand i)
    (define (x k) (ref point k))
    (+ (if (< i (sub1 n))
           (- (* -400 (x i) (- (x (add1 i)) (* (x i) (x i)))) (* 2 (- 1 (x i))))
           0)
       (if (> i 0) (* 200 (- (x i) (* (x (sub1 i)) (x (sub1 i))))) 0)))
  (check-equal? (s:length slope) n)
  (check-true (for/and ([i (in-range n)]) (close? (ref slope i) (by-hand i)))))

(test-case "a million joints one after the other"
  ;; x ← 0.5 x + y makes y·2(1 - 2⁻ⁿ) + x 2⁻ⁿ
  (define (f x y) (for/fold ([x x]) ([_ (in-range 1000000)]) (g:+ (g:* 0.5 x) y)))
  (check-same ((gradient f) 1.0 3.0) (down 0.0 2.0)))

;; ---------------------------------------------------------------------------
;; jacobian and products

(define (spherical s)
  (define r (ref s 0))
  (define theta (ref s 1))
  (define phi (ref s 2))
  (up (g:* r (g:sin theta) (g:cos phi)) (g:* r (g:sin theta) (g:sin phi)) (g:* r (g:cos theta))))

(test-case "jacobian is D, with few values and with many"
  (define s (up 'r 'theta 'phi))
  (check-same ((jacobian spherical) s) ((D spherical) s))
  (define runs 0)
  (define (many s)
    (set! runs (add1 runs))
    (list->up (for/list ([i (in-range 10)]) (g:expt (ref s (modulo i 3)) i))))
  (check-same ((jacobian many) (up 1.0 2.0 3.0)) ((D many) (up 1.0 2.0 3.0)))
  (define (few s) (set! runs (add1 runs)) (down (g:for/sum ([x s]) (g:* x x)) (ref s 3)))
  (define point (random-tuple 10))
  (set! runs 0)
  (define J ((jacobian few) point))
  (check-equal? runs 1 "reverse mode runs once")
  (check-same J ((D few) point)))

(test-case "jacobian of values of every shape, and of one number"
  (check-same ((jacobian (lambda (t) (up (g:sin t) t))) 'a) (up (g:cos 'a) 1))
  (check-same ((jacobian (lambda (x y) (down (g:* x y) (up x (g:sin y))))) 'a 'b)
              ((D (lambda (x y) (down (g:* x y) (up x (g:sin y))))) 'a 'b))
  (check-equal? ((jacobian (lambda (x y) (matrix-by-rows (list x) (list (g:* x y))))) 2 3)
                (down (matrix-by-rows '(1) '(3)) (matrix-by-rows '(0) '(2))))
  (check-equal? ((jacobian (lambda (x y) (g:* x y))) 2 3) (down 3 2))
  (check-same (((jacobian (lambda (x y) (lambda (t) (g:* x y t)))) 2 3) 't)
              (down (g:* 3 't) (g:* 2 't))))

(test-case "products with the derivative are those products"
  (define s (up 'r 'theta 'phi))
  (define v (up 'a 'b 'c))
  (define w (down 'a 'b 'c))
  (check-same ((jacobian-vector-product spherical) s v) (g:* ((D spherical) s) v))
  (check-same ((vector-jacobian-product spherical) s w) (g:* w ((D spherical) s)))
  (check-same ((vector-jacobian-product g:sin) 'x 'w) (g:* 'w (g:cos 'x)))
  (define (f s) (g:* (g:square (ref s 0)) (g:sin (ref s 1)) (ref s 2)))
  (check-same ((Hessian-vector-product f) s v) (g:* (((g:expt D 2) f) s) v))
  (check-same ((Hessian-vector-product g:cube) 'x 'v) (g:* 6 'x 'v)))

;; ---------------------------------------------------------------------------
;; Nested derivatives

(define modes (list D gradient))

(test-case "a derivative within a derivative, in both modes, inside and outside"
  (for* ([outer (in-list modes)] [inner (in-list modes)])
    (check-equal? ((outer (lambda (x) (g:* x ((inner (lambda (y) (g:+ x y))) 1)))) 1) 1)
    (check-equal? ((outer (lambda (x) ((inner (lambda (y) (g:+ x y))) 3))) 'x) 0)
    (check-same ((outer (lambda (x) ((inner (lambda (y) (g:* y (g:* y x)))) (g:* x 3)))) 'x)
                (g:* 12 'x))
    (check-same ((outer (lambda (x) (g:* x ((inner g:square) x)))) 'x) (g:* 4 'x))
    (check-same ((outer (lambda (x) ((inner g:sin) (g:square x)))) 'x)
                (g:* -2 'x (g:sin (g:square 'x))))))

(test-case "three levels, in all modes"
  (define (f x y z) (g:+ (g:* x y z) (g:square (g:* x y z))))
  (for* ([d1 (in-list modes)] [d2 (in-list modes)] [d3 (in-list modes)])
    (check-same ((d1 (lambda (x) ((d2 (lambda (y) ((d3 (lambda (z) (f x y z))) 'c))) 'b))) 'a)
                (g:+ 1 (g:* 8 'a 'b 'c)))
    (check-same ((d1 (d2 (d3 (lambda (x) (g:expt x 5))))) 'x) (g:* 60 (g:square 'x)))))

(test-case "Taylor numbers inside and outside"
  (define second (g:expt D 2))
  (define (curvature x y) ((second (lambda (t) (g:* y (g:sin (g:* x t))))) x))
  (check-agrees curvature 'a 'b)
  (check-agrees curvature 0.7 1.3)
  (define (slope t) (ref ((gradient (lambda (x y) (g:* (g:sin (g:* x t)) y))) t 'b) 0))
  (check-same ((second slope) 'a)
              ((second (lambda (t) (ref ((D (lambda (x y) (g:* (g:sin (g:* x t)) y))) t 'b) 0)))
               'a)))

(test-case "gradients of functions of tuples made of gradients"
  (define (f s) (g:* (g:square (ref s 0)) (g:cube (ref s 1))))
  (define (length-of-slope s) (g:square ((gradient f) s)))
  (check-agrees length-of-slope (up 'x 'y))
  (check-agrees length-of-slope (up 1.5 2.5))
  (check-same ((jacobian (gradient f)) (up 'x 'y)) (((g:expt D 2) f) (up 'x 'y)))
  (check-same ((D (gradient f)) (up 'x 'y)) (((g:expt D 2) f) (up 'x 'y)))
  (check-same ((gradient (lambda (s) (ref ((D f) s) 0))) (up 'x 'y))
              (ref (((g:expt D 2) f) (up 'x 'y)) 0)))

(test-case "a function that D returned, applied where a gradient is taken"
  (define slope ((D (lambda (x) (lambda (y) (g:* (g:sin x) (g:cube y))))) 'a))
  (check-same ((gradient (lambda (x y) (g:* (slope (g:* x y)) x))) 'b 'c)
              ((D (lambda (x y) (g:* (slope (g:* x y)) x))) 'b 'c))
  ;; the ε of the outer function comes back in the argument
  (define slope-at-3 ((D (lambda (x) (lambda (h) (h x)))) 3))
  (define (twice y) (g:* y (slope-at-3 (lambda (z) (slope-at-3 (lambda (w) (g:* y z (g:sin w))))))))
  (check-same ((gradient twice) 'y) ((D twice) 'y))
  (define linear ((D (lambda (a) (lambda (s) (g:+ (g:* a (ref s 0)) (ref s 1))))) 3))
  (check-equal? ((gradient linear) (up 4 5)) (down 1 0)))

(test-case "the derivative of the shift, of functions that take gradients (arXiv:1211.4892)"
  (define (((shift u) f) x) (f (g:+ x u)))
  (define D-hat ((D shift) 0))
  (for ([d (in-list modes)])
    (check-same ((D-hat (D-hat (d g:exp))) 1) (exp 1.0))
    (check-same ((d (D-hat (D-hat g:exp))) 1) (exp 1.0))
    (check-same ((D-hat (lambda (y) ((d (lambda (x) (g:* x x y))) y))) 3) 12)))

(test-case "a closure over the variables, and a value assigned from within"
  (define total 0)
  (define (f x y)
    (define (g z) (g:* x z))
    (set! total (g:+ x y))
    (g:* (g y) total))
  (check-equal? ((gradient f) 2 3) (down 21 16))
  (check-equal? (format "~a" total) "5"))

;; ---------------------------------------------------------------------------
;; Independence

(test-case "gradients in many threads at once do not disturb each other"
  (define (job seed)
    (with-seed seed
      (define point (random-tuple 30))
      (define expected ((gradient Rosenbrock) point))
      (for/and ([_ (in-range 20)]) (equal? ((gradient Rosenbrock) point) expected))))
  (define results (make-vector 8 #f))
  (for-each thread-wait
            (for/list ([i (in-range 8)])
              (thread (lambda () (vector-set! results i (job (+ 480 i)))))))
  (check-equal? results (make-vector 8 #t)))

(test-case "a break stops it, and the next gradient is right"
  (define started (make-semaphore))
  (define worker
    (thread (lambda ()
              (with-handlers ([exn:break? void])
                ((gradient (lambda (x y)
                             (semaphore-post started)
                             (let loop ([x x]) (loop (g:+ (g:* 0.5 x) y)))))
                 1.0 2.0)))))
  (semaphore-wait started)
  (break-thread worker)
  (thread-wait worker)
  (check-equal? ((gradient (lambda (x y) (g:* x y))) 2.0 3.0) (down 3.0 2.0)))

(test-case "the operators print as what is typed, numbers as their values"
  (check-equal? (format "~a" gradient) "gradient")
  (check-equal? (format "~a" (gradient g:sin)) "(gradient sin)")
  (check-equal? (format "~a" (Hessian-vector-product g:sin)) "(Hessian-vector-product sin)")
  (define seen #f)
  ((gradient (lambda (x) (set! seen (format "~v" (up x (g:square x)))) x)) 'a)
  (check-equal? seen "(up a (* a a))")
  (check-true (operator? gradient)))
