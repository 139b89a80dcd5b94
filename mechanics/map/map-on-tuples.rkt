#lang racket/base
;; A map of the plane, or of states, as one of rows of numbers, done so many times.
;;
;; Of a state (up t q p) the time is none of them: a motion comes back when the others do.
;; Coordinates that are angles come back when they do but for whole turns.  A coordinate is taken
;; for one if a whole turn of it changes the image by nothing but whole turns.

(require racket/flonum
         "map-of-the-plane.rkt"
         "../calculus/derivative.rkt" "../calculus/perturbed.rkt"
         "../error/complain.rkt" "../error/refusal.rkt"
         "../generic/compare.rkt" "../generic/describe.rkt" "../generic/function.rkt"
         "../generic/scalar.rkt" "../generic/up-down.rkt"
         "../lagrangian/called.rkt" "../lagrangian/of-momenta.rkt"
         "../numeric/constants.rkt" "../numeric/finite.rkt" "../numeric/flvector.rkt"
         "../numeric/whole-turns.rkt"
         "../value/shape.rkt")

(provide make-map-on-tuples (struct-out map-on-tuples)
         displacement slopes-of-image)

;; image : (up z ...) -> (up z' ...), of the numbers that come back; point : flvector -> what the
;; user calls a point; start : flvector; angles : list of booleans
(struct map-on-tuples (image point start angles))

;; map : a map of the plane, or a function of states; at : a point or a state
(define (make-map-on-tuples who map at times)
  (define plane? (and (procedure? map) (accepts? map 4)))
  (when (and (not (pointwise? map)) (pointwise? at))
    (complain who "the map comes first, then the point; these look swapped"))
  (unless (or plane? (and (pointwise? map) (accepts? map 1)))
    (complain who "expected a map of the plane, or a function of a state\n  given: ~a~a"
              (describe-function map) (map-hint map)))
  (check-no-energy who map at)
  (define start (point-numbers who at plane?))
  (define once (if plane? (plane-image who map) (state-image who map at)))
  (define (image p) (for/fold ([p p]) ([_ (in-range times)]) (once p)))
  (define (point v)
    (define p (apply up (flvector->list v)))
    (if plane? p (with-time at p)))
  (map-on-tuples image point start (angles-of image start)))

(define ((plane-image who map) p)
  (point-image-of who map (structure-ref p 0) (structure-ref p 1)))

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

;; The rate of the time is 1 at any time.
(define (later state)
  (define all (list->vector (scalars state)))
  (scalars->structure state (lambda (k) (if (= k 0) (+ 1 (vector-ref all 0)) (vector-ref all k)))))

;; An energy makes a number of a state, and what is called one may not take a point (up x y).
(define (check-no-energy who map at)
  (define takes? (with-handlers ([refusal? (lambda (e) #f)]) (map at) #t))
  (when (or (of-momenta? map) (and (called-energy? map) (not takes?))) (raise-energy who map)))

(define (raise-energy who f)
  (complain who "expected a map of the plane, or a function of a state\n  given: ~a~a"
            (describe-with-value f)
            (string-append (energy-hint f)
                           "\n  where the motion rests, (find-equilibrium "
                           (if (called-Lagrangian? f) "L" "H") " q) finds")))

(define (raise-rates who map)
  (complain who
            (string-append "a state derivative gives rates, it is no map of states\n  given: ~a\n"
                           "  (stroboscopic-map f period) and (Poincare-map f event) make maps of it")
            (value->text map)))

;; Tuples answer `procedure?`, too.
(define (plain-procedure? x) (and (procedure? x) (not (tuple? x))))

;; A state, of which the first scalar is the time.
(define (timed? at) (and (tuple? at) (>= (structure-length (adopt at)) 3)))

(define (with-time at p)
  (define all (row (if (timed? at) (list (car (scalars at))) '()) p))
  (scalars->structure at (lambda (k) (vector-ref all k))))

(define (row before p) (list->vector (append before (scalars p))))

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

(define (angles-of image start)
  (define there (numbers (image (up-of-numbers start))))
  (for/list ([k (in-range (flvector-length start))])
    (define moved (flvector-copy start))
    (flvector-set! moved k (fl+ :2pi (flvector-ref start k)))
    (with-handlers ([refusal? (lambda (e) #f)])
      (for/and ([a (in-flvector there)] [b (in-flvector (numbers (image (up-of-numbers moved))))])
        (fl< (flabs (whole-turns-less (fl- b a))) 1e-6)))))

;; How far the image of z is from z.
(define (displacement m z [image (numbers ((map-on-tuples-image m) (up-of-numbers z)))])
  (for/flvector #:length (flvector-length z)
                ([a (in-flvector z)] [b (in-flvector image)]
                 [angle? (in-list (map-on-tuples-angles m))])
    (if angle? (whole-turns-less (fl- b a)) (fl- b a))))

;; -> the derivatives of the image, a vector of rows
(define (slopes-of-image m z)
  (define n (flvector-length z))
  (define all
    (list->vector
     (for/list ([x (in-list (scalars (derivative-at (map-on-tuples-image m) (up-of-numbers z))))])
       (real->double-flonum (comparand (innermost x))))))
  (for/vector #:length n ([i (in-range n)])
    (for/vector #:length n ([j (in-range n)]) (vector-ref all (+ i (* j n))))))
