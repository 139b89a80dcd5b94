#lang racket/base
;; Events: when something happens along a trajectory.
;;
;; An event is a function of the state that passes through zero when it happens:
;; the height above the table, the force of a constraint.  After each step of the
;; integration its sign is looked at in a few places within the step; between two
;; of them where it differs the zero is found by the Illinois method (Dowell and
;; Jarratt 1971), false position in which the weight of an end that stays too long
;; is halved.  The value where a step begins is the one where the last step ended:
;; computed again it may differ by rounding, and a zero in between would be missed.
;; A pole changes the sign as well, and is no zero.
;;
;; Steps that are polynomials leave nothing to chance: there the zeros of the polynomial that
;; the event's function is along the step are isolated (event-polynomial.rkt), and where it
;; touches zero is found as well.
;;
;; The zeros of a function that is nothing but noise are no events (event-noise.rkt).

(require racket/flonum
         "check.rkt" "event-noise.rkt" "event-polynomial.rkt"
         "../algebra/expression/expression.rkt"
         "../compile/compile-function.rkt"
         "../error/complain.rkt" "../error/failure.rkt" "../error/hint.rkt"
         "../generic/define-plain.rkt" "../generic/describe.rkt" "../generic/function.rkt"
         "../generic/kind.rkt" "../generic/notation.rkt" "../generic/value-struct.rkt"
         "../generic/wrong-argument.rkt"
         "../value/shape.rkt")

(provide event event? event-f event-name event-direction event-terminal?
         event-value raise-undefined
         occurrence occurrence?
         (rename-out [event-of-it occurrence-event] [time-of-it occurrence-time]
                     [state-of-it occurrence-state] [grazing-at-it? occurrence-grazing?])
         check-events
         watch-for watches-for watches-by-code (struct-out crossing) (struct-out undefined)
         crosses?)

