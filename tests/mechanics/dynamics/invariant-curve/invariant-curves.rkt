#lang racket/base
;; Which way an orbit goes beside a rotation, and the curve between those that are ahead and behind.

(require mechanics mechanics/book
         "../../support/checks.rkt" "../../support/messages.rkt")

(define golden (- 1 (/ 1 golden-ratio)))

(test-case "a rotation goes ahead of all slower ones, by whatever it is faster, from any angle"
  (for* ([w (list golden (- 1 golden) (/ (sqrt 2) 10))]
         [start '(0 1.3 -2.0 6.0)]
         [off '(1e-1 1e-3 1e-5 1e-8)])
    (define (way x) (which-way? w start 1 (circle-map x)))
    (check-equal? (list (way (+ w off)) (way (- w off))) '(1 -1) (format "~a ~a ~a" w start off))))

;; Turns by y² for each step
(define (twist x y return fail) (return ((principal-value :2pi) (+ x (* :2pi y y))) y))

(test-case "the curve of a twist without kicks is where it turns by the rotation number"
  (for* ([w (list golden (- 1 golden))] [start '(0 2.0)])
    (check-= (find-invariant-curve twist w start 0.4 0.9 1e-10) (sqrt w) 1e-10)))

(test-case "orbits that begin above a circle are ahead, those below it behind, however near"
  (define T (standard-map 0.95))
  (define c (invariant-circle T golden))
  (for* ([start '(0 1.0 2.0 3.1 4.5)] [off '(1e-2 1e-5 1e-8 1e-10)])
    (define J (invariant-circle-ordinate c start))
    (check-equal? (list (which-way? golden start (+ J off) T) (which-way? golden start (- J off) T))
                  '(1 -1)
                  (format "~a ~a" start off)))
  (check-= (find-invariant-curve T golden 2.0 1.6 3.2 1e-9) (invariant-circle-ordinate c 2.0) 2e-9))

;; In parts of a turn, ω and ω + 1/10 lead to .38 .76 .15 .53 -.09 and to .48 .96 .45 .93 .41: at
;; the fifth step the first one comes nearer to its start than it was, the other does not.
(test-case "whether an orbit is ahead shows after so many steps, or not yet"
  (define (way most) (which-way? golden 0 1 (circle-map (+ golden 1/10)) most))
  (check-equal? (map way '(0 4 5 6)) '(0 0 1 1)))

(says
 [(find-invariant-curve 0.3 golden 0 twist 1 1e-3)
  "find-invariant-curve: the map comes first; it was given after the number 0.3"]
 [(find-invariant-curve golden twist 0 0.4 0.9 1e-3)
  "find-invariant-curve: the map comes first; it was given after the number 0.3819660112501052"])
