#lang racket/base
;; Trees as picts: names in italics, functions upright, fractions on the axis of the line.
;;
;; Every pict made here has its base line at its descent, so that picts put beside one
;; another by `hbl-append` stand level.

(require (only-in pict blank colorize hbl-append)
         "pict-glyphs.rkt" "pict-parts.rkt" "renderer.rkt" "visible.rkt"
         "../../algebra/notation/name.rkt" "../../algebra/notation/tree.rkt"
         racket/class
         (only-in racket/string string-join))

(provide tree->pict)

;; size : of letters, in units of the drawing; color : a color's name, or #f for that of the
;; text around
(define (tree->pict t size color)
  (define drawn (send (new pict-renderer% [g (make-glyphs size)]) draw t))
  (if color (colorize drawn color) drawn))

(define pict-pieces%
  (class typesetter%
    (init-field g)                ; the letters and their size
    (super-new)
    (define/override (prose text) (upright g (visible text)))
    (define/override (verbatim text) (typewriter g (visible text)))
    (define/override (number text) (upright g text))
    (define/override (roman text) (upright g text))
    (define/override (sign text form)
      (if (eq? form 'prefix) (upright g text) (spaced-sign g text)))
    (define/override (comma) (upright g ", "))
    (define/override (small-space) (blank (thin-space g) 0))
    (define/override (indent n) (indentation g n))
    (define/override (in-row picts) (apply hbl-append picts))
    (define/override (in-table cells) (rows g cells))
    (define/override (in-lines picts sort) (lines g picts))
    (define/override (divided above below) (over g above below))
    (define/override (superscripted base exponent) (with-exponent g base exponent))
    (define/override (rooted body) (under-root g body))
    (define/override (enclosed open picts close trees)
      (fenced g open (apply hbl-append picts) close))))

(define pict-renderer%
  (class pict-pieces%
    (super-new)
    (inherit-field g)
    (define/override (draw-exponent t) (send (new pict-renderer% [g (smaller g)]) draw t))
    ;; Words need more room between them than letters.
    (define/override (factor-space factors)
      (define (word? f) (and (name? f) (eq? 'word (parts-sort (name-parts (name-symbol f))))))
      (blank (if (ormap word? factors) (* 2 (thin-space g)) (thin-space g)) 0))
    (define/override (letters p)
      (define base (parts-base p))
      (with-dots g
        (if (memq (parts-sort p) '(letter word)) (italic g base) (upright g (visible base)))
        (parts-dots p)
        #:tall? (regexp-match? #px"^(?:\\p{Lu}|[bdfhikltjβδζθλξϕψ])" base)))
    (define/override (indexed base below above)
      (with-indices g base (index below (smaller g)) (index above (smaller g))))
    (define/override (derivative-sign text)
      (if (string=? text "D") (italic g text) (upright g text)))
    (define/override (draw-scientific digits exponent)
      (define text (regexp-replace #rx"-" (number->string exponent) "−"))
      (hbl-append (upright g (format "~a × 10" digits)) (raised g (upright (smaller g) text))))))

;; -> a pict, or #f
(define (index texts g)
  (define text (string-join texts ","))
  (cond [(null? texts) #f]
        [(regexp-match? #px"^[0-9,]+$" text) (upright g text)]
        [else (italic g text)]))