;; f : state -> real; direction : 'rising, 'falling or 'both
(value-struct event (f name direction terminal?)
  #:datum (lambda (e) (list 'event (event-name e)))
  #:notation (lambda (e see) (statement (list 0 "event" (see (event-name e)))))
  #:constructor-name make-event
  #:omit-define-syntaxes)

(define-plain (event f #:name [name (procedure-datum f)]
               #:direction [direction 'both] #:terminal? [terminal? #f])
  (unless (and (procedure? f) (accepts? f 1))
    (complain 'event "expected a function of one state\n  given: ~a" (describe-function f)))
  (unless (memq direction '(rising falling both))
    (complain-of-argument 'event "'rising, 'falling or 'both" direction))
  (make-event f name direction terminal?))

;; -> list of events
(define (check-events who events)
  (define all (if (list? events) events (list events)))
  (for ([e (in-list all)])
    (unless (event? e)
      (complain who
                "expected events; (event f) makes one of a function of the state\n  given: ~a"
                (describe-with-value e))))
  all)

;; An event, when it happened and the state then; grazing? : did its function only touch zero?
(value-struct occurrence (event time state grazing?)
  #:datum (lambda (o)
            (list 'occurrence (event-name (occurrence-event o)) (occurrence-state o)))
  #:notation (lambda (o see)
               (statement (list 0 "event" (see (event-name (occurrence-event o))) "at"
                                (see (occurrence-state o))))))

(define-parts occurrence? "an occurrence, one of those that (trajectory-events tr) gives"
  [event-of-it occurrence-event] [time-of-it occurrence-time]
  [state-of-it occurrence-state] [grazing-at-it? occurrence-grazing?])

;; so-far : the trajectory up to there
(define (raise-undefined e t state so-far)
  (raise-singular 'evolve-trajectory "the function of an event has no real value" so-far
                  "event" e
                  "time" t
                  "state" state))

;; ---------------------------------------------------------------------------
;; Watching

;; polynomial : interpolant, value where it begins or #f -> its polynomial along the step, or #f
;; noise?     : interpolant -> is that polynomial noise?
;; sampled    : interpolant -> place -> value; doubtful : the same, of a state that is changed by
;;              what is uncertain of it
;; last       : its value where the last step ended, or #f; size : the greatest that was seen
;;              of the last step, if it was looked at in places
(struct watched (event polynomial noise? sampled doubtful [last #:mutable] [size #:mutable])
  #:authentic)

;; An event whose function has no real value.
(struct undefined (event) #:authentic)

;; What is found within a step: `event`, or that it is undefined, `at` a place, from 0 to 1,
;; or a time; grazing? : is zero only touched?
(struct crossing (at event grazing?) #:authentic)

;; -> (interpolant -> crossings): what is within a step, in order; to be asked of each step
;; in turn
(define (watch-for who events state n tolerance)
  ((watches-for who events state n tolerance)))

;; -> (-> what watch-for gives), for one motion after another
(define (watches-for who events state n tolerance)
  (watches-by-code events (for/list ([e (in-list events)]) (event-code who e state)) n tolerance))

;; codes : of the events' functions, compiled
(define (watches-by-code events codes n tolerance)
  (define (new-watch e c)
    (define-values (polynomial noise?)
      (polynomial-along (compiled-function-program c) n tolerance))
    (define-values (sampled doubtful) (samplers (compiled-function-runner c) n tolerance))
    (watched e polynomial noise? sampled doubtful #f 0.0))
  (lambda () (watch (map new-watch events codes) tolerance)))

(define (watch all tolerance)
  (lambda (at)
    (define found
      (for*/list ([w (in-list all)]
                  [found (in-list (crossings-along! w at tolerance))])
        found))
    (if (or (null? found) (null? (cdr found))) found (sort found < #:key crossing-at))))

;; code : flvector flvector -> void
(define (samplers code n tolerance)
  (define point (make-flvector n))
  (define value (make-flvector 1))
  (define (value-at-point)
    (code point value)
    (flvector-ref value 0))
  (define ((sampled at) theta)
    (at theta point)
    (value-at-point))
  (define (doubtful at)
    (define by (uncertainties at n tolerance))
    (lambda (theta)
      (at theta point)
      (vary-point! point by)
      (value-at-point)))
  (values sampled doubtful))

(define (event-code who e state)
  (define value (event-value who e state))
  (define c (compile-function (event-f e) state #:name who #:value value))
  (unless (= (compiled-function-outputs c) 1)
    (check-event-value who e (compiled-function-value-shape c)))
  c)

;; The value of the event's function at the state, #f where it has none.
(define (event-value who e state)
  (define value
    (with-handlers ([exn:fail:mechanics:singular? (lambda (x) #f)]
                    [exn:fail:contract:divide-by-zero? (lambda (x) #f)])
      ((event-f e) (flvector->structure state (state-vector who state)))))
  (when value (check-event-value who e value))
  value)

(define (check-event-value who e x)
  (unless (or (number? x) (other-number? x))
    (complain who "the value of an event's function is a real number\n  event: ~a\n  value: ~a~a"
              (value->text e) (describe-with-value x)
              (cond [(boolean? x) "\n  it passes through zero: (- a b) where (< a b) changes"]
                    [(symbolic? x) symbols-hint]
                    [else ""]))))

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
         (define found (crossings-of w (zeros-along p tolerance)))
         (if (and (pair? found) ((watched-noise? w) at)) '() found)]))

(define (crossings-of w zeros)
  (define e (watched-event w))
  (define direction (event-direction e))
  (for/list ([z (in-list zeros)]
             #:when (or (eq? direction 'both) (eq? direction (zero-kind z))))
    (crossing (zero-at z) e (eq? (zero-kind z) 'touching))))

;; The same where nothing is known of the function: it is looked at in so many places.
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

(define (place k places) (fl/ (->fl k) (->fl places)))

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

;; Where g, which has a value at a and none at b, ceases to have one.
(define (last-value g a b)
  (let loop ([a a] [b b])
    (define middle (fl* 0.5 (fl+ a b)))
    (cond [(fl<= (fl- b a) 1e-12) b]
          [(let ([gm (g middle)]) (fl= gm gm)) (loop middle b)]
          [else (loop a middle)])))

;; From a sign to the other or to zero; from zero to a sign is no crossing.
(define (crosses? ga gb direction)
  (or (and (< ga 0) (>= gb 0) (not (eq? direction 'falling)))
      (and (> ga 0) (<= gb 0) (not (eq? direction 'rising)))))

;; -> a place, or #f if there is a pole instead
(define (zero-between g a ga b gb)
  (define least (flmin (flabs ga) (flabs gb)))
  (define (unless-pole x gx) (and (fl<= (flabs gx) least) x))
  (let loop ([a a] [ga ga] [b b] [gb gb] [count 0])
    (define c (fl- b (fl/ (fl* gb (fl- b a)) (fl- gb ga))))
    (cond [(or (fl= gb 0.0) (fl= c b) (= count 100) (fl<= (flabs (fl- b a)) 1e-15))
           (unless-pole b gb)]
          [else
           (define gc (g c))
           (if (if (fl< gb 0.0) (fl> gc 0.0) (fl< gc 0.0))
               (loop b gb c gc (+ count 1))
               (loop a (fl* 0.5 ga) c gc (+ count 1)))])))
