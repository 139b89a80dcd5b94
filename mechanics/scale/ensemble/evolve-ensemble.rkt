#lang racket/base
;; Many motions of one system, on all cores.
;;
;; Starts are taken in batches, in their order, as they are needed (run-batches.rkt).  Results come
;; out in the order of the starts whatever is finished first, so that sums do not depend on chance.

(require racket/future
         "check-request.rkt" "perform-task.rkt" "prepare-task.rkt"
         "run-batches.rkt" "start-rows.rkt"
         "task.rkt"
         "../../error/complain.rkt" "../../error/failure.rkt" "../../error/computed-once.rkt"
         "../../generic/define-plain.rkt" "../../generic/describe.rkt"
         "../../generic/value-struct.rkt"
         "../../generic/wrong-argument.rkt"
         "../../motion/system/check.rkt" "../../motion/event/event.rkt"
         "../../motion/observed-systems.rkt"
         (only-in "../../motion/system/parametric-system.rkt" derivative-for)
         "../../error/progress.rkt"
         "../../value/shape.rkt")

(provide evolve-ensemble
         ensemble-failure?)

(define who 'evolve-ensemble)

;; The value of a start that could not be followed to the end.  state : the last good one, or #f
(value-struct ensemble-failure (index message state)
  #:datum (lambda (f) (list 'ensemble-failure (ensemble-failure-index f)
                            (ensemble-failure-message f))))

(provide-parts ensemble-failure? "a failure, as evolve-ensemble gives it for a start"
  ensemble-failure-index ensemble-failure-message ensemble-failure-state)

;; maker : a state derivative, or a procedure that makes one of the parameters
;; starts : sequence of states; #:parameters : sequence of lists of them, one for each start
;; -> list of values in the order of the starts; or the result of #:fold on them from #:initial on
(define-plain (evolve-ensemble maker starts end
                               #:parameters [parameters #f] #:events [events '()]
                               #:tolerance [tolerance 1e-10] #:method [method 'auto]
                               #:collect [collect #f] #:observe [observe void]
                               #:fold [fold #f] #:initial [initial (void)]
                               #:jobs [jobs (processor-count)] #:batch [batch-size 16]
                               #:checkpoint [file #f] #:progress? [progress? (report-progress)])
  (check-argument-order maker starts end)
  (check-settings end tolerance method jobs batch-size file)
  (define watched (check-events who events))
  (check-callbacks collect (pair? watched) observe fold initial)
  (define-values (next t perform value-of)
    (prepare maker (start-rows starts parameters) batch-size watched collect
             (number end) (number tolerance) method))
  (define-values (add! result)
    (in-order (if fold (telling-of-values fold) cons) (if fold initial '()) observe value-of))
  (call-with-progress progress?
                      (lambda (note!) (run t (next note!) perform (useful jobs) add! file)))
  (if fold (result) (reverse (result))))

;; More workers would only share the cores, and each needs memory.
(define (useful jobs) (min jobs (* 4 (processor-count))))

;; -> (note! -> (-> batch or #f)), task or #f, (start parameters -> outcome),
;; (index outcome -> value)
(define (prepare maker rows batch-size events collect end tolerance method)
  (define-values (example ps next) (first-row rows))
  (check-maker who maker ps)
  (check-first maker ps example)
  (note-followed maker ps example)
  (define (make how) (how who maker example ps events collect end tolerance method))
  (define-values (t shape) (make make-task))
  (values (lambda (note!) (batches next example ps batch-size note!))
          t
          (if t (performer-here t) (make generically))
          (outcome->value example events collect shape)))

;; A first start at which the derivative has no value fails like any other.
(define (check-first maker ps example)
  (with-handlers ([no-value? void])
    (check-derivative who (derivative-for maker ps) example)))

(define (number x) (real->double-flonum (real-number x)))

;; The code is made when it is first needed; workers make their own.
(define (performer-here t)
  (define perform (once (lambda () (performer who t))))
  (lambda (y p) ((perform) y p)))

;; ---------------------------------------------------------------------------
;; Results

;; Puts batches that are finished in any order into the order of the starts.
;; fold : value result -> result; value-of : index outcome -> value; on-each : index value -> void
;; -> a procedure that adds a finished batch, and one that returns the final result
(define (in-order fold from on-each value-of)
  (define made from)
  (define next 0)
  (define waiting (make-hasheqv))
  (define (take! f)
    (define outcomes (finished-outcomes f))
    (for ([o (in-list outcomes)] [k (in-naturals (finished-index f))])
      (define v (value-of k o))
      (on-each k v)
      (set! made (fold v made)))
    (set! next (+ (finished-index f) (length outcomes))))
  (define (flush!)
    (define f (hash-ref waiting next #f))
    (when f
      (hash-remove! waiting next)
      (take! f)
      (flush!)))
  (values (lambda (f)
            (hash-set! waiting (finished-index f) f)
            (flush!))
          (lambda () made)))

;; -> (index outcome -> value)
(define ((outcome->value example events collect shape) index o)
  (define v (outcome-values o))
  (cond [(not v)
         (define last (outcome-state o))
         (ensemble-failure index (outcome-message o) (and last (vector->structure example last)))]
        [shape (vector->structure shape v)]
        [(pair? events)
         (define all (for/list ([h (in-list (outcome-events o))]) (happening h events example)))
         (if collect (collect (vector->structure example v) all) all)]
        [else
         (define state (vector->structure example v))
         (if collect (collect state) state)]))

;; fold, whose mistakes are told with the value that it was given, if that is none of the states
;; that it may have been written for.
(define ((telling-of-values fold) v made)
  (with-handlers ([exn:fail:contract? (lambda (e) (raise (with-more-said e (of-value v))))])
    (fold v made)))

(define (of-value v)
  (cond [(ensemble-failure? v)
         (format "\n  #:fold was given a motion that failed, ~a\n  ensemble-failure? tells these"
                 (value->text v))]
        [(and (pair? v) (andmap occurrence? v))
         (string-append
          "\n  #:fold was given the list of what happened on a motion, its value with #:events"
          "\n  #:collect makes another value of it: "
          "#:collect (lambda (state occurrences) (length occurrences))")]
        [(list? v) "\n  #:fold was given a list, what #:collect made of a motion"]
        [else ""]))

(define (happening h events example)
  (occurrence (list-ref events (happened-event h)) (happened-time h)
              (vector->structure example (happened-state h)) (happened-grazing? h)))
