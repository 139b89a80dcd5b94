#lang racket/base
;; Many motions of one system, on all cores.
;;
;; Starts are taken in batches, in their order, as they are needed (run.rkt).  Results come out in
;; the order of the starts whatever is finished first, so that sums do not depend on chance.

(require racket/future
         (only-in racket/path path-only)
         "ordered.rkt" "perform.rkt" "prepared.rkt" "run.rkt" "start-rows.rkt" "task.rkt"
         "../error/complain.rkt" "../error/failure.rkt" "../error/once.rkt"
         "../generic/define-plain.rkt" "../generic/describe.rkt" "../generic/function.rkt"
         "../generic/value-struct.rkt"
         "../motion/check.rkt" "../motion/choice.rkt" "../motion/event.rkt"
         "../motion/followed.rkt"
         (only-in "../motion/system.rkt" derivative-for)
         "../numeric/progress.rkt"
         "../value/shape.rkt")

(provide evolve-ensemble
         ensemble-failure? ensemble-failure-index ensemble-failure-message ensemble-failure-state)

(define who 'evolve-ensemble)

;; In place of the value of a start that could not be followed to the end.
;; state : the last that was good, or #f
(value-struct ensemble-failure (index message state)
  #:datum (lambda (f) (list 'ensemble-failure (ensemble-failure-index f)
                            (ensemble-failure-message f))))

;; maker : a state derivative, or what makes one of the parameters
;; starts : sequence of states; #:parameters : sequence of lists of them, one for each start
;; -> list of values in the order of the starts; or what #:fold makes of them from #:from on
(define-plain (evolve-ensemble maker starts end
                               #:parameters [parameters #f] #:events [events '()]
                               #:tolerance [tolerance 1e-10] #:method [method 'auto]
                               #:collect [collect #f] #:on-each [on-each void]
                               #:fold [fold #f] #:from [from '()]
                               #:jobs [jobs (processor-count)] #:batch [batch-size 16]
                               #:checkpoint [file #f] #:progress [progress? (report-progress)])
  (check-argument-order maker starts end)
  (check-settings end tolerance method jobs batch-size file)
  (define watched (check-events who events))
  (check-callbacks collect (pair? watched) on-each fold)
  (define rows (start-rows starts parameters))
  (define-values (example ps) (first-row rows))
  (define-values (t perform value-of)
    (prepare maker example ps watched collect (number end) (number tolerance) method))
  (define-values (add! result) (in-order (or fold cons) from on-each value-of))
  (call-with-progress
   progress?
   (lambda (note!)
     (run t (batches rows example ps batch-size note!) perform jobs add! file)))
  (if fold (result) (reverse (result))))

;; -> task or #f, (start parameters -> outcome), (index outcome -> value)
(define (prepare maker example ps events collect end tolerance method)
  (check-maker who maker ps)
  (check-first maker ps example)
  (note-followed maker ps example)
  (define (make how) (how who maker example ps events collect end tolerance method))
  (define-values (t shape) (make make-task))
  (values t
          (if t (performer-here t) (make generically))
          (outcome->value example events collect shape)))

;; Where the derivative has no value at the first start, that start fails like any other.
(define (check-first maker ps example)
  (with-handlers ([no-value? void])
    (check-derivative who (derivative-for maker ps) example)))

(define (number x) (real->double-flonum (real-number x)))

;; Code is made when it is first needed: workers make their own.
(define (performer-here t)
  (define perform (once (lambda () (performer who t))))
  (lambda (y p) ((perform) y p)))

;; ---------------------------------------------------------------------------
;; What comes out

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

(define (happening h events example)
  (occurrence (list-ref events (happened-event h)) (happened-time h)
              (vector->structure example (happened-state h)) (happened-grazing? h)))

;; ---------------------------------------------------------------------------

(define (check-argument-order maker starts end)
  (when (and (procedure? starts) (sequence? maker) (not (procedure? maker)))
    (complain who "the state derivative comes first, then the starts\n  given first: ~a"
              (describe-with-value maker)))
  (when (and (real? starts) (sequence? end) (not (real? end)))
    (complain who "the starts come before the time where they end\n  given second: ~a"
              (describe-with-value starts))))

(define (check-settings end tolerance method jobs batch-size file)
  (check-real who "end" end)
  (check-tolerance who tolerance)
  (check-method who method)
  (unless (symbol? method)
    (complain who "methods are told to other processes by name\n  given: ~a" (value->text method)))
  (for ([x (in-list (list jobs batch-size))] [what (in-list '("#:jobs" "#:batch"))])
    (unless (exact-positive-integer? x)
      (complain who "~a is a positive integer\n  given: ~a" what (value->text x))))
  (unless (or (not file) (path-string? file))
    (complain who "expected the name of a file as checkpoint\n  given: ~a" (value->text file)))
  (when file (check-file-place file)))

(define (check-file-place file)
  (define folder (path-only (path->complete-path file)))
  (unless (directory-exists? folder)
    (complain who "there is no such folder for the checkpoint\n  folder: ~a" folder)))

(define (check-callbacks collect events? on-each fold)
  (if events?
      (check-callback "#:collect" collect 2 "a state and a list of occurrences, with #:events")
      (check-callback "#:collect" collect 1 "a state"))
  (check-callback "#:on-each" on-each 2 "an index and a value")
  (check-callback "#:fold" fold 2 "a value and what was made of those before"))

(define (check-callback what f arguments takes)
  (unless (or (not f) (and (procedure? f) (accepts? f arguments)))
    (complain who "~a is a procedure of ~a\n  given: ~a" what takes (describe-with-value f))))
