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
         "../numeric/linear-algebra/symmetric-system.rkt")

(provide (protect-out program->closure-maker steps->maker system-step))

;; -> (-> (input output -> void)), as program->maker has it
(define (program->closure-maker p)
  (define (steps place-of)
    (for*/list ([k (in-range (program-inputs p) (+ (program-inputs p) (program-length p)))]
                [i (in-value (instruction-at p k))]
                #:unless (eq? 'component (instruction-operation i)))
      (if (eq? 'solve (instruction-operation i))
          (system-step p k place-of)
          (operating (instruction-operation i) k (map place-of (instruction-operands i))))))
  (steps->maker p steps))

;; (steps-of place-of) : operand -> place in the flvector, which then holds it
;; -> list of procedures of that flvector, and of the rooms where systems are solved, by their
;; unknowns; they store the values that later ones or outputs need
(define (steps->maker p steps-of)
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
      (let loop ([k 0])
        (when (unsafe-fx< k inputs)
          (unsafe-flvector-set! v k (unsafe-flvector-ref input k))
          (loop (unsafe-fx+ k 1))))
      (for ([run! (in-vector steps)]) (run! v rooms))
      (let loop ([k 0])
        (when (unsafe-fx< k (unsafe-fxvector-length outputs))
          (unsafe-flvector-set! output k (unsafe-flvector-ref v (unsafe-fxvector-ref outputs k)))
          (loop (unsafe-fx+ k 1)))))))

;; k : the place of the value
(define (operating name k places)
  (define a (car places))
  (define b (if (pair? (cdr places)) (cadr places) a))
  (define-syntax-rule (storing v x) (lambda (v rooms) (unsafe-flvector-set! v k x)))
  (define-syntax-rule (of-both operation)
    (storing v (operation (unsafe-flvector-ref v a) (unsafe-flvector-ref v b))))
  (case name
    [(add) (of-both unsafe-fl+)]
    [(subtract) (of-both unsafe-fl-)]
    [(multiply) (of-both unsafe-fl*)]
    [(divide) (of-both unsafe-fl/)]
    [(negate) (storing v (unsafe-fl* -1.0 (unsafe-flvector-ref v a)))]
    [else
     (define f (flonum-body name (length places)))
     (case (length places)
       [(1) (storing v (f (unsafe-flvector-ref v a)))]
       [(2) (of-both f)]
       [else (storing v (apply f (for/list ([k (in-list places)]) (flvector-ref v k))))])]))

;; ---------------------------------------------------------------------------
;; Systems

(struct room (matrix exchanges right) #:authentic)
(define (list->fxvector xs) (apply fxvector xs))
(define (make-room n) (room (make-flvector (* n n)) (make-fxvector n) (make-flvector n)))

;; The system at the place k, with its components, which follow it.
(define (system-step p k place-of)
  (define i (instruction-at p k))
  (define n (system-unknowns i))
  (define entries (list->fxvector (map place-of (instruction-operands i))))
  (define solve! (if (symmetric-system? i) solve-symmetric! solve-dense!))
  (define components (list->fxvector (components-after p k)))
  (lambda (v rooms)
    (define r (hash-ref rooms n))
    (define-values (A b) (values (room-matrix r) (room-right r)))
    (let row ([i 0] [k 0])
      (when (unsafe-fx< i n)
        (let column ([j 0] [k k])
          (define x (unsafe-flvector-ref v (unsafe-fxvector-ref entries k)))
          (cond [(unsafe-fx< j n)
                 (unsafe-flvector-set! A (unsafe-fx+ (unsafe-fx* i n) j) x)
                 (column (unsafe-fx+ j 1) (unsafe-fx+ k 1))]
                [else
                 (unsafe-flvector-set! b i x)
                 (row (unsafe-fx+ i 1) (unsafe-fx+ k 1))]))))
    (solve! A n (room-exchanges r) b)
    (for ([j (in-fxvector components)] [to (in-naturals (+ k 1))])
      (flvector-set! v to (flvector-ref b j)))))

;; -> list of their indices
(define (components-after p k)
  (for/list ([i (in-vector (program-instructions p) (+ 1 (- k (program-inputs p))))]
             #:break (not (eq? 'component (instruction-operation i))))
    (second-operand i)))
