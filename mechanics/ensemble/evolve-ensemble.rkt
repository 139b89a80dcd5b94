#lang racket/base
;; Many motions of one system, on all cores.
;;
;; Starts are taken in batches, in their order, as they are needed; batches are done by workers
;; (crew.rkt), or here where there is but one job or the system has no code.  Results come out in
;; the order of the starts whatever is finished first, so that sums do not depend on chance.

(require racket/future
         (only-in racket/path path-only)
         "batch.rkt" "checkpoint.rkt" "crew.rkt" "ordered.rkt" "perform.rkt" "prepared.rkt"
         "start-rows.rkt" "task.rkt"
         "../error/complain.rkt" "../error/failure.rkt" "../error/once.rkt"
         "../generic/define-plain.rkt" "../generic/describe.rkt" "../generic/function.rkt"
         "../generic/value-struct.rkt"
         "../motion/check.rkt" "../motion/choice.rkt" "../motion/followed.rkt"
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
                               #:parameters [parameters #f]
                               #:tolerance [tolerance 1e-10]
                               #:method [method 'auto]
                               #:collect [collect #f]
                               #:on-each [on-each void]
                               #:fold [fold #f] #:from [from '()]
                               #:jobs [jobs (processor-count)]
                               #:batch [batch-size 16]
                               #:checkpoint [file #f]
                               #:progress [progress? (report-progress)])
  (check-settings end tolerance method jobs batch-size file)
  (check-callbacks collect on-each fold)
  (define rows (start-rows starts parameters))
  (define-values (example ps) (first-row rows))
  (check-maker who maker ps)
  (check-first maker ps example)
  (note-followed maker ps example)
  (define (make how) (how who maker example ps collect (number end) (number tolerance) method))
  (define-values (t shape) (make make-task))
  (define-values (add! result)
    (in-order (or fold cons) from on-each (outcome->value example collect shape)))
  (call-with-progress
   progress?
   (lambda (note!)
     (define next (batches rows example ps batch-size note!))
     (define perform (if t (performer-here t) (make generically)))
     (if file
         (run-kept t file next perform jobs add!)
         (run t next perform jobs add!))))
  (if fold (result) (reverse (result))))

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
;; Running

;; add! : finished -> void; add-unkept! : the same of what is to be tried again another time
(define (run t next perform jobs add! [add-unkept! add!])
  (define first (next))
  (define second (and first (next)))
  (define (next-of-all)
    (cond [first (begin0 first (set! first #f))]
          [second (begin0 second (set! second #f))]
          [else (next)]))
  (if (and t (> jobs 1) second)
      (perform-by-crew t jobs next-of-all add! (lambda (b) (add-unkept! (given-up b))))
      (let loop ()
        (define b (next-of-all))
        (when b
          (add! (perform-batch perform b))
          (loop)))))

(define (given-up b)
  (finished (batch-index b)
            (for/list ([_ (in-list (batch-starts b))])
              (outcome #f "the processes that followed it have died, several times" #f))))

;; The same with a checkpoint: what it has is not done again.
(define (run-kept t file next perform jobs add!)
  (unless t
    (complain who "a checkpoint is for systems that have code; this one does not\n  file: ~a" file))
  (define c (open-checkpoint who file t))
  (define open (make-hasheqv))
  (define (next-undone)
    (define b (next))
    (define done (and b (checkpointed c b)))
    (cond [done (add! done) (next-undone)]
          [else (when b (hash-set! open (batch-index b) b))
                b]))
  (define (add-and-keep! f)
    (keep! c (hash-ref open (finished-index f)) f)
    (hash-remove! open (finished-index f))
    (add! f))
  (dynamic-wind
   void
   (lambda () (run t next-undone perform jobs add-and-keep! add!))
   (lambda () (close-checkpoint c))))

;; ---------------------------------------------------------------------------
;; What comes out

;; -> (index outcome -> value)
(define ((outcome->value example collect shape) index o)
  (define v (outcome-values o))
  (cond [(not v)
         (define last (outcome-state o))
         (ensemble-failure index (outcome-message o) (and last (vector->structure example last)))]
        [shape (vector->structure shape v)]
        [else
         (define state (vector->structure example v))
         (if collect (collect state) state)]))

;; ---------------------------------------------------------------------------

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

(define (check-callbacks collect on-each fold)
  (check-callback "#:collect" collect 1 "a state")
  (check-callback "#:on-each" on-each 2 "an index and a value")
  (check-callback "#:fold" fold 2 "a value and what was made of those before"))

(define (check-callback what f arguments takes)
  (unless (or (not f) (and (procedure? f) (accepts? f arguments)))
    (complain who "~a is a procedure of ~a\n  given: ~a" what takes (describe-with-value f))))
