#lang racket/base
;; Machine code of programs has the values that Racket's compiler gives, bit for bit.

(require racket/flonum
         rackunit
         mechanics/compile/code
         mechanics/compile/interpreter
         mechanics/compile/machine-code
         mechanics/compile/program
         (only-in mechanics/motion/system/rates-code program-machine-rates)
         mechanics/numeric/machine/executable
         mechanics/numeric/machine/straight-code
         "../support/random.rkt" "../support/skip.rkt")

(define (random-operand k)
  (cond [(zero? (random 10)) (random-flonum)]
        [(zero? (random 3)) (place (random k))]
        [else (place (max 0 (- k 1 (random (min k 25)))))]))

;; calls : how often an operation is a function
(define (random-program inputs instructions outputs calls others)
  (define (operand k) (random-operand k))
  (define (instruction k)
    (define names
      (cond [(< (random) others) '(sinh tanh atan2)]
            [(< (random) calls) '(sin cos sin cos tan exp log asin acos atan expt)]
            [else '(add subtract multiply add subtract multiply divide negate abs sqrt)]))
    (define name (apply random-choice names))
    (case name
      [(add subtract multiply divide expt) (list name (operand k) (operand k))]
      [(atan2) (list 'atan (operand k) (operand k))]
      [else (list name (operand k))]))
  (define end (+ inputs instructions))
  (program inputs
           (for/vector ([k (in-range inputs end)]) (instruction k))
           (for/vector ([_ (in-range outputs)]) (operand end))))

(define odd-numbers
  '(0.0 -0.0 1.0 -1.0 +inf.0 -inf.0 +nan.0 1e300 1e-310 0.5 2.0 3.0 -3.0 1e22 -2.5))

(define (random-inputs n)
  (for/flvector #:length n ([_ (in-range n)])
    (if (zero? (random 4)) (apply random-choice odd-numbers) (random-flonum))))

(define (values-by run p input)
  (define output (make-flvector (vector-length (program-outputs p)) 99.0))
  (run input output)
  output)

(define (check-alike p run)
  (define compiled ((program->maker p)))
  (for ([_ (in-range 10)])
    (define input (random-inputs (program-inputs p)))
    (with-check-info (['program p] ['input input])
      (check-equal? (values-by run p input) (values-by compiled p input)))))

(define (check-machine-code)
  (test-case "random programs, with many calls and few"
    (with-seeds 150
      (define p (random-program 5 (random-integer 1 150) 6 (random-choice 0 0.05 0.3 1) 0))
      (check-alike p (machine-procedure p))))

  (test-case "stretches, between functions that there is no code for"
    (with-seeds 60
      (define p (random-program 5 (random-integer 1 200) 6 0.1 (random-choice 0 0.02 0.2)))
      (define stretches (or (machine-stretches p) (hasheqv)))
      (check-alike p ((program->interpreter-maker p #:stretches stretches)))))

  (test-case "sine and cosine of one angle at once are those of it alone"
    (define both
      (program 1 (vector (list 'sin (place 0)) (list 'cos (place 0))) (vector (place 1) (place 2))))
    (define run (machine-procedure both))
    (with-seed 1
      (for ([_ (in-range 20000)])
        (define x (* (exp (* 60 (- (random) 0.5))) (- (random) 0.5)))
        (check-equal? (values-by run both (flvector x)) (flvector (flsin x) (flcos x))))))

  (test-case "powers of numbers that are special"
    (define power (program 2 (vector (list 'expt (place 0) (place 1))) (vector (place 2))))
    (define run (machine-procedure power))
    (for* ([x (in-list odd-numbers)] [y (in-list odd-numbers)])
      (check-equal? (values-by run power (flvector x y)) (flvector (flexpt x y)))))

  (test-case "more values at once than there are registers"
    (define n 60)
    (define p
      (program n
               (for/vector ([k (in-range (* 2 n))])
                 (if (< k n)
                     (list 'multiply (place k) (place (modulo (+ k 1) n)))
                     (list 'add (place k) (place (- (* 3 n) k 1)))))
               (for/vector ([k (in-range n)]) (place (+ n n k)))))
    (with-seeds 5 (check-alike p (machine-procedure p))))

  (test-case "a procedure takes little of the stack: longer programs are several, or none"
    (define n 10000)
    (define p
      (program 1
               (for/vector ([k (in-range 1 (* 2 n))])
                 (cond [(< k n) (list 'add (place (- k 1)) (/ 1.0 k))]
                       [else (list 'multiply (place (- k 1)) (place (- (* 2 n) k 1)))]))
               (vector (place (- (* 2 n) 1)) (place n) (place 17))))
    (check-false (machine-procedure p))
    (check-false (program-machine-rates p 1))
    (define stretches (machine-stretches p))
    (check-equal? (hash-count stretches) 3)
    (define-values (run by-machine)
      (values ((program->interpreter-maker p))
              ((program->interpreter-maker p #:stretches stretches))))
    (for ([x (in-list '(-0.3 -9.0 1e-5))])
      (check-equal? (values-by by-machine p (flvector x)) (values-by run p (flvector x)))))

  (test-case "no code where there is none for a function"
    (check-false (machine-procedure (program 1 (vector (list 'sinh (place 0))) (vector (place 1)))))
    (check-false (machine-instruction? (list 'solve 2 1)))))

(skip-unless (machine?) "no processor that machine code is written for" (check-machine-code))
