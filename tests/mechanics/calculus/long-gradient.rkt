#lang racket/base
;; Gradients of long runs: on tapes of many blocks, and of tuples the components of which are made
;; when they are asked for.

(require mechanics/generic/arithmetic
         mechanics/generic/elementary
         mechanics/generic/sums-and-products
         mechanics/value/structure
         mechanics/value/vector
         mechanics/calculus/derivative
         mechanics/calculus/gradient
         "../support/checks.rkt" "../support/close.rkt")

(define n 40000)                ; so that the tape takes several blocks
(define point (s:generate n 'up (lambda (i) (+ 0.5 (/ (modulo (* 7919 i) 1000) 1000.0)))))

(define (sum-of-squares s) (g:for/sum ([x s]) (g:square x)))
(define (products s)
  (g:for/sum ([i (in-range (sub1 (tuple-vector-length s)))])
    (g:* (tuple-vector-ref s i) (tuple-vector-ref s (add1 i)))))

(define (x k) (if (< -1 k n) (vector-ref (structure-elements point) k) 0))
(define (twice i) (* 2 (x i)))
(define (neighbours i) (+ (x (sub1 i)) (x (add1 i))))

(define (check-components slope expected)
  (check-true (down? slope))
  (check-equal? (s:length slope) n)
  (check-true (for/and ([d slope] [i (in-naturals)]) (close? d (expected i)))))

(test-case "however the function walks along the tuple"
  (check-components ((gradient sum-of-squares) point) twice)
  (check-components ((gradient g:square) point) twice)
  (check-components ((gradient (lambda (s) (g:for/sum ([i n]) (g:square (ref s i))))) point) twice)
  (check-components ((gradient (lambda (s) (g:for/sum ([i n]) (g:square (ref s (- -1 i)))))) point)
                    twice)
  (check-components ((gradient (lambda (s) (s:fold (lambda (x sum) (g:+ sum (g:square x))) 0 s)))
                     point)
                    twice)
  (check-components ((gradient (lambda (s) (g:* 1/2 (g:* (flip (g:* 2 s)) s)))) point) twice)
  (check-components ((gradient products) point) neighbours)
  (check-components ((gradient products) (structure->vector point)) neighbours))

(test-case "a component asked for twice is the same quantity"
  (define (f s)
    (define known (make-hash))
    (define (remembered x) (hash-ref! known x (lambda () (g:square x))))
    (check-equal? (ref s 3) (tuple-vector-ref s 3))
    (check-not-equal? (ref s 3) (ref s 4))
    (g:* (remembered (ref s 3)) (remembered (tuple-vector-ref s 3))))
  (check-equal? (ref ((gradient f) point) 3) (* 4 (x 3) (* (x 3) (x 3))))
  (check-exn #rx"vector-ref: index is out of range"
             (lambda () ((gradient (lambda (s) (tuple-vector-ref s n))) point)))
  (check-exn #rx"vector-ref: contract violation"
             (lambda () ((gradient (lambda (s) (tuple-vector-ref s -1))) point)))
  (check-exn #rx"ref: index 40000 is outside an up tuple of 40000"
             (lambda () ((gradient (lambda (s) (ref s n))) point))))

(test-case "a vector that the function changes"
  (define v (structure->vector point))
  (define (f s) (vector-set! v 1 'gone) (products s))
  (check-components ((gradient f) v) neighbours))

(test-case "what the value does not depend on has derivative 0"
  (define slope ((gradient (lambda (s) (sum-of-squares s) (g:exp (ref s 7)))) point))
  (check-equal? (for/sum ([d slope]) (if (eqv? d 0) 1 0)) (sub1 n))
  (check-true (close? (ref slope 7) (exp (x 7))))
  (define (half s) (sum-of-squares s) (g:for/sum ([x s] [i (/ n 2)]) x))
  (define of-half ((gradient half) point))
  (check-equal? (for/list ([d of-half] [i n] #:unless (eqv? d (if (< i (/ n 2)) 1.0 0))) i) '()))

(test-case "one gradient within another, after an early exit, and in two threads at once"
  (define direction (s:generate n 'up (lambda (i) (/ i 1.0 n))))
  (define (along i) (/ (+ (if (> i 0) (sub1 i) 0) (if (< i (sub1 n)) (add1 i) 0)) 1.0 n))
  (check-components ((Hessian-vector-product products) point direction) along)
  (define (nested s)
    (define slope ((gradient sum-of-squares) point))
    (g:* (ref slope 5) (products s) (ref ((gradient products) point) 5)))
  (check-components ((gradient nested) point)
                    (lambda (i) (* 2 (x 5) (neighbours 5) (neighbours i))))
  (let/ec leave ((gradient (lambda (s) (leave (products s)))) point))
  (check-exn #rx"stop" (lambda () ((gradient (lambda (s) (products s) (error "stop"))) point)))
  (define channels
    (for/list ([f (list sum-of-squares products)])
      (define c (make-channel))
      (thread (lambda () (channel-put c (for/last ([_ 5]) ((gradient f) point)))))
      c))
  (for ([c channels] [expected (list twice neighbours)])
    (check-components (channel-get c) expected)))

(test-case "numbers that escape from a run are numbers still, and disturb no other"
  (define escaped #f)
  (define (f s) (set! escaped (products s)) escaped)
  (check-components ((gradient f) point) neighbours)
  (define (with-strangers s)
    (for ([_ 10000]) (g:* escaped (g:+ escaped 1.0)))
    (products s))
  (check-components ((gradient with-strangers) point) neighbours)
  (check-true (close? ((D (lambda (t) (g:* t 2))) 1.0) 2.0)))

;; A run that is entered again gives another gradient.
(define (enter-twice point)
  (define again #f)
  (define times 0)
  (define (f s)
    (define factor (let/cc k (set! again k) 1.0))
    (g:* factor (products s)))
  (define slope ((gradient f) point))
  (set! times (add1 times))
  (if (= times 1) (again 2.0) slope))

(test-case "a run that is entered again by a continuation"
  (check-equal? (enter-twice (up 2.0 3.0)) (down 6.0 4.0))
  (check-components (enter-twice point) (lambda (i) (* 2 (neighbours i)))))
