#lang racket/base
;; A minimum of a function of several variables from its values alone, by the
;; downhill simplex method (J. A. Nelder and R. Mead, Computer Journal 7, 1965, 308).
;;
;; A simplex of n + 1 points moves and shrinks: its worst point is reflected in the
;; centre of the others; if that is the best point yet, twice as far is tried; if it
;; is still the worst, half as far on either side; and if that fails the simplex
;; shrinks towards its best point.  The search ends when the simplex is smaller than
;; the tolerance, and starts once more there with a fresh simplex, for a simplex may
;; collapse before it arrives.

(require racket/flonum
         racket/list
         "../flvector.rkt"
         "../../error/failure.rkt")

(provide nelder-mead)

;; f        : flvector -> flonum
;; step     : how far the first points are from each other, or #f for a tenth of the
;;            size of the start
;; argument : the user's form of a point
;; -> point, value, evaluations
(define (nelder-mead f start
                     #:step [step #f]
                     #:tolerance [tolerance 1e-8]
                     #:limit [limit 20000]
                     #:stop-at-limit? [stop? #f]
                     #:observe [observe void]
                     #:argument [argument flvector->list]
                     #:name [who 'minimize])
  (define count 0)
  (define (vertex-at x)
    (set! count (+ count 1))
    (define y (f x))
    (vertex x (if (< y +inf.0) y +inf.0)))
  (define (not-found what best [error +inf.0])
    (raise-not-convergent who (string-append "no minimum found: " what)
                          (argument (vertex-x best)) error
                          "value there" (vertex-y best)
                          "evaluations" count))
  (define (search start)
    (let loop ([simplex (sorted (initial-simplex vertex-at start step))])
      (define best (first simplex))
      (observe (vertex-x best) (vertex-y best))
      (cond [(= (vertex-y best) -inf.0) (not-found "the function falls without end" best)]
            [(<= (size simplex) (* tolerance (+ 1.0 (greatest (vertex-x best))))) best]
            [(and (>= count limit) stop?) best]
            [(>= count limit) (not-found "too many evaluations" best (size simplex))]
            [else (loop (move simplex vertex-at))])))
  (define found (search (vertex-x (search start))))
  (values (vertex-x found) (vertex-y found) count))

(struct vertex (x y) #:authentic)

(define (sorted vertices) (sort vertices < #:key vertex-y))

;; The point and others away along each axis.
(define (initial-simplex vertex-at x step)
  (define reach (or step (* 0.1 (max 1.0 (greatest x)))))
  (cons (vertex-at x)
        (for/list ([i (in-range (flvector-length x))])
          (define moved (flvector-copy x))
          (flvector-set! moved i (+ (flvector-ref x i) reach))
          (vertex-at moved))))

;; simplex : vertices by value, the best first
(define (move simplex vertex-at)
  (define best (first simplex))
  (define worst (last simplex))
  (define others (drop-right simplex 1))
  (define centre (mean (map vertex-x others)))
  ;; t = -1 is the worst point, t = 1 its reflection
  (define (try t) (vertex-at (between centre (vertex-x worst) t)))
  (define (replace-worst v) (sorted (cons v others)))
  (define reflected (try 1.0))
  (define y (vertex-y reflected))
  (cond
    [(< y (vertex-y best))
     (define farther (try 2.0))
     (replace-worst (if (< (vertex-y farther) y) farther reflected))]
    [(< y (vertex-y (last others))) (replace-worst reflected)]
    [else
     (define nearer (try (if (< y (vertex-y worst)) 0.5 -0.5)))
     (if (< (vertex-y nearer) (min y (vertex-y worst)))
         (replace-worst nearer)
         (shrink simplex vertex-at))]))

(define (shrink simplex vertex-at)
  (define best (first simplex))
  (sorted (cons best
                (for/list ([v (in-list (rest simplex))])
                  (vertex-at (mean (list (vertex-x best) (vertex-x v))))))))

;; ---------------------------------------------------------------------------
;; Points

(define (mean xs)
  (define n (->fl (length xs)))
  (define size (flvector-length (first xs)))
  (for/flvector #:length size ([i (in-range size)])
    (/ (for/fold ([sum 0.0]) ([x (in-list xs)]) (+ sum (flvector-ref x i))) n)))

(define (between centre worst t) (along centre t (difference centre worst)))

;; The greatest distance of a point from the best one.
(define (size simplex)
  (define best (vertex-x (first simplex)))
  (for/fold ([m 0.0]) ([v (in-list (rest simplex))]) (max m (distance (vertex-x v) best))))
