#lang racket/base
;; Right-hand sides of y' = f(y) with what methods make of them: Taylor coefficients of solutions,
;; and machine code of whole steps.

(provide expandable expandable? expandable-expand expandable-parameters rates-code
         machine-rates-inputs machine-rates-parameters machine-rates-instructions
         machine-rates-outputs
         (protect-out make-machine-rates)
         take-work! rest!)

;; run     : y dy -> void
;; expand  : order -> expansion (numeric/jet/expansion.rkt), for one thread at a time
;; machine : machine-rates, or #f; parameters : their values, an flvector
;; work    : what a method made for its latest integration, or #f; idle? : may the next one use it?
(struct expandable (run expand machine parameters [work #:auto #:mutable] [idle? #:auto #:mutable])
  #:authentic
  #:property prop:procedure 0)

;; Rates as straight code (numeric/machine/straight-code.rkt): of so many inputs, the components of y,
;; and as many parameters behind them; outputs : operands; made : what methods have made of it,
;; method -> code
(struct machine-rates (inputs parameters instructions outputs [made #:mutable]) #:authentic)

(define (make-machine-rates inputs parameters instructions outputs)
  (machine-rates inputs parameters instructions outputs (hasheq)))

;; (make rates) : -> what a method makes of the rates of f!, or #f; made once
;; -> that, or #f where they have no machine code
(define (rates-code f! method make)
  (define m (and (expandable? f!) (expandable-machine f!)))
  (and m
       (hash-ref (machine-rates-made m) method
                 (lambda ()
                   (define code (make m))
                   (set-machine-rates-made! m (hash-set (machine-rates-made m) method code))
                   code))))

;; What was made before, if it is idle and (fits? work); else what (make) makes.
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
