#lang racket/base
;; Roots of functions made by the generic arithmetic: between two points where the
;; signs differ, or near a point, in any number of variables.
;;
;; Newton's method takes its derivatives from one run of the function on dual
;; numbers; those of a function that refuses them, one that integrates a motion, say,
;; from differences, f(x + h) − f(x − h) over 2h with h the cube root of the rounding
;; error, where what the formula and what rounding do wrong balance.

(require racket/flonum
         "derivative.rkt" "number.rkt"
         "../numeric/newton.rkt" "../numeric/root.rkt"
         "../value/shape.rkt")

(provide find-root)

(define who 'find-root)

;; (find-root f low high), or (find-root f start) for a start of any shape.
(define (find-root f start [high #f] #:tolerance [tolerance 1e-12] #:observe [observe void])
  (check-function-of-one-variable who f)
  (if high
      (bracketed-root (lambda (x) (number who (f x))) (number who start) (number who high)
                      #:tolerance tolerance #:observe observe)
      (root-near f start tolerance observe)))

(define (root-near f start tolerance observe)
  (define (complain x) (number who x))
  (define x (structure->flvector start complain))
  (define (argument x) (flvector->structure start x))
  (define (value x)
    (define y (structure->flvector (f (argument x)) complain))
    (check-count start y)
    y)
  (define (exact-jacobian x)
    (columns->rows (flvector-length x)
                   (structure->flvector (derivative-at f (argument x)) complain)))
  (value x)                             ; a mistake of the function's own is seen here
  (argument (newton value
                    (if (succeeds? (lambda () (exact-jacobian x)))
                        exact-jacobian
                        (difference-jacobian value))
                    x
                    #:tolerance tolerance #:observe observe #:argument argument)))

(define (check-count start y)
  (define n (shape-length start))
  (unless (= (flvector-length y) n)
    (raise-arguments-error
     who "the function must give as many numbers as it takes"
     "given" (flvector-length y)
     "expected" n
     "start" start)))

(define (succeeds? thunk)
  (with-handlers ([exn:fail? (lambda (e) #f)])
    (thunk)
    #t))

;; ---------------------------------------------------------------------------
;; Matrices of derivatives

;; v : the derivatives by the first variable, by the second, ...
(define (columns->rows n v)
  (for/vector #:length n ([i (in-range n)])
    (for/vector #:length n ([j (in-range n)]) (flvector-ref v (+ i (* j n))))))

(define ((difference-jacobian value) x)
  (define n (flvector-length x))
  (define all (make-flvector (* n n)))
  (for ([j (in-range n)])
    (define h (fl* 6e-6 (fl+ 1.0 (flabs (flvector-ref x j)))))
    (define after (value (moved x j h)))
    (define before (value (moved x j (fl- 0.0 h))))
    (for ([i (in-range n)])
      (flvector-set! all (+ i (* j n))
                     (fl/ (fl- (flvector-ref after i) (flvector-ref before i)) (fl* 2.0 h)))))
  (columns->rows n all))

(define (moved x j h)
  (define y (flvector-copy x))
  (flvector-set! y j (fl+ h (flvector-ref x j)))
  y)
