#lang racket/base
;; Machine code that solves linear systems of flonums, in the order of operations of
;; numeric/linear, so that the solutions are the same to the last bit.
;;
;; A system of n unknowns has its room in memory, flonums one after the other:
;;
;;     x       n          the solution
;;     margin  n          by how much the pivots of a symmetric system are positive
;;     A b     n (n + 1)  row by row
;;     L       n (n + 1)  the triangle of a large symmetric system, row by row
;;
;; Code is for one n, and is given the address of the room in rdi; registers that a function of C
;; may change do.  A symmetric system without a positive margin is left to elimination, which
;; begins with A and b as they were.

(require "assembler.rkt" "instruction-builder.rkt" "straight-instruction.rkt"
         (only-in "../linear-algebra/small-symmetric-system.rkt" [most-unknowns most-in-registers] least-part))

(provide most-unknowns most-in-registers system-room solution-place entry-place
         write-elimination! definite-solution write-margin-tests! write-Cholesky!)

;; For more unknowns the room would be a great part of a small stack.
(define most-unknowns 40)

;; How many flonums the room of an instruction takes.
(define (system-room i)
  (cond [(eq? 'solve (instruction-operation i))
         (define n (system-unknowns i))
         (+ n n (* n (+ n 1) (if (and (symmetric-system? i) (> n most-in-registers)) 2 1)))]
        [else 0]))

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

;; The memory at `to` becomes less by the product of a factor, in register 2, and what is at `x`.
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

;; Subtracts from the row at r9 what clears its column k; register 3 : the inverse pivot.  A factor
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

;; From the last row on; behind it r8 and rcx are.
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
;; Few unknowns of a symmetric system (numeric/linear-algebra/small-symmetric-system.rkt)

;; -> instructions whose inputs are the entries of [A b], the operands of the solution, and those of
;; the margins
(define (definite-solution n)
  (define width (+ n 1))
  (define b (make-builder (* n width)))
  (define entries (build-vector (* n width) place))
  (define (entry i j) (vector-ref entries (+ (* i width) j)))
  (define (entry! i j x) (vector-set! entries (+ (* i width) j) x))
  (define (less! i j x y) (entry! i j (do! b 'subtract (entry i j) (do! b 'multiply x y))))
  (define inverses
    (for/vector #:length n ([k (in-range n)])
      (define inverse (do! b 'divide 1.0 (entry k k)))
      (for ([i (in-range (+ k 1) n)])
        (define factor (do! b 'multiply (entry k i) inverse))
        (for ([j (in-range i width)]) (less! i j factor (entry k j))))
      inverse))
  (for ([k (in-range (- n 1) -1 -1)])
    (for ([j (in-range (+ k 1) n)]) (less! k n (entry k j) (entry j n)))
    (entry! k n (do! b 'multiply (entry k n) (vector-ref inverses k))))
  (define margins
    (for/list ([k (in-range n)])
      (do! b 'subtract (entry k k) (do! b 'multiply least-part (place (* k (+ n 2)))))))
  (values (written b) (for/list ([k (in-range n)]) (entry k n)) margins))

;; Goes to the label unless the entries of the diagonal and the margins are positive.
(define (write-margin-tests! a n label)
  (for* ([k (in-range n)] [place (in-list (list diagonal-place margin-place))])
    (movsd! a 0 (behind rdi (place n k)))
    (unless-positive! a 0 label)))

;; ---------------------------------------------------------------------------
;; Many unknowns of a symmetric system (numeric/linear-algebra/symmetric-system.rkt)

;; r8, rdx : row i of A, and of L; rcx : 8 i; r9 : row j of L; rax : 8 j; r11 : the end of A
(define (write-Cholesky! a n elimination)
  (define-values (width right) (values (row-bytes n) (* 8 n)))
  (define L (behind rdi (+ (entry-place n 0) (* n width))))
  (lea! a r8 (behind rdi (entry-place n 0)))
  (lea! a r11 L)
  (lea! a rdx L)
  (mov-number! a rcx 0)
  (while-below a (r8 r11 width)
    (lea! a r9 L)
    (mov-number! a rax 0)
    (while-below a (rax rcx 8)
      (row-product! a rax)
      (movsd! a 1 (behind r8 0 rax))
      (subsd! a 1 0)
      (mulsd! a 1 (behind r9 0 rax))
      (store-sd! a (behind rdx 0 rax) 1)
      (add! a r9 width))
    (row-product! a rcx)
    (write-diagonal! a elimination)
    (add! a rdx width)
    (add! a rcx 8))
  (solve-by-triangle! a width right L)
  (ret! a))

;; Register 0 becomes the product of the rows at rdx and r9 up to `end`, in four sums.  At `end` the
;; row at r9 is that at rdx, or one above.
(define (row-product! a end)
  (xorpd! a 0 0)
  (xorpd! a 2 2)
  (mov-number! a rsi 0)
  (lea! a r10 (behind end -24))
  (while-below a (rsi r10 32)
    (for ([sums (in-list '(0 2))] [distance (in-list '(0 16))])
      (movupd! a 1 (behind rdx distance rsi))
      (movupd! a 3 (behind r9 distance rsi))
      (mulpd! a 1 3)
      (addpd! a sums 1)))
  (for ([sums (in-list '(0 2))])
    (movapd! a 1 sums)
    (unpckhpd! a 1 1)
    (addsd! a sums 1))
  (addsd! a 0 2)
  (while-below a (rsi end 8)
    (movsd! a 1 (behind rdx 0 rsi))
    (mulsd! a 1 (behind r9 0 rsi))
    (addsd! a 0 1)))

;; 1 / sqrt of what the product in register 0 leaves of the diagonal's entry; or elimination.
(define (write-diagonal! a elimination)
  (movsd! a 1 (behind r8 0 rcx))
  (movapd! a 2 1)
  (subsd! a 2 0)
  (mulsd! a 1 (constant least-part))
  (ucomisd! a 2 1)
  (jump! a 'below-or-equal elimination)
  (ucomisd! a 2 infinity)
  (jump! a 'not-below elimination)
  (sqrtsd! a 2 2)
  (movsd! a 1 one)
  (divsd! a 1 2)
  (store-sd! a (behind rdx 0 rcx) 1))

;; rdx : row i of L; rcx : 8 i; r8 : b_i; r10 : 8 n
(define (solve-by-triangle! a width right L)
  (lea! a rdx L)
  (lea! a r8 (behind rdi (+ (* 2 right) right)))
  (mov-number! a rcx 0)
  (mov-number! a r10 right)
  (while-below a (rcx r10 8)
    (movsd! a 0 (behind r8 0))
    (mov-number! a rax 0)
    (while-below a (rax rcx 8)
      (movsd! a 1 (behind rdx 0 rax))
      (mulsd! a 1 (behind rdi 0 rax))
      (subsd! a 0 1))
    (mulsd! a 0 (behind rdx 0 rcx))
    (store-sd! a (behind rdi 0 rcx) 0)
    (add! a r8 width)
    (add! a rdx width))
  (let ([again (make-label)])
    (label-here! a again)
    (add! a rdx (- width))
    (add! a rcx -8)
    (movsd! a 2 (behind rdi 0 rcx))
    (mulsd! a 2 (behind rdx 0 rcx))
    (store-sd! a (behind rdi 0 rcx) 2)
    (mov-number! a rax 0)
    (while-below a (rax rcx 8) (subtract-product! a (behind rdi 0 rax) (behind rdx 0 rax)))
    (mov-number! a rax 0)
    (compare! a rax rcx)
    (jump! a 'less again)))
