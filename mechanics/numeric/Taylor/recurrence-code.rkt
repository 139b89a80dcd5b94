#lang racket/base
;; Recurrences as machine code: one procedure for all coefficients of an expansion.
;;
;; The code of a recurrence is one loop over orders, the convolution, between straight lines; it
;; does the operations of its kernel (kernels.rkt) in the same order, so that the coefficients are
;; the same to the last bit.  All of it stands in a loop over the orders of the expansion.
;;
;; The procedure is given the vector of rows, and finds each row by its number.  The last entry of
;; that vector is the order: in memory a fixnum is eight times the number, as is the distance in
;; bytes to the coefficient of that order.

(require racket/list
         "recurrence.rkt" "convolution-code.rkt"
         "../machine/assembler.rkt" "../machine/executable.rkt" "../machine/instruction-code.rkt")

(provide (protect-out motion-code follow-code))

;; starts, endless : recurrences; ending : list of (last order . recurrence)
;; states, slopes : lists of rows
;; -> (h rows -> void), which solves y' = f(y) in the unit h; or #f where there is no such code
(define (motion-code states slopes starts ending endless latest-end count)
  (define-values (moving others)
    (partition (lambda (p) (not (ends? (car p)))) (map cons states slopes)))
  (define (write-next! a)
    (for ([p (in-list moving)]) (write-next-coefficient! a p))
    (unless (null? others)
      (only-up-to a latest-end
                  (for ([p (in-list others)]) (write-next-coefficient! a p)))))
  (code starts ending endless count write-next! #f))

;; The same for rows that are known already: (unused rows -> void)
(define (follow-code starts ending endless count)
  (code starts ending endless count void #t))

(define (code starts ending endless count write-next! to-the-end?)
  (define all (append starts (map cdr ending) endless))
  (and (machine?)
       (andmap coded? all)
       (let ([a (make-assembly)])
         (write-procedure! a starts ending endless count write-next! to-the-end?)
         (define procedures (machine-procedures (assembly->bytes a) '((0 flonum vector))))
         (and procedures (car procedures)))))

(define (coded? r)
  (case (recurrence-kind r)
    [(system) #f]
    [(value) (start-function r)]
    [else #t]))

;; ---------------------------------------------------------------------------
;; The procedure

;; Registers that a function of C keeps: rbx, the rows; r12, the order, in bytes; r13, the last one
(define kept (list rbx rbp r12 r13 r14 r15))

(define (write-procedure! a starts ending endless count write-next! to-the-end?)
  (define-values (again done) (values (make-label) (make-label)))
  (for ([r (in-list kept)]) (push! a r))
  (add! a rsp -24)
  (store-sd! a (behind rsp 0) 0)
  (mov! a rbx rdi)
  (mov! a r13 (behind rbx (+ flvector-data (* 8 count))))
  (mov-number! a r12 0)
  (for ([r (in-list starts)]) (write-recurrence! a r))
  (movsd! a unit (behind rsp 0))
  (xorpd! a order order)
  (label-here! a again)
  (compare! a r12 r13)
  (jump! a 'not-less done)
  (add! a r12 8)
  (addsd! a order (constant 1.0))
  (write-next! a)
  (unless to-the-end?
    (compare! a r12 r13)
    (jump! a 'not-less done))
  (for ([e (in-list ending)])
    (only-up-to a (car e) (write-recurrence! a (cdr e))))
  (for ([r (in-list endless)]) (write-recurrence! a r))
  (jump! a 'always again)
  (label-here! a done)
  (add! a rsp 24)
  (for ([r (in-list (reverse kept))]) (pop! a r))
  (ret! a))

(define-syntax-rule (only-up-to a last body ...)
  (let ([beyond (make-label)])
    (compare-number! a r12 (* 8 last))
    (jump! a 'greater beyond)
    body ...
    (label-here! a beyond)))

;; y_k = h f_{k-1} / k
(define (write-next-coefficient! a p)
  (define c (load-rows! a (list (car p) (cdr p))))
  (movsd! a 0 (before c (cdr p)))
  (mulsd! a 0 unit)
  (divsd! a 0 order)
  (store-sd! a (now c (car p)) 0))

;; ---------------------------------------------------------------------------
;; Recurrences

(define (write-recurrence! a r)
  (define operands (recurrence-operands r))
  (apply (hash-ref writers (recurrence-kind r)) (load-rows! a (rows-in operands)) operands))

(define (rows-in x)
  (cond [(row? x) (list x)]
        [(weighed? x) (list (weighed-row x))]
        [(pair? x) (append-map rows-in x)]
        [else '()]))

;; Stores base + Σ weight s, of the sums in the registers from 0 on.
(define (store-sum! c r base weights)
  (define a (rows-at-assembly c))
  (define (weigh! s w) (unless (eqv? w 1.0) (mulsd! a s (constant w))))
  (for ([w (in-list weights)] [s (in-naturals)]) (weigh! s w))
  (define total (if base 5 0))
  (when base
    (movsd! a total (now c (weighed-row base)))
    (weigh! total (weighed-weight base)))
  (for ([_ (in-list (if base weights (cdr weights)))] [s (in-naturals (if base 0 1))])
    (addsd! a total s))
  (store-sd! a (now c r) total))

;; A list of the parts of things, those of all things in turn -> n lists
(define (parts things n)
  (define size (quotient (length things) n))
  (let loop ([things things])
    (if (null? things) '() (cons (take things size) (loop (drop things size))))))

(define (write-sums! c r base . terms)
  (define-values (weights rows) (apply values (parts terms 2)))
  (for ([x (in-list rows)] [s (in-naturals)]) (movsd! (rows-at-assembly c) s (now c x)))
  (store-sum! c r base weights))

(define (write-products! c r base . terms)
  (define-values (weights as bs) (apply values (parts terms 3)))
  (convolve! c 0 as bs)
  (store-sum! c r base weights))

(define (write-squares! c r base . terms)
  (define-values (weights rows) (apply values (parts terms 2)))
  (convolve-halves! c 0 rows)
  (store-sum! c r base weights))

(define (write-ending-product! c r base w a la b lb)
  (convolve-ending! c a la b lb)
  (store-sum! c r base (list w)))

(define (write-shared-products! c b . targets)
  (define-values (rows as) (apply values (parts targets 2)))
  (convolve! c 0 as (map (lambda (_) b) as))
  (for ([r (in-list rows)] [s (in-naturals)]) (store-sd! (rows-at-assembly c) (now c r) s)))

;; ---------------------------------------------------------------------------
;; Differential equations

(define (write-derivative! c d r)
  (define a (rows-at-assembly c))
  (movapd! a 0 order)
  (mulsd! a 0 (now c r))
  (store-sd! a (now c d) 0))

(define (write-integral! c r d)
  (define a (rows-at-assembly c))
  (movsd! a 0 (now c d))
  (divsd! a 0 order)
  (store-sd! a (now c r) 0))

(define (write-differential! c r base w d last b)
  (convolve! c 1 (list d) (list b) #:last last)
  (store-sum! c r base (list w)))

(define (write-pair! c r u p v d last)
  (define a (rows-at-assembly c))
  (convolve! c 1 (list d d) (list p r) #:last last)
  (for ([row (in-list (list r p))] [w (in-list (list u v))] [s (in-naturals)])
    (mulsd! a s (constant w))
    (divsd! a s order)
    (store-sd! a (now c row) s)))

(define (write-turning! c r u p v d)
  (define a (rows-at-assembly c))
  (for ([w (in-list (list u v))] [other (in-list (list p r))] [s (in-naturals)])
    (movsd! a s (constant w))
    (mulsd! a s (early c d 1))
    (mulsd! a s (before c other))
    (divsd! a s order))
  (for ([row (in-list (list r p))] [s (in-naturals)]) (store-sd! a (now c row) s)))

;; ---------------------------------------------------------------------------
;; Equations

;; r_k becomes (r_k - s) / divisor
(define (write-rest! c r from divisor)
  (define a (rows-at-assembly c))
  (movsd! a 1 (now c from))
  (subsd! a 1 0)
  (divsd! a 1 divisor)
  (store-sd! a (now c r) 1))

(define (write-leading! c r l last)
  (convolve! c 1 (list l) (list r) #:last last)
  (write-rest! c r r (early c l 0)))

(define (write-differential-leading! c d l)
  (convolve! c 1 (list d) (list l) #:before-end? #t)
  (write-rest! c d d (early c l 0)))

(define (write-root! c r x)
  (define a (rows-at-assembly c))
  (convolve-halves! c 1 (list r))
  (movsd! a 2 (constant 2.0))
  (mulsd! a 2 (early c r 0))
  (write-rest! c r x 2))

(define (write-reciprocal! c r b)
  (define a (rows-at-assembly c))
  (convolve! c 1 (list b) (list r))
  (xorpd! a 1 1)
  (subsd! a 1 0)
  (divsd! a 1 (early c b 0))
  (store-sd! a (now c r) 1))

;; Register 0 : the sum; 1 : the weight, which rises by register 2
(define (write-power! c r b n)
  (define a (rows-at-assembly c))
  (define rise (+ n 1.0))
  (movsd! a 2 (constant rise))
  (movapd! a 1 2)
  (subsd! a 1 order)
  (xorpd! a 0 0)
  (for-each-term! c 1
                  (lambda ()
                    (movsd! a 3 (rising c b 0))
                    (mulsd! a 3 (falling c r 0))
                    (mulsd! a 3 1)
                    (addsd! a 0 3)
                    (addsd! a 1 2)))
  (movapd! a 1 order)
  (mulsd! a 1 (early c b 0))
  (divsd! a 0 1)
  (store-sd! a (now c r) 0))

;; ---------------------------------------------------------------------------
;; Order 0

(define (write-constant! c r x)
  (movsd! (rows-at-assembly c) 0 (constant x))
  (store-start! c r))

(define (store-start! c r) (store-sd! (rows-at-assembly c) (early c r 0) 0))

(define (write-ratio! c r x y)
  (define a (rows-at-assembly c))
  (movsd! a 0 (early c x 0))
  (divsd! a 0 (early c y 0))
  (store-start! c r))

(define (write-power-value! c r b n)
  (define a (rows-at-assembly c))
  (define-values (whole half?) (whole-and-half n))
  (define (load-b! k) (movsd! a k (early c b 0)))
  (cond [whole
         (if half? (sqrtsd! a 0 (early c b 0)) (movsd! a 0 (constant 1.0)))
         (for ([_ (in-range whole)]) (mulsd! a 0 (early c b 0)))
         (when (< n 0)
           (movsd! a 1 (constant 1.0))
           (divsd! a 1 0)
           (movapd! a 0 1))
         (store-start! c r)]
        [else
         (load-b! 0)
         (movsd! a 1 (constant (real->double-flonum n)))
         (call-address! a (C-function 'pow))
         (store-start! (load-rows! a (list r)) r)]))

;; A function of C changes the registers where rows are.
(define (write-value! c r name f . xs)
  (define a (rows-at-assembly c))
  (cond [(eq? name 'sqrt) (sqrtsd! a 0 (early c (car xs) 0))
                          (store-start! c r)]
        [else
         (for ([x (in-list xs)] [k (in-naturals)]) (movsd! a k (early c x 0)))
         (call-address! a (operation-C-function name (length xs)))
         (store-start! (load-rows! a (list r)) r)]))

(define (start-function r)
  (define operands (recurrence-operands r))
  (define name (second operands))
  (or (eq? name 'sqrt) (operation-C-function name (length (cdddr operands)))))

;; ---------------------------------------------------------------------------

(define writers
  (hasheq 'sums write-sums! 'products write-products! 'squares write-squares!
          'ending-product write-ending-product! 'shared-products write-shared-products!
          'derivative write-derivative! 'integral write-integral!
          'differential write-differential! 'pair write-pair! 'turning write-turning!
          'leading write-leading! 'differential-leading write-differential-leading!
          'root write-root! 'reciprocal write-reciprocal! 'power write-power!
          'value write-value! 'constant write-constant! 'ratio write-ratio!
          'power-value write-power-value!))
