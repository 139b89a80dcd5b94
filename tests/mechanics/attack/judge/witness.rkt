#lang racket/base
;; The point a refutation names: numbers for symbols, and what literal functions are.
;;
;; An entry (V x) -> number says the value of V at one argument; applications at arguments
;; that cannot be told apart must agree.  An application that no entry names has a
;; value of its own, which may be any number.

(require racket/list
         "evaluate.rkt" "interval.rkt" "polynomial.rkt")

(provide witness-numbers witness-point)

;; The numbers of symbols.
(define (witness-numbers witness)
  (for/hasheq ([entry (in-list witness)] #:when (symbol? (car entry)))
    (values (car entry) (exact (cdr entry)))))

(define (exact x) (if (and (flonum? x) (rational? x)) (inexact->exact x) x))

(define (witness-point numbers witness decimal)
  (define applications (filter (lambda (entry) (pair? (car entry))) witness))
  (define others '())                    ; applications not named, as entries of values
  (define (look-up name orders args A)
    (define found
      (remove-duplicates
       (append
        (for/list ([entry (in-list applications)]
                   #:when (said-of? entry name orders args self A))
          (cdr entry))
        (for/list ([o (in-list others)] #:when (same-application? o name orders args A))
          (application-value o)))))
    (cond [(null? found)
           (set! others (cons (application name orders args (random-value)) others))
           (application-value (car others))]
          [(pair? (cdr found)) (fail-with-two-values)]
          [else (exact (car found))]))
  (define self (point (lambda (s) (hash-ref numbers s #f)) look-up decimal))
  self)

(struct application (name orders args value))

(define (same-application? o name orders args A)
  (and (eq? name (application-name o))
       (equal? orders (application-orders o))
       (not (for/or ([u (in-list args)] [v (in-list (application-args o))]) (differ? u v A)))))

(define (random-value) (/ (- (random 201) 100) 8))

;; Is the entry for this head, at arguments not told apart from these?
(define (said-of? entry name orders args self A)
  (define e (car entry))
  (define-values (own-name own-orders) (parse-head (car e) (length (cdr e))))
  (and (eq? own-name name)
       (equal? own-orders orders)
       (for/and ([a (in-list (cdr e))] [v (in-list args)])
         (define own (value-at a self A))
         (and (value? own) (not (differ? own v A))))))
