#lang racket/base
;; Modes of M ẍ + K x = 0 for matrices of numbers, of unlike sizes too.
;;
;; The algorithms of numeric/ lose the slow modes beside fast ones: ω² = 10⁻⁸ is less than
;; roundings of stiffnesses of 10⁸.  Where that is so, ω² is sought again as a zero of the
;; polynomial |K − ω²M|, whose coefficients are exact numbers; and shapes by solving
;;
;;     (K − σM) y = M x
;;
;; exactly, with σ beside ω²: each solution y is nearer to the mode than x, by the distance of σ
;; from ω² over that from other modes.
;;
;; Of decimals the entries themselves are rounded, which leaves a bound of each frequency.

(require racket/list
         "../numeric/constants.rkt"
         "../numeric/linear-algebra/numeric-modes.rkt"
         "../numeric/linear-algebra/row-matrix.rkt"
         "../numeric/optimization/complex-zeros.rkt"
         "../value/matrix/row-systems.rkt" "../value/matrix/unsure-digits.rkt")

(provide refined-modes)

;; M, K : vectors of rows of real numbers, some perhaps flonums
;; -> a list of (frequency component ...), from slow to fast, or #f if M is not positive definite
(define (refined-modes who M K)
  (define found (pencil-modes M K))
  (define modes
    (cond [(not found) '()]
          [(settled? who K found) (map without-rounding found)]
          [else (exact-modes who M K found)]))
  (note-unsure who (append-map unsure-frequency modes) "exact numbers leave all digits")
  (and found
       (for/list ([m (in-list modes)])
         (frequency+shape (mode-square m) (mode-within m) (mode-shape m)))))

;; Are all frequencies known that are not 0, as exactly so many are as K has directions without a
;; force?
(define (settled? who K found)
  (define-values (zeros others) (partition zero-mode? found))
  (and (andmap (lambda (m) (<= (mode-within m) (* 1e-10 (abs (mode-square m))))) others)
       (or (null? zeros)
           (= (length zeros) (- (length found) (rows-rank who K (rows-map inexact->exact K)))))))

(define (without-rounding m) (if (zero-mode? m) (mode 0.0 0.0 (mode-shape m)) m))

(define (zero-mode? m) (<= (abs (mode-square m)) (mode-within m)))

;; Texts.  A zero within bounds, where it is not known to be one, is known to their root.
(define (unsure-frequency m)
  (define-values (square within) (values (abs (mode-square m)) (mode-within m)))
  (cond [(= square 0.0) '()]
        [(zero-mode? m) (list (with-bound 0.0 (sqrt within)))]
        [(few-digits? within (* 2.0 square))
         (list (with-bound (sqrt (mode-square m)) (/ within (* 2.0 (sqrt square)))))]
        [else '()]))

;; ---------------------------------------------------------------------------

(define most-rows 16)                   ; of a matrix whose polynomial is sought

(define (exact-modes who M K found)
  (cond
    [(> (vector-length K) most-rows) found]
    [else
     (define-values (M* K*) (values (rows-map inexact->exact M) (rows-map inexact->exact K)))
     (define squares (exact-squares who M* K*))
     (define least (apply min 1 (filter positive? (map abs squares))))
     (define roundings (if (all-entries? exact? M K) 0.0 (* 4.0 epsilon)))
     (for/list ([square (in-list squares)] [m (in-list found)])
       (define shape (refined who M* K* (beside square least) (mode-shape m)))
       (define z (exact->inexact square))
       (mode z (if (= z 0.0) 0.0 (* roundings (mode-terms M K z shape))) shape))]))

;; The zeros of |K − zM|, from the least on: exact numbers, near to a flonum's precision, or 0
(define (exact-squares who M K)
  (define columns (rows-solve-each who M M (rows-transpose K)))
  (define coefficients (reverse (rows-characteristic (rows-transpose columns))))
  (define-values (zeros rest) (splitf-at coefficients (lambda (c) (eqv? c 0))))
  (sort (append zeros
                (for/list ([b (in-list (if (null? (cdr rest)) '() (complex-zeros rest)))])
                  (inexact->exact (real-part (bounded-zero b)))))
        <))

;; A number beside ω², and nearer to it than to others
(define (beside square least)
  (+ square (* (expt 2 -45) (if (eqv? square 0) (- least) square))))

;; From the shape x -> a better one
(define (refined who M K sigma x)
  (define A (rows-combine - K (rows-map (lambda (m) (* sigma m)) M)))
  (for/fold ([x x]) ([_ (in-range 2)])
    (define exact-x (list->vector (map inexact->exact x)))
    (define b (for/vector ([row (in-vector M)]) (dot row exact-x)))
    (unit-shape M (vector->list (rows-solve who A A b)))))

(define (dot v w) (for/sum ([x (in-vector v)] [y (in-vector w)]) (* x y)))

;; The multiple with x·M x = 1, of decimals
(define (unit-shape M x)
  (define greatest (apply max (map abs x)))
  (define y (list->vector (map (lambda (x) (/ x greatest)) x)))
  (define size (sqrt (exact->inexact (dot y (for/vector ([row (in-vector M)]) (dot row y))))))
  (for/list ([x (in-vector y)]) (/ (exact->inexact x) size)))
