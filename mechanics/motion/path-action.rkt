#lang racket/base
;; The action of polynomial paths between two ends, and its gradient.
;;
;; A path of degree n + 1 is the straight line and n polynomials that vanish at both ends
;; (numeric/quadrature/end-polynomials.rkt), q(t) = line(t) + Σ cₖ φₖ(t).  Values at n
;; points between would do as well as the c's, but as unknowns they are worse and worse the
;; more there are: to the action of a free particle the c's contribute their squares, and to
;; others not much else.  The derivatives of the action S are
;;
;;     ∂S/∂cₖ = ∫ (∂₁L φₖ + ∂₂L φₖ') dt,
;;
;; so that L and its derivatives, compiled once as functions of a local tuple, are all
;; there is to evaluate, however large n is.  The integral is that of Gauss and Legendre's
;; rule on equal parts of the time: the gradient is exactly that of this sum.

(require racket/flonum
         "../compile/compile-function.rkt"
         "../lagrangian/Lagrange-equations.rkt"
         "../numeric/flvector.rkt"
         "../numeric/quadrature/end-polynomials.rkt" "../numeric/quadrature/gauss-rule.rkt")

(provide compile-Lagrangian path-action points-between)

;; From the scalars of (up t q v) to L there and its derivatives by t, q and v;
;; example : such a local tuple.  (input output -> void)
(define (compile-Lagrangian who L example)
  (compiled-function-runner
   (compile-function (scalar-valued who L) example #:name who #:gradient? #t)))

;; q0, q1 : the scalars of the ends, at the times t0 and t1; c : the coefficients, one
;; for each scalar with the first polynomial, one for each with the second …
;; -> c ↦ action and gradient, with that many nodes in that many parts
(define (path-action run t0 q0 t1 q1 n nodes parts)
  (define d (flvector-length q0))
  (define samples (time-samples n t0 t1 nodes parts))
  (define input (make-flvector (+ 1 (* 2 d))))
  (define output (make-flvector (+ 2 (* 2 d))))
  (lambda (c)
    (define gradient (make-flvector (* n d)))
    (define action
      (for/fold ([sum 0.0]) ([s (in-list samples)])
        (local-tuple! input s q0 q1 c n d)
        (run input output)
        (add-derivatives! gradient s output n d)
        (fl+ sum (fl* (sample-weight s) (flvector-ref output 0)))))
    (values action gradient)))

;; A node: time, weight, how far it is along the line, the polynomials there; rates are by
;; time.
(struct sample (time weight along rate basis rates) #:authentic)

(define (sample-at n u weight t0 t1)
  (define half (fl* 0.5 (fl- t1 t0)))
  (define-values (basis slopes) (end-polynomials n u))
  (sample (fl+ (fl* 0.5 (fl+ t0 t1)) (fl* half u)) (fl* half weight)
          (fl* 0.5 (fl+ 1.0 u)) (fl/ 0.5 half)
          basis (flvector-map (lambda (s) (fl/ s half)) slopes)))

(define (time-samples n t0 t1 nodes parts)
  (define-values (us ws) (gauss-legendre-rule nodes))
  (define width (fl/ 1.0 (->fl parts)))
  (for*/list ([part (in-range parts)]
              [middle (in-value (fl- (fl* width (->fl (+ 1 (* 2 part)))) 1.0))]
              [k (in-range nodes)])
    (sample-at n (fl+ middle (fl* width (flvector-ref us k))) (fl* width (flvector-ref ws k))
               t0 t1)))

(define (local-tuple! input s q0 q1 c n d)
  (flvector-set! input 0 (sample-time s))
  (for ([k (in-range d)])
    (define start (flvector-ref q0 k))
    (define way (fl- (flvector-ref q1 k) start))
    (define-values (q v)
      (for/fold ([q (fl+ start (fl* (sample-along s) way))] [v (fl* (sample-rate s) way)])
                ([b (in-flvector (sample-basis s))] [rate (in-flvector (sample-rates s))]
                 [i (in-range n)])
        (define x (flvector-ref c (+ k (* d i))))
        (values (fl+ q (fl* b x)) (fl+ v (fl* rate x)))))
    (flvector-set! input (+ 1 k) q)
    (flvector-set! input (+ 1 d k) v)))

(define (add-derivatives! gradient s output n d)
  (for* ([i (in-range n)] [k (in-range d)])
    (define place (+ k (* d i)))
    (flvector-set! gradient place
                   (fl+ (flvector-ref gradient place)
                        (fl* (sample-weight s)
                             (fl+ (fl* (flvector-ref (sample-basis s) i)
                                       (flvector-ref output (+ 2 k)))
                                  (fl* (flvector-ref (sample-rates s) i)
                                       (flvector-ref output (+ 2 d k)))))))))

;; The scalars of the path with these coefficients at n times evenly spaced between.
(define (points-between q0 q1 n c)
  (define d (flvector-length q0))
  (define input (make-flvector (+ 1 (* 2 d))))
  (define points (make-flvector (* n d)))
  (for ([i (in-range n)])
    (define u (fl- (fl/ (->fl (* 2 (+ i 1))) (->fl (+ n 1))) 1.0))
    (local-tuple! input (sample-at n u 1.0 -1.0 1.0) q0 q1 c n d)
    (for ([k (in-range d)]) (flvector-set! points (+ k (* d i)) (flvector-ref input (+ 1 k)))))
  points)
