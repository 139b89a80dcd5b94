#lang racket/base
;; Pictures as files: one alone, or several in rows as the panels of a figure.
;;
;; A figure for print has a width in centimetres and letters of a size in points: its panels are
;; laid out again, so wide that with letters of 12 units they come out in that size.

(require (only-in racket/class new send send*)
         (only-in racket/draw bitmap-dc% current-ps-setup make-bitmap make-font pdf-dc% svg-dc%)
         (only-in racket/math exact-ceiling exact-round)
         "picture.rkt" "plot-canvas.rkt" "svg-digits.rkt" "svg-text.rkt" "view.rkt")

(provide draw-to-bytes draw-figure)

;; format : as `convert` names it -> bytes, or #f if it is none of these
(define (draw-to-bytes v layers format)
  (define-values (width height) (values (view-width v) (view-height v)))
  (define (draw dc) (draw-picture dc v layers 0 0))
  (case format
    [(png-bytes) (bitmap-bytes width height draw 1)]
    [(png@2x-bytes) (bitmap-bytes width height draw 2)]
    [(svg-bytes) (shortened-svg (page-bytes svg-dc% width height draw 1))]
    [(pdf-bytes) (pdf-bytes width height draw (pdf-scale))]
    [else #f]))

;; How many points a unit is by itself
(define (pdf-scale)
  (define-values (x-scale y-scale) (values (box 1) (box 1)))
  (send (current-ps-setup) get-scaling x-scale y-scale)
  (unbox x-scale))

;; The canvas scales drawings on it by pdf-scale, but not the page.
(define (pdf-bytes width height draw points-per-unit)
  (define scale (/ points-per-unit (pdf-scale)))
  (define (draw-scaled dc)
    (unless (= scale 1) (send dc set-scale scale scale))
    (draw dc))
  (page-bytes pdf-dc% width height draw-scaled points-per-unit [interactive #f] [as-eps #t]))

(define (bitmap-bytes width height draw scale)
  (define image (make-bitmap width height #:backing-scale scale))
  (draw (new bitmap-dc% [bitmap image]))
  (define port (open-output-bytes))
  (send image save-file port 'png #:unscaled? #t)
  (get-output-bytes port))

(define-syntax-rule (page-bytes context% w h draw scale field ...)
  (let* ([port (open-output-bytes)]
         [dc (new context% [width (* scale w)] [height (* scale h)] [output port] field ...)])
    (send* dc (start-doc "picture") (start-page))
    (draw dc)
    (send* dc (end-page) (end-doc))
    (get-output-bytes port)))

;; ---------------------------------------------------------------------------
;; Figures

(define letter-size 12)          ; in units
(define dots-per-inch 300)       ; of a PNG that has a width in centimetres

;; rows : lists of panels, each a view and its layers, as a pair
;; centimeters : the width of all, or #f for the pixels of the views; points : the size of letters
;; font : the name of a typeface, or #f
(define (draw-figure rows format centimeters points font)
  (define inches (and centimeters (/ centimeters 2.54)))
  (define wide (apply max (map row-width rows)))
  (define panels
    (if inches (resized rows (/ (* inches 72 letter-size) points wide)) rows))
  (define width (apply max (map row-width panels)))
  (define height (apply + (map row-height panels)))
  (define (draw dc) (draw-rows dc panels))
  (define (drawn)
    (case format
      [(png-bytes)
       (bitmap-bytes width height draw (if inches (/ (* inches dots-per-inch) width 1.0) 1))]
      [(svg-bytes) (svg-figure width height draw centimeters font)]
      [else (pdf-bytes width height draw (if inches (/ (* 72 inches) width) (pdf-scale)))]))
  (if (or inches font) (call-with-font (figure-font font) drawn) (drawn)))

(define (svg-figure width height draw centimeters font)
  (define-values (svg texts)
    (call-catching-text
     (lambda () (shortened-svg (page-bytes svg-dc% width height draw 1)))))
  (svg-with-text svg texts (or font "Times, serif") centimeters))

(define (figure-font name)
  (if name
      (make-font #:size letter-size #:size-in-pixels? #t #:face name #:family 'roman)
      (make-font #:size letter-size #:size-in-pixels? #t #:family 'roman)))

(define (row-width row) (apply + (map (lambda (p) (view-width (car p))) row)))
(define (row-height row) (apply max (map (lambda (p) (view-height (car p))) row)))

(define (resized rows factor)
  (for/list ([row (in-list rows)])
    (for/list ([p (in-list row)])
      (define v (car p))
      (cons (struct-copy view v
                         [width (exact-ceiling (* factor (view-width v)))]
                         [height (exact-round (* factor (view-height v)))])
            (cdr p)))))

(define (draw-rows dc rows)
  (for/fold ([y 0]) ([row (in-list rows)])
    (for/fold ([x 0]) ([p (in-list row)])
      (draw-picture dc (car p) (cdr p) x y)
      (+ x (view-width (car p))))
    (+ y (row-height row)))
  (void))
