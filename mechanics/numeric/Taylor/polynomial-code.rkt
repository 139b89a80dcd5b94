#lang racket/base
;; Sums of Taylor coefficients in machine code: the state where a step ends, or within it, and its
;; rates; and the sizes of the last coefficients.
;;
;; Sums are those of convolution.rkt, even and odd terms apart, of four rows at a time: each
;; addition waits for the one before, and the processor works on eight meanwhile.

(require racket/list
         "convolution-code.rkt"
         "../machine/assembler.rkt" "../machine/executable.rkt")

(provide write-advance! write-sums! write-sizes!)

;; rows : with where each ends, (row . last)
;; Procedures of the time u and the tape, and
;;
;;     y lost z rest     z + rest = y + lost + Σ c_j u^j, j from 1
;;     out               Σ c_j u^j, j from 0

(define (write-advance! c rows)
  (in-procedure c
    (for-each-polynomial! c rows 1 (lambda (i s) (write-exact-sum! (tape-a c) i s)))))

(define (write-sums! c rows)
  (in-procedure c
    (for-each-polynomial! c rows 0
                          (lambda (i s) (store-sd! (tape-a c) (component rsi i) s)))))

(define-syntax-rule (in-procedure c body ...)
  (let ([a (tape-a c)])
    (push! a rbx)
    (mov! a rbx rdi)
    (movapd! a time 0)
    (movapd! a square 0)
    (mulsd! a square square)
    body ...
    (pop! a rbx)
    (ret! a)))

;; Registers of u and u²
(define-values (time square) (values 8 9))

(define (component base i) (behind base (+ flvector-data (* 8 i))))

;; z + rest = y + d, where nothing is lost (Knuth)
(define (write-exact-sum! a i s)
  (define-values (x z back) (values 10 11 12))
  (mulsd! a s time)
  (addsd! a s (component rdx i))
  (movsd! a x (component rsi i))
  (movapd! a z x)
  (addsd! a z s)
  (store-sd! a (component rcx i) z)
  (movapd! a back z)
  (subsd! a back x)
  (subsd! a z back)
  (subsd! a x z)
  (subsd! a s back)
  (addsd! a x s)
  (store-sd! a (component r8 i) x))

;; ---------------------------------------------------------------------------

;; (end! i s) for the sum in the register s, of row i
(define (for-each-polynomial! c rows first end!)
  (define numbered (for/list ([r (in-list rows)] [i (in-naturals)]) (list i (car r) (cdr r))))
  (for ([alike (in-list (group-by third numbered))])
    (let loop ([rows alike])
      (unless (null? rows)
        (define-values (some rest) (split-at rows (min 4 (length rows))))
        (write-polynomials! c (map second some) first (third (car some)))
        (for ([r (in-list some)] [s (in-naturals)]) (end! (car r) s))
        (loop rest)))))

;; The sum of row k becomes that in register k, its odd terms being in 4 + k.
(define (write-polynomials! c rows first last)
  (define a (tape-a c))
  (define again (make-label))
  (define (times! s factor coefficient)
    (mulsd! a s factor)
    (addsd! a s coefficient))
  (define-syntax-rule (for-each-row (r s odd) body ...)
    (for ([r (in-list rows)] [s (in-naturals)] [odd (in-naturals 4)]) body ...))
  (for-each-row (r s odd)
    (xorpd! a s s)
    (xorpd! a odd odd))
  (mov-number! a rax (* 8 last))
  (when (> last first)
    (label-here! a again)
    (for-each-row (r s odd)
      (times! s square (rising c r))
      (times! odd square (rising c r -1)))
    (add! a rax -16)
    (compare-number! a rax (* 8 first))
    (jump! a 'greater again))
  (for-each-row (r s odd)
    (cond [(even? (- last first))
           (times! s square (rising c r))
           (mulsd! a odd time)
           (addsd! a s odd)]
          [else (times! s time odd)])))

;; ---------------------------------------------------------------------------
;; Sizes

;; Stores in the flvector at the address in `to` the sizes ‖y_k‖ of the coefficients of the last
;; four orders, of which there must be as many, the last one's last: the greatest
;; |y_k| / (1 + |y_0|), not a number where one is not finite
(define (write-sizes! c rows to)
  (define a (tape-a c))
  (define last (- (tape-stride c) 1))
  (define pairs (list (- last 3) (- last 1)))
  (define one (constant 1.0))
  (for ([r (in-range 4)]) (xorpd! a r r))
  (for ([r (in-list rows)])
    (movsd! a 6 (early c r 0))
    (andpd! a 6 all-but-sign)
    (addsd! a 6 one)
    (unpcklpd! a 6 6)
    (for ([k (in-list pairs)] [greatest (in-naturals)] [lost (in-naturals 2)])
      (movupd! a 4 (early c r k))
      (andpd! a 4 all-but-sign)
      (divpd! a 4 6)
      (maxpd! a greatest 4)
      (subpd! a 4 4)
      (addpd! a lost 4)))
  (for ([greatest (in-range 2)])
    (addpd! a greatest (+ 2 greatest))
    (store-pd! a (behind to (+ flvector-data (* 16 greatest))) greatest)))
