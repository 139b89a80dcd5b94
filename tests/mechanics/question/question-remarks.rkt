#lang racket/base
;; Remarks of a verdict on the question: answers that say less than they seem to.

(require mechanics (only-in mechanics/book L-harmonic) "../support/checks.rkt")

(define ((L-forgetful m) local) (* 1/2 m (square 'v)))

(define (note v) (verdict-remarks v))

(test-case "a path that does not depend on the time"
  (check-equal? (note (verify-solution (L-harmonic 'm 'k) (lambda (t) 0)))
                '("the path does not depend on the time"))
  (check-equal? (note (verify-solution (L-harmonic 'm 'k) (lambda (t) (up 'a 'b))))
                '("the path does not depend on the time")))

(test-case "a symbol t that is taken for the time"
  (check-equal? (note (verify-solution (L-harmonic 'm 0) (lambda (t) (* 'a 't 't))))
                '("the path does not depend on its argument; the symbol t in it is a constant"))
  (check-equal? (note (verify-solution (L-harmonic 'm 0) (lambda (t) (* 't t))))
                '("the symbol t in the path is a constant, not its argument")))

(test-case "a Lagrangian that has forgotten its state"
  (check-equal? (note (verify-solution (L-forgetful 'm) (lambda (t) (exp t))))
                (list (string-append "the Lagrangian depends neither on time nor on coordinates "
                                     "nor on velocities: every path solves its equations"))))

(test-case "a constant is conserved"
  (define local (up 't 'q 'v))
  (check-equal? (note (verify-conserved (L-harmonic 'm 'k) (lambda (s) 'your-answer) local))
                '("the quantity is a constant, whatever the motion"))
  (check-equal? (note (verify-conserved (L-harmonic 'm 'k)
                                        (lambda (s) (up 'a (square 'b))) local))
                '("the quantity is a constant, whatever the motion")))

(test-case "an ordinary question has no remark"
  (check-equal? (note (verify-solution (L-harmonic 'm 'k) (lambda (t) (* 'a (cos t))))) '())
  (check-equal? (note (verify-solution (L-harmonic 'm 'k) (literal-function 'x))) '())
  (check-equal? (note (verify-conserved (L-harmonic 'm 'k)
                                        (Lagrangian->energy (L-harmonic 'm 'k))
                                        (up 't 'q 'v)))
                '())
  (check-equal? (note (prove-zero (- 'a 'b))) '()))

(test-case "a remark is a line of the report"
  (check-equal? (format "~a" (verify-solution (L-harmonic 'm 'k) (lambda (t) 0)))
                "proved: the residual is zero\n  note: the path does not depend on the time"))

(test-case "why a verdict is undecided"
  (define z (- (square (sin 'x)) (- 1 (square (cos 'x)))))
  (check-equal? (verdict-reason (prove-zero (* z (/ 1 z)))) 'nowhere-defined)
  (check-equal? (verdict-reason (prove-zero (- (cos (* 1.3579246801 'a))
                                               (cos (* 1.3579246801000003 'a)))))
                'decimals)
  (check-equal? (verdict-reason (verify-solution (L-harmonic 'm 0) abs)) 'kinks)
  (define arcs
    (for/fold ([sum 0]) ([k (in-range 1 6)])
      (+ sum (atan (* k 'x)) (atan (/ 1 (* k 'x))))))
  (check-equal? (verdict-reason (assuming ('(> x 0)) (prove-zero (- arcs (* 5/2 ':pi)))))
                'beyond-the-algebra)
  (check-equal? (verdict-reason (prove-zero (- 'a 'b))) #f))

(test-case "how decimals were read"
  (define v (verify-solution (L-harmonic 1 2) (lambda (t) (cos (* (sqrt 2.0) t)))))
  (check-true (proved? v))
  (check-equal? (map car (verdict-readings v)) '(-2.0000000000000004 1.4142135623730951))
  (check-equal? (expression (cadr (cadr (verdict-readings v)))) '(sqrt 2))
  (check-regexp-match #rx"\n  reading: 1.4142135623730951 as [(]sqrt 2[)]$" (format "~a" v)))
