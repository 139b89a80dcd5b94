#lang mechanics
;; Exercise 3.10 (SICM 3.6.1): a phase portrait
;; Checked: places of rest and the separatrix of a quartic oscillator with two wells
;; How: plot-phase-portrait finds them; the exact separatrix is put into the Hamiltonian

(require mechanics/plot)

;; A system of one degree of freedom: V(x) = x⁴/4 − x²/2, wells at ±1 and a hill between.
(define (H s)
  (define-values (x p) (values (coordinate s) (momentum s)))
  (+ (* 1/2 (square p)) (* 1/4 (expt x 4)) (* -1/2 (square x))))

(define portrait (plot-phase-portrait (frame -1.8 1.8 -1.2 1.2 #:x-label "x" #:y-label "p") H))
portrait

;; It rests where p = 0 and V'(x) = 0: in both wells and on the hill.
(define (at x p) (up 0 x p))
(map (lambda (x) ((D H) (at x 0))) '(-1 0 1))

;; An attempt: the orbits that take for ever leave the hill with its energy, 0, so
;; p² = x² − x⁴/2, from x = 0 to √2 and back; and a slip: with x⁴ for x⁴/2.
(define (attempt x) (sqrt (- (square x) (* 1/2 (expt x 4)))))
(define (slip x) (sqrt (- (square x) (expt x 4))))
(define right (verify-equal (H (at 'x (attempt 'x))) 0))
right
(define wrong (verify-equal (H (at 'x (slip 'x))) 0))

(module+ test
  (require rackunit)
  (test-case "it rests in the wells and on the hill"
    (for ([x '(-1 0 1)])
      (check-equal? (ref ((D H) (at x 0)) 1) 0)
      (check-equal? (ref ((D H) (at x 0)) 2) 0))
    (check-equal? (length (frame-points portrait)) 3))
  (test-case "the separatrix"
    (check-pred proved? right)
    (check-pred refuted? wrong)))
