#lang racket/base
;; A map of the plane, or of states, as one of rows of numbers, done so many times.
;;
;; Of a state (up t q p) the time is none of them: a motion comes back when the others do.
;; Coordinates that are angles come back when they do but for whole turns.  Coordinates are taken
;; for angles if a whole turn of one changes the image by nothing but whole turns, of these.  The
;; map done once is asked: of a map that stretches much the image after many times is so large
;; that its rounding is a turn or more, and anything would pass.

(require racket/flonum
         (only-in racket/list range remove-duplicates)
         "map-of-the-plane.rkt" "period-check.rkt"
         "../../calculus/derivative.rkt" "../../calculus/perturbed-value.rkt"
         "../../error/complain.rkt" "../../error/refusal.rkt"
         "../../generic/compare.rkt" "../../generic/describe.rkt"
         "../../generic/function-check.rkt" "../../generic/function.rkt"
         "../../generic/scalar.rkt" "../../generic/up-down.rkt" "../../generic/wrong-argument.rkt"
         "../../lagrangian/function-name-hints.rkt" "../../lagrangian/function-of-momenta.rkt"
         "../../numeric/constants.rkt" "../../numeric/finite-number.rkt"
         "../../numeric/flvector.rkt"
         "../../numeric/whole-turns.rkt"
         (only-in "../../search/implicit-root.rkt" columns->rows)
         "../../value/shape.rkt")

(provide make-map-on-tuples (struct-out map-on-tuples) done-times
         displacement returns-after slopes-of-image
         ;; for orbits
         up-of-numbers)

