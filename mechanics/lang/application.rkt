#lang racket/base
;; Application with messages in the reader's terms: `(f x ...)` where f turns out to be a number, a
;; symbol or a list; a Racket vector is applied as the up tuple it stands for.
;;
;; The test `(procedure? f)` costs nothing where the compiler knows f, which includes every function
;; defined once in the module, provided that f itself stays in operator position.  So a call of a
;; variable becomes
;;
;;     (let ([t argument] ...) (if (procedure? f) (f t ...) (refuse ...)))
;;
;; where constants, and variables among variables, need no t.  At the prompt f
;; itself comes first, for it may be undefined.  A name imported
;; from another module is trusted; any other operator, as in ((D f) x), is
;; tested on its way: ((callable operator) argument ...).
;;
;; Where the form looks as if it were meant otherwise (paper-notation/misread-call.rkt), that is
;; advice for the refusal, and for the message on an unknown name in it.

(require (for-syntax racket/base
                     "imported-name.rkt" "paper-notation/misread-call.rkt"
                     "paper-notation/operation-sign.rkt")
         (only-in "pattern/mismatch.rkt" short-text tuple-advice)
         "paper-notation/expansion-advice.rkt"
         "../error/complain.rkt" "../error/message-words.rkt"
         "../generic/arithmetic.rkt" "../generic/compare.rkt" "../generic/describe.rkt"
         (only-in "../generic/dispatch.rkt" raise-unary-arity)
         (only-meta-in 1 "../generic/elementary.rkt")
         (only-in "../generic/up-down.rkt" vector->up)
         (only-in "../value/matrix/quotient.rkt" inverse-of quotient-of)
         (only-in "../verdict/equality.rkt" equal-by-proof?))

