#lang racket/base
;; Numbers for expressions: their values at a point, at the cost of the graph.

(require mechanics/algebra/expression/expression
         mechanics/algebra/expression/operation
         mechanics/algebra/expression/pi)

(provide evaluate-expression point-lookup)

;; The value of e.  lookup : leaf arguments -> number, where the leaf is a
;; symbol, with no arguments, or a literal function applied, with the values of
;; its arguments (a tuple's value is its head and its components' values).
(define (evaluate-expression e lookup)
  (node-fold e
             (lambda (leaf)
               (cond [(pi-symbol? leaf) (pi-flonum leaf)]
                     [(symbol? leaf) (lookup leaf '())]
                     [else leaf]))
             (lambda (n values)
               (define head (node-head n))
               (cond [(literal-head? head) (lookup n values)]
                     [(operation-numeric head) => (lambda (f) (apply f values))]
                     [else (cons (operation-name head) values)]))))

;; The lookup of a point ((expression . number) ...) giving values to symbols
;; and literal applications.  An application is known by its function and the
;; values of its arguments.  Leaves that the point lacks go to `otherwise`.
(define (point-lookup point [otherwise raise-no-value])
  (define symbols (make-hasheq))
  (define applications (make-hash))
  (define (lookup leaf arguments)
    (if (symbol? leaf)
        (hash-ref symbols leaf (lambda () (otherwise leaf arguments)))
        (hash-ref applications (application-key leaf arguments)
                  (lambda () (otherwise leaf arguments)))))
  (for ([entry (in-list point)] #:when (symbol? (car entry)))
    (hash-set! symbols (car entry) (cdr entry)))
  (for ([entry (in-list (applications-inside-out point))])
    (define n (car entry))
    (define arguments
      (for/list ([a (in-list (node-args n))]) (evaluate-expression a lookup)))
    (hash-set! applications (application-key n arguments) (cdr entry)))
  lookup)

(define (application-key n arguments)
  (define head (node-head n))
  (list (literal-head-name head) (literal-head-index head) arguments))

;; Arguments of applications may hold other applications: those come first.
(define (applications-inside-out point)
  (sort (filter (lambda (entry) (node? (car entry))) point)
        <
        #:key (lambda (entry) (depth (car entry)))))

(define (depth e)
  (node-fold e (lambda (leaf) 0) (lambda (n depths) (+ 1 (apply max 0 depths)))))

(define (raise-no-value leaf arguments)
  (raise-arguments-error 'evaluate-expression "the point gives it no value"
                         "expression" leaf))