;; once : (up z ...) -> (up z' ...), of the numbers that come back; times : number of iterations
;; point : flvector -> the user's point or state; start : flvector; angles : list of booleans
(struct map-on-tuples (once times point start angles))

;; The same map with another number of iterations, from another start.
(define (done-times m times start) (struct-copy map-on-tuples m [times times] [start start]))

(define ((image-by m) p) (for/fold ([p p]) ([_ (in-range (map-on-tuples-times m))])
                           ((map-on-tuples-once m) p)))

;; map : a map of the plane, or a function of states; at : a point or a state
(define (make-map-on-tuples who map at times)
  (define plane? (map? map))
  (check-comes-first who (and (not (pointwise? map)) (pointwise? at)) "map" "point")
  (unless (or plane? (and (pointwise? map) (accepts? map 1)))
    (complain who "expected a map of the plane, or a function of a state\n  given: ~a~a"
              (describe-function map) (map-hint map)))
  (unless plane? (check-no-energy who map at))
  (define start (point-numbers who at plane?))
  (define once (if plane? (point-image-at who map) (state-image who map at)))
  (define angles (angles-of once start))
  (define (point v)
    (define p (apply up (flvector->list v)))
    (if plane? p (with-time at p)))
  (map-on-tuples once times point start angles))

(define ((state-image who map at) p)
  (define value (map (with-time at p)))
  (when (and (tuple? at) (scalar? value)) (raise-energy who map))
  (when (or (plain-procedure? value) (not (= (shape-length value) (shape-length at))))
    (complain who
              "the map gives another thing than it was given\n  map: ~a\n  of: ~a\n  value: ~a~a"
              (value->text map) (value->text (with-time at p)) (value->text value)
              (if (plain-procedure? value)
                  (format "\n  parameters are supplied first: (~a ...)" (value->text map))
                  "")))
  (define image (scalars value))
  (check-image who map image)
  (when (and (timed? at) (eqv? 1 (car image)) (eqv? 1 (car (scalars (map (later at))))))
    (raise-rates who map))
  (apply up (if (timed? at) (cdr image) image)))

;; The state at another time: there, too, the rate of the time is 1.
(define (later state) (changed state (lambda (x k) (if (= k 0) (+ 1 x) x))))

;; An energy makes a number of a state, and a procedure called one may not take a point (up x y).
(define (check-no-energy who map at)
  (define (takes?) (if-raised refusal? #f (map at) #t))
  (when (or (of-momenta? map) (and (called-energy? map) (not (takes?)))) (raise-energy who map)))

(define (raise-energy who f)
  (complain-of-argument who "a map of the plane, or a function of a state" f
                        (string-append (energy-hint f)
                                       "\n  where the motion rests, (find-equilibrium "
                                       (if (called-Lagrangian? f) "L" "H") " q) finds")))

(define (raise-rates who map)
  (complain who
            (string-append "a state derivative gives rates, it is no map of states\n  given: ~a\n"
                           "  (stroboscopic-map f period) and (Poincare-map f event) make maps of it")
            (value->text map)))

;; Is it a state, whose first scalar is the time?
(define (timed? at) (and (tuple? at) (>= (structure-length (adopt at)) 3)))

(define (with-time at p)
  (define time (if (timed? at) (list (car (scalars at))) '()))
  (vector->structure at (list->vector (append time (scalars p)))))

(define (point-numbers who at plane?)
  (define all (map comparand (scalars at)))
  (define moving (if (and (not plane?) (timed? at)) (cdr all) all))
  (unless (and (pair? moving) (andmap finite? moving)
               (or (not plane?) (and (tuple? at) (= (length all) 2))))
    (complain who "expected ~a of real numbers; given ~a"
              (if plane? "a point (up x y)" "a state") (describe-with-value at)))
  (for/flvector #:length (length moving) ([x (in-list moving)]) (real->double-flonum x)))

;; ---------------------------------------------------------------------------

(define (numbers p)
  (for/flvector ([x (in-list (scalars p))]) (real->double-flonum (comparand (innermost x)))))

(define (up-of-numbers v) (apply up (flvector->list v)))

;; -> a list of booleans: the largest set of coordinates that are angles together.  A
;; coordinate that moves another one, not an angle, by whole turns is no angle itself.
(define (angles-of image start)
  (define (at v) (numbers (image (up-of-numbers v))))
  (define all (range (flvector-length start)))
  (define here (at start))              ; where there is no image the user is told
  (define moves (for/list ([k (in-list all)]) (moved-by-a-turn at start here k)))
  (define (angle? k among)
    (define those (list-ref moves k))
    (and those (for/and ([k (in-list those)]) (memv k among))))
  (let settle ([among all])
    (define left (filter (lambda (k) (angle? k among)) among))
    (if (equal? left among)
        (for/list ([k (in-list all)]) (and (memv k left) #t))
        (settle left))))

;; If a whole turn of coordinate k moves coordinates of the image by whole turns only, returns
;; their indices, else #f.  Two places are tried: at one alone it may be chance.
(define (moved-by-a-turn at start here k)
  (define (at-or-not v) (if-raised refusal? #f (at v)))
  (define (moved v image)
    (define further (flvector-copy v))
    (flvector-set! further k (fl+ :2pi (flvector-ref v k)))
    (define there (at-or-not further))
    (and there (turned image there)))
  (define those (moved start here))
  (define near (beside start))
  (define image (and those (at-or-not near)))
  (define also (if image (moved near image) '()))
  (and those also (remove-duplicates (append those also))))

(define (beside v)
  (for/flvector #:length (flvector-length v) ([x (in-flvector v)] [k (in-naturals 1)])
    (fl+ x (fl/ 0.1 (->fl k)))))

;; -> the indices where b is whole turns from a, or #f if a difference is no whole turn
(define (turned a b)
  (let loop ([k 0] [those '()])
    (define off (and (< k (flvector-length a)) (fl- (flvector-ref b k) (flvector-ref a k))))
    (cond [(not off) those]
          [(not (whole-turns? off)) #f]
          [else (loop (+ k 1) (if (fl< (flabs off) 1.0) those (cons k those)))])))

;; Numbers of 1e8 and more are whole turns by rounding alone.
(define (whole-turns? x)
  (and (fl< (flabs x) 1e8) (fl< (flabs (whole-turns-less x)) 1e-6)))

;; -> the displacement from z to its image
(define (displacement m z [image (numbers ((image-by m) (up-of-numbers z)))])
  (for/flvector #:length (flvector-length z)
                ([a (in-flvector z)] [b (in-flvector image)]
                 [angle? (in-list (map-on-tuples-angles m))])
    (if angle? (whole-turns-less (fl- b a)) (fl- b a))))

;; -> the proper divisors of the times after which z is back, the least first.
;; back? : displacement -> boolean.  The orbit is followed once for all divisors.
(define (returns-after m z back?)
  (let loop ([divisors (proper-divisors (map-on-tuples-times m))] [k 0] [p (up-of-numbers z)])
    (cond [(null? divisors) '()]
          [(< k (car divisors)) (loop divisors (+ k 1) ((map-on-tuples-once m) p))]
          [(back? (displacement m z (numbers p))) (cons k (loop (cdr divisors) k p))]
          [else (loop (cdr divisors) k p)])))

(define (proper-divisors n)
  (for/list ([k (in-range 1 n)] #:when (zero? (remainder n k))) k))

;; -> the derivatives of the image, a vector of rows
(define (slopes-of-image m z)
  (columns->rows (flvector-length z)
                 (numbers (derivative-at (image-by m) (up-of-numbers z)))))
