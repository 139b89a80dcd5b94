#lang racket/base
;; `if` and its kin, which refuse a verdict for a test: it would pass for true whatever it says.
;;
;; They are Racket's, around tests that are looked at once more.  A test that is #t or #f, as of
;; numbers all are, costs nothing by that.

(require (for-syntax racket/base
                     "plain-form.rkt")
         "../generic/naming.rkt" "../generic/truth.rkt")

(provide (rename-out [asking-if if] [asking-cond cond] [asking-and and] [asking-or or]
                     [asking-not not] [asking-when when] [asking-unless unless]))

(define-syntax (asking-if stx)
  (syntax-case stx ()
    [(_ test then else) (syntax/loc stx (if (truth if test) then else))]
    [_ (plain-form #'if stx)]))

(define-syntax (asking-when stx)
  (syntax-case stx ()
    [(_ test body0 body ...) (syntax/loc stx (when (truth when test) body0 body ...))]
    [_ (plain-form #'when stx)]))

(define-syntax (asking-unless stx)
  (syntax-case stx ()
    [(_ test body0 body ...) (syntax/loc stx (unless (truth unless test) body0 body ...))]
    [_ (plain-form #'unless stx)]))

;; What comes last is no test, but the value.
(define-syntax (asking-and stx)
  (syntax-case stx ()
    [(_ test ... last)
     (with-syntax ([(tested ...) #'((truth and test) ...)])
       (syntax/loc stx (and tested ... last)))]
    [_ (plain-form #'and stx)]))

(define-syntax (asking-or stx)
  (syntax-case stx ()
    [(_ test ... last)
     (with-syntax ([(tested ...) #'((truth or test) ...)])
       (syntax/loc stx (or tested ... last)))]
    [_ (plain-form #'or stx)]))

(define-syntax (asking-cond stx)
  (syntax-case stx (else)
    [(_ [test . body] ... [else first . last])
     (with-tests stx #'((test . body) ...) #'([else first . last]))]
    [(_ [test . body] ...) (with-tests stx #'((test . body) ...) #'())]
    [_ (plain-form #'cond stx)]))

;; stx : the form; tail : () or its clause with else.  An else elsewhere Racket will refuse, and
;; what is wrong behind =>, in the form as it was written.
(define-for-syntax (with-tests stx clauses tail)
  (syntax-case clauses ()
    [([test . body] ...)
     (if (or (ormap else? (syntax->list #'(test ...)))
             (ormap half-arrow? (syntax->list #'(body ...))))
         (plain-form #'cond stx)
         (quasisyntax/loc stx (cond [(truth cond test) . body] ... . #,tail)))]))

(define-for-syntax (else? test) (and (identifier? test) (free-identifier=? test #'else)))

;; => without one expression behind it
(define-for-syntax (half-arrow? body)
  (syntax-case body (=>)
    [(=> f) #f]
    [(=> . _) #t]
    [_ #f]))

(define-named asking-not not (lambda (x) (not (truth not x))))
