#lang racket/base
;; Least squares: the x for which the sum of the squares of N functions of n variables is least,
;; by the method of Levenberg and Marquardt (J. J. Moré, The Levenberg–Marquardt algorithm:
;; implementation and theory, 1978).
;;
;; With r the residuals at x and J their derivatives, a step p makes |r + Jp|² + μ|Dp|² least: for
;; small μ Gauss and Newton's, which is fast near the minimum, for great μ a short one downhill.
;; D has the lengths of the columns of J, so that units of the variables make no difference.  The
;; eigenvalues λ and eigenvectors v of D⁻¹JᵀJD⁻¹ give the step for every μ,
;;
;;     Dp = −Σ v (v·D⁻¹Jᵀr)/(λ + μ),
;;
;; and at the end the certainty of x: directions where λ is 0 within rounding are not determined.
;; μ goes up and down as H. B. Nielsen has it (Damping Parameter in Marquardt's Method, 1999).

(require racket/flonum
         "../flvector.rkt" "../linear-algebra/symmetric-eigenvalues.rkt"
         "../../error/failure.rkt")

(provide least-squares (struct-out linear-model)
         undetermined-directions inverse-normal-matrix)

;; residuals : at the point; scales : lengths of the columns, 1 for that of zeros
;; gradient : D⁻¹Jᵀr; values, vectors : λ, an flvector, and v, a list
(struct linear-model (point residuals scales gradient values vectors) #:authentic)

;; evaluate : x -> residuals, an flvector, and the columns of J, a list; or #f twice where they
;; have no value, but not at the start
;; observe : called with each point reached and the sum of squares there
;; -> linear-model at the minimum
(define (least-squares who evaluate start #:tolerance [tolerance 1e-10] #:limit [limit 200]
                       #:argument [argument flvector->list] #:observe [observe void])
  (let loop ([here (model-at evaluate start)] [mu 1e-3] [growth 2.0] [count 0])
    (define p (scaled-step here mu))
    (define gain (promised here p mu))
    (define cost (cost-of here))
    (define x (stepped here p))
    (cond
      ;; nothing is left to gain, or rounding takes the step away
      [(or (fl= cost 0.0) (fl<= gain (fl* tolerance (fl* tolerance cost)))
           (equal? x (linear-model-point here)))
       here]
      [(or (= count limit) (fl> mu 1e12))
       (raise-not-convergent who "no least sum of squares found"
                             (argument (linear-model-point here)) (norm p)
                             "sum of squares" cost "steps" count)]
      [else
       (define next (model-at evaluate x))
       (define share (if next (fl/ (fl- cost (cost-of next)) gain) -1.0))
       (cond
         [(fl> share 1e-4)
          (observe (linear-model-point next) (cost-of next))
          (define less (flmax #i1/3 (fl- 1.0 (flexpt (fl- (fl* 2.0 share) 1.0) 3.0))))
          (if (arrived? cost next share gain tolerance)
              next
              (loop next (fl* mu less) 2.0 (+ count 1)))]
         [(fl<= gain (fl* tolerance cost)) here]
         [else (loop here (fl* mu growth) (fl* 2.0 growth) (+ count 1))])])))

;; Did a step gain as little as the model promised, and was that next to nothing?
(define (arrived? cost next share gain tolerance)
  (and (fl<= (flmax gain (fl- cost (cost-of next))) (fl* tolerance cost)) (fl<= share 2.0)))

(define (cost-of m) (let ([r (linear-model-residuals m)]) (dot r r)))

;; -> linear-model, or #f
(define (model-at evaluate x)
  (define-values (r columns) (evaluate x))
  (and r
       (let* ([scales (for/list ([c (in-list columns)])
                        (let ([size (norm c)]) (if (fl> size 0.0) size 1.0)))]
              [units (for/list ([c (in-list columns)] [d (in-list scales)])
                       (flvector-scaled (fl/ 1.0 d) c))]
              [n (length units)]
              [normal (for*/flvector #:length (* n n) ([u (in-list units)] [v (in-list units)])
                        (dot u v))])
         (define-values (values vectors) (symmetric-eigenvalues normal n))
         (linear-model x r (apply flvector scales)
                       (for/flvector #:length n ([u (in-list units)]) (dot u r))
                       values vectors))))

;; Dp
(define (scaled-step m mu)
  (define g (linear-model-gradient m))
  (for/fold ([p (make-flvector (flvector-length g))])
            ([v (in-list (linear-model-vectors m))] [l (in-flvector (linear-model-values m))])
    (along p (fl- 0.0 (fl/ (dot v g) (fl+ (flmax l 0.0) mu))) v)))

;; Loss of the sum of squares if the functions are linear: |r|² − |r + Jp|² = μ|Dp|² − g·Dp
(define (promised m p mu)
  (fl- (fl* mu (dot p p)) (dot (linear-model-gradient m) p)))

(define (stepped m p)
  (for/flvector #:length (flvector-length p)
                ([x (in-flvector (linear-model-point m))] [u (in-flvector p)]
                 [d (in-flvector (linear-model-scales m))])
    (fl+ x (fl/ u d))))

;; ---------------------------------------------------------------------------
;; Certainty of the point

;; Below it an eigenvalue is 0 within rounding and the errors of derivatives.
(define least-eigenvalue 1e-12)

;; -> list of flvectors
(define (undetermined-directions m)
  (for/list ([v (in-list (linear-model-vectors m))] [l (in-flvector (linear-model-values m))]
             #:when (fl< l least-eigenvalue))
    v))

;; The entries of (JᵀJ)⁻¹, rows as lists
(define (inverse-normal-matrix m)
  (define d (linear-model-scales m))
  (for/list ([i (in-range (flvector-length d))])
    (for/list ([j (in-range (flvector-length d))])
      (define sum
        (for/fold ([sum 0.0]) ([v (in-list (linear-model-vectors m))]
                               [l (in-flvector (linear-model-values m))])
          (fl+ sum (fl/ (fl* (flvector-ref v i) (flvector-ref v j)) l))))
      (fl/ sum (fl* (flvector-ref d i) (flvector-ref d j))))))
