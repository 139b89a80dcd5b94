#lang racket/base
;; The task that is performed for each start of an ensemble, batches of starts and their outcomes,
;; as data for other processes; and the messages that carry these.
;;
;; A closure cannot leave its process; the list of instructions that is compiled there can.

(require racket/fasl
         racket/flonum)

(provide (struct-out task) (struct-out watch) (struct-out outcome) failed-outcome
         (struct-out happened)
         flvector->vector
         (struct-out batch) (struct-out finished) (struct-out trouble) perform-batch
         send receive)

;; slope     : program of the rates, of a state of `size` scalars and the parameters
;; collect   : program of the values wanted of the last state, or #f for all of it
;; watches   : of the events that are looked for
;; clock?    : is the first scalar the time?
;; end, tolerance : flonums; method : a symbol
;; program : of an event's function of the state; direction, terminal? : as of the event
(struct watch (program direction terminal?) #:prefab)

(struct task (slope collect watches size clock? end tolerance method) #:prefab)

;; The outcome of a start: values is a vector; or, if it failed, #f, with the message and the last
;; good state, a vector or #f.  events : list of `happened`
(struct outcome (values message state events) #:prefab)
(define (failed-outcome message) (outcome #f message #f '()))

;; event : its place in the list of events; state : a vector
(struct happened (event time state grazing?) #:prefab)

;; Messages hold vectors.
(define (flvector->vector v) (for/vector #:length (flvector-length v) ([x (in-flvector v)]) x))
(define (vector->flvector v) (for/flvector #:length (vector-length v) ([x (in-vector v)]) x))

;; ---------------------------------------------------------------------------
;; Batches

;; index : of its first start; starts, parameters : lists of vectors of flonums
(struct batch (index starts parameters) #:prefab)

;; A worker's report of an error that is no failure of a motion.
(struct trouble (message) #:prefab)

;; outcomes : in the order of the starts
(struct finished (index outcomes) #:prefab)

(define (perform-batch perform b)
  (finished (batch-index b)
            (for/list ([y (in-list (batch-starts b))] [p (in-list (batch-parameters b))])
              (perform (vector->flvector y) (vector->flvector p)))))

(define (send x out)
  (s-exp->fasl x out)
  (flush-output out))

;; -> the next message, or eof where the input ends before it is whole
(define (receive in)
  (with-handlers ([exn:fail? (lambda (e) eof)]) (fasl->s-exp in)))
