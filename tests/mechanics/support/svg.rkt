#lang racket/base
;; Lines stroked by an SVG picture, whichever version of Cairo has written it: colors are in
;; the style of a path or attributes of it, as rgb(100%,0%,0%), with spaces and more or
;; fewer digits, as rgb(255, 0, 0), or as #ff0000.

(require "checks.rkt")

(provide strokes)      ; (strokes svg color) -> (listof natural)

;; The numbers of points of the lines stroked in a color, a list of three bytes.  A path may have
;; several, each of which begins with a move; a move alone strokes nothing.
(define (strokes svg color)
  (for*/list ([path (in-list (regexp-match* #px"<path [^>]*>" svg))]
              #:when (equal? (stroke-color path) color)
              [line (in-list (regexp-match* #px"M [^M]*" path))]
              #:when (regexp-match? #px"[LC] " line))
    (length (regexp-match* #px"[MLC] " line))))

(define (stroke-color path)
  (define found (regexp-match #px"\\bstroke(?::|=\")\\s*([^;\"]+)" path))
  (and found (color-of (cadr found))))

(define (color-of text)
  (cond [(regexp-match #px"^rgb\\(\\s*([\\d.]+%?)\\s*,\\s*([\\d.]+%?)\\s*,\\s*([\\d.]+%?)\\s*\\)"
                       text)
         => (lambda (parts) (map byte-of (cdr parts)))]
        [(regexp-match #px"^#([[:xdigit:]]{2})([[:xdigit:]]{2})([[:xdigit:]]{2})" text)
         => (lambda (parts) (for/list ([p (in-list (cdr parts))]) (string->number p 16)))]
        [else #f]))

(define (byte-of text)
  (define n (string->number (car (regexp-match #px"^[\\d.]+" text)) 10 'read 'decimal-as-exact))
  (if (regexp-match? #rx"%$" text) (round (* 255/100 n)) n))

(module+ test
  (test-case "colors as Cairo 1.16, Cairo 1.18 and others write them"
    (define (path attributes) (format "<path ~a d=\"M 0 0 L 1 1 L 2 0\"/>" attributes))
    (for ([attributes '("style=\"fill:none;stroke-width:1;stroke:rgb(3.921569%,0%,100%);\""
                        "fill=\"none\" stroke-width=\"1\" stroke=\"rgb(3.92157%, 0%, 100%)\""
                        "stroke=\"rgb(10, 0, 255)\""
                        "style=\"stroke:#0A00ff\"")])
      (check-equal? (strokes (path attributes) '(10 0 255)) '(3) attributes)
      (check-equal? (strokes (path attributes) '(11 0 255)) '() attributes))
    (check-equal? (strokes "<path stroke=\"#000000\" d=\"M 0 0 L 0 0 Z M 0 0 M 1 1 L 2 2 L 3 1\"/>"
                           '(0 0 0))
                  '(2 3))
    (check-equal? (strokes (path "fill=\"rgb(0%, 0%, 0%)\" stroke-width=\"1\"") '(0 0 0)) '())))
