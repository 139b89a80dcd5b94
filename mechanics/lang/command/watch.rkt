#lang racket/base
;; A program that tells when it begins with a form: before each form of the module stands a call
;; with the form's number.  So the program runs as it would by itself, and each output is known to
;; come from one form.

(require (only-in racket/list append*))

(provide with-watched-forms module-forms)

;; (module name language form ...), the forms perhaps in a #%module-begin
(struct parts (start wrapper forms))

(define (module-parts stx)
  (define-values (start body)
    (let ([all (syntax->list stx)]) (values (list (cadr all) (caddr all)) (cdddr all))))
  (if (and (= 1 (length body)) (module-begin? (car body)))
      (parts start (car body) (cdr (syntax->list (car body))))
      (parts start #f body)))

(define (module-begin? form)
  (define head (and (pair? (syntax-e form)) (car (syntax-e form))))
  (and (identifier? head) (regexp-match? #rx"module-begin$" (symbol->string (syntax-e head)))))

(define (module-forms stx) (parts-forms (module-parts stx)))

;; The module with the calls; watch : number of the form that begins -> any
(define (with-watched-forms stx watch)
  (define p (module-parts stx))
  (define wrapper (parts-wrapper p))
  (define watched
    (append*
     (for/list ([form (in-list (parts-forms p))] [number (in-naturals)])
       (list (call-of (lambda () (watch number) (values))) form))))
  (define body
    (if wrapper
        (list (datum->syntax wrapper (cons (car (syntax-e wrapper)) watched) wrapper wrapper))
        watched))
  (datum->syntax stx (cons (namespace-module-identifier) (append (parts-start p) body)) stx stx))

;; The procedure itself is in the form, not its name, which the program might define.
(define (call-of thunk) (datum->syntax #f (list thunk)))
