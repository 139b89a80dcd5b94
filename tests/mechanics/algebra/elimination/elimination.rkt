#lang racket/base
;; Elimination without fractions: exact numbers, polynomials, values that satisfy
;; relations.

(require mechanics/algebra/expression/expression
         mechanics/algebra/expression/operation
         mechanics/algebra/simplify/simplify-expression
         mechanics/algebra/elimination/bareiss
         mechanics/algebra/elimination/elimination
         "../../support/checks.rkt"
         "../../support/matrices.rkt" "../../support/random.rkt" "../../support/same.rkt")

(define (integer) (random-integer -5 5))
(define no-limit 1000000)

;; ---------------------------------------------------------------------------
;; Numbers

(test-case "entries are minors of the matrix given (Sylvester)"
  (with-seed 431
    (for* ([n (in-range 2 6)] [_ 5])
      (define A (random-rows n 1 integer))
      (define E (eliminate integer-domain A n))
      (when (= n (echelon-rank E))
        (check-equal? (abs (echelon-pivot E)) (abs (Leibniz A)))
        (for ([row (echelon-rows E)] [j (echelon-columns E)])
          (for ([x row] [l (in-naturals)])
            (check-equal? x (if (= l j) (echelon-pivot E) 0))))))))

(test-case "determinants of rational and of complex matrices"
  (with-seed 432
    (for* ([n (in-range 1 7)] [density '(1 0.6)] [_ 3])
      (define A (random-rows n density))
      (check-equal? (eliminated-determinant A 1) (Leibniz A))
      (define C (random-rows n density (lambda () (make-rectangular (integer) (random-rational)))))
      (check-equal? (eliminated-determinant C 1) (Leibniz C)))))

(test-case "Hilbert matrices: the determinant by its formula, the inverse exact and integral"
  ;; c⁴ₙ / c₂ₙ with cₙ = 1! 2! ... (n-1)!
  (define (factorial k) (for/product ([i (in-range 1 (add1 k))]) i))
  (define (c n) (for/product ([i (in-range 1 n)]) (factorial i)))
  (for ([n '(1 2 5 10 20)])
    (check-equal? (eliminated-determinant (Hilbert n) 1) (/ (expt (c n) 4) (c (* 2 n))))
    (define inverse (eliminated-solutions (Hilbert n) (identity-rows n) 1))
    (check-equal? (times (Hilbert n) inverse) (identity-rows n))
    (check-true (for*/and ([row inverse] [x row]) (integer? x)))))

(test-case "solutions satisfy their systems; singular ones are called so"
  (with-seed 433
    (for* ([n (in-range 1 7)] [_ 3])
      (define A (random-rows n 0.8))
      (define b (random-rows n 1 random-rational 2))
      (define x (eliminated-solutions A b 1))
      (if (zero? (Leibniz A))
          (check-eq? x 'singular)
          (check-equal? (times A x) b)))))

(test-case "rank and null space: a product of tall and wide matrices has the lesser rank"
  (with-seed 434
    (for* ([m '(2 4 6)] [n '(3 5)] [r '(0 1 2)])
      (define A
        (if (zero? r)
            (rows m (lambda (i j) 0) n)
            (times (random-rows m 1 integer r) (random-rows r 1 integer n))))
      (define k (eliminated-kernel A))
      (define vectors (kernel-basis-vectors k))
      (check <= (kernel-basis-rank k) r)
      (check-equal? (+ (kernel-basis-rank k) (length vectors)) n)
      (for ([v (in-list vectors)])
        (check-equal? (times A (for/vector ([x v]) (vector x))) (rows m (lambda (i j) 0) 1))
        (check-equal? (apply gcd (vector->list v)) 1))
      (unless (null? vectors)
        (check-equal? (kernel-basis-rank (eliminated-kernel (list->vector vectors)))
                      (length vectors))))))

(test-case "the arguments are left as they were"
  (define A (Hilbert 4))
  (eliminated-determinant A 1)
  (eliminated-kernel A)
  (check-equal? A (Hilbert 4)))

;; ---------------------------------------------------------------------------
;; Expressions

(define (e . datum)
  (let read ([d (car datum)])
    (if (pair? d)
        (apply (case (car d)
                 [(+) (lambda xs (for/fold ([s 0]) ([x xs]) (e:+ s x)))]
                 [(*) (lambda xs (for/fold ([s 1]) ([x xs]) (e:* s x)))]
                 [(-) e:-] [(/) e:/] [(expt) e:expt]
                 [(sin) (lambda (x) (e:apply op:sin x))]
                 [(cos) (lambda (x) (e:apply op:cos x))]
                 [(sqrt) (lambda (x) (make-node op:sqrt (list x)))])
               (map read (cdr d)))
        d)))

(define (matrix . datums)
  (for/vector ([row datums]) (for/vector ([d row]) (e d))))

(define (simply-zero? x) (eqv? 0 (if (number? x) x (simplify-expression x))))

(define (product A v)
  (for/list ([row A])
    (for/fold ([s 0]) ([a row] [x v]) (e:+ s (e:* a x)))))

(test-case "determinants of polynomials and of quotients"
  (with-seed 435
    (for* ([n (in-range 1 6)] [_ 3])
      (define (entry)
        (random-choice 0 1 'x (e '(+ x y)) (e '(* 2 x y)) (e '(/ 1 (+ x 1))) (e '(/ y 3)) 1.5))
      (define A (random-rows n 1 entry))
      (check-true (same? (eliminated-determinant A no-limit) (Leibniz A e:+ e:*))))))

(test-case "a determinant that may have many terms is not attempted"
  (define symbols (rows 4 (lambda (i j) (string->symbol (format "a~a~a" i j)))))
  (check-false (eliminated-determinant symbols 200))
  (check-equal? (eliminated-determinant (rows 20 (lambda (i j) (if (= i j) 'x 1))) 200)
                (simplify-expression (e '(* (expt (- x 1) 19) (+ x 19))))))

(test-case "solutions of symbolic systems"
  (define A (matrix '(a b) '(c d)))
  (define x (eliminated-solutions A (vector (vector 'p) (vector 'q)) no-limit))
  (for ([residual (product A (for/list ([row x]) (vector-ref row 0)))] [b '(p q)])
    (check-true (simply-zero? (e:- residual b))))
  (check-eq? (eliminated-solutions (matrix '(a b) '((* 2 a) (* 2 b))) #(#(1) #(1)) no-limit)
             'singular))

;; Each with its rank.
(define named-matrices
  (list (cons 0 (matrix '((+ (* (sin t) (sin t)) (* (cos t) (cos t)) -1))))
        (cons 1 (matrix '((cos t) (sin t)) '((* (cos t) (sin t)) (* (sin t) (sin t)))))
        (cons 2 (matrix '((cos t) (sin t)) '((sin t) (cos t))))
        (cons 1 (matrix '(1 (sqrt x)) '((sqrt x) x)))
        (cons 2 (matrix '(1 (sqrt x)) '((sqrt x) (* 2 x))))
        (cons 1 (matrix '((sqrt 2) 2 (sqrt 6)) '(1 (sqrt 2) (sqrt 3))))
        (cons 1 (matrix '((- (expt x 2) (expt y 2)) (+ x y)) '((- x y) 1)))
        (cons 1 (matrix '((/ 1 x) (/ 1 y)) '(y x)))
        (cons 1 (matrix '(0.5 x) '(1.0 (* 2 x))))
        (cons 2 (matrix '((sin (+ a b)) (sin a) (sin b)) '((cos (+ a b)) (cos a) (cos b))))
        (cons 2 (matrix '(1 (cos t) (sin t))
                        '(1 (sin t) (cos t))
                        '(2 (+ (sin t) (cos t)) (+ (sin t) (cos t)))))))

(test-case "what is zero is decided by the canonical form; null vectors are proved"
  (for ([named (in-list named-matrices)])
    (define A (cdr named))
    (define k (eliminated-kernel A))
    (with-check-info (['matrix A])
      (check-equal? (kernel-basis-rank k) (car named))
      (check-equal? (length (kernel-basis-vectors k))
                    (- (vector-length (vector-ref A 0)) (car named)))
      (for* ([v (kernel-basis-vectors k)] [x (product A v)])
        (check-true (simply-zero? x))))))

(test-case "null vectors are primitive: no divisor is common to their components"
  (check-equal? (kernel-basis-vectors (eliminated-kernel (matrix '((* a x) (* b x)))))
                (list (vector (e '(* -1 b)) 'a)))
  (check-equal? (kernel-basis-vectors (eliminated-kernel (matrix '((/ 2 x) (/ 4 y)))))
                (list (vector (e '(* -2 x)) 'y))))

(test-case "an entry that divides by zero has no rank"
  (check-false (eliminated-kernel (matrix '((/ 1 (- (* x (+ x 1)) (+ (* x x) x))))))))
