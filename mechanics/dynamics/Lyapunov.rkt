#lang racket/base
;; How fast neighbouring motions part: Lyapunov exponents (SICM 3.6.4, p. 263; Benettin, Galgani,
;; Giorgilli and Strelcyn 1980).
;;
;; A displacement v of a motion grows on the average like exp(λt).  It is followed by the
;; variational equations, brought back to length 1 from time to time, and the logarithms of its
;; lengths add up to λt.  Of several displacements the second is freed of its part along the first,
;; and so on, before its length is taken; so it grows by the second exponent.
;;
;; A finite time tells the exponents to about log(t)/t only where the motion is regular, where all
;; are 0, and to the fluctuations of its surroundings where it is chaotic.

(require racket/flonum
         (only-in racket/math exact-round)
         "map/compiled-map.rkt" "map/jacobian.rkt" "map/map-of-the-plane.rkt" "map/period-check.rkt"
         "map/plane-points.rkt"
         "../error/complain.rkt"
         "../generic/define-plain.rkt" "../generic/describe.rkt" "../generic/function.rkt"
         "../generic/kind.rkt" "../generic/up-down.rkt" "../generic/value-struct.rkt"
         "../generic/wrong-argument.rkt"
         "../motion/system/check.rkt" "../motion/evolution.rkt" "../motion/observed-systems.rkt"
         "../motion/linearized-flow.rkt"
         "../numeric/flvector.rkt"
         "../value/shape.rkt" (only-in "../value/structure.rkt" structure->list))

(provide Lyapunov-exponents maximal-Lyapunov-exponent Lyapunov?)

