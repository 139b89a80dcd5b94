#lang racket/base
;; Definitions as on paper, refused with the correct form: (define m = 3), (define f(t) (* 2 t)),
;; (define (T m v) 1/2 m v^2), (define x' 3).

(require (only-in racket/list flatten)
         "../written-form.rkt"
         "../paper-notation/operation-sign.rkt"
         "../../generic/on-demand.rkt")

(require-on-demand ["../paper-notation/prefix-form.rkt" prefix-form]
                   ["../paper-notation/other-notation.rkt" notation-sentence])

(provide check-on-paper shown)

(define datum syntax->datum)

;; stx : a form that begins with `define`
(define (check-on-paper stx)
  (syntax-case stx ()
    [(_ head . body)
     (begin
       (check-prime #'head #'body stx)
       (check-equals stx)
       (check-formula #'head #'body stx))]
    [_ (void)]))

;; A body in a message: itself if it is short; a formula in prefix form.
(define (shown body)
  (define forms (datum body))
  (define form
    (cond [(not (and (list? forms) (pair? forms))) #f]
          [(null? (cdr forms)) (car forms)]
          [(andmap number? forms) #f]
          [else (prefix-form (syntax->list body))]))
  (if (and form (<= (string-length (form->text form)) 50)) form '...))

(define (check-equals stx)
  (define (fail head body)
    (refuse stx #f "a definition is written ~a"
            (form->text (list 'define (datum head) (shown body)))))
  (syntax-case stx ()
    [(_ head sign . body)
     (and (equals? #'sign) (pair? (syntax-e #'body)))
     (fail #'head #'body)]
    [(_ name (argument ...) sign . body)
     (and (identifier? #'name) (equals? #'sign))
     (fail #'(name argument ...) #'body)]
    [(_ name arguments form . body)
     (and (identifier? #'name) (pair? (syntax-e #'arguments)) (adjacent? #'name #'arguments))
     (fail #'(name . arguments) #'(form . body))]
    [_ (void)]))

(define (equals? stx) (eq? (syntax-e stx) '=))

;; x' is read as x and a quote: (define x' 3) would define x.
(define (check-prime head body stx)
  (syntax-case body ()
    [(form . _)
     (and (identifier? head) (prime-before? head #'form))
     (refuse stx #f (string-append "a prime is read as a quote; a name is written without, as in "
                                   "(define ~aprime 3)")
             (datum head))]
    [_ (void)]))

;; Refuses (define (T m v) 1/2 m v^2), and (define T 1/2 * m * (square v)).
(define (check-formula head body stx)
  (define forms (datum body))
  (when (and (list? forms) (pair? forms) (pair? (cdr forms))
             (or (number? (car forms)) (symbol? (car forms)))
             (ormap symbol? forms)
             (or (infix? forms)
                 (and (list? (cadr forms)) (signed-name? (car forms)))
                 (andmap (lambda (d) (or (number? d) (symbol? d))) forms)))
    (define (known? name)
      (or (memq name (flatten (datum head)))
          (identifier-binding (datum->syntax stx name))))
    (define form (prefix-form (syntax->list body) known?))
    (cond [(and form (operation? form))
           (refuse stx #f "operations come first: ~a~a"
                   (form->text (list 'define (datum head) form)) (about-units forms))]
          [(infix? forms) (refuse stx #f about-formulas)])))

(define (operation? form) (or (sign? (car form)) (eq? (car form) 'expt)))

;; (define m 1.5 kg)
(define (about-units forms)
  (define sentence
    (and (number? (car forms)) (symbol? (cadr forms)) (notation-sentence (cadr forms))))
  (if sentence (string-append "; " sentence) ""))
