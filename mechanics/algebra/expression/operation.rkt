#lang racket/base
;; Operations: the heads of expressions.
;;
;; An expression node `(op arg ...)` is headed either by an *operation*, a
;; function whose meaning the algebra knows (`+`, `sin`, ...), or by a
;; *literal head*, an unknown function of the user's, possibly differentiated
;; (`x`, `(D x)`, `((partial 1) F)`).  This file defines both records, and makes
;; the operations from the table of them; the meaning of an operation on anything
;; but numbers (its derivative, its action on structures) belongs to the floors
;; above.

(require (for-syntax racket/base "../../operation/operation-table.rkt")
         "numeric-functions.rkt"
         "../../operation/operation-column.rkt")

(provide
 ;; operations; those of the table are provided where they are defined, as op:sin
 (struct-out operation)
 op:up op:down op:solution op:component op:wrapped wrap
 operations          ; those of the table, in its order
 find-operation      ; name -> operation, or #f
 operations-where    ; (operations-where fact ...) : those of which the table says all this
 circular-functions functions-of-angles  ; these are circular and hyperbolic
 written-names       ; names of operations and of quotients by one
 ;; literal heads
 (struct-out literal-head)
 make-literal-head literal-head-derivative head=? head-hash head->datum)

;; numeric : number ... -> number, or #f for the uninterpreted constructors
;; `up` and `down`, which occur only inside arguments of literal functions.
(struct operation (name numeric)
  #:authentic)

;; The operation of an entry is op:sin, and so on.  Where two entries share a name, as those of
;; (atan y) and (atan y x), one operation serves both, and has the facts that hold for both.
(begin-for-syntax
  (define (identifier-of e context)
    (datum->syntax context (string->symbol (format "op:~a" (entry-name e)))))
  (define (heads e) (and (not (entry-fact e 'composite)) (eq? (entry-name e) (entry-key e))))
  (define (all-of-name-in? e entries)
    (for/and ([other (in-list (append (entries-where 'arithmetic) (entries-where 'function)))])
      (or (not (eq? (entry-name e) (entry-name other))) (memq other entries)))))

(define-syntax (define-operations stx)
  (syntax-case stx ()
    [(_ all)
     (with-syntax ([((id name numeric) ...)
                    (for/list ([e (in-list (filter heads (entries-where)))])
                      (list (identifier-of e stx) (entry-name e)
                            (datum->syntax stx (entry-numeric e))))])
       #'(begin
           (provide id ...)
           (define id (operation 'name numeric)) ...
           (define all (list id ...))))]))

(define-operations operations)

(define-syntax (operations-where stx)
  (syntax-case stx ()
    [(_ fact ...)
     (let ([entries (apply entries-where (syntax->datum #'(fact ...)))])
       #`(list #,@(for/list ([e (in-list entries)]
                             #:when (and (heads e) (all-of-name-in? e entries)))
                    (identifier-of e #'here))))]))

(define circular-functions (operations-where circular))
(define functions-of-angles (append circular-functions (operations-where hyperbolic)))

(define by-name (for/hasheq ([op (in-list operations)]) (values (operation-name op) op)))
(define (find-operation name) (hash-ref by-name name #f))

(define written-names (operation-names arithmetic function reciprocal))

(define op:up (operation 'up #f))
(define op:down (operation 'down #f))

;; The solution of a linear system, whose rows [A b] are the operands one after
;; the other, and component k of it: `(component k (solution ...))`.  They occur
;; only in graphs that are about to be compiled.
(define op:solution (operation 'solution #f))
(define op:component (operation 'component #f))

;; x brought into [low, cut), whose length is `period`, by whole periods: as it is where it
;; is already there, and never led out by rounding.  It, too, is for graphs to be compiled.
(define (wrap x low cut period)
  (cond [(and (<= low x) (< x cut)) x]
        [else
         (define y (- x (* period (floor (/ (- x low) period)))))
         (if (or (< y low) (>= y cut)) low y)]))

(define op:wrapped (operation 'wrapped wrap))

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
