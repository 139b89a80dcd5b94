#lang racket/base
;; Machine code of programs has the values that Racket's compiler gives, bit for bit.

(require racket/flonum
         mechanics/compile/Racket-code
         mechanics/compile/closures
         mechanics/compile/program
         mechanics/compile/tiers
         (only-in mechanics/compile/compile-function program->compiled-function)
         (only-in mechanics/motion/system/rates-code machine-rates-of)
         (only-in mechanics/generic/up-down up)
         mechanics/numeric/machine/executable
         mechanics/numeric/machine/straight-code
         "../support/checks.rkt" "../support/random.rkt" "../support/skip.rkt")

(define (random-operand k)
  (cond [(zero? (random 10)) (random-flonum)]
        [(zero? (random 3)) (place (random k))]
        [else (place (max 0 (- k 1 (random (min k 25)))))]))

;; calls : how often an operation is a function; systems : how often it is a system of equations
(define (random-program inputs instructions outputs calls systems)
  ;; a system itself is no operand, but its first component is
  (define places-of-systems (make-hasheqv))
  (define (operand k)
    (define x (random-operand k))
    (if (and (place? x) (hash-ref places-of-systems (place-index x) #f))
        (place (+ 1 (place-index x)))
        x))
  ;; k : place of the value -> list of instructions
  (define (instruction k)
    (define name
      (apply random-choice
             (if (< (random) calls)
                 '(sin cos sin cos tan exp log asin acos atan atan2 expt)
                 '(add subtract multiply add subtract multiply divide negate abs sqrt))))
    (case name
      [(add subtract multiply divide expt) (list name (operand k) (operand k))]
      [(atan2) (list 'atan (operand k) (operand k))]
      [else (list name (operand k))]))
  (define end (+ inputs instructions))
  (define all
    (let loop ([k inputs])
      (cond [(>= k end) '()]
            [(< (random) systems)
             (define n (random-choice 1 2 3 5 8 9 12))
             (hash-set! places-of-systems k #t)
             (append (random-system k n (lambda () (operand k))) (loop (+ k n 1)))]
            [else (cons (instruction k) (loop (+ k 1)))])))
  (program inputs
           (list->vector all)
           (for/vector ([_ (in-range outputs)]) (operand (+ inputs (length all))))))

;; A system of n unknowns at the place k, symmetric or not, and its components.
(define (random-system k n operand)
  (define A (for*/hash ([i n] [j n]) (values (cons i j) (operand))))
  (define symmetric? (random-choice #t #f))
  (define (entry i j)
    (hash-ref A (if (and symmetric? (> i j)) (cons j i) (cons i j))))
  (cons (cons 'solve
              (for*/list ([i n] [j (+ n 1)]) (if (= j n) (operand) (entry i j))))
        (for/list ([j n]) (list 'component (place k) j))))

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
    (with-seeds 100
      (define p (random-program 5 (random-integer 1 150) 6 (random-choice 0 0.05 0.3 1) 0))
      (check-alike p (machine-procedure p))))

  (test-case "random programs with systems of equations"
    (with-seeds 70
      (define p (random-program 5 (random-integer 1 200) 6 0.1 (random-choice 0.02 0.2)))
      (check-alike p (machine-procedure p))))

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

  (test-case "a procedure takes little of the stack: programs of more values at once are none"
    (define n 10000)
    (define p
      (program 1
               (for/vector ([k (in-range 1 (* 2 n))])
                 (cond [(< k n) (list 'add (place (- k 1)) (/ 1.0 k))]
                       [else (list 'multiply (place (- k 1)) (place (- (* 2 n) k 1)))]))
               (vector (place (- (* 2 n) 1)) (place n) (place 17))))
    (check-false (machine-procedure p))
    (check-false (machine-rates-of (program->compiled-function p (up 0 0 0) 'f) 1))
    (for ([x (in-list '(-0.3 -9.0 1e-5))])
      (define v (flvector x))
      (check-equal? (values-by ((program->tiered-maker p)) p v)
                    (values-by ((program->maker p)) p v))))

  (test-case "a long program of few values at once is one procedure"
    (define n 9000)
    (define p
      (program 1
               (for/vector ([k (in-range 1 n)])
                 (list (if (even? k) 'add 'multiply) (place (- k 1)) (place (max 0 (- k 7)))))
               (vector (place (- n 1)))))
    (define-values (run by-closures) (values (machine-procedure p) ((program->closure-maker p))))
    (for ([x (in-list '(-0.3 1.0 1e-5))])
      (check-equal? (values-by run p (flvector x)) (values-by by-closures p (flvector x)))))

  (test-case "no code where there is none for a function"
    (check-false (machine-procedure (program 1 (vector (list 'sinh (place 0))) (vector (place 1)))))
    (check-false (machine-instruction? (list 'sinh 1)))))

(skip-unless (machine?) "no processor that machine code is written for" (check-machine-code))
