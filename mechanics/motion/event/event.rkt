#lang racket/base
;; Events: when something happens along a trajectory.
;;
;; An event is a function of the state that passes through zero when the event happens: the height
;; above the table, the force of a constraint.  An occurrence is an event with its time and state.
;; Zeros are found by event-watch.rkt.

(require "../system/check.rkt"
         "../../algebra/expression/expression.rkt"
         "../../error/complain.rkt" "../../error/failure.rkt" "../../error/hint.rkt"
         "../../error/refusal.rkt"
         "../../generic/define-plain.rkt" "../../generic/describe.rkt"
         "../../generic/function-check.rkt" "../../generic/function.rkt"
         "../../generic/kind.rkt" "../../generic/notation.rkt" "../../generic/value-struct.rkt"
         "../../generic/wrong-argument.rkt"
         "../../value/shape.rkt")

(provide event event? event-f event-name event-direction event-terminal?
         event-value check-event-value raise-undefined
         occurrence occurrence?
         check-events
         (struct-out crossing) (struct-out undefined))

;; f : state -> real; direction : 'rising, 'falling or 'both
(value-struct event (f name direction terminal?)
  #:datum (lambda (e) (list 'event (event-name e)))
  #:notation (lambda (e see) (statement (list 0 "event" (see (event-name e)))))
  #:constructor-name make-event
  #:omit-define-syntaxes)

(define-plain (event f #:name [name (procedure-datum f)]
               #:direction [direction 'both] #:terminal? [terminal? #f])
  (unless (takes-arguments? f 1) (raise-other-function 'event "a function of one state" f))
  (unless (memq direction '(rising falling both))
    (complain-of-argument 'event "'rising, 'falling or 'both" direction))
  (make-event f name direction terminal?))

;; -> list of events
(define (check-events who events)
  (define all (if (list? events) events (list events)))
  (for ([e (in-list all)])
    (check-argument who event? e "events; (event f) makes one of a function of the state"))
  all)

;; An event, its time and the state then; grazing? : did its function only touch zero?
(value-struct occurrence (event time state grazing?)
  #:datum (lambda (o)
            (list 'occurrence (event-name (occurrence-event o)) (occurrence-state o)))
  #:notation (lambda (o see)
               (statement (list 0 "event" (see (event-name (occurrence-event o))) "at"
                                (see (occurrence-state o))))))

(provide-parts occurrence? "an occurrence, one of those that (trajectory-events tr) gives"
  occurrence-event occurrence-time occurrence-state occurrence-grazing?)

;; An event whose function has no real value.
(struct undefined (event) #:authentic)

;; A crossing within a step; event : an event, or undefined; at : a place, from 0 to 1, or a time;
;; grazing? : is zero only touched?
(struct crossing (at event grazing?) #:authentic)

;; so-far : the trajectory up to there
(define (raise-undefined e t state so-far [who 'evolve-trajectory])
  (raise-singular who "the function of an event has no real value" so-far
                  "event" e
                  "time" t
                  "state" state))

;; ---------------------------------------------------------------------------

;; The value of the event's function at the state, #f where it has none.
(define (event-value who e state)
  (if-raised no-value? #f
    (define x ((event-f e) (flvector->structure state (state-vector who state))))
    (check-event-value who e x)
    x))

(define (check-event-value who e x)
  (unless (or (number? x) (other-number? x))
    (complain who "the value of an event's function is a real number\n  event: ~a\n  value: ~a~a"
              (value->text e) (describe-with-value x)
              (cond [(boolean? x) "\n  it passes through zero: (- a b) where (< a b) changes"]
                    [(symbolic? x) symbols-hint]
                    [else ""]))))
