#lang mechanics
;; A pendulum of length 1 whose support moves up and down by (q/2) cos 2t, in the gravity a.  Small
;; swings follow Mathieu's equation, and grow where a lies in one of its tongues.  Where a is
;; negative the pendulum stands on its head: shaken, it stands still from a₀ on.

(define q 0.4)
(define ((L a) (up t theta rate))
  (+ (* 1/2 (square rate)) (* (- a (* 2 q (cos (* 2 t)))) (cos theta))))

(define straight
  (continue-periodic-orbit (lambda (a) (Lagrangian->state-derivative (L a)))
                           (up 0 0 0) :pi -0.5 2))
straight
(define edges (map special-point-parameter (branch-special-points straight)))

;; The characteristic values as power series: DLMF 28.6.1 and 28.6.2
(define a0 (+ (* -1/2 (expt q 2)) (* 7/128 (expt q 4)) (* -29/2304 (expt q 6))
              (* 68687/18874368 (expt q 8))))
(define (a1 q)
  (+ 1 q (* -1/8 (expt q 2)) (* -1/64 (expt q 3)) (* -1/1536 (expt q 4))
     (* 11/36864 (expt q 5)) (* 49/589824 (expt q 6)) (* 55/9437184 (expt q 7))))

(module+ test
  (require rackunit)
  (test-case "edges of the tongues are the characteristic values a0, b1, a1"
    (for ([edge edges] [value (list a0 (a1 (- q)) (a1 q))] [tolerance '(1e-6 1e-8 1e-8)])
      (check-= edge value tolerance))
    (check-equal? (map special-point-kind (branch-special-points straight))
                  '(pitchfork period-doubling period-doubling)))
  (test-case "within the first tongue the swing grows, outside it does not"
    (for ([a (branch-parameters straight)] [stable? (branch-stabilities straight)])
      (check-eq? stable? (and (< (car edges) a) (not (< (cadr edges) a (caddr edges))))))))
