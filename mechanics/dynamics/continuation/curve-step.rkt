#lang racket/base
;; Steps along a curve of solutions of N equations in N + 1 unknowns, of which the last is the
;; parameter: pseudo-arclength (H. B. Keller 1977).
;;
;; From a point x with the tangent t a step of the length s predicts x + s t, and Newton's method
;; goes to the curve within the plane through there that is normal to t.  So a fold, where the
;; parameter turns back, is a point like any other.  Lengths are measured in scaled unknowns.
;;
;; The equations less this plane have a matrix J of N rows.  With the tangent as a further row its
;; determinant keeps its sign until another curve crosses this one.

(require racket/flonum
         (only-in racket/list range take)
         "../../error/refusal.rkt"
         "../../numeric/flvector.rkt"
         "../../numeric/linear-algebra/flonum-systems.rkt"
         "../../numeric/linear-algebra/row-matrix.rkt"
         (only-in "../../numeric/optimization/newton.rkt" solution)
         (only-in "../../numeric/optimization/trust-region.rkt" shortest-solution trust-region))

(provide (struct-out equations) (struct-out evaluated) (struct-out point)
         start-on-curve point-across solution-near point-at point-along step-along
         bordered scaled-rows)

;; evaluate : unknowns, reference point -> evaluated; scales : flvector
;; Of orbits, else #f: period : unknowns -> number; doubled : unknowns -> the equations of the orbit
;; gone through twice, and the unknowns of these
(struct equations (evaluate scales period doubled) #:authentic)

;; residual : flvector; slopes : vector of rows; spectrum : -> list of eigenvalues or multipliers
(struct evaluated (residual slopes spectrum) #:authentic)

;; x : unknowns; tangent : scaled, of length 1; slopes : scaled; determinant : with the tangent
(struct point (x tangent slopes determinant spectrum) #:authentic)

(define newton-tolerance 1e-9)
(define most-iterations 8)
;; Neighbouring tangents have at least this product.
(define least-cosine 0.95)

(define (scaled-rows e rows)
  (for/vector ([row (in-vector rows)])
    (for/vector ([a (in-vector row)] [s (in-flvector (equations-scales e))]) (* a s))))

(define (bordered rows t)
  (list->vector (append (vector->list rows) (list (list->vector (flvector->list t))))))

;; The shortest y with rows · y = −f; #f where the rows are not finite
(define (solved rows f)
  (and (all-entries? rational? rows)
       (or (solution rows f) (shortest-solution rows f (make-flvector (flvector-length f) 1.0)))))

;; y, which is normed, as a change of the unknowns
(define (moved e x a y) (along x a (flvector-map fl* y (equations-scales e))))

;; Newton's method from a guess within the plane normal to t
;; -> unknowns, evaluated and the number of iterations; or #f thrice
;; start : a point in that plane that is nearer
(define (corrected e guess t reference [start guess])
  (let loop ([x start] [k 0] [last +inf.0])
    (define v (if-raised refusal? #f ((equations-evaluate e) x reference)))
    (define off
      (for/fold ([sum 0.0]) ([u (in-flvector x)] [w (in-flvector guess)] [a (in-flvector t)]
                             [s (in-flvector (equations-scales e))])
        (fl+ sum (fl* a (fl/ (fl- u w) s)))))
    (define y
      (and v
           (solved (bordered (scaled-rows e (evaluated-slopes v)) t)
                   (apply flvector (append (flvector->list (evaluated-residual v)) (list off))))))
    (define length (if y (norm y) +inf.0))
    (cond [(fl< length newton-tolerance) (values (moved e x 1.0 y) v (+ k 1))]
          [(or (not y) (= k most-iterations) (fl> length (fl* 2.0 last))) (values #f #f #f)]
          [else (loop (moved e x 1.0 y) (+ k 1) length)])))

;; The point at unknowns that are a solution; border : about along the curve
(define (point-at e x v border)
  (define rows (scaled-rows e (evaluated-slopes v)))
  (define n (flvector-length x))
  (define t (solved (bordered rows border) (flvector-scaled -1.0 (unit-flvector (- n 1) n))))
  (define tangent (and t (flvector-scaled (fl/ 1.0 (norm t)) t)))
  (and tangent
       (point x tangent rows (floating-determinant (bordered rows tangent))
              ((evaluated-spectrum v)))))

;; The point at the parameter of x, from where the parameter changes by that sign; #f if none
(define (start-on-curve e x sign)
  (define n (flvector-length x))
  (point-across e x (flvector-scaled (->fl sign) (unit-flvector (- n 1) n))))

;; The point of the curve in the plane through x that is normal to t; #f if none
(define (point-across e x t)
  (define-values (there v _) (corrected e x t x))
  (and there (point-at e there v t)))

;; The unknowns of the nearest solution with the parameter of x; a failure of the search otherwise
(define (solution-near who e x)
  (define n (- (flvector-length x) 1))
  (define (all u) (apply flvector (append (flvector->list u) (list (flvector-ref x n)))))
  (define last (cons #f #f))
  (define (at u)
    (unless (eq? u (car last)) (set! last (cons u ((equations-evaluate e) (all u) x))))
    (cdr last))
  (define-values (u _error)
    (trust-region (lambda (u) (evaluated-residual (at u)))
                  (lambda (u)
                    (define rows (evaluated-slopes (at u)))
                    (submatrix rows (range (vector-length rows)) (range n)))
                  (apply flvector (take (flvector->list x) n)) #:deficient? #t #:name who))
  (all u))

;; The point whose plane is at the distance s from a, and how many iterations it took; or #f twice
(define (point-along e a s [t (point-tangent a)] [guess (moved e (point-x a) s t)])
  (define-values (x v count) (corrected e (moved e (point-x a) s t) t (point-x a) guess))
  (define p (and x (point-at e x v t)))
  (values p (and p count)))

;; A step of about that length -> the point, its distance, and the length for the next step; #f
;; thrice where there is none, however short the step
(define (step-along e a given longest shortest [t (point-tangent a)])
  (let loop ([s given])
    (define-values (p count) (point-along e a s t))
    (define smooth? (and p (fl> (dot (point-tangent p) t) least-cosine)))
    (cond [smooth?
           (define factor (cond [(<= count 3) 1.4] [(>= count 6) 0.6] [else 1.0]))
           (values p s (flmin longest (fl* s factor)))]
          [(fl< s shortest) (values #f #f #f)]
          [else (loop (fl* 0.5 s))])))
