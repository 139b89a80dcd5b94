#lang racket/base
;; The layers of a picture, one above the other, each drawn in one style.

(require "points.rkt"
         "../../error/message-words.rkt")

(provide (struct-out style) (struct-out layer) (struct-out field) (struct-out raster)
         layer-kind layers-now layers->text
         layer->datum datum->layer)

;; kind : 'points, 'lines (segments apart), 'curve, 'level or 'image
;; size : diameter of points or width of lines, in pixels
;; dash, label : of a line, as plot has them; what the legend says, or #f
(struct style (kind color size dash label))

;; data : points; a snapshot of them where the layer may not change any more; of a
;; 'level a field, of an 'image a raster
(struct layer (style data))

;; A function of the plane at the nodes of a grid from end to end of the view, as
;; `count` rows of y with as many values each, and the level that is drawn of it.
(struct field (rows count level))

;; Colours of equal parts of the view, `width` across and `height` down: bytes of alpha, red,
;; green, blue.
(struct raster (width height bytes))

(define (layer-kind l) (style-kind (layer-style l)))

;; The layers as they are now.
(define (layers-now layers)
  (for/list ([l (in-list layers)])
    (define data (layer-data l))
    (layer (layer-style l) (if (points? data) (take-snapshot data) data))))

;; Layers that stay -> "2 curves, 1 line, 100 points"
(define (layers->text layers)
  (define (total count kinds)
    (for/sum ([l (in-list layers)] #:when (memq (layer-kind l) kinds))
      (count (layer-data l))))
  (define parts
    (for/list ([noun (in-list '("image" "curve" "line" "point"))]
               [n (in-list (list (total (lambda (data) 1) '(image))
                                 (total (lambda (data) 1) '(curve level))
                                 (total line-count '(lines))
                                 (total snapshot-count '(points))))]
               #:unless (zero? n))
      (counted n noun)))
  (if (null? parts) "empty" (joined parts)))

;; Two points, and what separates them from the next line.
(define (line-count s) (quotient (snapshot-count s) 3))

;; ---------------------------------------------------------------------------
;; Layers in files

;; A layer that stays -> lists and vectors
(define (layer->datum l)
  (define s (layer-style l))
  (define data (layer-data l))
  (list (list (style-kind s) (style-color s) (style-size s) (style-dash s) (style-label s))
        (cond [(field? data) (list (field-rows data) (field-count data) (field-level data))]
              [(raster? data) (list (raster-width data) (raster-height data) (raster-bytes data))]
              [else (snapshot->vectors data)])))

(define (datum->layer datum)
  (define s (apply style (car datum)))
  (define data (cadr datum))
  (layer s (case (style-kind s)
             [(level) (apply field data)]
             [(image) (apply raster data)]
             [else (vectors->points data)])))
