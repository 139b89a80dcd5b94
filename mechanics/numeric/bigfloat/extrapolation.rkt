#lang racket/base
;; Integration of y' = f(y) in numbers of any precision: extrapolation of any order
;; (Hairer, Nørsett and Wanner, Solving Ordinary Differential Equations I, II.9).
;;
;; Row j of the scheme begins with a step of length H by Gragg's midpoint rule in 2j
;; substeps; with the rows before it, it is extrapolated to
;;
;;     T(j, i) = T(j, i−1) + (T(j, i−1) − T(j−1, i−1)) / ((j / (j−i+1))² − 1).
;;
;; The coefficients are fractions, which no precision exhausts, as it would the digits
;; that are known of those of a Runge–Kutta method.  T(j, j) is of order 2j; its
;; distance from T(j, j−1) is the error of that, of order 2j − 1, and takes rows until
;; it is tolerated.  For d digits about d ln(10)/4 rows of a step of e⁻² times the
;; distance to the nearest singularity take the fewest slopes.
;;
;; After each step every row tells how long a step it would have borne, and so the cost of
;; a unit of time by it; the cheapest one is aimed at next.

(require math/bigfloat
         racket/flonum
         "../record-fields.rkt" "../vector-map.rkt")

(provide make-integrator guard-bits
         ;; for tests of order
         step-by-rows)

;; Bits beyond those that the tolerance asks for: extrapolation multiplies rounding errors by up
;; to 2.3 for each row.
(define (guard-bits digits) (+ 24 (inexact->exact (ceiling (* 1.2 (most-rows digits))))))

(define (best-rows digits) (max 4 (inexact->exact (round (* 0.5 digits)))))
(define (most-rows digits) (+ 4 (inexact->exact (ceiling (* 0.8 digits)))))

