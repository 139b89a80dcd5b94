#lang racket/base
;; Generic functions run on numbers of higher precision.
;;
;; A program (program.rkt) is taken for a list of operations on bigfloats, one after
;; the other: each takes about a microsecond, beside which it does not matter that
;; they are not compiled.  A function that cannot be traced is evaluated by the generic
;; arithmetic, as for flonums.

(require "code-check.rkt" "program.rkt" "trace.rkt"
         "../algebra/expression/expression.rkt"
         "../error/complain.rkt"
         "../generic/describe.rkt" "../generic/kind.rkt" "../generic/up-down.rkt"
         "../numeric/bigfloat/bigfloat-arithmetic.rkt" "../numeric/bigfloat/bigfloat-systems.rkt"
         "../value/bigfloat.rkt" "../value/shape.rkt")

(provide bigfloat-function
         structure->bigfloats bigfloats->structure)

;; f : a procedure of one structure; point : such a structure, of numbers
;; -> a procedure from vectors of math/bigfloat's numbers to such, in the precision
;; in force; the shape of its value; and whether f could be traced
(define (bigfloat-function who f point)
  (define (fail x) (raise-not-a-number who x))
  (define input (structure->bigfloats point fail))
  (define (value-at v) (f (bigfloats->structure point v)))
  (define value (value-at input))
  (define (generic v) (structure->bigfloats (check-shape who value (value-at v)) fail))
  (define-values (p shape) (trace who f point #:constants exact))
  (define run (and (program? p) (runs-on-bigfloats? p) (program->procedure p)))
  (if (and run (agree? run generic input) (agree? run generic (opposite input)))
      (values run shape #t)
      (values generic value #f)))

;; Constants are combined before they are rounded.
(define (exact x) (if (rational? x) (inexact->exact x) x))

(define (check-shape who before now)
  (unless (same-shape? before now)
    (complain-showing who "the function's value has changed its shape"
                      "before" before "now" now))
  now)

(define (raise-not-a-number who x)
  (complain who "expected real numbers; given ~a" (describe-with-value x)))

;; Racket's own tests may see through a placeholder (compile-function.rkt), so
;; the program is compared with the function on both sides of zero.
(define (agree? run generic v)
  (agrees? (lambda () (generic v))
           (lambda () (run v))
           #:same? (lambda (xs ys)
                     (for/and ([x (in-vector xs)] [y (in-vector ys)])
                       (close? (exact-value x) (exact-value y))))
           #:numbers? (lambda (ys) (for/and ([y (in-vector ys)]) (rational? (exact-value y))))))

(define (opposite v)
  (define negate (operation-on-bigfloats 'negate 1))
  (for/vector #:length (vector-length v) ([x (in-vector v)]) (negate x)))

;; a : of the function, b : of the program.  An a that is not finite tells nothing.
(define (close? a b)
  (or (not (rational? a))
      (and (rational? b)
           (<= (abs (- a b)) (* 1/1000000000000 (+ 1/1000 (abs a) (abs b)))))))

;; ---------------------------------------------------------------------------
;; Structures as vectors

;; (fail scalar) where one is not a real number.
(define (structure->bigfloats x fail)
  (for/vector ([x (in-list (scalars x))])
    (cond [(or (real? x) (other-number? x)) (raw-bigfloat x)]
          [(symbolic? x) (constant->bigfloat x fail)]
          [else (fail x)])))

;; A constant, such as a multiple of π, by a program without inputs.
(define (constant->bigfloat x fail)
  (define p (expressions->program '() (list x) (lambda (e) (fail x)) #:constants exact))
  (vector-ref ((program->procedure p) (vector)) 0))

(define (bigfloats->structure shape v)
  (scalars->structure shape (lambda (k) (wrap (vector-ref v k)))))

;; ---------------------------------------------------------------------------
;; Programs

;; Some operations are there for flonums only.
(define (runs-on-bigfloats? p)
  (for/and ([i (in-vector (program-instructions p))])
    (define name (instruction-operation i))
    (or (memq name '(solve component))
        (operation-on-bigfloats name (length (instruction-operands i))))))

;; values : vector; the instructions store the value of each at its place, after the
;; inputs and the numbers that occur.
(define (program->procedure p)
  (define n (program-inputs p))
  (define size (+ n (program-length p)))
  (define numbers (make-hasheqv))
  (define (where operand)
    (if (place? operand)
        (place-index operand)
        (hash-ref! numbers operand (lambda () (+ size (hash-count numbers))))))
  (define steps
    (for/list ([i (in-vector (program-instructions p))] [k (in-naturals n)])
      (instruction->step i k where)))
  (define outputs (for/list ([o (in-vector (program-outputs p))]) (where o)))
  (define constants
    (for/list ([(x k) (in-hash numbers)]) (cons k (real->bigfloat x))))
  (lambda (input)
    (define values (make-vector (+ size (hash-count numbers)) #f))
    (vector-copy! values 0 input)
    (for ([c (in-list constants)]) (vector-set! values (car c) (cdr c)))
    (for ([step! (in-list steps)]) (step! values))
    (for/vector #:length (length outputs) ([k (in-list outputs)]) (vector-ref values k))))

(define (instruction->step instruction k where)
  (define operation (instruction-operation instruction))
  (define operands (instruction-operands instruction))
  (case operation
    [(solve) (solving k (map where operands))]
    [(component)
     (define system (where (car operands)))
     (define j (cadr operands))
     (lambda (v) (vector-set! v k (vector-ref (vector-ref v system) j)))]
    [else (operating k (operation-on-bigfloats operation (length operands)) (map where operands))]))

(define (operating k f places)
  (define a (car places))
  (if (null? (cdr places))
      (lambda (v) (vector-set! v k (f (vector-ref v a))))
      (let ([b (cadr places)])
        (lambda (v) (vector-set! v k (f (vector-ref v a) (vector-ref v b)))))))

;; The value of a system, given as rows of [A b], is the vector of its solution; where
;; it has none, a vector of NaNs.
(define ((solving k places) v)
  (define n (integer-sqrt (length places)))
  (define entries (for/vector ([p (in-list places)]) (vector-ref v p)))
  (define (row i from to)
    (for/vector ([j (in-range from to)]) (vector-ref entries (+ (* i (+ n 1)) j))))
  (define x (solutions (build-vector n (lambda (i) (row i 0 n)))
                       (build-vector n (lambda (i) (row i n (+ n 1))))))
  (vector-set! v k (if (eq? x 'singular)
                       (make-vector n (real->bigfloat +nan.0))
                       (for/vector ([r (in-vector x)]) (vector-ref r 0)))))
