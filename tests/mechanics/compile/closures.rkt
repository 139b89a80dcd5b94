#lang racket/base
;; Closures, which run programs at once, do what compiled code does, bit for bit.

(require racket/flonum
         mechanics
         (only-in mechanics/compile/Racket-code program->maker)
         (only-in mechanics/compile/compile-function compiled-function-program)
         (only-in mechanics/compile/closures program->closure-maker)
         (only-in mechanics/compile/program place program program-outputs)
         (only-in mechanics/compile/tiers program->tiered-maker tiered-maker)
         "../support/checks.rkt" (only-in "../support/systems.rkt" L-chain))

(define (run maker p input)
  (define output (make-flvector (vector-length (program-outputs p))))
  ((maker) input output)
  output)

(define (check-tiers f example inputs)
  (define p (compiled-function-program (compile-function f example)))
  (define code (program->maker p))
  (define closures (program->closure-maker p))
  (for ([v (in-list inputs)]) (check-equal? (run closures p v) (run code p v))))

(define every-operation
  (lambda (s)
    (define-values (x y) (values (ref s 0) (ref s 1)))
    (up (+ x y) (- x y) (* x y) (/ x y) (- x) (+ 3 (* 2 x)) 7 y
        (sin x) (cos x) (tan x) (asin x) (acos x) (atan x) (atan x y) (exp x) (log x) (sqrt x)
        (expt x y) (expt x 5/2) (sinh x) (cosh x) (tanh x) (asinh x) (acosh x) (atanh x) (abs x)
        (sgn y) ((principal-value 2) x))))

(test-case "each operation, at ordinary values and others"
  (check-tiers every-operation (up 0.3 0.7)
               (list (flvector 0.3 0.7) (flvector -0.3 0.7) (flvector 2.5 -1.0)
                     (flvector 0.0 0.0) (flvector +inf.0 +nan.0))))

(test-case "systems of equations, two in one program"
  (define one (Lagrangian->state-derivative (L-chain 3 9.8)))
  (define start (up 0.0 (up 0.1 0.2 0.4) (up 0.5 -0.3 0.2)))
  (check-tiers (lambda (s) (up (one s) (one (* 2 s)))) start
               (list (flvector 0.0 0.1 0.2 0.4 0.5 -0.3 0.2) (make-flvector 7 0.0))))

(test-case "a system with more entries than a section has instructions"
  (define n 16)
  (define (tuple f) (vector->up (build-vector n f)))
  (define start (up 0.0 (tuple (lambda (k) (* 0.1 k))) (tuple (lambda (k) (sin k)))))
  (define (matrix s)
    (define q (coordinate s))
    (up (up 1 (velocity s))
        (let ([entry (lambda (i j)
                       (if (= i j) (+ 20 (ref q i)) (sin (- (ref q i) (* 2 (ref q j))))))])
          (* (/ 1 (apply matrix-by-rows
                         (for/list ([i n]) (for/list ([j n]) (entry i j)))))
             (velocity s)))))
  (check-tiers matrix start
               (list (for/flvector #:length (+ 1 (* 2 n)) ([k (in-naturals)]) (cos (+ 0.5 k))))))

(test-case "a runner goes over to compiled code in the end, and nobody sees it"
  (define p
    (program 1
             (for/vector ([k (in-range 600)]) (list 'add (place k) 1.0))
             (vector (place 600))))
  (define maker (tiered-maker p))
  (define one (maker))
  (define out (make-flvector 1))
  (for ([k (in-range 10000)])
    (one (flvector (->fl k)) out)
    (unless (= (flvector-ref out 0) (+ k 600.0)) (error "wrong at" k)))
  (define another (maker))
  (another (flvector 1.0) out)
  (check-equal? out (flvector 601.0)))
