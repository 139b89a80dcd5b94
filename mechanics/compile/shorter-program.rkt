#lang racket/base
;; Programs with fewer operations and the same values, but for rounding.
;;
;; A program is read as sums of products (sums-of-products.rkt), common factors are taken out of
;; sums (factored-sums.rkt) and common products computed once (shared-products.rkt); then it is
;; written again (written-sums.rkt), and if it is short now once more, for then sums are found that
;; were hidden in others.  A program that does not get shorter stays as it is, to the last bit.
;;
;; This is done to final programs: code of every sort, here and exported, is made of the same list.
;; Derivatives of programs are taken of the longer ones, which leave no less to be found in theirs.

(require (only-in racket/list append-map)
         "factored-sums.rkt" (only-in "flonum-coefficients.rkt" moderate?)
         "program-builder.rkt" "program.rkt" "shared-products.rkt" "sum-terms.rkt"
         "sums-of-products.rkt" "written-sums.rkt")

(provide shorter-program)

;; To rewrite takes some microseconds an instruction: of more it takes longer than most runs save.
(define longest 1000)
(define longest-again 150)

(define (shorter-program p [most longest])
  (define q (and (<= 2 (program-length p) most) (moderate-constants? p) (written-again p)))
  (if (and q (< (cost q) (cost p))) (shorter-program q longest-again) p))

;; Sums and products of others may leave the flonums in another order.
(define (moderate-constants? p)
  (for*/and ([i (in-vector (program-instructions p))] [x (in-list (instruction-operands i))])
    (or (not (real? x)) (zero? x) (moderate? x))))

;; A division takes as long as some products.
(define (cost p)
  (for/sum ([i (in-vector (program-instructions p))])
    (if (memq (instruction-operation i) '(divide sqrt)) 4 1)))

(define (written-again p)
  (define n (program-inputs p))
  (define-values (f outputs) (program->sums p))
  (define-values (items sums) (factor-sums f outputs))
  (define-values (short new) (share-products (monomials-of items sums) (next-id items)))
  (for ([(id factor) (in-hash new)]) (hash-set! items id factor))
  (define b (make-builder n))
  (define w (make-writer b items short))
  (builder->program b n
                    (for/list ([s (in-list sums)] [o (in-vector (program-outputs p))])
                      (if (place? o) (write-sum! w s) o))))

(define (next-id items) (for/fold ([next 0]) ([id (in-hash-keys items)]) (max next (+ id 1))))

;; Monomials of two factors or more.
(define (monomials-of items sums)
  (for*/list ([s (in-list (append sums (append-map sums-of (hash-values items))))]
              [t (in-list s)]
              [m (in-value (monomial t))]
              #:when (and (pair? m) (pair? (cdr m))))
    m))
