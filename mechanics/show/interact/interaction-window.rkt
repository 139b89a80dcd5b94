#lang racket/base
;; The window of an interaction: its controls, and the value of the body beneath them.
;;
;; The window lives in an eventspace of its own, and the body is run by a worker in a thread of its
;; own: so the window answers at once, however slow the body, and the prompt is free.  The worker
;; takes the newest values that wait; work begun it finishes.  Closing the window stops it.

(require racket/class
         racket/gui/base
         (only-in racket/math exact-ceiling)
         (only-in pict draw-pict pict-height pict-width scale)
         "control.rkt" "interaction.rkt" "outcome.rkt"
         (only-in "outcome-picture.rkt" outcome->pict)
         (only-in "../plot/window.rkt" show-at-size titled-window))

(provide (rename-out [window-loaded? loaded?])
         open-interaction-window wait-until-closed
         ;; for tests
         (struct-out session))

(define (window-loaded?) #t)

;; values : those of the controls, in their order; shown : those of which there is the picture, or
;; #f; bitmap : of the picture, or #f; worker : thread; closed : a semaphore, posted at the end
(struct session (interaction window [canvas #:mutable] [values #:mutable]
                 [shown #:mutable] [bitmap #:mutable] [worker #:mutable] closed)
  #:authentic)

(define-values (usual-width usual-height) (values 440 440))

(define (open-interaction-window i title)
  (parameterize ([current-eventspace (make-eventspace)])
    (define custodian (make-custodian))
    (define closed (make-semaphore))
    (define window
      (titled-window title (lambda ()
                             (custodian-shutdown-all custodian)
                             (semaphore-post closed))))
    (define s (session i window #f (start-values i) #f #f #f closed))
    (add-controls! s)
    (set-session-canvas! s (new result-canvas% [parent window] [of s]))
    (set-session-worker! s (parameterize ([current-custodian custodian])
                             (thread (lambda () (work s)))))
    (show-at-size window (session-canvas s) usual-width usual-height)
    (ask! s)
    s))

;; A prompt and other windows go on.
(define (wait-until-closed s)
  (void (sync/enable-break (semaphore-peek-evt (session-closed s)))))

;; ---------------------------------------------------------------------------
;; Controls

(define (add-controls! s)
  (define controls (interaction-controls (session-interaction s)))
  (define panel
    (new vertical-panel% [parent (session-window s)] [stretchable-height #f] [border 6]))
  (define rows (for/list ([c (in-list controls)] [k (in-naturals)]) (add-control! s panel c k)))
  (define width (apply max (map (lambda (name) (send name get-width)) rows)))
  (for ([name (in-list rows)]) (send name min-width width)))

;; k : its number -> the message% with its name
(define (add-control! s panel c k)
  (define row (new horizontal-panel% [parent panel] [stretchable-height #f] [spacing 6]))
  (define name (new message% [parent row] [label (label-text (symbol->string (control-name c)))]))
  (define (move! value) (change! s k value))
  (case (control-kind c)
    [(number) (add-slider! row c move!)]
    [(choice)
     (new choice% [parent row] [label #f] [selection (control-position c (control-start c))]
          [choices (for/list ([v (in-vector (control-values c))]) (label-text (value->label v)))]
          [callback (lambda (choice e)
                      (move! (vector-ref (control-values c) (send choice get-selection))))])]
    [(boolean)
     (new check-box% [parent row] [label ""] [value (control-start c)]
          [callback (lambda (box e) (move! (send box get-value)))])]
    [else
     (new text-field% [parent row] [label #f] [init-value (control-start c)]
          [callback (lambda (field e) (move! (send field get-value)))])])
  name)

(define (add-slider! row c move!)
  (define numbers (control-values c))
  (define (number-label x) (label-text (value->label x)))
  (define (slide slider event)
    (define x (vector-ref numbers (send slider get-value)))
    (send number set-label (number-label x))
    (move! x))
  (new slider% [parent row] [label #f] [style '(horizontal plain)] [callback slide]
       [min-value 0] [max-value (- (vector-length numbers) 1)]
       [init-value (control-position c (control-start c))])
  (define number
    (new message% [parent row] [label (number-label (control-start c))] [min-width 90]))
  (void))

;; At most as long as labels may be; & would mark a key.
(define (label-text text)
  (regexp-replace* #rx"&" (if (> (string-length text) 99) (substring text 0 99) text) "\\&\\&"))

(define (change! s k value)
  (set-session-values! s (for/list ([old (in-list (session-values s))] [j (in-naturals)])
                           (if (= j k) value old)))
  (ask! s))

;; ---------------------------------------------------------------------------
;; The worker

(define (ask! s) (thread-send (session-worker s) 'changed void))

(define (work s)
  (let again ([values #f] [outcome #f])
    (thread-receive)
    (let skip () (when (thread-try-receive) (skip)))
    (define wanted (session-values s))
    (define new
      (if (eq? wanted values) outcome (interaction-outcome (session-interaction s) wanted)))
    (define bitmap (drawn s new))
    (set-session-bitmap! s bitmap)
    (set-session-shown! s wanted)
    (in-window s (lambda () (send (session-canvas s) refresh)))
    (again wanted new)))

(define (in-window s thunk)
  (parameterize ([current-eventspace (send (session-window s) get-eventspace)])
    (queue-callback thunk)))

;; -> the bitmap of an outcome, as large as the canvas; a picture that fails is told in its place
(define (drawn s outcome)
  (define-values (width height) (send (session-canvas s) get-client-size))
  (define (draw o) (draw-centered o (max 50 width) (max 50 height)))
  (define done (outcome-of (lambda () (draw outcome))))
  (if (failed? done) (draw done) done))

;; Only a drawing of lines is made larger than it is.
(define (draw-centered outcome width height)
  (define-values (picture grows?) (outcome->pict outcome))
  (define fitting
    (min (/ width (max 1 (pict-width picture))) (/ height (max 1 (pict-height picture)))))
  (define shown (scale picture (if grows? fitting (min 1 fitting))))
  (define bitmap (make-bitmap (exact-ceiling width) (exact-ceiling height)))
  (define dc (new bitmap-dc% [bitmap bitmap]))
  (send dc set-background "white")
  (send dc clear)
  (send dc set-smoothing 'smoothed)
  (draw-pict shown dc
             (/ (- width (pict-width shown)) 2) (/ (- height (pict-height shown)) 2))
  bitmap)

(define result-canvas%
  (class canvas%
    (init-field of)
    (super-new)
    (inherit get-dc)
    (define/override (on-paint)
      (define bitmap (session-bitmap of))
      (when bitmap (send (get-dc) draw-bitmap bitmap 0 0)))
    (define/override (on-size width height)
      (when (session-worker of) (ask! of)))))
