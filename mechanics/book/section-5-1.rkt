#lang racket/base
;; SICM 5.1, Point Transformations (pp. 336–341), in the reader's own language.

(require mechanics)

(provide H-central translating H-free H-prime)

;; A particle in a central potential energy V(r), in rectangular coordinates (p. 339).
(define ((H-central m V) (up t x p))
  (+ (/ (square p) (* 2 m))
     (V (sqrt (square x)))))

;; Coordinates that move with the velocity v (p. 340).
(define ((translating v) (up t q p))
  (+ q (* v t)))

(define ((H-free m) (up t q p))
  (/ (square p) (* 2 m)))

;; The free particle in space, in the moving coordinates: H∘C + K (p. 341).
(define velocity-of-frame (up 'v^x 'v^y 'v^z))

(define (H-prime state)
  ((+ (compose (H-free 'm) (F->CH (translating velocity-of-frame)))
      (F->K (translating velocity-of-frame)))
   state))
