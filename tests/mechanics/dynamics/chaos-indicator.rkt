#lang racket/base
;; Regular or chaotic, told by displacements that are integrated beside a motion.

(require mechanics
         mechanics/book mechanics/plot
         mechanics/show/plot/motion-indicators
         (only-in mechanics/show/plot/frame frame-now)
         (only-in mechanics/show/plot/picture-layer layer-data raster-bytes)
         racket/flonum
         "../support/checks.rkt" "../support/folder.rkt" "../support/messages.rkt")

(define (oscillator s) (up 1 (ref s 2) (- (ref s 1))))
(define (saddle s) (up 1 (ref s 1) (- (ref s 2))))
(define start (up 0 1.0 0.5))
(define origin (up 0 0.0 0.0))
(define (of f T kind [s start]) (chaos-indicator f s T #:indicator kind))

(define-check (check-close found expected error)
  (unless (<= (abs (- found expected)) error) (fail-check)))

(test-case "an oscillator turns its displacements and leaves their lengths"
  (check-close (of oscillator 100 'FLI) 0 1e-8)
  (check-close (of oscillator 100 'MEGNO) 0 1e-7)
  (check-close (of oscillator 100 'SALI) (sqrt 2) 1e-8))

;; The displacement (0.6, 0.8) becomes (0.6 e^t, 0.8 e^-t); a = 1 but for the first few units of
;; time, and a mean of a t² for a constant a gives a T/2.
(test-case "a saddle, of which all is known, however long"
  (check-close (of saddle 1000 'FLI origin) (+ (log 0.6 10) (/ 1000 (log 10))) 1e-6)
  (check-close (of saddle 1000 'MEGNO origin) 500 0.02)
  (check-close (of saddle 10 'SALI) (* 2 (exp -20) (/ 1 0.96)) 1e-9)
  (check-close (of saddle 1000 'SALI origin) 0 1e-12))

(test-case "a shear: the displacement grows as the time does"
  (define (shear s) (up 1 (ref s 2) 0))
  (check-close (of shear 1000 'FLI) (log (sqrt (+ (expt (+ 0.6 800) 2) 0.64)) 10) 1e-9)
  (check-close (of shear 1e4 'MEGNO) 2 0.01))

(test-case "Hénon and Heiles: MEGNO is 2 in an island, and λT/2 in the sea"
  (define sea (section->state 1/8 -0.1 0.0))
  (define island (section->state 1/8 0.1 0))
  (check-close (of (HHsysder) 2000 'MEGNO island) 2 0.05)
  (define rate (car (Lyapunov-values (maximal-Lyapunov-exponent (HHsysder) sea 2000))))
  (check-close (/ (of (HHsysder) 2000 'MEGNO sea) (* 1000 rate)) 1 0.5)
  ;; two orbits, which rounding parts: each has a rate of its own over 2000 units
  (check-close (/ (of (HHsysder) 2000 'FLI sea) (/ (* 2000 rate) (log 10))) 1 0.2)
  (check-true (< (of (HHsysder) 2000 'SALI sea) 1e-8))
  (check-true (> (of (HHsysder) 2000 'SALI island) 0.1)))

;; Arnold's cat, of exponent log (3 + √5)/2, and a shear, of both of which all is known
(define (cat x y return fail) (return (+ x y) (+ x y y)))
(define (shear x y return fail) (return (+ x y) y))
(define cat-rate (log (/ (+ 3 (sqrt 5)) 2)))

(test-case "the same of maps of the plane, for so many steps"
  (define (of map n kind) (chaos-indicator map (up 0 0) n #:indicator kind))
  (check-close (/ (of cat 1000 'MEGNO) (* 500 cat-rate)) 1 0.01)
  (check-close (of shear 100000 'MEGNO) 2 0.01)
  (check-close (/ (log (/ (of cat 9 'SALI) (of cat 6 'SALI))) (* -6 cat-rate)) 1 1e-3)
  (check-close (* (square 1000) (of shear 1000 'SALI)) (/ 1 (* 0.8 0.6)) 0.01)
  (check-equal? (of cat 50 'FLI) (fast-Lyapunov-indicator cat (up 0 0) 50))
  (check-equal? (of (lambda (x y return fail) (if (> x -1) (cat x y return fail) (fail)))
                    20 'MEGNO)
                (of cat 20 'MEGNO)))

(test-case "a state without the time"
  (define (turning s) (up (ref s 1) (- (ref s 0))))
  (check-close (of turning 10 'MEGNO (up 1.0 0.0)) 0 1e-7))

(define (driven s)
  (up 1 (ref s 2) (* (sin (ref s 1)) (- (* 0.3 (cos (ref s 0))) 1))))
(define (grid kind jobs [file #f])
  (motion-indicators 'chaos-map driven (lambda (x y) (and (< x 2) (up 0 x y)))
                     (flvector -1.0 0.5 2.5) (flvector 0.0 1.5) 20.0
                     #:indicator kind #:tolerance 1e-10 #:jobs jobs #:checkpoint file))

(test-case "a grid of motions, by workers or here, is that of single ones"
  (for ([kind '(FLI MEGNO SALI)])
    (define alone (grid kind 1))
    (check-equal? (grid kind 2) alone)
    (for* ([(y j) (in-indexed '(0.0 1.5))] [(x i) (in-indexed '(-1.0 0.5 2.5))])
      (define found (flvector-ref alone (+ i (* 3 j))))
      (if (< x 2)
          (check-close found (of driven 20 kind (up 0 x y)) 1e-12)
          (check-false (= found found))))))

(test-case "a checkpoint serves the next call"
  (with-folder (folder)
    (define file (build-path folder "a.ensemble"))
    (define first (grid 'FLI 1 file))
    (check-true (file-exists? file))
    (check-equal? (grid 'FLI 1 file) first)))

(define (picture) (frame -3 3 -3 3 #:width 60 #:height 60))
(define (at-zero q p) (up 0 q p))

(test-case "a frame takes the picture of each indicator"
  (for ([kind '(FLI MEGNO SALI)])
    (check-regexp-match #rx"1 image"
                        (format "~a" (chaos-map (picture) driven 5 #:samples 2 #:state at-zero
                                                #:indicator kind #:jobs 1)))))

(test-case "a picture of a map by each of them: the island at the middle is regular"
  (for ([kind '(FLI MEGNO SALI)])
    (define f (frame 0 :2pi 0 :2pi #:width 60 #:height 60))
    (chaos-map f (standard-map 1.0) 1000 #:samples '(3 6) #:indicator kind)
    (define r (layer-data (car (frame-now f))))
    (define (color row column)
      (define k (* 4 (+ column (* 3 row))))
      (bytes->list (subbytes (raster-bytes r) (+ k 1) (+ k 4))))
    (check-true (> (caddr (color 5 1)) (car (color 5 1))))    ; at (π, 0.5), blue
    (check-false (> (caddr (color 5 0)) (car (color 5 0))))))

(test-case "a picture grows row by row, and stays as far as it came"
  (define seen '())
  (define (note! all)
    (set! seen (cons (for/sum ([x (in-flvector all)]) (if (= x -inf.0) 0 1)) seen)))
  (motion-indicators 'chaos-map driven (lambda (x y) (up 0 x y)) (flvector -1.0 0.5)
                     (flvector 0.0 1.0 1.5) 5.0 #:indicator 'FLI #:tolerance 1e-10 #:jobs 1
                     #:checkpoint #f #:grown note!)
  (check-equal? (reverse seen) '(2 4 6))
  (define (breaks-below x y return fail)
    (if (< y 1) (error "broken off") (cat x y return fail)))
  (define f (frame 0 2 0 2 #:width 60 #:height 60))
  (check-exn #rx"broken off" (lambda () (chaos-map f breaks-below 1 #:samples 4)))
  (define r (layer-data (car (frame-now f))))
  (check-equal? (for/list ([row 4]) (bytes-ref (raster-bytes r) (* 16 row))) '(255 255 0 0)))

(says
 [(of driven 5 'fli)
  "chaos-indicator: expected 'FLI, 'MEGNO or 'SALI\n  given: the symbol fli"]
 [(of driven -5 'FLI)
  "chaos-indicator: expected a positive duration\n  given: the number -5"]
 [(chaos-map (picture) (standard-map 1) 5 #:indicator 'megno)
  "chaos-map: expected 'FLI, 'MEGNO or 'SALI\n  given: the symbol megno"]
 [(chaos-indicator (standard-map 1) (up 1.0 2.0) 5 #:tolerance 1e-8)
  "chaos-indicator: a tolerance is for motions; the steps of a map have none\n  given: 1e-8"]
 [(chaos-map (picture) (standard-map 1) 5 #:tolerance 1e-8)
  "chaos-map: a tolerance is for motions; the steps of a map have none\n  given: 1e-8"]
 [(chaos-map (picture) (standard-map 1) 5 #:checkpoint "a.ensemble")
  "chaos-map: a checkpoint is for motions, with #:state\n  file: a.ensemble"]
 [(chaos-map (picture) (stroboscopic-map oscillator 1) 5)
  "chaos-map: motions are followed by their state derivative, with their variations\n"
  "  given: (stroboscopic-map oscillator 1)\n"
  "  (chaos-map frame derivative duration #:state (lambda (q p) (up 0 q p)))"]
 [(chaos-map (picture) driven 5 #:samples 2 #:state (lambda (q p) #f))
  "chaos-map: #:state gives no state in the frame"]
 [(chaos-map (picture) (standard-map 1) 5 #:state at-zero)
  "chaos-map: with #:state, expected a state derivative\n"
  "  given: the procedure `standard-map`"])
