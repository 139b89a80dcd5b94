#lang racket/base
;; The letters of formulas as picts, and the measures of a line of them.

(require (only-in pict blank text)
         (only-in racket/math exact-round))

(provide make-glyphs smaller glyphs-size ems
         italic upright typewriter thin-space spaced-sign indentation axis rule)

;; size : of the letters; known : text pict by style and text, each made once
(struct glyphs (size known) #:authentic)

(define (make-glyphs size) (glyphs size (make-hash)))

;; Of exponents and indices; those of these are no smaller than can be read.
(define (smaller g)
  (hash-ref! (glyphs-known g) 'smaller
             (lambda () (make-glyphs (max (min 7 (glyphs-size g)) (* 0.72 (glyphs-size g)))))))

(define (glyph g style string)
  (define styles (hash-ref! (glyphs-known g) style make-hash))
  (define size (max 1 (exact-round (glyphs-size g))))
  (hash-ref! styles string (lambda () (text string style size))))

(define (italic g string) (glyph g '(italic . roman) string))
(define (upright g string)
  (define unit (assoc string '(("𝐢" . "i") ("𝐣" . "j") ("𝐤" . "k"))))
  (if unit
      (glyph g '(bold . roman) (cdr unit))
      (glyph g 'roman string)))
(define (typewriter g string) (glyph g 'modern string))

(define (ems g n) (* n (glyphs-size g)))
(define (thin-space g) (ems g 0.15))
(define (indentation g n) (blank (ems g n) 0))
(define (spaced-sign g sign) (upright g (string-append " " sign " ")))

;; How high above the base line fraction bars are, and how thick.
(define (axis g) (ems g 0.33))
(define (rule g) (max 0.75 (ems g 0.05)))
