#lang racket/base
;; A state derivative made ready to be sent to workers, as a task, or, where it has no code, to
;; be followed here by the generic arithmetic.

(require racket/flonum
         "task.rkt"
         "../compile/compile-function.rkt" "../compile/program.rkt"
         "../compile/tangent-program.rkt"
         "../error/failure.rkt"
         "../generic/up-down.rkt"
         "../motion/evolution.rkt" "../motion/method.rkt" "../motion/system.rkt"
         (only-in "../numeric/ode/stepper.rkt" method-asks)
         "../value/shape.rkt" (only-in "../value/structure.rkt" ref structure->list))

(provide make-task generically)

;; example : a state; parameters : list of scalars and tuples of them, an example; collect : state
;; -> value, or #f.  -> task, or #f if the derivative has no code; and the shape of what
;; collect gives, or #f if it is to be applied to the states that come back
(define (make-task who maker example parameters collect end tolerance method)
  (define code (code-of who maker example parameters))
  (define n (shape-length example))
  (define collecting (and code collect (compile-traced collect example #:name who)))
  (define slope (and code (compiled-function-program code)))
  (values (and slope
               (task slope (and (asks-for-jacobian? who method) (by-state slope n))
                     (and collecting (compiled-function-program collecting))
                     n
                     (constant-rate? (compiled-function-value-shape code) #t)
                     end tolerance method))
          (and collecting (compiled-function-value-shape collecting))))

(define (code-of who maker example parameters)
  (define (rates all)
    (define ps (structure->list (ref all 1)))
    ((derivative-for maker ps) (ref all 0)))
  (if (null? parameters)
      (compile-traced (derivative-for maker '()) example #:name who)
      (compile-traced rates (up example (apply up parameters)) #:name who)))

;; Implicit methods do; for others it is not worked out.
(define (asks-for-jacobian? who method) (eq? 'jacobian (method-asks (method-of who method))))

;; The derivatives by the state, as implicit methods take them: one column after the other.
(define (by-state slope n)
  (define J (tangent-program slope))
  (define width (program-inputs slope))
  (program (program-inputs J) (program-instructions J)
           (for*/vector ([j (in-range n)] [i (in-range n)])
             (vector-ref (program-outputs J) (+ (* i width) j)))))

;; (start parameters -> outcome) by the generic arithmetic; example, parameters : for their shapes;
;; what is collected is left to others
(define (generically who maker example parameters collect end tolerance method)
  (define shapes (apply up parameters))
  (lambda (y p)
    (define ps
      (if (null? parameters) '() (structure->list (flvector->structure shapes p))))
    (define state (flvector->structure example y))
    (define advance (apply state-advancer maker ps))
    (define start (start-of maker ps state y))
    (with-handlers ([exn:fail:mechanics?
                     (lambda (e) (outcome #f (exn-message e) #f))])
      (define last (advance state (fl- end start) tolerance #:method method))
      (outcome (list->vector (scalars last)) #f #f))))

;; The time is the first scalar where that goes on at the rate 1.
(define (start-of maker ps state y)
  (define rates ((derivative-for maker ps) state))
  (if (constant-rate? rates #f) (flvector-ref y 0) 0.0))
