#lang racket/base
;; How long the next step of an implicit method should be (Gustafsson 1994; Hairer and
;; Wanner, IV.8).
;;
;; The error of a step is φ h⁴, and after one step h · error^(−1/4) would be right if φ
;; stayed as it is.  Along a stiff motion φ changes steadily, by orders of magnitude: the
;; last two steps, of errors e₀ and e₁, tell by which factor, and the step predicted is
;;
;;     h₁ · e₁^(−1/4) · (h₁/h₀) · (e₀/e₁)^(1/4).
;;
;; The shorter of the two is taken, shortened by a tenth, and more if Newton's iteration
;; was slow: a shorter step will be solved for faster.

(require racket/flonum)

(provide make-controller)

(define safety 0.9)
(define greatest-growth 8.0)
(define least-growth 0.2)

;; -> (h error iterations -> length of the next step); error in units of the tolerance,
;; above 1 if the step is rejected; iterations : how many were made of at most `most`
(define (make-controller most)
  (define last-length 0.0)    ; of the step accepted last; 0 before the first, which predicts +inf.0
  (define last-error 1.0)
  (define rejected? #f)
  (define (shortened iterations)
    (flmin safety
           (fl/ (fl* safety (->fl (+ 1 (* 2 most)))) (->fl (+ iterations (* 2 most))))))
  (define (by-prediction h error factor)
    (fl* factor (fl* (fl/ h last-length) (root4 (fl/ last-error (fl* error error))))))
  (lambda (h error iterations)
    (define factor (shortened iterations))
    (define growth (fl* factor (root4 (fl/ 1.0 (flmax error 1e-12)))))
    (define (bounded x greatest) (fl* h (flmax least-growth (flmin greatest x))))
    (cond
      [(fl<= error 1.0)
       (define predicted (flmin growth (by-prediction h (flmax error 1e-12) factor)))
       (define next (bounded predicted (if rejected? 1.0 greatest-growth)))
       (set! last-length h)
       (set! last-error (flmax 1e-2 error))
       (set! rejected? #f)
       next]
      [else
       (set! rejected? #t)
       (bounded growth 1.0)])))

(define (root4 x) (flsqrt (flsqrt x)))
