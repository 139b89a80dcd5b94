#lang racket/base
;; SICM 3.9, The Standard Map (pp. 277–281), in the reader's own language.

(require mechanics)

(provide standard-map standard-map-inverse Henon-map Henon-map-inverse)

(define whole-turn (principal-value :2pi))

;; A rotor that is kicked once in each period, K being the strength of the kicks (p. 278).
(define ((standard-map K) theta I return fail)
  (define kicked (+ I (* K (sin theta))))
  (return (whole-turn (+ theta kicked))
          (whole-turn kicked)))

(define ((standard-map-inverse K) theta I return fail)
  (define before (- theta I))
  (return (whole-turn before)
          (whole-turn (- I (* K (sin before))))))

;; Hénon's quadratic map: a shear, and a turn by alpha.  It keeps areas, its points may leave
;; for ever (exercise at the end of 3.9).
(define ((Henon-map alpha) x y return fail)
  (define sheared (- y (square x)))
  (return (- (* x (cos alpha)) (* sheared (sin alpha)))
          (+ (* x (sin alpha)) (* sheared (cos alpha)))))

(define ((Henon-map-inverse alpha) x y return fail)
  (define before (+ (* x (cos alpha)) (* y (sin alpha))))
  (return before
          (+ (* y (cos alpha)) (* -1 x (sin alpha)) (square before))))
