#lang racket/base
;; Watching for events, step by step.
;;
;; After each step of the integration the sign of an event's function is looked at in a few
;; places within the step, and where it differs between two of them there is a zero
;; (sign-change.rkt).  The value where a step begins is the one where the last step ended:
;; computed again it may differ by rounding, and a zero in between would be missed.
;;
;; Steps that are polynomials leave nothing to chance: there the zeros of the polynomial that
;; the event's function is along the step are isolated (event-polynomial.rkt), and where it
;; touches zero is found as well.
;;
;; The zeros of a function that is nothing but noise are no events (event-noise.rkt).

(require racket/flonum
         "event.rkt" "event-noise.rkt" "event-polynomial.rkt" "sign-change.rkt"
         "../../compile/compile-function.rkt")

(provide watch-for watches-for watches-by-code)

;; polynomial : interpolant, value where it begins or #f -> the parts, 'clear or count of places of
;;              event-polynomial.rkt
;; noise?     : part -> is the function noise along it?
;; sampled    : interpolant -> place -> value; doubtful : the same, at a state that is changed by
;;              its uncertainty
;; last       : the value where the last step ended, or #f; size : the greatest value of the last
;;              step, if it was looked at in places
(struct watched (event polynomial noise? sampled doubtful [last #:mutable] [size #:mutable])
  #:authentic)

;; -> (interpolant -> the crossings within a step, in order), to be called for each step in turn
(define (watch-for who events state n tolerance)
  ((watches-for who events state n tolerance)))

;; -> (-> the result of watch-for), for one motion after another
(define (watches-for who events state n tolerance)
  (watches-by-code events (for/list ([e (in-list events)]) (event-code who e state)) n tolerance))

;; codes : of the events' functions, compiled
(define (watches-by-code events codes n tolerance)
  (define (new-watch e c)
    (define code (compiled-function-runner c))
    (define value (make-flvector 1))
    (define (value-at point)
      (code point value)
      (flvector-ref value 0))
    (define-values (polynomial only-noise?)
      (polynomial-along (compiled-function-program c) n tolerance value-at))
    (define-values (sampled doubtful) (samplers value-at n tolerance))
    (watched e polynomial only-noise? sampled doubtful #f 0.0))
  (lambda () (watch (map new-watch events codes) tolerance)))

(define (watch all tolerance)
  (lambda (at)
    (define found
      (for*/list ([w (in-list all)]
                  [found (in-list (crossings-along! w at tolerance))])
        found))
    (if (or (null? found) (null? (cdr found))) found (sort found < #:key crossing-at))))

;; value-at : flvector -> value
(define (samplers value-at n tolerance)
  (define point (make-flvector n))
  (define ((sampled at) theta)
    (at theta point)
    (value-at point))
  (define (doubtful at)
    (define by (uncertainties at n tolerance))
    (lambda (theta)
      (at theta point)
      (vary-point! point by)
      (value-at point)))
  (values sampled doubtful))

(define (event-code who e state)
  (define value (event-value who e state))
  (define c (compile-function (event-f e) state #:name who #:value value))
  (unless (= (compiled-function-outputs c) 1)
    (check-event-value who e (compiled-function-value-shape c)))
  c)

;; The zeros in (0, 1], up to where the function is undefined; one at 0 belongs to the step
;; before.
(define (crossings-along! w at tolerance)
  (define p ((watched-polynomial w) at (watched-last w)))
  (cond [(exact-integer? p) (crossings! w at p)]
        [(eq? p 'clear)
         (set-watched-last! w #f)
         '()]
        [else
         (set-watched-last! w (polynomial-end p))
         (crossings-of w (zeros-along p tolerance (watched-noise? w)))]))

(define (crossings-of w zeros)
  (define e (watched-event w))
  (define direction (event-direction e))
  (for/list ([z (in-list zeros)]
             #:when (or (eq? direction 'both) (eq? direction (zero-kind z))))
    (crossing (zero-at z) e (eq? (zero-kind z) 'touching))))

;; The same where nothing is known of the function, by its values at so many places.
(define (crossings! w at places)
  (define g ((watched-sampled w) at))
  (define size (watched-size w))
  (set-watched-size! w 0.0)
  (define found (sign-changes! w g places))
  (define (change)
    (define h ((watched-doubtful w) at))
    (for/fold ([most 0.0]) ([k (in-range 1 (+ places 1))])
      (define theta (place k places))
      (flmax most (flabs (fl- (h theta) (g theta))))))
  (if (and (pair? found) (noise? (flmax size (watched-size w)) (change)))
      (filter (lambda (c) (undefined? (crossing-event c))) found)
      found))

;; Crossings between so many places.
(define (sign-changes! w g places)
  (define e (watched-event w))
  (let loop ([a 0.0] [ga (or (watched-last w) (g 0.0))] [k 1])
    (set-watched-size! w (flmax (watched-size w) (flabs ga)))
    (cond [(not (fl= ga ga)) (list (crossing a (undefined e) #f))]
          [(> k places)
           (set-watched-last! w ga)
           '()]
          [else
           (define b (place k places))
           (define gb (g b))
           (define (rest) (loop (if (fl= gb gb) b (last-value g a b)) gb (+ k 1)))
           (define zero
             (and (crosses? ga gb (event-direction e)) (zero-between g a ga b gb)))
           (if zero (cons (crossing zero e #f) (rest)) (rest))])))

(define (place k places) (fl/ (->fl k) (->fl places)))
