#lang racket/base
;; Paths that solve an equation of motion, as they are or but for kinks and jumps.

(require "../statement.rkt")

(provide (struct-out proposal) motions)

;; Does `path`, in t, solve q'' = force?  places : times where it may not be smooth
(struct proposal (path force places) #:prefab)

(define (motions)
  (define force (pick '(none constant oscillator)))
  (define path (random-motion force))
  (define kink (random-kink))
  (define bent
    (case (random 4)
      [(0) (substituted path 't (car kink))]
      [(1) `(+ ,path (* ,(pick '(1 1/3 -2)) ,(car kink)))]
      [(2) `(* ,path ,(car kink))]
      [(3) (pick (list path `(abs ,path) `(sqrt (square ,path)) `(+ ,path (sgn ,(car kink)))))]))
  (proposal bent force (append (cdr kink) '(0 1 -1))))

(define (random-motion force)
  (case force
    [(none) (pick '((+ 1 (* 2 t)) t 3 (- 2 t) (- t 1)))]
    [(constant) (pick '((- t (/ (square t) 2)) (/ (- 1 (square t)) 2)))]
    [else (pick '((cos t) (sin t) (+ (cos t) (* 2 (sin t))) (cos (- t 1))))]))

;; Functions that look like a constant or like t if differentiated piece by piece; and where
;; they may not be smooth.
(define half-turn 3141592653589793238462643383279502884197/2000000000000000000000000000000000000000)
(define (random-kink)
  (define c (pick '(0 1 2 -3/2)))
  (define u (if (eqv? c 0) 't `(- t ,c)))
  (pick (list `((abs ,u) ,c) `((sgn ,u) ,c) `((sqrt (square ,u)) ,c) `((* ,u (sgn ,u)) ,c)
              `((/ (abs ,u) ,u) ,c) `((* (sgn ,u) (abs ,u)) ,c) `((square (sgn ,u)) ,c)
              `((atan (tan t)) ,half-turn) `((acosh (cosh ,u)) ,c) `((asinh (sinh ,u)) ,c)
              `((atan (/ 1 ,u)) ,c) `((abs (+ 1 (square ,u))) ,c) `((expt (square ,u) 1/2) ,c)
              `((sqrt (expt ,u 4)) ,c) `((asin (sin t)) ,half-turn) `((/ (square ,u) ,u) ,c)
              `((/ ,u (abs ,u)) ,c) `((- (abs ,u) (sqrt (square ,u))) ,c))))
