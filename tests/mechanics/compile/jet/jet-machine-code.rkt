#lang racket/base
;; Expansions of random programs have the same bits by kernels, at first, and by machine code, once
;; runs have earned it: coefficients, and all that a step makes of them.

(require racket/flonum
         mechanics/compile/cache
         mechanics/compile/jet/jet-program
         mechanics/compile/program
         mechanics/numeric/Taylor/coefficient-sums
         mechanics/numeric/Taylor/expansion
         mechanics/numeric/machine/executable
         "../../support/checks.rkt" "../../support/machine-counter.rkt"
         "../../support/random.rkt" "../../support/skip.rkt")

(define-values (states parameters) (values 4 2))
(define inputs (+ states parameters))

;; The first state is the time.
(define (random-program instructions)
  (define (operand k) (if (zero? (random 6)) (random-flonum) (place (random k))))
  (define all
    (for/vector ([k (in-range inputs (+ inputs instructions))])
      (define name
        (random-choice 'add 'subtract 'multiply 'add 'subtract 'multiply 'multiply 'divide 'negate
                       'sqrt 'sin 'cos 'tan 'exp 'log 'asin 'acos 'atan 'expt 'power))
      (case name
        [(add subtract multiply divide expt) (list name (operand k) (operand k))]
        [(power) (list 'expt (operand k) (random-choice 2.0 3.0 -1.0 -1.5 0.5 0.7))]
        [else (list name (operand k))])))
  (define (output _) (place (random (+ inputs instructions))))
  (program inputs all (list->vector (cons 1.0 (build-list (- states 1) output)))))

(define (random-state wild)
  (for/flvector #:length states ([_ (in-range states)])
    (if (< (random) wild)
        (random-choice +nan.0 +inf.0 -inf.0 0.0 -0.0 4.9e-324 1e-310 1e300)
        (random-flonum))))

(define unit 0.25)

;; All that there is of the expansion at y
(define (results e y)
  (define n (flvector-length y))
  (define (room) (make-flvector n))
  (define-values (lost z rest value rates)
    (values (make-flvector n 1e-17) (room) (room) (room) (room)))
  (expand! e y unit)
  (motion-end! e 0.7 y lost z rest)
  (value-at! e 0.3 value)
  (rates-at! e 0.3 rates)
  (list (for/list ([k (in-range n)]) (flvector-copy (coefficient-row e k)))
        z rest value rates
        (for/list ([k (in-range 4)]) (last-size e k))))

(define (earn! e y)
  (for ([_ (in-range 510)]) (expand! e y unit)))

(define (by-machine? e) (and (expansion-machine e) (not (eq? 'later (expansion-machine e)))))

;; -> expansion of a random program, or #f where a program has none
(define (random-expansion instructions)
  (define make (program->expansion-maker (random-program instructions) states))
  (and (procedure? make)
       (make (random-integer 5 21) (for/flvector #:length inputs ([_ inputs]) (random-flonum)))))

(define (check-program instructions wild)
  (define e (random-expansion instructions))
  (when e
    (define ys (for/list ([_ (in-range 4)]) (random-state wild)))
    (define (all-results) (for/list ([y (in-list ys)]) (results e y)))
    (define by-kernels (all-results))
    (check-false (by-machine? e))
    (earn! e (car ys))
    (check-true (by-machine? e))
    (check-equal? (all-results) by-kernels)))

;; The same of functions of rows that are known.
(define (check-followed instructions)
  (define make (program->expansion-maker (random-program instructions) states #:follow? #t))
  (when (procedure? make)
    (define order (random-integer 5 21))
    (define e (make order (for/flvector #:length inputs ([_ inputs]) (random-flonum))))
    (for* ([row (in-vector (expansion-states e))] [k (in-range (+ order 1))])
      (flvector-set! row k (random-flonum)))
    (define (functions)
      (follow! e)
      (for/list ([row (in-vector (expansion-slopes e))]) (flvector-copy row)))
    (define by-kernels (functions))
    (for ([_ (in-range 510)]) (follow! e))
    (check-true (by-machine? e))
    (check-equal? (functions) by-kernels)))

;; Members of an ensemble differ in constants; of a program that is kept they share code, unless
;; the constants leave other lists of recurrences, as 0 and 1 do.
(define (check-members p y order members)
  (define (expansions)
    (for*/list ([constants (in-list members)]
                [make (in-value (program->expansion-maker p (flvector-length y)
                                                          #:constants constants))]
                #:when (procedure? make))
      (make order (apply flvector (append (for/list ([x (in-flvector y)]) x) constants)))))
  (define by-kernels (for/list ([e (in-list (expansions))]) (results e y)))
  (void (compiled-program p))
  (for ([e (in-list (expansions))] [expected (in-list by-kernels)])
    (earn! e y)
    (check-true (by-machine? e))
    (check-equal? (results e y) expected))
  (clear-compiled-programs))

(define (check-random-members)
  (define (constant _) (random-choice 0.0 1.0 -1.0 2.0 (random-flonum)))
  (check-members (random-program 10) (random-state 0.0) (random-integer 5 21)
                 (for/list ([_ (in-range 6)]) (build-list parameters constant))))

;; x' = v + a sin b x, v' = √(k x + 1.5): where a is 0 nobody needs the sine, which has another row
;; if b is not 1.
(define sine-that-is-not-needed
  (program 5
           (vector (list 'multiply (place 4) (place 0)) (list 'add (place 5) 1.5)
                   (list 'sqrt (place 6)) (list 'multiply (place 3) (place 0))
                   (list 'sin (place 8)) (list 'multiply (place 2) (place 9))
                   (list 'add (place 1) (place 10)))
           (vector (place 11) (place 7))))

(define (check-bits)
  (test-case "random programs, short and long"
    (with-seeds 60 (check-program 8 0.0))
    (with-seeds 6 (check-program 80 0.0)))
  (test-case "functions of rows that are known"
    (with-seeds 60 (check-followed 10)))
  (test-case "members that share code, or do not"
    (with-seeds 40 (check-random-members))
    (check-members sine-that-is-not-needed (flvector 0.5 0.3) 12
                   '((0.0 2.0 0.7) (0.0 1.0 0.9) (0.0 2.0 0.9) (0.4 1.0 0.9))))
  (test-case "from states that are infinite, tiny, or missing"
    (with-seeds 60 (check-program 10 0.2))))

(define (oscillator)
  (define p
    (program 3 (vector (list 'negate (place 1))) (vector 1.0 (place 2) (place 3))))
  (program->expansion-maker p 3))

(define (check-oscillator make)
  (define e (make 12 (flvector 0.0 0.0 0.0)))
  (define y (flvector 0.0 1.0 0.0))
  (earn! e y)
  (check-= (flvector-ref (coefficient-row e 1) 4) (/ (expt unit 4) 24) 1e-18)
  e)

(define (check-attacks)
  (test-case "threads that are killed while code is made leave it to others"
    (for ([_ (in-range 50)])
      (define make (oscillator))
      (define t (thread (lambda () (let loop () (check-oscillator make) (loop)))))
      (sleep 0)
      (kill-thread t)
      (check-oscillator make)))

  (test-case "threads that run one list at once"
    (define make (oscillator))
    (define all
      (for/list ([_ (in-range 8)])
        (thread (lambda () (for ([_ (in-range 5)]) (check-oscillator make) (sleep 0))))))
    (for-each thread-wait all)
    (check-true (by-machine? (check-oscillator make))))

  (test-case "where there is no memory for code, kernels go on"
    (define counters (let loop () (define c (make-counter)) (if c (cons c (loop)) '())))
    (check-false (by-machine? (check-oscillator (oscillator))))
    (check-true (pair? counters))))

(skip-unless (machine?) "no processor that machine code is written for"
  (check-bits)
  (check-attacks))
