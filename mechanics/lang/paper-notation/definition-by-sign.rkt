#lang racket/base
;; Definitions as on paper: x = 3, f(x) = x^2, x(t) = A cos(omega t), L = 1/2 m v^2.
;;
;; The formula behind the sign may have unknown letters.  Beside arguments they become parameters,
;; as the book writes them: ((x A omega) t).  Without arguments they are symbols; but a formula
;; with a t is a path, and one with a v and the name L a Lagrangian, a function of the local tuple.

(require racket/list
         "prefix-form.rkt"
         "../written-form.rkt")

(provide definition-by-sign definition-by-word plain-definition Lagrangian-by-sign?)

;; data : of a line; known? : symbol -> boolean -> the definition, a datum, or #f
(define (definition-by-sign data known?)
  (define plain (plain-definition data))
  (and plain (with-letters (cadr plain) (caddr plain) known?)))

;; The same without a change for letters.
(define (plain-definition data)
  (define spread (append-map signs-apart (without-increment data)))
  (define i (index-where spread (lambda (d) (memq d '(= :=)))))
  (define head (and i (head-before (take spread i))))
  (define behind (if head (drop spread (add1 i)) '()))
  (and (pair? behind)
       (let ([procedure (procedure-elsewhere behind)])
         (define value (if procedure (cdr procedure) (prefix-form behind)))
         (and value
              (list 'define (if procedure (cons head (car procedure)) head) value)))))

;; m += 1 as m = m + 1
(define (without-increment data)
  (define sign
    (and (> (length data) 2) (symbol? (car data))
         (assq (cadr data) '((+= . +) (-= . -) (*= . *) (/= . /)))))
  (if sign (list* (car data) '= (car data) (cdr sign) (cddr data)) data))

;; x=3 as x = 3
(define (signs-apart d)
  (define found
    (and (symbol? d) (regexp-match #px"^([^=<>!:]*)(:?=)([^=?]*)$" (symbol->string d))))
  (if found
      (map operand-in (remove* '("") (cdr found)))
      (list d)))

;; lambda x, y: x**2 -> ((x y) . (expt x 2)), or #f
(define (procedure-elsewhere data)
  (define plain (without-commas data))
  (define i (index-where plain (lambda (d) (and (symbol? d) (before-colon d)))))
  (define body (if i (drop plain (add1 i)) '()))
  (and (memq (car plain) '(lambda λ))
       (pair? body)
       (let ([names (append (cdr (take plain i)) (list (before-colon (list-ref plain i))))]
             [value (prefix-form body)])
         (and value (cons names value)))))

;; def f(x): return x**2, and define f(x) x**2
(define (definition-by-word data)
  (define named? (and (> (length data) 3) (symbol? (cadr data)) (list? (caddr data))))
  (define body (if named? (remq* '(: = return) (cdddr data)) '()))
  (define value (and (pair? body) (memq (car data) '(def define)) (prefix-form body)))
  (and value (list 'define (cons (cadr data) (without-commas (caddr data))) value)))

(define (head-before data)
  (cond [(and (= (length data) 1) (symbol? (car data))) (car data)]
        [(and (= (length data) 2) (symbol? (car data)) (list? (cadr data)))
         (cons (car data) (without-commas (cadr data)))]
        [else #f]))

;; ---------------------------------------------------------------------------
;; Letters

(define (with-letters head value known?)
  (define letters
    (filter (lambda (s) (not (or (known? s) (memq s (flatten head)))))
            (remove-duplicates (operands value))))
  (cond [(null? letters) (list 'define head value)]
        [(pair? head) (list 'define (cons (cons (car head) letters) (cdr head)) value)]
        [(Lagrangian? head letters) (Lagrangian head letters value)]
        [(memq 't letters) (with-letters (list head 't) value known?)]
        [else (list 'define head (quoted value letters))]))

(define (quoted d letters)
  (cond [(symbol? d) (if (memq d letters) (list 'quote d) d)]
        [(and (pair? d) (list? d) (not (eq? (car d) 'quote)))
         (cons (car d) (map (lambda (x) (quoted x letters)) (cdr d)))]
        [else d]))

;; ---------------------------------------------------------------------------
;; Lagrangians

(define (Lagrangian? name letters) (and (eq? name 'L) (memq 'v letters) #t))

(define (Lagrangian name letters value)
  (define coordinate (or (findf (lambda (s) (memq s letters)) '(q x y z r theta)) 'q))
  (define local (list 'up 't coordinate 'v))
  (define parameters (remq* local letters))
  `(define ((,name ,@parameters) ,local) ,value))

;; Is it a definition that `Lagrangian` made?
(define (Lagrangian-by-sign? form)
  (define head (cadr form))
  (and (pair? head) (pair? (car head)) (eq? (caar head) 'L)
       (pair? (cadr head)) (eq? (car (cadr head)) 'up)))
