#lang racket/base
;; The legend of a picture: the labels of its layers, each with a line or a point in its style.

(require (only-in racket/class send)
         "../picture-layer.rkt" "plot-axes.rkt" "../plot-canvas.rkt" "../plot-colors.rkt")

(provide draw-legend)

(define inset 7)                 ; from the axes

;; In the upper left corner of the area, on a ground through which curves are pale.
(define (draw-legend dc a layers)
  (define labelled (filter (lambda (l) (style-label (layer-style l))) layers))
  (unless (null? labelled)
    (define-values (x y) (values (+ (area-left a) inset) (+ (area-top a) inset)))
    (define-values (space line descent above) (send dc get-text-extent " " #f #t 0))
    (define symbol-width (* 4 (- line descent)))
    (define skip (+ line descent))
    (define texts
      (for/list ([l (in-list labelled)] [k (in-naturals)])
        (make-text dc (style-label (layer-style l)) (+ x space) (+ y descent (* k skip)) 0 0)))
    (define symbol-x (+ x (* 4 space) (apply max (map text-width texts))))
    (send dc set-alpha 0.85)
    (draw-box dc x y (- (+ symbol-x symbol-width space) x)
              (+ (* 1.5 descent) (* skip (length texts))) "white" 0.5)
    (send dc set-alpha 1.0)
    (for ([t (in-list texts)] [l (in-list labelled)])
      (draw-text dc t)
      (draw-symbol dc l symbol-x (+ (text-top t) (/ line 2)) symbol-width))))

(define (draw-symbol dc l x y width)
  (define s (layer-style l))
  (define middle (cons (+ x (/ width 2)) y))
  (define line
    (if (eq? (layer-kind l) 'points) (list middle middle) (list (cons x y) (cons (+ x width) y))))
  (draw-strokes dc (list line) (color->bytes (style-color s)) (style-size s) (style-dash s)))
