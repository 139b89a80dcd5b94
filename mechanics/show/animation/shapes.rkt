#lang racket/base
;; Shapes of a drawing: lines, discs and labels in the plane, in the units of the
;; system that is drawn, x to the right and y up.  Widths of lines and sizes of letters are
;; in pixels.
;;
;; Points are given as (up x y) or (cons x y).  Shapes are drawn in their order; wherever
;; shapes are expected, lists of shapes will do, however deep.

(require "../../error/complain.rkt"
         "../../generic/describe.rkt" "../../generic/value-struct.rkt"
         "../../generic/wrong-argument.rkt"
         "../plot/plotted-number.rkt" "../plot/style.rkt")

(provide polyline disc label flat-shapes
         (struct-out stroke) (struct-out spot) (struct-out lettering)
         ink faint accents
         point-of check-length check-lengths)

;; Colors that can be read on white paper and on a dark page: the first turns white there.
(define ink "black")
(define faint '(140 140 140))
(define accents '((38 110 190) (205 85 35) (40 140 90) (140 80 170) (170 130 20)))

;; points : vectors of two flonums; color, fill : color or #f, for none
;; heads : 'none, 'end or 'both, with arrows there
(value-struct stroke (points closed? color width dash fill heads)
  #:text (lambda (s) "(polyline ...)"))

;; center : vector of two flonums; radius : in units
(value-struct spot (center radius color width fill)
  #:text (lambda (s) "(disc ...)"))

;; shift : vector, in pixels, x to the right and y up
(value-struct lettering (at text color size anchor italic? shift)
  #:text (lambda (s) (format "(label ~s ...)" (lettering-text s))))

;; ---------------------------------------------------------------------------
;; Making them

(define (polyline points #:color [color ink] #:width [width 2] #:style [dash 'solid]
                  #:closed? [closed? #f] #:fill [fill #f] #:arrows [heads 'none])
  (define who 'polyline)
  (unless (and (list? points) (pair? points) (pair? (cdr points)))
    (complain-of-argument who "a list of at least two points" points))
  (check-color who color)
  (check-color who fill)
  (check-width who width)
  (check-dash who dash)
  (unless (memq heads '(none end both))
    (complain-of-argument who "where arrows are: 'none, 'end or 'both" heads))
  (stroke (for/list ([p (in-list points)] [i (in-naturals)])
            (point-of who (lambda () (format "the point ~a" i)) p))
          (and closed? #t) color width dash fill heads))

(define (disc center radius #:color [color ink] #:width [width 1.5] #:fill [fill #f])
  (define who 'disc)
  (check-color who color)
  (check-color who fill)
  (check-width who width)
  (spot (point-of who "the center" center)
         (check-length who "the radius" radius) color width fill))

(define anchors '(center left right above below))

;; anchor : where the text is as seen from the point; "θ_1" has an index
(define (label at text #:color [color ink] #:size [size 15] #:anchor [anchor 'center]
               #:italic? [italic? #t] #:shift [shift #(0 0)])
  (define who 'label)
  (check-argument who string? text "a string")
  (check-color who color)
  (unless (and (real? size) (<= 4 size 200))
    (complain-of-argument who "a size of letters from 4 to 200 pixels" size))
  (unless (memq anchor anchors)
    (complain-of-argument who "where the text is, one of (center left right above below)" anchor))
  (lettering (point-of who "the place" at) text color size anchor (and italic? #t)
             (point-of who "the shift" shift)))

;; ---------------------------------------------------------------------------
;; Checks

(define (point-of who what p)
  (define-values (x y) (plane-point who what p))
  (vector x y))

;; A positive number, as a flonum.
(define (check-length who what x)
  (define length (check-number who what x))
  (unless (> length 0.0)
    (complain-of-argument who (format "a positive number as ~a" what) x))
  length)

;; A list of such numbers, as flonums.  fits? : is the list one that is expected?
(define (check-lengths who expected what fits? xs)
  (check-argument who (lambda (xs) (and (list? xs) (fits? xs))) xs expected)
  (for/list ([x (in-list xs)]) (check-length who what x)))

;; Names are looked up where there is a library that knows them, when they are drawn.
(define (check-color who color)
  (unless (or (not color) (string? color) (symbol? color)
              (and (list? color) (= (length color) 3) (andmap byte? color)))
    (complain-of-argument who "a color: a name such as 'red, a list of three bytes, or #f"
                          color)))

(define (check-width who width)
  (unless (and (real? width) (<= 0 width 100))
    (complain-of-argument who "a width in pixels, from 0 to 100" width)))

;; A shape, or lists of them -> list of shapes
(define (flat-shapes who x)
  (let flatten ([x x] [rest '()])
    (cond [(or (stroke? x) (spot? x) (lettering? x)) (cons x rest)]
          [(null? x) rest]
          [(pair? x) (flatten (car x) (flatten (cdr x) rest))]
          [else
           (complain who "expected shapes, such as (disc (up 0 1) 0.1)\n  given: ~a"
                     (describe-with-value x))])))
