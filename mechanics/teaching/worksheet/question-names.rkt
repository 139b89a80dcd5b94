#lang racket/base
;; The names of which a question speaks besides those that its kind prescribes: constants, as m and
;; g, and functions, as V.  An answer may have no others, and the student's file tells them.

(require (only-in racket/list append-map remove-duplicates)
         "prescribed-symbols.rkt"
         "../../algebra/expression/expression.rkt" "../../algebra/expression/symbols.rkt"
         (only-in "../../algebra/expression/read.rkt" operation-name?)
         "../../value/shape.rkt")

(provide names-in-question prescribed-names unknown-names)

;; data : the key, the system, and other settings of it -> constants, functions
(define (names-in-question data coordinates arguments)
  (define-values (constants functions) (names-in data))
  (define prescribed (append arguments (prescribed-names coordinates)))
  (define (others names) (remove-duplicates (remq* prescribed (reverse names))))
  (values (others constants) (others functions)))

(define (prescribed-names coordinates)
  (cons 't (if (null? coordinates)
               '()
               (append (scalars (long-tuple-of coordinates)) (scalars (state-of coordinates))))))

(define (names-in d)
  (for/fold ([constants '()] [functions '()]) ([part (in-list d)])
    (cond [(pair? part)
           (define head (car part))
           (define-values (names more) (names-in (cdr part)))
           (define heads (filter function-name? (flattened head)))
           (values (append names constants) (append more heads functions))]
          [(and (symbol? part) (not (eq? part ':pi))) (values (cons part constants) functions)]
          [else (values constants functions)])))

(define (flattened d)
  (cond [(pair? d) (apply append (map flattened d))] [(symbol? d) (list d)] [else '()]))

(define (function-name? s)
  (not (or (operation-name? s) (memq s '(D partial up down list matrix-by-rows)))))

;; The symbols in the answer that the question does not have.
(define (unknown-names answer known)
  (define names
    (append-map (lambda (e) (if (expression? e) (symbols-in e) '())) (scalars answer)))
  (remove-duplicates (filter (lambda (s) (not (memq s known))) names)))
