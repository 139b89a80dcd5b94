#lang racket/base
;; Where the values of straight machine code are: in registers as far as these go, or on the stack.
;;
;; Values are numbered from 0 on, and it is known beforehand which instructions use one.  A register
;; is free after the last use of its value; where none is free, the value whose next use is
;; farthest moves to the stack (L. A. Belady's rule).  A value on the stack may be in a register as
;; well.  A value is one flonum, or a pair of them side by side.

(require "assembler.rkt")

(provide make-values-at values-at-pairs? location in-register used-after?
         register-for! bind-register! bind-slot! keep-on-stack! forget-registers! used! stack-bytes
         move! store!)

;; a : the assembly that moves are written to; pairs? : are values pairs?
;; uses : vector, value -> the numbers of the instructions that use it, those to come
;; held : vector, register -> value, or #f; registers : value -> register; slots : value -> number
;; on the stack
;; free : numbers on the stack that are free again; size : so many were ever taken
(struct values-at (a pairs? uses held registers slots [free #:mutable] [size #:mutable])
  #:authentic)

;; reserved : so many flonums are on the stack before the values
(define (make-values-at a pairs? uses reserved)
  (values-at a pairs? uses (make-vector 16 #f) (make-hasheqv) (make-hasheqv) '() reserved))

(define (slot-bytes s) (if (values-at-pairs? s) 16 8))
(define (stack-bytes s) (* (slot-bytes s) (values-at-size s)))

(define (in-register s p) (hash-ref (values-at-registers s) p #f))

;; -> a register, or memory; #f for neither
(define (location s p)
  (or (in-register s p)
      (let ([k (hash-ref (values-at-slots s) p #f)]) (and k (slot s k)))))

(define (slot s k) (behind rsp (* (slot-bytes s) k)))

(define (uses-of s p) (vector-ref (values-at-uses s) p))

;; Is it used by instructions after the k-th?
(define (used-after? s p k)
  (for/or ([u (in-list (uses-of s p))]) (> u k)))

;; A value into the register r, from another, a constant or memory, and from r to memory.
(define (move! s r from)
  ((cond [(fixnum? from) movapd!] [(values-at-pairs? s) movupd!] [else movsd!])
   (values-at-a s) r from))

(define (store! s to r) ((if (values-at-pairs? s) store-pd! store-sd!) (values-at-a s) to r))

;; ---------------------------------------------------------------------------
;; Registers

;; -> a register that is free now, none of those in `but`
(define (register-for! s but)
  (define held (values-at-held s))
  (or (for/first ([r (in-range 16)] #:unless (or (vector-ref held r) (memv r but))) r)
      (let ([r (farthest s but)])
        (leave-register! s r)
        r)))

(define (farthest s but)
  (define (next-use r)
    (define uses (uses-of s (vector-ref (values-at-held s) r)))
    (if (null? uses) +inf.0 (car uses)))
  (for/fold ([best #f]) ([r (in-range 16)] #:unless (memv r but))
    (if (or (not best) (> (next-use r) (next-use best))) r best)))

(define (leave-register! s r)
  (define p (vector-ref (values-at-held s) r))
  (unless (null? (uses-of s p)) (to-stack! s p))
  (forget-register! s r))

(define (forget-register! s r)
  (define p (vector-ref (values-at-held s) r))
  (when p (hash-remove! (values-at-registers s) p))
  (vector-set! (values-at-held s) r #f))

(define (bind-register! s p r)
  (forget-register! s r)
  (vector-set! (values-at-held s) r p)
  (hash-set! (values-at-registers s) p r))

;; ---------------------------------------------------------------------------
;; The stack

(define (to-stack! s p)
  (unless (hash-ref (values-at-slots s) p #f)
    (define r (in-register s p))
    (store! s (bind-slot! s p) r)))

;; -> the memory that will hold the value
(define (bind-slot! s p)
  (define free (values-at-free s))
  (define k
    (cond [(pair? free) (set-values-at-free! s (cdr free)) (car free)]
          [else (define k (values-at-size s))
                (set-values-at-size! s (+ k 1))
                k]))
  (hash-set! (values-at-slots s) p k)
  (slot s k))

;; Saves the values used after the k-th instruction, which changes all registers.
(define (keep-on-stack! s k)
  (for ([p (in-vector (values-at-held s))] [r (in-naturals)]
        #:when (and p (used-after? s p k)))
    (leave-register! s r)))

(define (forget-registers! s)
  (for ([r (in-range 16)]) (forget-register! s r)))

;; ---------------------------------------------------------------------------
;; Uses

;; The k-th instruction has used these.
(define (used! s ps k)
  (for ([p (in-list ps)])
    (define left (let after ([uses (uses-of s p)])
                   (if (and (pair? uses) (<= (car uses) k)) (after (cdr uses)) uses)))
    (vector-set! (values-at-uses s) p left)
    (when (null? left) (release! s p))))

(define (release! s p)
  (define r (in-register s p))
  (when r (forget-register! s r))
  (define k (hash-ref (values-at-slots s) p #f))
  (when k
    (hash-remove! (values-at-slots s) p)
    (set-values-at-free! s (cons k (values-at-free s)))))
