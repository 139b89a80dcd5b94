#lang racket/base
;; Squares of squares of squares ... took all memory, or did not end: the growth of
;; coefficients was not counted, and reports were written out though their parts are shared.

(require mechanics "../support/checks.rkt")

(define (repeatedly f n x) (for/fold ([x x]) ([_ (in-range n)]) (f x)))

;; -> what the thunk gives, or #f if it takes more than a gigabyte more
(define (within-a-gigabyte thunk)
  (define c (make-custodian))
  (define result #f)
  (custodian-limit-memory c (expt 2 30) c)
  (parameterize ([current-custodian c])
    (thread-wait (thread (lambda () (set! result (thunk))))))
  (custodian-shutdown-all c)
  result)

(define towers
  (list (lambda () (repeatedly square 26 (+ 'x 1)))
        (lambda () (- (repeatedly square 26 (+ 'x 1)) 1))
        (lambda () (repeatedly (lambda (x) (+ 1 (square x))) 26 'x))
        (lambda () (repeatedly (lambda (x) (+ 'y (square x))) 26 'x))
        (lambda () (repeatedly (lambda (x) (* 2 (square x))) 26 (+ 'x 1)))
        (lambda () (repeatedly (lambda (x) (- (square x) 1/2)) 26 (sin 'x)))
        (lambda () (repeatedly (lambda (x) (- (* 2 (square x)) 1)) 26 (cos 'x)))
        (lambda () (repeatedly square 78 (+ 'x 3)))
        (lambda () (- (expt 'x 1000000) 1))
        (lambda () (- (expt (+ 'x 1) (expt 2 26)) (expt (- 'x 1) (expt 2 26))))))

(define (text x) (format "~a" x))

(test-case "a verdict is reached, and printed, without a proof that is none"
  (for ([tower (in-list towers)] [i (in-naturals)])
    (define verdict (within-a-gigabyte (lambda () (prove-zero (tower)))))
    (check-pred verdict? verdict (text i))
    (check-false (proved? verdict))
    (check-true (< (string-length (text verdict)) 100000))))

(test-case "simplification and expansion end, leaving what is too large"
  (for* ([tower (in-list towers)] [work (in-list (list simplify expand))])
    (define result (within-a-gigabyte (lambda () (work (tower)))))
    (check-not-false result)
    (check-true (< (string-length (text result)) 100000))))

(test-case "what cancels is proved however large it is"
  (define (tower n) (repeatedly square n (+ 'x 1)))
  (check-true (proved? (prove-zero (- (tower 26) (* (tower 25) (tower 25)))))))
