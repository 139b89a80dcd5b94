#lang racket/base
;; The sections of a program: parts that are small enough to be compiled.
;;
;; What counts is how long the form of a section is: what it loads, computes and stores.  A
;; system of many unknowns is one instruction with more operands than a section may have;
;; *fillings* store these in its matrix first, so many each.  Where a program has many values,
;; as a Jacobian has, of which most may be the number 0, *deliveries* store them last.

(require racket/list
         "program.rkt")

(provide divide allocate-scratch
         (struct-out section) (struct-out filling) (struct-out delivery)
         entries-of outputs-of operands-read)

;; Racket interprets procedures of more than 10,000 symbols, numbers and ends of lists; and fails
;; where such a one takes a sine.
(define longest-form 8500)

;; How many values are stored by a filling, by a delivery or, beside its own, by a section.
(define most-stored 250)

;; Places from `start` on and before `end`; the outputs are stored by sections, too, or not.
(struct section (start end outputs?) #:authentic)

;; Entries of the system at a place, from one number on and before another.
(struct filling (system from to) #:authentic)

;; Outputs from one number on and before another.
(struct delivery (from to) #:authentic)

(define (divide p)
  (define many? (> (vector-length (program-outputs p)) most-stored))
  (append (divide-instructions p (not many?))
          (if many? (deliveries p) '())))

(define (divide-instructions p outputs?)
  (define end (+ (program-inputs p) (program-length p)))
  (let loop ([start (program-inputs p)])
    (define long? (and (< start end) (long-system? (instruction-at p start))))
    (define next (after-components p (if long? (+ start 1) (end-of-section p start end)) end))
    (append (if long? (fillings p start) '())
            (cons (section start next outputs?) (if (= next end) '() (loop next))))))

;; As far as the form is not too long, and no long system comes.
(define (end-of-section p start end)
  (let loop ([k start] [length 0])
    (cond [(or (= k end) (long-system? (instruction-at p k))) k]
          [else
           (define longer (+ length (length-of-form (instruction-at p k))))
           (if (and (> longer longest-form) (> k start)) k (loop (+ k 1) longer))])))

;; At most, with the operands loaded and the value stored.
(define (length-of-form i)
  (define operands (instruction-operands i))
  (define loads (* 10 (count place? operands)))
  (case (instruction-operation i)
    [(solve) (+ 30 loads (* 6 (length operands)) (* 15 (system-unknowns i)))]
    [(component) 0]                     ; counted with its system
    [(wrapped) (+ 80 loads)]
    [else (+ 13 loads (length operands))]))

(define (long-system? i)
  (and (eq? 'solve (instruction-operation i))
       (> (length (instruction-operands i)) most-stored)))

(define (fillings p k)
  (define entries (length (instruction-operands (instruction-at p k))))
  (for/list ([(from to) (parts-of entries)]) (filling k from to)))

(define (deliveries p)
  (for/list ([(from to) (parts-of (vector-length (program-outputs p)))]) (delivery from to)))

;; Of so many things: where each part begins and ends.
(define (parts-of n)
  (in-parallel (in-range 0 n most-stored)
               (in-sequences (in-range most-stored n most-stored) (in-value n))))

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
    (cond [(filling? s)
           (for ([operand (in-list (entries-of p s))]) (need! operand (filling-system s)))]
          [(delivery? s) (for ([operand (in-list (outputs-of p s))]) (need! operand +inf.0))]
          [else
           (for* ([k (in-range (section-start s) (section-end s))]
                  [operand (in-list (operands-read (instruction-at p k)))])
             (need! operand (section-start s)))]))
  slots)

(define (outputs-of p d)
  (for/list ([o (in-vector (program-outputs p) (delivery-from d) (delivery-to d))]) o))

(define (entries-of p f)
  (define all (instruction-operands (instruction-at p (filling-system f))))
  (take (list-tail all (filling-from f)) (- (filling-to f) (filling-from f))))

;; Those of a long system were read by fillings.
(define (operands-read i) (if (long-system? i) '() (instruction-operands i)))
