#lang racket/base
;; The cost of derivatives: at numbers, beside derivatives written by hand; as
;; expressions, in nodes for each node of the function.

(require (prefix-in m: mechanics)
         "clock.rkt" "python.rkt" "rotations.rkt" "task.rkt")

(provide derivative-micros growth-heading growth-rows order-heading order-rows
         peers-heading peers-rows growing-functions)

;; ---------------------------------------------------------------------------
;; At numbers

(define x (opaque 1.25))
(define place (m:up x (opaque -0.75) 2.0))
(define force (m:down x (opaque 0.5) -2.0))

(define (f t) (m:* t (m:sin t)))
(define (df t) (+ (sin t) (* t (cos t))))
(define (ddf t) (- (* 2 (cos t)) (* t (sin t))))

(define (potential s) (m:/ -1 (m:sqrt (m:square s))))
(define (attraction s)
  (define-values (x y z) (values (vector-ref s 0) (vector-ref s 1) (vector-ref s 2)))
  (define r² (+ (* x x) (* y y) (* z z)))
  (define r³ (* r² (sqrt r²)))
  (vector (/ x r³) (/ y r³) (/ z r³)))

(define (newton-root a)
  (for/fold ([y 1.0]) ([_ (in-range 6)]) (m:- y (m:/ (m:- (m:square y) a) (m:* 2 y)))))
(define (newton-root-slope a)
  (define-values (y dy)
    (for/fold ([y 1.0] [dy 0.0]) ([_ (in-range 6)])
      (define next (- y (/ (- (* y y) a) (* 2 y))))
      (values next (- dy (/ (- (* (- (* 2 y dy) 1) 2 y) (* (- (* y y) a) 2 dy)) (* 4 y y))))))
  dy)

(define (contraction v w)
  (+ (* (vector-ref v 0) (vector-ref w 0))
     (* (vector-ref v 1) (vector-ref w 1))
     (* (vector-ref v 2) (vector-ref w 2))))

(define place* (m:structure->vector place))
(define force* (m:structure->vector force))

