#lang racket/base
;; The layers of a picture, one above the other, each drawn in one style.  They are prefab, so that
;; a frame can be written into files.

(require "points.rkt"
         "../../error/message-words.rkt")

(provide (struct-out style) (struct-out layer) (struct-out field) (struct-out raster)
         layer-kind layers-now layers->text
         stored-layer restored-layer)

;; kind : 'points, 'lines (segments apart), 'curve, 'level or 'image
;; size : diameter of points or width of lines, in pixels; #f for points whose number decides
;; dash, label : of a line, as plot has them; the text of the legend (axes/axis-label.rkt), or #f
(struct style (kind color size dash label) #:prefab)

;; data : points; a snapshot of them where the layer may not change any more; of a
;; 'level a field, of an 'image a raster
(struct layer (style data) #:prefab)

;; A function of the plane at the nodes of a grid from end to end of the view, as
;; `count` rows of y with as many values each, and the level that is drawn of it.
(struct field (rows count level) #:prefab)

;; Colours of equal parts of the view, `width` across and `height` down: bytes of alpha, red,
;; green, blue.  bar : the meaning of these, or #f
(struct raster (width height bytes bar) #:prefab)

(define (layer-kind l) (style-kind (layer-style l)))

;; The layers as they are now.
(define (layers-now layers)
  (for/list ([l (in-list layers)]) (with-data l points? take-snapshot)))

;; The layer with other data, if it has such.
(define (with-data l such? change)
  (define data (layer-data l))
  (if (such? data) (layer (layer-style l) (change data)) l))

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

;; Two points, and a separator from the next line.
(define (line-count s) (quotient (snapshot-count s) 3))

;; ---------------------------------------------------------------------------
;; Layers in files

;; A layer that stays, with a list of vectors for its points.
(define (stored-layer l) (with-data l snapshot? snapshot->vectors))

(define (restored-layer l) (with-data l list? vectors->points))
