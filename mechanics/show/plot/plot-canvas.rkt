#lang racket/base
;; A canvas for pictures on a device context of racket/draw: lines, rectangles, text.

(require (only-in racket/class new send send*)
         (only-in racket/draw dc-path% make-brush make-color make-font make-pen)
         racket/flonum
         (only-in racket/list partition split-at)
         "../../generic/on-demand.rkt")

(require-on-demand ["axes/formula-label.rkt" label-measures draw-label])

(provide call-with-canvas draw-strokes draw-box
         (struct-out text) make-text draw-text
         call-with-font call-catching-text (struct-out caught))

(define picture-font (make-parameter (make-font #:size 11 #:family 'roman)))

(define (call-with-font font use) (parameterize ([picture-font font]) (use)))

;; A text that was not drawn.  x, y : where its base line begins, on the page, in units, as are
;; length and size
(struct caught (string x y length size turned?) #:authentic)

;; A procedure that takes a text in place of drawing it, or #f; where the picture is on the page
(define catch (make-parameter #f))
(define origin (make-parameter '(0 . 0)))

;; -> the value of (draw), and the texts, which are not drawn
(define (call-catching-text draw)
  (define texts '())
  (define drawn (parameterize ([catch (lambda (t) (set! texts (cons t texts)))]) (draw)))
  (values drawn (reverse texts)))

;; Calls draw with x, y as the origin, and leaves the settings of the context as they were.
(define (call-with-canvas dc x y draw)
  (define-values (pen brush old-font color smoothing mode alpha clipping place)
    (values (send dc get-pen) (send dc get-brush) (send dc get-font)
            (send dc get-text-foreground) (send dc get-smoothing) (send dc get-text-mode)
            (send dc get-alpha) (send dc get-clipping-region) (send dc get-transformation)))
  (send* dc
    (translate x y) (set-font (picture-font)) (set-text-foreground "black")
    (set-smoothing 'smoothed) (set-text-mode 'transparent) (set-alpha 1.0))
  (parameterize ([origin (cons x y)]) (draw))
  (send* dc
    (set-transformation place) (set-pen pen) (set-brush brush) (set-font old-font)
    (set-text-foreground color) (set-smoothing smoothing) (set-text-mode mode)
    (set-alpha alpha) (set-clipping-region clipping)))

;; lines : lists of points, two at least, pairs of flonums in pixels; color : three bytes
(define (draw-strokes dc lines color width [style 'solid])
  (define-values (short long)
    (partition (lambda (line) (and (eq? style 'solid) (null? (cddr line)))) lines))
  (send* dc
    (set-pen (make-pen #:color (apply make-color color) #:width (min width 255) #:style style
                       #:cap 'round #:join 'round))
    (set-brush (make-brush #:style 'transparent)))
  (draw-together dc short)
  (for ([line (in-list long)]) (send dc draw-lines (thinned line))))

;; Dots and pieces with two ends are drawn as one path, some hundreds of them, for that is less to
;; write and quick.  A path closes its parts, which would be seen of others.
(define (draw-together dc lines)
  (unless (null? lines)
    (define path (new dc-path%))
    (define-values (now later) (split-at lines (min at-once (length lines))))
    (for ([line (in-list now)])
      (define-values (p q) (values (car line) (cadr line)))
      (send* path (move-to (car p) (cdr p)) (line-to (car q) (cdr q))))
    (send dc draw-path path)
    (draw-together dc later)))

(define at-once 500)

;; Leaves out points that are nearly on the straight line between those before and after.
(define (thinned line)
  (for/fold ([from (car line)] [passed '()] [kept (list (car line))]
             #:result (reverse (cons (car passed) kept)))
            ([p (in-list (cdr line))])
    (if (and (< (length passed) 10) (andmap (near-line from p) passed))
        (values from (cons p passed) kept)
        (values (car passed) (list p) (cons (car passed) kept)))))

;; -> a predicate: is a point less than a twentieth of a pixel from the line between p and q?
(define (near-line p q)
  (define-values (x y) (values (car p) (cdr p)))
  (define-values (dx dy) (values (fl- (car q) x) (fl- (cdr q) y)))
  (define square (flmax 1e-12 (fl+ (fl* dx dx) (fl* dy dy))))
  (lambda (r)
    (define-values (rx ry) (values (fl- (car r) x) (fl- (cdr r) y)))
    (define share (flmax 0.0 (flmin 1.0 (fl/ (fl+ (fl* rx dx) (fl* ry dy)) square))))
    (define-values (ex ey) (values (fl- rx (fl* share dx)) (fl- ry (fl* share dy))))
    (fl< (fl+ (fl* ex ex) (fl* ey ey)) 0.0025)))

;; color : of the area, a name or three bytes, or #f; line : width of the border, black, or #f
(define (draw-box dc left top width height color line)
  (send* dc
    (set-pen (if line (make-pen #:width line) (make-pen #:style 'transparent)))
    (set-brush (if color
                   (make-brush #:color (if (list? color) (apply make-color color) color))
                   (make-brush #:style 'transparent)))
    (draw-rectangle left top width height)))

;; ---------------------------------------------------------------------------
;; Text

;; A string, or the tree of a formula, and the rectangle that it fills; turned? : is it read from
;; below upwards?
(struct text (string left top width height turned?))

;; x, y : where is the point of the rectangle that is such shares of its width to the right and of
;; its height down
(define (make-text dc string x y across down [turned? #f])
  (define-values (length size) (text-measures dc string))
  (define-values (width height) (if turned? (values size length) (values length size)))
  (text string (- x (* across width)) (- y (* down height)) width height turned?))

(define (text-measures dc string)
  (cond [(string? string)
         (define-values (length size descent space)
           (send dc get-text-extent string (picture-font) #t 0))
         (values length size)]
        [else (label-measures string (letter-size (picture-font)))]))

(define (draw-text dc t)
  (define-values (x y) (values (text-left t) (text-top t)))
  (cond [(not (string? (text-string t)))
         (draw-label dc (text-string t) (letter-size (picture-font)) x y (text-turned? t))]
        [(catch) => (lambda (catch!) (catch! (caught-text dc t)))]
        [(text-turned? t)
         (send dc draw-text (text-string t) x (+ y (text-height t)) #t 0 (/ (acos -1) 2))]
        [else (send dc draw-text (text-string t) x y #t 0)]))

(define (caught-text dc t)
  (define-values (length height descent space)
    (send dc get-text-extent (text-string t) (picture-font) #t 0))
  (define-values (x y) (values (+ (text-left t) (car (origin))) (+ (text-top t) (cdr (origin)))))
  (define base (- height descent))
  (define size (letter-size (picture-font)))
  (if (text-turned? t)
      (caught (text-string t) (+ x base) (+ y (text-height t)) length size #t)
      (caught (text-string t) x (+ y base) length size #f)))

;; A point is 4/3 of a unit.
(define (letter-size font)
  (* (send font get-size) (if (send font get-size-in-pixels) 1 4/3)))