(define derivative-micros
  (list
   (make-micro 'derivative "((D f) x) for x sin x"
               (lambda (n) (repeat n ((m:D f) x)))
               #:against (lambda (n) (repeat n (df x)))
               #:reach "500 ns")
   (make-micro 'derivative2 "((D (D f)) x) for x sin x"
               (lambda (n) (repeat n ((m:D (m:D f)) x)))
               #:against (lambda (n) (repeat n (ddf x)))
               #:reach "2 µs")
   (make-micro 'order2 "(((expt D 2) f) x) for x sin x, in one run"
               (lambda (n) (repeat n (((m:expt m:D 2) f) x)))
               #:against (lambda (n) (repeat n (ddf x)))
               #:reach "2 µs")
   (make-micro 'attraction "D of -1/r at an up of 3 flonums"
               (lambda (n) (repeat n ((m:D potential) place)))
               #:against (lambda (n) (repeat n (attraction place*))))
   (make-micro 'newton "D of a root by 6 steps of Newton's"
               (lambda (n) (repeat n ((m:D newton-root) x)))
               #:against (lambda (n) (repeat n (newton-root-slope x))))
   (make-micro 'contract3 "* of a down and an up of 3 flonums"
               (lambda (n) (repeat n (m:* force place)))
               #:against (lambda (n) (repeat n (contraction force* place*)))
               #:reach "75 ns")))

;; ---------------------------------------------------------------------------
;; As expressions: graphs of growing depth

;; name, n -> function of one variable, the same in Python
(define growing-functions
  (list
   (list "sin sin … sin x"
         (lambda (n) (lambda (x) (for/fold ([y x]) ([_ (in-range n)]) (m:sin y))))
         "y = sin(y)")
   (list "product of sin (x + k)"
         (lambda (n)
           (lambda (x) (for/fold ([y x]) ([k (in-range n)]) (m:* y (m:sin (m:+ x (add1 k)))))))
         "y = y*sin(x + k + 1)")
   (list "y ← y² + x"
         (lambda (n) (lambda (x) (for/fold ([y x]) ([_ (in-range n)]) (m:+ (m:square y) x))))
         "y = y**2 + x")
   (list "y ← x/(1 + y)"
         (lambda (n) (lambda (x) (for/fold ([y x]) ([_ (in-range n)]) (m:/ x (m:+ 1 y)))))
         "y = x/(1 + y)")))

(define growth-heading
  '("derivative as an expression" "n" "nodes of f" "of f′" "of f″" "f′ : f" "CPU µs"))

(define (growth-rows)
  (for*/list ([entry (in-list growing-functions)] [n (in-list '(10 40 160 640))])
    (define g ((cadr entry) n))
    (define (nodes h) (graph-size (h 'x)))
    (define size (nodes g))
    (define size′ (nodes (m:D g)))
    (define-values (_ ms) (call/cpu (lambda () (for ([_ (in-range 20)]) ((m:D g) 'x)))))
    (map (lambda (v) (format "~a" v))
         (list (car entry) n size size′ (nodes ((m:expt m:D 2) g))
               (/ (round (* 100.0 (/ size′ size))) 100)
               (round (* 50.0 ms))))))

;; ---------------------------------------------------------------------------
;; Derivatives of higher order, in one run and nested

(define (wave x) (m:/ (m:exp (m:sin x)) (m:+ 1 (m:square x))))
(define (nested n f)                    ; hidden in a plain function each time
  (for/fold ([f f]) ([_ (in-range n)]) (let ([slope (m:D f)]) (lambda (x) (slope x)))))

(define order-heading
  '("derivative of exp(sin x)/(1 + x²)" "order" "µs" "nested µs" "nodes" "nested nodes"))

(define (order-rows)
  (for/list ([n (in-list '(1 2 3 4 6 8 12 16 20))])
    (define one-run ((m:expt m:D n) wave))
    (define nest (and (<= n 8) (nested n wave)))
    (define (µs g) (round (least-µs (lambda () (g 1.25)))))
    (map (lambda (v) (format "~a" v))
         (list "" n (µs one-run) (if nest (µs nest) "")
               (graph-size (one-run 'x)) (if nest (graph-size (nest 'x)) "")))))

(define (least-µs thunk)
  (for/fold ([least +inf.0]) ([_ (in-range 5)])
    (define-values (_ ms) (call/cpu (lambda () (for ([_ (in-range 20)]) (thunk)))))
    (min least (* 50.0 ms))))

;; ---------------------------------------------------------------------------
;; First derivatives in other systems, where they are installed

(define peers-heading
  '("first derivative elsewhere" "n" "ours µs" "SymPy µs" "JAX µs, traced and compiled"))

(define (peers-rows)
  (for*/list ([entry (in-list growing-functions)] [n (in-list '(10 40))])
    (define g ((cadr entry) n))
    (define-values (_ ms) (call/cpu (lambda () (for ([_ (in-range 20)]) ((m:D g) 'x)))))
    (list (car entry) (format "~a" n) (format "~a" (round (* 50.0 ms)))
          (python (sympy-program (caddr entry) n))
          (python (jax-program (caddr entry) n)))))

(define (sympy-program step n)
  (format #<<PYTHON
import time
from sympy import Symbol, sin, diff
x = Symbol('x'); y = x
for k in range(~a): ~a
start = time.process_time(); diff(y, x); print(round(1e6*(time.process_time() - start)))
PYTHON
          n step))

(define (jax-program step n)
  (format #<<PYTHON
import time, jax
from jax.numpy import sin
def f(x):
    y = x
    for k in range(~a): ~a
    return y
start = time.process_time()
jax.jit(jax.grad(f))(0.3).block_until_ready()
print(round(1e6*(time.process_time() - start)))
PYTHON
          n step))
