#lang racket/base
;; Points of a branch where something changes: folds, crossings with other branches, oscillations
;; that begin to grow, period doublings.
;;
;; Each has a function that changes its sign there (Yu. A. Kuznetsov, Elements of Applied
;; Bifurcation Theory, 10.2): the parameter's part of the tangent; the determinant of the equations
;; with the tangent; the product of all multipliers + 1; the growth of the oscillation.  Where no
;; energy is lost oscillations do not grow until two frequencies meet (a collision of Krein's):
;; there the number of growing ones is looked at.

(require racket/flonum
         racket/list
         "curve-step.rkt"
         "../../numeric/flvector.rkt"
         "../../numeric/linear-algebra/row-matrix.rkt"
         "../../numeric/linear-algebra/singular-values.rkt"
         "../../numeric/optimization/brent-root.rkt")

(provide (struct-out found) points-between growing crossing-directions)

;; kind : symbol; other : the tangent of the branch that crosses, or #f
(struct found (kind at other) #:authentic)

;; A growth below this is none.
(define growth-tolerance 1e-6)

;; The growth that an eigenvalue means, or a multiplier
(define (growth orbit? l) (if orbit? (- (magnitude l) 1.0) (real-part l)))

;; How many of the spectrum grow
(define (growing orbit? spectrum)
  (count (lambda (l) (> (growth orbit? l) growth-tolerance)) spectrum))

(define (complex? l) (> (abs (imag-part l)) growth-tolerance))

;; -> list of found, in the order of the branch, between neighbouring points at the distance s
(define (points-between e orbit? a b s)
  (define (fold-test p) (last-part p))
  (define (doubling-test p)
    (real-part (for/fold ([x 1.0]) ([l (in-list (point-spectrum p))]) (* x (+ l 1.0)))))
  (define (located test) (location e a b s test))
  (define (changes? test) (< (* (test a) (test b)) 0.0))
  (define crossing (and (changes? crossing-test) (located crossing-test)))
  (define fold (and (changes? fold-test) (located fold-test)))
  (define doubling (and orbit? (changes? doubling-test) (located doubling-test)))
  (define oscillation (oscillation-test orbit? a b))
  (define all
    (list (and crossing (crossing-found e crossing (point-tangent a)))
          (and fold (not (and crossing (same-place? crossing fold))) (found 'fold fold #f))
          (and doubling (found 'period-doubling doubling #f))
          (and oscillation
               (let ([p (located oscillation)])
                 (and p (found (oscillation-kind orbit? p) p #f))))))
  (define (place f) (dot (point-tangent a) (difference (point-x (found-at f)) (point-x a))))
  (sort (filter values all) < #:key place))

(define (last-part p)
  (define t (point-tangent p))
  (flvector-ref t (- (flvector-length t) 1)))

(define crossing-test point-determinant)

(define (same-place? p q) (< (distance (point-x p) (point-x q)) 1e-4))

;; The point between a and b, at the distance s, where the test changes its sign.  Close to a
;; crossing the equations have nearly no inverse: Newton's method begins on the cubic through the
;; nearest points on both sides, which is taken for the curve where rounding leaves no point.
(define (location e a b s test)
  (define-values (low low-r high high-r) (values a 0.0 b s))
  (let/ec return
    (define (at r)
      (define inside? (< low-r r high-r))
      (define guess (and inside? (between e a low low-r high high-r r)))
      (define-values (p _)
        (if inside?
            (point-along e a r (point-tangent a) guess)
            (point-along e a r)))
      (unless p (return (if inside? (point-there e a guess) low)))
      (when inside?
        (if (< (* (test p) (test a)) 0.0)
            (set!-values (high high-r) (values p r))
            (set!-values (low low-r) (values p r))))
      p)
    (define (value r)
      (cond [(= r 0.0) (test a)] [(= r s) (test b)] [else (test (at r))]))
    (define-values (r _error _count)
      (bracketed-root value 0.0 s #:tolerance 1e-11 #:jump void))
    (at r)))

(define (point-there e a x)
  (point-at e x ((equations-evaluate e) x (point-x a)) (point-tangent a)))

;; On the cubic from the point p to q, with their tangents, which are at p-r and q-r along that of a
(define (between e a p p-r q q-r r)
  (define length (fl- q-r p-r))
  (define h (fl/ (fl- r p-r) length))
  (define (change p)
    (define t (point-tangent p))
    (flvector-map fl* (equations-scales e)
                  (flvector-scaled (fl/ length (dot t (point-tangent a))) t)))
  (define step (difference (point-x q) (point-x p)))
  (define-values (early late) (values (difference (change p) step) (difference (change q) step)))
  (define bend (along (flvector-scaled (fl- 1.0 h) early) (fl- 0.0 h) late))
  (along (along (point-x p) h step) (fl* h (fl- 1.0 h)) bend))

;; ---------------------------------------------------------------------------
;; Oscillations

;; -> a test that changes its sign between a and b where an oscillation begins to grow; #f if none
(define (oscillation-test orbit? a b)
  (define (growing-pairs p)
    (growing orbit? (filter complex? (point-spectrum p))))
  (define (nearest p)
    (define pairs (filter complex? (point-spectrum p)))
    (if (null? pairs) 0.0 (argmin abs (map (lambda (l) (growth orbit? l)) pairs))))
  (define-values (before after) (values (growing-pairs a) (growing-pairs b)))
  (define pairs-kept? (= (count complex? (point-spectrum a)) (count complex? (point-spectrum b))))
  (cond [(or (= before after) (not pairs-kept?)) #f]
        [(< (* (nearest a) (nearest b)) (- (* growth-tolerance growth-tolerance))) nearest]
        [else (lambda (p) (- (growing-pairs p) (* 0.5 (+ before after))))]))

;; Where no energy is lost each growth has its opposite.
(define (oscillation-kind orbit? p)
  (define growths (map (lambda (l) (growth orbit? l)) (filter complex? (point-spectrum p))))
  (define together (count (lambda (g) (< (abs g) 1e-3)) growths))
  (cond [(>= together 4) 'Krein-collision] [orbit? 'torus] [else 'Hopf]))

;; ---------------------------------------------------------------------------
;; Crossings

;; The tangents of both branches at a crossing p: first of the one that is nearer to `way`.  There J
;; has two null vectors, the tangent t and v, and with t as a row a left one u.  To second order
;; x + α t + β v is on a branch where
;;
;;     A α² + 2 B α β + C β² = 0,   A = u·J'[t] t,   B = u·J'[v] t,   C = u·J'[v] v
;;
;; (Kuznetsov, 10.3).
(define (crossing-directions e p way)
  (define t (point-tangent p))
  (define-values (us _sizes vs) (singular-values (columns-of (bordered (point-slopes p) t))))
  (define-values (u v) (values (last us) (last vs)))
  (define (form along-v w)
    (define change (rows-times (slope-change e p along-v) w))
    (for/fold ([sum 0.0]) ([a (in-flvector change)] [b (in-flvector u)]) (fl+ sum (fl* a b))))
  (define pairs (quadratic-roots (form t t) (form v t) (form v v)))
  (define directions
    (for/list ([ab (in-list pairs)])
      (define d (along (flvector-scaled (car ab) t) (cdr ab) v))
      (flvector-scaled (fl/ 1.0 (norm d)) d)))
  (apply values (sort directions > #:key (lambda (d) (flabs (dot d way))))))

;; The change of the matrix along w
(define (slope-change e p w)
  (define h 1e-4)
  (define (slopes-at s)
    (define x (along (point-x p) s (flvector-map fl* w (equations-scales e))))
    (scaled-rows e (evaluated-slopes ((equations-evaluate e) x (point-x p)))))
  (rows-combine (lambda (a b) (/ (- a b) (* 2.0 h))) (slopes-at h) (slopes-at (- h))))

;; Both ratios α : β, as pairs; those of the axes where there is none
(define (quadratic-roots A B C)
  (define square (- (* B B) (* A C)))
  (define root (flsqrt (flmax 0.0 square)))
  (define q (- (+ B (if (< B 0.0) (- root) root))))
  (if (fl> square 0.0) (list (cons q A) (cons C q)) (list (cons 1.0 0.0) (cons 0.0 1.0))))

;; At a pitchfork one branch has the parameter turned back.
(define (crossing-found e p way)
  (define-values (own other) (crossing-directions e p way))
  (define (turned? t) (< (abs (flvector-ref t (- (flvector-length t) 1))) 1e-2))
  (found (if (or (turned? other) (turned? own)) 'pitchfork 'transcritical)
         (struct-copy point p [tangent own]) other))
