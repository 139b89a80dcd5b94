#lang racket/base
;; The point at which open signs are taken: where it lies, what is seen there, and when it is
;; looked for.

(require mechanics/algebra/assumption/assumption-set
         mechanics/algebra/assumption/reference-point
         mechanics/algebra/expression/read
         mechanics/algebra/simplify/declare-relations
         "../../support/checks.rkt")

(define (point-of . relations)
  (find-reference '(x) (declare-relations no-assumptions relations)))

(test-case "the point lies where relations hold, however far that is"
  (define (x-where . relations) ((apply point-of relations) 'x '()))
  (check-true (< (x-where '(< x -1000000)) -1e6))
  (check-true (> (x-where '(> x 1000000)) 1e6))
  (check-true (< 1e6 (x-where '(> x 1000000) '(< x 1000001)) 1000001)))

;; At first all numbers are positive.
(test-case "the point lies where products and sums of several have the declared signs"
  (for ([d '((< (* x y) 0) (< (+ x y) -1) (> (* -1 x y y) 2))])
    (check-pred procedure? (find-reference '(x y) (declare-relations no-assumptions (list d)))
                (format "~s" d))))

(test-case "relations concern a question by what they share with others that do"
  (define relations
    (for/list ([d '((> a b) (> x y) (> y z) (> b 0))])
      (car (assumptions-relations (declare-relations no-assumptions (list d))))))
  (define (concerning-one leaf)
    (map relation-datum (concerning (leaves-of (list leaf)) relations)))
  (check-equal? (concerning-one 'z) '((> x y) (> y z)))
  (check-equal? (concerning-one 'b) '((> a b) (> b 0)))
  (check-equal? (concerning-one 'c) '()))

(test-case "signs are read off the point, but those that rounding hides"
  (define point (point-of '(> x 0)))
  (check-equal? (for/list ([d '(x (- x) (- x x) (sqrt (- x)))])
                  (reference-sign (datum->expression d) point))
                '(1 -1 #f #f)))

(define large-sum
  (for/fold ([d 'x]) ([k (in-range 60000)])
    `(+ ,d (* ,(string->symbol (format "a~a" k)) (sqrt x)))))

(test-case "a break while the point is looked for leaves it to be found by the next who asks"
  (define sum (datum->expression large-sum))
  ;; The break comes after so many turns of the other thread, at one place or another.
  (for ([turns '(0 1 2 4 8)])
    (define A (at-common-reference no-assumptions (list sum)))
    (define started (make-semaphore))
    (define interrupted
      (thread (lambda ()
                (with-handlers ([exn:break? void])
                  (semaphore-post started)
                  ((assumptions-reference A))))))
    (semaphore-wait started)
    (for ([_ turns]) (sleep 0))
    (break-thread interrupted)
    (thread-wait interrupted)
    (check-pred procedure? ((assumptions-reference A)) (format "~a turns" turns))))
