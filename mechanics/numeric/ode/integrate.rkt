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
         "../failure.rkt" "step-size.rkt" "stepper.rkt" "vectors.rkt")

(provide integrate integrate-step)

;; f!    : y dy -> void; stores f(y) in dy
;; visit : called after each step with the times before and after it and with a
;;         thunk that makes its interpolant (stepper.rkt); the integration ends
;;         there if it returns #f
;; clock : index of the component of y that is the time, to be kept exact, or #f
;; stuck : called with a time and a copy of the state there if no step is short
;;         enough to go on; it does not return
;; -> the time reached and the state there, an flvector
(define (integrate m f! y0 start end
                   #:tolerance [tolerance 1e-10]
                   #:longest [longest +inf.0]
                   #:limit [limit +inf.0]
                   #:clock [clock #f]
                   #:visit [visit (lambda (from to interpolant) #t)]
                   #:stuck [stuck raise-stuck]
                   #:name [who 'integrate])
  (define s ((method-start m) f! y0))
  (define sign (if (fl< end start) -1.0 1.0))
  (define tolerated (step-tolerance tolerance))
  (define first
    (or (method-step m)
        (flmin longest (first-length m s f! tolerated sign (flabs (fl- end start))))))
  (let loop ([t start] [h first] [count 0])
    (cond
      [(fl= t end) (values t (flvector-copy (stepper-state s)))]
      [(>= count limit) (raise-too-many who limit t s)]
      [else
       (define-values (now next) (take-step m s tolerated t end sign (flmin longest h) stuck))
       (when clock (flvector-set! (stepper-state s) clock now))
       (if (visit t now (stepper-interpolant s))
           (loop now next (+ count 1))
           (values now (flvector-copy (stepper-state s))))])))

;; One step of at most the length |h| in the direction of h.
;; -> the time and the state after it and, with its sign, the length for the next one
(define (integrate-step m f! y0 t h
                        #:tolerance [tolerance 1e-10]
                        #:clock [clock #f]
                        #:stuck [stuck raise-stuck])
  (define s ((method-start m) f! y0))
  (define sign (if (fl< h 0.0) -1.0 1.0))
  (define-values (now next)
    (take-step m s (step-tolerance tolerance) t (fl+ t h) sign
               (or (method-step m) (flabs h)) stuck))
  (when clock (flvector-set! (stepper-state s) clock now))
  (values now (flvector-copy (stepper-state s)) (fl* sign next)))

;; The errors of many steps add up: each may have a tenth of the tolerance, but
;; not less than rounding takes.
(define (step-tolerance tolerance) (flmax 4e-16 (fl* 0.1 tolerance)))

;; -> the time after the step and the length of the next one
(define (take-step m s tolerance t end sign h stuck)
  (define remaining (flabs (fl- end t)))
  (let try ([h h])
    (define last? (fl>= h (fl* (fl- 1.0 1e-7) remaining)))
    (define length (if last? remaining h))
    (define error (fl/ ((stepper-try! s) (fl* sign length)) tolerance))
    (cond
      [(fl<= error 1.0)
       (define now (if last? end (fl+ t (fl* sign length))))
       (define next (if (method-step m) h (next-length m length error)))
       (when (and (fl= now t) (fl<= next length)) ; time stands still
         (stuck t (flvector-copy (stepper-state s))))
       ((stepper-accept! s))
       (values now next)]
      [(or (method-step m) (fl= (fl+ t (fl* 0.125 length)) t))
       (stuck t (flvector-copy (stepper-state s)))]
      [else (try (next-length m length error))])))

;; ---------------------------------------------------------------------------

(define (raise-stuck t y)
  (raise-singular 'integrate "the motion cannot be followed any further" y
                  "time" t
                  "last state" y))

(define (raise-too-many who limit t s)
  (raise-not-convergent who "more steps than allowed" (flvector-copy (stepper-state s)) t
                        "limit" limit))
