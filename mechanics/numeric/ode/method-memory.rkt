#lang racket/base
;; Where the vectors of a method are while its machine code runs.
;;
;; A procedure receives flvectors, and keeps their addresses in registers that no function of C
;; changes.  One flvector is the *room*.  It holds the error of a step and the divisor of this
;; error; then two pairs of equal numbers, h or a fraction θ of a step, and 1 − θ; then vectors of n
;; components: w, the slopes and the squares of errors.  States, the present slope and the
;; coefficients of an interpolant are flvectors of their own.

(require racket/flonum
         "method-formulas.rkt"
         "../machine/assembler.rkt" "../machine/elements.rkt" "../machine/executable.rkt")

(provide room-length kept-length error-in-room write-procedure-of-vectors! component)

;; The numbers before the vectors of the room, by their indices.
(define-values (error-place divisor-place first-vector) (values 0 1 6))
(define numbers (hasheq 'error error-place 'divisor divisor-place 'h 2 'other 4))

;; The error that the code of a step has stored, or 0 if the divisor is 0
(define (error-in-room room)
  (if (fl= (flvector-ref room divisor-place) 0.0) 0.0 (flvector-ref room error-place)))

(define (room-vectors m)
  (cons 'w (append (explicit-formulas-names m) (map car (mean-formulas m)))))

(define (room-length m n) (+ first-vector (* n (length (room-vectors m)))))
(define (kept-length m n) (* n (length (coefficient-names m))))

;; The memory of the component of index i
(define (component places name i)
  (define v (hash-ref places name))
  (behind (vector-at-base v) (+ (vector-at-distance v) (* 8 i))))

(define own-registers (list rbx rbp r12 r13 r14 r15))

;; Writes a procedure of h, or not, and of flvectors by these names, up to six; (write places),
;; places : name -> where that vector or number is, writes the body, while rsp is a multiple of
;; 16, and register 0 is h twice.
(define (write-procedure-of-vectors! a m n h? names write)
  (for ([r (in-list own-registers)]) (push! a r))
  (add! a rsp -8)
  (for ([_ (in-list names)] [r (in-list own-registers)]
        [given (in-list (list rdi rsi rdx rcx r8 r9))])
    (lea! a r (behind given flvector-data)))
  (define places
    (places-of m n (for/hasheq ([name (in-list names)] [r (in-list own-registers)])
                     (values name (vector-at r 0)))))
  (when h?
    (unpcklpd! a 0 0)
    (store-pd! a (hash-ref places 'h) 0))
  (write places)
  (add! a rsp 8)
  (for ([r (in-list (reverse own-registers))]) (pop! a r))
  (ret! a))

;; given : places of the flvectors -> with those in the room and the coefficients kept
(define (places-of m n given)
  (define (with-vectors places base-name names from)
    (define base (hash-ref given base-name #f))
    (for/fold ([places places]) ([name (in-list (if base names '()))] [k (in-naturals)])
      (hash-set places name (vector-at (vector-at-base base) (* 8 (+ from (* n k)))))))
  (define room? (hash-has-key? given 'room))
  (define with-numbers
    (for/fold ([places given]) ([(name place) (in-hash (if room? numbers (hasheq)))])
      (hash-set places name (component given 'room place))))
  (define in-room (with-vectors with-numbers 'room (room-vectors m) first-vector))
  (with-vectors (if (and (hash-ref given 'slope #f) (not (final-among-stages? m)))
                    (hash-set in-room (explicit-formulas-final m) (hash-ref given 'slope))
                    in-room)
                'kept
                (coefficient-names m) 0))
