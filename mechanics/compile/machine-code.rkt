#lang racket/base
;; A program as machine code: as a whole, or in stretches between what there is none for.
;;
;; Systems of equations and functions beyond those of the library of C are left to the interpreter
;; (interpreter.rkt); the instructions between them are stretches, each a procedure of the flvector
;; of all values, from which it takes what was computed before and where it stores what others need.

(require racket/vector
         "program.rkt"
         "../numeric/machine/assembler.rkt" "../numeric/machine/executable.rkt"
         "../numeric/machine/straight-code.rkt")

(provide (protect-out machine-procedure machine-stretches))

;; -> (input output -> void), flvectors that do not overlap; or #f where it is not straight code
;; throughout
(define (machine-procedure p)
  (define instructions (program-instructions p))
  (define (code)
    (define a (make-assembly))
    (lea! a rdi (behind rdi flvector-data))
    (lea! a rsi (behind rsi flvector-data))
    (write-procedure! a (program-inputs p) 0 instructions (program-outputs p))
    (assembly->bytes a))
  (define procedures
    (and (straight-code? instructions)
         (machine-procedures (code) '((0 flvector flvector)))))
  (and procedures (car procedures)))

;; ---------------------------------------------------------------------------
;; Stretches

;; -> place -> (procedure . how many instructions), for the first place of each stretch; or #f where
;; there is none
(define (machine-stretches p)
  (define ranges (if (machine?) (stretches p) '()))
  (define needed (needed-elsewhere p ranges))
  (define a (make-assembly))
  (define entries
    (for/list ([r (in-list ranges)])
      (define where (make-label))
      (label-here! a where)
      (write-stretch! a p (car r) (cdr r) needed)
      (list (label-place where) 'flvector)))
  (define procedures (and (pair? ranges) (machine-procedures (assembly->bytes a) entries)))
  (and procedures
       (for/hasheqv ([r (in-list ranges)] [f (in-list procedures)])
         (values (car r) (cons f (- (cdr r) (car r)))))))

;; -> list of (from . to), places: as long as may be
(define (stretches p)
  (define start (program-inputs p))
  (define end (+ start (program-length p)))
  (define (straight? k) (machine-instruction? (instruction-at p k)))
  (define (end-of-stretch from)
    (define farthest (min end (+ from longest-straight)))
    (or (for/first ([k (in-range from farthest)] #:unless (straight? k)) k)
        farthest))
  (let loop ([k start])
    (cond [(= k end) '()]
          [(straight? k)
           (define next (end-of-stretch k))
           (cons (cons k next) (loop next))]
          [else (loop (+ k 1))])))

;; place -> #t, where it is an output, or computed in a stretch and used outside it
(define (needed-elsewhere p ranges)
  (define needed (make-hasheqv))
  (define (need! o before)
    (when (and (place? o) (< (place-index o) before)) (hash-set! needed (place-index o) #t)))
  (for ([o (in-vector (program-outputs p))]) (need! o +inf.0))
  (define start-of (make-hasheqv))
  (for* ([r (in-list ranges)] [k (in-range (car r) (cdr r))]) (hash-set! start-of k (car r)))
  (for ([i (in-vector (program-instructions p))] [k (in-naturals (program-inputs p))])
    (define before (hash-ref start-of k +inf.0))
    (for ([o (in-list (instruction-operands i))]) (need! o before)))
  needed)

(define (write-stretch! a p from to needed)
  (define inputs (program-inputs p))
  (define (in-memory k) (behind rbx (* 8 k)))
  (push! a rbx)
  (lea! a rbx (behind rdi flvector-data))
  (write-straight-code! a (vector-copy (program-instructions p) (- from inputs) (- to inputs)) from
                        in-memory
                        (for/list ([k (in-range from to)] #:when (hash-ref needed k #f))
                          (cons (place k) (in-memory k))))
  (pop! a rbx)
  (ret! a))
