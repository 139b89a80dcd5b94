#lang racket/base
;; States and steps with which an integration never ended, or ended elsewhere.

(require mechanics "../support/checks.rkt")

(define ((oscillator) s) (up 1 (velocity s) (- (coordinate s))))
(define advance (state-advancer oscillator))

(test-case "a time that is not a number was never reached"
  (check-exn #rx"expected a state of real numbers; the number \\+nan.0 is none"
             (lambda () (advance (up +nan.0 1 0) 1)))
  (check-exn #rx"the number \\+inf.0 is none" (lambda () (advance (up 0 +inf.0 0) 1))))

(test-case "neither was the end by steps too short to change the time"
  (check-exn #rx"cannot be followed any further"
             (lambda () (advance (up 1 1 0) 1 1e-10 #:method (leapfrog 1e-20)))))

(test-case "a state without components"
  (check-exn #rx"a state without components has no motion"
             (lambda () ((state-advancer (lambda () (lambda (s) (up)))) (up) 1))))

(test-case "a first component is not the time because its derivative is 1 at the start"
  (define ((gears slow) s) (up (if (< (ref s 0) 5) slow 2) 0))
  (check-exn #rx"was taken for the time, but its derivative varies"
             (lambda () ((state-advancer gears 1) (up 0 0) 10)))
  (check-exn #rx"\n  at the start: 1\n  now: 2\n"
             (lambda () ((state-advancer gears 1) (up 0 0) 10 1e-10 #:precision 60)))
  (check-= (ref ((state-advancer gears 1.0) (up 0 0) 10) 0) 15 1e-6))

(test-case "it is where the derivative is 1.0 throughout"
  (define times '())
  ((evolve (lambda () (lambda (s) (up 1.0 (- (ref s 1))))))
   (up 0 1) (lambda (s) (set! times (cons (time s) times))) 1 2)
  (check-equal? times '(2.0 1.0 0.0)))

(test-case "a parameter that counts stays exact"
  (define ((pick n) s) (up 1 (list-ref '(1 2 3) n)))
  (check-= (ref ((state-advancer pick 2) (up 0 0) 1) 1) 3 1e-12)
  (define ((total n) s) (up 1 (for/sum ([i n]) (add1 i))))
  (check-= (ref ((state-advancer total 3) (up 0 0) 1) 1) 6 1e-12))

(test-case "a step into where the derivative is complex is taken again, shorter"
  (define ((leaking) s) (up 1 (if (> (time s) 100) 5 (- (sqrt (ref s 1))))))
  (check-= (ref ((state-advancer leaking) (up 0 1) 1.5) 1) 1/16 1e-9)
  (check-exn #rx"cannot be followed any further.*time: 1\\.99999"
             (lambda () ((state-advancer leaking) (up 0 1) 3))))

(test-case "a path between two times that are one"
  (check-exn #rx"find-path: the initial and the final time are the same"
             (lambda () (find-path (lambda (s) (square (velocity s))) 0 1 0 2 2))))

(test-case "the edge of where the derivative is real, met at full speed, was approached for ever"
  (define ((f) s) (up 1 (velocity s) (- (sqrt (- 1 (square (coordinate s)))))))
  (for ([q '(1 0.9)])
    (check-exn #rx"cannot be followed any further.*\n  state derivative (there|beyond): "
               (lambda () ((state-advancer f) (up 0 q 2) 3)))))

(test-case "a single step of leapfrog, asked for a thousand times, is checked once"
  (define calls 0)
  (define ((counting) s)
    (set! calls (+ calls 1))
    (up 1 (velocity s) (if (< (coordinate s) 100) (- (coordinate s)) 0)))
  (define step (free-run-state-advancer counting))
  (define (after n)
    (for/fold ([s (up 0 1 0)])
              ([_ n])
              (step s 0.01 1e-10 (lambda (s . _) s) #:method (leapfrog 0.01))))
  (after 1)
  (set! calls 0)
  (after 100)
  (check-true (<= calls 700) (format "~a calls" calls)))
