#lang racket/base
;; Roots of exact quadratics and eigenvalues of exact matrices lost their digits in a difference,
;; of which decimals took care: 0.0 for the root 10⁻⁹ of x² − 10⁹x + 1.  Eigenvectors of exact
;; matrices were missing where rounding left no zero.

(require mechanics "../support/checks.rkt" "../support/messages.rkt")

(define-check (check-near given expected)
  (unless (and (= (length given) (length expected))
               (for/and ([x given] [y expected]) (<= (magnitude (- x y)) (* 4e-16 (magnitude y)))))
    (with-check-info (['given given] ['expected expected]) (fail-check))))

(define (roots b c) (polynomial-roots (+ (square 'x) (* b 'x) c) 'x))

(test-case "roots of unlike sizes"
  (check-near (roots -1000000000 1) '(1e9 1e-9))
  (check-near (roots -100000000 1) '(99999999.99999999 1e-8))
  (check-near (roots 1000000000 1) '(-1e-9 -1e9))
  (check-near (roots -1e9 1) '(1e9 1e-9))
  (check-near (roots (expt 10 20) -3) '(3e-20 -1e20))
  (check-near (roots 1/1000000000000 -1) '(0.9999999999995 -1.0000000000005))
  (check-near (roots (expt 10 200) (expt 10 20)) '(-1e-180 -1e200)))

(test-case "of rational numbers they are rational"
  (check-equal? (roots -3 2) '(2 1))
  (check-equal? (roots (- (expt 10 30) (/ 1 (expt 10 30))) -1)
                (list (/ 1 (expt 10 30)) (- (expt 10 30))))
  (check-equal? (roots 2 2) '(-1+1i -1-1i)))

(define (rows . entries) (matrix-by-rows (list (car entries) (cadr entries)) (cddr entries)))

(test-case "eigenvalues of unlike sizes"
  (check-near (eigenvalues (rows 1 1000000 1000000 1000000000001))
              '(1000000000002.0 9.99999999998e-13))
  (check-near (eigenvalues (rows 1.0 1e6 1e6 1000000000001.0)) '(1000000000002.0 9.99999999998e-13))
  (check-near (eigenvalues (rows -1 1/3 1/3 (/ 1 (expt 10 15))))
              (list 0.10092521257733246 -1.1009252125773314)))

;; Is m v = λ v, each component to rounding of the terms of its sum?
(define-check (check-vectors m counts)
  (define found (eigenvectors m))
  (check-equal? (map length (map cdr found)) counts)
  (for* ([entry found] [v (cdr entry)])
    (for ([x (up->list v)] [i (in-naturals)])
      (define terms (for/list ([y (up->list v)] [j (in-naturals)]) (* (matrix-ref m i j) y)))
      (check-true (<= (magnitude (- (apply + terms) (* (car entry) x)))
                      (* 1e-15 (apply + (map magnitude terms))))
                  (format "~a" entry)))))

(define (up->list v) (for/list ([i (s:length v)]) (ref v i)))

(test-case "each irrational eigenvalue has its vectors"
  (check-vectors (rows 1 10 10 10001) '(1 1))
  (check-vectors (rows 0 -1 1 1000) '(1 1))
  (check-vectors (rows 0 -3 1 1) '(1 1))
  (check-vectors (rows 1 1000000000 1 1000000001) '(1 1))
  (check-vectors (matrix-by-rows '(1 2 0) '(3 4 0) '(5 6 7)) '(1 1 1))
  (check-vectors (matrix-by-rows '(1 10 0 0) '(10 10001 0 0) '(0 0 1 10) '(0 0 10 10001)) '(2 2))
  (check-vectors (matrix-by-rows '(0 2 1 0) '(1 0 0 0) '(0 0 0 2) '(0 0 1 0)) '(1 1)))

(test-case "what is beyond decimals is refused"
  (check-message "polynomial-roots: there are values beyond 1.8e308, where decimals end"
                 (roots (expt 10 400) 1))
  (check-message "eigenvalues: there are values beyond 1.8e308, where decimals end"
                 (eigenvalues (rows 0 (expt 10 801) 1 0)))
  (check-message "polynomial-roots: there are roots beyond 1.8e308 or next to 0, where decimals end"
                 (polynomial-roots (+ (* 1e-200 (square 'x)) (* -1e200 'x) 1) 'x)))
