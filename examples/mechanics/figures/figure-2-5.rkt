#lang mechanics
;; Nutation: the tilt of the top against the time  (SICM 2.10, Figure 2.5)
;;
;; As in the book π − θ is drawn, so that a top that nods goes down.

(require "top.rkt")

(define picture (draw-against-time (lambda (s) (- pi (tilt s))) 2.2 2.9 "π − θ"))

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-2-5.png"))

(module+ test
  (require rackunit)
  (define tilts (for/list ([t (in-range 0. 2. 0.0005)]) (tilt (top t))))
  (test-case "it nods between two tilts, those of the cubic"
    (define range (nutation-range A C gMR start))
    (check-= (apply min tilts) (car range) 1e-5)
    (check-= (apply max tilts) (cadr range) 1e-5)
    (check-= (cadr range) .809714734259 1e-11))
  (test-case "nine times and a half in two seconds"
    (define middle (/ (+ (apply min tilts) (apply max tilts)) 2))
    (define crossings
      (for/sum ([a tilts] [b (cdr tilts)]) (if (< (* (- a middle) (- b middle)) 0) 1 0)))
    (check-equal? crossings 19)))
