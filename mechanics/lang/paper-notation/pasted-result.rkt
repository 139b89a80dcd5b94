#lang racket/base
;; A printed result, typed or pasted again at the prompt: (+ (* k (x t)) (* m v)), where k, x and
;; t were symbols.

(require (only-in racket/list flatten remove-duplicates)
         "operation-sign.rkt"
         "../written-form.rkt"
         "../../operation/operation-column.rkt")

(provide pasted-sentence)

;; entry : a form, a datum; known? : symbol -> is anything known of the name? -> text or #f
(define (pasted-sentence entry known?)
  (define (unknown? name) (not (or (memq name operations) (known? name))))
  (define (unknown-symbol? d) (and (symbol? d) (unknown? d)))
  (and (pair? entry)
       (memq (car entry) operations)
       (result? entry unknown?)
       (ormap pair? (cdr entry))
       (or (calls-unknown? entry unknown?)
           (> (length (remove-duplicates (filter unknown-symbol? (flatten entry)))) 1))
       (format "a result that was printed is read by (read-expression '~a)" (shortened entry))))

(define (shortened form)
  (define text (form->text form))
  (if (> (string-length text) 60) (format "(~s ...)" (car form)) text))

;; Is it made of operations and unknown names?  Derivatives are applied in steps, as in
;; (((expt D 2) x) t).
(define (result? d unknown?)
  (define (results? ds) (andmap (lambda (d) (result? d unknown?)) ds))
  (define (head? d)
    (if (pair? d)
        (and (list? d) (head? (car d)) (results? (cdr d)))
        (and (symbol? d) (or (memq d operations) (unknown? d)) #t)))
  (cond [(pair? d) (and (list? d) (head? (car d)) (results? (cdr d)))]
        [(symbol? d) (or (memq d '(D pi)) (not (memq d operations)))]
        [else (number? d)]))

(define operations (append '(up down D partial) (operation-names arithmetic) functions))

(define (calls-unknown? d unknown?)
  (and (pair? d)
       (or (and (symbol? (car d)) (unknown? (car d)))
           (ormap (lambda (x) (calls-unknown? x unknown?)) d))))
