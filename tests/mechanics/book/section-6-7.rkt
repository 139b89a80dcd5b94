#lang racket/base
;; SICM 6.7, the project on symplectic integration (pp. 453-456).

(require mechanics
         mechanics/book
         mechanics/plot
         "../support/checks.rkt" "../support/close.rkt")

(define E 1/12)
(define (star) (frame -0.6 0.8 -0.6 0.6))
(define (points f) (map vector->list (frame-points f)))

;; The motion to rounding, in place of a symplectic map
(define advance (make-advance (state-advancer HHsysder) 1e-13))

(test-case "p. 456: with a precise motion the crossings are those of the section's map"
  (define win (star))
  (define start (list (up 0.1 0.)))
  (check-eq? (explore-map win (HH-collector win advance E 0.1 1e-12 5) #f #:starts start) win)
  (define other (star))
  (explore-map other (HHmap E 0.1 1e-12 1e-13) 5 #:starts start)
  (check-equal? (length (points win)) 6)
  (for ([p (points win)] [q (points other)]) (check-close p q 1e-8)))

(test-case "it goes on from the states that it hands on, in the same rhythm"
  (define-values (whole parts) (values (star) (star)))
  ((HH-collector whole advance E 0.25 1e-12 4) 0.1 0. list void)
  (define half (HH-collector parts advance E 0.25 1e-12 2))
  (half 0.1 0. (lambda (crossing beyond) (half crossing beyond list void)) void)
  (for ([p (points whole)] [q (list (list-ref (points parts) 0) (list-ref (points parts) 1)
                                    (list-ref (points parts) 2) (list-ref (points parts) 4)
                                    (list-ref (points parts) 5))])
    (check-close p q 1e-12)))

(test-case "where the energy does not suffice there is no orbit"
  (check-equal? ((HH-collector (star) advance E 0.1 1e-12 5) 0.9 0. list (lambda () 'outside))
                'outside))
