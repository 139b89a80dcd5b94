#lang mechanics
;; A section of the driven pendulum, with a drive of no amplitude  (SICM 4.1, Figure 4.2)
;;
;; The pendulum looked at once in each 4.2nd part of its period of small oscillations: points on the
;; contours of the Hamiltonian, in gray.  Most orbits would fill theirs; those of which the period
;; is to that of the looks as two integers, in red, consist of a few points.  The points of the
;; separatrix, in blue, crowd where the pendulum stands upright.

(require mechanics/plot mechanics/book "strobe.rkt")

(define-values (alpha beta) (values 1. 9.8))      ; H = α p²/2 − β cos θ
(define omega (* 4.2 (sqrt 9.8)))
(define T (strobe-map 0. 4.2))
(define (energy theta p) (- (* 1/2 alpha (square p)) (* beta (cos theta))))
(define (momentum-at-bottom E) (sqrt (/ (* 2 (+ E beta)) alpha)))

;; The momenta at θ = 0 of orbits that swing, or go round, `turns` times in n looks.
(define (resonant n turns low high)
  (define (excess E) (- (pendulum-frequency alpha beta E) (/ (* turns omega) n)))
  (momentum-at-bottom (find-root excess low high)))
(define swings-in-6 (resonant 6 1 -9.7 9.7))
(define turns-in-3 (resonant 3 1 9.9 100.))
(define turns-in-1 (resonant 1 1 9.9 200.))
(define separatrix (momentum-at-bottom beta))

(define ordinary '(1. 2. 3. 4. 5.1 6. 7.4 9.2 11. 13. 15. 17. -7.4 -9.2 -11. -13. -15. -17.))
(define win (frame :-pi :pi -20 20 #:width 600 #:height 500 #:x-label "θ" #:y-label "p_θ"))
(plot-contours win energy (for/list ([p ordinary]) (energy 0. p)) #:samples 201
               #:color "light gray")
(define (draw starts color size n)
  (for ([p starts])
    (for/fold ([theta 0.] [p p]) ([k n])
      (plot-point win theta p #:color color #:size size)
      (T theta p values void))))
(draw ordinary 'black 3. 20)
(draw (list swings-in-6 turns-in-3 (- turns-in-3) turns-in-1 (- turns-in-1)) 'red 6. 6)
(draw (list separatrix (- separatrix)) 'blue 4. 8)

win

(module+ main
  (require "save.rkt")
  (save-figure win "figure-4-2.png"))

(module+ test
  (require rackunit)
  (define (after n p) ((iterated-map T n) 0. p list void))
  (test-case "points are on contours of the Hamiltonian"
    (for* ([p ordinary] [n '(1 7)]) (check-= (apply energy (after n p)) (energy 0. p) 1e-8)))
  (test-case "commensurate orbits come back, after six looks, three and one, and not before"
    (for ([p (list swings-in-6 turns-in-3 turns-in-1)] [n '(6 3 1)])
      (for ([k (in-range 1 (+ n 1))])
        (define q (after k p))
        (define away (+ (abs (car q)) (abs (- (cadr q) p))))
        (if (= k n) (check-= away 0 1e-7) (check-true (> away 0.5))))))
  (test-case "so does any other start on the contour"
    (define start (after 1 swings-in-6))
    (define half ((iterated-map T 1) (* 1/2 (car start))
                                     (sqrt (+ (square swings-in-6)
                                              (* -2 beta (- 1 (cos (* 1/2 (car start)))))))
                                     list void))
    (define back ((iterated-map T 6) (car half) (cadr half) list void))
    (check-= (car back) (car half) 1e-7)
    (check-= (cadr back) (cadr half) 1e-7))
  (test-case "on the separatrix points come to the upright rest"
    (check-= (car (after 8 separatrix)) pi 1e-3)
    (for ([k 6])
      (check-true (< (- pi (car (after (+ k 1) separatrix))) (- pi (car (after k separatrix)))))))
  (test-case "rests are fixed points"
    (check-equal? (fixed-point-kind (find-fixed-point T (up 0. 0.))) 'elliptic)
    (check-equal? (fixed-point-kind (find-fixed-point T (up pi 0.))) 'hyperbolic)))
