#lang racket/base
;; Recurrences as data: how coefficient k of a row follows from those of rows below k.
;;
;; A list of these is a program whose values are rows of Taylor coefficients.  It is run by closures
;; (kernels.rkt) or as machine code (recurrence-code.rkt).  A recurrence has a kind and operands:
;; rows, numbers, and the *base*, the sum so far: a weighed row, or #f for nothing.
;;
;;     sums r base w ... x ...                 r = base + Σ w x
;;     products r base w ... a ... b ...       r = base + Σ w a b
;;     squares r base w ... a ...              r = base + Σ w a²
;;     ending-product r base w a la b lb       r = base + w a b, of rows with such last indices
;;     shared-products b r ... a ...           r = a b, of each r and a
;;     derivative d r                          d_k = k r_k
;;     integral r d                            r_k = d_k / k
;;     differential r base w d last b          r = base + w Σ d_j b_{k−j}, j from 1
;;     pair r u p v d last                     k r_k = u Σ d_j p_{k−j}, k p_k = v Σ d_j r_{k−j}
;;     turning r u p v d                       the same of an angle that grows as the time does
;;     leading r l last                        l r = x, where x_k has been stored in r_k
;;     differential-leading d l                the same of rows of derivatives
;;     root r a                                r r = a
;;     reciprocal r b                          r b = 1
;;     power r b n                             b r' = n b' r
;;     system A varying b x                    A x = b (linear-system.rkt)
;;
;; and at order 0 alone
;;
;;     constant r c
;;     value r name f x ...                    r = f(x, ...), an operation of that name
;;     ratio r a b                             r = a / b
;;     power-value r b n                       r = bⁿ
;;
;; Several may make one row, each adding its share to the sum that the one before it left.

(require racket/list)

(provide (struct-out recurrence) make-recurrence (struct-out row) (struct-out weighed)
         (struct-out product) (struct-out target) (struct-out slot)
         itself ends? last-index
         sum-recurrences product-recurrences square-recurrences shared-product-recurrences
         differential-recurrence pair-recurrence leading-recurrence whole-and-half)

;; kind : symbol; operands : list
(struct recurrence (kind operands) #:authentic #:transparent)
(define (make-recurrence kind . operands) (recurrence kind operands))

;; degree : an exact integer, or +inf.0 for a row that does not end
(struct row (index degree) #:authentic #:transparent)

;; weight times a row; weight times a product of rows; a row that becomes the product of `a` and
;; another
(struct weighed (weight row) #:authentic #:transparent)
(struct product (weight a b) #:authentic)
(struct target (row a) #:authentic)

;; A number that is not known when code is made: it will be the one of that index among those on the
;; tape (recurrence-shape.rkt).
(struct slot (index) #:authentic #:transparent)

;; The base of a recurrence that adds to the row.
(define (itself r) (weighed 1.0 r))

;; The index of the last coefficient: of a row that does not end one that is never reached.
(define (last-index r) (if (ends? r) (row-degree r) never))
(define never 1000000)
(define (ends? r) (< (row-degree r) +inf.0))

;; ---------------------------------------------------------------------------

;; In groups of at most three things: (make base part ...), the parts being those of all things in
;; turn; the first group begins with the base and the others with the sum so far.
(define (grouped things base again make . parts)
  (let loop ([things things] [base base])
    (cond [(null? things) '()]
          [else
           (define-values (group rest) (split-at things (min 3 (length things))))
           (cons (make base (append-map (lambda (part) (map part group)) parts))
                 (loop rest again))])))

(define ((sum-of kind r) base parts) (recurrence kind (list* r base parts)))

;; base + Σ weight row
(define (sum-recurrences r terms base)
  (grouped terms base (itself r) (sum-of 'sums r) weighed-weight weighed-row))

;; base + Σ weight row²
(define (square-recurrences r terms base)
  (grouped terms base (itself r) (sum-of 'squares r) weighed-weight weighed-row))

;; base + Σ weight a b.  Convolutions of a row that ends (a linear function of time has two
;; coefficients) run over those.
(define (product-recurrences r products base)
  (define-values (ending endless)
    (partition (lambda (p) (or (ends? (product-a p)) (ends? (product-b p))))
               products))
  (append (grouped endless base (itself r) (sum-of 'products r)
                   product-weight product-a product-b)
          (for/list ([p (in-list ending)] [k (in-naturals)])
            (define-values (a b) (values (product-a p) (product-b p)))
            (make-recurrence 'ending-product r
                             (if (or (pair? endless) (> k 0)) (itself r) base)
                             (product-weight p) a (last-index a) b (last-index b)))))

;; Each target becomes the product of its row and b, endless ones.
(define (shared-product-recurrences targets b)
  (grouped targets #f #f (lambda (_ parts) (recurrence 'shared-products (cons b parts)))
           target-row target-a))

(define (differential-recurrence r weight d b base)
  (make-recurrence 'differential r base weight d (last-index d) b))

;; r' = u p a' and p' = v r a', given d of a: two functions of which each has the other in its
;; derivative, as sin and cos.  The angle of a drive grows as the time does: coefficient k follows
;; from the one before alone.
(define (pair-recurrence r u p v d)
  (if (= 1 (row-degree d))
      (make-recurrence 'turning r u p v d)
      (make-recurrence 'pair r u p v d (last-index d))))

(define (leading-recurrence r l) (make-recurrence 'leading r l (last-index l)))

;; bⁿ is computed by so many multiplications, and perhaps a root, if |n| is half a small whole
;; number; else -> #f, #f
(define (whole-and-half n)
  (define m (* 2 (abs n)))
  (if (and (integer? m) (<= m 12))
      (values (quotient m 2) (odd? m))
      (values #f #f)))
