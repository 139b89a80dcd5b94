#lang racket/base
;; The state of one integration by the Taylor method, and the coefficients where it is.
;;
;; They are of a time whose unit is near the length of the step, so that none is too large or
;; too small for a flonum.  The step that they allow follows from the last two of them,
;; ‖y_k‖ being the greatest component relative to 1 + |y|; and the last terms must not grow.

(require racket/flonum
         (only-in racket/list argmin range)
         "right-hand-side.rkt" "vector-formulas.rkt"
         (only-in "../constants.rkt" rounding) "../record-fields.rkt" "../flvector.rkt"
         "../unboxed-loop.rkt"
         "../Taylor/coefficient-sums.rkt" "../Taylor/expansion.rkt")

(provide (struct-out run) make-run begin-at! forget! limit-of term-tolerance)

;; f!, n     : the right-hand side, of how many variables; e : its expansion
;; tolerance : of the error of a step; order : of the expansion; share : ln q
;; branches? : may f take another branch within a step (numeric/Taylor/expansion.rkt)?
;; y, lost   : the present state, and the digits that rounding has lost of it
;; z, rest   : those that the step tried last leads to; from : where the last one began;
;; slope, rate, within : room
;; unit      : of the time of the coefficients, a power of 2; limit : of the next step, or #f
;;             if the coefficients are not those of y
;; last      : length of the step accepted last, 0 before the first; tried : of that tried last
;; piece     : the step whose coefficients are in e, or #f
;; reader    : an expansion for reading pieces later, made then; read : the piece in it; lock :
;;             for one reader at a time
(struct run (f! n e tolerance order share branches? y lost z rest from slope rate within
             [unit #:mutable] [limit #:mutable] [last #:mutable] [tried #:mutable]
             [piece #:mutable] [reader #:mutable] [read #:mutable] lock)
  #:authentic)

(define (make-run f! n tolerance)
  (define-vectors n y lost z rest from slope rate within)
  (define expand (expandable-expand f!))
  (define order (order-for tolerance (expander-work expand)))
  (define e (expand order))
  (run f! n e tolerance order (log-share order tolerance) (expander-branches? expand)
       y lost z rest from slope rate within
       #f #f 0.0 0.0 #f #f #f (make-semaphore 1)))

;; Begins at y0, unless outlook-from has just done so.
(define (begin-at! r y0)
  (define-fields run r f! y slope)
  (unless (and (run-limit r) (fl= (run-last r) 0.0) (equal? y y0))
    (flvector-copy! y y0)
    (set-run-unit! r (first-unit f! y slope))
    (set-run-piece! r #f)
    (forget! r)))

;; To be called when the state was changed: rounding has lost nothing of the new one yet.
(define (forget! r)
  (scale! (run-lost r) 0.0)
  (set-run-last! r 0.0)
  (set-run-limit! r #f))

;; ---------------------------------------------------------------------------
;; The order of the expansions
;;
;; With ρ_k = ‖y_k‖^(−1/k), near the radius of convergence, the step is
;;
;;     h = q min(ρ_{n−1}, ρ_n),   where q^(n+1)/(1 − q) = ε/200,
;;
;; as all terms left out are then.  Jorba and Zou's are twice as much: they take
;; n = ⌈1 − ½ ln ε⌉ and q near e⁻², so that the work for a unit of time is least if an expansion
;; takes n² operations.  But it takes a + b n + c n², and the smaller the system, the more of
;; that are a and b; so n is the one for which (a + b n + c n²)/q is least.

;; w : the work of an expansion (numeric/Taylor/expansion.rkt)
(define (order-for tolerance w)
  (define least (max 4 (fl->exact-integer (ceiling (- 1.0 (* 0.5 (log tolerance)))))))
  (argmin (lambda (n) (/ (work-of-order w n) (exp (log-share n tolerance))))
          (range least (* 2 least))))

;; ln q, by repetition.
(define (log-share n tolerance)
  (for/fold ([l -2.0]) ([_ (in-range 8)])
    (/ (+ (log (* 0.005 tolerance)) (log (- 1.0 (exp l)))) (+ n 1.0))))

;; The tolerance of the terms left out.  They do not need to be a tenth of the error tolerated of a
;; motion; but where only rounding is tolerated, they must be nothing beside it.
(define (term-tolerance tolerated)
  (if (fl<= tolerated rounding) least-term (fl* 10.0 tolerated)))

(define least-term 1e-17)

;; ---------------------------------------------------------------------------
;; The length of the next step

(define (limit-of r)
  (or (run-limit r)
      (let* ([usual (run-unit r)] [limit (expand-in-fit-unit! r)])
        (unless (fl> limit 0.0) (set-run-unit! r usual)) ; the unit tried fits nothing
        (set-run-limit! r limit)
        limit)))

;; -> the length of the next step
(define (expand-in-fit-unit! r)
  (define-fields run r e y order)
  (define usual (run-unit r))
  (set-run-piece! r #f)
  (let try ([count 0])
    (define unit (run-unit r))
    (expand! e y unit)
    (define length (length-in-units r))
    (define fitting
      (cond [(fl<= 0.0625 length 16.0) unit]
            [(fl= length +inf.0) (larger-unit usual count)]
            [(fl> length 0.0) (fl* unit (power-of-2 length))]
            [(slopes-finite? e) (fl* unit (expt 2.0 -40))]       ; too large to have been finite
            [else unit]))
    (cond [(or (fl= fitting unit) (= count 20) (not (fl< 1e-290 fitting 1e290)))
           (fl* unit (leading-bits length))]
          [else (set-run-unit! r fitting)
                (try (+ count 1))])))

;; Coefficients that are 0 may have been too small for flonums; or they are 0.
(define (larger-unit usual count)
  (if (< count 3) (fl* usual (flexpt 2.0 (fl* 60.0 (->fl (+ count 1))))) usual))

(define (slopes-finite? e)
  (for/and ([row (in-vector (expansion-states e))]) (fl< (flabs (at row 1)) +inf.0)))

;; The first half of the digits of x (Dekker): the square of a step of so many is exact, as the
;; sum of even and odd terms (numeric/Taylor/convolution.rkt) wants it.
(define (leading-bits x)
  (define c (fl* 134217729.0 x))
  (define high (fl- c (fl- c x)))
  (if (fl< high +inf.0) high x))

(define (power-of-2 x)
  (flexpt 2.0 (flround (fl/ (fllog (flmax 1e-290 (flmin 1e290 x))) (fllog 2.0)))))

;; The time in which y changes by a tenth of its size.
(define (first-unit f! y slope)
  (f! y slope)
  (define n (flvector-length y))
  (define rate (root-mean-square slope y y n))
  (if (fl< 0.0 rate +inf.0) (power-of-2 (fl/ 0.1 rate)) 1.0))

(define (length-in-units r)
  (define-fields run r e order share)
  (define-values (a b) (values (last-size e 0) (last-size e 1)))
  (cond [(and (fl< a +inf.0) (fl< b +inf.0))
         (flmin (flexp (fl- share
                            (flmax (fl/ (fllog a) (->fl order))
                                   (fl/ (fllog b) (->fl (- order 1))))))
                (flmax (falling (last-size e 2) a) (falling (last-size e 3) b)))]
        [else +nan.0]))

;; Terms as small as they may be tell nothing as long as they grow: half the distance at which
;; two of them, of orders that differ by 2, are equal.
(define (falling earlier later)
  (if (or (fl= later 0.0) (fl= earlier 0.0)) +inf.0 (fl* 0.5 (flsqrt (fl/ earlier later)))))
