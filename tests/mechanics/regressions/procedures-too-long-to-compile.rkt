#lang racket/base
;; Racket compiles no procedure of more than 10,000 symbols and numbers, but interprets it, and
;; its interpreter does not know the sine of flonums: "hash-ref: no value found for key:
;; 'unsafe-flsin".  Code is divided into sections; but one of them stored all values that are
;; numbers, as most of a Jacobian are.

(require (except-in mechanics time)
         racket/flonum
         racket/list
         (only-in mechanics/compile/Racket-code program->maker)
         (only-in mechanics/compile/compile-function compiled-function-program)
         "../support/checks.rkt")

;; The values of the code are those of f.  (Long programs are interpreted at first, by an
;; interpreter of our own.)
(define (check-code f xs)
  (define c (compile-function f (apply up xs)))
  (check-false (compiled-function-reason c))
  (define expected (structure->list (f (apply up xs))))
  (define values (make-flvector (length expected)))
  (((program->maker (compiled-function-program c))) (apply flvector xs) values)
  (for ([x (in-flvector values)] [y (in-list expected)])
    (check-= x y (* 1e-12 (+ 1 (abs y))))))

(define (structure->list s) (for/list ([k (dimension s)]) (ref s k)))
(define (sines n) (for/list ([k n]) (sin (+ 1.0 k))))

(test-case "many values that are numbers, and many that are one value"
  (for ([n '(100 249 250 251 499 500 501 3000)])
    (check-code (lambda (s)
                  (define x (sin (ref s 0)))
                  (define y (ref s 1))
                  (apply up (for/list ([k n]) (case (modulo k 3) [(0) x] [(1) k] [else y]))))
                '(0.3 0.4))))

(test-case "no instructions, and many values"
  (check-code (lambda (s) (apply up (for/list ([k 700]) (if (even? k) (ref s 0) k)))) '(0.5)))

(test-case "arguments from elsewhere, each value wanted twice"
  (for ([n '(100 240 250 260 499)])
    (check-code (lambda (s)
                  (define (x k) (ref s (modulo k n)))
                  (define products
                    (for/list ([k n]) (* (x k) (x (+ 1 (* 2 k))))))
                  (define all (for/list ([p products] [k n]) (sin (+ p (x (+ 3 (* 5 k)))))))
                  (apply up (append (for/list ([a all] [b (reverse all)]) (* a b)) all)))
                (sines n))))

(test-case "angles brought to one turn"
  (check-code (lambda (s)
                (apply up (for/list ([k 240]) ((principal-value :pi) (ref s k)))))
              (for/list ([k 240]) (* 0.1 (- k 120.5)))))

(test-case "systems of a few unknowns, many of them"
  (define (chain n)
    (lambda (s)
      (define (q k) (ref s 1 k))
      (define (v k) (ref s 2 k))
      (+ (for*/fold ([sum 0]) ([i n] [j n])
           (+ sum (* 1/2 (- n (max i j)) (cos (- (q i) (q j))) (v i) (v j))))
         (for/fold ([sum 0]) ([i n]) (+ sum (* (- n i) (cos (q i))))))))
  (for ([n '(6 8)])
    (define rates (Lagrangian->state-derivative (chain n)))
    (define start
      (up 0.0 (apply up (take (sines 20) n)) (apply up (take (reverse (sines 20)) n))))
    ;; Radau's method asks for the Jacobian
    (define a ((state-advancer (lambda () rates)) start 0.01 1e-11 #:method 'Radau-IIA-5))
    (define b ((state-advancer (lambda () rates)) start 0.01 1e-11 #:method 'Dormand-Prince-853))
    (for* ([k '(1 2)] [i n]) (check-= (ref a k i) (ref b k i) 1e-9))))

(test-case "the flow of a motion, by an implicit method"
  (define (driven s)
    (for/fold ([sum 0]) ([i 3])
      (+ sum (* 1/2 (square (ref s 2 i)))
         (* -1/4 (expt (- (ref s 1 i) (sin (* 2 (ref s 0)))) 4)))))
  (define rates (Lagrangian->state-derivative driven))
  (define start (up 0.4 (up 0.1 0.2 0.3) (up 0.3 -0.2 0.1)))
  (define (flow method) ((linearized-flow (lambda () rates)) start 1 1e-11 #:method method))
  (define-values (a b) (values (flow 'Radau-IIA-5) (flow 'Taylor)))
  (for* ([i 3] [j 3]) (check-= (ref a 1 i 1 j) (ref b 1 i 1 j) 1e-9)))
