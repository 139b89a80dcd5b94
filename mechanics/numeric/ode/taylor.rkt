#lang racket/base
;; The Taylor method: y(t + h) = Σ y_k h^k (À. Jorba and M. Zou, Experimental Mathematics 14,
;; 2005; F. Biscani and D. Izzo, Monthly Notices of the RAS 504, 2021).
;;
;; The step follows from the last two coefficients: with ρ_k = ‖y_k‖^(−1/k), near the radius of
;; convergence, it is
;;
;;     h = q min(ρ_{n−1}, ρ_n),   where q^(n+1)/(1 − q) = ε/200,
;;
;; as all terms left out are then.  Theirs are twice as much: they take n = ⌈1 − ½ ln ε⌉ and q
;; near e⁻², so that the work for a unit of time is least if an expansion takes n² operations.
;; But it takes a + b n + c n², and the smaller the system, the more of that are a and b; so n is
;; the one for which (a + b n + c n²)/q is least.  ‖y_k‖ is the greatest component relative to
;; 1 + |y|; and the last terms must not grow.
;;
;; The step is known before it is taken, and is taken once.  Only where it grows much, as the
;; first one does from nothing, is it asked whether y' = f(y) holds at its end: terms beyond the
;; order may be the first that are not 0.
;;
;; The state is kept with what rounding loses of it at each step, so that the error of a long
;; run grows as the root of the number of steps.  Within a step the polynomial itself is the
;; motion; what is kept of a step is the state where it begins, and its coefficients are
;; computed again when it is looked at later.

(require racket/flonum
         racket/list
         racket/unsafe/ops
         "expandable.rkt" "stepper.rkt" "vectors.rkt"
         (only-in "../constants.rkt" rounding) "../fields.rkt" "../flvector.rkt"
         "../unboxed.rkt"
         "../jet/expansion.rkt")

(provide taylor outlook-from (struct-out outlook)
         taylor-piece? taylor-piece-span call-with-coefficients)

