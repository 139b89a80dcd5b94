#lang mechanics
;; Sections of the standard map  (SICM 3.9, pp. 279 and 280)
;;
;; K = 0.6, where curves around the torus hold each orbit in a range of I, and on the right K = 1.4,
;; where the last of them are gone.

(require mechanics/plot mechanics/book)

;; Both in one frame, side by side.
(define gap 0.5)
(define win (frame 0 (+ (* 2 :2pi) gap) 0 :2pi #:width 800 #:height 400 #:y-label "I"))
(define (shifted T by)
  (lambda (x y return fail)
    (T (- x by) y (lambda (theta I) (return (+ theta by) I)) fail)))
(define right (+ :2pi gap))
(define starts (for/list ([k 16]) (list (if (even? k) 0.1 3.) (* k (/ :2pi 16)))))
(define (even? k) (= (modulo k 2) 0))
(for ([K '(0.6 1.4)] [by (list 0 right)])
  (explore-map win (shifted (standard-map K) by) 2000
               #:from (map (lambda (start) (up (+ by (car start)) (cadr start))) starts)))

win

(module+ main
  (require "save.rkt")
  (save-figure win "standard-map-sections.png"))

(module+ test
  (require rackunit)
  (test-case "after one step and ten"
    (define (after K n) ((iterated-map (standard-map K) n) 1. 1. list void))
    (check-= (car (after 0.6 10)) 2.02201816481268 1e-12)
    (check-= (cadr (after 1.4 10)) 1.7744615690744 1e-11))
  (test-case "the golden circle is there at 0.6"
    (define circle (invariant-circle (standard-map 0.6) (- 1 (/ 1 golden-ratio))))
    (check-true (< (invariant-circle-error circle) 1e-13)))
  (test-case "the rotation about (π, 0), and what stretches at (0, 0)"
    (define (at K theta) (find-fixed-point (standard-map K) (up theta 0.)))
    (check-= (fixed-point-rotation-angle (at 0.6 3.1)) 0.795398830184 1e-9)
    (check-= (fixed-point-rotation-angle (at 1.4 3.1)) 1.26610367278 1e-9)
    (check-= (car (fixed-point-multipliers (at 1.4 0.))) 3.07477270848675 1e-9)))
