#lang racket/base
;; The window in which maps are explored, where there is a display or a program, Xvfb, that
;; stands for one.  It is tested in a process of its own, which has that display.

;; for-label: compiled with this file, for processes that run it.
(require (for-label "../../runner/fixture/explorer.rkt")
         mechanics/plot
         (only-in mechanics/show/explorer/explore-in-window background)
         racket/class
         racket/list
         racket/runtime-path
         "../../support/checks.rkt" "../../support/display.rkt" "../../support/skip.rkt")

(define-runtime-path program "../../runner/fixture/explorer.rkt")
(define-runtime-path in-DrRacket "../../runner/fixture/explorer-as-in-DrRacket.rkt")

;; What is drawn on it is kept.
(define recorder%
  (class object%
    (super-new)
    (field [drawn '()])
    (define/public (set-pen . _) (void))
    (define/public (draw-line . ends) (set! drawn (append drawn (list ends))))
    (define/public (draw-point i j) (set! drawn (append drawn (list (list i j)))))))

(test-case "beneath the orbits is what the frame had: lines and points, at their pixels"
  (define f (frame 0 10 0 10))
  (plot-line f 1 2 3 4)
  (plot-point f 5 6)
  (define dc (new recorder%))
  ((background f) dc (lambda (x y) (values (* 10 x) (* 100 y))))
  (check-equal? (get-field drawn dc) '((10.0 200.0 30.0 400.0) (50.0 600.0))))

(skip-unless (eq? (system-type) 'unix) "this system has no displays that could be missing"
  (test-case "without a display there is a message, the same every time, and no window"
    (define-values (output refusals) (run-without-display program 'explore-map))
    (check-equal? (length refusals) 2 output)
    (check-equal? (remove-duplicates refusals) (list (car refusals)))
    (check-regexp-match
     (string-append "\n  without one orbits start where that is said: "
                    "\\(explore-map f map n #:starts \\(list \\(up x y\\) ...\\)\\), or #:grid")
     output)))

(test-windows
 "clicks start orbits, drags zoom, keys undo, clear, save and close"
 program
 '("shown" "an orbit appears" "and another" "both seen" "undone" "more of it"
   "zoomed" "whole again" "cleared" "brought back"
   "written: explored-1.png and explored-1.rkt" "all of the canvas"
   "closed, with its orbit in the frame" "redrawn"
   "other clicks do not wait" "says what failed"
   "told of 0.5" "told of 1.5" "told of 2.5" "told of 3.5" "and goes on"
   "points at their places" "no title above" "done"))

(skip-unless (find-executable-path "xdotool")
             "xdotool (Debian: apt install xdotool) is not installed: nobody moves the mouse"
  (test-windows
   "as DrRacket runs a program: it waits, its value is a picture, Stop ends it"
   in-DrRacket
   '("shown" "the program waits" "closed, and the program goes on"
     "its value is a picture of the orbits" "shown" "waits again" "stopped"
     "and the window is gone")))
