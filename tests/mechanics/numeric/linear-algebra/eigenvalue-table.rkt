#lang racket/base
;; 63 matrices that are badly scaled, defective or graded (eigenvalues.rktd): as accurate as LAPACK,
;; and what is less than half of the digits is known to be.
;;
;; A line of the table is a name, LAPACK's error, rows of flonums, and the eigenvalues of these very
;; flonums to 30 digits.  They are mpmath's (1.3, mp.eig at 600 digits).  LAPACK's error is the
;; greatest of numpy's eigenvalues (2.4, dgeev), relative to the eigenvalue or, of 0, to the
;; greatest entry of the balanced matrix; of the matrix itself and of 20 whose entries differ from
;; it in the last digit, since of one alone an error may be small by chance.

(require racket/flonum
         racket/list
         racket/runtime-path
         mechanics/generic/arithmetic
         mechanics/numeric/flvector
         mechanics/numeric/linear-algebra/general-eigenvalues
         mechanics/value/matrix/decompositions
         mechanics/value/matrix/eigenvalues
         mechanics/value/matrix/matrix
         mechanics/value/matrix/unsure-digits
         mechanics/value/structure
         "../../support/checks.rkt")

(define-runtime-path table "eigenvalues.rktd")

(struct line (name LAPACK rows values))

(define lines
  (for/list ([l (in-list (call-with-input-file table
                           (lambda (port) (for/list ([l (in-port read port)]) l))))])
    (line (first l) (second l) (filter list? l) (filter number? (cddr l)))))

(define (entries l) (apply flvector (append* (line-rows l))))
(define (size-of rows) (length rows))

(define (balanced l)
  (define v (entries l))
  (define scales (balance! v (size-of (line-rows l))))
  (values (greatest v) (flvector->list scales)))

;; Pairs of a number found and a true one, the nearest first; each is in one pair.
(define (pairs found true)
  (define all
    (sort (for*/list ([(x i) (in-indexed found)] [(y j) (in-indexed true)])
            (list (magnitude (exact->inexact (- (inexact->exact x) y))) x y i j))
          < #:key first))
  (let next ([all all] [chosen '()])
    (cond [(null? all) chosen]
          [(for/or ([c chosen]) (or (eqv? (fourth c) (fourth (car all)))
                                    (eqv? (fifth c) (fifth (car all)))))
           (next (cdr all) chosen)]
          [else (next (cdr all) (cons (car all) chosen))])))

(define (in-indexed xs) (in-parallel xs (in-naturals)))

(define (relative-error pair size)
  (define true (magnitude (exact->inexact (third pair))))
  (/ (first pair) (if (= true 0.0) size true)))

(test-case "eigenvalues are as accurate as LAPACK's, matrix for matrix"
  (check-equal? (length lines) 63)
  (for ([l (in-list lines)])
    (define-values (size scales) (balanced l))
    (define found (real-matrix-eigenvalues (entries l) (size-of (line-rows l))))
    (define error
      (apply max (map (lambda (p) (relative-error p size)) (pairs found (line-values l)))))
    (check-true (<= error (* 10 (max 1e-15 (line-LAPACK l))))
                (format "~a: ~a, of LAPACK ~a" (line-name l) error (line-LAPACK l)))))

(define (matrix-of l) (apply matrix-by-rows (line-rows l)))

(test-case "where fewer than half of the digits are right, this is known, and elsewhere hardly said"
  (define alarms
    (for*/sum ([l (in-list lines)]
               [found (in-value (spectrum 'eigenvalues (matrix-of l)))]
               [pair (in-list (pairs (map sure-value found) (line-values l)))]
               #:unless (eqv? (third pair) 0))
      (define x (findf (lambda (x) (eqv? (sure-value x) (second pair))) found))
      (define error (relative-error pair 1.0))
      (define said? (few-digits? (sure-within x) (magnitude (sure-value x))))
      (when (> error 1.5e-8)
        (check-true said? (format "~a: ~a, ~a" (line-name l) pair (sure-within x))))
      (if (and said? (< error 1e-11)) 1 0)))
  (check-true (<= alarms 3) (format "~a" alarms)))

;; In coordinates in which the matrix is balanced
(test-case "the matrix turns eigenvectors into multiples, but for roundings"
  (for ([l (in-list lines)])
    (define m (matrix-of l))
    (define-values (size scales) (balanced l))
    (define (largest v)
      (for/fold ([most 0.0]) ([x (in-list (structure->list v))] [s (in-list scales)])
        (max most (/ (magnitude x) s))))
    (for* ([e (in-list (eigenvectors m))] [v (in-list (cdr e))])
      (check-true (<= (largest (g:- (g:* m v) (g:* (car e) v)))
                      (* 1e-14 (length scales) size (largest v)))
                  (format "~a: ~a" (line-name l) e)))))

(test-case "those that are simple have a vector each"
  (for ([l (in-list lines)])
    (define values (line-values l))
    (define (alone? x)
      (for/and ([y (in-list (remq x values))]) (> (magnitude (- x y)) (* 1e-3 (magnitude x)))))
    (when (andmap alone? values)
      (check-equal? (map length (eigenvectors (matrix-of l))) (map (lambda (x) 2) values)
                    (line-name l)))))

(test-case "units of coordinates: each of three vectors comes"
  (define chain (matrix-by-rows '(1.0 1e5 0.0) '(1e-5 1.0 1e5) '(0.0 1e-5 1.0)))
  (define found (eigenvectors chain))
  (check-within (map car found) (list (- 1 (sqrt 2)) 1.0 (+ 1 (sqrt 2))) 1e-14)
  (for ([e (in-list found)] [middle (list (- (sqrt 2)) 0.0 (sqrt 2))])
    (define v (structure->list (cadr e)))
    (check-= (/ (second v) (first v)) (* 1e-5 middle) 1e-19)))

(test-case "two rows: an eigenvalue that is double but for the last digits has half of them"
  ;; (3.3 - x) (1.3 - x) + 1, whose discriminant (3.3 - 1.3)² - 4 is not 0 in flonums
  (define m (matrix-by-rows '(3.3 1.0) '(-1.0 1.3)))
  (define-values (a d) (values (inexact->exact 3.3) (inexact->exact 1.3)))
  (define root (sqrt (exact->inexact (- (* (- a d) (- a d)) 4))))
  (check-false (= root 0))
  (for ([x (in-list (eigenvalues m))] [y (list (/ root 2) (/ root -2))])
    (check-= (magnitude (- x (+ (/ (exact->inexact (+ a d)) 2) y))) 0.0 1e-15)))
