#lang racket/base
;; Marks above, below and around picts of formulas.

(require (only-in pict blank filled-ellipse filled-rectangle hbl-append hc-append
                  pict pict-ascent pict-descent pict-height pict-width
                  pin-over unsafe-dc vc-append vl-append)
         "drawing-state.rkt" "pict-glyphs.rkt"
         (only-in racket/class new send send*)
         (only-in racket/draw dc-path%))

(provide over raised with-exponent with-indices with-dots under-root fenced rows lines)

;; p with its base line so far above its lower edge.
(define (with-base-line p descent)
  (define h (pict-height p))
  (struct-copy pict p [ascent (- h descent)] [descent descent]))

(define (bar g width) (filled-rectangle width (rule g) #:draw-border? #f))

;; The pict with its middle on the axis of the line.
(define (on-axis g p) (with-base-line p (- (/ (pict-height p) 2) (axis g))))

;; ---------------------------------------------------------------------------

(define (over g above below)
  (define gap (ems g 0.1))
  (define width (+ (ems g 0.25) (max (pict-width above) (pict-width below))))
  (define whole (vc-append gap above (bar g width) below))
  (define margin (ems g 0.08))
  (hbl-append (blank margin 0)
              (with-base-line whole (- (+ gap (pict-height below) (/ (rule g) 2)) (axis g)))
              (blank margin 0)))

;; An exponent beside a base of one line.
(define (raised g exponent) (lifted exponent (ems g 0.4)))

(define (lifted p by) (with-base-line p (- (pict-descent p) by)))

;; An exponent with its base line well above the middle of the base.
(define (with-exponent g base exponent)
  (define by (max (ems g 0.4)
                  (- (base-ascent base) (ems g 0.45))))
  (level base (lifted exponent by)))

(define (base-ascent p) (- (pict-height p) (pict-descent p)))

(define (with-indices g base below above)
  (define low (and below (lifted below (ems g -0.2))))
  (define high (and above (lifted above (ems g 0.4))))
  (cond [(and low high)
         (define width (max (pict-width low) (pict-width high)))
         (level base (level high (blank (- width (pict-width high)) 0)
                            (shifted low (- width))))]
        [(or low high) => (lambda (one) (level base one))]
        [else base]))

;; Draws p shifted to the right by dx, in a pict without width.
(define (shifted p dx)
  (with-base-line (pin-over (blank 0 (pict-height p)) dx 0 p) (pict-descent p)))

;; Beside one another, level, with all that is drawn inside the pict.
(define (level . ps)
  (define ascent (apply max (map base-ascent ps)))
  (define descent (apply max (map pict-descent ps)))
  (define-values (whole width)
    (for/fold ([whole (blank (apply + (map pict-width ps)) (+ ascent descent))] [x 0])
              ([p (in-list ps)])
      (values (pin-over whole x (- ascent (base-ascent p)) p) (+ x (pict-width p)))))
  (with-base-line whole descent))

;; ---------------------------------------------------------------------------
;; Dots and roots

;; Above the letter, whatever its height.
(define (with-dots g p n #:tall? [tall? #f])
  (cond [(eqv? n 0) p]
        [else
         (define size (glyphs-size g))
         (define dot (filled-ellipse (* 0.13 size) (* 0.13 size) #:draw-border? #f))
         (define dots (apply hc-append (* 0.08 size) (for/list ([_ (in-range n)]) dot)))
         (define x (+ (/ (- (pict-width p) (pict-width dots)) 2) (* 0.06 size)))
         (define room (- (* (if tall? 1.02 0.78) size) (base-ascent p)))
         (define raised (if (positive? room) (vl-append (blank (pict-width p) room) p) p))
         (with-base-line (pin-over raised x (max 0 (- room)) dots) (pict-descent p))]))

(define (under-root g p)
  (define size (glyphs-size g))
  (define margin (* 0.12 size))
  (define hook (* 0.6 size))
  (define h (+ (pict-height p) margin))
  (define w (+ hook (pict-width p) margin))
  (define sign
    (stroke g w h
            (lambda (path)
              (send path move-to 0 (* 0.65 h))
              (send path line-to (* 0.3 hook) (* 0.58 h))
              (send path line-to (* 0.6 hook) (- h 1))
              (send path line-to hook 1)
              (send path line-to w 1))))
  (with-base-line (pin-over sign (+ hook (/ margin 2)) margin p) (pict-descent p)))

;; ---------------------------------------------------------------------------
;; Fences

(define (fenced g open p close)
  (define size (glyphs-size g))
  (cond [(<= (pict-height p) (* 1.75 size))
         (hbl-append (upright g open) p (upright g close))]
        [else
         (define (sign s)
           (with-base-line (tall g s (pict-height p)) (pict-descent p)))
         (level (sign open) (blank (* 0.08 size) 0) p (blank (* 0.08 size) 0) (sign close))]))

(define (tall g sign h)
  (define w (ems g 0.35))
  (define (curve from to)
    (lambda (path)
      (send path move-to from 0)
      (send path curve-to to (* 0.25 h) to (* 0.75 h) from h)))
  (define (bracket from to)
    (lambda (path)
      (send path move-to from 0.5)
      (send path line-to to 0.5)
      (send path line-to to (- h 0.5))
      (send path line-to from (- h 0.5))))
  (stroke g w h
          (case sign
            [("(") (curve (* 0.9 w) 0)]
            [(")") (curve (* 0.1 w) w)]
            [("[") (bracket (* 0.9 w) (* 0.3 w))]
            [("]") (bracket (* 0.1 w) (* 0.7 w))]
            [else (lambda (path)
                    (send path move-to (/ w 2) 0)
                    (send path line-to (/ w 2) h))])))

;; A line, in the color of the letters.
(define (stroke g w h draw-path)
  (define path (new dc-path%))
  (draw-path path)
  (unsafe-dc
   (lambda (dc x y)
     (define color (send (send dc get-pen) get-color))
     (call-restoring-state
      dc
      (lambda ()
        (send* dc (set-pen color (rule g) 'solid) (set-brush "black" 'transparent)
          (draw-path path x y)))))
   w h))

;; ---------------------------------------------------------------------------
;; Rows and lines

;; rows of cells of equal number, each row level, the whole on the axis
(define (rows g cells)
  (define size (glyphs-size g))
  (define columns (if (null? cells) '() (apply map list cells)))
  (define widths (for/list ([c (in-list columns)]) (apply max (map pict-width c))))
  (define drawn
    (for/list ([row (in-list cells)])
      (apply level
             (apply append
                    (for/list ([p (in-list row)] [w (in-list widths)] [i (in-naturals)])
                      (define free (/ (- w (pict-width p)) 2))
                      (list (blank (+ free (if (= i 0) 0 (* 0.8 size))) 0) p (blank free 0)))))))
  (on-axis g (apply vl-append (* 0.2 size) drawn)))

(define (lines g ps) (on-axis g (apply vl-append (ems g 0.25) ps)))
