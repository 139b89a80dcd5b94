#lang racket/base
;; The colours of layers: three bytes, names, and numbers, of which neighbours can be told apart.

(require (only-in racket/class send)
         (only-in racket/draw the-color-database)
         (only-in racket/math exact-floor pi))

(provide color->bytes color-name?)

;; c : as a style has it -> (list red green blue)
(define (color->bytes c)
  (cond [(list? c) c]
        [(exact-integer? c) (numbered (modulo c 128))]
        [else (define named (find c))
              (list (send named red) (send named green) (send named blue))]))

(define (color-name? name) (and (find name) #t))

(define (find name) (send the-color-database find-color (format "~a" name)))

;; 0 is black, 1 to 120 are hues, 121 to 127 greys, from light to dark.
(define (numbered n)
  (cond [(= n 0) '(0 0 0)]
        [(> n 120) (define grey (exact-floor (* 128 (expt (/ (- 128 n) 7) 3/4))))
                   (list grey grey grey)]
        [else (hue->bytes (remainder (* 59 (hue-step (- n 1))) 360))]))

;; Six hues go around the circle: first the three primary ones, then those between.
(define (hue-step k) (+ (vector-ref #(0 2 4 1 3 5) (remainder k 6)) (* 18 (quotient k 6))))

;; Hues are spread, and some darkened, so that all are as easy to see on white.
(define (hue->bytes degrees)
  (define wave (sin (* 3 pi (/ degrees 360))))
  (define sector (/ (- degrees (* 25 wave)) 60))
  (define value (+ 1/2 (/ wave 6)))
  (for/list ([middle (in-list '(0 2 4))])      ; sectors of red, green, blue
    (define distance (abs (- sector middle)))
    (define around (min distance (- 6 distance)))
    (exact-floor (* 255 value (max 0.0 (min 1.0 (- 2 around)))))))
