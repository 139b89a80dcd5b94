#lang racket/base
;; The bar beside a picture that explains its colours.

(require "../color-map.rkt" "../plot-canvas.rkt" "plot-ticks.rkt")

(provide bar-texts draw-color-bar)

(define gap 10)                  ; from the axes to the bar, and from there to numbers and label
(define thickness 12)

;; right, top, bottom : edges of the area within the axes -> list of text
(define (bar-texts dc b right top bottom)
  (define x (+ right gap thickness gap))
  (define numbers
    (for/list ([t (in-list (ticks-of b))] #:when (tick-label t))
      (make-text dc (tick-label t) x (place-on b top bottom t) 0 1/2)))
  (define aside (+ x gap (apply max 0 (map text-width numbers))))
  (cons (make-text dc (color-bar-label b) aside (/ (+ top bottom) 2) 0 1/2 #t) numbers))

(define (ticks-of b)
  (define-values (from to) (values (color-bar-from b) (color-bar-to b)))
  (ticks-between (min from to) (max from to)))

(define (place-on b top bottom t)
  (define share
    (/ (- (tick-value t) (color-bar-from b)) (- (color-bar-to b) (color-bar-from b))))
  (- bottom (* share (- bottom top))))

(define pieces 128)

(define (draw-color-bar dc b right top bottom)
  (define left (+ right gap))
  (define height (/ (- bottom top) pieces))
  (for ([k (in-range pieces)])
    (draw-box dc left (- bottom (* (+ k 1) height)) thickness (+ height 0.5)
              (color-between (color-bar-colors b) (/ (+ k 0.5) pieces)) #f))
  (draw-box dc left top thickness (- bottom top) #f 0.5)
  (define end (+ left thickness))
  (draw-strokes dc
                (for/list ([t (in-list (ticks-of b))] #:when (tick-label t))
                  (define y (place-on b top bottom t))
                  (list (cons (- end 4) y) (cons end y)))
                '(0 0 0) 1))
