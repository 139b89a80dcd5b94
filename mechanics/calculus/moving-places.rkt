#lang racket/base
;; Where an integrand that is being differentiated takes another branch, and how these places
;; move.
;;
;; With ∫ f(x, a) dx from 0 to 1, f = 1 for x < a and 0 elsewhere, ∂f/∂a is 0 wherever it is
;; defined, and the derivative of the integral is 1: Leibniz' rule asks for the jump of f,
;; times dc/da, at each place c(a) where it jumps.  Divided at c, all pieces have smooth
;; integrands, and moving ends; so |x − a| is right to any order, too.
;;
;; Places are found from the choices made at points in between (branch-points.rkt), by halving
;; (branch-turning-points.rkt says how two between the same points are); and c as a perturbed value
;; from the number s that is chosen by, which is 0 there,
;;
;;     c ← c − s(c, a)/s',
;;
;; in the arithmetic of perturbed values, where s' from differences will do: repeated often
;; enough, the steps mend its error.
;;
;; Of an integral within the integrand of another, s(x, y, a) = 0 may leave the range of y as x
;; goes on.  So the choices at the ends of its range are told to the one around it.

(require "branch-points.rkt" "branch-turning-points.rkt" "perturbed-value.rkt"
         "../error/failure.rkt"
         "../generic/arithmetic.rkt" "../generic/operation-rule/branches.rkt")

(provide moving-places aside tell-choices-at-ends)

;; The places between two numbers where f changes its choices, in order.
(define (moving-places who f low high)
  (define samples (with-turning-points f (samples-between f low high)))
  (for/list ([p (in-list samples)] [q (in-list (cdr samples))]
             #:unless (alike? (choice-sample-made p) (choice-sample-made q)))
    (place who f p q)))

(define (place who f p q)
  (define-values (x y) (values (choice-sample-x p) (choice-sample-x q)))
  (define middle (* 0.5 (+ x y)))
  (cond [(or (<= middle x) (>= middle y)) (moving-root who f p q)]
        [else
         (define m (sample-choices f middle))
         (if (alike? (choice-sample-made p) (choice-sample-made m))
             (place who f m q)
             (place who f p m))]))

;; p, q : next to each other
(define (moving-root who f p q)
  (define x (choice-sample-x p))
  (define-values (cs ds) (values (choice-sample-made p) (choice-sample-made q)))
  (define k (first-difference cs ds))
  (define (nth choices) (list-ref choices k))
  (define middle ((choice-between (nth cs)) (choice-made (nth cs)) (choice-made (nth ds))))
  (define (s x) (g:- (or (chosen-by f x k) (raise-unclear who (innermost x))) middle))
  (define h (* 1e-6 (+ 1.0 (abs x))))
  (define slope (/ (- (innermost (s (+ x h))) (innermost (s (- x h)))) (* 2.0 h)))
  (when (or (not (rational? slope)) (= slope 0.0)) (raise-unclear who x))
  (for/fold ([c x]) ([_ (in-range newton-steps)]) (g:- c (g:/ (s c) slope))))

(define newton-steps 6)

(define (raise-unclear who x)
  (raise-singular who
                  (string-append "the integral has no derivative found: how the place moves where "
                                 "the integrand takes another branch is not clear")
                  x "at" x))

;; The displacement of an end of a piece at which f takes the branch of the piece: more than
;; rounding, and as little beyond that as serves.
(define (aside f end other)
  (define direction (if (< end other) 1.0 -1.0))
  (define far (if (rational? other) (* 0.5 (abs (- other end))) 1.0))
  (define (choices-at distance)
    (choice-sample-made (sample-choices f (+ end (* direction distance)))))
  (define inside (choices-at far))
  (let loop ([distance (* 1e-13 (+ 1.0 (abs end)))])
    (cond [(>= distance far) (* direction far)]
          [(alike? inside (choices-at distance)) (* direction distance)]
          [else (loop (* 4.0 distance))])))

;; ---------------------------------------------------------------------------

;; Tells a listener to branches, if there is one, those that f takes at the ends.
(define (tell-choices-at-ends f low high)
  (when (current-branches)
    (for ([end (list low high)] #:when (rational? end))
      (with-handlers ([no-value? void]) (f end)))))
