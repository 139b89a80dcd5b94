#lang racket/base
;; The choices that a function makes at points: the values, and the way
;; (generic/operation-rule/branches.rkt).

(require "perturbed-value.rkt"
         "../error/failure.rkt"
         "../generic/operation-rule/branches.rkt")

(provide (struct-out choice) (struct-out choice-sample)
         samples-between sample-choices chosen-by alike? first-difference)

;; a value that was chosen by, the choice, and the number between two choices
(struct choice (value made between) #:authentic)

;; made : all choices at x, in order
(struct choice-sample (x made) #:authentic)

(define cells 160)
(define edge 1e-15)                    ; of the whole, from an end

;; In the middle of cells, or nearly, and close to both ends.
(define (samples-between f low high)
  (define (at t)
    (cond [(and (rational? low) (rational? high)) (+ low (* t (- high low)))]
          [(rational? low) (+ low (/ t (- 1.0 t)))]
          [(rational? high) (- high (/ (- 1.0 t) t))]
          [else (/ (- (* 2.0 t) 1.0) (* t (- 1.0 t)))]))
  (define inside
    (for/list ([k (in-range cells)]) (/ (+ k 0.5127) cells)))
  (for/list ([t (in-list (append (list edge) inside (list (- 1.0 edge))))])
    (sample-choices f (exact->inexact (at t)))))

;; The choices at x, up to the place where f fails, as |u|' does at 0
(define (sample-choices f x)
  (define made '())
  (define (note! value choice-made between)
    (set! made (cons (choice value choice-made between) made)))
  (with-handlers ([no-value? void])
    (parameterize ([current-branches note!]) (f x)))
  (choice-sample x (reverse made)))

;; The value that the choice k is made by at x, or #f.  Where x is perturbed there are more
;; choices, of values that depend on x alone; their numbers tell which are those at the number x.
(define (chosen-by f x k)
  (define numbers
    (for/list ([c (in-list (choice-sample-made (sample-choices f (innermost x))))]
               [_ (in-range (+ k 1))])
      (innermost (choice-value c))))
  (let/ec return
    (define left numbers)
    (define (note! value made between)
      (when (and (pair? left) (eqv? (innermost value) (car left)))
        (set! left (cdr left))
        (when (null? left) (return value))))
    (when (= (length numbers) (+ k 1))
      (parameterize ([current-branches note!]) (f x)))
    #f))

(define (alike? cs ds) (not (first-difference cs ds)))

;; Which choice differs first, or #f; 0 is no choice of its own.
(define (first-difference cs ds)
  (for/first ([c (in-list cs)] [d (in-list ds)] [k (in-naturals)]
              #:unless (equal? (choice-made c) (choice-made d)))
    k))
