#lang racket/base
;; The sections of a program: parts that are small enough to be compiled.
;;
;; What counts is what a section loads and stores.  A system of many unknowns is one
;; instruction with more operands than a section may have; *fillings* store these in its
;; matrix first, so many each.

(require racket/list
         "program.rkt")

(provide divide allocate-scratch
         (struct-out section) (struct-out filling)
         instruction-at entries-of operands-read)

(define section-length 250)

(define (instruction-at p k)
  (vector-ref (program-instructions p) (- k (program-inputs p))))

;; Places from `start` on and before `end`.
(struct section (start end) #:authentic)

;; Entries of the system at a place, from one number on and before another.
(struct filling (system from to) #:authentic)

(define (divide p)
  (define end (+ (program-inputs p) (program-length p)))
  (let loop ([start (program-inputs p)])
    (define long (next-long-system p start (min end (+ start section-length))))
    (cond [(eqv? long start)
           (define next (after-components p (+ start 1) end))
           (append (fillings p start)
                   (cons (section start next) (if (= next end) '() (loop next))))]
          [else
           (define next
             (or long (after-components p (min end (+ start section-length)) end)))
           (cons (section start next) (if (= next end) '() (loop next)))])))

;; The first one in [start, end), or #f.
(define (next-long-system p start end)
  (for/first ([k (in-range start end)] #:when (long-system? (instruction-at p k))) k))

(define (long-system? i)
  (and (eq? 'solve (instruction-operation i))
       (> (length (instruction-operands i)) section-length)))

(define (fillings p k)
  (define entries (length (instruction-operands (instruction-at p k))))
  (for/list ([from (in-range 0 entries section-length)])
    (filling k from (min entries (+ from section-length)))))

;; The components of a solution stay with the system.
(define (after-components p k end)
  (if (and (< k end) (eq? (instruction-operation (instruction-at p k)) 'component))
      (after-components p (+ k 1) end)
      k))

;; place index -> place in the scratch vector, for all values that later
;; sections need.
(define (allocate-scratch p sections)
  (define slots (make-hasheqv))
  (define (need! operand before)
    (define i (and (place? operand) (place-index operand)))
    (when (and i (>= i (program-inputs p)) (< i before))
      (hash-ref! slots i (lambda () (hash-count slots)))))
  (for ([s (in-list sections)])
    (if (filling? s)
        (for ([operand (in-list (entries-of p s))]) (need! operand (filling-system s)))
        (for* ([k (in-range (section-start s) (section-end s))]
               [operand (in-list (operands-read (instruction-at p k)))])
          (need! operand (section-start s)))))
  slots)

(define (entries-of p f)
  (define all (instruction-operands (instruction-at p (filling-system f))))
  (take (list-tail all (filling-from f)) (- (filling-to f) (filling-from f))))

;; Those of a long system were read by fillings.
(define (operands-read i) (if (long-system? i) '() (instruction-operands i)))
