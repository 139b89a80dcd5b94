#lang racket/base
;; The Taylor method: y(t + h) = Σ y_k h^k (À. Jorba and M. Zou, Experimental Mathematics 14,
;; 2005; F. Biscani and D. Izzo, Monthly Notices of the RAS 504, 2021).
;;
;; The step is known from the last coefficients before it is taken (taylor-run.rkt),
;; and is taken once.  Where it grows much, as the first one does from
;; nothing, it is asked whether y' = f(y) holds in some places of it: terms beyond the order may
;; be the first that are not 0.  It is asked of each step where f has branches: the series of
;; |x| = √x², which is x, knows nothing of the branch beyond 0.
;;
;; The state is kept with the digits that rounding loses of it at each step, so that the error of
;; a long run grows as the root of the number of steps.  The motion within a step is the affair
;; of taylor-piece.rkt.

(require racket/flonum
         racket/unsafe/ops
         "right-hand-side.rkt" "stepper.rkt" "taylor-piece.rkt" "taylor-run.rkt"
         "../record-fields.rkt" "../flvector.rkt" "../unboxed-loop.rkt"
         "../Taylor/coefficient-sums.rkt" "../Taylor/expansion.rkt")

(provide taylor outlook-from (struct-out outlook))

;; tolerated : a tenth of the tolerance (integrate.rkt)
(define (start f! y0 tolerated)
  (define r (run-from-start f! y0 tolerated))
  (define-fields run r y slope)
  (make-stepper y
                (lambda () (f! y slope) slope)
                (lambda (h) (try! r h))
                (lambda () (accept! r))
                (lambda () (make-piece r))
                #:limit (lambda () (limit-of r))
                #:moved! (lambda () (forget! r))))

;; The run that f! kept from its last integration, if that is over and had the same tolerance, or
;; a new run; it begins at y0.
(define (run-from-start f! y0 tolerated)
  (define tolerance (term-tolerance tolerated))
  (define r (take-work! f! (lambda (r) (fl= tolerance (run-tolerance r)))
                        (lambda () (make-run f! (flvector-length y0) tolerance))))
  (begin-at! r y0)
  r)

(define taylor (adaptive-method 'Taylor #f start #:asks 'expansion))

;; First look at a motion where it begins.  step : the length of the first step, or
;; not a positive number; work : that of one (numeric/Taylor/expansion.rkt); functions : how many
;; of these the rates have; eighth : ‖y_8‖, or ‖y_9‖^(8/9) if that is more: of a motion that begins
;; at rest every other term may be nothing
(struct outlook (step work functions eighth) #:authentic)

;; An integration from y0 by f! begins with the results.
(define (outlook-from f! y0 tolerated)
  (define r (run-from-start f! y0 tolerated))
  (define-fields run r e order)
  (define step (limit-of r))
  (define (rate k) (fl/ (flexpt (coefficient-size e k) (fl/ 1.0 (->fl k))) (run-unit r)))
  (rest! f!)
  (define work (expander-work (expandable-expand f!)))
  (outlook step (work-of-order work order) (work-functions work)
           (flexpt (flmax (rate (min 8 order)) (rate (min 9 order))) 8.0)))

;; ---------------------------------------------------------------------------
;; Steps

;; -> the error, as far as it is looked at
(define (try! r h)
  (define-fields run r e y lost z rest unit last branches?)
  (limit-of r)
  (set-run-tried! r h)
  (motion-end! e (fl/ h unit) y lost z rest)
  (cond [(not (flvector-finite? z)) +nan.0]
        [(fl> (flabs h) (fl* growth last)) (fl* 0.01 (greatest-defect r h))]
        [branches?
         (define d (defect-at r h (fl/ h unit) z))
         (if (fl<= d no-branch) 0.0 (fl* 0.01 d))]
        [else 0.0]))

;; A step that is longer than the last by more is looked at.
(define growth 4.0)

;; In these parts of it: a periodic term may be the same at its end as it was at its beginning.
(define places '(0.236 0.618 1.0))

;; A defect of no more may be rounding's.
(define no-branch 1e-11)

;; +nan.0 is worse than any.
(define-syntax-rule (worse x y)
  (if (or (unsafe-fl<= y x) (not (unsafe-fl= x x))) x y))

(define (greatest-defect r h)
  (define-fields run r e unit within)
  (for/fold ([greatest 0.0]) ([theta (in-list places)])
    (define u (fl* theta (fl/ h unit)))
    (value-at! e u within)
    (define d (defect-at r h u within))
    (worse greatest d)))

;; By how much y' and f(y) differ at the time u, in units, when the state is y, times the length of
;; the step.
(define (defect-at r h u y)
  (define-fields run r f! n e slope rate)
  (f! y slope)
  (rates-at! e u rate)
  (let loop ([i 0] [greatest 0.0])
    (if (unsafe-fx= i n)
        (unboxed greatest)
        (let* ([change (unsafe-fl* h (at rate i))]
               [by-f (unsafe-fl* h (at slope i))]
               [scale (unsafe-fl+ 1.0 (unsafe-flmax (unsafe-flabs (at y i)) (unsafe-flabs change)))]
               [d (unsafe-fl/ (unsafe-flabs (unsafe-fl- change by-f)) scale)])
          (loop (unsafe-fx+ i 1) (worse greatest d))))))

(define (accept! r)
  (define-fields run r y lost z rest from tried)
  (flvector-copy! from y)
  (flvector-copy! y z)
  (flvector-copy! lost rest)
  (set-run-last! r (flabs tried))
  (set-run-limit! r #f))
