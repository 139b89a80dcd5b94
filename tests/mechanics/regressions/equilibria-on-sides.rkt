#lang racket/base
;; An equilibrium was listed on the side of a kink where there is none, those of the other side were
;; lost, and one was where the force is infinite.

(require mechanics
         (only-in mechanics/error/note start-session-of-notes!)
         (only-in "../support/systems.rkt" L-on-a-line)
         "../support/checks.rkt")

(define line (up 't 'x 'v))

(define (resting V)
  (for/list ([e (in-list (equilibria (L-on-a-line 'm V) line))])
    (expression (cons (equilibrium-coordinates e) (equilibrium-conditions e)))))

(define-check (check-rest V expected)
  (with-check-info (['potential (V 'x)] ['found (resting V)])
    (unless (equal? (format "~s" (resting V)) (format "~s" expected)) (fail-check))))

(define (size x) (sqrt (square x)))

(test-case "each side of a kink by itself"
  (check-rest (lambda (x) (* 1/2 (square (+ 1 (size x))))) '())
  (check-rest (lambda (x) (square (- (size x) 1))) '((1) (-1)))
  (check-rest (lambda (x) (square (- (abs x) 1))) '((1) (-1)))
  (check-rest (lambda (x) (* x (size (- x 1)))) '((1/2))))

(test-case "everywhere between two kinks"
  (check-rest (lambda (x) (+ (size (- x 1)) (size (+ x 1)))) '((x (> (+ 1 x) 0) (> (- 1 x) 0))))
  (check-rest (lambda (x) (+ (size x) x)) '((x (> (* -1 x) 0))))
  (check-rest (lambda (x) (+ (abs x) x)) '((x (> (* -1 x) 0)))))

(test-case "on which side, parameters tell"
  (check-rest (lambda (x) (+ (* 1/2 'k (square x)) (* 'c (size x))))
              '(((/ (* -1 c) k) (> (/ (* -1 c) k) 0)) ((/ c k) (> (/ (* -1 c) k) 0)))))

(test-case "on the kink itself, where the force has a value"
  (check-rest (lambda (x) (* x (abs x))) '((0)))
  (check-rest (lambda (x) (abs x)) '())
  (check-rest (lambda (x) (* (+ x 1) (abs x))) '((-1/2))))

(test-case "no equilibrium where the force has no value, and conditions that keep it away"
  (check-rest (lambda (x) (- (* 2 (sqrt (+ x 'b))) (* 'a x)))
              '(((- (/ 1 (expt a 2)) b) (> a 0))))
  (check-rest (lambda (x) (- (exp x) (* 'a x))) '(((log a) (> a 0))))
  (check-rest (lambda (x) (- (* 1/3 'a (cube x)) (* 'b x)))
              '(((sqrt (/ b a)) (> (* a b) 0)) ((* -1 (sqrt (/ b a))) (> (* a b) 0))))
  (check-rest (lambda (x) (- (* 1/2 (square x)) (* 'c (log x)))) '(((sqrt c) (> c 0)))))

(test-case "a force that is the same everywhere"
  (define said (open-output-string))
  (thread-wait
   (thread (lambda ()
             (parameterize ([current-error-port said])
               (start-session-of-notes!)
               (check-equal? (resting (lambda (x) (* 'a x))) '())))))
  (check-equal? (get-output-string said) "; equilibria: there are none, unless a is 0\n"))
