#lang racket/base
;; Eigenvectors of a matrix of decimals that is not symmetric.
;;
;; An eigenvalue alone has one eigenvector, which inverse iteration finds.  One that is repeated
;; comes as several numbers near one another: by roundings ε if it has as many vectors, by as
;; much as ε^(1/k) if it has fewer.  Their mean is the eigenvalue to some ε in both cases.  So
;; eigenvalues that lie near are taken together; if their mean λ is an eigenvalue, the space
;; that A − λ maps to 0 has its vectors, and if not, those are taken together that lie nearer.
;;
;; That space is spanned by the right singular vectors of which the singular values vanish.  With
;; λ complex, z = x + i y is taken to 0 if (x, y) is by a real matrix of twice the size.

(require racket/list
         "linear-algebra.rkt" "matrix.rkt" "row-products.rkt"
         "../structure.rkt"
         "../../generic/arithmetic.rkt"
         "../../numeric/flvector.rkt"
         "../../numeric/linear-algebra/row-matrix.rkt"
         "../../numeric/linear-algebra/singular-values.rkt")

(provide numeric-eigenvectors)

;; rows : of flonums; values : its eigenvalues -> a list of (value vector ...), up tuples
(define (numeric-eigenvectors rows values)
  (append-map (lambda (near) (vectors-of rows near widest))
              (clusters values (greatest-entry rows) widest)))

;; Relative to the entries: how near eigenvalues are that may be one, and how far the mean of
;; such from being it.
(define widest 1e-3)
(define narrowest 1e-14)
(define rounding 1e-12)

(define (vectors-of rows near gap)
  (define size (greatest-entry rows))
  (cond [(null? (cdr near)) (list (list (car near) (by-inverse-iteration rows (car near))))]
        [else
         (define mean (mean-of near))
         (define found (null-vectors rows mean (* rounding size (vector-length rows))))
         (cond [(pair? found) (list (cons mean found))]
               [(< gap narrowest)
                (for/list ([value (in-list near)])
                  (list value (by-inverse-iteration rows value)))]
               [else
                (define closer (/ gap 10))
                (append-map (lambda (part) (vectors-of rows part closer))
                            (clusters near size closer))])]))

(define (mean-of near)
  (define mean (/ (apply + near) (length near)))
  (if (<= (abs (imag-part mean)) (* 1e-14 (magnitude mean))) (real-part mean) mean))

;; Lists of values of which each is near another in its list, in the order of the values
(define (clusters values size gap)
  (define (value i) (list-ref values i))
  (define (near? i j) (<= (magnitude (- (value i) (value j))) (* gap size)))
  (for/list ([group (in-list (joined-groups (length values) near?))]) (map value group)))

;; ---------------------------------------------------------------------------
;; One

;; Near the eigenvalue the inverse of the matrix less it stretches one direction: that one.
(define (by-inverse-iteration rows value)
  (define n (vector-length rows))
  (define near (g:- (matrix rows) (+ value (* (greatest-entry rows) 1e-10))))
  (define start (apply up (for/list ([i (in-range n)]) (+ 1.0 (* 0.1 i)))))
  (for/fold ([v start]) ([_ (in-range 4)])
    (unit-length (solve-linear-left near v))))

(define (unit-length v)
  (define size (sqrt (for/sum ([x (in-list (structure->list v))]) (expt (magnitude x) 2))))
  (g:/ v size))

;; ---------------------------------------------------------------------------
;; Several

;; Orthonormal vectors that rows less value takes to 0, but for the tolerance
(define (null-vectors rows value tolerance)
  (define A (rows-combine - rows (unit-rows (vector-length rows) value 0)))
  (if (all-entries? real? A)
      (for/list ([v (in-list (real-null-vectors A tolerance))]) (apply up v))
      (map (lambda (z) (apply up z))
           (independent (for/list ([v (in-list (real-null-vectors (doubled A) tolerance))])
                          (joined v (vector-length A)))))))

;; -> lists of numbers
(define (real-null-vectors rows tolerance)
  (define-values (us sizes vs) (singular-values (columns-of rows)))
  (for/list ([size (in-list sizes)] [v (in-list vs)] #:when (<= size tolerance))
    (flvector->list v)))

;; Re A, −Im A over Im A, Re A
(define (doubled A)
  (define n (vector-length A))
  (for/vector ([i (in-range (* 2 n))])
    (for/vector ([j (in-range (* 2 n))])
      (define x (entry A (modulo i n) (modulo j n)))
      (cond [(eq? (< i n) (< j n)) (real-part x)]
            [(< i n) (- (imag-part x))]
            [else (imag-part x)]))))

(define (joined v n)
  (define-values (x y) (split-at v n))
  (map make-rectangular x y))

;; Those that are not combinations of others before; z and i z both come, as v
(define (independent zs)
  (for/fold ([found '()] #:result (reverse found)) ([z (in-list zs)])
    (define rest
      (for/fold ([z z]) ([w (in-list (append found found))])
        (define c (inner w z))
        (map (lambda (a b) (- a (* c b))) z w)))
    (define size (sqrt (real-part (inner rest rest))))
    (if (> size 0.1) (cons (map (lambda (a) (/ a size)) rest) found) found)))

(define (inner w z) (for/sum ([a (in-list w)] [b (in-list z)]) (* (conjugate a) b)))
(define (conjugate a) (make-rectangular (real-part a) (- (imag-part a))))
