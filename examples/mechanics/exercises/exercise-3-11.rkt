#lang mechanics
;; Exercise 3.11 (SICM 3.8): determinants and traces
;; Checked: that det (I + εA) is 1 + ε tr A to first order, and what that says of volumes
;; How: with symbols, by D at ε = 0; along a motion, the determinant against the trace's integral

;; A matrix of any entries, of 2 and of 3 rows; its determinant is that of the library.
(define (any n)
  (apply matrix-by-rows
         (for/list ([i n]) (for/list ([j n]) (string->symbol (format "a_~a~a" i j))))))
(define (entry A i j) (ref A i j))
(define (trace A n) (for/sum ([k n]) (entry A k k)))
(define (identity-and epsilon A n)
  (apply matrix-by-rows
         (for/list ([i n])
           (for/list ([j n]) (+ (if (= i j) 1 0) (* epsilon (entry A i j)))))))

(define (first-order n)
  ((D (lambda (epsilon) (determinant (identity-and epsilon (any n) n)))) 0))
(simplify (first-order 2))

;; An attempt, and a slip that takes all entries for those of the diagonal.
(define (attempt n) (verify-equal (first-order n) (trace (any n) n)))
(define (slip n)
  (verify-equal (first-order n) (for*/sum ([i n] [j n]) (entry (any n) i j))))
(attempt 2)
(attempt 3)

;; So volumes grow at the rate of the trace.  Of a damped oscillator, x'' = −x − c x', the trace
;; is −c whatever the state: an area shrinks as exp(−ct).  Of a Hamiltonian system it is 0.
(define ((damped c) (up t x v)) (up 1 v (- (* -1 x) (* c v))))
(define (area-after c t)
  (define J ((linearized-flow (lambda () (damped c))) (up 0. 1. 0.) t 1e-12))
  (- (* (ref J 1 1) (ref J 2 2)) (* (ref J 1 2) (ref J 2 1))))
(list (area-after 0.2 3.) (exp (* -0.2 3.)))

(module+ test
  (require rackunit)
  (test-case "to first order the determinant is the trace"
    (for ([n '(2 3 4)])
      (check-pred proved? (attempt n))
      (check-pred refuted? (slip n))))
  (test-case "areas of phase space along a motion"
    (check-= (area-after 0.2 3.) (exp -0.6) 1e-10)
    (check-= (area-after 0. 3.) 1 1e-10)))
