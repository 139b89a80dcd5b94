#lang racket/base
;; The window in which a map is explored: a click starts an orbit, a drag enlarges a part, keys
;; and buttons do the rest.
;;
;; It lives in an eventspace of its own.  The map is computed by a worker in a thread of its own
;; (orbit-worker.rkt), which queues the points it has for the window; so the window
;; answers at once, however slow the map.  Closing it stops the worker.

(require racket/class
         racket/gui/base
         "exploration.rkt" "explorer-board.rkt" "orbit-worker.rkt" "../plot/window.rkt")

(provide (rename-out [explorer-loaded? loaded?])
         open-explorer explorer-exploration explorer-window explorer-board
         close-explorer explorer-message wait-until-closed)

(define (explorer-loaded?) #t)

;; message : the text of the line below; save : exploration bitmap -> text
(struct explorer (exploration window board status save
                  [worker #:mutable] [message #:mutable] closed)
  #:authentic)

(define keys-text
  "click: orbit   drag: zoom   u: undo   m: more points   w: whole   c: clear   s: save   q: close")

;; starts : list of pairs; background : as the board's (explorer-board.rkt)
;; save   : exploration bitmap -> a text that names the files written
(define (open-explorer title width height e starts background save closed)
  (parameterize ([current-eventspace (make-eventspace)])
    (define window (titled-window title (lambda () (finish! it closed))))
    (define row (new horizontal-panel% [parent window] [stretchable-height #f] [border 2]))
    (for ([action (in-list '(undo more whole clear save close))])
      (define label (string-titlecase (symbol->string action)))
      (new button% [parent row] [label label] [callback (lambda (b event) (act! it action))]))
    (define board
      (make-board window e background
                  (lambda (x y) (start-orbit! it x y))
                  (lambda (bounds) (zoom! e bounds) (redraw! it))
                  (lambda (code) (on-key it code))))
    (define status
      (new message% [parent window] [label keys-text] [stretchable-width #t]))
    (define it (explorer e window board status save #f "" (make-semaphore)))
    (set-explorer-worker! it (start-worker (exploration-map e) (receiver it)))
    (show-at-size window (board-canvas board) width height)
    (send (board-canvas board) focus)
    (queue-callback (lambda () (for ([p (in-list starts)]) (start-orbit! it (car p) (cdr p)))))
    it))

;; ---------------------------------------------------------------------------
;; Actions of the reader

(define (on-key it code)
  (define action
    (case code
      [(#\u #\backspace) 'undo]
      [(#\m) 'more]
      [(#\w #\o) 'whole]
      [(#\c) 'clear]
      [(#\s) 'save]
      [(#\q escape) 'close]
      [else #f]))
  (when action (act! it action)))

(define (act! it action)
  (define e (explorer-exploration it))
  (case action
    [(undo) (undo! e)]
    [(whole) (whole! e)]
    [(clear) (clear! e)]
    [(more) (for ([t (in-list (exploration-orbits e))]) (grow! it (traced-orbit t)))]
    [(save) (say! it ((explorer-save it) e (board-picture (explorer-board it))))]
    [(close) (close-explorer it)])
  (when (memq action '(undo whole clear)) (redraw! it)))

(define (start-orbit! it x y) (grow! it (add-orbit! (explorer-exploration it) x y)))

(define (grow! it o)
  (ask-worker (explorer-worker it) o (exploration-n (explorer-exploration it))))

(define (redraw! it)
  (redraw-board! (explorer-board it))
  (say! it #f))

;; The window tells that it is closed by on-close, too, which a program's closing does not call.
(define (close-explorer it)
  (parameterize ([current-eventspace (send (explorer-window it) get-eventspace)])
    (queue-callback
     (lambda ()
       (when (send (explorer-window it) is-shown?)
         (send (explorer-window it) show #f)
         (send (explorer-window it) on-close))))))

(define (finish! it closed)
  (stop-worker (explorer-worker it))
  (closed (explorer-exploration it))
  (semaphore-post (explorer-closed it)))

(define (wait-until-closed it)
  (with-handlers ([exn:break? (lambda (b) (close-explorer it) (raise b))])
    (wait-until (explorer-closed it))))

;; ---------------------------------------------------------------------------
;; Points from the worker

;; The worker waits until its points are drawn.
(define ((receiver it) o xs ys count why)
  (define space (send (explorer-window it) get-eventspace))
  (define done (make-semaphore))
  (parameterize ([current-eventspace space])
    (queue-callback
     (lambda ()
       (when (add-points! (explorer-exploration it) o xs ys count)
         (mark-on-board! (explorer-board it) xs ys count (orbit-color o))
         (say! it (and why (format "an orbit ends: ~a" (on-one-line why)))))
       (semaphore-post done))
     #f))
  (semaphore-wait done))

;; what : a text, or #f for the numbers of orbits and points
(define (say! it what)
  (define e (explorer-exploration it))
  (define text
    (or what (if (null? (exploration-orbits e)) keys-text (exploration->text e))))
  (set-explorer-message! it text)
  (send (explorer-status it) set-label (if (> (string-length text) 200)
                                           (substring text 0 200)
                                           text)))

;; A message has its details on lines of their own.
(define (on-one-line text) (regexp-replace* #rx" *\n *" text "; "))
