#lang racket/base
;; Symplectic methods by composition: leapfrog, and Yoshida's of orders 4, 6 and 8.
;;
;; For a state (t, q, p), or (q, p), in which the slope of q depends on p alone and
;; that of p on t and q alone, both parts of the motion can be followed exactly:
;; the drift of q at constant p and the kick of p at constant q.  Half a kick, a
;; drift and half a kick make the leapfrog step S(h), of order 2.  It is its own
;; inverse for −h, and so S(w₁h) ... S(w₁h) with suitable weights, some of them
;; negative, is of higher order (H. Yoshida, Phys. Lett. A 150, 1990, 262).
;;
;; A composition of exact motions is symplectic whatever the step: energies do not
;; drift.  That takes steps of one length.

(require racket/flonum
         "gauss-legendre.rkt" "shorter-step.rkt" "stepper.rkt" "vector-formulas.rkt"
         "../flvector.rkt")

(provide leapfrog yoshida-4 yoshida-6 yoshida-8)

(define ((start weights) f! y0)
  (define kicks (kicks-between weights))
  (define drifts (apply flvector weights))
  (define n (flvector-length y0))
  (define q-start (remainder n 2))      ; a clock comes first
  (define p-start (+ q-start (quotient n 2)))
  (define y (flvector-copy y0))
  (define-vectors n z dz)
  (define (try! h slope)
    (flvector-copy! z y)
    (kick-and-drift! f! z dz p-start n h kicks drifts)
    (if (flvector-finite? z) 0.0 +nan.0))
  (stepper-by-shorter-steps (start weights) f! y z try!))

;; The kicks, with the drifts between them, of a step from z, whose momenta begin at p-start.
(define (kick-and-drift! f! z dz p-start n h kicks drifts)
  (define-syntax-rule (move! weights k from to)
    (begin
      (f! z dz)
      (advance! z dz (fl* h (flvector-ref weights k)) from to)))
  (let loop ([k 0])
    (move! kicks k p-start n)
    (when (< k (flvector-length drifts))
      (move! drifts k 0 p-start)
      (loop (+ k 1)))))

;; Half a weight before each drift and after it; two half kicks that meet are one.
(define (kicks-between weights)
  (for/flvector ([before (in-list (cons 0.0 weights))] [after (in-list (append weights '(0.0)))])
    (fl* 0.5 (fl+ before after))))

;; Weights that read the same both ways: w_m ... w₁ w₀ w₁ ... w_m, with sum 1.
(define (symmetric . ws)
  (define w0 (fl- 1.0 (fl* 2.0 (apply + ws))))
  (append (reverse ws) (list w0) ws))

(define weights-4 (symmetric (/ 1.0 (- 2.0 (expt 2.0 (/ 1.0 3.0))))))
(define weights-6 (symmetric -1.17767998417887 0.235573213359357 0.784513610477560))
(define weights-8
  (symmetric 0.102799849391985 -1.96061023297549 1.93813913762276 -0.158240635368243
             -1.44485223686048 0.253693336566229 0.914844246229740))

;; Methods with steps of length h.
(define ((composition name order weights alternative) h)
  (fixed-step-method name order h (start weights) #:alternative alternative))

(define leapfrog (composition 'leapfrog 2 '(1.0) gauss-legendre-2))
(define yoshida-4 (composition 'Yoshida-4 4 weights-4 gauss-legendre-4))
(define yoshida-6 (composition 'Yoshida-6 6 weights-6 gauss-legendre-6))
(define yoshida-8 (composition 'Yoshida-8 8 weights-8 gauss-legendre-6))
