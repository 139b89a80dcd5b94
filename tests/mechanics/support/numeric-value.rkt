#lang racket/base
;; The oracle for expressions: their value at a point.
;;
;; A point gives numbers to symbols and to literal functions; it follows from a
;; number that seeds it and from the names alone, so that two expressions that
;; mean the same get the same value.  A literal function F is taken to be
;;
;;   F(x) = e^{a·x} + c e^{b·x},
;;
;; summed over all scalars x of its arguments, which makes all its partial
;; derivatives known: each brings down its factor a or b.

(require mechanics/algebra/expression/expression
         mechanics/algebra/expression/operation
         mechanics/algebra/expression/pi)

(provide numeric-value symbol-value)

(define (numeric-value e point)
  (node-fold e
             (lambda (leaf)
               (cond [(number? leaf) leaf]
                     [(pi-symbol? leaf) (pi-flonum leaf)]
                     [else (symbol-value leaf point)]))
             (lambda (n args)
               (define head (node-head n))
               (cond [(literal-head? head) (literal-value head args point)]
                     [(eq? head op:up) (cons 'up args)]
                     [(eq? head op:down) (cons 'down args)]
                     [else (apply (operation-numeric head) args)]))))

;; Between 0.3 and 1.3: within the domain of asin is not promised.
(define (symbol-value name point) (+ 0.3 (fraction name point)))

;; A number in [0, 1) made from the name.
(define (fraction key point)
  (define bytes (string->bytes/utf-8 (format "~s" key)))
  (define h
    (for/fold ([h (+ 1009 (* 7919 point))]) ([b (in-bytes bytes)])
      (modulo (+ (* h 1103515245) (* 12345 b) 777) 2147483647)))
  (/ (exact->inexact h) 2147483647.0))

;; ---------------------------------------------------------------------------
;; Literal functions

(define (literal-value head args point)
  (define name (literal-head-name head))
  (define index (literal-head-index head))
  (define leaves (argument-leaves args))
  (+ (exponential name 'a index leaves point)
     (* (fraction (list name 'c) point) (exponential name 'b index leaves point))))

;; e^{k·x} times the factors that the derivatives bring down.
(define (exponential name which index leaves point)
  (define (rate path) (- (* 1.5 (fraction (list name which path) point)) 0.75))
  (* (exp (for/fold ([sum 0.0]) ([leaf (in-list leaves)])
            (+ sum (* (rate (car leaf)) (cdr leaf)))))
     (for/fold ([product 1.0]) ([entry (in-list index)])
       (* product (expt (rate (car entry)) (cdr entry))))))

;; ((path . number) ...), the paths as partial derivatives give them.
(define (argument-leaves args)
  (define (walk x path)
    (if (pair? x)
        (for/fold ([leaves '()]) ([e (in-list (cdr x))] [i (in-naturals)])
          (append leaves (walk e (append path (list i)))))
        (list (cons path x))))
  (if (and (pair? args) (null? (cdr args)))
      (walk (car args) '())
      (for/fold ([leaves '()]) ([a (in-list args)] [i (in-naturals)])
        (append leaves (walk a (list i))))))

;; ---------------------------------------------------------------------------

(module+ test
  (require mechanics/generic/arithmetic mechanics/generic/elementary
           mechanics/calculus/literal-function mechanics/value/signature
           "checks.rkt")

  (define (central f x)
    (define h 1e-5)
    (/ (- (f (+ x h)) (f (- x h))) (* 2 h)))

  (test-case "equal expressions have equal values, and others other ones"
    (check-= (numeric-value (g:* 'a (g:+ 'b 'c)) 1)
             (numeric-value (g:+ (g:* 'a 'b) (g:* 'a 'c)) 1) 1e-14)
    (check-false (= (numeric-value (g:sin 'a) 1) (numeric-value (g:sin 'a) 2)))
    (check-false (= (numeric-value 'a 1) (numeric-value 'b 1))))

  (test-case "the derivative of a literal function is the derivative of its value"
    (define F (literal-function 'F (-> (X Real Real) Real)))
    (define (F-at x) (numeric-value (F x 2) 3))
    (define dF (make-literal-head 'F '(((0) . 1))))
    (check-= (numeric-value (make-node dF (list 0.7 2)) 3) (central F-at 0.7) 1e-8)
    (define d2F (make-literal-head 'F '(((0) . 2))))
    (check-= (numeric-value (make-node d2F (list 0.7 2)) 3)
             (central (lambda (x) (numeric-value (make-node dF (list x 2)) 3)) 0.7) 1e-8)))
