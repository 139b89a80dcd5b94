#lang racket/base
;; Right-hand sides of y' = f(y) with values that methods compute: Taylor coefficients of solutions,
;; and machine code of whole steps.

(provide expandable expandable-expand
         expandable-machine-rates expandable-parameters
         rates-code machine-rates-pay? step-taken! steps-that-pay
         machine-rates-inputs machine-rates-parameters machine-rates-instructions
         machine-rates-outputs
         (protect-out make-machine-rates)
         take-work! rest!)

;; run     : y dy -> void
;; expand  : order -> expansion (numeric/Taylor/expansion.rkt), for one thread at a time
;; machine : machine-rates, or #f; parameters : their values, an flvector
;; work    : a method's room for its latest integration, or #f; idle? : may the next one use it?
(struct expandable (run expand machine parameters [work #:auto #:mutable] [idle? #:auto #:mutable])
  #:authentic
  #:property prop:procedure 0)

;; Rates as straight code (numeric/machine/straight-code.rkt): of so many inputs, the components of
;; y, and so many parameters behind them; outputs : operands; made : code that methods made of it,
;; method -> code, or #f where it is none; steps : so many were taken without it, by all
;; integrations; threads may lose some
(struct machine-rates (inputs parameters instructions outputs [made #:mutable] [steps #:mutable])
  #:authentic)

(define (make-machine-rates inputs parameters instructions outputs #:steps [steps 0])
  (machine-rates inputs parameters instructions outputs (hasheq) steps))

;; -> machine-rates, or #f
(define (expandable-machine-rates f!) (and (expandable? f!) (expandable-machine f!)))

;; About so many steps of a pendulum take as much less time by machine code as it takes to write.
(define steps-that-pay 500)

(define (machine-rates-pay? m) (>= (machine-rates-steps m) steps-that-pay))
(define (step-taken! m) (set-machine-rates-steps! m (+ 1 (machine-rates-steps m))))

;; (make) : -> a method's code for the rates, or #f; made once
(define (rates-code m method make)
  (define made (hash-ref (machine-rates-made m) method 'not-yet))
  (cond [(eq? made 'not-yet)
         (define code (make))
         (set-machine-rates-made! m (hash-set (machine-rates-made m) method code))
         code]
        [else made]))

;; The former work, if it is idle and (fits? work); else a new one by (make).
(define (take-work! f! fits? make)
  (define work (and (expandable-idle? f!) (expandable-work f!)))
  (set-expandable-idle?! f! #f)
  (cond [(and work (fits? work)) work]
        [else
         (define new (make))
         (set-expandable-work! f! new)
         new]))

;; The integration is over, and no interpolant of its steps will be asked any more.
(define (rest! f!) (set-expandable-idle?! f! #t))
