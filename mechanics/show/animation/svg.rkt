#lang racket/base
;; Elements of SVG, and how they look, which goes into a style sheet: black turns into the
;; ink of the page and white into its paper, so that a dark page can be read.

(require net/base64
         racket/class
         racket/math
         racket/string
         (only-in xml xexpr->string)
         "plane.rkt")

(provide (struct-out look) (struct-out element)
         path-element ellipse-element text-element image-element clipped
         moved color->css number->svg element->markup look->css)

;; stroke, fill : as CSS has colors, or #f; dashes : in widths of the line, or #f
(struct look (stroke width dashes fill even-odd?) #:transparent)

;; head : such as "path d=\"M0 0\""; look : look, or #f if the head says all
;; body : what is inside, as markup
(struct element (head look body) #:transparent)

;; class-of : look -> name of its class
(define (element->markup e class-of)
  (define style (if (element-look e) (format " class=\"~a\"" (class-of (element-look e))) ""))
  (define tag (car (string-split (element-head e) " ")))
  (define body (element-body e))
  (define inside (if (element? body) (element->markup body class-of) body))
  (if (string=? inside "")
      (format "<~a~a/>" (element-head e) style)
      (format "<~a~a>~a</~a>" (element-head e) style inside tag)))

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
  (element (format "path d=\"~a\"" (string-append* pieces)) look ""))

;; Points, of which those with six numbers end curves.
(define (piece points)
  (string-append*
   (for/list ([p (in-list points)] [i (in-naturals)])
     (string-append (cond [(= i 0) "M"] [(= (vector-length p) 6) "C"] [else "L"])
                    (numbers (vector->list p))))))

(define (numbers xs) (string-join (map number->svg xs) " "))

(define (ellipse-element center rx ry look)
  (element (format "ellipse cx=\"~a\" cy=\"~a\" rx=\"~a\" ry=\"~a\""
                   (number->svg (at-x center)) (number->svg (at-y center))
                   (number->svg rx) (number->svg ry))
           look ""))

;; x, y : upper left corner; ascent : from there down to the line
(define (text-element text x y width ascent angle font color alpha m)
  (define base (+ y ascent))
  (define turn
    (if (zero? angle)
        ""
        (format " rotate(~a ~a ~a)" (number->svg (- (radians->degrees angle)))
                (number->svg x) (number->svg y))))
  (element
   (format (string-append "text x=\"~a\" y=\"~a\" textLength=\"~a\" transform=\"matrix(~a)~a\" "
                          "style=\"~afill:~a\"")
           (number->svg x) (number->svg base) (number->svg (max 0.1 width))
           (numbers (vector->list m)) turn (font->css font) (color->css color alpha))
   #f
   (xexpr->string text)))

(define (image-element bitmap x y width height alpha m)
  (define port (open-output-bytes))
  (send bitmap save-file port 'png)
  (element
   (format (string-append "image x=\"~a\" y=\"~a\" width=\"~a\" height=\"~a\" opacity=\"~a\" "
                          "transform=\"matrix(~a)\" href=\"data:image/png;base64,~a\"")
           (number->svg x) (number->svg y) (number->svg width) (number->svg height)
           (number->svg alpha) (numbers (vector->list m))
           (bytes->string/latin-1 (base64-encode (get-output-bytes port) #"")))
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
  (define place (numbers (list x y w h)))
  (element (format "svg x=\"~a\" y=\"~a\" width=\"~a\" height=\"~a\" viewBox=\"~a\""
                   (number->svg x) (number->svg y) (number->svg w) (number->svg h) place)
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
