#lang racket/base
;; Tapes: a gradient's record of a run of a function.
;;
;; Every intermediate value u of the run has a differential that is a multiple of
;; one other, du = s dz.  An operation on u alone only changes the factor s.
;; Where an operation joins values whose differentials are multiples of different
;; dzᵢ and dzⱼ, a new one is made of them,
;;
;;     dz = a dzᵢ + b dzⱼ,
;;
;; and this line is written on the tape: two indices and two slopes.  Indices
;; below `inputs` stand for the variables, the others number the lines.
;;
;; The derivative of the result by every z, its *adjoint*, then follows in one
;; sweep over the lines, from the last to the first: a z with adjoint z̄ adds a z̄
;; to the adjoint of zᵢ and b z̄ to that of zⱼ.  So all partial derivatives cost no
;; more than the lines there are, however many variables (B. Speelpenning 1980).
;;
;; Lines lie in blocks, each twice as long as the one before up to some length, so
;; that none is ever moved.  Their slopes are flonums, in an flvector, until one comes
;; that is none: an expression, or a number that is itself being differentiated.

(require racket/fixnum
         racket/flonum
         "../generic/arithmetic.rkt" "../generic/kind.rkt")

;; Every index on a tape is one that `join!` gave out, or a variable's.
(#%declare #:unsafe)

(provide make-tape tape? tape-tag tape-inputs
         join! join-flonums! sweep)

;; Who calls `make-tape` owns the tape.
;; inputs : the number of variables.  Of the block being written, `room` is how many
;; lines it has for flonums (none if its slopes are not) and `used` how many are
;; written; `before` counts the variables and the lines of older blocks, of which the
;; last comes first.
;; A tape is the kind of the numbers recorded on it, which so need no field for each.
(struct tape kind (tag inputs
                   [before #:mutable] [room #:mutable] [used #:mutable]
                   [indices #:mutable] [slopes #:mutable] [older #:mutable])
  #:authentic
  #:sealed)

;; before, used : the number of its first line, and how many there are.
;; indices : i and j of a line, packed.
;; slopes : a and b, one after the other, in an flvector or a vector.
(struct block (before used indices slopes)
  #:authentic)

;; Half of a fixnum for each; a tape of 2³⁰ lines would not fit into memory.
(define-syntax-rule (pack i j) (fxior (fxlshift i 30) j))
(define-syntax-rule (first-index p) (fxrshift p 30))
(define-syntax-rule (second-index p) (fxand p #x3FFFFFFF))

;; k, unary, binary : the kind of the recorded numbers, and its methods, called from here
;; without a detour.  A line for each variable but one is the least that a function of
;; all needs.
(define (make-tape k unary binary tag inputs flonums?)
  (define size (fxmin (fx+ inputs 24) longest-block))
  (tape (kind-rank k) (kind-describe k) (kind-datum k) (kind-map k) unary binary
        (kind-comparand k) (kind-zero? k) (kind-same? k) (kind-arity k) (kind-closed? k)
        (kind-component k) (kind-parts k) (kind-notation k) (kind-order k) (kind-judged k)
        tag inputs inputs (if flonums? size 0) 0 (make-fxvector size) (make-slopes size flonums?)
        '()))

;; In lines.
(define longest-block 4096)
(define (for-flonums? b) (flvector? (block-slopes b)))

(define (make-slopes size flonums?)
  (if flonums? (make-flvector (* 2 size)) (make-vector (* 2 size) 0)))

(define (tape-count t) (fx+ (tape-before t) (tape-used t)))

;; ---------------------------------------------------------------------------
;; Writing

;; The index of dz = a dzᵢ + b dzⱼ.
(define (join! t i a j b)
  (define k (tape-used t))
  (define slopes (tape-slopes t))
  (define-values (x y) (values (->flonum a) (->flonum b)))
  (cond [(fx= k (fxvector-length (tape-indices t)))
         (begin-block! t (fxmin (fxmax (fx* 2 k) 16) longest-block) (flvector? slopes))
         (join! t i a j b)]
        [(not (flvector? slopes)) (write-line! t k i j vector-set! slopes a b)]
        [(and (flonum? x) (flonum? y)) (write-line! t k i j flvector-set! slopes x y)]
        [else
         (begin-block! t 16 #f)
         (join! t i a j b)]))

;; The same for flonums, without a call where there is room.
(define-syntax-rule (join-flonums! t i a j b)
  (let ([k (tape-used t)])
    (if (fx< k (tape-room t))
        (let ([slopes (tape-slopes t)]) (write-line! t k i j flvector-set! slopes a b))
        (join! t i a j b))))

;; a as a flonum if it is real.
(define-syntax-rule (->flonum a)
  (cond [(flonum? a) a]
        [(eq? a 1) 1.0]
        [(real? a) (real->double-flonum a)]
        [else a]))

(define-syntax-rule (write-line! t k i j slope-set! slopes a b)
  (let ([at (fxlshift k 1)])
    (slope-set! slopes at a)
    (slope-set! slopes (fx+ at 1) b)
    (fxvector-set! (tape-indices t) k (pack i j))
    (set-tape-used! t (fx+ k 1))
    (fx+ (tape-before t) k)))

(define (begin-block! t size flonums?)
  (set-tape-older! t (written-blocks t))
  (set-tape-before! t (tape-count t))
  (set-tape-room! t (if flonums? size 0))
  (set-tape-used! t 0)
  (set-tape-indices! t (make-fxvector size))
  (set-tape-slopes! t (make-slopes size flonums?)))

;; All blocks, the last one first.
(define (written-blocks t)
  (cons (block (tape-before t) (tape-used t) (tape-indices t) (tape-slopes t)) (tape-older t)))

;; ---------------------------------------------------------------------------
;; Sweeping

;; The derivatives by the variables of a value whose differential is factor · dz, in
;; a new vector: exactly 0 where it does not depend on one.
(define (sweep t index factor)
  (define size (fxmax (tape-inputs t) (fx+ index 1)))
  (define blocks (written-blocks t))
  (if (and (real? factor) (andmap for-flonums? blocks))
      (sweep-flonums t blocks index (real->double-flonum factor) size)
      (sweep-generally t blocks index factor size)))

;; -0.0 stands where nothing was added: it is neutral, and no sum below is -0.0.
;; Places without effect on the result are passed over, be their slopes infinite.
;; (As `eqv?` would, but of a number in a register.)
(define-syntax-rule (untouched? a) (and (fl= a 0.0) (fl< (fl/ 1.0 a) 0.0)))

;; The next line may wait for this sum: it begins with terms known before.
(define-syntax-rule (add-at! as place amount)
  (let ([z place]) (flvector-set! as z (fl+ (fl+ (flvector-ref as z) 0.0) amount))))

(define (sweep-flonums t blocks index factor size)
  (define as (make-flvector size -0.0))
  (flvector-set! as index factor)
  (for ([b (in-list blocks)])
    (define indices (block-indices b))
    (define slopes (block-slopes b))
    (define before (block-before b))
    (let loop ([k (last-line b index)])
      (when (fx>= k 0)
        (let ([a (flvector-ref as (fx+ before k))])
          (unless (untouched? a)
            (let ([line (fxvector-ref indices k)] [at (fxlshift k 1)])
              (add-at! as (first-index line) (fl* a (flvector-ref slopes at)))
              (add-at! as (second-index line) (fl* a (flvector-ref slopes (fx+ at 1)))))))
        (loop (fx- k 1)))))
  (for/vector #:length (tape-inputs t) ([a (in-flvector as 0 (tape-inputs t))])
    (if (untouched? a) 0 a)))

;; The last line of the block up to this index.
(define (last-line b index) (fxmin (fx- (block-used b) 1) (fx- index (block-before b))))

(define (sweep-generally t blocks index factor size)
  (define as (make-vector size 0))
  (define (add! z a slope)
    (vector-set! as z (g:+ (vector-ref as z) (g:* a slope))))
  (vector-set! as index factor)
  (for* ([b (in-list blocks)] [k (in-range (last-line b index) -1 -1)])
    (define a (vector-ref as (fx+ (block-before b) k)))
    (unless (eqv? a 0)
      (define line (fxvector-ref (block-indices b) k))
      (add! (first-index line) a (slope b (* 2 k)))
      (add! (second-index line) a (slope b (add1 (* 2 k))))))
  (define derivatives (make-vector (tape-inputs t)))
  (vector-copy! derivatives 0 as 0 (tape-inputs t))
  derivatives)

(define (slope b at)
  (define slopes (block-slopes b))
  (if (flvector? slopes) (flvector-ref slopes at) (vector-ref slopes at)))
