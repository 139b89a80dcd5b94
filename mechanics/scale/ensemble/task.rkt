#lang racket/base
;; The task that is performed for each start of an ensemble, as data for other processes.
;;
;; A closure cannot leave its process; the list of instructions that is compiled there can.

(require racket/flonum
         "../../compile/program.rkt")

(provide (struct-out task) (struct-out watch) task->datum datum->task
         (struct-out outcome) (struct-out happened)
         flvector->vector vector->flvector)

;; slope     : program of the rates, of a state of `size` scalars and the parameters
;; jacobian  : program of their derivatives by the state, column by column, or #f
;; collect   : program of what is wanted of the last state, or #f for all of it
;; watches   : of the events that are looked for
;; clock?    : is the first scalar the time?
;; end, tolerance : flonums; method : a symbol
;; program : of an event's function of the state; direction, terminal? : as of the event
(struct watch (program direction terminal?) #:authentic)

(struct task (slope jacobian collect watches size clock? end tolerance method) #:authentic)

(define (task->datum t)
  (list (program->datum (task-slope t))
        (program->datum (task-jacobian t))
        (program->datum (task-collect t))
        (for/list ([w (in-list (task-watches t))])
          (list (program->datum (watch-program w)) (watch-direction w) (watch-terminal? w)))
        (task-size t) (task-clock? t) (task-end t) (task-tolerance t) (task-method t)))

(define (datum->task d)
  (define programs (list (car d) (cadr d) (caddr d)))
  (define watches
    (for/list ([w (in-list (cadddr d))])
      (apply watch (datum->program (car w)) (cdr w))))
  (apply task (append (map datum->program programs) (list watches) (cddddr d))))

(define (program->datum p)
  (and p (list (program-inputs p)
               (for/list ([i (in-vector (program-instructions p))])
                 (cons (instruction-operation i)
                       (map operand->datum (instruction-operands i))))
               (map operand->datum (vector->list (program-outputs p))))))

(define (datum->program d)
  (and d (program (car d)
                  (for/vector ([i (in-list (cadr d))])
                    (cons (car i) (map datum->operand (cdr i))))
                  (list->vector (map datum->operand (caddr d))))))

;; Places are boxed.
(define (operand->datum x) (if (place? x) (box (place-index x)) x))
(define (datum->operand x) (if (box? x) (place (unbox x)) x))

;; The outcome of a start: values is a vector; or, if it failed, #f, with the message and the last
;; good state, a vector or #f.  events : list of `happened`
(struct outcome (values message state events) #:prefab)

;; event : its place in the list of events; state : a vector
(struct happened (event time state grazing?) #:prefab)

;; Messages hold vectors.
(define (flvector->vector v) (for/vector #:length (flvector-length v) ([x (in-flvector v)]) x))
(define (vector->flvector v) (for/flvector #:length (vector-length v) ([x (in-vector v)]) x))
