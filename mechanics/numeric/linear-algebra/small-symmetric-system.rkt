#lang racket/base
;; Symmetric systems of a few unknowns, solved in straight lines.
;;
;; Most systems of mechanics have a few coordinates.  Loops over so few entries cost more than the
;; arithmetic within them: no processor foresees where they end.  So for each number of unknowns
;; up to `most-unknowns` a macro writes a procedure without loops, all of whose values are in
;; variables.
;;
;; Row k times M_ki / d_k is taken from each row i below it: M = L D Lᵀ.  Only the upper triangle
;; is read.  Where each d_k is positive beyond rounding M is positive definite, and needs no
;; pivots; where one is not, nothing has been changed.

(require racket/unsafe/ops
         (for-syntax racket/base))

(provide most-unknowns solve-small! least-part)

;; The least part of an entry of the diagonal that elimination must leave.
(define least-part 1e-13)

(begin-for-syntax
  (define (name letter . indices) (string->symbol (format "~a~a" letter indices)))
  (define (less-product x a b) `(unsafe-fl- ,x (unsafe-fl* ,a ,b)))

  ;; The name of an entry is bound again to its new value.
  (define (loads n)
    (for/list ([i (in-range n)])
      `([,(name 'b i) (unsafe-flvector-ref b ,i)]
        ,@(for/list ([j (in-range i n)])
            `[,(name 'm i j) (unsafe-flvector-ref m ,(+ (* n i) j))])
        [,(name 'whole i) ,(name 'm i i)])))

  (define (row-operations n)
    (for*/list ([k (in-range n)] [i (in-range k n)])
      (if (= i k)
          `([,(name 'inverse k) (unsafe-fl/ 1.0 ,(name 'm k k))])
          `([factor (unsafe-fl* ,(name 'm k i) ,(name 'inverse k))]
            ,@(for/list ([j (in-range i n)])
                `[,(name 'm i j) ,(less-product (name 'm i j) 'factor (name 'm k j))])
            [,(name 'b i) ,(less-product (name 'b i) 'factor (name 'b k))]))))

  (define (substitution n)
    (for/list ([k (in-range (- n 1) -1 -1)])
      (define rest
        (for/fold ([rest (name 'b k)]) ([j (in-range (+ k 1) n)])
          (less-product rest (name 'm k j) (name 'b j))))
      `([,(name 'b k) (unsafe-fl* ,rest ,(name 'inverse k))])))

  ;; The lower bounds are 0 or, when elimination is done, parts of the first entries.
  (define (diagonal-above n bound)
    `(and ,@(for/list ([k (in-range n)]) `(unsafe-fl< ,(bound k) ,(name 'm k k) +inf.0))))

  (define (part-of-whole k) `(unsafe-fl* least-part ,(name 'whole k)))

  ;; A zero on the diagonal, as constraints leave it, is seen at once.
  (define (solution n)
    `(lambda (m b)
       (let* ,(apply append (loads n))
         (and ,(diagonal-above n (lambda (k) 0.0))
              (let* ,(apply append (row-operations n))
                (and ,(diagonal-above n part-of-whole)
                     (let* ,(apply append (substitution n))
                       ,@(for/list ([k (in-range n)])
                           `(unsafe-flvector-set! b ,k ,(name 'b k)))
                       #t))))))))

;; Defines the greatest number of unknowns, and a vector of procedures by number of unknowns.
(define-syntax (define-solvers stx)
  (syntax-case stx ()
    [(here most by-size largest)
     (with-syntax ([(solver ...)
                    (for/list ([n (in-range 1 (+ (syntax-e #'largest) 1))])
                      (datum->syntax #'here (solution n)))])
       #'(begin (define most largest)
                (define by-size (vector #f solver ...))))]))

(define-solvers most-unknowns by-size 8)

;; m : n² entries; n : at most `most-unknowns` -> whether m is positive definite, and so b, the
;; right-hand side, has become the solution
(define (solve-small! m n b) ((unsafe-vector-ref by-size n) m b))
