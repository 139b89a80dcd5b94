#lang racket/base
;; Colour maps: from a share, 0 to 1, to a colour.  In each the luminance rises from end to end, so
;; that a reader who is colour-blind, and a copier, tell more from less.
;;
;; viridis and plasma are those of Matplotlib (N. Smith and S. van der Walt 2015), cividis that of
;; J. Nuñez, C. Anderton and R. Renslow (2018), by colours at equal distances.

(require (only-in racket/math exact-floor exact-round))

(provide color-map-names color-between (struct-out color-bar))

;; The meaning of colours: their map by name, with the values of its ends; label : string
;; Prefab, as a frame is written into files.
(struct color-bar (colors from to label) #:prefab)

(define color-maps
  '((dusk #x14145a #x3c3ca0 #xc83c46 #xfaa032 #xfff096)
    (viridis #x440154 #x472d7b #x3b528b #x2c728e #x21918c #x28ae80 #x5ec962 #xaddc30 #xfde725)
    (cividis #x00224e #x123570 #x3b496c #x575d6d #x707173 #x8a8678 #xa59c74 #xc3b369 #xe1cc55
             #xfee838)
    (plasma #x0d0887 #x5302a3 #x8b0aa5 #xb83289 #xdb5c68 #xf48849 #xfebd2a #xf0f921)
    (grey #x000000 #xffffff)))

(define color-map-names (map car color-maps))

(define nowhere '(190 190 190))

;; -> (list red green blue); grey where there is no number
(define (color-between name share)
  (define stops (cdr (assq name color-maps)))
  (cond [(not (= share share)) nowhere]
        [else
         (define at (* (max 0.0 (min 1.0 share)) (- (length stops) 1)))
         (define k (min (- (length stops) 2) (exact-floor at)))
         (for/list ([a (in-list (color->parts (list-ref stops k)))]
                    [b (in-list (color->parts (list-ref stops (+ k 1))))])
           (exact-round (+ a (* (- at k) (- b a)))))]))

(define (color->parts c)
  (for/list ([shift (in-list '(-16 -8 0))]) (bitwise-and 255 (arithmetic-shift c shift))))
