#lang racket/base
;; The cost of a gradient beside its function, run generically on flonums, and of a
;; product with the Hessian beside both; with JAX where it is installed.

(require (prefix-in m: mechanics)
         "clock.rkt" "python.rkt")

(provide gradient-heading gradient-rows)

;; ---------------------------------------------------------------------------
;; Functions of n variables

(define (sum-of-squares s) (m:for/sum ([x s]) (m:square x)))

(define (Rosenbrock s)
  (m:for/sum ([i (in-range (sub1 (m:vector-length s)))])
    (define x (m:vector-ref s i))
    (m:+ (m:* 100.0 (m:square (m:- (m:vector-ref s (add1 i)) (m:square x))))
         (m:square (m:- 1.0 x)))))

(define (log-sum-exp s) (m:log (m:for/sum ([x s]) (m:exp x))))

;; A chain of pendulums: sines, cosines and a root for each.
(define (chain-energy s)
  (m:for/sum ([i (in-range (sub1 (m:vector-length s)))])
    (define x (m:vector-ref s i))
    (define y (m:vector-ref s (add1 i)))
    (m:- (m:sqrt (m:+ 1.0 (m:square (m:sin (m:- y x))))) (m:cos x))))

;; name, function, the same in JAX
(define functions
  (list (list "sum of squares" sum-of-squares "(x*x).sum()")
        (list "Rosenbrock" Rosenbrock
              "(100*(x[1:] - x[:-1]**2)**2 + (1 - x[:-1])**2).sum()")
        (list "log Σ exp" log-sum-exp "jnp.log(jnp.exp(x).sum())")
        (list "chain of pendulums" chain-energy
              "(jnp.sqrt(1 + jnp.sin(x[1:] - x[:-1])**2) - jnp.cos(x[:-1])).sum()")))

(define (point n)
  (m:s:generate n 'up (lambda (i) (+ 0.5 (* 0.001 (modulo (* 7919 i) 1000))))))

;; ---------------------------------------------------------------------------

(define gradient-heading
  '("gradient" "n" "function µs" "gradient : function" "Hessian-vector : function"
    "JAX µs, compiled"))

(define (gradient-rows)
  (for*/list ([entry (in-list functions)] [n (in-list '(10 100 1000 10000 100000))])
    (define f (cadr entry))
    (define x (point n))
    (define-values (alone gradient product)
      (apply values
             (microseconds (lambda () (f x))
                           (lambda () ((m:gradient f) x))
                           (lambda () ((m:Hessian-vector-product f) x x)))))
    (list (car entry) (number->string n)
          (rounded alone) (rounded (/ gradient alone)) (rounded (/ product alone))
          (python (jax-program (caddr entry) n)))))

(define (rounded x) (number->string (/ (round (* 10.0 x)) 10.0)))

;; CPU time of one call of each: the least of many series of calls, taken in turn, so
;; that what slows the machine down for a while slows down all of them.  A series is
;; long enough to pay for the garbage it makes.
(define (microseconds . thunks)
  (define counts (map calls-per-series thunks))
  (collect-garbage)
  (for/fold ([least (map (lambda (_) +inf.0) thunks)]) ([_ (in-range 20)])
    (for/list ([thunk (in-list thunks)] [count (in-list counts)] [t (in-list least)])
      (min t (/ (* 1e3 (series thunk count)) count)))))

(define (series thunk count)
  (define start (cpu-milliseconds))
  (for ([_ (in-range count)]) (thunk))
  (- (cpu-milliseconds) start))

(define (calls-per-series thunk)
  (let loop ([n 1]) (if (< (series thunk n) 5) (loop (* 2 n)) n)))

(define (jax-program expression n)
  (format #<<PYTHON
import time, jax
from jax import numpy as jnp
jax.config.update("jax_enable_x64", True)
x = 0.5 + 0.001*((7919*jnp.arange(~a)) % 1000)
g = jax.jit(jax.grad(lambda x: ~a))
g(x).block_until_ready()
start = time.process_time()
for _ in range(100): g(x).block_until_ready()
print(round(1e4*(time.process_time() - start)))
PYTHON
          n expression))
