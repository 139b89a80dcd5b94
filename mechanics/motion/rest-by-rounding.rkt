#lang racket/base
;; A note on motions that begin at rest except for rounding, as a pendulum at π, which is no flonum:
;; they leave an unstable equilibrium at a time and in a direction that rounding decides.

(require racket/flonum
         "../error/note.rkt")

(provide note-left-rest)

;; y, end : the states at the start and at the end; clock? : is the first number the time?
(define (note-left-rest who f! y end clock?)
  (define from (if clock? 1 0))
  (when (and (left? y end from) (rest-by-rounding? f! y from))
    (note-once
     (string-append (symbol->string who)
                    ": the motion begins at rest but for rounding, which decides when it leaves\n"
                    "and where to; to see how an equilibrium is left, begin beside it"))))

(define (left? y end from)
  (for/or ([a (in-flvector y from)] [b (in-flvector end from)])
    (fl> (flabs (fl- b a)) (fl* noticeable (fl+ 1.0 (flabs a))))))

;; Are the rates as small as rounding, but not all 0?  From exact rest the motion would not leave.
(define (rest-by-rounding? f! y from)
  (define slope (make-flvector (flvector-length y)))
  (f! y slope)
  (and (for/and ([v (in-flvector slope from)] [x (in-flvector y from)])
         (fl<= (flabs v) (fl* rounding-of-rates (fl+ 1.0 (flabs x)))))
       (for/or ([v (in-flvector slope from)]) (not (fl= v 0.0)))))

(define noticeable 1e-6)
(define rounding-of-rates 1e-14)
