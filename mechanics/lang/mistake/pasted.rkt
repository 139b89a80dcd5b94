#lang racket/base
;; A printed result, typed or pasted again at the prompt: (+ (* k (x t)) (* m v)), where k, x and
;; t were symbols.

(require (only-in racket/list remove-duplicates)
         "../as-written.rkt")

(provide pasted-sentence)

;; entry : the form that was typed, a datum -> text or #f
(define (pasted-sentence entry)
  (and (pair? entry)
       (memq (car entry) operations)
       (result? entry)
       (ormap pair? (cdr entry))
       (or (calls-unknown? entry) (several? (unknown-in entry)))
       (format "a result that was printed is read by (read-expression '~a)" (shortened entry))))

(define (several? names) (> (length (remove-duplicates names)) 1))

(define (shortened form)
  (define text (form->text form))
  (if (> (string-length text) 60) (format "(~s ...)" (car form)) text))

;; Is it made of operations and of names that nothing is known of?  Derivatives are applied in
;; steps, as in (((expt D 2) x) t).
(define (result? d)
  (cond [(pair? d) (and (list? d) (head? (car d)) (andmap result? (cdr d)))]
        [(symbol? d) (or (memq d '(D pi)) (unknown? d) (not (memq d operations)))]
        [else (number? d)]))

(define (head? d)
  (if (pair? d)
      (and (list? d) (head? (car d)) (andmap result? (cdr d)))
      (and (symbol? d) (or (memq d operations) (unknown? d)) #t)))

(define operations
  '(+ - * / expt sqrt exp log abs sin cos tan asin acos atan sinh cosh tanh square cube
    up down D partial))

(define (unknown-in d)
  (cond [(pair? d) (append (unknown-in (car d)) (unknown-in (cdr d)))]
        [(and (symbol? d) (unknown? d)) (list d)]
        [else '()]))

(define (calls-unknown? d)
  (and (pair? d)
       (or (and (symbol? (car d)) (unknown? (car d)))
           (ormap calls-unknown? d))))

;; Does the prompt know nothing of the name?
(define (unknown? name)
  (and (not (memq name operations))
       (not (identifier-binding (namespace-symbol->identifier name)))
       (eq? (namespace-variable-value name #f (lambda () nothing)) nothing)))

(define nothing (string->uninterned-symbol "nothing"))
