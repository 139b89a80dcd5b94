#lang racket/base
;; Makes a task of a state derivative, to be sent to workers; a derivative without code is followed
;; here, by the generic arithmetic.

(require (only-in racket/list index-of)
         "task.rkt"
         "../../compile/compile-function.rkt"
         "../../error/failure.rkt"
         "../../generic/up-down.rkt"
         "../../motion/event/event.rkt" "../../motion/evolve-trajectory.rkt"
         "../../motion/system/time-component.rkt" "../../motion/system/parametric-system.rkt"
         "../../motion/trajectory.rkt"
         "../../value/shape.rkt" (only-in "../../value/structure.rkt" ref structure->list))

(provide make-task generically)

;; example : a state; parameters : an example, list of scalars and tuples of them; collect : state
;; -> value, or #f.  Returns the task, or #f if the derivative or an event has no code; and the
;; shape of the value of collect, or #f if collect is to be applied to the final states here.
(define (make-task who maker example parameters events collect end tolerance method)
  (define watches (watches-of who events example))
  (define code (and watches (code-of who maker example parameters)))
  (define n (shape-length example))
  (define collecting
    (and code collect (null? events) (compile-traced collect example #:name who)))
  (define slope (and code (compiled-function-program code)))
  (values (and slope
               (task slope
                     (and collecting (compiled-function-program collecting))
                     watches
                     n
                     (constant-rate? (compiled-function-value-shape code) #t)
                     end tolerance method))
          (and collecting (compiled-function-value-shape collecting))))

;; -> the watches, or #f if the function of an event has no code
(define (watches-of who events example)
  (define codes
    (for/list ([e (in-list events)])
      (event-value who e example)
      (compile-traced (event-f e) example #:name who)))
  (and (andmap values codes)
       (for/list ([c (in-list codes)] [e (in-list events)])
         (watch (compiled-function-program c) (event-direction e) (event-terminal? e)))))

(define (code-of who maker example parameters)
  (define (rates all)
    (define ps (structure->list (ref all 1)))
    ((derivative-for maker ps) (ref all 0)))
  (if (null? parameters)
      (compile-traced (derivative-for maker '()) example #:name who)
      (compile-traced rates (up example (apply up parameters)) #:name who)))

;; -> a function from start and parameters to the outcome, by the generic arithmetic.
;; example, parameters : for their shapes.  collect is not applied.
(define (generically who maker example parameters events collect end tolerance method)
  (define shapes (apply up parameters))
  (lambda (y p)
    (define ps
      (if (null? parameters) '() (structure->list (flvector->structure shapes p))))
    (define state (flvector->structure example y))
    (with-handlers ([exn:fail:mechanics?
                     (lambda (e) (failed-outcome (exn-message e)))])
      (define tr
        (evolve-trajectory (derivative-for maker ps) state end
                           #:events events #:tolerance tolerance #:method method))
      (outcome (row (trajectory-final-state tr)) #f #f
               (for/list ([o (in-list (trajectory-events tr))])
                 (happened (index-of events (occurrence-event o) eq?) (occurrence-time o)
                           (row (occurrence-state o)) (occurrence-grazing? o)))))))

(define (row state) (list->vector (scalars state)))
