#lang racket/base
;; The derivative of functions of one variable from their values, with an estimate of
;; its error (C. J. F. Ridders, Advances in Engineering Software 4, 1982, 75).
;;
;; The difference quotient over x ± h has an error of even powers of h,
;;
;;     (f(x + h) − f(x − h))/2h = f'(x) + c₂ h² + c₄ h⁴ + …,
;;
;; and with that for h/2 the first of them goes away: (4 D(h/2) − D(h))/3.  So on, with
;; each halving, a row of the table
;;
;;     A(i, 0) = D(h/2ⁱ),   A(i, j) = A(i, j−1) + (A(i, j−1) − A(i−1, j−1))/(4ʲ − 1),
;;
;; in which an entry's difference from the two it is made of estimates its error, and
;; rounding adds ε |f|/h.  One does not go to small h: rounding would win.  The entry of
;; least error is the derivative; once it is good enough, the search ends when errors grow.
;;
;; At a kink all that converges too, to the mean of two slopes.  But there their
;; difference, (f(x + h) − 2 f(x) + f(x − h))/h, does not fall with h.

(require racket/flonum
         racket/list
         "../constants.rkt" "../flvector.rkt" "../checked-arguments.rkt"
         "../../error/failure.rkt")

(provide difference-derivative)

(define most-rows 40)

