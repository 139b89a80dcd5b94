#lang racket/base
;; Parts of mechanisms, made of lines, discs and labels: pieces that drawings are put together
;; from, and labels for them.

(require (only-in racket/math exact-round)
         "../animation/plane-vector.rkt" "../animation/shapes.rkt"
         "../../generic/wrong-argument.rkt"
         "../../numeric/constants.rkt"
         "../plot/plotted-number.rkt")

(provide rod bob spring wall block vector-arrow angle-mark length-mark
         ;; for the mechanisms of the library
         pivot swinging mount thin dashed name-beside swing-mark numbered numbered-names)

(define (rod p q #:color [color ink] #:width [width 3])
  (polyline (list p q) #:color color #:width width))

;; A body that is small, with its name beside it.
(define (bob center radius #:color [color (car accents)] #:label [text #f] #:anchor [anchor 'right])
  (define body (disc center radius #:fill color #:color ink #:width 1))
  (if text (list body (beside (point-of 'bob "the center" center) radius text anchor))
      body))

(define (beside center radius text anchor)
  (define away
    (case anchor
      [(right) (vector radius 0.0)]
      [(left) (vector (- radius) 0.0)]
      [(above) (vector 0.0 radius)]
      [(below) (vector 0.0 (- radius))]
      [else (vector 0.0 0.0)]))
  (label (add center away) text #:anchor anchor))

;; The place about which something turns.
(define (pivot p radius) (disc p radius #:fill "white" #:width 1.5))

;; A pendulum of length l, its bob at b.
(define (swinging p b l)
  (list (rod p b) (pivot p (* 0.025 l)) (bob b (* 0.08 l))))

;; A coil from p to q with straight ends, an eighth of the way long each; its width stays when
;; it is stretched.
(define (spring p q #:coils [coils 8] #:width [width 0.1] #:color [color ink])
  (define who 'spring)
  (unless (and (exact-positive-integer? coils) (<= coils 100))
    (complain-of-argument who "a number of coils from 1 to 100" coils))
  (define from (point-of who "the first end" p))
  (define to (point-of who "the second end" q))
  (define along (minus to from))
  (define aside
    (times (/ (check-length who "the width" width) 2.0 (max 1e-9 (span along))) (crosswise along)))
  (define corners (* 2 coils))
  (define zigzag
    (for/list ([k (in-range corners)])
      (add (between from to (+ 0.125 (* 0.75 (/ (+ k 0.5) corners))))
           (times (if (even? k) 1.0 -1.0) aside))))
  (polyline (append (list from (between from to 0.125)) zigzag
                    (list (between from to 0.875) to))
            #:width 1.5 #:color color))

;; A firm support: a line with hatches to its left, as one goes from p to q.
(define (wall p q #:depth [depth 0.08])
  (define who 'wall)
  (define from (point-of who "the first end" p))
  (define to (point-of who "the second end" q))
  (define deep (check-length who "the depth" depth))
  (define way (minus to from))
  (define long (span way))
  (define strokes (max 1 (exact-round (/ long deep 1.3))))
  (define slant (times (/ deep (max 1e-9 long)) (minus (crosswise way) way)))
  (cons (polyline (list from to) #:width 2)
        (for/list ([k (in-range strokes)])
          (define foot (between from to (/ (+ k 1.0) strokes)))
          (polyline (list foot (add foot slant)) #:width 1 #:color faint))))

;; The firm piece above a pivot, so far to either side.
(define (mount p half depth)
  (define aside (vector half 0.0))
  (wall (minus p aside) (add p aside) #:depth depth))

;; A rectangle about its center, turned by an angle.
(define (block center width height #:angle [angle 0.0] #:color [color (car accents)])
  (define who 'block)
  (define middle (point-of who "the center" center))
  (define a (times 0.5 (turned (check-length who "the width" width) angle)))
  (define b (times 0.5 (crosswise (turned (check-length who "the height" height) angle))))
  (polyline (list (minus (minus middle a) b) (minus (add middle a) b)
                  (add (add middle a) b) (add (minus middle a) b))
            #:closed? #t #:fill color #:width 1))

(define (vector-arrow p q #:color [color (cadr accents)] #:label [text #f])
  (define line (polyline (list p q) #:color color #:width 2 #:arrows 'end))
  (if text
      (list line (label q text #:color color #:anchor (if (leftwards? p q) 'left 'right)))
      line))

(define (leftwards? p q)
  (define (x-of p) (at-x (point-of 'vector-arrow "an end" p)))
  (< (x-of q) (x-of p)))

;; ---------------------------------------------------------------------------
;; Marks of diagrams

(define (thin p q #:color [color faint] #:arrows [heads 'none])
  (polyline (list p q) #:width 1 #:color color #:arrows heads))

(define (dashed p q) (polyline (list p q) #:width 1 #:style 'long-dash #:color faint))

;; shift : pixels to the right of the point
(define (name-beside p text [shift 13])
  (label p text #:anchor 'right #:shift (vector shift 0)))

;; A name, with its number where there are several.
(define (numbered letter k count) (if (= count 1) letter (format "~a_~a" letter k)))
(define (numbered-names letter count)
  (for/list ([k (in-range 1 (+ count 1))]) (numbered letter k count)))

;; From the vertical to a direction, an angle from the x axis.
(define (swing-mark p to radius text) (angle-mark p (- :pi/2) to radius text))

;; An arc between two directions, which are angles from the x axis, and its name beyond its
;; middle.
(define (angle-mark vertex from to radius text)
  (define who 'angle-mark)
  (define center (point-of who "the vertex" vertex))
  (define a (check-number who "the first angle" from))
  (define b (check-number who "the second angle" to))
  (define r (check-length who "the radius" radius))
  (define middle (/ (+ a b) 2.0))
  (list (polyline (arc center r a b) #:width 1.2 #:color (cadr accents) #:arrows 'end)
        (label (add center (turned r middle)) text #:color (cadr accents)
               #:shift (turned 11.0 middle))))

;; The distance of two points, measured beside them: to their left by `offset`.
(define (length-mark p q text #:offset [offset 0.0])
  (define who 'length-mark)
  (define from (point-of who "the first point" p))
  (define to (point-of who "the second point" q))
  (define left (crosswise (times (/ 1.0 (max 1e-9 (span (minus to from)))) (minus to from))))
  (define away (times (check-number who "the offset" offset) left))
  (define side (if (< offset 0.0) -1.0 1.0))
  (define-values (a b) (values (add from away) (add to away)))
  (list (if (= offset 0.0)
            '()
            (for/list ([end (in-list (list from to))])
              (polyline (list end (add end away)) #:width 0.8 #:color faint #:style 'dot)))
        (if (= offset 0.0) '() (polyline (list a b) #:width 1 #:color faint #:arrows 'both))
        (label (between a b 0.5) text #:shift (times (* side 11.0) left))))
