#lang racket/base
;; Elements of SVG, and how they look, which goes into a style sheet: black turns into the
;; ink of the page and white into its paper, so that a dark page can be read.

(require net/base64
         racket/class
         racket/math
         racket/string
         (only-in xml xexpr->string)
         "plane-vector.rkt")

(provide (struct-out look) (struct-out element)
         path-element dot-element ellipse-element text-element image-element clipped
         line-kind joined-lines
         moved color->css number->svg element->markup look->css)

;; stroke, fill : as CSS has colors, or #f; dashes : in widths of the line, or #f
(struct look (stroke width dashes fill even-odd?) #:transparent)

;; tag : as "path"; attributes : text; look : look, or #f if the attributes say all
;; body : the markup or the element inside
(struct element (tag attributes look body) #:transparent)

;; name, value : in turn; a number as SVG has them, or a text
(define (attributes . names-and-values)
  (let loop ([rest names-and-values])
    (if (null? rest)
        ""
        (string-append (format " ~a=\"~a\"" (car rest)
                               (if (real? (cadr rest)) (number->svg (cadr rest)) (cadr rest)))
                       (loop (cddr rest))))))

;; class-of : look -> name of its class
(define (element->markup e class-of)
  (define style (if (element-look e) (attributes 'class (class-of (element-look e))) ""))
  (define tag (element-tag e))
  (define head (string-append "<" tag (element-attributes e) style))
  (define body (element-body e))
  (define inside (if (element? body) (element->markup body class-of) body))
  (if (string=? inside "") (string-append head "/>") (format "~a>~a</~a>" head inside tag)))

(define (look->css l)
  (define width (number->svg (look-width l)))
  (string-append
   (format "fill:~a;" (or (look-fill l) "none"))
   (if (and (look-fill l) (look-even-odd? l)) "fill-rule:evenodd;" "")
   (if (look-stroke l) (format "stroke:~a;stroke-width:~a;" (look-stroke l) width) "")
   (if (and (look-stroke l) (look-dashes l))
       (format "stroke-dasharray:~a;"
               (string-join (for/list ([d (in-list (look-dashes l))])
                              (number->svg (* d (look-width l))))
                            " "))
       "")))

;; ---------------------------------------------------------------------------
;; Elements

(define (path-element path look)
  (define-values (closed open) (send path get-datum))
  (define pieces
    (append (for/list ([points (in-list closed)]) (string-append (piece points) "Z"))
            (if (null? open) '() (list (piece open)))))
  (element "path" (attributes 'd (string-append* pieces)) look ""))

;; Points, of which those with six numbers end curves.
(define (piece points)
  (string-append*
   (for/list ([p (in-list points)] [i (in-naturals)])
     (string-append (cond [(= i 0) "M"] [(= (vector-length p) 6) "C"] [else "L"])
                    (numbers (vector->list p))))))

;; Properties shared by elements that one path can draw: lines without an area, in one clip; or #f
(define (line-kind e)
  (define body (element-body e))
  (cond [(element? body)
         (define inner (line-kind body))
         (and inner (cons (element-attributes e) inner))]
        [else
         (define l (element-look e))
         (and (string=? (element-tag e) "path") l (not (look-fill l)) (list l))]))

;; es : elements of one line-kind
(define (joined-lines es)
  (define first-one (car es))
  (if (element? (element-body first-one))
      (struct-copy element first-one [body (joined-lines (map element-body es))])
      (struct-copy element first-one
                   [attributes (attributes 'd (string-append* (map path-data es)))])))

(define (path-data e) (cadr (regexp-match #rx"\"(.*)\"" (element-attributes e))))

(define (numbers xs) (string-join (map number->svg xs) " "))

;; A point of a line of that look: as wide as the line, and round
(define (dot-element center l)
  (define radius (/ (look-width l) 2))
  (ellipse-element center radius radius (look #f 1 #f (look-stroke l) #f)))

(define (ellipse-element center rx ry look)
  (element "ellipse" (attributes 'cx (at-x center) 'cy (at-y center) 'rx rx 'ry ry) look ""))

;; x, y : upper left corner; ascent : from there down to the line
(define (text-element text x y width ascent angle font color alpha m)
  (define base (+ y ascent))
  (define turn
    (if (zero? angle)
        ""
        (format " rotate(~a)" (numbers (list (- (radians->degrees angle)) x y)))))
  (element "text"
           (attributes 'x x 'y base 'textLength (max 0.1 width)
                       'transform (string-append (matrix->svg m) turn)
                       'style (format "~afill:~a" (font->css font) (color->css color alpha)))
           #f
           (xexpr->string text)))

(define (matrix->svg m) (format "matrix(~a)" (numbers (vector->list m))))

(define (image-element bitmap x y width height alpha m)
  (define port (open-output-bytes))
  (send bitmap save-file port 'png)
  (define content (bytes->string/latin-1 (base64-encode (get-output-bytes port) #"")))
  (element "image"
           (attributes 'x x 'y y 'width width 'height height 'opacity alpha
                       'transform (matrix->svg m)
                       'href (string-append "data:image/png;base64," content))
           #f ""))

;; A picture within a picture shows nothing outside of itself.  box : left, top, width, height
(define (clipped e box m)
  (define-values (left top width height) (vector->values box))
  (define corner (moved m left top))
  (define opposite (moved m (+ left width) (+ top height)))
  (define-values (x y)
    (values (min (at-x corner) (at-x opposite)) (min (at-y corner) (at-y opposite))))
  (define-values (w h)
    (values (abs (- (at-x opposite) (at-x corner))) (abs (- (at-y opposite) (at-y corner)))))
  (element "svg"
           (attributes 'x x 'y y 'width w 'height h 'viewBox (numbers (list x y w h)))
           #f e))

;; A point under a transformation, as racket/draw's vectors have it.
(define (moved m x y)
  (vector (+ (* (vector-ref m 0) x) (* (vector-ref m 2) y) (vector-ref m 4))
          (+ (* (vector-ref m 1) x) (* (vector-ref m 3) y) (vector-ref m 5))))

;; ---------------------------------------------------------------------------
;; Values

;; To a hundredth of a pixel, in as few letters as that takes.
(define (number->svg x)
  (define n (if (and (real? x) (< -1e9 x 1e9)) (exact-round (* 100 x)) 0))
  (define-values (whole hundredths) (quotient/remainder (abs n) 100))
  (string-append (if (< n 0) "-" "")
                 (if (and (= whole 0) (> hundredths 0)) "" (number->string whole))
                 (vector-ref decimals hundredths)))

;; "" ".01" ... ".1" ".11" ...
(define decimals
  (for*/vector ([tenths (in-range 10)] [rest (in-range 10)])
    (cond [(= 0 tenths rest) ""]
          [(= rest 0) (format ".~a" tenths)]
          [else (format ".~a~a" tenths rest)])))

(define (color->css c alpha)
  (define-values (r g b a)
    (values (send c red) (send c green) (send c blue) (* alpha (send c alpha))))
  (cond [(< a 1) (format "rgba(~a,~a,~a,~a)" r g b (number->svg a))]
        [(= 0 r g b) "var(--ink)"]
        [(= 255 r g b) "var(--paper)"]
        [else (format "rgb(~a,~a,~a)" r g b)]))

(define (font->css f)
  (format "font:~a ~a ~apx ~a;"
          (if (memq (send f get-style) '(italic slant)) "italic" "normal")
          (if (memq (send f get-weight) '(bold semibold heavy ultraheavy)) "bold" "normal")
          (number->svg (send f get-size #t))
          (case (send f get-family)
            [(roman) "'DejaVu Serif',Georgia,serif"]
            [(modern) "'DejaVu Sans Mono',Menlo,monospace"]
            [else "'DejaVu Sans',Verdana,sans-serif"])))
