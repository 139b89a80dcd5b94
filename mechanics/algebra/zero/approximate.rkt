#lang racket/base
;; Complex values with a bound, to first order, on their rounding error.
;;
;; Of expressions in which a complex number stands; values of others are certified by balls.
;; A value is a pair (number . error), the true value being within `error` of
;; the number: exact arithmetic has error 0, a flonum that was given may be the
;; result of a few operations on others, such as (square (sqrt 2)), and is taken
;; to be uncertain by a few units in its last place, and every operation passes errors on to
;; first order and adds its own rounding.  So "not zero" can be told from
;; "zero within rounding".

(require "../ball/ball-tape.rkt"
         "../expression/exact-numbers.rkt" "../expression/operation.rkt" "../expression/pi.rkt"
         "../../numeric/constants.rkt" "../../numeric/finite-number.rkt")

(provide approximate-tape)

;; Exact numbers of more bits than these become flonums: powers of powers
;; would not fit into memory.
(define bit-limit 2000)

;; lookup : as for evaluate-expression, giving plain numbers.
;; -> number and error; the number is not finite where e is not defined.
;; Raises exn:fail:contract:divide-by-zero as the operations on numbers do.
(define (approximate-tape t lookup)
  (define result (evaluate-tape t (lambda (e head args) (item-value e head args lookup))))
  (values (car result) (cdr result)))

(define (item-value e head args lookup)
  (cond [(operation? head) (approximate head args)]
        [head (plain (lookup e (map bare args)))]
        [(pi-symbol? e) (constant (pi-flonum e))]
        [(symbol? e) (plain (lookup e '()))]
        [else (constant e)]))

(define (plain x) (cons x 0))
(define (constant x) (cons x (if (exact? x) 0 (* 4.0 epsilon (magnitude x)))))

;; Of the angle of a point whose coordinates are not real.
(define undefined (cons +nan.0 +nan.0))

;; The value alone, of tuples too.
(define (bare v)
  (if (symbol? (car v)) (cons (car v) (map bare (cdr v))) (car v)))

(define (rounded x bound)
  (cond [(fixnum? x) (cons x bound)]
        [(not (exact? x)) (cons x (+ bound (* epsilon (magnitude x))))]
        [(<= (bits x) bit-limit) (cons x bound)]
        [else
         (define y (exact->inexact x))
         (cons y (+ bound (* epsilon (magnitude y))))]))

(define (bits x) (+ (rational-bits (real-part x)) (rational-bits (imag-part x))))

;; ---------------------------------------------------------------------------

(define (approximate op args)
  (define f (operation-numeric op))
  (cond [(not f) (cons (operation-name op) args)]
        [(eq? op op:+) (for/fold ([s (car args)]) ([a (in-list (cdr args))]) (add + s a))]
        [(eq? op op:-) (add - (car args) (cadr args))]
        [(eq? op op:*) (for/fold ([p (car args)]) ([a (in-list (cdr args))]) (multiply p a))]
        [(eq? op op:/) (divide (car args) (cadr args))]
        [(and (eq? op op:expt) (enormous? (caar args) (caadr args)))
         (approximate op (cons (inexact (car args)) (cdr args)))]
        [(and (eq? op op:atan) (pair? (cdr args)) (ormap not-real? (map car args))) undefined]
        [else
         (define value (apply f (map car args)))
         (define used (if (exact? value) args (map as-flonum args)))
         (rounded value (propagated op (map car used) (map cdr used) value))]))

;; An exact number beside a flonum is rounded first.
(define (add f a b)
  (define-values (x y)
    (if (eq? (exact? (car a)) (exact? (car b))) (values a b) (values (as-flonum a) (as-flonum b))))
  (rounded (f (car x) (car y)) (+ (cdr x) (cdr y))))

;; As it is, where a flonum holds it, and where none is as great.
(define (as-flonum a)
  (define x (exact->inexact (car a)))
  (if (or (= x (car a)) (not (< (magnitude x) +inf.0))) a (inexact a)))

(define (multiply a b)
  (rounded (* (car a) (car b))
           (+ (* (magnitude (car a)) (cdr b))
              (* (magnitude (car b)) (cdr a))
              (* (cdr a) (cdr b)))))

(define (divide a b)
  (define q (/ (car a) (car b)))
  (define room (- (magnitude (car b)) (cdr b)))
  (rounded q (if (positive? room)
                 (/ (+ (cdr a) (* (magnitude q) (cdr b))) room)
                 +inf.0)))

;; Would the power be an exact number of too many bits?
(define (enormous? base n)
  (and (exact? base) (exact? n) (real? n)
       (not (memv base '(0 1 -1)))
       (> (* (bits base) (abs n)) bit-limit)))

(define (inexact a) (rounded (exact->inexact (car a)) (cdr a)))

;; The error of value = op(xs) due to those of xs: |derivative| · error.
(define (propagated op xs errors value)
  (cond [(andmap (lambda (e) (eqv? e 0)) errors) 0]
        [(and (memq op (list op:sin op:cos op:tanh op:abs)) (andmap real? xs)) (apply + errors)]
        [else
         (for/sum ([e (in-list errors)] [k (in-naturals)] #:unless (eqv? e 0))
           (* e (slope op xs k value)))]))

;; A bound for the derivative by argument k, from a difference quotient, with
;; room for its change over the error.
(define (slope op xs k value)
  (define h (* 1e-6 (max 1.0 (magnitude (list-ref xs k)))))
  (define (at dx)
    (define moved (for/list ([y (in-list xs)] [i (in-naturals)]) (if (eqv? i k) (+ y dx) y)))
    (magnitude (- (apply (operation-numeric op) moved) value)))
  (* 2.0 (/ (max (at h) (at (- h))) h)))
