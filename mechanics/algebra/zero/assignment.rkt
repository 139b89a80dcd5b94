#lang racket/base
;; Numbers for leaves: each symbol has one, each literal function one for each argument.
;;
;; A literal function stands for a polynomial in all its arguments, and there is one that has,
;; with each of its derivatives, any values wanted at finitely many points.  So the values are
;; free, but for this: at equal arguments they are equal.  Arguments known as balls that overlap
;; count as equal, which is no mistake if they differ by less than is seen; if one overlaps with
;; two that have different values, this is no place to look for a value.

(require "../ball/ball.rkt" "../ball/ball-value.rkt"
         "../expression/expression.rkt" "../expression/operation.rkt")

(provide make-assignment assigned integers-from fractions-from)

;; symbols : symbol -> number
;; applications : (name . index) -> ((arguments . number) ...)
(struct assignment (symbols applications) #:authentic)

(define (make-assignment) (assignment (make-hasheq) (make-hash)))

;; The number of the leaf with these values of its arguments: (choose), the first time.
(define (assigned a leaf arguments choose)
  (if (symbol? leaf)
      (hash-ref! (assignment-symbols a) leaf choose)
      (application-value (assignment-applications a) (function-key leaf) arguments choose)))

(define (function-key leaf)
  (define head (node-head leaf))
  (cons (literal-head-name head) (literal-head-index head)))

(define (application-value applications key arguments choose)
  (define known (hash-ref applications key '()))
  (define (record! value)
    (hash-set! applications key (cons (cons arguments value) known))
    value)
  (define same (filter (lambda (k) (all-overlap? (car k) arguments)) known))
  (cond [(null? same) (record! (choose))]
        [(for/or ([s (in-list (cdr same))]) (not (eqv? (cdr s) (cdar same)))) (raise unknown)]
        [(member arguments (map car same)) (cdar same)]
        [else (record! (cdar same))]))

(define (all-overlap? xs ys)
  (and (eqv? (length xs) (length ys)) (andmap values-overlap? xs ys)))

;; ---------------------------------------------------------------------------
;; Where numbers come from: always the same ones

;; The k-th source of small integers, by a linear congruence: positive ones for
;; k not negative, of either sign for k negative.
(define (integers-from k)
  (define n (abs k))
  (define range (cond [(< n 2) 3] [(< n 6) 5] [else 11]))
  (numbers-from k (lambda (i place) (+ 1 (modulo i range)))))

;; The same of small fractions, for where integers are out of the domain: those below 1 for
;; small k.  The first leaf has each of them in turn.
(define (fractions-from k)
  (define range (if (< (abs k) below-one) below-one (vector-length fractions)))
  (define (fraction i place)
    (vector-ref fractions (modulo (if (eqv? place 0) (abs k) i) range)))
  (numbers-from k fraction))

(define fractions (vector 1/2 3/5 1/3 4/5 1/4 1/10 2/3 7/4 5/2 4/3 1/1000 1000))
(define below-one 7)

;; number : of a random integer and of how many numbers there were before
(define (numbers-from k number)
  (define state (+ 12345 (* 7919 (abs k))))
  (define place -1)
  (lambda ()
    (set! state (modulo (+ (* 1103515245 state) 12345) 2147483648))
    (set! place (+ place 1))
    (define x (number (quotient state 65536) place))
    (if (and (negative? k) (odd? (quotient state 1048576))) (- x) x)))
