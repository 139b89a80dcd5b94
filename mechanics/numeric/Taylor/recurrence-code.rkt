#lang racket/base
;; Recurrences as machine code: one procedure for all coefficients of an expansion.
;;
;; The code of a recurrence is one loop over orders, the convolution, between straight lines; it
;; does the operations of its kernel (kernels.rkt) in the same order, so that the coefficients are
;; the same to the last bit.  Recurrences that do not wait for each other share a loop, for the
;; processor works on several sums at once.  All of it stands in a loop over the orders of the
;; expansion.

(require racket/list
         "recurrence-list.rkt" "recurrence-groups.rkt" "convolution-code.rkt"
         "../machine/assembler.rkt" "../machine/executable.rkt"
         "../machine/instruction-code.rkt")

(provide write-expansion! coded-recurrence? start-found?)

;; Is there code for it, on processors that have any?
(define (coded-recurrence? r)
  (case (recurrence-kind r)
    [(system) #f]
    [(value) (call-with-start r (lambda (name n) (or (eq? name 'sqrt) (C-operation? name n))))]
    [else #t]))

;; Is the function that the row begins with in the library of C of this machine?
(define (start-found? r) (or (not (eq? 'value (recurrence-kind r))) (and (start-function r) #t)))

;; ---------------------------------------------------------------------------
;; The procedure

;; Registers that a function of C keeps: rbx, the tape; rbp, the vector of flvectors; r12, the
;; order; two for loops; the further argument
(define kept (list rbx rbp r12 r13 r14 r15))

;; starts, endless : recurrences; ending : list of (last order . recurrence)
;; inputs, outputs : lists of rows
;; follow? : are the inputs known?  Else they are the solution of y' = f(y), f being the outputs,
;; and (write-end!) writes the end of the code.  ends : to which order inputs are found that end
;; Writes a procedure of the unit h; flvectors, a vector of those of inputs and outputs; the tape of
;; all rows; and a further argument in rdx, which is in r15 at the end.
(define (write-expansion! c inputs outputs starts ending endless ends follow? write-end!)
  (define a (tape-a c))
  (for ([r (in-list kept)]) (push! a r))
  (add! a rsp -24)
  (store-sd! a (behind rsp 0) 0)
  (for ([r (in-list (list rbp rbx r15))] [given (in-list (list rdi rsi rdx))]) (mov! a r given))
  (mov-number! a r12 0)
  (write-taking! c inputs)
  (for ([r (in-list starts)]) (write-group! c (list r)))
  (when follow? (write-giving! c inputs outputs))
  (movsd! a unit (behind rsp 0))
  (unpcklpd! a unit unit)
  (xorpd! a order order)
  (write-orders! c inputs outputs ending endless ends follow?)
  (write-end!)
  (add! a rsp 24)
  (for ([r (in-list (reverse kept))]) (pop! a r))
  (ret! a))

;; The loop over orders from 1 on.
(define (write-orders! c inputs outputs ending endless ends follow?)
  (define a (tape-a c))
  (define-values (again done) (values (make-label) (make-label)))
  (define (end-at-last!)
    (compare-number! a r12 (* 8 (- (tape-stride c) 1)))
    (jump! a 'not-less done))
  (label-here! a again)
  (when follow? (end-at-last!))
  (add! a r12 8)
  (addpd! a order (constant 1.0))
  (cond [follow? (write-taking! c inputs)]
        [else (write-next! c inputs outputs ends)
              (end-at-last!)])
  (for ([e (in-list ending)])
    (only-up-to c (car e) (write-group! c (list (cdr e)))))
  (for ([g (in-list (recurrence-groups endless))]) (write-group! c g))
  (when follow? (write-giving! c inputs outputs))
  (jump! a 'always again)
  (label-here! a done))

(define-syntax-rule (only-up-to c last body ...)
  (let ([beyond (make-label)] [a (tape-a c)])
    (compare-number! a r12 (* 8 last))
    (jump! a 'greater beyond)
    body ...
    (label-here! a beyond)))

;; The coefficient of the present order in the flvector of such a number
(define (in-flvector! c k)
  (mov! (tape-a c) rax (behind rbp (+ flvector-data (* 8 k))))
  (behind rax flvector-data r12))

;; Takes coefficients from flvectors, and gives them there.
(define (write-taking! c rows)
  (for ([r (in-list rows)] [k (in-naturals)])
    (movsd! (tape-a c) 0 (in-flvector! c k))
    (store-sd! (tape-a c) (now c r) 0)))

(define (write-giving! c inputs outputs)
  (for ([r (in-list outputs)] [k (in-naturals (length inputs))]  #:unless (among? r inputs))
    (movsd! (tape-a c) 0 (now c r))
    (store-sd! (tape-a c) (in-flvector! c k) 0)))

;; y_k = h f_{k-1} / k
(define (write-next! c inputs outputs ends)
  (define-values (endless others)
    (partition (lambda (x) (not (ends? (first x))))
               (for/list ([y (in-list inputs)] [f (in-list outputs)] [k (in-naturals)])
                 (list y f k))))
  ;; coordinates, whose rates are inputs, do not wait for the other rates
  (define-values (coordinates rest)
    (partition (lambda (x) (among? (second x) inputs)) endless))
  (write-next-pairs! c coordinates)
  (write-next-pairs! c rest)
  (unless (null? others) (only-up-to c ends (write-next-pairs! c others))))

(define (among? r rows) (memv (row-index r) (map row-index rows)))

;; Two at a time.
(define (write-next-pairs! c all)
  (define a (tape-a c))
  (unless (null? all)
    (define-values (x y) (values (car all) (if (null? (cdr all)) (car all) (cadr all))))
    (movsd! a 0 (before c (second x)))
    (load-high! a 0 (before c (second y)))
    (mulpd! a 0 unit)
    (divpd! a 0 order)
    (for ([state (in-list (list x y))] [store! (in-list (list store-sd! store-high!))])
      (store! a (now c (first state)) 0)
      (store! a (in-flvector! c (third state)) 0))
    (write-next-pairs! c (if (null? (cdr all)) '() (cddr all)))))

;; ---------------------------------------------------------------------------
;; Recurrences

;; Recurrences of one loop, and then each in its own straight lines: (end! c s operand ...), its
;; sums being in the registers from s on
(define (write-group! c group)
  (write-loop! c group)
  (for/fold ([s 0]) ([r (in-list group)])
    (apply (hash-ref ends-of-loops (recurrence-kind r)) c s (recurrence-operands r))
    (+ s (length (recurrence-terms r))))
  (void))

(define (write-loop! c group)
  (define r (car group))
  (define terms (append-map recurrence-terms group))
  (define operands (recurrence-operands r))
  (define (convolve-from! first last)
    (convolve! c first terms (single-sum? r) #:last last))
  (case (recurrence-kind r)
    [(products shared-products) (convolve-from! 0 #f)]
    [(differential pair leading) (convolve-from! 1 (recurrence-last r))]
    [(reciprocal) (convolve! c 1 terms #t)]
    [(differential-leading) (convolve! c 1 terms #t #:before-end? #t)]
    [(squares) (convolve-halves! c 0 (map car terms))]
    [(root) (convolve-halves! c 1 (map car terms))]
    [(power) (add-weighted-terms! c terms (map (lambda (r) (third (recurrence-operands r))) group))]
    [(ending-product) (apply convolve-ending! c (cdddr operands))]
    [else (void)]))

;; Stores base + Σ weight s, of the sums in the registers from s on.
(define (end-sum! c s r base weights)
  (define a (tape-a c))
  (define (weigh! x w) (unless (eqv? w 1.0) (mulsd! a x (factor c w))))
  (for ([w (in-list weights)] [x (in-naturals s)]) (weigh! x w))
  (define total (if base most-sums s))
  (when base
    (movsd! a total (now c (weighed-row base)))
    (weigh! total (weighed-weight base)))
  (for ([x (in-range (if base s (+ s 1)) (+ s (length weights)))]) (addsd! a total x))
  (store-sd! a (now c r) total))

(define (end-plain-sum! c s r base . terms)
  (define-values (weights rows) (apply values (equal-parts terms 2)))
  (for ([x (in-list rows)] [t (in-naturals s)]) (movsd! (tape-a c) t (now c x)))
  (end-sum! c s r base weights))

(define ((end-sum-of parts) c s r base . terms)
  (end-sum! c s r base (first (equal-parts terms parts))))

(define (end-one-product! c s r base w . _) (end-sum! c s r base (list w)))

(define (end-shared-products! c s b . targets)
  (for ([r (in-list (first (equal-parts targets 2)))] [t (in-naturals s)])
    (store-sd! (tape-a c) (now c r) t)))

;; ---------------------------------------------------------------------------
;; Differential equations

(define (end-derivative! c s d r)
  (define a (tape-a c))
  (movapd! a 0 order)
  (mulsd! a 0 (now c r))
  (store-sd! a (now c d) 0))

(define (end-integral! c s r d)
  (define a (tape-a c))
  (movsd! a 0 (now c d))
  (divsd! a 0 order)
  (store-sd! a (now c r) 0))

(define (end-pair! c s r u p v d last)
  (define a (tape-a c))
  (for ([row (in-list (list r p))] [w (in-list (list u v))] [t (in-naturals s)])
    (mulsd! a t (factor c w))
    (divsd! a t order)
    (store-sd! a (now c row) t)))

(define (end-turning! c s r u p v d)
  (define a (tape-a c))
  (for ([w (in-list (list u v))] [other (in-list (list p r))] [t (in-naturals)])
    (movsd! a t (factor c w))
    (mulsd! a t (early c d 1))
    (mulsd! a t (before c other))
    (divsd! a t order))
  (for ([row (in-list (list r p))] [t (in-naturals)]) (store-sd! a (now c row) t)))

;; ---------------------------------------------------------------------------
;; Equations

;; r_k becomes (x_k - s) / divisor
(define (end-equation! c s r x divisor)
  (define a (tape-a c))
  (movsd! a most-sums (now c x))
  (subsd! a most-sums s)
  (divsd! a most-sums divisor)
  (store-sd! a (now c r) most-sums))

(define (end-leading! c s r l last) (end-equation! c s r r (early c l 0)))
(define (end-differential-leading! c s d l) (end-equation! c s d d (early c l 0)))

(define (end-root! c s r x)
  (define-values (a twice) (values (tape-a c) (+ 1 most-sums)))
  (movsd! a twice (constant 2.0))
  (mulsd! a twice (early c r 0))
  (end-equation! c s r x twice))

(define (end-reciprocal! c s r b)
  (define a (tape-a c))
  (xorpd! a most-sums most-sums)
  (subsd! a most-sums s)
  (divsd! a most-sums (early c b 0))
  (store-sd! a (now c r) most-sums))

(define (end-power! c s r b n)
  (define a (tape-a c))
  (movapd! a most-sums order)
  (mulsd! a most-sums (early c b 0))
  (divsd! a s most-sums)
  (store-sd! a (now c r) s))

;; ---------------------------------------------------------------------------
;; Order 0

(define (store-start! c r) (store-sd! (tape-a c) (early c r 0) 0))

(define (end-constant! c s r x)
  (movsd! (tape-a c) 0 (factor c x))
  (store-start! c r))

(define (end-ratio! c s r x y)
  (movsd! (tape-a c) 0 (early c x 0))
  (divsd! (tape-a c) 0 (early c y 0))
  (store-start! c r))

(define (end-power-value! c s r b n)
  (define a (tape-a c))
  (define-values (whole half?) (whole-and-half n))
  (cond [whole
         (if half? (sqrtsd! a 0 (early c b 0)) (movsd! a 0 (constant 1.0)))
         (for ([_ (in-range whole)]) (mulsd! a 0 (early c b 0)))
         (when (< n 0)
           (movapd! a 1 0)
           (movsd! a 0 (constant 1.0))
           (divsd! a 0 1))]
        [else
         (movsd! a 0 (early c b 0))
         (movsd! a 1 (constant (real->double-flonum n)))
         (call-address! a (C-function 'pow))])
  (store-start! c r))

(define (end-value! c s r name f . xs)
  (define a (tape-a c))
  (cond [(eq? name 'sqrt) (sqrtsd! a 0 (early c (car xs) 0))]
        [else
         (for ([x (in-list xs)] [k (in-naturals)]) (movsd! a k (early c x 0)))
         (call-address! a (operation-C-function name (length xs)))])
  (store-start! c r))

;; -> the address of a function, or 'sqrt
(define (start-function r)
  (call-with-start r (lambda (name n) (if (eq? name 'sqrt) name (operation-C-function name n)))))

;; (use operation number-of-arguments)
(define (call-with-start r use)
  (use (second (recurrence-operands r)) (length (cdddr (recurrence-operands r)))))

;; ---------------------------------------------------------------------------

(define ends-of-loops
  (hasheq 'sums end-plain-sum! 'products (end-sum-of 3) 'squares (end-sum-of 2)
          'ending-product end-one-product! 'shared-products end-shared-products!
          'derivative end-derivative! 'integral end-integral!
          'differential end-one-product! 'pair end-pair! 'turning end-turning!
          'leading end-leading! 'differential-leading end-differential-leading!
          'root end-root! 'reciprocal end-reciprocal! 'power end-power!
          'value end-value! 'constant end-constant! 'ratio end-ratio!
          'power-value end-power-value!))