;; value, error : flvectors; badness : the error beside the size of the values, or +inf.0
(struct entry (value error badness) #:authentic)

;; Results of the steps so far.  row : the last row of the table, empty where f was not finite;
;; best : the entry of least error, or #f; scale : slopes that the values would make over the
;; first step; turn : the difference of the slopes on both sides; bends : how many times in a row
;; this difference did not fall; count : of steps
(struct search (row best scale turn bends count) #:authentic)

;; given  : flonum -> flvector, of one length
;; known  : its value at x, which counts as one evaluation, or #f
;; shape  : the user's form of an flvector
;; -> derivative, error, evaluations
(define (difference-derivative given x
                               #:step [step (* 0.1 (max 1.0 (abs x)))]
                               #:tolerance [tolerance 1e-8]
                               #:middle [known #f]
                               #:shape [shape values]
                               #:name [who 'D-numeric])
  (check-tolerance who tolerance)
  (define evaluations (if known 1 0))
  (define (f x)
    (set! evaluations (+ evaluations 1))
    (given x))
  (define middle (or known (f x)))
  (let loop ([h (real->double-flonum step)] [s (search '() #f #f #f 0 0)])
    (define after (f (+ x h)))
    (define before (f (- x h)))
    (define there? (andmap flvector-finite? (list after before middle)))
    (define next (if there? (refined s after middle before h) (interrupted s)))
    (define last? (>= (search-count next) most-rows))
    (define good? (and there? (good-enough? s next tolerance)))
    (define end? (and good? (= (search-bends next) 0) (or last? (at-its-best? next tolerance))))
    (cond
      [(and good? (>= (search-bends next) most-bends)) (raise-kinked who x)]
      [(and end? (holds-elsewhere? f x h next tolerance))
       (define best (search-best next))
       (values (entry-value best) (entry-error best) evaluations)]
      [(and last? (not there?))
       (raise-singular who "the function is not finite on both sides" x "at" x)]
      [(and last? (or end? (not good?))) (raise-not-found who x next shape evaluations)]
      [else (loop (* 0.5 h) (if end? (begun-anew next) next))])))

;; All steps may be many periods of f, and nearly whole ones: 1000/10, 1000/20 ... are, of the
;; sine, by a hundredth.  Then a step that is no half of another finds something else; the
;; quotient over it is to be no farther from the derivative than that over the last one, which
;; is longer.
(define (holds-elsewhere? f x h s tolerance)
  (define h* (* golden-fraction h))
  (define-values (after before) (values (f (+ x h*)) (f (- x h*))))
  (define best (entry-value (search-best s)))
  (define longer (entry-value (car (search-row s))))
  (for/and ([a (in-flvector after)] [b (in-flvector before)] [v (in-flvector best)]
            [q (in-flvector longer)] [scale (in-flvector (search-scale s))])
    (define rounding (/ (* 8.0 epsilon (+ (abs a) (abs b))) h*))
    (<= (distance (/ (- a b) (* 2.0 h*)) v)
        (+ (* 2.0 (distance q v)) rounding (* 10.0 tolerance (max (abs v) scale))))))

(define (begun-anew s) (search '() #f (search-scale s) #f 0 (search-count s)))

(define (raise-not-found who x s shape evaluations)
  (define best (search-best s))
  (raise-not-convergent who "no derivative found" (shape (entry-value best))
                        (shape (entry-error best))
                        "at" x "evaluations" evaluations))

;; The search after one more step, h.
(define (refined s after middle before h)
  (define sizes (flvector-map (lambda (a b) (max (abs a) (abs b))) after before))
  (define rounding (flvector-map (lambda (s) (/ (* epsilon s) h)) sizes))
  (define scale (or (search-scale s) (flvector-map (lambda (s) (/ s h)) sizes)))
  (define quotient (flvector-map (lambda (a b) (/ (- a b) (* 2.0 h))) after before))
  (define turn (turn-of after middle before h))
  (define bent? (and (search-turn s) (stays? turn (search-turn s) rounding)))
  (define row (extend (search-row s) quotient rounding scale))
  (define best (search-best s))
  (search row (least-bad (if best (cons best row) row)) scale turn
          (if bent? (+ (search-bends s) 1) 0)
          (+ (search-count s) 1)))

(define (interrupted s)
  (search '() (search-best s) (search-scale s) #f 0 (+ (search-count s) 1)))

(define (good-enough? before s tolerance)
  (and (<= (entry-badness (search-best s)) tolerance)
       (confirms? (search-row before) tolerance)
       (confirms? (search-row s) tolerance)))

(define (at-its-best? s tolerance)
  (define best (search-best s))
  (or (<= (entry-badness best) (* 1e-3 tolerance))
      (worsening? (search-row s) best)))

(define most-bends 4)

;; Where h is longer than a period of f, entries agree by accident; not in two rows.
(define (confirms? row tolerance)
  (and (pair? row) (<= (entry-badness (least-bad row)) (* 10.0 tolerance))))

(define (raise-kinked who x)
  (raise-singular who "the slopes of the function on both sides differ" x "at" x))

;; The difference of the slopes on both sides.
(define (turn-of after middle before h)
  (flvector-map (lambda (sum m) (/ (- sum (* 2.0 m)) h)) (flvector-map + after before) middle))

;; Does it stay when h is halved, and is it more than rounding?
(define (stays? turn before rounding)
  (for/or ([t (in-flvector turn)] [b (in-flvector before)] [r (in-flvector rounding)])
    (and (> (abs t) (* 0.75 (abs b))) (> (abs t) (* 1e3 r)))))

;; Is the last row far worse than the best entry?
(define (worsening? row best)
  (and (> (length row) 2)
       (> (entry-badness (least-bad row)) (max 1e-13 (* 8.0 (entry-badness best))))))

(define (least-bad entries) (argmin entry-badness entries))

;; ---------------------------------------------------------------------------
;; The table

;; (A(i−1, 0) A(i−1, 1) ...) and the quotient A(i, 0) -> (A(i, 0) A(i, 1) ...)
(define (extend row quotient rounding scale)
  (define unknown (flvector-map (lambda (_) +inf.0) quotient))
  (let loop ([value quotient] [error unknown] [row row] [power 4.0])
    (define here (entry value error (badness value error scale)))
    (cons here
          (if (null? row)
              '()
              (let* ([old (entry-value (car row))]
                     [new (flvector-map (lambda (v o) (+ v (/ (- v o) (- power 1.0)))) value old)])
                (loop new (error-of new value old rounding) (cdr row) (* 4.0 power)))))))

(define (error-of new value old rounding)
  (flvector-map + rounding
                 (flvector-map max
                                (flvector-map distance new value)
                                (flvector-map distance new old))))

(define (distance a b) (abs (- a b)))

;; scale : slopes that the values would make over the first step
(define (badness value error scale)
  (for/fold ([m 0.0]) ([v (in-flvector value)] [e (in-flvector error)] [s (in-flvector scale)])
    (if (= e 0.0) m (max m (/ e (max (abs v) s))))))
