#lang racket/base
;; Drawings: functions from the states of a system to its pictures.
;;
;; Any procedure that makes a pict of a state will do for an animation.  A drawing of this
;; library knows more: the part of the plane that it shows, for how many coordinates it is,
;; which of its points leave a trail, and the marks that make a diagram of it.

(require (only-in racket/list append-map)
         "on-demand.rkt" "plane-vector.rkt" "shapes.rkt" "drawn-state.rkt"
         "../display/drawing-library.rkt"
         "../../error/complain.rkt"
         "../../generic/describe.rkt" "../../generic/up-down.rkt"
         "../../generic/value-struct.rkt" "../../generic/wrong-argument.rkt"
         "../plot/plotted-number.rkt" "../plot/view.rkt")

(provide mechanism drawn make-drawing drawing? drawing-datum drawing-bounds drawing-width
         drawing-axes drawing-sample
         check-state drawing-trail drawn-place trail-points
         sketch diagram
         check-drawing-library
         ;; for tests
         drawing-shapes drawing-marks)

;; datum  : its printed form
;; bounds : (list x-min x-max y-min y-max); width : pixels
;; counts : for which numbers of coordinates it is, or #f
;; shapes, trail, marks : functions of the state; trail gives points of the plane; or #f
;; sample : a state of which a diagram can be made, or #f
;; axes   : names of the coordinates, or '()
(value-struct drawing (datum bounds width counts shapes trail marks sample axes)
  #:datum drawing-datum
  #:constructor-name new-drawing
  #:property prop:procedure (lambda (d state) (draw-state d state)))

;; ---------------------------------------------------------------------------
;; Making them

;; trail, marks, shapes : procedures without arguments, called when that part is needed
(struct parts (trail marks shapes))

(define-syntax-rule (drawn #:trail trail #:marks marks #:shapes shapes)
  (parts (lambda () trail) (lambda () marks) (lambda () shapes)))

;; The drawing of a mechanism of this library.
;; call : the expression that makes it, (name argument ...)
;; parts-at : the time and the coordinates, a vector of flonums -> parts, made by `drawn`
(define (mechanism call #:bounds bounds #:width width #:coordinates counts
                   #:sample sample #:axes axes parts-at)
  (define who (car call))
  (check-picture-width who width)
  (define ((of-state part) state)
    (define-values (t q) (read-state who state counts))
    ((part (parts-at t q))))
  (new-drawing call (map real->double-flonum bounds) width counts
               (of-state parts-shapes) (of-state parts-trail) (of-state parts-marks)
               (up 0.0 (apply up sample) 0.0) axes))

;; Of a system of the reader's: shapes and trail are functions of the state.
(define (make-drawing x-min x-max y-min y-max shapes #:trail [trail #f] #:width [width 300])
  (define who 'make-drawing)
  (define bounds (list x-min x-max y-min y-max))
  (check-bounds who bounds)
  (check-picture-width who width)
  (check-function-of-state who shapes)
  (when trail (check-function-of-state who trail))
  (new-drawing `(make-drawing ,@bounds ,(procedure-datum shapes))
               (map real->double-flonum bounds) width #f
               shapes (and trail (lambda (state) (trail-points who (trail state))))
               #f #f '()))

(define (check-picture-width who width)
  (unless (and (exact-positive-integer? width) (<= 50 width 4000))
    (complain-of-argument who "a width of 50 to 4000 pixels" width)))

;; One point, or a list of them -> vectors of two flonums
(define (trail-points who x)
  (for/list ([p (in-list (if (list? x) x (list x)))])
    (point-of who "a point of the trail" p)))

;; ---------------------------------------------------------------------------
;; Drawing

(define (draw-state d state)
  (check-drawing-library (name-of d))
  (paint (drawing-bounds d) (drawing-width d) (shapes-of d state)))

(define (name-of d) (car (drawing-datum d)))
(define (shapes-of d state) (flat-shapes (name-of d) ((drawing-shapes d) state)))

;; Complains unless the state is one that this draws.
(define (check-state d state) (read-state (name-of d) state (drawing-counts d)))

(define (check-drawing-library who) (check-drawing who why-no-pictures))

;; A point of the plane that is drawn -> pixels from the upper left corner
(define (drawn-place d p)
  (define-values (x-min x-max y-min y-max) (apply values (drawing-bounds d)))
  (define scale (/ (drawing-width d) (- x-max x-min)))
  (vector (* scale (- (vector-ref p 0) x-min)) (* scale (- y-max (vector-ref p 1)))))

;; ---------------------------------------------------------------------------
;; Still pictures

(define (sketch x-min x-max y-min y-max #:width [width 300] . shapes)
  (define bounds (list x-min x-max y-min y-max))
  (check-bounds 'sketch bounds)
  (check-picture-width 'sketch width)
  (define all (flat-shapes 'sketch shapes))
  (check-drawing-library 'sketch)
  (paint (map real->double-flonum bounds) width all))

;; The mechanism with its angles, lengths and masses named; about so many pixels high, unless
;; it is wide.  names : hash, from names to others in their place
(define (diagram d [state (and (drawing? d) (drawing-sample d))]
                 #:names [names (hash)] #:size [size 220])
  (define who 'diagram)
  (unless (and (drawing? d) (drawing-marks d))
    (complain who
              "expected a drawing of a mechanism of the library, such as (draw-pendulum)\n  given: ~a"
              (if (drawing? d) (value->text (drawing-datum d)) (describe-with-value d))))
  (check-argument who hash? names "a hash from names to names, such as (hash \"θ\" \"φ\")")
  (check-picture-width who size)
  (define marked (append (shapes-of d state) (flat-shapes who ((drawing-marks d) state))))
  (define named (for/list ([s (in-list marked)]) (if (lettering? s) (renamed s names) s)))
  (check-drawing-library who)
  (define scale (fitting-scale named size))
  (define bounds (extent named scale))
  (paint bounds (* scale (- (cadr bounds) (car bounds))) named))

(define (renamed s names)
  (define other (hash-ref names (lettering-text s) (lettering-text s)))
  (check-argument 'diagram string? other "a string as name")
  (struct-copy lettering s [text other]))

;; ---------------------------------------------------------------------------
;; The part of the plane that shapes take up

(define margin 6.0)              ; pixels

;; scale : pixels to a unit -> (list x-min x-max y-min y-max), with a margin
(define (extent shapes scale)
  (define corners (append-map (lambda (s) (corners-of s scale)) shapes))
  (define (bound choose part change) (change (apply choose (map part corners)) (/ margin scale)))
  (list (bound min at-x -) (bound max at-x +) (bound min at-y -) (bound max at-y +)))

;; Pixels to a unit, so that all but letters is at most so many pixels high, and 1.7 times as
;; wide.
(define (fitting-scale shapes size)
  (define bounds (extent (filter (lambda (s) (not (lettering? s))) shapes) +inf.0))
  (/ size (max 1e-9 (/ (- (cadr bounds) (car bounds)) 1.7) (- (cadddr bounds) (caddr bounds)))))

(define (corners-of s scale)
  (cond [(stroke? s) (stroke-points s)]
        [(spot? s) (box (spot-center s) (vector 0.0 0.0) (spot-radius s) (spot-radius s))]
        [else (lettering-corners s scale)]))

(define (box p shift wide high)
  (list (add (add p shift) (vector wide high)) (minus (add p shift) (vector wide high))))

;; The letters' width is estimated.
(define (lettering-corners s scale)
  (define size (/ (lettering-size s) scale))
  (define wide (* 0.31 size (+ 1 (string-length (lettering-text s)))))
  (define-values (x y)
    (case (lettering-anchor s)
      [(left) (values (- wide) 0.0)]
      [(right) (values wide 0.0)]
      [(above) (values 0.0 size)]
      [(below) (values 0.0 (- size))]
      [else (values 0.0 0.0)]))
  (define shift (times (/ 1.0 scale) (lettering-shift s)))
  (box (lettering-at s) (add (vector x y) shift) wide (* 0.7 size)))
