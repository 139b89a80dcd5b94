#lang racket/base
;; `define`, `lambda`, `let` and `let*` with structure patterns in argument
;; position (SICM's (up t (up x y) (up vx vy)), after Scheme's local tuples).
;; Where no pattern is written these are Racket's forms, given the same syntax.

(require (for-syntax racket/base
                     (only-in racket/list append-map)
                     "incomplete-forms.rkt" "definition-mistakes.rkt" "pattern-syntax.rkt"
                     "definition-notes.rkt" "../written-form.rkt")
         "tuple.rkt")

(provide up down
         (rename-out [define/pattern define]
                     [lambda/pattern lambda]
                     [λ/pattern λ]
                     [case-lambda/pattern case-lambda]
                     [let/pattern let]
                     [let*/pattern let*]))

(begin-for-syntax
  ;; Racket's form, on the syntax as it was written.
  (define (as form stx)
    (when (identifier? stx) (raise-alone stx))
    (plain-form form stx))

  (define (raise-alone id)
    (raise-syntax-error
     #f (format "stands first within parentheses, as in ~s"
                (case (syntax-e id)
                  [(define) '(define m 3)]
                  [(let let*) `(,(syntax-e id) ([m 3]) (* 2 m))]
                  [else `(,(syntax-e id) (t) (* 2 t))]))
     id))

  ;; The name that a procedure made here will have, or `other`.
  (define (inferred-name stx other)
    (define name (or (syntax-property stx 'inferred-name) (syntax-local-name)))
    (cond [(symbol? name) name]
          [(identifier? name) (syntax-e name)]
          [else other]))

  (define (check-body body stx)
    (when (null? body) (refuse stx #f "no expressions for procedure body")))

  ;; An argument list and a body without patterns that mean the same, and the patterns.
  (define (rewrite-procedure formals body who stx)
    (check-body body stx)
    (define-values (new-formals bounds ids) (rewrite-formals formals who))
    (check-distinct ids "argument name" stx)
    (values new-formals
            (if (null? bounds) body (list (destructure bounds who body)))
            bounds)))

;; ---------------------------------------------------------------------------
;; define

;; A curried head is taken apart from outside in, and every procedure it makes has the name that is
;; defined.
(define-syntax (define/pattern stx)
  (check-pattern-in-head stx)
  (check-definition stx)
  (check-head stx)
  (tell-slips-of-definition stx)
  (syntax-case stx ()
    [(_ (name . formals) body ...)
     (and (identifier? #'name) (has-pattern? #'formals) (not (as-variable? stx)))
     (let-values ([(formals body bounds)
                   (rewrite-procedure #'formals (syntax->list #'(body ...))
                                      (syntax-e #'name) stx)])
       (note-pattern-heads
        (quasisyntax/loc stx (define (name . #,formals) #,@body))
        bounds))]
    [(_ (head . formals) body ...)
     (and (head-name #'head)
          (or (as-variable? stx) (not (identifier? #'head))))
     (let ([procedure (quasisyntax/loc stx (lambda/pattern formals body ...))])
       (check-body (syntax->list #'(body ...)) stx)
       (quasisyntax/loc stx
         (define/pattern head
           #,(syntax-property procedure 'inferred-name
                              (syntax-e (head-name #'head))))))]
    [_ (as #'define stx)]))

(begin-for-syntax
  ;; Must the definition make a variable?  Racket's `define` makes a macro of a function with
  ;; keywords.
  (define (as-variable? stx) (syntax-property stx 'as-variable))

  ;; Only the first procedure of a curried head: the others are lambdas.
  (define (tell-slips-of-definition stx)
    (syntax-case stx ()
      [(_ (name . formals) body ...)
       (identifier? #'name)
       (tell-slips (syntax-e #'name) #'formals (syntax->list #'(body ...)))]
      [_ (void)]))

  ;; The arguments of every procedure that a head makes.
  (define (check-head stx)
    (syntax-case stx ()
      [(_ head . _)
       (for ([formals (in-list (reverse (argument-lists #'head)))]) (check-arguments formals stx))]
      [_ (void)])))

;; ---------------------------------------------------------------------------
;; lambda

(begin-for-syntax
  (define ((expand-lambda plain) stx)
    (check-complete-procedure stx)
    (syntax-case stx ()
      [(_ formals body ...)
       (let ([name (inferred-name stx 'lambda)] [forms (syntax->list #'(body ...))])
         (check-argument-list #'formals #'(body ...) stx)
         (check-arguments #'formals stx)
         (tell-slips name #'formals forms)
         (if (has-pattern? #'formals)
             (let-values ([(formals forms bounds) (rewrite-procedure #'formals forms name stx)])
               (note-pattern-heads (quasisyntax/loc stx (#,plain #,formals #,@forms)) bounds))
             (as plain stx)))]
      [_ (as plain stx)])))

(begin-for-syntax
  (define (check-cases stx)
    (syntax-case stx ()
      [(_ [formals . body] ...)
       (for ([formals (in-list (syntax->list #'(formals ...)))]
             [body (in-list (syntax->list #'(body ...)))])
         (check-argument-list formals body stx))]
      [_ (void)])))

(define-syntax lambda/pattern (expand-lambda #'lambda))
(define-syntax λ/pattern (expand-lambda #'λ))

(define-syntax (case-lambda/pattern stx)
  (check-cases stx)
  (syntax-case stx ()
    [(_ [formals body ...] ...)
     (ormap has-pattern? (syntax->list #'(formals ...)))
     (let* ([who (inferred-name stx 'case-lambda)]
            [clauses
             (for/list ([formals (in-list (syntax->list #'(formals ...)))]
                        [body (in-list (syntax->list #'((body ...) ...)))])
               (define-values (new-formals new-body bounds)
                 (rewrite-procedure formals (syntax->list body) who stx))
               (cons (cons new-formals new-body) bounds))])
       (note-pattern-heads
        (quasisyntax/loc stx (case-lambda #,@(map car clauses)))
        (append-map cdr clauses)))]
    [_ (as #'case-lambda stx)]))

;; ---------------------------------------------------------------------------
;; let

(define-syntax (let/pattern stx)
  (define-values (loop others)
    (syntax-case stx ()
      [(_ loop . others) (identifier? #'loop) (values #'loop #'others)]
      [(_ . others) (values #f #'others)]
      [_ (values #f stx)]))
  (syntax-case others ()
    [(([name value] ...) body0 body ...)
     (ormap pattern? (syntax->list #'(name ...)))
     (rewrite-let loop (syntax->list #'(name ...)) (syntax->list #'(value ...))
                  (syntax->list #'(body0 body ...)) stx)]
    [_ (as #'let stx)]))

(define-syntax (let*/pattern stx)
  (syntax-case stx ()
    [(_ ([name value] ...) body0 body ...)
     (ormap pattern? (syntax->list #'(name ...)))
     (let nest ([names (syntax->list #'(name ...))]
                [values (syntax->list #'(value ...))])
       (if (null? names)
           #'(let () body0 body ...)
           (rewrite-let #f (list (car names)) (list (car values))
                        (list (nest (cdr names) (cdr values))) stx)))]
    [_ (as #'let* stx)]))

(begin-for-syntax
  (define (rewrite-let loop names values body stx)
    (define who (if loop (syntax-e loop) (syntax-e (car (syntax-e stx)))))
    (define-values (lefts bounds ids) (rewrite-bindings names (and loop #t)))
    (check-distinct ids "identifier" stx)
    (note-pattern-heads
     (quasisyntax/loc stx
       (let #,@(if loop (list loop) '())
         #,(map list lefts values)
         #,@(if (null? bounds) body (list (destructure bounds who body)))))
     bounds)))
