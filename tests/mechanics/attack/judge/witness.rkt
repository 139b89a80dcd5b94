#lang racket/base
;; The point a refutation names: numbers for symbols, and what literal functions are.
;;
;; An entry (V x) -> number says the value of V at one argument; applications at arguments
;; that cannot be told apart must agree.  An entry (V q) -> expression in q says what
;; function V is.  What no entry names may be anything: it has a value of its own.

(require racket/list
         "evaluate.rkt" "interval.rkt" "point.rkt" "polynomial.rkt")

(provide witness-numbers witness-point)

;; The numbers of symbols.
(define (witness-numbers witness)
  (for/hasheq ([entry (in-list witness)] #:when (symbol? (car entry)))
    (values (car entry) (exact (cdr entry)))))

(define (exact x) (if (and (flonum? x) (rational? x)) (inexact->exact x) x))

(define (witness-point numbers witness decimal)
  (define applications (filter (lambda (entry) (pair? (car entry))) witness))
  (define others (make-hash))
  (define (look-up name orders args A)
    (define found
      (remove-duplicates
       (for/list ([entry (in-list applications)]
                  #:when (said-of? entry name orders args self A))
         (cdr entry))))
    (cond [(null? found) (hash-ref! others (list name orders args) (lambda () (random-value)))]
          [(pair? (cdr found)) (fail-with-two-values)]
          [else (exact (car found))]))
  (define self (point (lambda (s) (hash-ref numbers s #f)) look-up decimal))
  self)

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
