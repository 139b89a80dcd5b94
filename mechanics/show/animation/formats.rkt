#lang racket/base
;; Animations in the formats of files.

(require file/convertible
         racket/math
         (only-in pict pict-width scale hc-append vl-append text)
         "film.rkt" "gif.rkt" "playing-page.rkt" "scenery.rkt"
         "../../error/complain.rkt")

(provide convert-scenery scenery->gif scenery->page)

;; As file/convertible asks: motion where the format has any, else a strip of pictures.
(define (convert-scenery s request default)
  (case request
    [(gif-bytes) (scenery->gif 'animation s)]
    [(html-bytes) (scenery->page 'animation s)]
    [else (convert (strip s) request default)]))

(define strip-count 4)

(define (strip s)
  (define when-taken (film-schedule (scenery-film s)))
  (apply hc-append 12
         (for/list ([k (in-range strip-count)])
           (define t (time-at-share when-taken (/ k (- strip-count 1.0))))
           (define picture (scenery->pict s t))
           (vl-append 4
                      (scale picture (min 1 (/ 130 (pict-width picture))))
                      (text (format "t = ~a" (rounded t)) 'roman 12)))))

(define (rounded t)
  (define x (/ (exact-round (* 100 t)) 100))
  (if (integer? x) x (exact->inexact x)))

;; ---------------------------------------------------------------------------

(define most-pictures 3000)

;; The rate that a GIF can have, in hundredths of a second; browsers take less than 2 for 10.
(define (scenery->gif who s)
  (define given (film-schedule (scenery-film s)))
  (define delay (max 2 (exact-round (/ 100 (schedule-rate given)))))
  (define when-taken (struct-copy schedule given [rate (/ 100 delay)]))
  (define n (check-count who when-taken))
  (define-values (width height) (scenery-size s))
  (define port (open-output-bytes))
  (write-gif (for/vector #:length n ([i (in-range n)])
               (lambda () (scenery->pict s (schedule-time when-taken i))))
             width height delay port)
  (get-output-bytes port))

(define (scenery->page who s)
  (check-count who (film-schedule (scenery-film s)))
  (make-page s))

(define (check-count who when-taken)
  (define n (schedule-count when-taken))
  (unless (<= n most-pictures)
    (complain who
              (string-append "~a pictures are too many for a file; at most ~a\n"
                             "  choose fewer #:frames-per-second, a greater #:speed, "
                             "or a shorter time by #:from and #:to")
              n most-pictures))
  n)
