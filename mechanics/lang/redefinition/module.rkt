#lang racket/base
;; The body of a `#lang mechanics` module, which is read like a session: a name may be defined
;; again further down, functions defined before see the new definition, and names of the language
;; may be used until they are replaced.
;;
;; Each form is expanded until it shows its definitions, and the second
;; definition of a variable becomes its assignment:
;;
;;     (define (f) (g 1))        (define-values (f) (lambda () (g 1)))
;;     (define (g x) x)     =>   (define-values (g) (lambda (x) x))
;;     (define (g x) 'new)       (define-values () (begin (set! g (lambda (x) 'new)) (values)))
;;
;; A variable that is replaced after it was imported and used is first defined as the imported
;; value.  All other forms stay as they are.  Expressions leave their line for messages of errors.

(require (prefix-in core: '#%kernel)
         (for-syntax racket/base
                     "binding-forms.rkt" "definitions.rkt" "imports.rkt" "module-survey.rkt"
                     "../imported-name.rkt" "../paper-notation/program-lines.rkt"
                     (only-in "../paper-notation/typographic.rkt" tell-curly-quotes))
         "../wrong-call/marked-line.rkt"
         "../printer.rkt"
         (only-in "../../error/note.rkt" note-once)
         (only-in "../../error/message-words.rkt" joined))

(provide (rename-out [module-begin #%module-begin]))

;; A program run from the module has our session, unless the module brings its own.
(define-syntax (module-begin stx)
  (syntax-case stx ()
    [(_ form ...)
     (let* ([forms (syntax->list #'(form ...))]
            [survey (survey-forms forms)]
            [outside (filter imported? (all-early survey))])
       (check-lines forms (map syntax-e (survey-defined survey)))
       (for-each tell-curly-quotes forms)
       (with-syntax ([state (datum->syntax #f (make-definitions survey (syntax-source stx)))]
                     [(configuration ...)
                      (if (ormap configuration? forms)
                          '()
                          #'((module configure-runtime '#%kernel
                               (#%require mechanics/lang/runtime))))]
                     [((again ...) ...) (lines-of-repeated survey)]
                     [(start ...) (map start-as-outside outside)]
                     [(later ...)
                      (for/list ([ids (in-list (survey-early survey))])
                        (for/list ([id (in-list (remq* outside ids))])
                          (cons (syntax-e id) (syntax-line id))))])
         (syntax/loc stx
           (#%plain-module-begin
            configuration ...
            (#%plain-app tell-repeated 'again ...) ...
            (module-form state () start) ... (module-form state later form) ...))))]
    [_ (raise-syntax-error #f "bad syntax" stx)]))

(define-for-syntax (configuration? form)
  (syntax-case form ()
    [(keyword name . _)
     (and (among? #'keyword (list #'module #'module*))
          (eq? (syntax-e #'name) 'configure-runtime))]
    [_ #f]))

;; Each definition of a name holds from its line on; a note says so once in a session.
(define (tell-repeated name . lines)
  (note-once (format "~a is defined on lines ~a: each definition holds from there on"
                     name (joined (map number->string lines)))))

;; ---------------------------------------------------------------------------
;; Form by form

;; state : the definitions known; later : ((name . line) ...), names that the form may use before
;; their definitions
(define-syntax (module-form stx)
  (syntax-case stx ()
    [(_ state later form)
     (let* ([ds (syntax-e #'state)]
            [replaced (require-without-clashes ds #'form)])
       (if replaced
           (splice (quasisyntax/loc stx (begin #,@replaced)) #'state #'later)
           (let ([form (as-pasted #'form (lambda (name) (shows-definition? ds name)))])
             (expand-form ds #'state #'later (mark-variable ds form)))))]))

(begin-for-syntax
  (define (expand-form ds state later form)
    (define e (local-expand form 'module stops))
    (syntax-case e (begin define-values define-syntaxes)
      [(begin . _) (splice e state later)]
      [(define-values (id ...) value)
       (expand-variables ds later e (syntax->list #'(id ...)) #'value)]
      [(define-syntaxes (id ...) _)
       (begin (for ([id (in-list (syntax->list #'(id ...)))]) (add-macro! ds id))
              e)]
      [(head . _) (among? #'head no-expressions) e]
      [_ (quasisyntax/loc e (print-results #,(lined ds (watched e later) form)))]))

  (define (splice e state later)
    (define keyword (car (syntax-e e)))
    (datum->syntax
     e
     (cons keyword
           (for/list ([form (in-list (cdr (syntax->list e)))])
             #`(module-form #,state #,later #,(syntax-track-origin form e keyword))))
     e))

  (define no-expressions
    (syntax->list
     #'(begin-for-syntax module module* #%module-begin #%require #%provide #%declare)))

  ;; Where the expansion of a form stops: the core of the language.
  (define stops
    (append
     no-expressions
     (syntax->list
      #'(core:begin core:define-values core:define-syntaxes core:quote core:quote-syntax
         core:#%top core:lambda core:case-lambda core:let-values core:letrec-values
         core:begin0 core:set! core:with-continuation-mark core:if core:#%app
         core:#%expression core:#%variable-reference)))))

(define-syntax (print-results stx)
  (syntax-case stx ()
    [(_ expression)
     #'(#%plain-app call-with-values (lambda () expression) print-and-return)]))

(define (print-and-return . results)
  (for-each print-result results)
  (apply values results))

;; ---------------------------------------------------------------------------
;; Definitions

;; An error on a variable that is used before its definition says where that is.
;; lines : ((name . line or #f) ...), the variables that later forms define
(define (call-with-later-definitions thunk lines)
  (call-with-exception-handler
   (lambda (e)
     (define later
       (and (exn:fail:contract:variable? e)
            (assq (exn:fail:contract:variable-id e) lines)))
     (if later (early-use e (car later) (cdr later)) e))
   thunk))

(define (early-use e name line)
  (exn:fail:contract:variable
   (format "~a: used before its definition, which is ~a; a module is run from top to bottom"
           name (if line (format "on line ~a" line) "further down"))
   (exn-continuation-marks e)
   name))

(begin-for-syntax
  ;; e : the definition of ids as the value.  It stands as it is, unless some of them are defined
  ;; already or it may use names that are defined later.
  (define (expand-variables ds later e ids value)
    (define old (filter (lambda (id) (defined? ds id)) ids))
    (for ([id (in-list ids)]) (add-variable! ds id))
    (define safe-value
      (if (run-by-definition? (list value)) (lined ds (watched value later) e) value))
    (cond [(pair? old) (assignment e ids old safe-value)]
          [(eq? value safe-value) e]
          [else (definition e ids safe-value)]))

  (define (definition e ids value)
    (datum->syntax e (list #'define-values ids value) e e))

  ;; An assignment of the old ones among ids, a definition of the others.
  (define (assignment e ids old value)
    (define new (remq* old ids))
    (define temporaries
      (for/hasheq ([id (in-list ids)]) (values id (datum->syntax #'here (syntax-e id)))))
    (define (temporary id) (hash-ref temporaries id))
    (definition
      e new
      #`(let-values ([#,(map temporary ids) #,value])
          #,@(for/list ([id (in-list old)]) #`(set! #,id #,(temporary id)))
          (values #,@(map temporary new)))))

  ;; An expression that leaves the line of the form, unless it is a constant.
  (define (lined ds expression form)
    (define line (line-in ds form))
    (if (and line (pair? (syntax-e expression)))
        (quasisyntax/loc expression (at-line #,line #,expression))
        expression))

  ;; An expression with a message of its own if it uses one of these too early.
  (define (watched expression later)
    (if (null? (syntax-e later))
        expression
        (quasisyntax/loc expression
          (#%plain-app call-with-later-definitions (lambda () #,expression) '#,later)))))
