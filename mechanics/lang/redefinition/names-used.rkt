#lang racket/base
;; The names that a form uses, as far as it is seen before expansion: those of a given table that
;; stand in it, without quotations and without names that the commonest forms bind: arguments,
;; `let` and definitions inside bodies.  Names are compared by their spelling.

(require (for-template racket/base)
         "binding-forms.rkt"
         (only-in "../pattern/pattern-syntax.rkt" argument-lists fold-formals))

(provide names-in)

;; known : symbol -> true value
(define (names-in stx known)
  (define found (make-hasheq))
  (define (note! name)
    (when (hash-ref known name #f) (hash-set! found name #t)))
  (walk stx (hasheq) note!)
  (hash-keys found))

;; local : symbol -> #t, the names that are bound around stx
(define (walk stx local note!)
  (define (walk-inside stx) (walk stx local note!))
  (syntax-case stx (quote)
    [name
     (identifier? #'name)
     (unless (hash-ref local (syntax-e #'name) #f) (note! (syntax-e #'name)))]
    [(quote _) (void)]
    [(keyword formals . body)
     (among? #'keyword procedure-forms)
     (walk-procedure (list #'formals) #'body local note!)]
    [(keyword (head . formals) . body)
     (among? #'keyword definition-forms)
     (walk-procedure (argument-lists #'(head . formals)) #'body local note!)]
    [(keyword ([left right] next . others) . body)
     (among? #'keyword sequential-let-forms)
     (begin (walk-inside #'right)
            (walk #'(keyword (next . others) . body) (bind #'left local) note!))]
    [(keyword ([left right] ...) . body)
     (among? #'keyword let-forms)
     (begin (walk-inside #'(right ...))
            (walk-body #'body (bind #'(left ...) local) note!))]
    [(keyword loop ([left right] ...) . body)
     (and (identifier? #'loop) (among? #'keyword let-forms))
     (begin (walk-inside #'(right ...))
            (walk-body #'body (bind #'(loop left ...) local) note!))]
    [(first . others) (begin (walk-inside #'first) (walk-inside #'others))]
    [#(part ...) (walk-inside #'(part ...))]
    [_ (void)]))

(define (walk-body body local note!)
  (define forms (or (syntax->list body) '()))
  (define inside (bind (filter values (map defined-by-define forms)) local))
  (for ([form (in-list forms)]) (walk form inside note!)))

;; Walks the default values, then the body.
(define (walk-procedure argument-lists body local note!)
  (define (walk-argument name default local)
    (when default (walk default local note!))
    (bind name local))
  (walk-body body
             (for/fold ([local local]) ([formals (in-list argument-lists)])
               (fold-formals walk-argument local formals))
             note!))

;; Adds the symbols in stx.
(define (bind stx local)
  (define d (if (syntax? stx) (syntax-e stx) stx))
  (cond [(symbol? d) (hash-set local d #t)]
        [(pair? d) (bind (cdr d) (bind (car d) local))]
        [else local]))
