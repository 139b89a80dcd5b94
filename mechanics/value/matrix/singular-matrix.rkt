#lang racket/base
;; A matrix without an inverse, in words: the dependence of its rows, its null
;; space, whether the system still has solutions.

(require "../algebra.rkt" "../assumptions.rkt"
         "../../algebra/expression/expression.rkt"
         "../../error/failure.rkt" "../../error/message-words.rkt"
         "../../generic/describe.rkt" "../../generic/wrong-argument.rkt"
         "../../numeric/linear-algebra/flonum-systems.rkt"
         "../../numeric/linear-algebra/row-matrix.rkt")

(provide raise-singular-matrix matrix-kernel raise-no-scalars raise-too-large last-by-others)

;; Of a matrix of numbers and expressions; #f if that would grow too large.
(define (matrix-kernel rows)
  (if (and (all-entries? number? rows) (not (exact-numbers? rows)))
      (let-values ([(rank vectors) (floating-kernel rows)])
        (kernel-basis rank vectors '()))
      (eliminated-kernel rows (assumptions-in-force))))

;; right : rows of right-hand sides, or #f if the inverse was wanted
;; shape : vector of components -> unknown, in the shape asked for
(define (raise-singular-matrix who given rows right shape)
  (define (kernel-of rows) (and (all-entries? expression? rows) (matrix-kernel rows)))
  (define kernel (kernel-of rows))
  (define dependences (kernel-of (rows-transpose rows)))
  (define null-vectors (and kernel (map shape (kernel-basis-vectors kernel))))
  (raise-without-inverse
   who
   (string-append
    "the matrix has no inverse"
    (field "matrix" (matrix-text rows))
    (if kernel (kernel-text kernel null-vectors (vector-length rows)) "")
    (if dependences (dependences-text (kernel-basis-vectors dependences) right) ""))
   given
   null-vectors))

(define (field label text) (format "\n  ~a: ~a" label text))

(define (matrix-text rows)
  (if (> (vector-length rows) 6)
      (format "~a rows and columns" (vector-length rows))
      (format "~a" (for/list ([row (in-vector rows)]) (map value->datum (vector->list row))))))

;; A line for each of xs.
(define (fields label ->text xs)
  (joined (for/list ([x (in-list xs)]) (field label (->text x))) ""))

(define (kernel-text kernel null-vectors n)
  (string-append (field "rank" (format "~a of ~a" (kernel-basis-rank kernel) n))
                 (fields "null vector" value->text null-vectors)
                 (fields "assuming" (lambda (a) (format "~a" a))
                         (kernel-basis-assumptions kernel))))

;; ---------------------------------------------------------------------------
;; Dependent rows

(define (dependences-text dependences right)
  (string-append (fields "dependent" dependence-text dependences)
                 (if right (field "solutions" (solutions-text dependences right)) "")))

;; Σ yᵢ (row i) = 0, as the last of them in terms of the others.
(define (dependence-text y)
  (define-values (end others)
    (last-by-others y "row" (lambda (a b) (simple (e:/ (e:negate a) b)))))
  (format "row ~a is ~a" end (or others "zero")))

;; -> the index of the last that Σ yᵢ xᵢ = 0 depends on, and it in terms of the others, or #f if
;; there are none; noun : of the x; less-quotient : a b -> −a/b as it is shown
(define (last-by-others y noun less-quotient)
  (define (none? c) (and (number? c) (zero? c)))
  (define end (for/last ([c (in-vector y)] [i (in-naturals)] #:unless (none? c)) i))
  (define terms
    (for/list ([c (in-vector y)] [i (in-range end)] #:unless (none? c))
      (define factor (less-quotient c (vector-ref y end)))
      (if (member factor '(1 1.0))
          (format "~a ~a" noun i)
          (format "~a times ~a ~a" (value->text factor) noun i))))
  (values end (and (pair? terms) (joined terms " plus "))))

(define (simple e) (if (number? e) e (simplify-expression e (assumptions-in-force))))

;; Do the right-hand sides depend in the same way?
(define (solutions-text dependences right)
  (if (and (all-entries? expression? right)
           (for*/and ([y (in-list dependences)] [l (in-range (row-length right))])
             (vanishes? (combination y right l) (assumptions-in-force))))
      "infinitely many, the right-hand side depending in the same way"
      "none, the right-hand side not depending in the same way"))

(define (combination y right l)
  (for/fold ([sum 0]) ([c (in-vector y)] [b (in-vector right)])
    (e:+ sum (e:* c (vector-ref b l)))))

;; ---------------------------------------------------------------------------
;; Rank and null space

(define (raise-no-scalars who given)
  (complain-of-argument who "numbers or expressions as entries" given))

(define (raise-too-large who given)
  (raise-no-answer who (string-append "elimination would make the entries too large, "
                                      "or one divides by zero\n  matrix: ~a")
                   (value->text given)))
