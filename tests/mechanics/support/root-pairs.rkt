#lang racket/base
;; Pairs of numbers made of roots, as people write them in exercises and answers, that are equal;
;; and for each pair neighbours that are not.

(provide equal-pairs false-neighbours)

(define phi '(/ (+ 1 (sqrt 5)) 2))

;; ((left right) ...)
(define equal-pairs
  `(;; square roots of fractions
    ((sqrt 12) (* 2 (sqrt 3)))
    ((sqrt 8) (* 2 (sqrt 2)))
    ((sqrt 450) (* 15 (sqrt 2)))
    ((sqrt 1/2) (/ (sqrt 2) 2))
    ((sqrt 3/4) (/ (sqrt 3) 2))
    ((sqrt 8/27) (* 2/9 (sqrt 6)))
    ((/ 1 (sqrt 2)) (/ (sqrt 2) 2))
    ((/ 6 (sqrt 3)) (* 2 (sqrt 3)))
    ((/ (sqrt 6) (sqrt 2)) (sqrt 3))
    ((* (sqrt 2) (sqrt 3)) (sqrt 6))
    ((* (sqrt 2) (sqrt 8)) 4)
    ((* (sqrt 6) (sqrt 10) (sqrt 15)) 30)
    ((- (sqrt 2)) (/ -2 (sqrt 2)))
    ;; powers
    ((expt 4 -1/2) 1/2)
    ((expt 9 3/2) 27)
    ((expt 2 3/2) (* 2 (sqrt 2)))
    ((expt 2 -3/2) (/ (sqrt 2) 4))
    ((expt 16 3/4) 8)
    ((expt 32 2/5) 4)
    ((expt (sqrt 2) 4) 4)
    ((expt (sqrt 2) -3) (/ (sqrt 2) 4))
    ((sqrt (sqrt 2)) (expt 2 1/4))
    ((sqrt (expt 2 1/3)) (expt 2 1/6))
    ((* (sqrt 2) (expt 2 1/3)) (expt 2 5/6))
    ((expt 12 1/4) (sqrt (* 2 (sqrt 3))))
    ;; sums
    ((+ (sqrt 2) (sqrt 8)) (sqrt 18))
    ((- (sqrt 27) (sqrt 12)) (sqrt 3))
    ((+ (sqrt 2) (sqrt 8) (sqrt 18)) (* 6 (sqrt 2)))
    ((- (sqrt 50) (sqrt 32) (sqrt 2)) 0)
    ((+ (sqrt 1/2) (sqrt 2)) (* 3 (sqrt 1/2)))
    ;; products of sums
    ((expt (+ 1 (sqrt 2)) 2) (+ 3 (* 2 (sqrt 2))))
    ((expt (+ 1 (sqrt 2)) 3) (+ 7 (* 5 (sqrt 2))))
    ((expt (+ (sqrt 2) (sqrt 3)) 4) (+ 49 (* 20 (sqrt 6))))
    ((* (+ (sqrt 5) (sqrt 3)) (- (sqrt 5) (sqrt 3))) 2)
    ((* (+ 1 (sqrt 2) (sqrt 3)) (- (+ 1 (sqrt 2)) (sqrt 3))) (* 2 (sqrt 2)))
    ;; denominators
    ((/ 1 (+ 1 (sqrt 2))) (- (sqrt 2) 1))
    ((/ 1 (- (sqrt 3) (sqrt 2))) (+ (sqrt 3) (sqrt 2)))
    ((/ (+ 1 (sqrt 5)) (- 1 (sqrt 5))) (- -3/2 (/ (sqrt 5) 2)))
    ((/ (- 2 (sqrt 3)) (+ 2 (sqrt 3))) (- 7 (* 4 (sqrt 3))))
    ((/ 1 (+ 1 (sqrt 2) (sqrt 3))) (/ (- (+ 2 (sqrt 2)) (sqrt 6)) 4))
    ((/ 2 (+ (sqrt 2) (sqrt 3) (sqrt 5))) (+ (/ (sqrt 2) 2) (/ (sqrt 3) 3) (* -1/6 (sqrt 30))))
    ;; golden ratios
    ((* ,phi ,phi) (+ ,phi 1))
    ((/ 1 ,phi) (- ,phi 1))
    ((expt ,phi 5) (/ (+ 11 (* 5 (sqrt 5))) 2))
    ((+ (expt ,phi 4) (expt ,phi -4)) 7)
    ((sqrt (+ 1 ,phi)) ,phi)
    ;; roots within roots
    ((sqrt (+ 3 (* 2 (sqrt 2)))) (+ 1 (sqrt 2)))
    ((sqrt (- 3 (* 2 (sqrt 2)))) (- (sqrt 2) 1))
    ((sqrt (+ 4 (* 2 (sqrt 3)))) (+ 1 (sqrt 3)))
    ((sqrt (- 4 (* 2 (sqrt 3)))) (- (sqrt 3) 1))
    ((sqrt (+ 11 (* 6 (sqrt 2)))) (+ 3 (sqrt 2)))
    ((sqrt (+ 2 (sqrt 3))) (/ (+ (sqrt 6) (sqrt 2)) 2))
    ((sqrt (- 2 (sqrt 3))) (/ (- (sqrt 6) (sqrt 2)) 2))
    ((sqrt (+ 5 (* 2 (sqrt 6)))) (+ (sqrt 2) (sqrt 3)))
    ((sqrt (- 9 (* 4 (sqrt 5)))) (- (sqrt 5) 2))
    ((sqrt (+ 12 (* 2 (sqrt 35)))) (+ (sqrt 5) (sqrt 7)))
    ((sqrt (+ 3 (sqrt 5))) (/ (+ (sqrt 10) (sqrt 2)) 2))
    ((sqrt (+ 1 (/ (sqrt 3) 2))) (/ (+ 1 (sqrt 3)) 2))
    ((sqrt (+ 4 (* 3 (sqrt 2)))) (* (expt 2 1/4) (+ 1 (sqrt 2))))
    ((sqrt (+ 10 (sqrt 24) (sqrt 40) (sqrt 60))) (+ (sqrt 2) (sqrt 3) (sqrt 5)))
    ((+ (sqrt (+ 2 (sqrt 3))) (sqrt (- 2 (sqrt 3)))) (sqrt 6))
    ((- (sqrt (+ 3 (* 2 (sqrt 2)))) (sqrt (- 3 (* 2 (sqrt 2))))) 2)
    ((sqrt (sqrt (+ 17 (* 12 (sqrt 2))))) (+ 1 (sqrt 2)))
    ((expt (- 19601 (* 13860 (sqrt 2))) 7/4) (expt (- (* 5 (sqrt 2)) 7) 7))
    ;; cube roots and others
    ((* (expt 2 1/3) (expt 4 1/3)) 2)
    ((expt 54 1/3) (* 3 (expt 2 1/3)))
    ((/ 1 (expt 2 1/3)) (/ (expt 4 1/3) 2))
    ((/ 1 (+ 1 (expt 2 1/3))) (/ (+ 1 (- (expt 2 1/3)) (expt 4 1/3)) 3))
    ((expt (- (expt 2 1/3) 1) 3) (+ 1 (* 3 (expt 2 1/3)) (* -3 (expt 4 1/3))))
    ((expt (+ 7 (* 5 (sqrt 2))) 1/3) (+ 1 (sqrt 2)))
    ((expt (+ 2 (sqrt 5)) 1/3) ,phi)
    ((expt (- (sqrt 5) 2) 1/3) (- ,phi 1))
    ((- (expt (+ 2 (sqrt 5)) 1/3) (expt (- (sqrt 5) 2) 1/3)) 1)
    ((expt (+ 9 (* 4 (sqrt 5))) 1/3) (+ 1 ,phi))
    ((expt (+ 26 (* 15 (sqrt 3))) 2/3) (+ 7 (* 4 (sqrt 3))))
    ((expt (+ 10 (* 6 (sqrt 3))) 1/3) (+ 1 (sqrt 3)))
    ((+ (expt (+ 20 (* 14 (sqrt 2))) 1/3) (expt (- 20 (* 14 (sqrt 2))) 1/3)) 4)
    ((expt (+ 41 (* 29 (sqrt 2))) -1/5) (- (sqrt 2) 1))))

;; Of a datum: the same with one of its whole numbers greater by one, for each of them.
(define (changed-by-one datum)
  (cond [(and (exact-integer? datum) (> datum 0)) (list (+ datum 1))]
        [(pair? datum)
         (for*/list ([i (in-range 1 (length datum))]
                     [new (in-list (changed-by-one (list-ref datum i)))])
           (for/list ([part (in-list datum)] [k (in-naturals)]) (if (= k i) new part)))]
        [else '()]))

;; -> ((left wrong-right) ...)
(define false-neighbours
  (for*/list ([pair (in-list equal-pairs)] [wrong (in-list (changed-by-one (cadr pair)))])
    (list (car pair) wrong)))
