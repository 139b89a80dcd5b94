#lang mechanics
;; Exercise 2.19 (SICM 2.12): the product of quaternions
;; Checked: real part and vector of a product, in terms of those of its factors
;; How: by i² = j² = k² = ijk = −1 alone, against the product of the library

;; Show that q p has the real part q₀ p₀ − q · p and the vector q₀ p + p₀ q + q × p.

;; A quaternion as a sum of units: a list of factors of 1, i, j and k.
(define-values (p q) (values '(p_0 p_1 p_2 p_3) '(q_0 q_1 q_2 q_3)))

;; From i² = j² = k² = ijk = −1: ij = k, since ijk = −1 = k²; jk = i, since i (jk) = −1 = i²; so
;; j = −i k as i j = k, and ik = −j; kj = −i as jk = i; and ji = −k, ki = j likewise.
;; The unit of the product of two units, and its sign:
(define products
  '(((0 . 1) (1 . 1) (2 . 1) (3 . 1))
    ((1 . 1) (0 . -1) (3 . 1) (2 . -1))
    ((2 . 1) (3 . -1) (0 . -1) (1 . 1))
    ((3 . 1) (2 . 1) (1 . -1) (0 . -1))))
(define (times a b)
  (for/list ([unit 4])
    (for*/fold ([sum 0]) ([i 4] [j 4])
      (define entry (list-ref (list-ref products i) j))
      (if (= (car entry) unit)
          (+ sum (* (cdr entry) (list-ref a i) (list-ref b j)))
          sum))))

;; An attempt, and the slip: the cross product in the order in which one rotates.
(define (parts cross)
  (define-values (v w) (values (apply up (cdr q)) (apply up (cdr p))))
  (up (- (* 'q_0 'p_0) (dot-product v w))
      (+ (* 'q_0 w) (* 'p_0 v) (cross v w))))
(define product (up (car (times q p)) (apply up (cdr (times q p)))))
(define right (verify-equal product (parts cross-product)))
right
(define wrong (verify-equal product (parts (lambda (v w) (cross-product w v)))))
(verdict-status wrong)
(verdict-residual wrong)

;; The library has the same product, and its units the same table; and matrices of rotations
;; multiply as their quaternions do.
(define same (verify-equal (quaternion->vector (* (make-quaternion q) (make-quaternion p)))
                           (apply up (times q p))))
same
(define M quaternion->rotation-matrix)
(define rotations
  (verify-equal (M (make-quaternion (times q p)))
                (* (M (make-quaternion q)) (M (make-quaternion p)))))
rotations

;; The slip is none for rotations about one axis, nor for half turns about axes at right angles.
(define-values (half-x half-y) (values '(0 1 0 0) '(0 0 1 0)))
(define half-turns (verify-equal (M (make-quaternion (times half-x half-y)))
                                 (M (make-quaternion (times half-y half-x)))))
half-turns

(module+ test
  (require rackunit)
  (test-case "real part and vector; the library's product; matrices"
    (for ([v (list right same rotations)]) (check-pred proved? v)))
  (test-case "the order matters, except where it does not"
    (check-pred refuted? wrong)
    (check-equal? (ref (verdict-residual wrong) 0) 0)
    (check-pred proved? half-turns))
  (test-case "the table says i² = j² = k² = ijk = −1"
    (define-values (i j k) (values '(0 1 0 0) '(0 0 1 0) '(0 0 0 1)))
    (for ([x (list (times i i) (times j j) (times k k) (times (times i j) k))])
      (check-equal? x '(-1 0 0 0)))))
