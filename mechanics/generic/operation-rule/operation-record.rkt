#lang racket/base
;; From an entry in the table of operations to the record that kinds see.
;;
;; (define-record id key procedure) defines id as the record of that entry.
;; The derivatives are read where define-record stands, so that `g:cos` in them is
;; `g:cos` there.  They come twice: as one procedure for each argument,
;; of values of any kind; and together with the operation's value in one procedure,
;; of flonums, which saves most of the cost of calls and dispatch.

(require (for-syntax racket/base "../../operation/operation-table.rkt")
         racket/flonum
         "../kind.rkt" "kinks-met.rkt"
         "../../algebra/expression/operation.rkt")

(provide define-record case-at-flonums)

(define-syntax (define-record stx)
  (syntax-case stx ()
    [(_ id key procedure)
     (let* ([e (find-entry (syntax-e #'key))]
            [here (lambda (datum) (datum->syntax stx datum))])
       (with-syntax ([name (entry-name e)]
                     [(argument ...) (here (entry-arguments e))]
                     [(partial ...) (here (entry-partials e))]
                     [(derivative ...) (generate-temporaries (entry-partials e))]
                     [domain (entry-domain e)]
                     [value (here 'value)]
                     [slope (here 'slope)]
                     [slope-at (here 'slope-at)]
                     [pole (here 'pole)]
                     [operation (and (not (entry-fact e 'composite)) (operation-of e))])
         (define define-forms
           #'(begin
               (define-syntax-rule (slope a b) (slope-at 'name (list argument ...) a b))
               (define-syntax-rule (pole a) (begin (note-kink! 'name argument ...) a))))
         (with-syntax ([define-forms define-forms]
                       [at-flonums (flonum-procedure #'(procedure argument ...)
                                                     (here (value-form e)) define-forms
                                                     #'(argument ...) #'value
                                                     #'(partial ...) #'(derivative ...))])
           #'(define id
               (let ()
                 (define (derivative argument ... value) define-forms partial) ...
                 (define in-one-call at-flonums)
                 (generic-op 'name operation procedure (list derivative ...) in-one-call
                             'domain))))))]))

;; The operation that heads expressions.
(define-for-syntax (operation-of e) #`(find-operation '#,(entry-name e)))

;; Operations of the algebra have a name for their function of numbers, composite ones an
;; expression.
(define-for-syntax (value-form e)
  (define numeric (entry-numeric e))
  (if (entry-fact e 'composite) numeric (cons numeric (entry-arguments e))))

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

;; A number stays as it is: exact 1 says that there is nothing to multiply.
(define-for-syntax (slope-form partial flonums)
  (if (number? (syntax-e partial)) partial (flonum-form partial flonums)))

;; Where op is one of the records given with the keys of their entries, the form
;; (use value derivative ...), in flonum arithmetic but for constants; else the last.
;; x ... : identifiers, bound to flonums.
(define-syntax (case-at-flonums stx)
  (syntax-case stx (else)
    [(_ op (x ...) use [id key] ... [else general])
     (with-syntax ([(form ...)
                    (for/list ([k (in-list (syntax->datum #'(key ...)))])
                      (flonum-use (find-entry k) #'use (syntax->list #'(x ...))))])
       #'(cond [(eq? op id) form] ... [else general]))]))

(define-for-syntax (flonum-use e use inputs)
  (define (here datum) (datum->syntax use datum))
  (define arguments (map here (entry-arguments e)))
  (with-syntax ([value (here 'value)])
    #`(let #,(map list arguments inputs)
        (let ([value #,(flonum-form (here (value-form e)) arguments)])
          (#,use value #,@(for/list ([p (in-list (entry-partials e))])
                            (slope-form (here p) (cons #'value arguments))))))))

;; ---------------------------------------------------------------------------
;; From an expression in generic arithmetic to the same in flonum arithmetic, which a compiler
;; keeps in registers.  Only operations occur that give flonums for all flonums.

;; expression, identifiers that stand for flonums -> expression or #f
(begin-for-syntax
  (define flonum-operations
    (hasheq '+ #'fl+ 'g:+ #'fl+ '- #'fl- 'g:- #'fl- '* #'fl* 'g:* #'fl* '/ #'fl/ 'g:/ #'fl/
            'exp #'flexp 'g:exp #'flexp 'sin #'flsin 'g:sin #'flsin 'cos #'flcos 'g:cos #'flcos))

  (define (flonum-form expression variables)
    (let/ec return
      (define (variable? id) (memf (lambda (v) (bound-identifier=? v id)) variables))
      (let form ([e expression])
        (syntax-case e ()
          [(head argument ...)
           (with-syntax ([(a ...) (map form (syntax->list #'(argument ...)))])
             (case (syntax-e #'head)
               [(g:negate) #'(fl* -1.0 a ...)]
               [(g:square) (with-syntax ([(a) #'(a ...)]) #'(let ([x a]) (fl* x x)))]
               [(pole) (car (syntax->list #'(a ...)))]
               [(slope) (with-syntax ([(a b) #'(a ...)])
                          #'(let ([d b]) (if (fl= d 0.0) (head a d) (fl/ a d))))]
               [else (with-syntax ([operation (hash-ref flonum-operations (syntax-e #'head)
                                                        (lambda () (return #f)))])
                       #'(operation a ...))]))]
          [x (identifier? #'x) (if (variable? #'x) #'x (return #f))]
          [n (real? (syntax-e #'n)) (datum->syntax #'n (real->double-flonum (syntax-e #'n)))])))))
