#lang racket/base
;; An assembler for the part of x86-64 that flonum arithmetic takes.
;;
;; An *assembly* grows by instructions, each a procedure named as the processor's manuals name it.
;; Flonums are in the registers xmm0 to xmm15, given by their numbers; an instruction that ends in
;; -sd works on one, in -pd on two side by side.  Its last operand may be in memory: behind an
;; address in one of the other sixteen registers, or a constant, which is kept behind the code,
;; twice side by side.  The code may be put anywhere: it refers to itself by distances alone.

(provide
 make-assembly assembly->bytes
 ;; operands
 rax rcx rdx rbx rsp rbp rsi rdi r8 r9 r10 r11 r12 r13 r14 r15
 behind memory? (struct-out constant) sign all-but-sign
 ;; flonums
 movsd! movupd! movapd! load-high! store-sd! store-high! store-pd!
 addsd! subsd! mulsd! divsd! sqrtsd! maxsd! ucomisd!
 addpd! subpd! mulpd! divpd! sqrtpd! maxpd!
 andpd! xorpd! unpcklpd!
 ;; addresses, and the way through the code
 mov! mov-number! lea! add! later-add! compare! compare-number! push! pop!
 call-address! call! ret! jump! make-label label-here! label-place subroutine!)

;; code : bytes, of which `size` are written; distances : (where . to) ..., to be filled in, `to`
;; being a label or the number of a constant; constants : value -> its number; subroutines : key ->
;; label; unwritten : (-> void) ..., which write the latest of them
(struct assembly ([code #:mutable] [size #:mutable] [distances #:mutable] constants
                  subroutines [unwritten #:mutable])
  #:authentic)

(define (make-assembly) (assembly (make-bytes 1024) 0 '() (make-hasheqv) (make-hash) '()))

;; ---------------------------------------------------------------------------
;; Operands

(define-values (rax rcx rdx rbx rsp rbp rsi rdi) (values 0 1 2 3 4 5 6 7))
(define-values (r8 r9 r10 r11 r12 r13 r14 r15) (values 8 9 10 11 12 13 14 15))

;; Memory at the address in `base`, plus so many bytes, plus the number in `index` unless that is #f
(struct memory (base index distance) #:authentic)
(define (behind base distance [index #f]) (memory base index distance))

;; A flonum, or a pattern of 64 bits, a natural number.
(struct constant (value) #:authentic)

;; Masks of a flonum's bits: that of the sign, and all others
(define sign (constant (expt 2 63)))
(define all-but-sign (constant (- (expt 2 63) 1)))

(struct label ([place #:mutable]) #:authentic)
(define (make-label) (label #f))
(define (label-here! a l) (set-label-place! l (assembly-size a)))

;; ---------------------------------------------------------------------------
;; Bytes

(define (byte! a b)
  (define k (assembly-size a))
  (define code (assembly-code a))
  (when (= k (bytes-length code))
    (define longer (make-bytes (* 2 k)))
    (bytes-copy! longer 0 code)
    (set-assembly-code! a longer))
  (bytes-set! (assembly-code a) k b)
  (set-assembly-size! a (+ k 1)))

(define (bytes! a . bs) (for ([b (in-list bs)]) (byte! a b)))

;; Writes a whole number in so many bytes, the least first.
(define (number! a x size)
  (for ([k (in-range size)]) (byte! a (bitwise-bit-field x (* 8 k) (* 8 (+ k 1))))))

(define (distance-to! a to)
  (set-assembly-distances! a (cons (cons (assembly-size a) to) (assembly-distances a)))
  (number! a 0 4))

;; An instruction of the registers `reg` and `rm`, the latter perhaps memory: a prefix or #f, then
;; the bits of both that do not fit below (REX), the operation, and the operands (ModRM, SIB).
(define (instruction! a prefix wide? operation reg rm)
  (when prefix (byte! a prefix))
  (define rex (+ (if wide? 8 0)
                 (if (> reg 7) 4 0)
                 (if (and (memory? rm) (> (or (memory-index rm) 0) 7)) 2 0)
                 (if (> (first-register rm) 7) 1 0)))
  (unless (zero? rex) (byte! a (+ #x40 rex)))
  (for ([b (in-list operation)]) (byte! a b))
  (operands! a (bitwise-and reg 7) rm))

(define (first-register rm)
  (cond [(memory? rm) (memory-base rm)]
        [(constant? rm) 0]
        [else rm]))

(define (operands! a reg rm)
  (define (mod-rm! mod low) (byte! a (+ (* 64 mod) (* 8 reg) low)))
  (cond [(memory? rm)
         (define d (memory-distance rm))
         (define near? (<= -128 d 127))
         (define base (bitwise-and (memory-base rm) 7))
         (define mod (if near? 1 2))
         (cond [(or (memory-index rm) (= base rsp))
                (mod-rm! mod 4)
                (byte! a (+ (* 8 (bitwise-and (or (memory-index rm) rsp) 7)) base))]
               [else (mod-rm! mod base)])
         (number! a d (if near? 1 4))]
        [(constant? rm)
         (mod-rm! 0 5)
         (distance-to! a (number-of-constant a (constant-value rm)))]
        [else (mod-rm! 3 (bitwise-and rm 7))]))

(define (number-of-constant a x)
  (define all (assembly-constants a))
  (hash-ref! all x (lambda () (hash-count all))))

;; ---------------------------------------------------------------------------
;; Flonums

(define-syntax-rule (define-flonum-instructions [name prefix operation] ...)
  (begin (define (name a x y) (instruction! a prefix #f '(#x0F operation) x y)) ...))

(define-flonum-instructions
  [movsd! #xF2 #x10] [movupd! #x66 #x10] [movapd! #x66 #x28] [ucomisd! #x66 #x2E]
  [addsd! #xF2 #x58] [subsd! #xF2 #x5C] [mulsd! #xF2 #x59] [divsd! #xF2 #x5E]
  [sqrtsd! #xF2 #x51] [maxsd! #xF2 #x5F]
  [addpd! #x66 #x58] [subpd! #x66 #x5C] [mulpd! #x66 #x59] [divpd! #x66 #x5E]
  [sqrtpd! #x66 #x51] [maxpd! #x66 #x5F]
  [andpd! #x66 #x54] [xorpd! #x66 #x57] [unpcklpd! #x66 #x14])

;; The second of two, from memory and to it
(define (load-high! a x from) (instruction! a #x66 #f '(#x0F #x16) x from))
(define (store-high! a to x) (instruction! a #x66 #f '(#x0F #x17) x to))

(define (store-sd! a to x) (instruction! a #xF2 #f '(#x0F #x11) x to))
(define (store-pd! a to x) (instruction! a #x66 #f '(#x0F #x11) x to))

;; ---------------------------------------------------------------------------
;; Addresses

(define (mov! a to from) (instruction! a #f #t '(#x8B) to from))
(define (lea! a to place) (instruction! a #f #t '(#x8D) to place))

(define (mov-number! a to x)
  (bytes! a (if (> to 7) #x49 #x48) (+ #xB8 (bitwise-and to 7)))
  (number! a x 8))

(define (add! a to x)
  (instruction! a #f #t '(#x81) 0 to)
  (number! a x 4))

;; Adds a number that is not known yet; returns a procedure that sets this number.
(define (later-add! a to)
  (add! a to 0)
  (define end (assembly-size a))
  (lambda (x) (integer->bytes! x (assembly-code a) (- end 4))))

(define (integer->bytes! x code where)
  (bytes-copy! code where (integer->integer-bytes x 4 #t #f)))

(define (push! a r) (instruction! a #f #f '(#xFF) 6 r))
(define (pop! a r) (instruction! a #f #f '(#x8F) 0 r))

;; Of a function of C, by its address; changes rax.
(define (call-address! a address)
  (mov-number! a rax address)
  (instruction! a #f #f '(#xFF) 2 rax))

(define (call! a l)
  (byte! a #xE8)
  (distance-to! a l))

(define (ret! a) (byte! a #xC3))

;; Compares a register with another, or with a number, for a jump.
(define (compare! a r other) (instruction! a #f #t '(#x3B) r other))
(define (compare-number! a r x)
  (instruction! a #f #t '(#x81) 7 r)
  (number! a x 4))

;; Jumps to the label: always, or if the numbers compared last satisfy the condition.  'below and
;; its kin compare flonums (ucomisd!); 'unordered and 'equal both hold if one is not a number.
(define (jump! a condition l)
  (if (eq? condition 'always)
      (byte! a #xE9)
      (bytes! a #x0F (hash-ref jump-codes condition)))
  (distance-to! a l))

(define jump-codes
  (hasheq 'less #x8C 'not-less #x8D 'not-below #x83 'below-or-equal #x86 'equal #x84
          'unordered #x8A 'greater #x8F))

;; The label of a procedure that (write!) writes behind the code, once for a key.
(define (subroutine! a key write!)
  (hash-ref! (assembly-subroutines a) key
             (lambda ()
               (define l (make-label))
               (define (write-it!)
                 (label-here! a l)
                 (write!))
               (set-assembly-unwritten! a (cons write-it! (assembly-unwritten a)))
               l)))

;; A subroutine may ask for others.
(define (write-subroutines! a)
  (define all (assembly-unwritten a))
  (unless (null? all)
    (set-assembly-unwritten! a '())
    (for ([write! (in-list all)]) (write!))
    (write-subroutines! a)))

;; ---------------------------------------------------------------------------
;; The code

(define (assembly->bytes a)
  (write-subroutines! a)
  (define first-constant (* 16 (quotient (+ (assembly-size a) 15) 16)))
  (define all (make-bytes (+ first-constant (* 16 (hash-count (assembly-constants a))))))
  (bytes-copy! all 0 (assembly-code a) 0 (assembly-size a))
  (define (place-of-constant k) (+ first-constant (* 16 k)))
  (for ([d (in-list (assembly-distances a))])
    (define-values (where to) (values (car d) (cdr d)))
    (define place (if (label? to) (label-place to) (place-of-constant to)))
    (integer->bytes! (- place (+ where 4)) all where))
  (for ([(x k) (in-hash (assembly-constants a))])
    (define eight (if (flonum? x) (real->floating-point-bytes x 8 #f)
                      (integer->integer-bytes x 8 #f #f)))
    (bytes-copy! all (place-of-constant k) eight)
    (bytes-copy! all (+ 8 (place-of-constant k)) eight))
  all)
