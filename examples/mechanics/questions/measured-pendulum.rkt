#lang mechanics
;; A pendulum that was filmed: its length, its damping and how it was let go, from angles read
;; off the pictures to 0.01; and the table that another program would draw.

(define ((pendulum l gamma) (up t theta omega))
  (up 1 omega (- (* -9.81 (/ (sin theta) l)) (* gamma omega))))

;; In place of a film: a motion, and errors with a fixed seed.
(define motion (evolve-trajectory (pendulum 0.8 0.05) (up 0 0.6 0) 12))
(define (error-of-reading)
  (* 0.01 (sqrt (* -2 (log (random)))) (cos (* :2pi (random)))))
(define film
  (begin
    (random-seed 12)
    (for/list ([k 120])
      (define t (* 0.1 k))
      (up t (+ (coordinate (motion t)) (error-of-reading))))))

(define fit
  (fit-motion pendulum (up 0 0.5 0) film #:parameters '((l 1.0) (gamma 0)) #:measured coordinate
              #:deviation 0.01))
fit

;; Correlation: knowledge of one is knowledge of another.
(define covariance (motion-fit-covariance fit))
(define (correlation i j)
  (/ (matrix-ref covariance i j)
     (sqrt (* (matrix-ref covariance i i) (matrix-ref covariance j j)))))
(correlation 0 3)

;; Angles and residuals for another program, here in a folder for what is passing.
(define file (build-path (find-system-path 'temp-dir) "measured-pendulum.csv"))
(write-table (for/list ([row film] [r (motion-fit-residuals fit)])
               (list (ref row 0) (ref row 1) (ref r 1)))
             file #:names '(t angle residual))
(read-table file)
(delete-file file)

(module+ test
  (require rackunit)
  (test-case "the truth is within three deviations"
    (for ([v (motion-fit-values fit)] [d (motion-fit-deviations fit)] [true '(0.6 0 0.8 0.05)])
      (check-true (< (abs (- (cadr v) true)) (* 3 (cadr d))))))
  (test-case "the squares add up to about as many as there are degrees of freedom"
    (check-true (< 80 (motion-fit-chi-square fit) 160))))
