#lang racket/base
;; Periodic points of a map of the plane in a rectangle.
;;
;; They are looked for from the nodes of a grid where the displacement |M(x) − x| is less than at
;; the nodes around, then on a grid twice as fine, until nothing new comes.
;;
;; How often the displacement turns round while x goes once round the rectangle is the sum of the
;; indices of the points within: the sign of det(DM − 1), which is +1 of an elliptic point and −1
;; of a hyperbolic one.  So a lone point that is missing is noticed; a pair that arose together is
;; not, for the indices of its points cancel.
;;
;; With a symmetry, a map of the plane, those are wanted that it leaves where they are.

(require racket/flonum
         racket/list
         "displacement-index.rkt" "fixed-points.rkt" "map-of-the-plane.rkt" "map-on-tuples.rkt"
         "plane-points.rkt"
         "../../error/failure.rkt" "../../error/note.rkt" "../../error/refusal.rkt"
         "../../generic/compare.rkt" "../../generic/define-plain.rkt"
         "../../generic/up-down.rkt" "../../generic/wrong-argument.rkt"
         "../../numeric/constants.rkt" "../../numeric/finite-number.rkt"
         "../../numeric/flvector.rkt")

(provide periodic-points)

;; A rectangle of the plane
(struct area (x-min x-max y-min y-max))

