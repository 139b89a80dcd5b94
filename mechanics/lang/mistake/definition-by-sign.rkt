#lang racket/base
;; Definitions as on paper: x = 3, f(x) = x^2, x(t) = A cos(omega t), L = 1/2 m v^2.
;;
;; What is written behind the sign may have letters that nothing is known of.  Beside the
;; arguments they are parameters, as the book writes them: ((x A omega) t).  Where there are no
;; arguments they are symbols; but a Lagrangian, called L and with a v, wants its local tuple.

(require racket/list
         "prefix-form.rkt" "sign.rkt"
         "../as-written.rkt")

(provide definition-by-sign plain-definition Lagrangian-by-sign?)

;; data : of a line; known? : symbol -> boolean -> the definition, a datum, or #f
(define (definition-by-sign data known?)
  (define plain (plain-definition data))
  (and plain (with-letters (cadr plain) (caddr plain) known?)))

;; The same without regard to letters.
(define (plain-definition data)
  (define i (index-where data (lambda (d) (memq d '(= :=)))))
  (define head (and i (head-before (take data i))))
  (define value (and head (pair? (drop data (add1 i))) (prefix-form (drop data (add1 i)))))
  (and value (list 'define head value)))

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
        [else (list 'define head (quoted value letters))]))

;; The symbols of a formula, but for what is called.
(define (operands d)
  (cond [(symbol? d) (list d)]
        [(and (pair? d) (eq? (car d) 'quote)) '()]
        [(pair? d) (append (if (pair? (car d)) (operands (car d)) '())
                           (append-map operands (if (list? d) (cdr d) '())))]
        [else '()]))

(define (quoted d letters)
  (cond [(symbol? d) (if (memq d letters) (list 'quote d) d)]
        [(and (pair? d) (list? d) (not (eq? (car d) 'quote)))
         (cons (car d) (map (lambda (x) (quoted x letters)) (cdr d)))]
        [else d]))

;; ---------------------------------------------------------------------------
;; Lagrangians

(define (Lagrangian? name letters) (and (eq? name 'L) (memq 'v letters) #t))

(define (Lagrangian name letters value)
  (define coordinate (or (for/first ([s (in-list '(q x y z r theta))] #:when (memq s letters)) s)
                         'q))
  (define local (list 'up 't coordinate 'v))
  (define parameters (remq* local letters))
  `(define ((,name ,@parameters) ,local) ,value))

;; Is it a definition that was made so?
(define (Lagrangian-by-sign? form)
  (define head (cadr form))
  (and (pair? head) (pair? (car head)) (eq? (caar head) 'L)
       (pair? (cadr head)) (eq? (car (cadr head)) 'up)))
