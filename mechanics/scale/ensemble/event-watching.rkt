#lang racket/base
;; Follows motions and watches for events, whose functions were sent as programs.

(require racket/flonum
         "task.rkt"
         "../../compile/compile-function.rkt"
         "../../motion/event/event.rkt" "../../motion/event/event-watch.rkt"
         "../../motion/trajectory-recording.rkt"
         "../../motion/run-system.rkt" "../../motion/system/system.rkt"
         "../../motion/event/within-step.rkt"
         "../../value/shape.rkt")

(provide watching)

;; -> a function from system, start and end to the last state, an flvector, and the events
(define (watching plan t)
  (define new-watch (watches-for-task t))
  (lambda (s start end)
    (define r (make-recording))
    (define found-in (new-watch))
    (define stopped #f)                 ; the state at a terminal event
    (define (visit from to interpolant)
      (define at (interpolant))
      (define (state-at x) (row-within s at from to x))
      (record-crossings! r (crossings-in-time (found-in at) from to) to
                         (lambda (x) (unless (fl= x to) (set! stopped (state-at x))))
                         #:state state-at
                         #:shown values
                         #:give-up (lambda (e x y)
                                     (raise-undefined e x (system-state s y) #f
                                                      'evolve-ensemble))))
    (define last (run-system plan s start (start-time s start) end visit))
    (values (or stopped (structure->flvector last values))
            (map occurrence->happened (recorded-occurrences r)))))

;; Each event is named by its place in the list.
(define (watches-for-task t)
  (define watches (task-watches t))
  (define events
    (for/list ([w (in-list watches)] [k (in-naturals)])
      (event values #:name k #:direction (watch-direction w) #:terminal? (watch-terminal? w))))
  (define codes
    (for/list ([w (in-list watches)])
      (program->compiled-function (watch-program w) 0 'event)))
  (watches-by-code events codes (task-size t) (task-tolerance t)))

(define (occurrence->happened o)
  (happened (event-name (occurrence-event o)) (occurrence-time o)
            (flvector->vector (occurrence-state o)) (occurrence-grazing? o)))
