#lang mechanics
;; Lines in space, drawn as they are seen from the front, the right and above.

(require mechanics/plot)

(provide seen draw-line draw-curve draw-axes)

;; Directions to the right and up, for the eye; a tuple of three -> a tuple of two
(define-values (right above) (values (up -0.5 0.866 0) (up -0.3 -0.173 0.938)))
(define (seen p) (up (dot-product p right) (dot-product p above)))

(define (draw-line f from to #:color [color 0] #:width [width 1] #:style [style 'solid])
  (define-values (a b) (values (seen from) (seen to)))
  (plot-line f (ref a 0) (ref a 1) (ref b 0) (ref b 1) #:color color #:width width #:style style))

;; curve : number -> a tuple of three
(define (draw-curve f curve from to #:color [color 0] #:style [style 'solid])
  (plot-parametric f (lambda (t) (seen (curve t))) from to #:color color #:style style))

;; Three axes of unit length, turned by a matrix
(define (draw-axes f M #:color [color 0] #:width [width 1] #:style [style 'solid])
  (for ([axis (list (up 1 0 0) (up 0 1 0) (up 0 0 1))])
    (draw-line f (up 0 0 0) (* M axis) #:color color #:width width #:style style)))
