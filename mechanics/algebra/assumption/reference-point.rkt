#lang racket/base
;; The reference point of a question: where a sign that nothing decides is looked up.
;;
;; √(u²) is u or -u.  If domain, declarations and the real numbers leave that open, the
;; sign of u at one fixed point is taken, and told as an assumption.  All signs of one answer
;; are taken at one point, where the question has a value and the declarations hold: so no
;; sign contradicts another, or a declaration.
;;
;; The first point tried gives numbers between 1 and π/2 to all symbols, the first of the
;; alphabet the greatest: lengths and masses are positive there, and sines and cosines of
;; angles.  Then others are tried, points with positive numbers first, always in one order.

(require racket/list
         "assumption-set.rkt" "interval.rkt" "leaf-bounds.rkt" "signs.rkt"
         "../expression/expression.rkt"
         "../expression/operation.rkt" "../expression/order.rkt" "../expression/pi.rkt"
         "../expression/symbols.rkt"
         "../../error/computed-once.rkt" "../../error/refusal.rkt")

(provide find-reference at-common-reference
         reference-sign holds-at? real-value leaves-of concerning)

;; expressions : those of the question; A : assumptions
;; value? : lookup -> does the question have a value there?
;; -> lookup: leaf arguments -> number, or #f if no point was found
(define (find-reference expressions A [value? (lambda (lookup) (all-real? expressions lookup))])
  (define domain (assumptions-domain A))
  (define leaves (leaves-of (append expressions domain)))
  (define relations (concerning leaves (assumptions-relations A)))
  (define table (bounds-from relations))
  (define (there? lookup)
    (and (for/and ([r (in-list relations)]) (holds-at? r lookup))
         (all-real? domain lookup)
         (value? lookup)))
  (for/or ([k (in-range most-points)])
    (define lookup (make-lookup leaves table k))
    (and (there? lookup) lookup)))

;; A for each of several expressions that are asked about together, so that their signs are
;; taken at one point, if there is one where all have a value.
(define (at-common-reference A expressions)
  (with-reference A (once (lambda () (find-reference expressions A)))))

(define (all-real? expressions lookup)
  (for/and ([e (in-list expressions)]) (real-value e lookup)))

(define most-points 200)

;; 1 or -1, or #f where e is 0, as far as rounding lets one see, or has no value
(define (reference-sign e lookup)
  (define x (real-value e lookup))
  (cond [(not x) #f]
        [(> x distinct) 1]
        [(< x (- distinct)) -1]
        [else #f]))

(define distinct 1e-9)

(define (holds-at? r lookup)
  (define x (real-value (relation-expression r) lookup))
  (and x (signs-within? (number-signs x) (relation-signs r))))

;; ---------------------------------------------------------------------------
;; Values

;; A flonum, or #f where something in e is not real or not finite.
(define (real-value e lookup)
  (let/ec return
    (define (real x) (if (rational? x) x (return #f)))
    (define (leaf-value leaf)
      (cond [(unknown? leaf) (lookup leaf '())]
            [(symbol? leaf) (pi-flonum leaf)]
            [(exact-integer? leaf) leaf]
            [else (real->double-flonum (real leaf))]))
    (define (node-value n parts)
      (define head (node-head n))
      (cond [(literal-head? head) (lookup n parts)]
            [(operation-numeric head) => (lambda (f) (real (apply f parts)))]
            [else (cons (operation-name head) parts)]))
    (if-raised divided-by-zero? #f
      (exact->inexact (node-fold e leaf-value node-value)))))

;; ---------------------------------------------------------------------------
;; Points

;; -> table: leaf -> its place among the symbols and literal functions applied, in order
(define (leaves-of expressions)
  (define compare (make-order))
  (define found (make-hash))
  (for ([e (in-list expressions)])
    (node-fold e
               (lambda (leaf) (when (unknown? leaf) (hash-set! found leaf #t)))
               (lambda (n parts) (when (unknown? n) (hash-set! found n #t)))))
  (for/hash ([leaf (in-list (sort (hash-keys found) (lambda (a b) (< (compare a b) 0))))]
             [i (in-naturals)])
    (values leaf i)))

;; The relations that speak of one of the leaves, or of a leaf that such a relation speaks of.
(define (concerning leaves relations)
  (define (leaves-in r) (hash-keys (leaves-of (list (relation-expression r)))))
  (let loop ([known leaves] [chosen '()] [rest relations])
    (define (known? l) (hash-ref known l #f))
    (define-values (more others) (partition (lambda (r) (ormap known? (leaves-in r))) rest))
    (if (null? more)
        chosen
        (loop (for*/fold ([known known]) ([r (in-list more)] [l (in-list (leaves-in r))])
                (hash-set known l #t))
              (append more chosen)
              others))))

;; The k-th point.  A literal function has one value for one argument.
(define (make-lookup leaves table k)
  (define seen (make-hash))
  (define (lookup leaf arguments)
    (hash-ref! seen (leaf-key leaf arguments)
               (lambda ()
                 (define i (hash-ref leaves leaf (lambda () (+ 1000 (hash-count seen)))))
                 (within (bounds-of table leaf) (coordinate k i)))))
  lookup)

(define (leaf-key leaf arguments)
  (if (symbol? leaf)
      leaf
      (list (literal-head-name (node-head leaf)) (literal-head-index (node-head leaf))
            (rounded arguments))))

;; Values that differ by rounding alone are one.
(define (rounded x)
  (cond [(pair? x) (cons (rounded (car x)) (rounded (cdr x)))]
        [(rational? x) (/ (round (* 1e10 x)) 1e10)]
        [else x]))

;; x brought to where it may be
(define (within r x)
  (define-values (low high) (interval-ends r))
  (cond [(and (rational? low) (rational? high))
         (+ low (* (- high low) (/ (abs x) (+ 1.0 (abs x)))))]
        [(rational? low) (+ low (abs x))]
        [(rational? high) (- high (abs x))]
        [else x]))

;; The i-th coordinate of the k-th point.
(define (coordinate k i)
  (if (eqv? k 0)
      (+ 1.0 (/ 5.0 (+ 11.0 (* 7.0 i))))
      (let* ([a (scattered (seed k (+ (* 1009 k) (* 31 i))))]
             [b (scattered (seed k (+ 17 (* 2003 k) (* 57 i))))]
             [size (* (scale k) (exp (* (spread k) (- (* 2.0 a) 1.0))))])
        (if (negative-there? k i b) (- size) size))))

;; All are positive first, then all but every sixth, then it is a matter of chance.
(define (negative-there? k i chance)
  (cond [(<= k last-positive) #f]
        [(<= k last-mostly-positive) (eqv? (remainder k 6) (remainder i 6))]
        [else (< chance 0.5)]))

(define last-positive 60)
(define last-mostly-positive 108)

;; How far from 1, as a logarithm, the numbers of the k-th point may be.
(define (spread k)
  (case (remainder k 4) [(0 1) 1.0] [(2) 3.0] [else 7.0]))

;; The last points have small numbers, as speeds are in units of that of light, and independent
;; ones: seeds in a row, as before, give numbers that differ by the same, modulo 1, and never three
;; whose squares have a sum below 1.
(define (scale k) (if (< k last-dependent) 1.0 0.25))
(define (seed k n) (if (< k last-dependent) n (* n n)))

(define last-dependent 160)

;; A number between 0 and 1 that depends on n in no simple way.
(define (scattered n)
  (define x (modulo (+ (* 1103515245 (modulo (+ (* 22695477 n) 1) 2147483648)) 12345) 2147483648))
  (/ (modulo (quotient x 64) 65536) 65536.0))
