#lang racket/base
;; Any operation on sequences of Taylor coefficients: by its recurrence if it has
;; one, by the rule for its derivative otherwise (generic/operation-rule/recurrence.rkt derives
;; both).
;;
;; The rule is generic code and wants values of the arithmetic; `wrap` makes one of
;; a sequence, which the operations take apart again by way of `unwrap`.  The rule
;; may use the value of the operation itself: the sequence is handed to it before
;; it is known, and it looks only at the known part.

(require "coefficients.rkt"
         "../../error/computed-once.rkt"
         "../../generic/arithmetic.rkt" "../../generic/kind.rkt"
         "../../generic/operation-rule/recurrence.rkt")

(provide operate-1 operate-2 reduced)

;; One argument

;; op : record; a : coefficients; wrap : coefficients -> value;
;; unwrap : value -> coefficients
(define (operate-1 op a wrap unwrap)
  (define rules (recurrence-of op))
  (define solved
    (and rules ((recurrence-choose rules) (coefficient a 0) (coefficients-length a))))
  (cond [(<= (coefficients-length a) 1)
         (coefficients-from (list ((generic-op-procedure op) (coefficient a 0))))]
        [solved (by-step op a solved)]
        [else (by-rule op (list a) wrap unwrap)]))

;; The first two coefficients are the value and the slope there, by the rule for
;; the derivative, which complains where there is none.
(define (by-step op a solved)
  (define a0 (coefficient a 0))
  (define start ((generic-op-procedure op) a0))
  (define step (solution-step solved))
  (define r
    (make-coefficients
     (lambda (k)
       (case k
         [(0) start]
         [(1) (g:* ((car (generic-op-partials op)) a0 start) (coefficient a 1))]
         [else (step k all)]))))
  (define p (partner-of (solution-partner solved) a0 start (lambda (k step) (step k all))))
  (define all
    (rows (reader a) (coefficients-length a) #f 0 (reader r) (and p (reader p))))
  r)

;; The coefficients of the operation's partner, or #f.
(define (partner-of other a0 r0 take)
  (and other
       (let ([start ((partner-start other) a0 r0)])
         (make-coefficients (lambda (k) (if (eqv? k 0) start (take k (partner-step other))))))))

;; ---------------------------------------------------------------------------
;; Two arguments, a constant being a sequence of one

;; The value of op by other operations on the values a and b, or #f.
(define (reduced op a b)
  (define rules (recurrence-of op))
  (define reduce (and rules (recurrence-reduce rules)))
  (and reduce (reduce a b)))

(define (operate-2 op a b wrap unwrap)
  (define rules (recurrence-of op))
  (define la (coefficients-length a))
  (define lb (coefficients-length b))
  (define solved
    (and rules ((recurrence-choose rules) (coefficient a 0) la (coefficient b 0) lb)))
  (if solved
      (by-steps op a la b lb (solution-step solved) ((recurrence-length rules) la lb))
      (by-rule op (list a b) wrap unwrap)))

(define (by-steps op a la b lb step length)
  (define start ((generic-op-procedure op) (coefficient a 0) (coefficient b 0)))
  (define r
    (make-coefficients (lambda (k) (if (eqv? k 0) start (step k all))) (max length 0)))
  (define all (rows (reader a) la (reader b) lb (reader r) #f))
  r)

;; ---------------------------------------------------------------------------
;; By the rule for the derivative: k r_k = Σᵢ Σ_j j aᵢ_j gᵢ_{k-j}, where gᵢ is the
;; partial derivative by argument i, at the arguments and the value.

(define (by-rule op as wrap unwrap)
  (define point (for/list ([a (in-list as)]) (coefficient a 0)))
  (define start (apply (generic-op-procedure op) point))
  (define numbers (map comparand (append point (list start))))
  (define r
    (make-coefficients
     (lambda (k)
       (if (eqv? k 0)
           start
           (g:/ (for/fold ([sum 0]) ([a (in-list as)] [g (in-list gs)])
                  (if (<= (coefficients-length a) 1)
                      sum
                      (g:+ sum (integrand a (reader (g)) k))))
                k)))))
  (define values (append (map wrap as) (list (wrap r))))
  (define gs
    (for/list ([partial (in-list (generic-op-partials op))])
      (once (lambda ()
              ;; of numbers the rule complains where there is no derivative; sequences
              ;; would go on with infinity
              (when (andmap number? numbers) (apply partial numbers))
              (unwrap (apply partial values))))))
  r)

(define (integrand a g k)
  (weighted-convolution (reader a) (coefficients-length a) g k))
