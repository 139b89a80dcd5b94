#lang racket/base
;; Animations on the screen, where there is one.  The window and the libraries for it are
;; loaded when the first is opened.

(require (only-in racket/math exact-ceiling exact-round)
         "animation.rkt" "drawing.rkt" "film.rkt" "pictures-on-demand.rkt"
         "../../generic/on-demand.rkt"
         "../display/program-end.rkt"
         "../plot/window-screen.rkt")

(require-on-demand #:in-this-thread ["player.rkt" loaded? open-player make-performance]
                   ["../plot/window.rkt" wait-until])

(provide animation-show
         ;; for tests: -> the window
         animation-window)

;; wait? : until the reader closes the window; 'at-end : at the end of the program
(define (animation-show a #:wait? [wait? 'at-end])
  (define closed (make-semaphore))
  (animation-window a (lambda () (semaphore-post closed)))
  (stay-open! wait? (semaphore-peek-evt closed) wait-until))

(define (animation-window a [closed void])
  (define who 'animation-show)
  (check-animation who a)
  (check-screen who loaded? "(animation-save animation \"motion.gif\"), or \"motion.html\"")
  (check-drawing-library who)
  (define f (animation-film a))
  (define s (film-schedule f))
  (define pictures ((animation-pictures a)))
  (define-values (width height) (scenery-size pictures))
  (define pause (exact-ceiling (/ 1000 (schedule-rate s))))
  (open-player (make-performance (film-title f) width height (schedule-seconds s) pause
                                 (lambda (share)
                                   (scenery->pict pictures (time-at-share s share)))
                                 (lambda (share) (time->text s share)))
               closed))

(define (time->text s share)
  (define t (+ (schedule-start s) (* share (schedule-span s))))
  (define hundredths (exact-round (* 100 (abs t))))
  (define-values (whole part) (quotient/remainder hundredths 100))
  (format "t = ~a~a.~a~a" (if (< t 0.0) "-" "") whole (quotient part 10) (remainder part 10)))
