#lang racket/base
;; Maps explored on the screen, where there is one.  The window and the libraries for it are
;; loaded when the first is opened.

(require racket/class
         "exploration.rkt" "exploration-program.rkt" "../plot/frame.rkt" "../plot/style.rkt"
         "../plot/view.rkt"
         "../plot/window-screen.rkt"
         "../../error/computed-once.rkt" "../../error/message-words.rkt"
         "../../generic/on-demand.rkt")

(require-on-demand #:in-this-thread
                   ["explorer.rkt" loaded? open-explorer wait-until-closed])

(provide explore-in-window
         ;; for tests; open-exploration gives the explorer
         open-exploration background)

;; Waits until the window is closed; then the frame has the explored orbits.
(define (explore-in-window who f map n starts source)
  (wait-until-closed (open-exploration who f map n starts source)))

(define (open-exploration who f map n starts source)
  (check-screen who loaded?
                "(explore-map f map n #:starts (list (up x y) ...)), or #:grid (list 5 5)"
                "without one orbits start where that is said: ")
  (define v (frame-view f))
  (define folder (current-directory))
  (define namespace (current-namespace))
  (define missing (once (lambda () (names-missing source namespace))))
  (open-explorer (or (view-title v) "explore-map") (view-width v) (+ 40 (view-height v))
                 (make-exploration map n (view-bounds v))
                 starts
                 (background f)
                 (lambda (e picture)
                   (parameterize ([current-directory folder])
                     (save e v source (missing) picture)))
                 (lambda (e) (draw-explored who e f))))

;; The reader has seen the points.
(define (draw-explored who e f)
  (exploration->dots
   e (lambda (color x y) (add-dot! who f (make-style who 'points color #f 'solid #f) x y)))
  (seen f))

;; Draws the earlier contents of the frame in grey.
(define ((background f) dc point->pixel)
  (send dc set-pen "gray" 1 'solid)
  (for ([c (in-list (frame-curves f))])
    (for ([p (in-list c)] [q (in-list (if (null? c) '() (cdr c)))])
      (define-values (i1 j1) (point->pixel (vector-ref p 0) (vector-ref p 1)))
      (define-values (i2 j2) (point->pixel (vector-ref q 0) (vector-ref q 1)))
      (send dc draw-line i1 j1 i2 j2)))
  (for ([p (in-list (frame-points f))])
    (define-values (i j) (point->pixel (vector-ref p 0) (vector-ref p 1)))
    (send dc draw-point i j)))

;; ---------------------------------------------------------------------------

;; missing : as write-exploration takes it (exploration-program.rkt)
;; -> a text: the files that were written, or the reason of the failure
(define (save e v source missing picture)
  (define name (free-name 1))
  (define-values (image program) (values (string-append name ".png") (string-append name ".rkt")))
  (with-handlers ([exn:fail:filesystem? exn-message])
    (send picture save-file image 'png)
    (call-with-output-file program
      (lambda (port) (write-exploration e v source image port #:missing missing)))
    (format "written: ~a and ~a~a" image program (what-is-missing program missing))))

(define (what-is-missing program missing)
  (cond [(null? missing) ""]
        [(string? missing) (format "; what #:source gives is no expression: ~a" missing)]
        [else
         (format "; ~a does not know ~a: add ~a" program (joined (map symbol->string missing))
                 (if (null? (cdr missing)) "its definition" "their definitions"))]))

(define (free-name k)
  (define name (format "explored-~a" k))
  (if (for/or ([extension '(".png" ".rkt")]) (file-exists? (string-append name extension)))
      (free-name (+ k 1))
      name))
