#lang racket/base
;; Formulas over vectors as machine code: the same for each component, two components at a time.
;;
;; A *formula* is what Racket code has (numeric/ode/vector-formulas.rkt): a number; a symbol, which stands
;; for one; (at v i), the component of a vector; (fl+ f g), and so with fl-, fl*, fl/ and flmax;
;; (flabs f), (flsqrt f); or (weighted i [f v] ...), the sum of products with components of vectors.
;; A *statement* says what is done with its value:
;;
;;     (store v f)     the component of the vector v becomes it
;;     (local x f)     x stands for it in the statements behind
;;     (total x f)     it is added to the number x, component after component
;;
;; The operations are done in the order written: the values are the same to the last bit.

(require racket/flonum
         "assembler.rkt")

(provide emit-elements! (struct-out vector-at) (struct-out number-in))

;; Where what a symbol stands for is: a vector so many bytes behind the address in a register; a
;; number in a register for flonums, both halves the same.
(struct vector-at (base distance) #:authentic)
(struct number-in (register) #:authentic)

;; Up to so many components are written one pair after the other, not as a loop.
(define most-unrolled 8)

;; n : how many components; places : symbol -> vector-at or number-in
;; Registers for flonums below 8 and rax are changed.
(define (emit-elements! a n places statements)
  (define in-pairs (* 2 (quotient n 2)))
  (define (components! pair? distance index)
    (for/fold ([places places]) ([s (in-list statements)])
      (statement! (context a pair? distance index places) s)))
  (cond [(<= n most-unrolled)
         (for ([i (in-range 0 in-pairs 2)]) (components! #t (* 8 i) #f))]
        [else
         (define again (make-label))
         (mov-number! a rax 0)
         (label-here! a again)
         (components! #t 0 rax)
         (add! a rax 16)
         (while-less! a rax (* 8 in-pairs) again)])
  (when (odd? n) (components! #f (* 8 in-pairs) #f)))

;; pair? : two components or one; distance, index : where the first of them is from the first of all
(struct context (a pair? distance index places) #:authentic)

(define (place-of c name) (hash-ref (context-places c) name))

;; -> the places for the statements behind
(define (statement! c s)
  (define-values (kind name f) (apply values s))
  (define a (context-a c))
  (define places (context-places c))
  (formula! c f 0)
  (case kind
    [(store)
     ((if (context-pair? c) store-pd! store-sd!) a (component c (place-of c name)) 0)
     places]
    [(total)
     (define to (number-in-register (place-of c name)))
     (addsd! a to 0)
     (when (context-pair? c)
       (unpckhpd! a 0 0)
       (addsd! a to 0))
     places]
    [(local)
     (define r (free-register places))
     (movapd! a r 0)
     (hash-set places name (number-in r))]))

(define (free-register places)
  (define taken
    (for/list ([p (in-hash-values places)] #:when (number-in? p)) (number-in-register p)))
  (for/first ([r (in-range 15 7 -1)] #:unless (memv r taken)) r))

(define (component c v)
  (behind (vector-at-base v) (+ (vector-at-distance v) (context-distance c)) (context-index c)))

;; ---------------------------------------------------------------------------
;; A formula: its value in the register r; those above may be changed

(define (formula! c f r)
  (cond [(leaf? f) (load! c (leaf c f) r)]
        [else
         (case (car f)
           [(weighted) (sum! c (cddr f) r)]
           [(flabs) (formula! c (cadr f) r)
                    (andpd! (context-a c) r all-but-sign)]
           [(flsqrt) (formula! c (cadr f) r)
                     ((if (context-pair? c) sqrtpd! sqrtsd!) (context-a c) r r)]
           [else (operation! c (car f) (cadr f) (caddr f) r)])]))

;; A fraction is a number.
(define (leaf? f)
  (or (not (pair? f)) (eq? (car f) 'at) (fraction? f)))

(define (fraction? f) (and (eq? (car f) 'fl/) (andmap real? (cdr f))))

(define (sum! c products r)
  (define (product! p r) (operation! c 'fl* (car p) `(at ,(cadr p) i) r))
  (product! (car products) r)
  (for ([p (in-list (cdr products))])
    (product! p (+ r 1))
    (apply! c 'fl+ r (+ r 1))))

;; Of a sum or product what an instruction cannot take from where it is comes first.
(define (operation! c name f g r)
  (define swapped?
    (and (memq name '(fl+ fl*))
         (if (leaf? g) (and (operand c f) (not (operand c g))) (leaf? f))))
  (define-values (one other) (if swapped? (values g f) (values f g)))
  (formula! c one r)
  (define there (operand c other))
  (unless there (formula! c other (+ r 1)))
  (apply! c name r (or there (+ r 1))))

(define (apply! c name r operand)
  (define-values (one two)
    (case name
      [(fl+) (values addsd! addpd!)]
      [(fl-) (values subsd! subpd!)]
      [(fl*) (values mulsd! mulpd!)]
      [(fl/) (values divsd! divpd!)]
      [(flmax) (values maxsd! maxpd!)]))
  ((if (context-pair? c) two one) (context-a c) r operand))

(define (leaf c f)
  (cond [(real? f) (constant (real->double-flonum f))]
        [(and (pair? f) (fraction? f)) (constant (apply fl/ (cdr f)))]
        [(pair? f) (component c (place-of c (cadr f)))]
        [else (number-in-register (place-of c f))]))

;; What an instruction takes as its second operand, or #f: two components side by side in memory it
;; takes only where their address is a multiple of 16.
(define (operand c f)
  (and (leaf? f)
       (not (and (context-pair? c) (pair? f) (not (fraction? f))))
       (leaf c f)))

(define (load! c l r)
  (define a (context-a c))
  (cond [(fixnum? l) (movapd! a r l)]
        [(not (context-pair? c)) (movsd! a r l)]
        [(constant? l) (movapd! a r l)]
        [else (movsd! a r l)
              (movhpd! a r (eight-behind l))]))
