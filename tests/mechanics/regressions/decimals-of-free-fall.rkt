#lang racket/base
;; A body falls 4.9 t² where g is 9.8: that was undecided, as decimals alone prove nothing.  They
;; are read as they were written, if they are short.

(require mechanics
         "../support/checks.rkt")

(define ((L-falling g) (up t x v)) (- (* 1/2 (square v)) (* g x)))
(define ((falling half-g) t) (- 10 (* half-g (square t))))
(define (lines v) (regexp-split #rx"\n" (format "~a" v)))

(define-check (check-read v readings)
  (with-check-info (['verdict v])
    (unless (and (proved? v) (equal? (format "~s" (verdict-readings v)) (format "~s" readings)))
      (fail-check))))

(test-case "free fall"
  (check-read (verify-solution (L-falling 9.8) (falling 4.9)) '((4.9 49/10) (9.8 49/5)))
  (check-pred refuted? (verify-solution (L-falling 9.8) (falling 4.8)))
  (check-equal? (lines (verify-solution (L-falling 9.8) (falling 4.9)))
                '("proved: the residual is zero" "  reading: 4.9 as 49/10"
                  "  reading: 9.8 as 49/5")))

(test-case "relatives: a Hamiltonian, a conserved quantity, a symplectic matrix"
  (define ((H g) (up t x p)) (+ (/ (square p) 2) (* g x)))
  (check-pred proved? (verify-Hamiltonian-solution (H 9.8) (falling 4.9)
                                                   (lambda (t) (* -9.8 t))))
  (check-pred proved? (verify-conserved (L-falling 9.8)
                                        (lambda ((up t x v)) (+ v (* 9.8 t)))
                                        (up 't 'x 'v)))
  (check-pred proved? (verify-symplectic (matrix-by-rows '(2.0 0) '(0 0.5))))
  (check-pred proved? (verify-symplectic (matrix-by-rows '(0.6 0.8) '(-0.8 0.6))))
  (check-pred refuted? (verify-symplectic (matrix-by-rows '(2.0 0) '(0 0.6)))))

(test-case "what was rounded is not read"
  (define rounded (* (sqrt 2) (tanh 20)))
  (check-pred undecided? (verify-equal rounded (sqrt 2)))
  (check-pred undecided? (verify-solution (L-falling rounded) (falling (/ (sqrt 2) 2))))
  (check-pred undecided? (verify-solution (L-falling (+ 0.1 0.2)) (falling (/ (+ 0.1 0.2) 2))))
  (check-pred undecided? (verify-symplectic (matrix-by-rows (list (sqrt 2.0) 0)
                                                            (list 0 (/ 1 (sqrt 2.0))))))
  (check-pred undecided? (verify-equal 0.5 1/2)))

(test-case "the report says why decimals that cancel prove nothing, and what to type"
  (check-equal? (lines (prove-zero 0.0))
                '("undecided: the residual is neither proved nor refuted to be zero"
                  "  residual: 0"
                  "  evidence: decimals cancel, and decimals are rounded numbers"
                  "  note: exact numbers would tell: 49/5 for 9.8, ':pi for π, (sqrt 2) for the root of 2"))
  (check-regexp-match #rx"tell, [(]sqrt 8[)] for 2.828"
                      (format "~a" (verify-equal (sqrt 8.0) (* 2 (sqrt 2.0)))))
  (check-pred proved? (verify-equal (sqrt 8) (* 2 (sqrt 2)))))
