#lang racket/base
;; SVG made shorter: places of points in tenths of a pixel, where Cairo writes millionths.  The
;; outlines of letters, among the definitions, stay as they are.  The group of all has no name, so
;; that pictures that look the same are the same.

(require (only-in racket/math exact-round))

(provide shortened-svg)

;; The size is in pixels; some versions of Cairo call them points.
(define (shortened-svg svg)
  (define text
    (regexp-replace #px#"width=\"([\\d.]+)pt\" height=\"([\\d.]+)pt\"" svg
                    #"width=\"\\1\" height=\"\\2\""))
  (define end (cdar (regexp-match-positions #rx#"^(.*</defs>)?" text)))
  (define drawn (regexp-replace #px#"<g id=\"surface\\d+\">" (subbytes text end) #"<g>"))
  (bytes-append (subbytes text 0 end) (regexp-replace* #rx#" d=\"[^\"]*\"" drawn shortened-path)))

;; A dot is a line to its beginning: not all that show SVG draw a point that is closed.
(define (shortened-path d)
  (regexp-replace* #px#"M ([-.\\d]+ [-.\\d]+) Z"
                   (regexp-replace* #px#"-?\\d+[.]\\d+" d in-tenths)
                   #"M \\1 L \\1"))

;; #"-12.345678" -> #"-12.3"
(define (in-tenths digits)
  (define tenths (exact-round (* 10 (string->number (bytes->string/latin-1 digits)))))
  (define-values (whole tenth) (quotient/remainder (abs tenths) 10))
  (string->bytes/latin-1
   (string-append (if (< tenths 0) "-" "") (number->string whole)
                  (if (= tenth 0) "" ".") (if (= tenth 0) "" (number->string tenth)))))
