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
         "../../numeric/linear-algebra/row-matrix.rkt" "../../numeric/linear-algebra/singular-values.rkt"
         "../../numeric/optimization/brent-root.rkt")

(provide (struct-out found) points-between growing crossing-direction)

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
    (list (and crossing (crossing-found e crossing))
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

;; The point between a and b where the test changes its sign; #f where it is not found
(define (location e a b s test)
  (let/ec return
    (define (at r)
      (define-values (p _) (point-along e a r))
      (or p (return #f)))
    (define (value r) (cond [(= r 0.0) (test a)] [(= r s) (test b)] [else (test (at r))]))
    (define-values (r _error _count)
      (bracketed-root value 0.0 s #:tolerance 1e-11 #:jump void))
    (at r)))

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

;; The tangent of the other branch at a crossing p, where J and the tangent t have a null vector
;; v, and a left one u.  To second order x + α t + β v is on a branch where
;; β (2 b α + c β) = 0, with b = u·J'[v] t and c = u·J'[v] v (Kuznetsov, 10.3).
(define (crossing-direction e p)
  (define t (point-tangent p))
  (define-values (us _sizes vs) (singular-values (columns-of (bordered (point-slopes p) t))))
  (define-values (u v) (values (last us) (last vs)))
  (define h 1e-4)
  (define (slopes-at s)
    (define x (along (point-x p) s (flvector-map fl* v (equations-scales e))))
    (scaled-rows e (evaluated-slopes ((equations-evaluate e) x (point-x p)))))
  (define change
    (rows-combine (lambda (a b) (/ (- a b) (* 2.0 h))) (slopes-at h) (slopes-at (- h))))
  (define (form w)
    (for/sum ([row (in-vector change)] [y (in-flvector u)])
      (* y (for/sum ([a (in-vector row)] [x (in-flvector w)]) (* a x)))))
  (define-values (b c) (values (form t) (form v)))
  (define size (max (abs b) (abs c) 1e-300))
  (define d (along (flvector-scaled (/ c size) t) (/ (* -2.0 b) size) v))
  (flvector-scaled (fl/ 1.0 (norm d)) d))

;; At a pitchfork one branch has the parameter turned back.
(define (crossing-found e p)
  (define other (crossing-direction e p))
  (define (turned? t) (< (abs (flvector-ref t (- (flvector-length t) 1))) 1e-2))
  (found (if (or (turned? other) (turned? (point-tangent p))) 'pitchfork 'transcritical) p other))