;; In the precision in force:
;; f         : vector -> vector
;; tolerance : of each step, relative to 1 + |y|, a bigfloat of about 10^-digits
;; clock     : index of the component of y that is the time, to be kept exact, or #f
;; longest   : how long a step may be, a flonum; limit : how many there may be
;; shortest  : how short, beside the time and the time since the start
;; stuck     : called with the time, the state there and why, 'too-short or
;;             'too-many-steps, where it cannot go on
;; -> (advance end visit), which goes on to the time `end`, exactly, and returns the
;;    time and state reached.  (visit from y to z) is called after each step, from the
;;    state y to z; the integration ends there if it returns #f.
(define (make-integrator f y0 start tolerance digits #:clock clock #:stuck stuck
                         #:longest [longest +inf.0] #:limit [limit +inf.0]
                         #:shortest [shortest 0.0])
  (define most (most-rows digits))
  (define slope (f y0))
  (define i
    (integrator f start tolerance clock stuck longest limit shortest most (make-factors most)
                start y0 slope (best-rows digits) (first-length y0 slope) 0))
  (lambda (end visit) (advance! i end visit)))

;; most, factors : greatest number of rows of the scheme, and the factors of their differences
;; t, y, slope   : where the motion is
;; aim, length   : of the next step, the rows aimed at and a flonum; count : of steps
(struct integrator (f start tolerance clock stuck longest limit shortest most factors
                    [t #:mutable] [y #:mutable] [slope #:mutable]
                    [aim #:mutable] [length #:mutable] [count #:mutable])
  #:authentic)

(define (advance! i end visit)
  (let loop ([go-on? #t])
    (define t (integrator-t i))
    (if (and go-on? (not (bf= t end)))
        (loop (step! i end visit))
        (values t (integrator-y i)))))

;; Takes one step towards `end`.
(define (step! i end visit)
  (define-fields integrator i t y length longest count limit stuck)
  (when (>= count limit) (stuck t y 'too-many-steps))
  (set-integrator-count! i (+ count 1))
  (try! i end (flmin longest length) visit))

(define (try! i end h visit)
  (define-fields integrator i f t y slope tolerance aim most factors stuck)
  (define remaining (bf- end t))
  (define far (abs (bigfloat->flonum remaining)))
  (define last? (fl>= (fl* 1.0000001 h) far))
  (define H (if last? remaining (bf (if (bfnegative? remaining) (- h) h))))
  (when (and (not last?) (too-short? i h)) (stuck t y 'too-short))
  (define-values (z errors accepted?) (extrapolate f y slope H tolerance aim most factors))
  (define-values (rows next) (best-choice errors (if last? far h) accepted? most))
  (cond [accepted?
         (unless (and last? (fl< next (integrator-length i)))   ; short for no fault of its own
           (set-integrator-aim! i rows)
           (set-integrator-length! i next))
         (accept! i (if last? end (bf+ t H)) z)
         (visit t y (integrator-t i) (integrator-y i))]
        [else (set-integrator-aim! i rows)
              (try! i end next visit)]))

(define (accept! i t z)
  (define-fields integrator i f clock)
  (define y (if clock (with-component z clock t) z))
  (set-integrator-t! i t)
  (set-integrator-y! i y)
  (set-integrator-slope! i (f y)))

;; Towards a pole steps would get shorter without end, for rounding is far away.
(define (too-short? i h)
  (define-fields integrator i t start shortest)
  (define scale (flmax (flabs (bigfloat->flonum t)) (flabs (bigfloat->flonum (bf- t start)))))
  (fl<= h (fl* shortest scale)))

(define (with-component v k x)
  (define new (make-vector (vector-length v)))
  (vector-copy! new 0 v)
  (vector-set! new k x)
  new)

;; A tenth of the time in which the state changes by its own size.
(define (first-length y slope)
  (define rate (norm slope y (bf 1)))
  (if (and (fl> rate 0.0) (fl< rate +inf.0)) (fl/ 0.1 rate) 1.0))

;; ---------------------------------------------------------------------------
;; One step

;; -> the best state found, the errors of rows 2, 3 ..., the latest first, in units of
;; the tolerance, and whether the last one will do
(define (extrapolate f y slope H tolerance aim limit factors)
  (let loop ([j 1] [above '()] [errors '()])
    (define row (extrapolated-row f y slope H j above factors))
    (define best (car row))
    (cond
      [(eqv? j 1) (loop 2 row '())]
      [else
       (define error (norm (difference best (cadr row)) y tolerance))
       (define all (cons error errors))
       (cond [(and (fl<= error 1.0) (> j 2)) (values best all #t)]
             [(or (hopeless? error j aim) (eqv? j limit)) (values best all #f)]
             [else (loop (+ j 1) row all)])])))

;; One row more multiplies the error by about 1/j²; one more than aimed at is allowed.
(define (hopeless? error j aim)
  (define left (- (+ aim 1) j))
  (or (not (fl< error +inf.0))
      (<= left 0)
      (and (<= left 2)
           (> error (for/product ([k (in-range (+ j 1) (+ aim 2))]) (* 1.0 k k))))))

;; T(j, j) ... T(j, 1), given those of the row above
(define (extrapolated-row f y slope H j above factors)
  (for/fold ([row (list (midpoint-rule f y slope H (* 2 j)))])
            ([previous (in-list (reverse above))] [factor (in-vector (vector-ref factors j))])
    (define last (car row))
    (cons (vector-map2 (lambda (a b) (bf+ a (bf* factor (bf- a b)))) last previous) row)))

;; The state after a step from y: T(j, j).
(define (step-by-rows f y H j)
  (define factors (make-factors j))
  (define slope (f y))
  (for/fold ([row '()] #:result (car row)) ([i (in-range 1 (+ j 1))])
    (extrapolated-row f y slope H i row factors)))

;; j -> the factors of the differences in row j, from column 2 on
(define (make-factors limit)
  (for/vector #:length (+ limit 1) ([j (in-range (+ limit 1))])
    (for/vector ([m (in-range (- j 1) 0 -1)])
      (bf (/ (* m m) (- (* j j) (* m m)))))))

;; Gragg's rule, smoothed: u and w are the last two points.
(define (midpoint-rule f y slope H count)
  (define h (bf/ H (bf count)))
  (define 2h (bf* (bf 2) h))
  (let loop ([k 1] [u y] [w (moved y h slope)])
    (define v (f w))
    (if (eqv? k count)
        (vector-map2 (lambda (a b) (bf* (bf 1/2) (bf+ a b))) w (moved u h v))
        (loop (+ k 1) w (moved u 2h v)))))

;; y + h v
(define (moved y h v) (vector-map2 (lambda (a b) (bf+ a (bf* h b))) y v))
(define (difference v w) (vector-map2 bf- v w))

;; The greatest |eᵢ| / (1 + |yᵢ|), in units of `one`, as a flonum.
(define (norm e y one)
  (for/fold ([greatest 0.0]) ([a (in-vector e)] [b (in-vector y)])
    (define x (bigfloat->flonum (bf/ (bfabs a) (bf* one (bf+ (bf 1) (bfabs b))))))
    (if (fl< x +inf.0) (flmax greatest x) +inf.0)))

;; ---------------------------------------------------------------------------
;; The next step

;; errors : of rows j, j-1 ... 2 -> how many rows to aim at and the length for them
(define (best-choice errors h accepted? limit)
  (define last (+ 1 (length errors)))
  (define-values (rows longest least)
    (for/fold ([rows 3] [longest (* 0.1 h)] [least +inf.0])
              ([e (in-list errors)] [j (in-range last 2 -1)])
      (define H (borne e j h))
      (define cost (/ (slopes j) H))
      (if (< cost least) (values j H cost) (values rows longest least))))
  (cond [(not accepted?) (values rows (min longest (* 0.7 h)))]
        [(and (= rows last) (< last limit))     ; still falling
         (values (+ rows 1) (* longest (/ (slopes (+ rows 1)) (slopes rows))))]
        [else (values rows longest)]))

;; How many slopes j rows take: 1 + 2 + 4 + ... + 2j.
(define (slopes j) (+ 1.0 (* j (+ j 1))))

;; The length of step that row j would have borne.
(define (borne error j h)
  (define growth
    (if (fl< error +inf.0)
        (fl* 0.94 (flexpt (fl/ 0.65 error) (fl/ 1.0 (->fl (- (* 2 j) 1)))))
        0.1))
  (fl* h (flmin 6.0 growth)))
