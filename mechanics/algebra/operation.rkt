#lang racket/base
;; Operations: what may stand at the head of an expression.
;;
;; An expression node `(op arg ...)` is headed either by an *operation*, a
;; function whose meaning the algebra knows (`+`, `sin`, ...), or by a
;; *literal head*, an unknown function of the user's, possibly differentiated
;; (`x`, `(D x)`, `((partial 1) F)`).  This file defines both records and the
;; operations themselves; the meaning of an operation on anything but numbers
;; (its derivative, its action on structures) belongs to the floors above.

(provide
 ;; operations
 (struct-out operation)
 op:+ op:* op:- op:/ op:expt op:sqrt op:exp op:log
 op:sin op:cos op:tan op:asin op:acos op:atan op:sinh op:cosh op:tanh op:abs
 op:up op:down
 ;; literal heads
 (struct-out literal-head)
 make-literal-head literal-head-derivative head=? head-hash head->datum)

;; numeric : number ... -> number, or #f for the uninterpreted constructors
;; `up` and `down`, which occur only inside arguments of literal functions.
(struct operation (name arity numeric)
  #:authentic)

(define-syntax-rule (define-operations [id name arity numeric] ...)
  (begin (define id (operation 'name arity numeric)) ...))

(define (cosh x) (/ (+ (exp x) (exp (- x))) 2))
(define (sinh x)
  (cond [(eqv? x 0) 0]
        [(and (real? x) (< (abs x) 1e-2))   ; Taylor: no cancellation near 0
         (let* ([x (exact->inexact x)] [s (* x x)])
           (* x (+ 1 (* (/ s 6) (+ 1 (* (/ s 20) (+ 1 (/ s 42))))))))]
        [else (/ (- (exp x) (exp (- x))) 2)]))
(define (tanh x)
  (cond [(not (real? x)) (/ (sinh x) (cosh x))]
        [(> x 20) 1.0]
        [(< x -20) -1.0]
        [else (/ (sinh x) (cosh x))]))

(define-operations
  [op:+ + #f +]
  [op:* * #f *]
  [op:- - 2 -]
  [op:/ / 2 /]
  [op:expt expt 2 expt]
  [op:sqrt sqrt 1 sqrt]
  [op:exp exp 1 exp]
  [op:log log 1 log]
  [op:sin sin 1 sin]
  [op:cos cos 1 cos]
  [op:tan tan 1 tan]
  [op:asin asin 1 asin]
  [op:acos acos 1 acos]
  [op:atan atan #f atan]                    ; (atan y) and (atan y x)
  [op:sinh sinh 1 sinh]
  [op:cosh cosh 1 cosh]
  [op:tanh tanh 1 tanh]
  [op:abs abs 1 (lambda (x) (if (real? x) (abs x) (magnitude x)))]
  [op:up up #f #f]
  [op:down down #f #f])

;; ---------------------------------------------------------------------------
;; Literal heads

;; The function called `name`, differentiated: `index` is a multi-index, a list
;; of (path . count) sorted by path.  A path says by which argument: () is the
;; only argument of a function of one real variable, (1) the second argument or
;; the second component of the only one, (1 0) the first component of that.
;; Mixed partial derivatives commute, so the order of differentiation is not
;; kept and two routes to one derivative give equal heads.
(struct literal-head (name index hash)
  #:authentic)

(define (make-literal-head name [index '()])
  (literal-head name index
                (fxmix (equal-hash-code name) (equal-hash-code index))))

(define (literal-head-derivative head path)
  (make-literal-head (literal-head-name head)
                     (index-add (literal-head-index head) path)))

(define (index-add index path)
  (cond [(null? index) (list (cons path 1))]
        [(equal? path (caar index))
         (cons (cons path (add1 (cdar index))) (cdr index))]
        [(path<? path (caar index)) (cons (cons path 1) index)]
        [else (cons (car index) (index-add (cdr index) path))]))

(define (path<? p q)
  (cond [(null? q) #f]
        [(null? p) #t]
        [(= (car p) (car q)) (path<? (cdr p) (cdr q))]
        [else (< (car p) (car q))]))

;; ---------------------------------------------------------------------------
;; Heads in general

(define (head=? a b)
  (or (eq? a b)
      (and (literal-head? a) (literal-head? b)
           (eq? (literal-head-name a) (literal-head-name b))
           (equal? (literal-head-index a) (literal-head-index b)))))

(define (head-hash h)
  (if (literal-head? h)
      (literal-head-hash h)
      (equal-hash-code (operation-name h))))

(define (fxmix a b)
  (bitwise-and (+ (* 31 (bitwise-and a #xFFFFFFFFFFF)) b) #xFFFFFFFFFFFF))

;; The S-expression of a head: `x`, `(D x)`, `((expt D 2) x)`, `((partial 1) F)`,
;; `((* (partial 0) (expt (partial 1) 2)) F)`.
(define (head->datum h)
  (cond [(operation? h) (operation-name h)]
        [(null? (literal-head-index h)) (literal-head-name h)]
        [else (list (index->datum (literal-head-index h)) (literal-head-name h))]))

(define (index->datum index)
  (define factors
    (for/list ([entry (in-list index)])
      (define d (if (null? (car entry)) 'D (cons 'partial (car entry))))
      (if (= (cdr entry) 1) d (list 'expt d (cdr entry)))))
  (if (null? (cdr factors)) (car factors) (cons '* factors)))