;; f!, n     : the right-hand side, of how many variables; e : its expansion
;; tolerance : of the error of a step; order : of the expansion; share : ln q
;; y, lost   : the present state, and what rounding has lost of it
;; z, rest   : those that the step tried last leads to; from : where the last one began;
;; slope     : room
;; unit      : of the time of the coefficients, a power of 2; limit : of the next step, or #f
;;             if the coefficients are not those of y
;; last      : length of the step accepted last, 0 before the first; tried : of that tried last
;; piece     : the step whose coefficients are in e, or #f
;; reader    : an expansion for reading pieces later, made then; read : the piece in it; lock :
;;             for one reader at a time
(struct run (f! n e tolerance order share y lost z rest from slope
             [unit #:mutable] [limit #:mutable] [last #:mutable] [tried #:mutable]
             [piece #:mutable] [reader #:mutable] [read #:mutable] lock)
  #:authentic)

(define (order-for tolerance w)
  (define least (max 4 (fl->exact-integer (ceiling (- 1.0 (* 0.5 (log tolerance)))))))
  (argmin (lambda (n) (/ (work-of-order w n) (exp (log-share n tolerance))))
          (range least (* 2 least))))

;; ln q, by repetition.
(define (log-share n tolerance)
  (for/fold ([l -2.0]) ([_ (in-range 8)])
    (/ (+ (log (* 0.005 tolerance)) (log (- 1.0 (exp l)))) (+ n 1.0))))

;; tolerated : a tenth of the tolerance (integrate.rkt)
(define (start f! y0 tolerated)
  (define r (run-from-start f! y0 tolerated))
  (define-fields run r y slope)
  (foreseeing-stepper y
                      (lambda () (f! y slope) slope)
                      (lambda (h) (try! r h))
                      (lambda () (accept! r))
                      (lambda () (make-piece r))
                      (lambda () (limit-of r))
                      (lambda () (forget! r))))

;; The one that f! has worked with before, if that will do, or a new one.
(define (run-from-start f! y0 tolerated)
  (define tolerance (term-tolerance tolerated))
  (define r (take-work! f! (lambda (r) (fl= tolerance (run-tolerance r)))
                        (lambda () (make-run f! (flvector-length y0) tolerance))))
  (begin-at! r y0)
  r)

;; Of the terms left out, which do not need a tenth; or if that is no more than rounding, they
;; are to be nothing beside rounding.
(define (term-tolerance tolerated)
  (if (fl<= tolerated rounding) least-term (fl* 10.0 tolerated)))

(define least-term 1e-17)

(define (make-run f! n tolerance)
  (define-vectors n y lost z rest from slope)
  (define expand (expandable-expand f!))
  (define order (order-for tolerance (expander-work expand)))
  (define e (expand order))
  (run f! n e tolerance order (log-share order tolerance) y lost z rest from slope
       #f #f 0.0 0.0 #f #f #f (make-semaphore 1)))

;; Nothing to do where it has just been tried (outlook-from).
(define (begin-at! r y0)
  (define-fields run r f! y slope)
  (unless (and (run-limit r) (fl= (run-last r) 0.0) (equal? y y0))
    (flvector-copy! y y0)
    (set-run-unit! r (first-unit f! y slope))
    (set-run-piece! r #f)
    (forget! r)))

(define taylor (adaptive-method 'Taylor #f start #:asks 'expansion))

;; What there is to be seen of a motion where it begins.  step : the length of the first step, or
;; not a positive number; work : what one takes (numeric/jet/expansion.rkt); eighth : ‖y_8‖
(struct outlook (step work eighth) #:authentic)

;; An integration from y0 by f! begins with what was computed.
(define (outlook-from f! y0 tolerated)
  (define r (run-from-start f! y0 tolerated))
  (define-fields run r n e y order)
  (define step (limit-of r))
  (define k (min 8 order))
  (rest! f!)
  (outlook step
           (work-of-order (expander-work (expandable-expand f!)) order)
           (fl/ (size e y n k) (flexpt (run-unit r) (->fl k)))))

;; ---------------------------------------------------------------------------
;; Coefficients, in a unit of time near the length of the step

(define (limit-of r)
  (or (run-limit r)
      (let ([limit (expand-in-fit-unit! r)])
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
;; sum of even and odd terms (numeric/jet/convolution.rkt) wants it.
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
  (define-fields run r n e y order share)
  (define a (size e y n order))
  (define b (size e y n (- order 1)))
  (cond [(and (fl< a +inf.0) (fl< b +inf.0))
         (flmin (flexp (fl- share
                            (flmax (fl/ (fllog a) (->fl order))
                                   (fl/ (fllog b) (->fl (- order 1))))))
                (flmax (falling (size e y n (- order 2)) a) (falling (size e y n (- order 3)) b)))]
        [else +nan.0]))

;; Terms as small as they may be tell nothing as long as they grow: half the distance at which
;; two of them, of orders that differ by 2, are equal.
(define (falling earlier later)
  (if (or (fl= later 0.0) (fl= earlier 0.0)) +inf.0 (fl* 0.5 (flsqrt (fl/ earlier later)))))

;; ‖y_k‖; not less than infinite if one is not a number
(define (size e y n k)
  (let loop ([i 0] [greatest 0.0])
    (if (unsafe-fx= i n)
        (unboxed greatest)
        (let ([x (unsafe-fl/ (unsafe-flabs (at (coefficient-row e i) k))
                             (unsafe-fl+ 1.0 (unsafe-flabs (unsafe-flvector-ref y i))))])
          (loop (unsafe-fx+ i 1)
                (if (unsafe-fl< x +inf.0) (unsafe-flmax greatest x) +inf.0))))))

;; ---------------------------------------------------------------------------
;; Steps

;; -> the error, as far as it is looked at
(define (try! r h)
  (define-fields run r e y lost z rest unit last)
  (limit-of r)
  (set-run-tried! r h)
  (advance-all! e (fl/ h unit) y lost z rest)
  (cond [(not (flvector-finite? z)) +nan.0]
        [(fl<= (flabs h) (fl* growth last)) 0.0]
        [else (fl* 0.01 (defect r h))]))

;; A step that is longer than the last by more is looked at.
(define growth 4.0)

;; z + rest = y + lost + Σ c_k u^k, k from 1, where rounding loses nothing that is not in `rest`
(define (advance-all! e u y lost z rest)
  (for-each-sum e u 1 (i c sum)
    (add-exactly! i (unsafe-fl+ (unsafe-fl* u sum) (at lost i)) y z rest)))

;; z + rest = y + d (Knuth)
(define-syntax-rule (add-exactly! i d-form y z rest)
  (let* ([d d-form]
         [x (at y i)]
         [sum (unsafe-fl+ x d)]
         [back (unsafe-fl- sum x)])
    (unsafe-flvector-set! z i sum)
    (unsafe-flvector-set! rest i
                          (unsafe-fl+ (unsafe-fl- x (unsafe-fl- sum back))
                                      (unsafe-fl- d back)))))

;; By how much y' and f(y) differ at the end of a step, times its length.
(define (defect r h)
  (define-fields run r f! n e y z slope order unit)
  (f! z slope)
  (define u (fl/ h unit))
  (for/fold ([greatest 0.0]) ([i (in-range n)])
    (define change (fl* u (derivative (coefficient-row e i) order u)))
    (define change-by-f (fl* h (flvector-ref slope i)))
    (define scale (fl+ 1.0 (flmax (flabs (flvector-ref z i)) (flabs change))))
    (flmax greatest (fl/ (flabs (fl- change change-by-f)) scale))))

(define (derivative row order u)
  (for/fold ([sum 0.0]) ([k (in-range order 0 -1)])
    (fl+ (fl* (->fl k) (at row k)) (fl* u sum))))

;; The state is another one, of which rounding has lost nothing yet.
(define (forget! r)
  (scale! (run-lost r) 0.0)
  (set-run-last! r 0.0)
  (set-run-limit! r #f))

(define (accept! r)
  (define-fields run r y lost z rest from tried)
  (flvector-copy! from y)
  (flvector-copy! y z)
  (flvector-copy! lost rest)
  (set-run-last! r (flabs tried))
  (set-run-limit! r #f))

;; ---------------------------------------------------------------------------
;; The motion within a step

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