(provide (rename-out [application #%app]))

;; ---------------------------------------------------------------------------
;; At run time

(define (callable f advice)
  (if (procedure? f) f (stand-in f #f advice)))

;; A procedure to apply in place of f, which is no procedure; `name` is the variable that holds
;; it, if any; `advice` is a text, or #f.
(define (stand-in f name advice)
  (if (vector? f)
      (vector->up f)
      (make-keyword-procedure
       (lambda (keywords their-values . arguments) (refuse f name advice arguments)))))

(define (refuse f name advice arguments)
  (define who (or name 'application))
  (define operation (and (pair? arguments) (operation-sign (car arguments))))
  (cond
    [advice (complain who "~a" advice)]
    [operation
     (complain who "operations come first~a"
               (prefix operation (or name (quoted f)) (cdr arguments)))]
    [(symbol? f)
     (complain who (string-append "the symbol ~a is a number here, not a function; "
                                  "(literal-function '~a) makes a function of it")
               f f)]
    [(null? f)
     (complain who "the empty list cannot be applied; parentheses around nothing are no value")]
    [(list? f) (complain who "~a" (tuple-advice f))]
    [else
     (complain who "the value ~a is ~a; it cannot be applied to ~a~a"
               (short-text f) (describe f) (describe-arguments arguments)
               (if name "" (product-hint f arguments)))]))

;; 2 (x + 1), with nothing between.
(define (product-hint f arguments)
  (cond [(not (and (number? f) (pair? arguments))) ""]
        [(null? (cdr arguments)) (format "; a product is (* ~a ~a)" f (quoted (car arguments)))]
        [(andmap number? arguments)
         (format "; a tuple is ~a" (cons 'up (cons f arguments)))]
        [else ""]))

;; (x * 2), as formulas are written on paper

(define (operation-sign x)
  (define found (assq x operations))
  (and found (cdr found)))

(define operations
  (list (cons g:+ '+) (cons g:* '*) (cons g:- '-) (cons quotient-of '/)
        (cons equal-by-proof? '=) (cons g:= '=)
        (cons g:< '<) (cons g:> '>) (cons g:<= '<=) (cons g:>= '>=)))

;; "(* 'x 2)", or the beginning of a longer formula
(define (prefix operation operand others)
  (format "~a (~a ~a ~a)"
          (if (= (length others) 1) ":" ", as in")
          operation operand
          (if (pair? others) (quoted (car others)) "...")))

(define (quoted x) (string-append (if (symbol? x) "'" "") (short-text x)))

(define (describe-arguments arguments)
  (if (null? arguments)
      "no arguments"
      (format "the argument~a ~a" (if (null? (cdr arguments)) "" "s")
              (joined (map short-text arguments) " "))))

;; ---------------------------------------------------------------------------
;; At expansion time

(define-syntax (application stx)
  (check-call stx)
  (syntax-case stx ()
    [(_ operator argument ...)
     (expand-application stx (called-beside (syntax->list #'(operator argument ...))))]
    [_ (plain-application stx (cdr (syntax-e stx)))]))

(begin-for-syntax
  ;; row : the operator and its arguments
  (define (expand-application stx row)
    (define operator (car row))
    (cond
      [(and (identifier? operator) (imported? operator) (not (number-before-sign? row)))
       (application-of-import stx row)]
      [(lambda-form? operator) (plain-application stx row)]
      [else
       (define advice (advice-on-call stx row))
       (define text (or advice (advice-on-product row)))
       (define advised-row (if text (map (lambda (x) (with-advice x text)) row) row))
       (application-of-own stx (car advised-row) (cdr advised-row) advice)]))

  ;; (pi / 2): a name that may hold a number is not trusted to be a procedure.
  (define (number-before-sign? row)
    (and (infix? (map syntax-e row)) (not (unary? (car row)))))

  (define (application-of-import stx row)
    (define operator (car row))
    (define arguments (cdr row))
    (if (and (unary? operator) (not (one? arguments)) (not (ormap keyword-argument? arguments)))
        #`(#%plain-app raise-unary-arity (#%plain-app object-name #,operator)
                       (#%plain-app list #,@arguments))
        (plain-application stx row)))

  (define (application-of-own stx operator arguments advice)
    (cond
      [(not (identifier? operator))
       (apply-to stx #`(#%plain-app callable #,operator '#,advice) arguments)]
      [(ormap keyword-argument? arguments)
       (apply-to stx #`(if (#%plain-app procedure? #,operator)
                           #,operator
                           #,(other-than-procedure operator advice))
                 arguments)]
      [else (application-of-variable stx operator arguments advice)]))

  (define (other-than-procedure f advice)
    #`(#%plain-app stand-in #,f '#,f '#,advice))

  ;; Racket's own application of the same syntax.
  (define (plain-application stx row)
    (datum->syntax stx (cons #'#%app row) stx stx))

  (define (apply-to stx operator arguments)
    (datum->syntax stx (list* #'#%app operator arguments) stx stx))

  (define (application-of-variable stx f arguments advice)
    (define temporaries (temporary-names arguments))
    (define operands
      (for/list ([a (in-list arguments)] [t (in-list temporaries)]) (or t a)))
    (define call
      #`(if (#%plain-app procedure? #,f)
            #,(datum->syntax stx (list* #'#%plain-app f operands) stx stx)
            (#%plain-app #,(other-than-procedure f advice) #,@operands)))
    (define bindings
      (for/list ([a (in-list arguments)] [t (in-list temporaries)] #:when t)
        #`[(#,t) #,(without-name a)]))
    (cond [(null? bindings) call]
          [(identifier-binding f)
           #`(let-values #,bindings #,call)]
          [else #`(let-values () #,f (let-values #,bindings #,call))]))

  ;; An identifier for each argument that needs one, or #f.  Constants need
  ;; none; variables do when a sibling might assign them.
  (define (temporary-names arguments)
    (define free? (if (andmap atomic? arguments) atomic? constant?))
    (for/list ([a (in-list arguments)]
               [t (in-sequences names (in-cycle '(#f)))])
      (and (not (free? a))
           (or t (car (generate-temporaries '(t)))))))

  ;; Each expansion renames these apart.
  (define names (syntax->list #'(t0 t1 t2 t3 t4 t5 t6 t7)))

  (define (atomic? stx) (or (identifier? stx) (constant? stx)))

  (define (constant? stx)
    (define d (syntax-e stx))
    (or (number? d) (boolean? d)
        (syntax-case stx (quote) [(quote _) #t] [_ #f])))

  ;; The temporary must not name a procedure written as an argument.
  (define (without-name stx)
    (syntax-property stx 'inferred-name (void)))

  (define (lambda-form? stx)
    (syntax-case stx ()
      [(head . _) (identifier? #'head) (memq (syntax-e #'head) '(lambda λ case-lambda))]
      [_ #f]))

  (define (one? xs) (and (pair? xs) (null? (cdr xs))))

  ;; Is it a function of one argument of this library?
  (define (unary? id)
    (define own-name (cadr (identifier-binding id)))
    (for/or ([u (in-list (cons #'inverse-of unary-functions))])
      (and (eq? own-name (syntax-e u)) (free-identifier=? id u)))))
