#lang racket/base
;; Methods as machine code do what their Racket code does, bit for bit: errors of steps, states,
;; slopes and what is within a step, whatever the size of the system.

(require racket/flonum
         mechanics/compile/Racket-code
         mechanics/compile/program
         (only-in mechanics/motion/system/rates-code fix-parameters)
         mechanics/numeric/machine/executable
         mechanics/numeric/ode/dormand-prince-54
         mechanics/numeric/ode/dormand-prince-853
         mechanics/numeric/ode/right-hand-side
         mechanics/numeric/ode/integrate
         mechanics/numeric/ode/stepper
         "../../support/checks.rkt"
         "../../support/machine-counter.rkt" "../../support/random.rkt" "../../support/skip.rkt")

;; Rates of n components, y' = sin a − y or cos a − y, a being a sum or product of two of them or of
;; the parameters.
(define (random-rates n [parameters 0])
  (define inputs (+ n parameters))
  (define (input) (place (random inputs)))
  (define instructions
    (for*/vector ([i (in-range n)] [step (in-range 3)])
      (define before (place (+ inputs (* 3 i) step -1)))
      (case step
        [(0) (list (random-choice 'multiply 'subtract 'add) (input) (input))]
        [(1) (list (random-choice 'sin 'cos) before)]
        [else (list 'subtract before (place i))])))
  (program inputs instructions
           (for/vector ([i (in-range n)]) (place (+ inputs (* 3 i) 2)))))

;; ps : values of the inputs after as many as there are outputs
(define (by-compiler p ps)
  (fix-parameters ((program->maker p)) (vector-length (program-outputs p)) ps))

;; steps : so many are left to Racket code
(define (by-machine p [ps (flvector)] [steps 0])
  (define n (vector-length (program-outputs p)))
  (expandable (by-compiler p ps) #f
              (make-machine-rates n (flvector-length ps) (program-instructions p)
                                  (program-outputs p) #:steps (- steps-that-pay steps))
              ps))

(define (random-state n) (for/flvector #:length n ([_ (in-range n)]) (fl* 0.3 (random-flonum))))

(define methods (list dormand-prince-54 dormand-prince-853))

;; (f! y0) -> stepper
(define (start m f! y0) ((method-start m) f! y0))

;; steps : so many are taken before machine code is
(define (check-steps m p n y0 [ps (flvector)] [steps 0])
  (define a (start m (by-compiler p ps) y0))
  (define b (start m (by-machine p ps steps) y0))
  (define (same part) (check-equal? (part b) (part a)))
  (same stepper-state)
  (same (lambda (s) ((stepper-slope s))))
  (for ([h (in-list '(0.1 3.0 0.2 -0.15 1e-3 0.4))])
    (same (lambda (s) ((stepper-try! s) (fl* 0.5 h))))
    (same (lambda (s) ((stepper-try! s) h)))
    (for ([s (in-list (list a b))]) ((stepper-accept! s)))
    (same stepper-state)
    (same (lambda (s) ((stepper-slope s))))
    (define-values (in-a in-b) (values ((stepper-interpolant a)) ((stepper-interpolant b))))
    (for ([s (in-list (list a b))]) ((stepper-try! s) 0.01)) ; interpolants stay good
    (for ([theta (in-list '(0.0 0.3 0.8 1.0))])
      (define-values (x y) (values (make-flvector n) (make-flvector n)))
      (in-a theta x)
      (in-b theta y)
      (check-equal? y x))))

(define (check-methods)
  (test-case "steps of random systems"
    (with-seeds 25
      (define n (random-choice 1 2 3 4 5 8 9 13 24 31))
      (define parameters (random-choice 0 0 1 3))
      (define p (random-rates n parameters))
      (define ps (random-state parameters))
      (for ([m (in-list methods)]) (check-steps m p n (random-state n) ps))))

  (test-case "it is machine code that is run: the rates as Racket code are not asked"
    (define (refused y dy) (fail-check "rates as Racket code"))
    (for ([n (in-list '(1 5 8 9 13))])
      (define p (with-seed n (random-rates n)))
      (define f!
        (expandable refused #f
                    (make-machine-rates n 0 (program-instructions p) (program-outputs p)
                                        #:steps steps-that-pay)
                    (flvector)))
      (for ([m (in-list methods)])
        (define s (start m f! (random-state n)))
        (check-true (rational? ((stepper-try! s) 0.1)))
        ((stepper-accept! s))
        (((stepper-interpolant s)) 0.5 (make-flvector n)))))

  (test-case "steps of which the first are Racket code"
    (with-seeds 10
      (define n (random-choice 1 2 5 8 9 13))
      (define p (random-rates n 1))
      (for* ([m (in-list methods)] [steps (in-list '(1 2 4))])
        (check-steps m p n (random-state n) (flvector 0.7) steps))))

  (test-case "machine code is written when that pays, by all integrations of the rates together"
    (define p (random-rates 2))
    (define r (make-machine-rates 2 0 (program-instructions p) (program-outputs p)))
    (define f! (expandable ((program->maker p)) #f r (flvector)))
    (for ([k (in-range (* 2 steps-that-pay))])
      (define s (start dormand-prince-54 f! (flvector 0.1 0.2)))
      ((stepper-try! s) 0.1)
      ((stepper-accept! s))
      (check-equal? (machine-rates-pay? r) (>= k (- steps-that-pay 1)))))

  (test-case "integrations, with steps that are rejected"
    (with-seeds 10
      (define n (random-integer 1 12))
      (define p (random-rates n))
      (define y0 (random-state n))
      (for* ([m (in-list methods)] [end (in-list '(20.0 -5.0))])
        (define (run f!)
          (define-values (t y) (integrate m f! y0 0.0 end #:tolerance 1e-8))
          y)
        (check-equal? (run (by-machine p)) (run ((program->maker p)))))))

  (test-case "what is no number is an error that is none"
    (define p (program 2 (vector (list 'log (place 0))) (vector 1.0 (place 2))))
    (for ([m (in-list methods)])
      (define s (start m (by-machine p) (flvector -1.0 0.0)))
      (check-equal? ((stepper-try! s) 0.1) +nan.0)))

  (test-case "a method at rest has no error"
    (define p (program 2 (vector) (vector 0.0 0)))
    (for ([m (in-list methods)])
      (define s (start m (by-machine p) (flvector 1.0 2.0)))
      (check-equal? ((stepper-try! s) 0.1) 0.0)))

  (test-case "where there is no memory for code, steps are those of Racket code"
    (define p (random-rates 3))
    (define all
      (let loop ([all '()])
        (define counter (make-counter))
        (if counter (loop (cons counter all)) all)))
    (for ([m (in-list methods)]) (check-steps m p 3 (flvector 0.1 0.2 0.3)))
    (check-equal? (count-to 3 (car all)) 3.0))

  (test-case "two integrations of one right-hand side are apart"
    (with-seed 3
      (define p (random-rates 4))
      (define f! (by-machine p))
      (define-values (one other) (values (random-state 4) (random-state 4)))
      (define a (start dormand-prince-853 f! one))
      (define alone (start dormand-prince-853 (by-machine p) one))
      (define b (start dormand-prince-853 f! other))
      (for ([h (in-list '(0.1 0.2))])
        (for ([s (in-list (list a b alone))])
          ((stepper-try! s) h)
          ((stepper-accept! s))))
      (check-equal? (stepper-state a) (stepper-state alone)))))

(skip-unless (machine?) "no processor that machine code is written for" (check-methods))
