#lang racket/base
;; Text in an SVG as text, which is found, copied and edited, where Cairo draws outlines of letters.
;; Each is fitted to the width that it has in the picture, whatever the reader's typeface.

(require racket/string
         "plot-canvas.rkt")

(provide svg-with-text)

;; texts : of caught texts; typeface : a string; centimeters : the width of the picture, or #f
(define (svg-with-text svg texts typeface centimeters)
  (define-values (end) (caar (regexp-match-positions #rx#"</svg>[^>]*$" svg)))
  (define group
    (format "<g font-family=\"~a\" fill=\"black\">\n~a</g>\n" (escaped typeface)
            (string-append* (map text-element texts))))
  (define whole (bytes-append (subbytes svg 0 end) (string->bytes/utf-8 group) (subbytes svg end)))
  (if centimeters (in-centimeters whole centimeters) whole))

(define (text-element t)
  (define-values (x y) (values (number (caught-x t)) (number (caught-y t))))
  (format "<text x=\"~a\" y=\"~a\" font-size=\"~a\" textLength=\"~a\"~a>~a</text>\n"
          x y (number (caught-size t)) (number (caught-length t))
          (if (caught-turned? t) (format " transform=\"rotate(-90 ~a ~a)\"" x y) "")
          (escaped (caught-string t))))

(define (number x) (real->decimal-string x 2))

(define (escaped text)
  (for/fold ([text text]) ([pair (in-list '(("&" "&amp;") ("<" "&lt;") ("\"" "&quot;")))])
    (string-replace text (car pair) (cadr pair))))

;; The size of the page alone: the viewBox keeps its units.
(define (in-centimeters svg width)
  (define m (regexp-match #px#"width=\"([\\d.]+)\" height=\"([\\d.]+)\"" svg))
  (define (length part) (string->number (bytes->string/latin-1 part)))
  (define height (* width (/ (length (caddr m)) (length (cadr m)))))
  (regexp-replace (regexp-quote (car m)) svg
                  (string->bytes/latin-1
                   (format "width=\"~acm\" height=\"~acm\"" (number width) (number height)))))
