#lang mechanics
;; Exercise 2.21 (SICM 2.11): Mercury's resonance
;; Checked: the rate at which Mercury librates about three turns in two orbits
;; How: by averaging over two orbits, and against a motion

;; Mercury turns three times while it goes round twice.  At which rate does it librate about that,
;; with ε = 0.026 and the eccentricity 0.2?

;; Near the resonance θ = 3/2 n t + γ, with a γ that changes slowly.  Its mean acceleration is
;; −½ n² ε² H sin 2γ, with H the mean of (a/R)³ cos(3 n t − 2 f): a Hansen coefficient.
(define (H e)
  ;; over an orbit, by the eccentric anomaly E: n t = E − e sin E
  (define (integrand E)
    (define R (- 1 (* e (cos E))))
    (define f (* 2 (atan (* (sqrt (+ 1 e)) (sin (/ E 2))) (* (sqrt (- 1 e)) (cos (/ E 2))))))
    (/ (cos (- (* 3 (- E (* e (sin E)))) (* 2 f))) (square R)))
  (/ (definite-integral integrand 0 (* 2 :pi)) (* 2 :pi)))

;; An attempt, to first order in e; and the next term, of third order.
(define (attempt e) (* 7/2 e))
(define (better e) (- (* 7/2 e) (* 123/16 (cube e))))
(for/list ([e '(0.001 0.01 0.1)]) (/ (H e) (attempt e)))
(for/list ([e '(0.001 0.01 0.1)]) (/ (H e) (better e)))

;; A slip: the mean for one turn in one orbit, which does not vanish on a circle.
(define (slip e) (- 1 (* 5/2 (square e))))
(/ (H 0.01) (slip 0.01))

;; γ̈ = −½ n² ε² H sin 2γ librates at the rate n ε √H: in units of n,
(define (rate h) (* 0.026 (sqrt h)))
(map rate (list (attempt 0.2) (better 0.2) (H 0.2)))

;; A motion, seen at each second perihelion: γ returns to 0 after half a libration.
(define orbit (* 2 :pi))
(define mercury
  (evolve-trajectory (spin-orbit-sysder orbit 0.026 0.2) (up 0 0. (* 3/2 1.0005 orbit) 0.) 60
                     #:tolerance 1e-12))
(define (gamma-at t) (- (ref (mercury t) 1) (* 3/2 orbit t)))
(define-values (before after-that)
  (let ((t (for/first ([t (in-range 2 60 2)] #:when (< (gamma-at t) 0)) t)))
    (values (- t 2) t)))
(define half-libration
  (+ before (* 2 (/ (gamma-at before) (- (gamma-at before) (gamma-at after-that))))))
(define measured (/ 1/2 half-libration))
(list measured (/ measured (rate (H 0.2))))

(module+ test
  (require rackunit)
  (test-case "to first order, and to third"
    (check-= (rate (attempt 0.2)) .02175316069 1e-10)
    (check-= (/ (H 0.001) (attempt 0.001)) 1 1e-5)
    (check-= (/ (H 0.1) (better 0.1)) 1 1e-3))
  (test-case "the slip is of another order"
    (check-true (< (/ (H 0.01) (slip 0.01)) 0.04)))
  (test-case "the motion librates at the mean rate"
    (check-= (/ measured (rate (H 0.2))) 1 0.01)))
