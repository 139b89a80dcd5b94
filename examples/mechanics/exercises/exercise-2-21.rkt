#lang mechanics
;; Exercise 2.21 (SICM 2.14): the rotation of Mercury
;; Checked: the orbit's equation; that three turns in two orbits are stable; how far off is caught
;; How: Lagrange's equations of the orbit, a mean over two orbits, and motions

;; Mercury turns three times while it goes round twice.  With ε = 0.026 and the eccentricity 0.2,
;; for which initial rates of turning does it stay there?

;; a. The true anomaly goes at n √(1 − e²) (a/R)², with a/R = (1 + e cos f)/(1 − e²): with this
;; the orbit solves Lagrange's equations of Kepler's problem, n² a³ = μ.
(define (R f) (/ (* 'a (- 1 (square 'e))) (+ 1 (* 'e (cos f)))))
(define (fdot f) (* 'n (sqrt (- 1 (square 'e))) (square (/ 'a (R f)))))
(define (L (up t (up r phi) (up rdot phidot)))
  (+ (* 1/2 (+ (square rdot) (square (* r phidot)))) (/ (* (square 'n) (cube 'a)) r)))
(define (along g) (lambda (f) (* ((D g) f) (fdot f))))
(define accelerations
  ((Lagrangian->acceleration L)
   (up 't (up (R 'f) 'f) (up ((along R) 'f) (fdot 'f)))))
(define right (verify-equal accelerations (up ((along (along R)) 'f) ((along fdot) 'f))))
right

;; A slip: equal areas, but at the rate of a circle.
(define (fdot-slip f) (* 'n (square (/ 'a (R f)))))
(define slip (verify-equal (fdot-slip 'f) (fdot 'f)))
(verdict-status slip)
(define on-circle (verify-again slip '(= e 0)))
on-circle

;; b. With θ = 3/2 n t + γ and γ slow, γ̈ = −½ n² ε² H sin 2γ, with H the mean of
;; (a/R)³ cos(3 n t − 2 f): it librates at the rate n ε √H.  By the eccentric anomaly E,
(define (H e)
  (define (integrand E)
    (define f (* 2 (atan (* (sqrt (+ 1 e)) (sin (/ E 2))) (* (sqrt (- 1 e)) (cos (/ E 2))))))
    (/ (cos (- (* 3 (- E (* e (sin E)))) (* 2 f))) (square (- 1 (* e (cos E))))))
  (/ (definite-integral integrand 0 (* 2 :pi)) (* 2 :pi)))
(define (rate h) (* 0.026 (sqrt h)))
(map rate (list (* 7/2 0.2) (H 0.2)))

;; A motion, seen at each second perihelion: it starts at γ = 0, a little too fast.
(define orbit (* 2 pi))
(define (sysder) (spin-orbit-sysder orbit 0.026 0.2))
(define (gammas turns n)
  (define advance (state-advancer sysder))
  (define start (up 0. 0. (* turns orbit) 0.))
  (for/list ([k (in-range 1 (+ n 1))])
    (- (ref (advance start (* 2. k) 1e-11) 1) (* 3/2 orbit 2 k))))

;; c. γ̇ up to n ε √H is caught, for the energy ½ γ̇² − ¼ n² ε² H cos 2γ may not pass that at
;; γ = π/2.  With initial rates of 3/2 ± that, and a little less and more:
(define width (rate (H 0.2)))
(define (caught? share)
  (andmap (lambda (g) (< (abs g) (/ pi 2))) (gammas (+ 3/2 (* share width)) 60)))
(list width (map caught? '(-0.9 0.5 0.9)) (map caught? '(-1.1 1.1)))

(module+ test
  (require rackunit)
  (test-case "the orbit is Kepler's, and the slip holds on a circle only"
    (check-pred proved? right)
    (check-pred refuted? slip)
    (check-pred proved? on-circle))
  (test-case "the rate of libration to first order in e, and with all orders"
    (check-= (rate (* 7/2 0.2)) .02175316069 1e-10)
    (check-= (rate (H 0.2)) 0.0207953 1e-7))
  (test-case "small librations have that rate: γ is 0 again after half a period"
    (define found (gammas (+ 3/2 0.0005) 30))
    (define k (for/first ([g found] [k (in-naturals)] #:when (< g 0)) k))
    (check-= (* 2 k) (/ 1/2 width) 2))
  (test-case "what is caught and what is not"
    (check-equal? (map caught? '(-0.9 0.5 0.9)) '(#t #t #t))
    (check-equal? (map caught? '(-1.1 1.1)) '(#f #f))))
