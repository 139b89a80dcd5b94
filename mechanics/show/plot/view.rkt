#lang racket/base
;; The window of the plane that a picture shows, its size on paper and the texts
;; beside it.

(require "axes/axis-label.rkt"
         "../../generic/wrong-argument.rkt"
         "../../error/complain.rkt")

(provide (struct-out view) make-view plain-axes? check-bounds)

;; bounds : (list x-min x-max y-min y-max), flonums; width, height : pixels
;; title : string or #f; x-label, y-label : of axes/axis-label.rkt
;; aspect-ratio : positive real or #f
;; scales : of both axes, a list of 'linear and 'log
;; Prefab, as a frame is written into files.
(struct view (bounds title x-label y-label width height aspect-ratio scales) #:prefab)

(define (make-view bounds title x-label y-label width height aspect-ratio scales)
  (check-bounds 'frame bounds)
  (for ([scale (in-list scales)] [axis (in-list '("x" "y"))]
        [low (in-list (list (car bounds) (caddr bounds)))])
    (check-argument 'frame (lambda (s) (memq s '(linear log))) scale "a scale, 'linear or 'log")
    (when (and (eq? scale 'log) (<= low 0))
      (complain 'frame "a logarithmic axis begins above 0\n  least ~a: ~a" axis low)))
  (check-argument 'frame (lambda (t) (or (not t) (string? t))) title "a string as title, or #f")
  (for ([size (in-list (list width height))])
    (unless (and (exact-positive-integer? size) (<= 50 size 10000))
      (complain-of-argument 'frame "a size of 50 to 10000 pixels" size)))
  (view (map real->double-flonum bounds) title
        (checked-label 'frame "label" x-label) (checked-label 'frame "label" y-label) width height
        (ratio aspect-ratio bounds) scales))

(define (plain-axes? v) (equal? (view-scales v) '(linear linear)))

;; who : the procedure that was given them
(define (check-bounds who bounds)
  (for ([x (in-list bounds)]
        [what (in-list '("least x" "greatest x" "least y" "greatest y"))])
    (unless (and (real? x) (< (abs (real->double-flonum x)) +inf.0))
      (complain-of-argument who (format "a real number as ~a" what) x)))
  (define-values (x-min x-max y-min y-max) (apply values bounds))
  (check-ascending who "x" x-min x-max)
  (check-ascending who "y" y-min y-max))

(define (check-ascending who axis low high)
  (unless (< (real->double-flonum low) (real->double-flonum high))
    (complain-showing who (format "the least ~a is not below the greatest" axis)
                      "least" low
                      "greatest" high)))

;; 'equal: one unit is as long on both axes.
(define (ratio aspect-ratio bounds)
  (define-values (x-min x-max y-min y-max) (apply values bounds))
  (cond [(eq? aspect-ratio 'equal) (/ (- x-max x-min) (- y-max y-min))]
        [(or (not aspect-ratio) (and (real? aspect-ratio) (< 0 aspect-ratio +inf.0)))
         aspect-ratio]
        [else (complain-of-argument 'frame "'equal, a positive ratio of width to height, or #f"
                                    aspect-ratio)]))
