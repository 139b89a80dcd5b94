#lang racket/base
;; Convolutions of Taylor coefficients in machine code, in the order of convolution.rkt.
;;
;; All rows are one behind the other on a *tape*, an flvector whose address is in rbx.  The present
;; order is in r12, in bytes, and in a register for flonums.  Within a loop rax rises and rcx falls,
;; so that their sum is the present order; r13 and r14 bound rax.  Sums are in the registers for
;; flonums from 0 on, the latest of them for terms, so that many are added up in one loop.

(require "recurrence-list.rkt"
         "../machine/assembler.rkt" "../machine/executable.rkt")

(provide (struct-out tape) unit order most-sums factor
         now before early rising
         convolve! convolve-ending! convolve-halves! add-weighted-terms!)

;; a : assembly; stride : how many coefficients a row has; count : how many rows there are
(struct tape (a stride count) #:authentic)

;; A number of a recurrence: numbers are on the tape, behind all rows.
(define (factor c x)
  (if (slot? x)
      (behind rbx (+ flvector-data (* 8 (+ (slot-index x) (* (tape-stride c) (tape-count c))))))
      (constant x)))

;; Registers of the unit of time and of the present order, each twice side by side
(define-values (unit order) (values 15 14))

;; How many registers are for sums; those up to `order` are for terms.
(define most-sums 10)

;; ---------------------------------------------------------------------------
;; Rows

(define ((coefficient index) c r [k 0])
  (behind rbx (+ flvector-data (* 8 (+ k (* (tape-stride c) (row-index r))))) index))

;; The coefficient of the present order, of the one before, and of a given one
(define now (coefficient r12))
(define (before c r) (now c r -1))
(define early (coefficient #f))

;; In a loop: so many orders from where it is
(define rising (coefficient rax))
(define falling (coefficient rcx))

;; ---------------------------------------------------------------------------
;; Sums Σ a_j b_{k−j} of each (a . b), j from `first` to `last`, to k, or to k − 1.  alone? : is
;; each a sum by itself, in two parts?  There are twice as many registers then.

(define (convolve! c first pairs alone? #:last [last #f] #:before-end? [before-end? #f])
  (define a (tape-a c))
  (begin-terms! c first)
  (define end
    (cond [before-end? (lea! a r13 (behind r12 -8)) r13]
          [last (load-lesser! a r13 last) r13]
          [else r12]))
  (write-terms! c pairs alone? end))

(define (begin-terms! c first)
  (mov-number! (tape-a c) rax (* 8 first))
  (lea! (tape-a c) rcx (behind r12 (* -8 first))))

;; All terms of rows that end
(define (convolve-ending! c x lx y ly)
  (define a (tape-a c))
  (define not-negative (make-label))
  (lea! a rax (behind r12 (* -8 ly)))
  (compare-number! a rax 0)
  (jump! a 'not-less not-negative)
  (mov-number! a rax 0)
  (label-here! a not-negative)
  (load-lesser! a rcx ly)
  (load-lesser! a r13 lx)
  (write-terms! c (list (cons x y)) #t r13))

;; The present order or the last one, whichever is less
(define (load-lesser! a r last)
  (define least (make-label))
  (mov-number! a r (* 8 last))
  (compare! a r r12)
  (jump! a 'less least)
  (mov! a r r12)
  (label-here! a least))

(define (write-terms! c pairs alone? end)
  ((if alone? write-in-parts! write-in-pairs!) c pairs end))

(define (clear-sums! a count)
  (for ([s (in-range count)]) (xorpd! a s s)))

;; Terms in pairs.
(define (write-in-pairs! c pairs end)
  (define a (tape-a c))
  (define-values (again last-one out) (values (make-label) (make-label) (make-label)))
  (define (for-each-sum add!) (for ([p (in-list pairs)] [s (in-naturals)]) (add! c s p 0)))
  (clear-sums! a (length pairs))
  (compare! a rax end)
  (jump! a 'not-less last-one)
  (label-here! a again)
  (for-each-sum add-two!)
  (go-on! a 2)
  (compare! a rax end)
  (jump! a 'less again)
  (label-here! a last-one)
  (jump! a 'greater out)
  (for-each-sum add-one!)
  (label-here! a out))

;; A sum alone would wait for each addition: it is two, of which the second is in another register.
(define (write-in-parts! c pairs end)
  (define a (tape-a c))
  (define n (length pairs))
  (define-values (again few) (values (make-label) (make-label)))
  (define (for-each-sum add! k) (for ([p (in-list pairs)] [s (in-naturals)]) (add! c s p k)))
  (define (for-each-part add! k) (for ([p (in-list pairs)] [s (in-naturals n)]) (add! c s p k)))
  (clear-sums! a (* 2 n))
  (lea! a r14 (behind end -16))
  (compare! a rax r14)
  (jump! a 'not-less few)
  (label-here! a again)
  (for-each-sum add-two! 0)
  (for-each-part add-two! 2)
  (go-on! a 4)
  (compare! a rax r14)
  (jump! a 'less again)
  (label-here! a few)
  (write-last-terms! a end for-each-sum for-each-part
                     (lambda () (for ([s (in-range n)]) (addsd! a s (+ n s))))))

;; Up to three terms, and both parts added up; rax has just been compared with r14, 16 less than
;; the end.
(define (write-last-terms! a end for-each-sum for-each-part add-parts!)
  (define-values (two one out) (values (make-label) (make-label) (make-label)))
  (jump! a 'greater two)
  (for-each-sum add-two! 0)
  (for-each-part add-one! 2)
  (add-parts!)
  (jump! a 'always out)
  (label-here! a two)
  (compare! a rax end)
  (jump! a 'not-less one)
  (for-each-sum add-two! 0)
  (add-parts!)
  (jump! a 'always out)
  (label-here! a one)
  (add-parts!)
  (jump! a 'greater out)
  (for-each-sum add-one! 0)
  (label-here! a out))

(define (go-on! a terms)
  (add! a rax (* 8 terms))
  (add! a rcx (* -8 terms)))

(define (add-one! c s p k)
  (define t (term-register s))
  (term! c t p k)
  (addsd! (tape-a c) s t))

(define (add-two! c s p k)
  (define-values (a t) (values (tape-a c) (term-register s)))
  (term! c t p k)
  (term! c (+ t 1) p (+ k 1))
  (addsd! a t (+ t 1))
  (addsd! a s t))

(define (term-register s) (+ most-sums (* 2 (remainder s 2))))

(define (term! c t p k)
  (movsd! (tape-a c) t (rising c (car p) k))
  (mulsd! (tape-a c) t (falling c (cdr p) (- k))))

;; ---------------------------------------------------------------------------
;; Sums Σ a_j a_{k−j} of each row, j from `first` to k − `first`

(define (convolve-halves! c first rows)
  (define a (tape-a c))
  (define-values (again middle even out)
    (values (make-label) (make-label) (make-label) (make-label)))
  (define (add-squares!) (for ([x (in-list rows)] [s (in-naturals)]) (add-one! c s (cons x x) 0)))
  (define (double!) (for ([s (in-range (length rows))]) (addsd! a s s)))
  (clear-sums! a (length rows))
  (begin-terms! c first)
  (compare! a rax rcx)
  (jump! a 'not-less middle)
  (label-here! a again)
  (add-squares!)
  (go-on! a 1)
  (compare! a rax rcx)
  (jump! a 'less again)
  (label-here! a middle)
  (jump! a 'greater even)
  (double!)
  (add-squares!)
  (jump! a 'always out)
  (label-here! a even)
  (double!)
  (label-here! a out))

;; Sums Σ ((n + 1) j − k) a_j b_{k−j} of each (a . b) and n, j from 1 to k; the factors are in
;; registers behind those of the sums.
(define (add-weighted-terms! c pairs ns)
  (define-values (a count) (values (tape-a c) (length pairs)))
  (define again (make-label))
  (define (rise n) (constant (+ n 1.0)))
  (clear-sums! a count)
  (for ([n (in-list ns)] [w (in-naturals count)])
    (movsd! a w (rise n))
    (subsd! a w order))
  (begin-terms! c 1)
  (label-here! a again)
  (for ([p (in-list pairs)] [n (in-list ns)] [s (in-naturals)])
    (define t (term-register s))
    (term! c t p 0)
    (mulsd! a t (+ count s))
    (addsd! a s t)
    (addsd! a (+ count s) (rise n)))
  (go-on! a 1)
  (compare-number! a rcx 0)
  (jump! a 'not-less again))
