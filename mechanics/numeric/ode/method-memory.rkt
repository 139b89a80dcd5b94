#lang racket/base
;; Where the vectors of a method are while its machine code runs.
;;
;; A procedure is given flvectors, whose addresses it keeps in registers of its own.  One of them is
;; the *room*: the error of a step, its divisor and h, then vectors of n components, those of the
;; slopes and w.  The present slope is an flvector of its own, as the states are; and so is what is
;; kept of an interpolant, the vectors of its coefficients.

(require racket/list
         "../machine/assembler.rkt" "../machine/elements.rkt" "../machine/executable.rkt")

(provide (struct-out method-formulas) last-taken? slope-name kept-name
         room-length kept-length
         with-vectors with-length with-room with-coefficients
         component vector-start length-in-room)

;; What method-formulas.rkt has defined: stages of a step, its error, stages of an interpolant and
;; coefficients of its polynomial.  last : the name of the slope at the end of the step; it is that
;; of a stage, or taken when the step is accepted
(struct method-formulas (slopes error further coefficients last) #:authentic)

;; ---------------------------------------------------------------------------
;; Vectors

;; So many numbers are before the vectors of the room.
(define results 3)

(define (room-vectors formulas)
  (remove-duplicates
   (list* 'w 'k0 (append (stage-names (method-formulas-slopes formulas))
                         (stage-names (method-formulas-further formulas))))
   eq?))

(define (stage-names stages) (map car (first stages)))

(define (last-taken? formulas)
  (and (memq (method-formulas-last formulas) (stage-names (method-formulas-slopes formulas))) #t))

;; So many numbers are in the room, and with an interpolant.
(define (room-length formulas n) (+ results (* n (length (room-vectors formulas)))))
(define (kept-length formulas n) (* n (length (method-formulas-coefficients formulas))))

;; What the flvector of the present slope is called: as the last one, if that is no stage.
(define (slope-name formulas)
  (if (last-taken? formulas) 'slope (method-formulas-last formulas)))

;; What a coefficient is called where it is kept.
(define (kept-name c) (string->symbol (format "kept-~a" c)))

;; ---------------------------------------------------------------------------
;; Places: name -> where that vector is

;; given : those that a procedure is given, the room among them
(define (with-room formulas n given)
  (define base (vector-at-base (hash-ref given 'room)))
  (for/fold ([places (hash-set* given 'error (vector-at base 0) 'divisor (vector-at base 8))])
            ([name (in-list (room-vectors formulas))] [k (in-naturals)])
    (hash-set places name (vector-at base (* 8 (+ results (* n k)))))))

;; base : register with the address of what is kept
(define (with-coefficients formulas n places base)
  (for/fold ([places places])
            ([c (in-list (method-formulas-coefficients formulas))] [k (in-naturals)])
    (hash-set places (kept-name (first c)) (vector-at base (* 8 n k)))))

;; The memory of the component of index i
(define (component places name i)
  (define v (hash-ref places name))
  (behind (vector-at-base v) (+ (vector-at-distance v) (* 8 i))))

(define (vector-start places name) (component places name 0))

;; Where straight code finds h
(define (length-in-room places) (component places 'room 2))

;; ---------------------------------------------------------------------------
;; What a procedure is given

(define own-registers (list rbx rbp r12 r13 r14 r15))

;; A procedure of h, perhaps, and of flvectors by these names, up to six; (write places) writes what
;; it does, while h is on the stack twice and rsp a multiple of 16.
(define (with-vectors a names write)
  (for ([r (in-list own-registers)]) (push! a r))
  (add! a rsp -24)
  (unpcklpd! a 0 0)
  (store-pd! a (behind rsp 0) 0)
  (for ([_ (in-list names)] [r (in-list own-registers)]
        [given (in-list (list rdi rsi rdx rcx r8 r9))])
    (lea! a r (behind given flvector-data)))
  (write (for/hasheq ([name (in-list names)] [r (in-list own-registers)])
           (values name (vector-at r 0))))
  (add! a rsp 24)
  (for ([r (in-list (reverse own-registers))]) (pop! a r))
  (ret! a))

;; h in a register.
(define (with-length a places)
  (movupd! a 15 (behind rsp 0))
  (hash-set places 'h (number-in 15)))
