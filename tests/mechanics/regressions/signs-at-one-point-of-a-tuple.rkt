#lang racket/base
;; The components of a tuple took their signs each at a point of its own: what was assumed
;; of one contradicted what was assumed of another.

(require mechanics
         (only-in mechanics/value/simplify simplify/assumptions)
         (only-in mechanics/algebra/assumption/reference-point find-reference)
         (only-in mechanics/algebra/assumption/assumption-set no-assumptions)
         "../support/checks.rkt")

(define (assumed x)
  (forget-assumptions)
  (define-values (simple assumptions) (simplify/assumptions x))
  (forget-assumptions)
  assumptions)

(define (root-of-square x) (sqrt (square x)))
(define beyond (sqrt (- -1 (* 'x 'y))))

(test-case "the last component has a value only where x and y have different signs"
  (define all (assumed (up (root-of-square 'y) (root-of-square 'x)
                           (* (root-of-square 'y) (root-of-square 'x) beyond))))
  (check-equal? all '((<= y 0) (>= x 0))))

(test-case "so do the rows of a matrix, and what is shown"
  (check-equal? (assumed (matrix-by-rows (list (root-of-square 'y) (root-of-square 'x))
                                         (list (* (root-of-square 'y) beyond) 0)))
                '((<= y 0) (>= x 0)))
  (check-equal? (expression (assuming () (up (root-of-square 'y) (* (root-of-square 'x) beyond))))
                '(up (* -1 y) (* x (sqrt (- -1 (* x y))))))
  (forget-assumptions))

(test-case "a verdict on a tuple assumes what holds at one point"
  (define v (prove-zero (up (+ (root-of-square 'y) 'y)
                            (- (root-of-square 'x) 'x)
                            (* (+ (* (root-of-square 'y) (root-of-square 'x)) (* 'x 'y))
                               beyond))))
  (check-pred proved? v)
  (check-equal? (verdict-assumptions v) '((<= y 0) (>= x 0))))

;; Products of roots of squares, with factors that have a value in a part of the plane only.
(define symbols '(x y z))
(define (any xs) (list-ref xs (random (length xs))))
(define (random-component)
  (define (linear) (* (any '(1 -1)) (+ (any symbols) (* (any '(0 1 -1 2)) (any symbols)))))
  (define u (linear))
  (* (if (eqv? u 0) 1 (root-of-square u))
     (root-of-square (any symbols))
     (if (zero? (random 2)) (sqrt (- (any '(0 -1 -2)) (* (any symbols) (linear)))) 1)))

(define (opposite d) (cons (if (eq? (car d) '>=) '<= '>=) (cdr d)))

(test-case "no assumption of a random tuple is the opposite of another, or cannot hold with them"
  (random-seed 5)
  (define compared 0)
  (for ([_ (in-range 60)])
    (define components (list (random-component) (random-component) (random-component)))
    (when (find-reference components no-assumptions)
      (set! compared (+ compared 1))
      (define all (assumed (apply up components)))
      (for ([d all]) (check-false (member (opposite d) all) (format "~s: ~s" components all)))
      (check-not-exn (lambda () (assuming () (apply assume all)))
                     (format "~s: ~s" components all))))
  (check-true (> compared 30)))