;; values : the largest first; history : list of (cons time values)
(value-struct Lyapunov (values history)
  #:text Lyapunov->text)

(provide-parts Lyapunov? "what Lyapunov-exponents or maximal-Lyapunov-exponent gives"
  Lyapunov-values Lyapunov-history Lyapunov-change)

;; -> the greatest change of an exponent over the last half of the time
(define (Lyapunov-change g)
  (define history (Lyapunov-history g))
  (define later (list-tail history (quotient (length history) 2)))
  (for/fold ([most 0.0]) ([entry (in-list later)])
    (for/fold ([most most]) ([x (in-list (cdr entry))] [end (in-list (Lyapunov-values g))])
      (if (fl= x end) most (flmax most (flabs (fl- x end)))))))

(define (Lyapunov->text g)
  (define values (Lyapunov-values g))
  (define single? (null? (cdr values)))
  (define end (car (car (reverse (Lyapunov-history g)))))
  (format "Lyapunov exponent~a ~a after ~a\n  changed by ~a over the last half"
          (if single? "" "s")
          (if single? (car values) (value->text values))
          end (Lyapunov-change g)))

;; ---------------------------------------------------------------------------
;; Of motions

;; count : number of exponents, #f for all; interval : time between two orthogonalizations
(define-plain (Lyapunov-exponents derivative state duration
                                  #:count [count #f] #:interval [interval #f]
                                  #:tolerance [tolerance 1e-10])
  (check-order 'Lyapunov-exponents "the state derivative" "state" derivative state duration)
  (check-no-map 'Lyapunov-exponents derivative)
  (exponents-of-motion 'Lyapunov-exponents derivative state duration count interval tolerance))

;; The greatest exponent of a motion for a duration, or of a map of the plane for n steps.
(define-plain (maximal-Lyapunov-exponent system start duration
                                         #:interval [interval #f] #:tolerance [tolerance 1e-10])
  (define who 'maximal-Lyapunov-exponent)
  (check-order who "the state derivative or map" "start" system start duration)
  (if (map? system)
      (exponent-of-map who system start duration)
      (exponents-of-motion who system start duration 1 interval tolerance)))

(define (exponents-of-motion who f state duration count interval tolerance)
  (check-derivative who f state)
  (check-positive who "duration" duration)
  (check-tolerance who tolerance)
  (when interval (check-positive who "interval" interval))
  (define all (unit-displacements state (if (timed-state? f state) 1 0)))
  (unless (or (not count) (and (exact-positive-integer? count) (<= count (length all))))
    (complain-of-argument who (format "how many exponents, at most ~a" (length all)) count))
  (define n (or count (length all)))
  (define T (real->double-flonum (comparand duration)))
  (define steps (if interval (max 1 (exact-round (/ T (comparand interval)))) 1000))
  (define advance (state-advancer (lambda () (with-displacements f))))
  (define (step x vs)
    (define both (apply up x (map (shaped state) vs)))
    (define (later) (advance both (/ T steps) tolerance))
    (define end (structure->list (call-for-state who later)))
    (values (car end) (for/list ([v (in-list (cdr end))]) (row v))))
  (note-followed f '() state)
  (call-unwatched
   (lambda () (collect step state (map row (scattered all n)) (fl/ T (->fl steps)) steps))))

;; Complains of arguments in another order; first, second : names of the arguments expected there
(define (check-order who first second system start duration)
  (cond [(pointwise? system)
         (when (and (tuple? duration) (not (tuple? start)))
           (complain who "the ~a comes before how long it is followed\n  given second: ~a" second
                     (describe-with-value start)))]
        [(or (pointwise? start) (pointwise? duration))
         (complain who "~a comes first, then the ~a and how long\n  given first: ~a"
                   first second (describe-with-value system))]))

(define (check-no-map who f)
  (when (and (map? f) (not (accepts? f 1)))
    (complain who
              (string-append "expected a state derivative; this is a map of the plane: ~a\n"
                             "  of maps there is (maximal-Lyapunov-exponent map point steps)")
              (value->text f))))

(define (row v) (for/flvector ([x (in-list (scalars v))]) (real->double-flonum x)))
(define ((shaped state) v) (flvector->structure state v))

;; Displacements with a part in every direction, so that no exponent is missed; all units if n is
;; their number.
(define (scattered units n)
  (if (= n (length units))
      units
      (for/list ([k (in-range n)])
        (define parts (map scalars units))
        (define sum
          (for/list ([i (in-range (length (car parts)))])
            (for/sum ([p (in-list parts)] [j (in-naturals)])
              (* (list-ref p i) (+ 1.0 (cos (+ j (* 2.0 j k) k)))))))
        (scalars->structure (car units) (lambda (i) (list-ref sum i))))))

;; step : takes a state and displacements, returns both an interval later
(define (collect step state vs interval steps)
  (define-values (start _) (orthonormal vs))
  (let loop ([k 0] [x state] [vs start] [sums (map (lambda (v) 0.0) vs)] [history '()])
    (define t (fl* interval (->fl k)))
    (define now
      (if (> k 0) (cons (cons t (sort (map (lambda (s) (fl/ s t)) sums) >)) history) history))
    (cond [(= k steps)
           (Lyapunov (cdr (car now)) (reverse now))]
          [else
           (define-values (next moved) (step x vs))
           (define-values (turned lengths) (orthonormal moved))
           (define grown
             (for/list ([sum (in-list sums)] [l (in-list lengths)]) (fl+ sum (fllog l))))
           (loop (+ k 1) next turned grown now)])))

;; Gram and Schmidt -> the unit vectors, and the length of each displacement, freed of those before
;; it.  A displacement that has shrunk to nothing stays so, and its exponent is −∞.
(define (orthonormal vs)
  (for/fold ([units '()] [lengths '()] #:result (values (reverse units) (reverse lengths)))
            ([v (in-list vs)])
    (define free
      (for/fold ([v v]) ([u (in-list (reverse units))]) (along v (fl- 0.0 (dot u v)) u)))
    (define size (norm free))
    (define divisor (if (fl> size 0.0) size 1.0))
    (values (cons (flvector-map (lambda (x) (fl/ x divisor)) free) units)
            (cons size lengths))))

;; ---------------------------------------------------------------------------
;; Of maps

(define (exponent-of-map who map start n)
  (check-steps who n)
  (define p (start-point who start))
  (define run! (tangent-stepper who map p))
  (define interval (max 1 (quotient n 1000)))
  (define v (flvector 0.6 0.8))
  (define (step _ vs)
    (flvector-copy! v (car vs))
    (for ([_ (in-range interval)]) (run! p v))
    (values p (list (flvector-copy v))))
  (collect step p (list v) (->fl interval) (quotient n interval)))

;; -> a procedure that moves a point p and its displacement v
(define (tangent-stepper who map p)
  (define step! (orbit-stepper map p))
  (define derivatives! (jacobian-runner who map (flvector-ref p 0) (flvector-ref p 1)))
  (define J (make-flvector 4))
  (lambda (p v)
    (derivatives! p J)
    (define-values (x y) (values (flvector-ref v 0) (flvector-ref v 1)))
    (flvector-set! v 0 (fl+ (fl* (flvector-ref J 0) x) (fl* (flvector-ref J 2) y)))
    (flvector-set! v 1 (fl+ (fl* (flvector-ref J 1) x) (fl* (flvector-ref J 3) y)))
    (unless (step! p)
      (raise-no-image who map (flvector-ref p 0) (flvector-ref p 1)))))
