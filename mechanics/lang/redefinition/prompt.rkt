#lang racket/base
;; Definitions and `require` at the prompt.
;;
;; Racket's `require` silently replaces earlier definitions; here the reader's definitions stay,
;; and a note says so.  Racket also compiles an unknown name in a procedure as a variable, which no
;; `require` defines: here it does, so that the procedure need not be defined again.

(require (for-syntax racket/base
                     "binding-forms.rkt" "definition-head.rkt" "specification.rkt"
                     "../imported-name.rkt"
                     (only-in "../paper-notation/typographic.rkt" tell-curly-quotes))
         (only-in racket/list partition)
         "../imported-name.rkt" "definition-head.rkt" "import-clash.rkt"
         (only-in "../../algebra/expression/expression.rkt" node?)
         (only-in "../../error/note.rkt" note-once)
         (only-in "../../generic/up-down.rkt" tuple?))

(provide at-prompt head-at-prompt variable-name?)

;; A form, for evaluation at the prompt.
(define-syntax (at-prompt stx)
  (tell-curly-quotes stx)
  (syntax-case stx (require)
    [(_ (require spec ...))
     #`(begin #,@(for/list ([spec (in-list (distinct-specifications
                                            (syntax->list #'(spec ...))))])
                   (required spec (cadr (syntax->list stx)))))]
    [(_ (same a b))
     (and (identifier? #'same) (memq (syntax-e #'same) '(equal? eqv? eq?)) (imported? #'same))
     #'(let ([x a] [y b]) (noted-if-unequal 'same (same x y) x y))]
    [(_ form)
     (let ([id (defined-by-define #'form)])
       (if id
           #`(begin form
                    (note-definition! '#,id '#,(definition-head (syntax->datum #'form))
                                      '#,(library-with id)))
           #'form))]))

(begin-for-syntax
  ;; The library that defines a name at the prompt, as `require` names it; or #f
  (define (library-with id)
    (define binding (identifier-binding id))
    (define-values (path base)
      (if (and (pair? binding) (imported? id))
          (module-path-index-split (caddr binding))
          (values #f #f)))
    (cond [(symbol? path) path]
          [(and (pair? path) (eq? (car path) 'lib) (null? (cddr path)))
           (string->symbol (regexp-replace #rx"(/main)?[.]rkt$" (cadr path) ""))]
          [else #f]))

  ;; Where the specification is wrong, `require` itself says so.
  (define (required spec form)
    (define names (names-imported spec))
    (if names
        #`(require-beside! #'#,spec '#,names)
        (datum->syntax form (list (car (syntax-e form)) spec) form))))

;; ---------------------------------------------------------------------------

;; Imports the names of the specification, without those that the reader defined and that it does
;; not list one by one.
(define (require-beside! spec names)
  (define by-name (named-by spec))
  (define-values (staying others)
    (partition (lambda (name) (and (own-definition? name) (not (memq name by-name)))) names))
  (eval (if (null? staying)
            #`(require #,spec)
            #`(require (except-in #,spec #,@(for/list ([n (in-list staying)])
                                              (datum->syntax spec n))))))
  (unless (null? staying) (tell-clashes (syntax->datum spec) staying))
  (show-to-procedures! others))

;; Defined at the prompt, or by the module that the prompt belongs to?
(define (own-definition? name)
  (define id (namespace-symbol->identifier name))
  (if (identifier-binding id)
      (not (imported? id))
      (variable-name? name)))

;; Is it a variable that was defined at the prompt?
(define (variable-name? name)
  (known? (namespace-variable-value name #f (lambda () unknown))))

;; namespace -> table: name -> head of its definition
(define heads (make-weak-hasheq))

;; hidden : the library whose name it was, or #f
(define (note-definition! name head hidden)
  (hash-set! (hash-ref! heads (current-namespace) make-hasheq) name head)
  (when hidden
    (note-once (format (string-append "~a: your definition hides the one of ~a; "
                                      "(require (only-in ~a ~a)) brings that back")
                       name hidden hidden name))))

;; -> head of the definition at the prompt, a datum, or #f
(define (head-at-prompt name)
  (hash-ref (hash-ref heads (current-namespace) hasheq) name #f))

(define (tell-clashes library names)
  (tell-clash library
              (for/list ([name (in-list names)])
                (clash name (head->header (or (head-at-prompt name) name)) #f))))

;; Defines these names as variables of the namespace, for procedures that were defined before.
(define (show-to-procedures! names)
  (for ([name (in-list names)] #:unless (variable-name? name))
    (define value (namespace-variable-value name #t (lambda () (value-of-syntax name))))
    (when (known? value) (namespace-set-variable-value! name value #f))))

;; ---------------------------------------------------------------------------
;; (equal? a b), which knows no algebra

;; The answer same? of Racket's `who` for x and y, with a note if it is #f.
(define (noted-if-unequal who same? x y)
  (unless (or same? (not (or (formula? x) (formula? y) (and (number? x) (number? y)))))
    (note-once (format "~a compares how values are made; (= a b) asks whether they are equal" who)
               'same))
  same?)

(define (formula? x) (or (node? x) (tuple? x)))

(define unknown (string->uninterned-symbol "unknown"))
(define (known? x) (not (eq? x unknown)))

;; The value of a procedure with keywords or with a contract, which is syntax.
(define (value-of-syntax name)
  (eval #`(value-if-procedure #,(namespace-symbol->identifier name))))

;; Other syntax is not evaluated, and its errors about a name that stands alone are ignored.  A
;; contract lifts definitions, once for each place: here they are captured apart from the
;; definitions that will be made.
(define-syntax (value-if-procedure stx)
  (define name (cadr (syntax->list stx)))
  (define meant (with-handlers ([exn:fail? (lambda (e) #f)])
                  (local-expand/capture-lifts name 'expression '())))
  (syntax-case meant (begin define-values)
    [(begin (define-values . _) . _) name]
    [(begin id) (identifier? #'id) name]
    [_ #'unknown]))
