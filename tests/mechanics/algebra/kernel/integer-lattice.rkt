#lang racket/base
;; Lattice bases: every vector is an integer combination of the basis.

(require mechanics/algebra/kernel/integer-lattice "../../support/checks.rkt")

(define (combination basis coordinates)
  (for/fold ([sum '()]) ([entry (in-list coordinates)])
    (vector-add sum (vector-scale (cdr entry) (list-ref basis (car entry))))))

(define (check-basis vectors)
  (define-values (basis coordinates) (integer-basis vectors))
  (for ([v (in-list vectors)] [c (in-list coordinates)])
    (check-true (for/and ([entry (in-list c)]) (exact-integer? (cdr entry))))
    (check-equal? (combination basis c) v))
  basis)

(define theta '((0 . 1)))
(define phi '((1 . 1)))
(define half '((0 . 1/2)))
(define difference '((0 . 1) (1 . -1)))

(test-case "independent vectors are their own basis"
  (check-equal? (check-basis (list theta phi)) (list theta phi))
  (check-equal? (check-basis (list difference)) (list difference)))

(test-case "dependent vectors are written by earlier ones"
  (check-equal? (check-basis (list theta phi difference)) (list theta phi))
  (check-equal? (check-basis (list theta '((0 . 3)))) (list theta)))

(test-case "fractions refine the basis"
  (check-equal? (check-basis (list theta half)) (list half))
  (check-equal? (length (check-basis (list difference (vector-scale 1/2 difference) theta))) 2)
  (define multiples (list (vector-scale 2 difference) (vector-scale 3 difference)))
  (check-equal? (length (check-basis multiples)) 1))

;; Sparse, with few dimensions among more atoms, so that coordinates of any kind occur.
(define (random-combination generators)
  (for/fold ([v '()]) ([g (in-list generators)])
    (vector-add v (vector-scale (* 1/6 (- (random 13) 6)) g))))

(test-case "any vectors are integer combinations of their basis, whose coordinates are sparse"
  (random-seed 43)
  (for ([_ (in-range 60)])
    (define generators
      (list (list (cons 0 1) (cons 2 (+ 1 (random 3))) (cons 4 -1)) '((1 . 2) (2 . 1) (3 . 5))))
    (define vectors (for/list ([_ (in-range 5)]) (random-combination generators)))
    (check-basis vectors)
    (define-values (basis coordinates) (integer-basis vectors))
    (for* ([c (in-list coordinates)] [entry (in-list c)]) (check-not-equal? (cdr entry) 0))))

(test-case "a basis by atoms does not depend on the combinations given"
  (define (basis-of . vectors)
    (define-values (basis coordinates) (modest-basis/atoms vectors 1000))
    (for ([v (in-list vectors)] [c (in-list coordinates)])
      (check-equal? (combination basis c) v))
    basis)
  (check-equal? (basis-of difference) (list theta (vector-scale -1 phi)))
  (check-equal? (basis-of half difference) (list half (vector-scale -1 phi)))
  (check-equal? (basis-of '((0 . 2/3)) '((0 . 1/2) (1 . 1))) (list '((0 . 1/6)) phi))
  (check-equal? (length (basis-of '((0 . 1)) '((0 . 100001/100000)))) 2))
