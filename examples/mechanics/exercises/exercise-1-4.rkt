#lang mechanics
;; Exercise 1.4 (SICM 1.4): the action of a free particle
;; Checked: a formula for the action between two events
;; How: against the integral, for several masses, places and times

;; A particle of mass m goes uniformly from x_a at the time t_a to x_b at the time t_b.
;; Find its action.

(define ((L-free m) (up t x v)) (* 1/2 m (square v)))

(define ((uniform t_a x_a t_b x_b) t)
  (+ x_a (* (/ (- x_b x_a) (- t_b t_a)) (- t t_a))))

(define (action m t_a x_a t_b x_b)
  (Lagrangian-action (L-free m) (uniform t_a x_a t_b x_b) t_a t_b))

;; An attempt, and one that takes the mean of the velocity for that of its square, and
;; forgets for how long the particle moves.
(define (attempt m t_a x_a t_b x_b)
  (/ (* m (square (- x_b x_a))) (* 2 (- t_b t_a))))
(define (slip m t_a x_a t_b x_b)
  (* 1/2 m (square (/ (- x_b x_a) (- t_b t_a)))))

(define cases '((3 0 0 10 40) (1/2 -1 7 2 1) (5 1 2 2 4)))

(define (ratios formula)
  (for/list ([c cases]) (/ (apply action c) (apply formula c))))

;; The ratio should be 1.  That of the slip is the duration, in every case.
(ratios attempt)
(ratios slip)
(for/list ([c cases]) (- (list-ref c 3) (list-ref c 1)))

(module+ test
  (require rackunit)
  (test-case "the formula is the integral"
    (for ([r (ratios attempt)]) (check-= r 1 1e-12)))
  (test-case "the slip lacks the duration"
    (for ([r (ratios slip)] [duration '(10 3 1)]) (check-= r duration 1e-12))))
