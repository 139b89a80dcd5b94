#lang racket/base
;; Text in an SVG as text, which is found, copied and edited, where Cairo draws outlines of letters.
;; Each is fitted to the width that it has in the picture, whatever the reader's typeface.

(require (only-in xml xexpr->string)
         "plot-canvas.rkt")

(provide svg-with-text)

;; texts : of caught texts; typeface : a string; centimeters : the width of the picture, or #f
(define (svg-with-text svg texts typeface centimeters)
  (define end (caar (regexp-match-positions #rx#"</svg>[^>]*$" svg)))
  (define group `(g ([font-family ,typeface] [fill "black"]) ,@(map text-element texts)))
  (define whole
    (bytes-append (subbytes svg 0 end) (string->bytes/utf-8 (xexpr->string group)) #"\n"
                  (subbytes svg end)))
  (if centimeters (in-centimeters whole centimeters) whole))

(define (text-element t)
  (define-values (x y) (values (number (caught-x t)) (number (caught-y t))))
  `(text ([x ,x] [y ,y] [font-size ,(number (caught-size t))]
          [textLength ,(number (caught-length t))]
          ,@(if (caught-turned? t) `([transform ,(format "rotate(-90 ~a ~a)" x y)]) '()))
         ,(caught-string t)))

(define (number x) (real->decimal-string x 2))

;; The size of the page alone: the viewBox keeps its units.
(define (in-centimeters svg width)
  (define m (regexp-match #px#"width=\"([\\d.]+)\" height=\"([\\d.]+)\"" svg))
  (define (length part) (string->number (bytes->string/latin-1 part)))
  (define height (* width (/ (length (caddr m)) (length (cadr m)))))
  (regexp-replace (regexp-quote (car m)) svg
                  (string->bytes/latin-1
                   (format "width=\"~acm\" height=\"~acm\"" (number width) (number height)))))
