#lang mechanics
;; A section of the motion of Hénon and Heiles  (SICM 3.6.3, Figure 3.21)
;;
;; Energy 1/6, where a star can just escape: nearly all is filled by one orbit.

(require mechanics/plot "star.rkt")

(define T (star-map 1/6))
(define win
  (star-section 1/6 '((0.1 0.05) (0.3 0.) (0. 0.) (-0.2 0.) (0.15 0.))
                300))

win

(module+ main
  (require "save.rkt")
  (save-figure win "figure-3-21.png"))

(module+ test
  (require rackunit)
  (test-case "the first crossing"
    (define once (T 0.1 0. list void))
    (check-= (car once) 0.5488146036799 1e-9)
    (check-= (cadr once) -0.003258636757405 1e-9))
  (test-case "one orbit comes nearly everywhere"
    (define cells
      (for/fold ([seen '()]) ([v (frame-points win)])
        (define cell (list (floor (* 10 (ref v 0))) (floor (* 10 (ref v 1)))))
        (if (member cell seen) seen (cons cell seen))))
    (check-true (> (length cells) 75))))
