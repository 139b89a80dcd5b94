#lang racket/base
;; From an entry in the table of operations to the record that kinds see.
;;
;; (define-record id name arity procedure) defines id as the record of that entry.
;; The derivatives are read where define-record stands, so that `g:cos` in them is
;; what `g:cos` means there.  They come twice: as one procedure for each argument,
;; of values of any kind; and together with the operation's value in one procedure,
;; of flonums, which saves the most of what calls and dispatch cost.

(require (for-syntax racket/base "flonum-form.rkt")
         "kind.rkt" "kinks-met.rkt"
         "../algebra/expression/operation-table.rkt")

(provide define-record define-composite-record case-at-flonums)

(define-syntax (define-record stx)
  (syntax-case stx ()
    [(_ id name arity procedure)
     (syntax-case (find-entry (syntax-e #'name) (syntax-e #'arity)) ()
       [(_ (argument ...) numeric domain partial ...)
        (with-syntax ([op (datum->syntax stx (prefixed #'name))])
          #`(define id
              (make-record #,stx name op procedure
                           (argument ...) (numeric argument ...) domain partial ...)))])]))

;; The same of an operation of one argument made of others; messages call it `name`.
(define-syntax (define-composite-record stx)
  (syntax-case stx ()
    [(_ id entry name procedure)
     (syntax-case (find-entry (syntax-e #'entry) 1) ()
       [(_ arguments expression domain partial ...)
        #`(define id
            (make-record #,stx name #f procedure arguments expression domain partial ...))])]))

(define-for-syntax (prefixed name)
  (string->symbol (format "op:~a" (syntax-e name))))

(define-syntax (make-record stx)
  (syntax-case stx ()
    [(_ context name op procedure arguments expression domain . partials)
     (let ([here (lambda (s) (datum->syntax #'context (syntax->datum s) s))])
       (with-syntax ([(argument ...) (here #'arguments)]
                     [value (here #'value)]
                     [slope (here #'slope)]
                     [slope-at (here #'slope-at)]
                     [pole (here #'pole)]
                     [(partial ...) (here #'partials)]
                     [(derivative ...) (generate-temporaries #'partials)])
         (define define-forms
           #'(begin
               (define-syntax-rule (slope a b) (slope-at 'name (list argument ...) a b))
               (define-syntax-rule (pole a) (begin (note-kink! 'name argument ...) a))))
         (with-syntax ([define-forms define-forms]
                       [at-flonums (flonum-procedure #'(procedure argument ...) (here #'expression)
                                                     define-forms
                                                     #'(argument ...) #'value
                                                     #'(partial ...) #'(derivative ...))])
           #'(let ()
               (define (derivative argument ... value) define-forms partial) ...
               (define in-one-call at-flonums)
               (generic-op 'name op procedure (list derivative ...) in-one-call 'domain)))))]))

;; The procedure that gives value and derivatives of flonums, or #f if a derivative
;; takes more than flonum arithmetic.  Where the value is no flonum, as √-1.0, the
;; derivatives are not either.
(define-for-syntax (flonum-procedure application expression define-forms
                                     arguments value partials derivatives)
  (define inputs (syntax->list arguments))
  (define flonums (cons value inputs))
  (define slopes (for/list ([p (in-list (syntax->list partials))]) (slope-form p flonums)))
  (and (andmap values slopes)
       (with-syntax ([(argument ...) arguments]
                     [value value]
                     [numeric (or (flonum-form expression inputs) application)]
                     [(slope ...) slopes]
                     [(derivative ...) derivatives])
         #`(lambda (argument ...)
             #,define-forms
             (let ([value numeric])
               (if (flonum? value)
                   (values value slope ...)
                   (values value (derivative argument ... value) ...)))))))

;; What is a number stays it: exact 1 says that there is nothing to multiply.
(define-for-syntax (slope-form partial flonums)
  (if (number? (syntax-e partial)) partial (flonum-form partial flonums)))

;; Where op is one of the records given with the names of their entries, the form
;; (use value derivative ...), in flonum arithmetic but for constants; else the last.
;; x ... : identifiers, bound to flonums.
(define-syntax (case-at-flonums stx)
  (syntax-case stx (else)
    [(_ op (x ...) use [id name] ... [else general])
     (with-syntax ([(form ...)
                    (for/list ([n (in-list (syntax->list #'(name ...)))])
                      (flonum-use n #'use (syntax->list #'(x ...))))])
       #'(cond [(eq? op id) form] ... [else general]))]))

(define-for-syntax (flonum-use name use inputs)
  (syntax-case (find-entry (syntax-e name) (length inputs)) ()
    [(_ (argument ...) numeric domain partial ...)
     (let ([here (lambda (s) (datum->syntax use (syntax->datum s)))])
       (with-syntax ([(argument ...) (here #'(argument ...))] [value (here #'value)])
         (define arguments (syntax->list #'(argument ...)))
         #`(let #,(map list arguments inputs)
             (let ([value #,(flonum-form (here (value-form #'numeric #'(argument ...))) arguments)])
               (#,use value #,@(for/list ([p (in-list (syntax->list #'(partial ...)))])
                                 (slope-form (here p) (cons #'value arguments))))))))]))

;; Operations of the algebra have a name for what they are of numbers, composite ones
;; an expression.
(define-for-syntax (value-form numeric arguments)
  (if (identifier? numeric) #`(#,numeric . #,arguments) numeric))
