#lang racket/base
;; Drawings of mechanisms: what they print as, what states they draw, and where.

(require (only-in mechanics up down)
         mechanics/animate
         (only-in racket/list last)
         (only-in mechanics/show/animation/drawing drawing-trail drawing-bounds drawing-sample)
         (only-in mechanics/show/animation/on-demand why-no-pictures)
         (only-in pict pict? pict-width pict-height pict->bitmap)
         "../../support/checks.rkt" "../../support/messages.rkt" "../../support/skip.rkt")

(define drawable? (not (why-no-pictures)))
(define no-drawing "the shared libraries of racket/draw are not installed: no drawings")

(define (height t) (* 0.1 (sin t)))
(define (valley x) (up x (* x x)))

;; Each with what it prints as and a state of its, and how many coordinates it takes.
(define drawings
  (list
   (list (draw-pendulum #:length 2) "(draw-pendulum #:length 2)" 1)
   (list (draw-driven-pendulum #:support height)
         "(draw-driven-pendulum #:length 1 #:support height)" 1)
   (list (draw-pendulum-chain) "(draw-pendulum-chain #:lengths (list 1 1))" 2)
   (list (draw-pendulum-chain #:lengths '(1 2 1)) "(draw-pendulum-chain #:lengths (list 1 2 1))" 3)
   (list (draw-cart-pendulum) "(draw-cart-pendulum #:length 1 #:range 2)" 2)
   (list (draw-spherical-pendulum) "(draw-spherical-pendulum #:length 1)" 2)
   (list (draw-Foucault-pendulum) "(draw-Foucault-pendulum #:range 1)" 2)
   (list (draw-oscillator) "(draw-oscillator #:masses 1 #:length 1)" 1)
   (list (draw-oscillator #:masses 3) "(draw-oscillator #:masses 3 #:length 1)" 3)
   (list (draw-spring-pendulum) "(draw-spring-pendulum #:length 1)" 2)
   (list (draw-spring-pendulum #:rectangular? #t)
         "(draw-spring-pendulum #:length 1 #:rectangular? #t)" 2)
   (list (draw-bead-on-ring #:angular-velocity 3)
         "(draw-bead-on-ring #:radius 1 #:angular-velocity 3)" 1)
   (list (draw-bead-on-track valley -1 1) "(draw-bead-on-track valley -1 1)" 1)
   (list (draw-Atwood-machine) "(draw-Atwood-machine #:length 3 #:masses (list 1 2))" 1)
   (list (draw-Atwood-machine #:masses '(4 1 2))
         "(draw-Atwood-machine #:length 3 #:masses (list 4 1 2))" 4)
   (list (draw-ladder) "(draw-ladder #:length 1)" 1)
   (list (draw-wheel #:slope 0.3) "(draw-wheel #:radius 1 #:slope 0.3 #:range 10)" 1)
   (list (draw-coin) "(draw-coin #:radius 1 #:range 3)" 5)
   (list (draw-sleigh) "(draw-sleigh #:ahead 0.3 #:range 3)" 3)
   (list (draw-top) "(draw-top #:length 1 #:radius 0.4)" 3)
   (list (draw-brick #:edges '(1 2 3)) "(draw-brick #:edges (list 1 2 3))" 3)
   (list (draw-orbit) "(draw-orbit #:range 2)" 2)
   (list (draw-orbit #:polar? #t) "(draw-orbit #:range 2 #:polar? #t)" 2)
   (list (draw-bodies #:masses '(3 1 1)) "(draw-bodies #:masses (list 3 1 1) #:range 2)" 6)))

(define (state-of n) (up 0 (apply up (for/list ([k n]) (+ 0.3 (* 0.1 k)))) 0))

(for ([d (in-list drawings)])
  (define-values (drawing text n) (apply values d))
  (test-case (format "~a prints as its call" text)
    (for ([form '("~a" "~s" "~v")]) (check-equal? (format form drawing) text))
    (check-true (drawing? drawing)))
  (test-case (format "~a is of states with ~a coordinates" text n)
    (check-exn #rx"draws a system of .*coordinate.*; this state has 9\n  state: "
               (lambda () ((drawing-trail drawing) (state-of 9)))))
  (test-case (format "~a: the trail begins within what is seen" text)
    (define-values (x-min x-max y-min y-max) (apply values (drawing-bounds drawing)))
    (define points ((drawing-trail drawing) (drawing-sample drawing)))
    (check-true (pair? points))
    (for ([p (in-list points)])
      (check-true (<= x-min (vector-ref p 0) x-max))
      (check-true (<= y-min (vector-ref p 1) y-max))))
  (skip-unless drawable? no-drawing
    (test-case (format "~a draws, and has a diagram" text)
      (check-pred pict? (drawing (state-of n)))
      (check-pred pict? (diagram drawing))
      (check-pred pict? (diagram drawing (state-of n))))))

;; ---------------------------------------------------------------------------
;; Where things are

(define (trail drawing . q)
  (for/list ([p (in-list ((drawing-trail drawing) (up 0 (apply up q) 0)))])
    (for/list ([x (in-vector p)]) (/ (round (* 1e6 x)) 1e6))))

(test-case "bobs, beads and weights are where their coordinates say"
  (define right (acos 0))
  (check-equal? (trail (draw-pendulum #:length 2) right) '((2.0 -0.0)))
  (check-equal? (trail (draw-pendulum) 0.6 -0.8) '((0.6 -0.8)))
  (check-equal? (trail (draw-pendulum-chain #:lengths '(1 2)) 0 right) '((2.0 -1.0)))
  (check-equal? (trail (draw-cart-pendulum) 0.5 0) '((0.5 -1.0)))
  (check-equal? (trail (draw-oscillator #:masses 2) 0.5 -0.25) '((1.5 0.0) (1.75 0.0)))
  (check-equal? (trail (draw-spring-pendulum) 1.5 right) '((1.5 -0.0)))
  (check-equal? (trail (draw-orbit #:polar? #t) 2 right) '((0.0 2.0)))
  (check-equal? (trail (draw-bodies) 1 2 3 4) '((1.0 2.0) (3.0 4.0)))
  (check-equal? (trail (draw-bead-on-track valley -1 1) 0.5) '((0.5 0.25)))
  (check-equal? (map cadr (trail (draw-Atwood-machine) 1)) '(-1.0 -2.0))
  (check-equal? (map cadr (trail (draw-Atwood-machine) 1 1.5)) '(-1.0 -1.5))
  (check-equal? (trail (draw-wheel) 0) '((0.0 2.0)))
  (check-equal? (trail (draw-ladder) right) '((-0.0 0.5))))

(test-case "a ring that turns carries its bead round"
  (define ring (draw-bead-on-ring #:angular-velocity 2))
  (define (at t) (car ((drawing-trail ring) (up t 1 0))))
  (check-equal? (at 0.0) (at 0))
  (check-not-equal? (at 0.0) (at 0.5))
  (for ([k (in-range 2)])
    (check-= (vector-ref (at 0.0) k) (vector-ref (at (acos -1)) k) 1e-12)))

(test-case "the axis of a top is the third axis of Euler's rotation"
  (define (tip theta phi psi)
    (car ((drawing-trail (draw-top)) (up 0 (up theta phi psi) 0))))
  (check-equal? (tip 0 0 0) (tip 0 0.5 0.7))
  (for ([k (in-range 2)])
    (check-= (vector-ref (tip 0.5 1 0) k) (vector-ref (tip 0.5 1 9) k) 1e-12)
    (check-= (vector-ref (tip 0.5 1 0) k) (vector-ref (tip -0.5 (+ 1 (acos -1)) 0) k) 1e-12)))

(test-case "states with momenta, nested tuples and numbers of any kind are states"
  (check-equal? (trail (draw-orbit) 1/2 1) '((0.5 1.0)))
  (check-equal? ((drawing-trail (draw-orbit)) (up 0 (up 1 2) (down 3 4))) '(#(1.0 2.0)))
  (check-equal? ((drawing-trail (draw-bodies)) (up 0 (up (up 1 2) (up 3 4)) 0))
                '(#(1.0 2.0) #(3.0 4.0))))

;; ---------------------------------------------------------------------------
;; Mistakes

(says
 [((draw-pendulum) (up 0 (up 1 2 3) 0))
  "draw-pendulum: draws a system of 1 or 2 coordinates; this state has 3\n"
  "  state: (up 0 (up 1 2 3) 0)"]
 [((draw-pendulum-chain) (up 0 1 0))
  "draw-pendulum-chain: draws a system of 2 coordinates; this state has 1\n  state: (up 0 1 0)"]
 [((draw-pendulum) 3)
  "draw-pendulum: expected a state, such as (up t q v)\n  given: the number 3"]
 [((draw-pendulum) '(0 1 0))
  "draw-pendulum: expected a state, such as (up t q v)\n  given: (0 1 0), a list\n"
  "  a list is not a tuple; use (up t q v)"]
 [((draw-pendulum) (up 0 'theta 0))
  "draw-pendulum: component 0 of the coordinates is no number\n  given: the symbol theta\n"
  "  without a number: theta\n  give its symbols values first"]
 [(draw-pendulum #:length -1)
  "draw-pendulum: expected a positive number as the length\n  given: the number -1"]
 [(draw-pendulum #:length 'l)
  "draw-pendulum: the length is no number\n  given: the symbol l\n"
  "  without a number: l\n  give its symbols values first"]
 [(draw-pendulum #:width 3)
  "draw-pendulum: expected a width of 50 to 4000 pixels\n  given: the number 3"]
 [(draw-pendulum-chain #:lengths 2)
  "draw-pendulum-chain: expected a list of lengths\n  given: the number 2"]
 [(draw-Atwood-machine #:masses '(1))
  "draw-Atwood-machine: expected a list of two or three masses\n  given: (1), a list"]
 [(draw-oscillator #:masses 0)
  "draw-oscillator: expected a number of masses from 1 to 20\n  given: the number 0"]
 [(draw-brick #:edges '(1 2))
  "draw-brick: expected a list of three lengths\n  given: (1 2), a list"]
 [(draw-wheel #:slope 2)
  "draw-wheel: expected a slope between -π/2 and π/2\n  given: the number 2"]
 [(make-drawing 0 1 1 1 values)
  "make-drawing: the least y is not below the greatest\n  least: 1\n  greatest: 1"]
 [(diagram (make-drawing 0 1 0 1 values))
  "diagram: expected a drawing of a mechanism of the library, such as (draw-pendulum)\n"
  "  given: (make-drawing 0 1 0 1 values)"]
 [(diagram (draw-pendulum) #:names '(("θ" "φ")))
  "diagram: expected a hash from names to names, such as (hash \"θ\" \"φ\")\n  given: ((\"θ\" \"φ\")), a list"])

;; ---------------------------------------------------------------------------
;; Shapes

(says
 [(polyline '())
  "polyline: expected a list of at least two points\n  given: (), a list"]
 [(polyline (list (up 0 0) 3))
  "polyline: the point 1 is no point of the plane, such as (up x y) or (cons x y)\n"
  "  given: the number 3"]
 [(disc (up 0 0) 0)
  "disc: expected a positive number as the radius\n  given: the number 0"]
 [(disc (up 0 0) 1 #:color 3)
  "disc: expected a color: a name such as 'red, a list of three bytes, or #f\n  given: the number 3"]
 [(label (up 0 0) 'm)
  "label: expected a string\n  given: the symbol m"]
 [(sketch 0 1 0 1 (disc (up 0 0) 1) "text")
  "sketch: expected shapes, such as (disc (up 0 1) 0.1)\n"
  "  given: \"text\", a string"])

(skip-unless drawable? no-drawing
  (test-case "a sketch has the proportions of its bounds"
    (define p (sketch -1 1 0 1 #:width 200 (rod (up -1 0) (up 1 1)) (list (bob (up 0 0) 0.1))))
    (check-equal? (list (pict-width p) (pict-height p)) '(200 100.0)))
  (test-case "a label is shifted in pixels, to the right and upwards"
    (define (place shift)
      (define p (sketch 0 1 0 1 #:width 200 (label (up 1/2 1/2) "m" #:shift shift)))
      (define record-pict
        (dynamic-require 'mechanics/show/animation/pict-recorder 'record-pict))
      (define text (last (record-pict p)))
      (map string->number
           (cdr (regexp-match #px" x=\"([-.\\d]+)\" y=\"([-.\\d]+)\""
                              ((dynamic-require 'mechanics/show/animation/svg 'element->markup)
                               text (lambda (look) ""))))))
    (check-equal? (map - (place #(10 7)) (place #(0 0))) '(10 -7)))
  (test-case "a color that there is not is named when it is drawn"
    (check-exn #rx"color: there is no color of that name\n  given: 'bleu"
               (lambda ()
                 (pict->bitmap
                  (sketch 0 1 0 1 (disc (up 0 0) 1 #:color 'bleu)))))))
