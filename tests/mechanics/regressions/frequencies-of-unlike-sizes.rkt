#lang racket/base
;; Slow modes beside fast ones were 0 without a word, though all numbers were exact; an imaginary
;; frequency, too.  Independent values are eigenvalues to 60 digits.

(require mechanics
         "../support/checks.rkt" "../support/notes.rkt")

;; Masses of 1 in a row, between springs of these stiffnesses; the last one ends at a wall.
(define ((L-chain . stiffnesses) s)
  (define-values (q v) (values (coordinate s) (velocity s)))
  (define n (length stiffnesses))
  (define stretched
    (for/list ([i n]) (- (ref q i) (if (= i (- n 1)) 0 (ref q (+ i 1))))))
  (- (* 1/2 (square v))
     (* 1/2 (apply + (for/list ([k stiffnesses] [x stretched]) (* k (square x)))))))

(define (frequencies . stiffnesses)
  (small-oscillation-frequencies (apply L-chain stiffnesses)
                                 (apply up (map (lambda (_) 0) stiffnesses))))

(define-check (check-near given expected)
  (unless (and (= (length given) (length expected))
               (for/and ([x given] [y expected]) (<= (magnitude (- x y)) (* 1e-15 (magnitude y)))))
    (with-check-info (['given given] ['expected expected]) (fail-check))))

(define (ten k) (expt 10 k))

(test-case "of exact numbers all are found"
  (check-equal?
   (told
    (check-near (frequencies (ten 6) 1 (ten -8))
                '(5.7735026790662485e-5 1.2247447210200496 1414.2137391499119)))
   "")
  (check-near (frequencies (ten 16) 1 (ten -8))
              '(5.7735026790662517e-5 1.2247448741132443 141421356.23730951))
  (check-near (frequencies (ten 12) (ten -12) (ten 12) (ten -20))
              '(4.99999999375e-11 1.00000000125e-6 1414213.562373095 1414213.562373095)))

(test-case "an imaginary one is told"
  (define found #f)
  (check-regexp-match
   #rx"a frequency that is not real belongs to no oscillation: this one grows as"
   (told (set! found (frequencies (ten 12) (- (ten -12)) (ten 12) (ten -20)))))
  (check-near found '(+9.9999999875e-7i 5.00000000625e-11 1414213.562373095 1414213.562373095))
  (check-regexp-match
   #rx"this one grows as \\(exp \\(\\* 0.000707106781186[0-9]* t\\)\\); the equilibrium is unstable"
   (told (frequencies (ten 10) (- (ten -6))))))

(test-case "so are shapes"
  (define modes (normal-modes (L-chain (ten 16) 1 (ten -8)) (up 0 0 0)))
  (define shapes (map (lambda (m) (ref m 1)) modes))
  (check-within (ref (car shapes) 2) 0.9999999933333333 1e-15)
  (check-within (ref (cadr shapes) 1) 1.0 1e-15)
  (check-within (ref (cadr shapes) 2) -2.0000000133333333 1e-15)
  (check-within (ref (caddr shapes) 1) -1.0 1e-15))

(test-case "of decimals what is not known is told"
  (define notes (told (frequencies 1e16 1 1e-8)))
  (check-equal? notes
                (string-append
                 "; small-oscillation-frequencies: roundings leave fewer than half of the digits of\n"
                 ";   0.0, known to about 1e1\n"
                 ";   0.0, known to about 1e1\n"
                 ";   exact numbers leave all digits\n"))
  (check-regexp-match #rx"\n;   0.0, known to about 1e-2\n" (told (frequencies 1e10 -1e-6))))

(test-case "a drift is 0, and nothing is to be told of it"
  (define (free-ring k)
    (define (L s)
      (define-values (q v) (values (coordinate s) (velocity s)))
      (- (* 1/2 (square v))
         (* 1/2 k (apply + (for/list ([i 5]) (square (- (ref q i) (ref q (modulo (+ i 1) 5)))))))))
    (small-oscillation-frequencies L (up 0 0 0 0 0)))
  (check-equal? (told (for ([k (list 1 3/7 2.0 (ten 20))])
                        (check-equal? (car (free-ring k)) 0.0)))
                "")
  (check-equal? (told (check-equal? (car (frequencies 1 2 0)) 0.0)
                      (check-equal? (car (frequencies 0.25 0.5 0)) 0.0))
                ""))
