#lang racket/base
;; Programs run by closures, at once and everywhere.
;;
;; What Racket's compiler makes (code.rkt) takes as long to make as some thousand runs of it save:
;; too long for a motion of a hundred steps of a big system.  So each instruction becomes a closure,
;; which stores its value in an flvector of all values: inputs, values of instructions, and
;; constants behind them.

(require racket/fixnum
         racket/flonum
         racket/unsafe/ops
         "flonum-functions.rkt" "program.rkt"
         "../numeric/linear-algebra/factored-system.rkt" "../numeric/linear-algebra/symmetric-system.rkt")

(provide (protect-out program->closure-maker))

;; -> (-> (input output -> void)), as program->maker has it
(define (program->closure-maker p)
  (define inputs (program-inputs p))
  (define first-constant (+ inputs (program-length p)))
  (define constants (make-hasheqv))
  (define (place-of x)
    (if (place? x)
        (place-index x)
        (hash-ref! constants (real->double-flonum x)
                   (lambda () (+ first-constant (hash-count constants))))))
  (define closures
    (for/vector #:length (program-length p) ([k (in-range inputs first-constant)])
      (instruction->closure p k place-of)))
  (define outputs (for/list ([x (in-vector (program-outputs p))]) (place-of x)))
  (lambda ()
    (define v (make-flvector (+ first-constant (hash-count constants))))
    (for ([(x k) (in-hash constants)]) (flvector-set! v k x))
    (define rooms (for/hasheqv ([n (in-list (system-sizes p))]) (values n (make-room n))))
    (lambda (input output)
      (for ([k (in-range inputs)]) (flvector-set! v k (flvector-ref input k)))
      (for ([run! (in-vector closures)]) (run! v rooms))
      (for ([k (in-list outputs)] [i (in-naturals)])
        (flvector-set! output i (flvector-ref v k))))))

;; k : the place of its value
;; -> closure of the values, and of the rooms where systems are solved, by their unknowns
(define (instruction->closure p k place-of)
  (define i (instruction-at p k))
  (define operands (instruction-operands i))
  (case (instruction-operation i)
    [(solve) (solving i (map place-of operands))]
    [(component)
     (define n (system-unknowns (instruction-at p (place-index (car operands)))))
     (define j (cadr operands))
     (lambda (v rooms) (flvector-set! v k (flvector-ref (room-right (hash-ref rooms n)) j)))]
    [else (operating (instruction-operation i) k (map place-of operands))]))

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
(define (make-room n) (room (make-flvector (* n n)) (make-fxvector n) (make-flvector n)))

;; places : those of the rows [A b].  The solution is the room's right-hand side.
(define (solving i places)
  (define n (system-unknowns i))
  (define solve! (if (symmetric-system? i) solve-symmetric! solve-dense!))
  (lambda (v rooms)
    (define r (hash-ref rooms n))
    (define-values (A b) (values (room-matrix r) (room-right r)))
    (let row ([i 0] [places places])
      (when (unsafe-fx< i n)
        (let column ([j 0] [places places])
          (define x (unsafe-flvector-ref v (car places)))
          (cond [(unsafe-fx< j n)
                 (unsafe-flvector-set! A (unsafe-fx+ (unsafe-fx* i n) j) x)
                 (column (unsafe-fx+ j 1) (cdr places))]
                [else
                 (unsafe-flvector-set! b i x)
                 (row (unsafe-fx+ i 1) (cdr places))]))))
    (solve! A n (room-exchanges r) b)))
