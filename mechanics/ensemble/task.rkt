#lang racket/base
;; What is done for each start of an ensemble, as data that another process can be sent.
;;
;; A closure cannot leave its process; the list of instructions that is compiled there can.

(require racket/flonum
         "../compile/program.rkt")

(provide (struct-out task) task->datum datum->task
         (struct-out outcome)
         flvector->vector vector->flvector)

;; slope     : program of the rates, of a state of `size` scalars and the parameters
;; jacobian  : program of their derivatives by the state, column by column, or #f
;; collect   : program of what is wanted of the last state, or #f for all of it
;; clock?    : is the first scalar the time?
;; end, tolerance : flonums; method : a symbol
(struct task (slope jacobian collect size clock? end tolerance method) #:authentic)

(define (task->datum t)
  (list (program->datum (task-slope t))
        (program->datum (task-jacobian t))
        (program->datum (task-collect t))
        (task-size t) (task-clock? t) (task-end t) (task-tolerance t) (task-method t)))

(define (datum->task d)
  (define-values (programs rest) (values (list (car d) (cadr d) (caddr d)) (cdddr d)))
  (apply task (append (map datum->program programs) rest)))

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

;; What came of a start: values, a vector; or, if it failed, #f, with the message and the last
;; state that was good, a vector, if there is one.
(struct outcome (values message state) #:prefab)

;; Messages hold vectors.
(define (flvector->vector v) (for/vector #:length (flvector-length v) ([x (in-flvector v)]) x))
(define (vector->flvector v) (for/flvector #:length (vector-length v) ([x (in-vector v)]) x))
