#lang racket/base
;; Right-hand sides of y' = f(y) with what computes Taylor coefficients of solutions.

(provide expandable expandable? expandable-expand
         take-work! rest!)

;; run    : y dy -> void
;; expand : order -> expansion (numeric/jet/expansion.rkt), for one thread at a time
;; work   : what a method made for its latest integration, or #f; idle? : may the next one use it?
(struct expandable (run expand [work #:auto #:mutable] [idle? #:auto #:mutable])
  #:authentic
  #:property prop:procedure 0)

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
