#lang racket/base
;; Values of expressions with bounds on their errors, by an evaluator that shares
;; nothing with the algebra under test.
;;
;; A value is a pair (number . error); every operation passes errors on to first
;; order and adds its own rounding.  Numbers are bigfloats of 200 bits where the
;; library for them is there, flonums elsewhere, with errors that are as much
;; larger.  Everything is real: where an operation is not defined, or is so close
;; to where it is not that the error cannot tell, there is no value.
;;
;; A point is an integer.  It gives every symbol a number of a size between 0.3 and
;; 2.3, positive if the point is odd, of either sign if it is even; and every literal
;; function, and each of its derivatives, a smooth function of its own, so that equal
;; arguments give equal values.

(require mechanics/algebra/expression/expression
         mechanics/algebra/expression/operation)

(provide value-at-point value-with differ? agree? precise?)

;; ---------------------------------------------------------------------------
;; Two kinds of numbers

(struct numbers (unit from to-flonum table) #:authentic)

(define names
  '(+ - * / sqrt exp log sin cos tan asin acos atan sinh cosh tanh abs expt atan2))

(define (make-numbers unit from to-flonum procedures)
  (numbers unit from to-flonum (for/hasheq ([n (in-list names)] [p (in-list procedures)])
                                 (values n p))))

(define (flonum-numbers)
  (define (e x) (exp x))
  (define (sinh x) (/ (- (e x) (e (- x))) 2))
  (define (cosh x) (/ (+ (e x) (e (- x))) 2))
  (make-numbers (expt 2.0 -48) real->double-flonum values
                (list + - * / sqrt exp log sin cos tan asin acos atan
                      sinh cosh (lambda (x) (/ (sinh x) (cosh x))) abs expt atan)))

(define (bigfloat-numbers)
  (define (big name) (dynamic-require 'math/bigfloat name))
  ((big 'bf-precision) 200)
  ((big 'bf+) ((big 'bf) 1) ((big 'bf) 2))
  (make-numbers (expt 2.0 -195) (big 'bf) (big 'bigfloat->flonum)
                (map big '(bf+ bf- bf* bf/ bfsqrt bfexp bflog bfsin bfcos bftan bfasin bfacos
                           bfatan bfsinh bfcosh bftanh bfabs bfexpt bfatan2))))

;; Without the shared library bigfloats cannot be made.
(define N
  (with-handlers ([exn:fail? (lambda (x) (flonum-numbers))])
    (bigfloat-numbers)))

(define unit (numbers-unit N))
(define precise? (< unit 1e-40))
(define (number x) (hash-ref! made x (lambda () ((numbers-from N) x))))
(define made (make-weak-hash))       ; exact rational -> number, for few occur, and often
(define (flonum x) ((numbers-to-flonum N) x))
(define (compute name . xs) (apply (hash-ref (numbers-table N) name) xs))

;; ---------------------------------------------------------------------------
;; Values

(define undefined (make-parameter #f))
(define (no-value) ((undefined) #f))

(define (make x error)
  (define f (flonum x))
  (unless (and (rational? f) (< (abs f) 1e60) (rational? error)) (no-value))
  (cons x (+ error (* unit (abs f)))))

(define (size v) (abs (flonum (car v))))
(define (margin v) (- (size v) (cdr v)))      ; positive if its sign is known
(define (positive v)
  (unless (and (> (margin v) 0) (> (flonum (car v)) 0)) (no-value))
  v)
(define (nonzero v)
  (unless (> (margin v) 0) (no-value))
  v)

(define (constant c)
  (unless (and (real? c) (rational? c)) (no-value))
  (make (number (inexact->exact c)) (if (exact? c) 0.0 (* 4e-16 (abs c)))))

(define (sum u v) (make (compute '+ (car u) (car v)) (+ (cdr u) (cdr v))))
(define (difference u v) (make (compute '- (car u) (car v)) (+ (cdr u) (cdr v))))
(define (product u v)
  (make (compute '* (car u) (car v))
        (+ (* (size u) (cdr v)) (* (size v) (cdr u)) (* (cdr u) (cdr v)))))
(define (quotient* u v)
  (define q (compute '/ (car u) (car (nonzero v))))
  (make q (/ (+ (cdr u) (* (abs (flonum q)) (cdr v))) (margin v))))

(define (power u v)
  (define n (car v))
  (cond [(and (eqv? (cdr v) 0.0) (eqv? 0.0 (flonum n))) (constant 1)]
        [(integer-power v) => (lambda (k) (repeated u k))]
        [else
         (define p (compute 'expt (car (positive u)) n))
         (define s (abs (flonum p)))
         (make p (+ (/ (* s (abs (flonum n)) (cdr u)) (margin u))
                    (* s (abs (log (size u))) (cdr v))))]))

(define (integer-power v)
  (define x (flonum (car v)))
  (and (integer? x) (< (abs x) 200)
       (eqv? 0.0 (flonum (compute '- (car v) (number (inexact->exact x)))))
       (inexact->exact x)))

(define (repeated u k)
  (cond [(negative? k) (quotient* (constant 1) (repeated u (- k)))]
        [(eqv? k 0) (constant 1)]
        [else (product u (repeated u (- k 1)))]))

;; The function of one argument called so, with a bound for its derivative.
(define (function name u)
  (define x (flonum (car u)))
  (define (apply-with slope)
    (make (compute name (car u)) (* 1.01 (abs slope) (cdr u))))
  (case name
    [(sqrt) (positive u) (apply-with (/ 0.5 (sqrt (margin u))))]
    [(log) (positive u) (apply-with (/ 1 (margin u)))]
    [(exp sinh cosh) (when (> (abs x) 100) (no-value)) (apply-with (exp (abs x)))]
    [(sin cos atan tanh abs) (apply-with 1)]
    [(tan) (define c (cos x)) (when (< (abs c) 1e-3) (no-value)) (apply-with (/ 1 (* c c)))]
    [(asin acos) (define room (- 1 (* x x)))
                 (when (< room 1e-6) (no-value))
                 (apply-with (/ 1 (sqrt room)))]
    [else (error 'function "unknown: ~a" name)]))

(define (arc y x)
  (define r (+ (* (size x) (size x)) (* (size y) (size y))))
  (when (and (< (flonum (car x)) 0) (<= (margin y) 0)) (no-value))
  (when (< r 1e-12) (no-value))
  (make (compute 'atan2 (car y) (car x))
        (* 1.01 (/ (+ (* (size x) (cdr y)) (* (size y) (cdr x))) r))))

;; ---------------------------------------------------------------------------
;; Points

;; A rational between 0 and 1 that depends on the text and the point.
(define (scatter text point)
  (define h
    (for/fold ([h (+ 99991 (* 7919 point))]) ([c (in-string text)])
      (modulo (+ (* 69069 (bitwise-xor h (char->integer c))) 12345) 4294967296)))
  (define g (modulo (* 2654435761 (bitwise-xor h (arithmetic-shift h -13))) 4294967296))
  (/ (quotient g 65536) 65536))

(define (symbol-value s point)
  (define text (symbol->string s))
  (define size (+ 3/10 (* 2 (scatter text point))))
  (constant (if (and (even? point) (< (scatter text (- point)) 1/2)) (- size) size)))

;; 3/2 + sin(Σ kᵢ xᵢ + φ), which is never negative.
(define (application-value head arguments point)
  (define text (format "~s" (head->datum head)))
  (define angle
    (for/fold ([angle (constant (* 6 (scatter text point)))])
              ([x (in-list (flatten-arguments arguments))] [i (in-naturals)])
      (sum angle (product x (constant (+ 1 (scatter (format "~a ~a" text i) point)))))))
  (sum (constant 3/2) (function 'sin angle)))

(define (flatten-arguments xs)
  (apply append
         (for/list ([x (in-list xs)])
           (if (symbol? (car x)) (flatten-arguments (cdr x)) (list x)))))

;; ---------------------------------------------------------------------------
;; Expressions

;; -> (number . error), or #f where e has no value.
(define (value-at-point e point)
  (value-with e
              (lambda (s) (symbol-value s point))
              (lambda (n arguments) (application-value (node-head n) arguments point))))

;; The same with values for symbols and for literal functions applied.
(define (value-with e symbol application)
  (let/ec return
    (parameterize ([undefined return])
      (node-fold e
                 (lambda (leaf)
                   (cond [(eq? leaf ':pi) (product (constant 4) (function 'atan (constant 1)))]
                         [(symbol? leaf) (symbol leaf)]
                         [else (constant leaf)]))
                 (lambda (n args)
                   (define head (node-head n))
                   (if (literal-head? head)
                       (application n args)
                       (operation-value (operation-name head) args)))))))

(define (operation-value name args)
  (case name
    [(+) (for/fold ([s (car args)]) ([a (in-list (cdr args))]) (sum s a))]
    [(*) (for/fold ([p (car args)]) ([a (in-list (cdr args))]) (product p a))]
    [(-) (difference (car args) (cadr args))]
    [(/) (quotient* (car args) (cadr args))]
    [(expt) (power (car args) (cadr args))]
    [(atan) (if (null? (cdr args)) (function 'atan (car args)) (arc (car args) (cadr args)))]
    [(up down) (cons name args)]
    [else (function name (car args))]))

;; ---------------------------------------------------------------------------
;; Comparison

(define (gap u v) (abs (flonum (compute '- (car u) (car v)))))

;; Surely different, or equal as far as the errors tell.
(define (differ? u v) (> (gap u v) (+ 1e-300 (* 16 (+ (cdr u) (cdr v))))))
(define (agree? u v) (not (differ? u v)))
