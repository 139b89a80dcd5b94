#lang racket/base
;; Shapes that each mechanism is drawn with, marks of its diagram included, as found good by looking
;; at it: drawn-mechanisms.rktd.
;;
;; `racket tests/mechanics/show/mechanism/drawn-mechanisms.rkt` writes the file anew; the changes
;; are to be looked at.

(require (only-in mechanics up)
         mechanics/animate
         (only-in mechanics/show/animation/drawing
                  drawing-axes drawing-bounds drawing-marks drawing-sample drawing-shapes
                  drawing-width)
         mechanics/show/animation/shapes
         (only-in racket/file file->list)
         racket/runtime-path
         (only-in racket/vector vector-map)
         "../../support/checks.rkt")

(define-runtime-path kept "drawn-mechanisms.rktd")

(define drawings
  (list (draw-pendulum) (draw-pendulum #:length 2 #:width 200)
        (draw-driven-pendulum #:support (lambda (t) (+ 0.1 t)))
        (draw-pendulum-chain #:lengths '(1 2 3) #:width 200)
        (draw-cart-pendulum) (draw-spherical-pendulum) (draw-Foucault-pendulum)
        (draw-oscillator #:width 200) (draw-oscillator #:masses 3)
        (draw-spring-pendulum) (draw-spring-pendulum #:rectangular? #t)
        (draw-bead-on-ring #:radius 2) (draw-bead-on-track (lambda (x) (up x (* x x))) -3 -1)
        (draw-Atwood-machine) (draw-Atwood-machine #:masses '(4 1 2))
        (draw-ladder) (draw-wheel #:slope 0.3 #:range 5) (draw-wheel #:slope -0.3) (draw-coin)
        (draw-sleigh #:ahead 0.5) (draw-top) (draw-brick #:edges '(1 2 3))
        (draw-orbit) (draw-orbit #:polar? #t) (draw-bodies #:masses '(3 1 1))))

;; Of a line with many points, as a spring's or a circle's, some.
(define (data-of s)
  (define (each . fields) (for/list ([f (in-list fields)]) (f s)))
  (cond [(stroke? s)
         (list* 'line (some (stroke-points s))
                (each stroke-closed? stroke-color stroke-width stroke-dash stroke-fill
                      stroke-heads))]
        [(spot? s)
         (cons 'disc (each spot-center spot-radius spot-color spot-width spot-fill))]
        [else
         (cons 'label (each lettering-at lettering-text lettering-color lettering-size
                            lettering-anchor lettering-italic? lettering-shift))]))

(define (some points)
  (define step (max 1 (quotient (length points) 7)))
  (for/list ([p (in-list points)] [k (in-naturals)] #:when (zero? (modulo k step))) p))

(define (drawn d)
  (define state (drawing-sample d))
  (define (of part) (map data-of (flat-shapes 'drawn (part state))))
  (list (format "~a" d) (drawing-bounds d) (drawing-width d) (drawing-axes d)
        (of (drawing-shapes d)) (of (drawing-marks d))))

(define (rounded x)
  (cond [(flonum? x) (+ 0.0 (/ (round (* 1e4 x)) 1e4))]
        [(pair? x) (cons (rounded (car x)) (rounded (cdr x)))]
        [(vector? x) (vector-map rounded x)]
        [else x]))

(define (close? a b)
  (cond [(and (real? a) (real? b)) (< (abs (- a b)) 1e-3)]
        [(and (pair? a) (pair? b)) (and (close? (car a) (car b)) (close? (cdr a) (cdr b)))]
        [(and (vector? a) (vector? b)) (close? (vector->list a) (vector->list b))]
        [else (equal? a b)]))

(define-check (check-drawn now before)
  (define (shapes x) (apply append (cdddr (cdr x))))
  (unless (close? now before)
    (with-check-info (['now (for/list ([a (in-list (shapes now))] [b (in-list (shapes before))]
                                       #:unless (close? a b))
                              a)])
      (fail-check))))

(test-case "mechanisms are drawn as they were"
  (define before (file->list kept))
  (check-equal? (length before) (length drawings))
  (for ([d (in-list drawings)] [b (in-list before)])
    (check-drawn (rounded (drawn d)) b (car b))))

;; Procedures as values take their defaults when they are called.
(test-case "mechanisms without keywords are those of their defaults"
  (define before (file->list kept))
  (for ([d (list* (keyword-apply draw-oscillator '(#:masses) '(3) '())
                  (for/list ([f (list draw-pendulum draw-cart-pendulum draw-spherical-pendulum
                                      draw-Foucault-pendulum draw-spring-pendulum draw-ladder
                                      draw-Atwood-machine draw-coin draw-top draw-orbit)])
                    (f)))])
    (define name (format "~a" d))
    (check-drawn (rounded (drawn d)) (or (assoc name before) (list name)) name))
  (define (coils f) (stroke-points (f '#(0 0) '#(0 1))))
  (check-equal? (coils (values spring)) (coils (lambda (p q) (spring p q #:coils 8)))))

(test-case "the label of a bob stands at the side that was asked for"
  (for ([(anchor place) (hash 'right #(1.5 2.0) 'left #(0.5 2.0) 'above #(1.0 2.5) 'below #(1.0 1.5)
                              'center #(1.0 2.0))])
    (define label (cadr (bob '#(1 2) 0.5 #:label "m" #:anchor anchor)))
    (check-equal? (vector-map exact->inexact (lettering-at label)) place (format "~a" anchor))))

(module+ main
  (call-with-output-file* kept #:exists 'truncate
    (lambda (port)
      (for ([d (in-list drawings)])
        (define all (rounded (drawn d)))
        (fprintf port "(~s ~s ~s ~s\n" (car all) (cadr all) (caddr all) (cadddr all))
        (for ([shapes (in-list (cddddr all))])
          (fprintf port " (")
          (for ([s (in-list shapes)]) (fprintf port "\n  ~s" s))
          (fprintf port ")"))
        (fprintf port ")\n")))))
