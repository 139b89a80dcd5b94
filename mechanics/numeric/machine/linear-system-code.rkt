#lang racket/base
;; Machine code that solves linear systems of flonums, in the order of operations of
;; numeric/linear-algebra, so that the solutions are the same to the last bit.
;;
;; A system of n unknowns has its room in memory, flonums one after the other:
;;
;;     x       n          the solution
;;     margin  n          by how much the pivots of a symmetric system are positive
;;     A b     n (n + 1)  row by row
;;
;; Code is for one n, and is given the address of the room in rdi; registers that a function of C
;; may change do.  A symmetric system without a positive margin is left to elimination, which
;; begins with A and b as they were.

(require "assembler.rkt" "instruction-builder.rkt" "straight-instruction.rkt"
         (only-in "../linear-algebra/small-symmetric-system.rkt" [most-unknowns most-small]
                                                                 least-part))

(provide most-unrolled system-room solution-place entry-place
         write-elimination! definite-solution write-margin-tests! write-Cholesky!)

;; Up to here symmetric systems are solved without loops, which takes three quarters of the time
;; with them; but the code grows as n³, and so does the time to write it.
(define most-unrolled 16)

;; How many flonums the room of an instruction takes.
(define (system-room i)
  (define n (if (eq? 'solve (instruction-operation i)) (system-unknowns i) 0))
  (* n (+ n 3)))

;; Distances in the room, in bytes: of unknown k, of a margin, of entry j of [A b]
(define (solution-place k) (* 8 k))
(define (margin-place n k) (* 8 (+ n k)))
(define (entry-place n j) (* 8 (+ n n j)))
(define (diagonal-place n k) (entry-place n (* k (+ n 2))))

(define (row-bytes n) (* 8 (+ n 1)))
(define infinity (constant +inf.0))
(define one (constant 1.0))

;; ---------------------------------------------------------------------------
;; Loops

;; Runs the body while the register is less than the limit, a register; it grows by `step`.
(define-syntax-rule (while-below a (register limit step) body ...)
  (let ([again (make-label)] [out (make-label)])
    (label-here! a again)
    (compare! a register limit)
    (jump! a 'not-less out)
    body ...
    (add! a register step)
    (jump! a 'always again)
    (label-here! a out)))

;; Goes to the label unless the flonum in the register is positive and finite.  Changes register 7.
(define (unless-positive! a r label)
  (xorpd! a 7 7)
  (ucomisd! a r 7)
  (jump! a 'below-or-equal label)
  (ucomisd! a r infinity)
  (jump! a 'not-below label))

;; The memory at `to` becomes less by the product of a factor, in register 2, and the number at `x`.
(define (subtract-product! a to x)
  (movsd! a 0 x)
  (mulsd! a 0 2)
  (movsd! a 1 to)
  (subsd! a 1 0)
  (store-sd! a to 1))

;; ---------------------------------------------------------------------------
;; Elimination with pivots (numeric/linear-algebra/factored-system.rkt)

;; r8 : row k; rcx : 8 k; r9 : a row below; rax : 8 j; r10 : 8 n; r11 : the end of the rows
(define (write-elimination! a n)
  (define-values (width right fail) (values (row-bytes n) (* 8 n) (make-label)))
  (lea! a r8 (behind rdi (entry-place n 0)))
  (lea! a r11 (behind r8 (* n width)))
  (mov-number! a rcx 0)
  (mov-number! a r10 right)
  (while-below a (r8 r11 width)
    (exchange-pivot! a width)
    (unless-positive! a 0 fail)
    (movsd! a 3 one)
    (divsd! a 3 (behind r8 0 rcx))
    (lea! a r9 (behind r8 width))
    (while-below a (r9 r11 width) (clear-entry! a right))
    (add! a rcx 8))
  (substitute-back! a width right)
  (ret! a)
  (label-here! a fail)
  (movsd! a 0 (constant +nan.0))
  (for ([k (in-range n)]) (store-sd! a (behind rdi (solution-place k)) 0))
  (ret! a))

;; Exchanges row k and the row, from it on, with the greatest entry in column k, whose size is in
;; register 0 then.  rdx : that row
(define (exchange-pivot! a width)
  (define (size! r row)
    (movsd! a r (behind row 0 rcx))
    (andpd! a r all-but-sign))
  (size! 0 r8)
  (lea! a rdx (behind r8 0))
  (lea! a r9 (behind r8 width))
  (while-below a (r9 r11 width)
    (let ([not-greater (make-label)])
      (size! 1 r9)
      (ucomisd! a 1 0)
      (jump! a 'below-or-equal not-greater)
      (movapd! a 0 1)
      (lea! a rdx (behind r9 0))
      (label-here! a not-greater)))
  (mov-number! a rax 0)
  (mov-number! a rsi width)
  (while-below a (rax rsi 8)
    (movsd! a 1 (behind r8 0 rax))
    (movsd! a 2 (behind rdx 0 rax))
    (store-sd! a (behind r8 0 rax) 2)
    (store-sd! a (behind rdx 0 rax) 1)))

;; Clears column k of the row at r9 by subtraction; register 3 : the inverse pivot.  A factor
;; 0 leaves the row as it is, but not its right-hand side.
(define (clear-entry! a right)
  (define-values (clear cleared) (values (make-label) (make-label)))
  (movsd! a 2 (behind r9 0 rcx))
  (mulsd! a 2 3)
  (subtract-product! a (behind r9 right) (behind r8 right))
  (xorpd! a 1 1)
  (ucomisd! a 2 1)
  (jump! a 'unordered clear)
  (jump! a 'equal cleared)
  (label-here! a clear)
  (lea! a rax (behind rcx 8))
  (while-below a (rax r10 8) (subtract-product! a (behind r9 0 rax) (behind r8 0 rax)))
  (label-here! a cleared))

;; Substitutes from the last row up.  At the start r8 and rcx are just behind this row.
(define (substitute-back! a width right)
  (define again (make-label))
  (label-here! a again)
  (add! a r8 (- width))
  (add! a rcx -8)
  (movsd! a 0 (behind r8 right))
  (lea! a rax (behind rcx 8))
  (while-below a (rax r10 8)
    (movsd! a 1 (behind r8 0 rax))
    (mulsd! a 1 (behind rdi 0 rax))
    (subsd! a 0 1))
  (divsd! a 0 (behind r8 0 rcx))
  (store-sd! a (behind rdi 0 rcx) 0)
  (mov-number! a rax 0)
  (compare! a rax rcx)
  (jump! a 'less again))

;; ---------------------------------------------------------------------------
;; Symmetric systems

;; -> instructions whose inputs are the entries of [A b], the operands of the solution, and those of
;; the margins
(define (definite-solution n)
  (define width (+ n 1))
  (define b (make-builder (* n width)))
  (define entries (build-vector (* n width) place))
  (define (entry i j) (vector-ref entries (+ (* i width) j)))
  (define (entry! i j x) (vector-set! entries (+ (* i width) j) x))
  (define (less! i j x y) (entry! i j (do! b 'subtract (entry i j) (do! b 'multiply x y))))
  (define (margin k rest) (do! b 'subtract rest (do! b 'multiply least-part (place (* k (+ n 2))))))
  (define margins
    ((if (<= n most-small) solve-by-rows-above! solve-by-triangle!)
     n entry entry! less! margin (lambda operation (apply do! b operation))))
  (values (written b) (for/list ([k (in-range n)]) (entry k n)) margins))

;; Both procedures leave the solution in column n, and return the margins.
;; Of few unknowns (numeric/linear-algebra/small-symmetric-system.rkt)
(define (solve-by-rows-above! n entry entry! less! margin do)
  (define inverses
    (for/vector #:length n ([k (in-range n)])
      (define inverse (do 'divide 1.0 (entry k k)))
      (for ([i (in-range (+ k 1) n)])
        (define factor (do 'multiply (entry k i) inverse))
        (for ([j (in-range i (+ n 1))]) (less! i j factor (entry k j))))
      inverse))
  (for ([k (in-range (- n 1) -1 -1)])
    (for ([j (in-range (+ k 1) n)]) (less! k n (entry k j) (entry j n)))
    (entry! k n (do 'multiply (entry k n) (vector-ref inverses k))))
  (for/list ([k (in-range n)]) (margin k (entry k k))))

;; Of more (numeric/linear-algebra/symmetric-system.rkt): the lower triangle becomes L, with the
;; inverse entries of its diagonal.
(define (solve-by-triangle! n entry entry! less! margin do)
  (define (plus-product sum i j k) (do 'add sum (do 'multiply (entry i k) (entry j k))))
  (define (row-product i j end)
    (define in-four (* 4 (quotient end 4)))
    (define-values (w x y z)
      (for/fold ([w 0.0] [x 0.0] [y 0.0] [z 0.0]) ([k (in-range 0 in-four 4)])
        (values (plus-product w i j k) (plus-product x i j (+ k 1))
                (plus-product y i j (+ k 2)) (plus-product z i j (+ k 3)))))
    (for/fold ([sum (if (= 0 in-four) 0.0 (do 'add (do 'add w x) (do 'add y z)))])
              ([k (in-range in-four end)])
      (plus-product sum i j k)))
  (define margins
    (for/list ([i (in-range n)])
      (for ([j (in-range i)])
        (define rest (do 'subtract (entry i j) (row-product i j j)))
        (entry! i j (do 'multiply rest (entry j j))))
      (define rest (do 'subtract (entry i i) (row-product i i i)))
      (entry! i i (do 'divide 1.0 (do 'sqrt rest)))
      (margin i rest)))
  (for ([i (in-range n)])
    (for ([j (in-range i)]) (less! i n (entry i j) (entry j n)))
    (entry! i n (do 'multiply (entry i n) (entry i i))))
  (for ([i (in-range (- n 1) -1 -1)])
    (entry! i n (do 'multiply (entry i n) (entry i i)))
    (for ([j (in-range i)]) (less! j n (entry i n) (entry i j))))
  margins)

;; Goes to the label unless the entries of the diagonal and the margins are positive.
(define (write-margin-tests! a n label)
  (for* ([k (in-range n)] [place (in-list (list diagonal-place margin-place))])
    (movsd! a 0 (behind rdi (place n k)))
    (unless-positive! a 0 label)))

;; Of more unknowns, in loops (numeric/linear-algebra/symmetric-system.rkt): the lower triangle
;; becomes L, with the inverse entries of its diagonal, while that of A is kept in the room of
;; margins.  elimination : label of the code that solves the system where A is not positive definite

;; r8 : row i; rcx : 8 i; r9 : row j; rdx : 8 j; rax : 8 k; r10 : 8 n
(define (write-Cholesky! a n elimination)
  (define-values (width right fail) (values (row-bytes n) (* 8 n) (make-label)))
  (define (first-row! r) (lea! a r (behind rdi (entry-place n 0))))
  (first-row! r8)
  (mov-number! a rcx 0)
  (mov-number! a r10 right)
  (while-below a (rcx r10 8)
    (write-row-of-factor! a width right (lambda () (first-row! r9)) fail)
    (add! a r8 width))
  (substitute-by-factor! a width right first-row!)
  (ret! a)
  (label-here! a fail)
  (restore-rows! a width right first-row!)
  (jump! a 'always elimination))

(define (write-row-of-factor! a width right begin-rows! fail)
  (movsd! a 0 (behind r8 0 rcx))
  (store-sd! a (behind rdi right rcx) 0)
  (begin-rows!)
  (mov-number! a rdx 0)
  (while-below a (rdx rcx 8)
    (write-row-product! a)
    (movsd! a 0 (behind r8 0 rdx))
    (subsd! a 0 3)
    (mulsd! a 0 (behind r9 0 rdx))
    (store-sd! a (behind r8 0 rdx) 0)
    (add! a r9 width))
  (write-row-product! a)
  (movsd! a 2 (behind r8 0 rcx))
  (movapd! a 1 2)
  (subsd! a 1 3)
  (mulsd! a 2 (constant least-part))
  (ucomisd! a 1 2)
  (jump! a 'below-or-equal fail)
  (ucomisd! a 1 infinity)
  (jump! a 'not-below fail)
  (sqrtsd! a 1 1)
  (movsd! a 0 one)
  (divsd! a 0 1)
  (store-sd! a (behind r8 0 rcx) 0))

;; Register 3 becomes the product of the entries before rdx of the rows at r8 and r9, in four sums,
;; for one would wait for itself.
(define (write-row-product! a)
  (define (add-product! sum distance)
    (movsd! a 0 (behind r8 distance rax))
    (mulsd! a 0 (behind r9 distance rax))
    (addsd! a sum 0))
  (mov-number! a rax 0)
  (lea! a rsi (behind rdx -24))
  (for ([sum (in-range 3 7)]) (xorpd! a sum sum))
  (while-below a (rax rsi 32)
    (for ([sum (in-range 3 7)] [k (in-naturals)]) (add-product! sum (* 8 k))))
  (addsd! a 3 4)
  (addsd! a 5 6)
  (addsd! a 3 5)
  (while-below a (rax rdx 8) (add-product! 3 0)))

;; L y = b, and then Lᵀ x = y
(define (substitute-by-factor! a width right first-row!)
  (define again (make-label))
  (first-row! r8)
  (mov-number! a rcx 0)
  (while-below a (rcx r10 8)
    (movsd! a 0 (behind r8 right))
    (mov-number! a rax 0)
    (while-below a (rax rcx 8)
      (movsd! a 1 (behind r8 0 rax))
      (mulsd! a 1 (behind rdi 0 rax))
      (subsd! a 0 1))
    (mulsd! a 0 (behind r8 0 rcx))
    (store-sd! a (behind rdi 0 rcx) 0)
    (add! a r8 width))
  (label-here! a again)
  (add! a r8 (- width))
  (add! a rcx -8)
  (movsd! a 2 (behind rdi 0 rcx))
  (mulsd! a 2 (behind r8 0 rcx))
  (store-sd! a (behind rdi 0 rcx) 2)
  (mov-number! a rax 0)
  (while-below a (rax rcx 8) (subtract-product! a (behind rdi 0 rax) (behind r8 0 rax)))
  (mov-number! a rax 0)
  (compare! a rax rcx)
  (jump! a 'less again))

;; A in the rows up to the one at rcx again: its diagonal, and its lower triangle from the upper one
(define (restore-rows! a width right first-row!)
  (first-row! r8)
  (add! a rcx 8)
  (mov-number! a rdx 0)
  (while-below a (rdx rcx 8)
    (movsd! a 0 (behind rdi right rdx))
    (store-sd! a (behind r8 0 rdx) 0)
    (first-row! r9)
    (mov-number! a rax 0)
    (while-below a (rax rdx 8)
      (movsd! a 0 (behind r9 0 rdx))
      (store-sd! a (behind r8 0 rax) 0)
      (add! a r9 width))
    (add! a r8 width)))
