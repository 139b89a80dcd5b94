#lang racket/base
;; Integrals of slow powers and logarithms, up to an end or to infinity.
;;
;; With x = e^u, ∫ x^−1.01 dx = ∫ e^(−u/100) du and ∫ dx/(x log² x) = ∫ du/u²: flonums end at
;; u = 700, where much is still left.  The integrals over parts of u that are equally long
;; are a geometric sequence for the first, those over parts each longer by the same factor
;; for the second, and the epsilon algorithm finds the sum of either.  It would find one for
;; sums that have none; so the parts must be of one sign and fall, to the last; and the difference
;; of the last three estimates, tenfold, is the bound of the error.
;;
;; The same variable tells where there is no integral: f must fall faster than 1/x, and
;; faster than 1/(x log x) if it does so barely.

(require racket/flonum
         "epsilon-algorithm.rkt" "gauss-kronrod.rkt"
         "../finite-number.rkt"
         "../../error/failure.rkt" "../../error/refusal.rkt")

(provide in-logarithm last-logarithm tail-integral diverging?)

;; f as a function of u: the integrand of ∫ f(x) dx with x = end + side e^u, where end is a
;; number and e^u its distance, or of x = side e^u to infinity; direction : 1.0 where u goes
;; to infinity with x, −1.0 towards an end.  #f where f has no finite value.
(define ((in-logarithm f end side direction) u)
  (define d (flexp (fl* direction u)))
  (define y
    (if-raised no-value? #f
      (f (fl+ end (fl* side d)))))
  (define z (and (real? y) (fl* d (real->double-flonum y))))
  (and z (finite? z) z))

;; The greatest u: beyond it flonums end, or rounding hides the distance from an end that is not 0.
(define (last-logarithm end)
  (if (fl= end 0.0) 690.0 (fl- 22.0 (fllog (flabs end)))))

;; ---------------------------------------------------------------------------

;; The integral of g from `from` to infinity, and a bound of its error; #f twice if there is none,
;; or not to the tolerance relative to the whole integral, of which `size` is known.
(define (tail-integral g from to size tolerance)
  (define (good? value bound)
    (and value (<= bound (* tolerance (+ size (abs value))))))
  (define-values (value bound) (sum-of-parts g (equal-parts from to)))
  (define-values (value* bound*)
    (if (good? value bound) (values #f #f) (sum-of-parts g (growing-parts from to))))
  (cond [(good? value bound) (values value bound)]
        [(good? value* bound*) (values value* bound*)]
        [else (values #f #f)]))

(define (equal-parts from to)
  (define n 20)
  (for/list ([k (in-range (+ n 1))]) (+ from (* k (/ (- to from) n)))))

(define (growing-parts from to)
  (define factor 1.5)
  (let loop ([u from])
    (if (> u to) '() (cons u (loop (* u factor))))))

(define least-parts 7)
(define greatest-ratio 0.98)

(define (sum-of-parts g points)
  (let/ec return
    (define (fail) (return #f #f))
    (when (<= (length points) least-parts) (fail))
    (define parts
      (for/list ([u (in-list points)] [v (in-list (cdr points))]) (or (part g u v) (fail))))
    (unless (falling? parts) (fail))
    (estimate parts)))

(define (part g u v)
  (part-integral (lambda (u) (or (g u) +inf.0)) u v 0.0 100))

(define (falling? parts)
  (for/and ([p (in-list parts)] [q (in-list (cdr parts))])
    (or (= p q 0.0)
        (<= 0.0 (/ q p) greatest-ratio))))

;; The last limit of the diagonals of the sums, and a bound of its error from those before it.
(define (estimate parts)
  (define-values (sum diagonal limits)
    (for/fold ([sum 0.0] [diagonal '()] [limits '()]) ([p (in-list parts)])
      (define next (extend-diagonal diagonal (+ sum p)))
      (values (+ sum p) next (cons (estimated-limit next) limits))))
  (define limit (car limits))
  (define spread
    (for/fold ([most 0.0]) ([l (in-list (cdr limits))] [_ (in-range 2)])
      (max most (abs (- l limit)))))
  (define last-parts (list-tail parts (- (length parts) 2)))
  (define left (if (= (car last-parts) 0.0) 0.0 (- 1.0 (/ (cadr last-parts) (car last-parts)))))
  (define rounding (* 1e-15 (abs limit) (if (= left 0.0) 1.0 (/ 1.0 left))))
  (values limit (+ (* 10.0 spread) rounding)))

;; ---------------------------------------------------------------------------

;; Is it seen that g has no integral to infinity?  Its sign does not change, and it does not
;; fall, or as 1/u at most.  Where g ends earlier than u may, as x/(1 + x²) does when x²
;; overflows, it is looked at up to there.
(define (diverging? g to)
  (define end
    (for*/first ([k (in-range 3)]
                 [end (in-value (/ to (expt 2 k)))]
                 [y (in-value (g end))]
                 #:when (and y (not (= y 0.0))))
      end))
  (and end (level-or-reciprocal? g end)))

(define (level-or-reciprocal? g to)
  (define us (for/list ([k (in-range 8)]) (* to (expt 2.0 (* -0.5 k)))))
  (define ys (map g us))                ; the last first
  (define (all? sign) (andmap (lambda (y) (and y (< 0.0 (* sign y)))) ys))
  (and (or (all? 1.0) (all? -1.0))
       (or (level? g to)
           (and (> to 100.0) (falls-as-reciprocal? us (map abs ys))))))

(define (level? g to)
  (define-values (near far) (values (g (* 0.9 to)) (g to)))
  (and near (>= (abs far) (* (- 1.0 (if (> to 100.0) 1e-9 1e-6)) (abs near)))))

;; p = −d log g/d log u over each half octave is at most 1 and does not grow, as that of a
;; power of x would.
(define (falls-as-reciprocal? us ys)
  (define exponents
    (for/list ([u (in-list us)] [u* (in-list (cdr us))] [y (in-list ys)] [y* (in-list (cdr ys))]
               [_ (in-range 4)])
      (/ (log (/ y* y)) (log (/ u u*)))))
  (and (<= (car exponents) (+ 1.0 1e-6))
       (<= (car exponents) (* 1.05 (list-ref exponents 3)))))
