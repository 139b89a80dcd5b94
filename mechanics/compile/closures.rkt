#lang racket/base
;; Programs run by closures, at once and everywhere.
;;
;; Code of Racket's compiler (Racket-code.rkt) takes as long to make as several thousand runs
;; of it save (tiers.rkt): too long for a motion of a hundred steps of a big system.  So each
;; instruction becomes a closure, which stores its value in an flvector of all values: inputs,
;; values of instructions, and constants behind them.

(require racket/fixnum
         racket/flonum
         racket/unsafe/ops
         "flonum-functions.rkt" "program.rkt"
         "../numeric/linear-algebra/factored-system.rkt"
         "../numeric/linear-algebra/symmetric-system.rkt"
         "../numeric/unboxed-loop.rkt")

(provide (protect-out program->closure-maker steps->runner-maker system-step))

;; -> (-> (input output -> void)), as program->maker has it
(define (program->closure-maker p)
  (define (steps place-of)
    (for*/list ([k (in-range (program-inputs p) (+ (program-inputs p) (program-length p)))]
                [i (in-value (instruction-at p k))]
                #:unless (eq? 'component (instruction-operation i)))
      (if (eq? 'solve (instruction-operation i))
          (system-step p k place-of)
          (operating (instruction-operation i) k (map place-of (instruction-operands i))))))
  (steps->runner-maker p steps))

;; (steps-of place-of) returns a list of procedures.  Each is given the flvector of all values, and
;; a hash from numbers of unknowns to rooms where such systems are solved; it stores values that
;; later procedures or outputs need.  (place-of operand) is the place of an operand in the flvector.
(define (steps->runner-maker p steps-of)
  (define inputs (program-inputs p))
  (define first-constant (+ inputs (program-length p)))
  (define constants (make-hasheqv))
  (define (place-of x)
    (if (place? x)
        (place-index x)
        (hash-ref! constants (real->double-flonum x)
                   (lambda () (+ first-constant (hash-count constants))))))
  (define steps (list->vector (steps-of place-of)))
  (define outputs
    (for/fxvector #:length (vector-length (program-outputs p)) ([x (in-vector (program-outputs p))])
      (place-of x)))
  (lambda ()
    (define v (make-flvector (+ first-constant (hash-count constants))))
    (for ([(x k) (in-hash constants)]) (flvector-set! v k x))
    (define rooms (for/hasheqv ([n (in-list (system-sizes p))]) (values n (make-room n))))
    (lambda (input output)
      (each (k 0 inputs) (put! v k (at input k)))
      (for ([run! (in-vector steps)]) (run! v rooms))
      (each (k 0 (unsafe-fxvector-length outputs))
        (put! output k (at v (unsafe-fxvector-ref outputs k)))))))

;; k : the place of the value
(define (operating name k places)
  (define a (car places))
  (define b (if (pair? (cdr places)) (cadr places) a))
  (define-syntax-rule (storing v x) (lambda (v rooms) (put! v k x)))
  (define-syntax-rule (of-both operation) (storing v (operation (at v a) (at v b))))
  (case name
    [(add) (of-both unsafe-fl+)]
    [(subtract) (of-both unsafe-fl-)]
    [(multiply) (of-both unsafe-fl*)]
    [(divide) (of-both unsafe-fl/)]
    [(negate) (storing v (unsafe-fl* -1.0 (at v a)))]
    [else
     (define f (flonum-body name (length places)))
     (case (length places)
       [(1) (storing v (f (at v a)))]
       [(2) (of-both f)]
       [else (storing v (apply f (for/list ([p (in-list places)]) (at v p))))])]))

;; ---------------------------------------------------------------------------
;; Systems

(struct room (matrix exchanges right) #:authentic)
(define (make-room n) (room (make-flvector (* n n)) (make-fxvector n) (make-flvector n)))

;; The system at the place k, with its components, which follow it.
(define (system-step p k place-of)
  (define i (instruction-at p k))
  (define n (system-unknowns i))
  (define entries (apply fxvector (map place-of (instruction-operands i))))
  (define solve! (if (symmetric-system? i) solve-symmetric! solve-dense!))
  (define components (apply fxvector (components-after p k)))
  (lambda (v rooms)
    (define r (hash-ref rooms n))
    (define-values (A b) (values (room-matrix r) (room-right r)))
    (define (entry row column)
      (at v (unsafe-fxvector-ref entries (unsafe-fx+ (unsafe-fx* row (unsafe-fx+ n 1)) column))))
    (each (row 0 n)
      (each (column 0 n) (put! A (unsafe-fx+ (unsafe-fx* row n) column) (entry row column)))
      (put! b row (entry row n)))
    (solve! A n (room-exchanges r) b)
    (for ([j (in-fxvector components)] [to (in-naturals (+ k 1))])
      (flvector-set! v to (flvector-ref b j)))))

;; -> list of their indices
(define (components-after p k)
  (for/list ([i (in-vector (program-instructions p) (+ 1 (- k (program-inputs p))))]
             #:break (not (eq? 'component (instruction-operation i))))
    (second-operand i)))
