#lang racket/base
;; The motion within a step of the Taylor method.
;;
;; Within a step the polynomial itself is the motion; of a step only the state where it begins
;; is kept, and its coefficients are computed again when it is looked at later.

(require racket/flonum
         "right-hand-side.rkt" "taylor-run.rkt"
         "../Taylor/coefficient-sums.rkt" "../Taylor/expansion.rkt")

(provide make-piece taylor-piece? taylor-piece-span call-with-coefficients)

;; from : the state where it begins; unit : of its coefficients; length : with its sign
(struct taylor-piece (run from unit length)
  #:authentic
  #:property prop:procedure
  (lambda (p theta out)
    (define u (fl* theta (taylor-piece-span p)))
    (call-with-coefficients p (lambda (e) (value-at! e u out)))
    (void)))

;; Its length in the unit.
(define (taylor-piece-span p) (fl/ (taylor-piece-length p) (taylor-piece-unit p)))

;; Of the step accepted last.
(define (make-piece r)
  (define p (taylor-piece r (flvector-copy (run-from r)) (run-unit r) (run-tried r)))
  (set-run-piece! r p)
  p)

;; (f e), where e holds the coefficients of the step, in its unit, while f runs.
(define (call-with-coefficients p f)
  (define r (taylor-piece-run p))
  (if (eq? p (run-piece r))
      (f (run-e r))
      (call-with-semaphore (run-lock r) read-piece #f r p f)))

(define (read-piece r p f)
  (define e
    (or (run-reader r)
        (let ([e ((expandable-expand (run-f! r)) (run-order r))])
          (set-run-reader! r e)
          e)))
  (unless (eq? p (run-read r))
    (set-run-read! r #f)
    (expand! e (taylor-piece-from p) (taylor-piece-unit p))
    (set-run-read! r p))
  (f e))
