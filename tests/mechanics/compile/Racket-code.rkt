#lang racket/base
;; Compiled code computes what the expression's value is, short or long.

(require racket/flonum
         mechanics/algebra/expression/expression
         mechanics/algebra/expression/operation
         mechanics/compile/Racket-code
         mechanics/compile/program
         mechanics/generic/arithmetic
         mechanics/generic/elementary
         "../support/checks.rkt" "../support/close.rkt" "../support/random.rkt"
         "../support/evaluate.rkt")

(define (refuse e) (raise-argument-error 'program-of "an expression of the inputs" e))

;; The outputs at a point, an association list of symbols and numbers.
(define (run point . es)
  (define p (expressions->program (map car point) es refuse))
  (define input (apply flvector (map cdr point)))
  (define output (make-flvector (length es)))
  (((program->maker p)) input output)
  (for/list ([x (in-flvector output)]) x))

(define (alike? x y) (close? x y 1e-12))

(define point '((x . 0.3) (y . -1.7) (z . 2.5)))
(define (value e)
  (real->double-flonum (evaluate-expression e (lambda (s args) (cdr (assq s point))))))

(define-check (check-compiled e)
  (define compiled (car (run point e)))
  (unless (alike? compiled (value e))
    (with-check-info (['expression e] ['compiled compiled] ['value (value e)])
      (fail-check))))

(test-case "every operation"
  (define (unary? op)
    (and (not (memq op (list op:+ op:- op:* op:/)))
         (procedure-arity-includes? (operation-numeric op) 1)))
  (for ([op (in-list operations)])
    (define f (operation-numeric op))
    (when (and (unary? op) (real? (f 0.3)))
      (check-compiled (e:apply op 'x)))
    (when (and (procedure-arity-includes? f 2) (real? (f 0.3 -1.7)))
      (check-compiled (e:apply op 'x 'y))))
  (check-compiled (e:apply op:acosh 'z))
  (check-compiled (e:apply op:abs 'y))
  (check-compiled (e:apply op:atan 'y 'x))
  (check-compiled (e:apply op:expt 'x 'y))
  (check-compiled (g:expt 'y 7))
  (check-compiled (g:expt 'x -3/2))
  (check-compiled (g:/ (g:- 'x 'y) (g:+ 'z 'x)))
  (check-compiled (g:- (g:* -1 'x 'y) (g:* 2 'z))))

(define (random-expression depth)
  (define (sub) (random-expression (- depth 1)))
  (if (zero? depth)
      (list-ref '(a b c x 2 -1/3 0.7) (random 7))
      (case (random 7)
        [(0 1) (g:+ (sub) (sub))]
        [(2 3) (g:* (sub) (sub))]
        [(4) (g:- (sub) (sub))]
        [(5) (g:sin (sub))]
        [else (g:/ (sub) (g:+ 2 (g:square (g:cos (sub)))))])))

(test-case "random expressions"
  (define symbols '(a b c x))
  (with-seeds 200
    (define e (random-expression 6))
    (define at (for/list ([s (in-list symbols)]) (cons s (+ 0.5 (random)))))
    (define expected
      (evaluate-expression e (lambda (s args) (cdr (assq s at)))))
    (when (and (real? expected) (< (abs expected) 1e6))
      (check-true (alike? (car (run at e)) (real->double-flonum expected))))))

(test-case "values pass from one section of a long program to others"
  (define powers
    (for/fold ([es '(x)]) ([k (in-range 1 1000)])
      (cons (g:sin (g:+ (car es) (list-ref es (random k)) 'y)) es)))
  (define expected
    (for/list ([e (in-list powers)])
      (value e)))
  (check-true (andmap alike? (apply run point powers) expected)))

(test-case "outputs may be inputs and numbers"
  (check-equal? (run point 'z 1/2 'x 'x) '(2.5 0.5 0.3 0.3))
  (check-equal? (run '() 7) '(7.0)))

(test-case "where a function is not real the value is not a number"
  (check-equal? (car (run point (g:sqrt 'y))) +nan.0)
  (check-equal? (car (run point (g:log 'y))) +nan.0)
  (check-equal? (car (run point (g:asin 'z))) +nan.0))

(test-case "several threads may run one program"
  (define e (for/fold ([e 'x]) ([k (in-range 700)]) (g:sin (g:+ e 'y))))
  (define make-run (program->maker (expressions->program '(x y) (list e) refuse)))
  (define ((at f) x)
    (let ([output (make-flvector 1)]) (f (flvector x 0.5) output) (flvector-ref output 0)))
  (define expected (for/list ([k (in-range 4)]) ((at (make-run)) (* 0.1 (+ k 1)))))
  (define found (make-vector 4 #f))
  (define threads
    (for/list ([k (in-range 4)])
      (thread (lambda ()
                (define f (make-run))
                (vector-set! found k (for/and ([_ (in-range 2000)])
                                       (= ((at f) (* 0.1 (+ k 1))) (list-ref expected k))))))))
  (for-each thread-wait threads)
  (check-equal? found (vector #t #t #t #t)))
