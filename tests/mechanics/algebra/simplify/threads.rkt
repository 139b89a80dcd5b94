#lang racket/base
;; Simplification shares nothing between threads, and a break leaves nothing
;; behind.

(require mechanics/algebra/expression/expression
         mechanics/algebra/expression/operation
         mechanics/algebra/simplify/simplify-expression
         mechanics/algebra/zero/zero-test
         "../../support/checks.rkt" "../../support/property/expressions.rkt")

;; Twelve expressions, from seeds.
(define expressions
  (for/list ([seed (in-range 12)])
    (parameterize ([current-pseudo-random-generator (make-pseudo-random-generator)])
      (random-seed (+ 500 seed))
      (define class (list-ref classes (modulo (* 5 seed) (length classes))))
      (random-expression (class-depth class) (class-kinds class)))))

;; The simplified form, what it assumes, and the verdict on e - e' for a nearby e'.
(define (answers e)
  (define-values (s assumptions) (simplify-expression/assumptions e))
  (define near (make-node op:+ (list s (make-node op:* (list 1/1000 (make-node op:sin '(b)))))))
  (list (expression->datum s)
        assumptions
        (zero-test-status (zero-test (make-node op:- (list e s))))
        (zero-test-status (zero-test (make-node op:- (list e near))))
        (zero-test-witness (zero-test (make-node op:- (list e near))))))

(define expected (map answers expressions))

(define (in-threads n work)
  (define results (make-vector n #f))
  (for-each thread-wait
            (for/list ([i (in-range n)])
              (thread (lambda () (vector-set! results i (work i))))))
  (vector->list results))

(test-case "four threads give the answers of one, on the same expressions"
  (for ([round (in-range 5)])
    (for ([answer (in-list (in-threads 4 (lambda (i) (map answers expressions))))])
      (check-equal? answer expected))))

(define (rotated xs k) (if (eqv? k 0) xs (rotated (append (cdr xs) (list (car xs))) (- k 1))))

(test-case "four threads give the answers of one, on different expressions"
  (for ([round (in-range 5)])
    (define found
      (in-threads 4 (lambda (i) (map answers (rotated expressions (* 3 (+ i round)))))))
    (for ([answer (in-list found)] [i (in-naturals)])
      (check-equal? answer (rotated expected (modulo (* 3 (+ i round)) 12))))))

;; Expressions made anew: nothing a break interrupted is found in tables by eq?.
(define (copy e)
  (node-fold e values (lambda (n args) (make-node (node-head n) args))))

;; Runs the work in a thread and breaks it after a number of turns of others, which
;; is when the scheduler looks at it; -> was it broken?
(define (broken-after turns work)
  (define broken? #f)
  (define worker
    (parameterize-break #f
      (thread (lambda ()
                (with-handlers ([exn:break? (lambda (x) (set! broken? #t))])
                  (parameterize-break #t (work)))))))
  (for ([_ (in-range turns)]) (sleep 0))
  (break-thread worker)
  (thread-wait worker)
  broken?)

(test-case "a break at any moment leaves later answers as they were"
  (define breaks
    (for/sum ([round (in-range 40)])
      (define shared (map copy expressions))
      (define broken?
        (broken-after (quotient round 4)
                      (lambda () (for ([_ (in-range 50)]) (for-each answers shared)))))
      (check-equal? (map answers (list (list-ref shared (modulo round 12))))
                    (list (list-ref expected (modulo round 12))))
      (if broken? 1 0)))
  (check-true (> breaks 30) "too few were interrupted")
  (check-equal? (map answers expressions) expected))
