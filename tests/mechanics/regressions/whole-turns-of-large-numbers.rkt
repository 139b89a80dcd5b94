#lang racket/base
;; Coordinates were taken for angles where an image was so large that its rounding is a turn, or
;; where a turn of one moved another that is no angle by a turn.  Periodic points were found that
;; come back by "whole turns" only.

(require mechanics "../support/checks.rkt")

(define ((Henon a b) x y return fail) (return (+ 1 y (* -1 a x x)) (* b x)))
(define (logistic x y return fail) (return (* 4 x (- 1 x)) (* 0.5 y)))

(define (remainder-of x) (abs (- x (round x))))

(define (count-of map n region grid) (length (periodic-points map n region #:grid grid)))

(test-case "Hénon's map has as many periodic points as are published"
  (check-equal? (for/list ([n '(1 2 3 4 5 6)]) (count-of (Henon 1.4 0.3) n '(-2 2 -2 2) '(24 24)))
                '(2 2 0 4 0 12)))

;; x = sin²(pi t) doubles t: the points that 2^n t = ± t + whole turns
(test-case "the logistic map has those of the doubling of an angle, and no others"
  (for ([n '(1 2 3 4 5)] [expected '(2 2 6 12 30)])
    (define found (periodic-points logistic n '(-0.1 1.1 -0.1 0.1) #:grid '(300 1)))
    (check-equal? (length found) expected)
    (for ([p found])
      (define x (abscissa (fixed-point-coordinates p)))
      (define t (/ (asin (sqrt (max 0 x))) :pi))
      (check-= (min (remainder-of (* (- (expt 2 n) 1) t)) (remainder-of (* (+ (expt 2 n) 1) t)))
               0 1e-5))))

(test-case "a point that comes back a turn further, in what is no angle, is none"
  (check-exn exn:fail:mechanics?
             (lambda ()
               (find-fixed-point (lambda (x y return fail)
                                   (return (+ (* 1/4 x) (sin x) y) (+ y (* 2 :pi) (* x x))))
                                 (up 0.1 0.2)))))

(test-case "angles of the standard map still are"
  (define (kicked theta I return fail)
    (define J (+ I (* 0.6 (sin theta))))
    (return (+ theta J) J))
  (define p (find-fixed-point kicked (up 3 6.2)))
  (check-= (ordinate (fixed-point-coordinates p)) (* 2 :pi) 1e-12))
