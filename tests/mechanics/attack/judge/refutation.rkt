#lang racket/base
;; Is a refutation right?  Both sides must have values at its witness, which differ, and what
;; is declared must hold there.

(require "evaluate.rkt" "fault.rkt" "fixed.rkt" "flonum.rkt" "interval.rkt" "point.rkt"
         "relation.rkt" "witness.rkt")

(provide judge-refutation)

;; witness : ((S-expression . number) ...)
(define (judge-refutation left right given hints witness)
  (define symbols (apply symbols-of left right (relation-sides given)))
  (define named (witness-numbers witness))
  (if (broken? given (make-point named 0) flonum-intervals)
      (fault 'witness-outside-given named #f #f)
      (judge-completions left right given hints witness named
                         (remq* (hash-keys named) symbols))))

;; Symbols that the witness does not name may be anything that is in the question: the
;; refutation is right if it is so for one choice.
(define (judge-completions left right given hints witness named unnamed)
  (define constants (apply constants-of left right (relation-sides given)))
  (let loop ([k 0] [so-far 'unjudged] [judged 0])
    (define numbers
      (for/fold ([all named])
                ([(s x) (in-hash (completed (if (< k (length hints)) (list-ref hints k) (hash))
                                            unnamed (* 2 k) constants))]
                 #:unless (hash-has-key? named s))
        (hash-set all s x)))
    (define held? (all-hold? given (make-point numbers 0) flonum-intervals))
    (define found (and held? (judge-witness left right given numbers witness)))
    (cond [(and held? (not found)) #f]
          [(or (= k 300) (= judged 10) (null? unnamed)) (if held? found so-far)]
          [held? (loop (+ k 1) found (+ judged 1))]
          [else (loop (+ k 1) so-far judged)])))

;; Ever more digits; in the end what is zero to thousands of bits is zero.
(define witness-arithmetics
  (list (fixed-intervals 96) (fixed-intervals 224) (fixed-intervals 900)
        (fixed-intervals 2000 #:snap? #t)))

(define (judge-witness left right given numbers witness)
  (let loop ([As witness-arithmetics])
    (define A (car As))
    (define last? (null? (cdr As)))
    (define where (witness-point numbers witness exact-decimal))
    (define-values (u v) (values (value-at left where A) (value-at right where A)))
    (define (wrong kind) (fault kind numbers (shown u A) (shown v A)))
    (cond [(or (no-value? u) (no-value? v)) (wrong 'no-value-at-witness)]
          [(and (value? u) (value? v) (differ? u v A))
           (and (broken? given where A) (wrong 'witness-outside-given))]
          [(and (real? u) (real? v)) (wrong 'no-difference-at-witness)]
          [(not last?) (loop (cdr As))]
          [(or (two-values? u) (two-values? v)) (wrong 'function-of-two-values)]
          [(and (value? u) (value? v)) (wrong 'no-difference-at-witness)]
          [else 'unjudged])))

(define (shown v A) (and (value? v) (value->exact v A)))
