#lang racket/base
;; (* 'A cos 'omega t): the cosine multiplied, where it was meant to be applied.  Functions are
;; values, so that this is one, a function; whoever needs a number finds the mistake here.

(require "describe.rkt" "elementary.rkt" "function.rkt" "kind.rkt"
         "../algebra/expression/write.rkt")

(provide multiplied-hint)

;; x : given in place of a number -> lines to add to a message, or ""
(define (multiplied-hint x)
  (define found (and (pointwise? x) (multiplied (value->datum x))))
  (if found
      (format "\n  ~a is a factor there; to apply it, write ~a" (car found) (call->text found))
      ""))

;; (cos (* omega t)), with symbols quoted as they are typed
(define (call->text factors)
  (define next (and (pair? (cdr factors)) (cadr factors)))
  (format "(~a ~a)" (car factors)
          (cond [(not next) "..."]
                [(symbol? next) (format "'~a" next)]
                [else (datum->text next)])))

;; An elementary function in a product and the factors after it, or #f.
(define (multiplied d)
  (cond [(not (and (pair? d) (list? d))) #f]
        [(and (eq? (car d) '*) (memf elementary? (factors d)))]
        [else (ormap multiplied (cdr d))]))

;; Products are made from the left: (* (* A cos) t).
(define (factors d)
  (if (and (pair? d) (eq? (car d) '*)) (append (factors (cadr d)) (cddr d)) (list d)))

(define (elementary? d) (and (memq d names) #t))

(define names (map generic-op-name elementary-operations))
