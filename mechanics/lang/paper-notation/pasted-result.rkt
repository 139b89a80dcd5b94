#lang racket/base
;; A printed result, typed or pasted again at the prompt: (+ (* k (x t)) (* m v)), where k, x and
;; t were symbols.

(require (only-in racket/list remove-duplicates)
         "../written-form.rkt")

(provide pasted-sentence)

;; entry : a form, a datum; known? : symbol -> is anything known of the name? -> text or #f
(define (pasted-sentence entry known?)
  (define (unknown? name) (not (or (memq name operations) (known? name))))
  (and (pair? entry)
       (memq (car entry) operations)
       (result? entry unknown?)
       (ormap pair? (cdr entry))
       (or (calls-unknown? entry unknown?) (several? (unknown-in entry unknown?)))
       (format "a result that was printed is read by (read-expression '~a)" (shortened entry))))

(define (several? names) (> (length (remove-duplicates names)) 1))

(define (shortened form)
  (define text (form->text form))
  (if (> (string-length text) 60) (format "(~s ...)" (car form)) text))

;; Is it made of operations and of names that nothing is known of?  Derivatives are applied in
;; steps, as in (((expt D 2) x) t).
(define (result? d unknown?)
  (define (results? ds) (andmap (lambda (d) (result? d unknown?)) ds))
  (define (head? d)
    (if (pair? d)
        (and (list? d) (head? (car d)) (results? (cdr d)))
        (and (symbol? d) (or (memq d operations) (unknown? d)) #t)))
  (cond [(pair? d) (and (list? d) (head? (car d)) (results? (cdr d)))]
        [(symbol? d) (or (memq d '(D pi)) (unknown? d) (not (memq d operations)))]
        [else (number? d)]))

(define operations
  '(+ - * / expt sqrt exp log abs sin cos tan asin acos atan sinh cosh tanh square cube
    up down D partial))

(define (unknown-in d unknown?)
  (cond [(pair? d) (append (unknown-in (car d) unknown?) (unknown-in (cdr d) unknown?))]
        [(and (symbol? d) (unknown? d)) (list d)]
        [else '()]))

(define (calls-unknown? d unknown?)
  (and (pair? d)
       (or (and (symbol? (car d)) (unknown? (car d)))
           (ormap (lambda (x) (calls-unknown? x unknown?)) d))))
