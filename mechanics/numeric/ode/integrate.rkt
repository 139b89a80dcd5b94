#lang racket/base
;; Integration of y' = f(y) from one time to another, by any method.
;;
;; An adaptive method tries a step; if its error exceeds the tolerance the step
;; is tried again, shorter.  Other methods take steps of their own length.  The
;; last step ends where the integration ends, exactly.
;;
;; When no step is short enough, because f is not finite there or changes too
;; fast, the integration fails with the time it has reached and the last state
;; that was good.

(require racket/flonum
         "roundoff-detection.rkt" "step-size.rkt" "stepper.rkt"
         (only-in "../constants.rkt" epsilon rounding) "../flvector.rkt"
         "../../error/failure.rkt")

(provide integrate integrate-step step-tolerance)

;; f!    : y dy -> void; stores f(y) in dy
;; visit : called after each step with the times before and after it and with a
;;         thunk that makes its interpolant (stepper.rkt); the integration ends
;;         there if it returns #f
;; begun : called first, with the flvector that the present state will always be in
;; clock : index of the component of y that is the time, to be kept exact, or #f
;; stuck : called with a time, a copy of the state there and the reason why the
;;         integration cannot go on from there; it does not return.  Reasons:
;;         'no-slope     f is not finite there
;;         'step-fails   a step of the length that the method always takes fails
;;         'step-too-short   the error demands steps too short to change the time, or
;;                       steps are of such a length
;;         'boundary     f is not finite beyond
;;         'too-many-steps   as many were taken as allowed
;;         'lost-digits  rounding in f demands steps that get nowhere (roundoff-detection.rkt)
;; -> the time reached and the state there, an flvector
(define (integrate m f! y0 start end
                   #:tolerance [tolerance 1e-10]
                   #:longest [longest +inf.0]
                   #:limit [limit +inf.0]
                   #:clock [clock #f]
                   #:visit [visit (lambda (from to interpolant) #t)]
                   #:begun [begun void]
                   #:stuck [stuck raise-stuck])
  (define tolerated (step-tolerance tolerance))
  (define s (start-stepper m f! y0 tolerated))
  (begun (stepper-state s))
  (define give-up (giving-up f! s stuck))
  (define sign (if (fl< end start) -1.0 1.0))
  (define first (length-to-begin-with m s f! tolerated longest (fl- end start)))
  (define c (make-crawl))
  (let loop ([t start] [h first] [count 0] [failures 0])
    (cond
      [(fl= t end) (values t (flvector-copy (stepper-state s)))]
      [(>= count limit) (give-up t 'too-many-steps)]
      [(= failures most-failures) (give-up t 'boundary)]
      [else
       (define-values (now next finite?)
         (take-step m s tolerated start t count end sign (flmin longest h) give-up))
       (when clock (flvector-set! (stepper-state s) clock now))
       (define on? (visit t now (stepper-interpolant s)))
       (when (and on? (not (fl= now end)))
         (check-digits m c f! s t now tolerated give-up stuck))
       (if on?
           (loop now next (+ count 1) (if finite? 0 (+ failures 1)))
           (values now (flvector-copy (stepper-state s))))])))

(define (length-to-begin-with m s f! tolerated longest span)
  (define sign (if (fl< span 0.0) -1.0 1.0))
  (cond [(method-step m) => (lambda (h) (flmin longest h))]
        [(stepper-limit s) longest]
        [else (flmin longest (first-length m s f! tolerated sign (flabs span)))]))

(define (check-digits m c f! s t now tolerated give-up stuck)
  (define h (flabs (fl- now t)))
  (define y (stepper-state s))
  (when (and (crawls? c h) (rounding-exceeds? f! y h tolerated))
    (give-up now 'lost-digits))
  (define place (and (follows-f? m) (state-too-coarse c f! now y h tolerated)))
  (when place (stuck (car place) (cdr place) 'lost-digits)))

;; Implicit methods damp rounding errors of stiff systems; those of a fixed step have no
;; tolerance.
(define (follows-f? m) (not (or (method-step m) (eq? 'jacobian (method-asks m)))))

;; One step of at most the length |h| in the direction of h.
;; -> the time and the state after it and, with its sign, the length for the next one
(define (integrate-step m f! y0 t h
                        #:tolerance [tolerance 1e-10]
                        #:clock [clock #f]
                        #:stuck [stuck raise-stuck])
  (define tolerated (step-tolerance tolerance))
  (define s (start-stepper m f! y0 tolerated))
  (define sign (if (fl< h 0.0) -1.0 1.0))
  (define give-up (giving-up f! s stuck))
  (define end (fl+ t h))
  (define-values (now next finite?)
    (take-step m s tolerated t t 0 end sign (or (method-step m) (flabs h)) give-up))
  (when clock (flvector-set! (stepper-state s) clock now))
  (define proposed (if (stepper-limit s) ((stepper-limit s)) next))
  (values now (flvector-copy (stepper-state s)) (fl* sign proposed)))

;; The errors of many steps add up: each may have a tenth of the tolerance, but
;; not less than rounding takes.
(define (step-tolerance tolerance) (flmax rounding (fl* 0.1 tolerance)))

;; Towards a place beyond which f is not finite, steps are taken that cover a part of
;; the rest of the way, after others that failed.  A few tens of them lead to where
;; rounding ends it, unless it is the state that no longer changes, and not the time.
(define most-failures 100)

;; After `count` others from the time `start` on.
;; -> the time after the step, the length of the next one, and whether no step was
;; tried whose error is not finite
(define (take-step m s tolerance start t count end sign h give-up)
  (cond [(method-step m) (take-equal-step s start t count end sign h give-up)]
        [(stepper-limit s) (take-foreseen-step s tolerance t end sign h give-up)]
        [else (take-tried-step m s tolerance t end sign h give-up)]))

;; The time after a step is rounded, and the step is as long as that says: rounding errors of the
;; time, which far from 0 are many times those of a step, would be errors of the state.

;; A step as long as it may be.
(define (take-foreseen-step s tolerance t end sign longest give-up)
  (define limit ((stepper-limit s)))
  (unless (fl> limit 0.0) (give-up t 'boundary))
  (define remaining (flabs (fl- end t)))
  (define h0 (flmin longest limit))
  (let try ([h (if (and (fl= h0 +inf.0) (fl= remaining +inf.0)) (endless-length s t) h0)])
    (define now (if (fl>= h (fl* almost-all remaining)) end (fl+ t (fl* sign h))))
    (when (fl= now t) (give-up t 'step-too-short))
    (define length (fl- now t))
    (define error (fl/ ((stepper-try! s) length) tolerance))
    (cond [(fl<= error 1.0)
           ((stepper-accept! s))
           (values now +inf.0 #t)]
          [(fl= (fl+ t (fl* 0.125 length)) t) (give-up t 'step-too-short)]
          [else (try (fl* 0.5 (flabs length)))])))

(define almost-all (fl- 1.0 1e-7))

;; A motion that is a polynomial, as one at rest, has steps of any length.  Where it has no end
;; either, a step is as long as a component takes to change by its own size.
(define (endless-length s t)
  (define length
    (for/fold ([least +inf.0]) ([y (in-flvector (stepper-state s))]
                                [rate (in-flvector ((stepper-slope s)))])
      (flmin least (fl/ (fl+ 1.0 (flabs y)) (flabs rate)))))
  (if (fl< 0.0 length +inf.0) length (fl+ 1.0 (flabs t))))

(define (take-tried-step m s tolerance t end sign h give-up)
  (define remaining (flabs (fl- end t)))
  (let try ([h h] [finite? #t])
    (define now (if (fl>= h (fl* almost-all remaining)) end (later t (fl* sign h))))
    (define length (flabs (fl- now t)))
    (define error (fl/ ((stepper-try! s) (fl* sign length)) tolerance))
    (define next (proposed m s length error))
    (cond
      [(fl<= error 1.0)
       (when (and (fl= (fl+ t h) t) (fl<= next length)) ; time stands still
         (give-up t 'step-too-short))
       ((stepper-accept! s))
       (values now next finite?)]
      [(fl= (fl+ t (fl* 0.125 length)) t) (give-up t 'step-too-short)]
      [else
       (define same? (fl= now (later t (fl* sign next)))) ; as rounding has it
       (try (if same? (fl* 0.75 length) next) (and finite? (fl< error +inf.0)))])))

;; t + h, or the next number to t if that is t.
(define (later t h)
  (define now (fl+ t h))
  (define least (fl* epsilon (flabs t)))
  (if (fl= now t) (if (fl< h 0.0) (fl- t least) (fl+ t least)) now))

;; A step of a method that takes all of the same length h, after `count` others from the time
;; `start` on.  Here the state decides the time: it is counted, so that rounding errors
;; of it do not add up.
(define (take-equal-step s start t count end sign h give-up)
  (define remaining (fl- (flabs (fl- end start)) (fl* (->fl count) h)))
  (define last? (fl>= h (fl* almost-all remaining)))
  (define now (if last? end (fl+ start (fl* sign (fl* (->fl (+ count 1)) h)))))
  (when (and (fl= now t) (not last?)) (give-up t 'step-too-short)) ; time stands still
  (unless (fl<= ((stepper-try! s) (fl* sign (if last? remaining h))) 1.0) (give-up t 'step-fails))
  ((stepper-accept! s))
  (values now h #t))

(define (proposed m s length error)
  (if (stepper-propose s)
      ((stepper-propose s) length error)
      (next-length m length error)))

;; ---------------------------------------------------------------------------

(define ((giving-up f! s stuck) t why)
  (define y (flvector-copy (stepper-state s)))
  (stuck t y (if (or (eq? why 'too-many-steps) (flvector-finite? (rates-at f! y))) why 'no-slope)))

(define (raise-stuck t y why)
  (if (eq? why 'too-many-steps)
      (raise-not-convergent 'integrate "more steps than allowed" y #f "time" t)
      (raise-singular 'integrate "the motion cannot be followed any further" y
                      "time" t
                      "last state" y
                      "reason" why)))
