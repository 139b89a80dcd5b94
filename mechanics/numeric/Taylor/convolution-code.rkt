#lang racket/base
;; Convolutions of Taylor coefficients in machine code, in the order of convolution.rkt.
;;
;; The number of the present order is in r12, in bytes, and in a register for flonums; rbx has the
;; address of the vector of rows.  Within a loop rax rises and rcx falls, so that their sum is the
;; present order; rbp and rdx bound rax.  Rows take the other registers; sums are in the registers
;; for flonums from 0 on.

(require racket/list
         "recurrence.rkt"
         "../machine/assembler.rkt" "../machine/executable.rkt")

(provide (struct-out rows-at) load-rows! unit order
         now before early rising falling
         convolve! convolve-halves! convolve-ending! for-each-term!)

;; Registers of the unit of time, and of the present order
(define-values (unit order) (values 15 14))

;; ---------------------------------------------------------------------------
;; Rows

;; registers : number of a row -> the one that has its address
(struct rows-at (assembly registers) #:authentic)

(define for-rows (list rsi rdi r8 r9 r10 r11 r14 r15))

(define (load-rows! a rows)
  (define indices (remove-duplicates (map row-index rows)))
  (rows-at a
           (for/hasheqv ([i (in-list indices)] [r (in-list for-rows)])
             (mov! a r (behind rbx (+ flvector-data (* 8 i))))
             (values i r))))

(define ((coefficient index) c r [k 0])
  (behind (hash-ref (rows-at-registers c) (row-index r)) (+ flvector-data (* 8 k)) index))

;; The coefficient of the present order, of the one before, and of a given one
(define now (coefficient r12))
(define (before c r) (now c r -1))
(define early (coefficient #f))

;; In a loop: so many orders from where it is
(define rising (coefficient rax))
(define falling (coefficient rcx))

;; ---------------------------------------------------------------------------
;; Sums Σ a_j b_{k−j}, j from `first` to `last`, to k, or to k − 1

(define (convolve! c first as bs #:last [last #f] #:before-end? [before-end? #f])
  (define a (rows-at-assembly c))
  (mov-number! a rax (* 8 first))
  (lea! a rcx (behind r12 (* -8 first)))
  (define end
    (cond [before-end? (lea! a rbp (behind r12 -8)) rbp]
          [last (load-lesser! a rbp last) rbp]
          [else r12]))
  (write-terms! c as bs end))

;; All terms of rows that end
(define (convolve-ending! c x lx y ly)
  (define a (rows-at-assembly c))
  (define not-negative (make-label))
  (lea! a rax (behind r12 (* -8 ly)))
  (compare-number! a rax 0)
  (jump! a 'not-less not-negative)
  (mov-number! a rax 0)
  (label-here! a not-negative)
  (load-lesser! a rcx ly)
  (load-lesser! a rbp lx)
  (write-terms! c (list x) (list y) rbp))

;; The present order or the last one, whichever is less
(define (load-lesser! a r last)
  (define least (make-label))
  (mov-number! a r (* 8 last))
  (compare! a r r12)
  (jump! a 'less least)
  (mov! a r r12)
  (label-here! a least))

(define (write-terms! c as bs end)
  (for ([s (in-range (length as))]) (xorpd! (rows-at-assembly c) s s))
  (if (null? (cdr as))
      (write-one! c (car as) (car bs) end)
      (write-some! c as bs end)))

;; Terms in pairs.
(define (write-some! c as bs end)
  (define a (rows-at-assembly c))
  (define-values (again last-one out) (values (make-label) (make-label) (make-label)))
  (define (for-each-sum add!)
    (for ([x (in-list as)] [y (in-list bs)] [s (in-naturals)]) (add! c s x y 0)))
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

;; Of a sum alone, two: registers 0 and 1
(define (write-one! c x y end)
  (define a (rows-at-assembly c))
  (define-values (again few two none out)
    (values (make-label) (make-label) (make-label) (make-label) (make-label)))
  (define (end-with! add! label)
    (addsd! a 0 1)
    (when add! (add! c 0 x y 0))
    (jump! a 'always out)
    (label-here! a label))
  (xorpd! a 1 1)
  (lea! a rdx (behind end -16))
  (compare! a rax rdx)
  (jump! a 'not-less few)
  (label-here! a again)
  (add-two! c 0 x y 0)
  (add-two! c 1 x y 2)
  (go-on! a 4)
  (compare! a rax rdx)
  (jump! a 'less again)
  (label-here! a few)
  (jump! a 'greater two)
  (add-two! c 0 x y 0)                  ; three are left
  (add-one! c 1 x y 2)
  (end-with! #f two)
  (compare! a rax end)
  (jump! a 'not-less none)
  (add-two! c 0 x y 0)                  ; two are left
  (end-with! #f none)
  (addsd! a 0 1)
  (jump! a 'greater out)
  (add-one! c 0 x y 0)
  (label-here! a out))

(define (go-on! a terms)
  (add! a rax (* 8 terms))
  (add! a rcx (* -8 terms)))

;; Registers from 6 on are for terms.
(define (add-one! c s x y k)
  (term! c 6 x y k)
  (addsd! (rows-at-assembly c) s 6))

(define (add-two! c s x y k)
  (define-values (a t) (values (rows-at-assembly c) (+ 6 (* 2 s))))
  (term! c t x y k)
  (term! c (+ t 1) x y (+ k 1))
  (addsd! a t (+ t 1))
  (addsd! a s t))

(define (term! c t x y k)
  (movsd! (rows-at-assembly c) t (rising c x k))
  (mulsd! (rows-at-assembly c) t (falling c y (- k))))

;; ---------------------------------------------------------------------------
;; Sums Σ a_j a_{k−j}, j from `first` to k − `first`

(define (convolve-halves! c first rows)
  (define a (rows-at-assembly c))
  (define-values (again middle even out)
    (values (make-label) (make-label) (make-label) (make-label)))
  (define (for-each-sum do!) (for ([x (in-list rows)] [s (in-naturals)]) (do! s x)))
  (define (add-square! s x) (add-one! c s x x 0))
  (define (double! s x) (addsd! a s s))
  (for-each-sum (lambda (s x) (xorpd! a s s)))
  (mov-number! a rax (* 8 first))
  (lea! a rcx (behind r12 (* -8 first)))
  (compare! a rax rcx)
  (jump! a 'not-less middle)
  (label-here! a again)
  (for-each-sum add-square!)
  (go-on! a 1)
  (compare! a rax rcx)
  (jump! a 'less again)
  (label-here! a middle)
  (jump! a 'greater even)
  (for-each-sum double!)
  (for-each-sum add-square!)
  (jump! a 'always out)
  (label-here! a even)
  (for-each-sum double!)
  (label-here! a out))

;; Any term, j from `first` to k
(define (for-each-term! c first write-term!)
  (define a (rows-at-assembly c))
  (define again (make-label))
  (mov-number! a rax (* 8 first))
  (lea! a rcx (behind r12 (* -8 first)))
  (label-here! a again)
  (write-term!)
  (go-on! a 1)
  (compare-number! a rcx 0)
  (jump! a 'not-less again))
