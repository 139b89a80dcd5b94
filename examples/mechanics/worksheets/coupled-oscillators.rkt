#lang mechanics/worksheet
;; SICM 1.6: two masses on springs.

(title "Coupled oscillators")

(text "Two masses m on a line are held by springs of stiffness k to the walls on either side, and "
      "by one of stiffness c to each other. Their elongations are x and y.")

(define (L (up t (up x y) (up vx vy)))
  (- (* 1/2 'm (+ (square vx) (square vy)))
     (* 1/2 'k (+ (square x) (square y)))
     (* 1/2 'c (square (- x y)))))

(exercise L-coupled Lagrangian "A Lagrangian."
  (coordinates x y) (key L) (points 2)
  (slip (lambda ((up t (up x y) (up vx vy)))
          (- (* 1/2 'm (+ (square vx) (square vy)))
             (* 1/2 'k (+ (square x) (square y)))
             (* 1/2 'c (square (+ x y)))))
        "When both are moved alike, the spring between them is not stretched."))

(exercise equations-coupled equations "The equations of motion."
  (coordinates x y) (of L) (points 2))

(exercise frequencies expression
  "The squares of the angular frequencies, the slower one first: (up slow fast)."
  (key (up (/ 'k 'm) (/ (+ 'k (* 2 'c)) 'm)))
  (points 2))

(exercise beats solution "A motion in which x and y are opposite, with amplitude `a`."
  (coordinates x y) (of L)
  (key (lambda (t)
         (define f (* 'a (cos (* (sqrt (/ (+ 'k (* 2 'c)) 'm)) t))))
         (up f (- f))))
  (points 2))