;; region : (list x-min x-max y-min y-max); -> fixed points of period n and no lesser one
(define-plain (periodic-points map n region #:grid [grid '(20 20)] #:symmetry [R #f])
  (define who 'periodic-points)
  (check-map who map n region)
  (check-argument who exact-positive-integer? n "a period, a positive integer")
  (define a (call-with-values (lambda () (checked-region who region)) area))
  (check-grid who grid)
  (define m (map-at-some-node who map n a grid))
  (define mirror (and R (make-map-on-tuples who R (up (area-x-min a) (area-y-min a)) 1)))
  (define index (index-round m (area-x-min a) (area-x-max a) (area-y-min a) (area-y-max a)))
  (define-values (all smooth?) (points-on-grids who map m mirror n a grid index))
  (define missing (if (and smooth? (not R)) (missing-index index all a) 0))
  (unless (eqv? 0 missing)
    (note-once
     (format (string-append "periodic-points: a point of index ~a is missing, as the displacement "
                            "turns round the rectangle; a finer #:grid may find it")
             missing)))
  (define (wanted? p) (and (not (lesser-period? map p n)) (or (not R) (kept-by? mirror p))))
  (sort (filter wanted? all) before?))

;; Does the symmetry leave the point where it is?
(define (kept-by? mirror p)
  (define at (fixed-point-coordinates p))
  (define d (displacement-at mirror (abscissa at) (ordinate at)))
  (and d (fl< (norm d) 1e-8)))

;; The number of times that a grid is made twice as fine, where points are known to be missing.
(define most-grids 4)

;; -> the points, those of lesser periods among them, and whether the displacement is smooth
(define (points-on-grids who map m mirror n a grid index)
  (let loop ([found '()] [grid grid] [left most-grids])
    (define-values (starts smooth?) (low-nodes m mirror a grid))
    (define all (with-points-near who map n a starts found))
    (define lacking? (and smooth? (not (eqv? 0 (missing-index index all a)))))
    (define same? (= (length all) (length found)))
    (if (or (eqv? left 1) (and same? (not lacking?) (< left most-grids)))
        (values all smooth?)
        (loop all (list (* 2 (car grid)) (* 2 (cadr grid))) (- left 1)))))

(define (with-points-near who map n a starts found)
  (for/fold ([found found]) ([guess (in-list starts)])
    (define p
      (with-handlers ([refusal? values]) (fixed-point-near who map guess n 1e-13 30)))
    (if (and (fixed-point? p) (inside? p a) (not (member p found same-point?)))
        (cons p found)
        found)))

;; ---------------------------------------------------------------------------
;; Grids

;; -> the x of the nodes, or the y
(define (columns a grid)
  (for/list ([i (in-range (car grid))]) (part-middle (area-x-min a) (area-x-max a) i (car grid))))
(define (rows a grid)
  (for/list ([j (in-range (cadr grid))]) (part-middle (area-y-min a) (area-y-max a) j (cadr grid))))

;; The map as it is at the first node where it has an image.  A map that fails wherever one starts
;; is at fault, not the starts.
(define (map-at-some-node who map n a grid)
  (define nodes (for*/list ([x (in-list (columns a grid))] [y (in-list (rows a grid))]) (up x y)))
  (define (map-at node) (with-handlers ([refusal? values]) (make-map-on-tuples who map node n)))
  (define first-try (map-at (car nodes)))
  (define (fault? x) (and (exn:fail:contract? x) (not (no-value? x))))
  (cond [(map-on-tuples? first-try) first-try]
        [(for/or ([node (in-list (cdr nodes))])
           (define m (map-at node))
           (and (map-on-tuples? m) m))]
        [else (raise first-try)]))

;; -> the nodes where the displacement is no longer than at their eight neighbours, and whether it
;; is smooth on the grid.  With a symmetry its own displacement counts as well.
(define (low-nodes m mirror a grid)
  (define-values (xs ys) (values (columns a grid) (rows a grid)))
  (define moves (for*/vector ([x (in-list xs)] [y (in-list ys)]) (displacement-at m x y)))
  (define high (cadr grid))
  (define lengths
    (for*/vector ([(x i) (in-indexed xs)] [(y j) (in-indexed ys)])
      (define d (vector-ref moves (+ (* i high) j)))
      (define off (if mirror (displacement-at mirror x y) (flvector 0.0)))
      (if (and d off) (fl+ (norm d) (norm off)) +inf.0)))
  (define (length-at i j)
    (if (and (< -1 i (car grid)) (< -1 j high)) (vector-ref lengths (+ (* i high) j)) +inf.0))
  (define (low? i j)
    (define l (length-at i j))
    (and (fl< l +inf.0)
         (for*/and ([k '(-1 0 1)] [h '(-1 0 1)]) (fl<= l (length-at (+ i k) (+ j h))))))
  (values (for*/list ([(x i) (in-indexed xs)] [(y j) (in-indexed ys)] #:when (low? i j)) (up x y))
          (for/and ([d (in-vector moves)]) (and d (smooth? m d)))))

;; ---------------------------------------------------------------------------
;; Points

;; The sum of indices that is missing; 0 where it is not known
(define (missing-index index all a)
  (define (undecided? p)
    (or (eq? (fixed-point-kind p) 'parabolic) (near-edge? (fixed-point-coordinates p) a)))
  (if (or (not index) (ormap undecided? all))
      0
      (- index (for/sum ([p (in-list all)]) (index-of p)))))

(define (index-of p)
  (define product (apply * (map (lambda (l) (- l 1)) (fixed-point-multipliers p))))
  (if (> (real-part product) 0) 1 -1))

(define (near-edge? at a)
  (define (close? z edge) (< (abs (- z edge)) (* 1e-6 (+ 1 (abs z)))))
  (or (close? (abscissa at) (area-x-min a)) (close? (abscissa at) (area-x-max a))
      (close? (ordinate at) (area-y-min a)) (close? (ordinate at) (area-y-max a))))

;; Orders points by abscissas, those with equal abscissas by ordinates.
(define (before? p q)
  (define-values (a b) (values (fixed-point-coordinates p) (fixed-point-coordinates q)))
  (or (< (abscissa a) (- (abscissa b) 1e-9))
      (and (<= (abs (- (abscissa a) (abscissa b))) 1e-9) (< (ordinate a) (ordinate b)))))

;; Points on an edge are inside; of two edges a turn apart, only the first counts.
(define (inside? p a)
  (define at (fixed-point-coordinates p))
  (define (within? low z high)
    (define whole-turn? (>= (- high low) (- :2pi 1e-9)))
    (<= (- low 1e-9) z (if whole-turn? (- high 1e-9) (+ high 1e-9))))
  (and (within? (area-x-min a) (abscissa at) (area-x-max a))
       (within? (area-y-min a) (ordinate at) (area-y-max a))))

(define (same-point? p q) (near? p (fixed-point-coordinates q)))

(define (near? p at)
  ((nearness-by-angles (fixed-point-angles p) 1e-7) (fixed-point-coordinates p) at))

(define (lesser-period? map p n)
  (let loop ([k 1] [at (fixed-point-coordinates p)])
    (define image (and (<= k (quotient n 2)) (image-once map at)))
    (and image
         (or (and (zero? (remainder n k)) (near? p image))
             (loop (+ k 1) image)))))

(define (image-once map at)
  (image-of 'periodic-points map (abscissa at) (ordinate at) make-point))

(define (checked-region who region)
  (define bounds (and (list? region) (for/list ([x (in-list region)]) (comparand x))))
  (unless (and bounds (= (length bounds) 4) (andmap finite? bounds)
               (< (car bounds) (cadr bounds)) (< (caddr bounds) (cadddr bounds)))
    (complain-of-argument who "a region, (list x-min x-max y-min y-max)" region))
  (apply values bounds))
