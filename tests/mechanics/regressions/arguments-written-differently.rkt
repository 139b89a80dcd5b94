#lang racket/base
;; Functions of equal arguments were different functions where the arguments were
;; written in different angles, or roots.

(require mechanics/algebra/simplify/simplify-expression
         mechanics/algebra/expression/expression
         mechanics/algebra/zero/zero-test
         mechanics/algebra/expression/read
         "../support/checks.rkt")

(define (simplified datum) (expression->datum (simplify-expression (datum->expression datum))))

;; Equal arguments, each by itself in kernels of its own.
(define pairs
  '([(sin (* 2 a)) (* 2 (sin a) (cos a))]
    [(+ b (sin (* 3 a))) (+ b (* 3 (sin a)) (* -4 (expt (sin a) 3)))]
    [(sinh (* 2 a)) (* 2 (sinh a) (cosh a))]
    [(sqrt 6) (* (sqrt 2) (sqrt 3))]
    [(exp (sin (* 2 a))) (exp (* 2 (sin a) (cos a)))]
    [(W (sin (* 2 a))) (W (* 2 (sin a) (cos a)))]))

(define (functions u)
  `((V ,u) (V b ,u) (V (up ,u b)) (atan ,u b) (exp ,u) (exp (+ ,u b)) (expt b ,u)
    (sin ,u) (cosh ,u) (sqrt (+ 1 ,u)) (expt (+ 2 ,u) 1/3) (log (+ 2 ,u)) (abs (+ b ,u))))

(for* ([p (in-list pairs)]
       [fs (in-list (map cons (functions (car p)) (functions (cadr p))))])
  (define f (car fs))
  (define g (cdr fs))
  (test-case (format "~s is ~s" f g)
    (check-equal? (simplified `(- ,f ,g)) 0)
    (check-eq? (zero-test-status (zero-test (datum->expression `(- ,f ,g)))) 'proved)))

(test-case "also where they are but parts of arguments"
  (check-equal? (simplified '(- (exp (+ b (sin (* 2 a)))) (* (exp b) (exp (* 2 (sin a) (cos a))))))
                0)
  (check-equal? (simplified '(- (log (sin (* 2 a))) (log (* 2 (sin a) (cos a))))) 0)
  (check-equal? (simplified '(- (exp (cos (* 2 a))) (/ (exp (* 2 (expt (cos a) 2))) (exp 1)))) 0))

(test-case "the shortest way of writing an argument is kept"
  (check-equal? (simplified '(+ (V (* 2 (sin a) (cos a))) (V (sin (* 2 a)))))
                '(* 2 (V (sin (* 2 a)))))
  (check-equal? (simplified '(+ (V (sin (* 2 a))) (V (sin a)))) '(+ (V (sin a)) (V (sin (* 2 a))))))

(test-case "arguments that differ stay different"
  (define d (datum->expression '(- (V (sin (* 2 a))) (V (* 2 (sin a) (sin a))))))
  (check-eq? (zero-test-status (zero-test d)) 'refuted))
