#lang racket/base
;; `if` and its kin, which refuse a verdict for a test: any verdict, a refutation too, would count
;; as true.
;;
;; They are Racket's forms around tests that are checked.  The check costs nothing for #t and #f.

(require (for-syntax racket/base
                     "written-form.rkt")
         "../generic/naming.rkt" "../generic/no-truth-value.rkt")

(provide (rename-out [asking-if if] [asking-cond cond] [asking-and and] [asking-or or]
                     [asking-not not] [asking-when when] [asking-unless unless]))

(begin-for-syntax
  ;; A form whose first part is a test: Racket's `form`, of at least so many parts.
  (define ((one-test form least [most +inf.0]) stx)
    (syntax-case stx ()
      [(_ test part ...)
       (<= least (length (syntax->list #'(part ...))) most)
       (quasisyntax/loc stx (#,form (truth #,form test) part ...))]
      [_ (plain-form form stx)]))

  ;; A form whose parts are tests, but for the last, which is the value.
  (define ((all-tests form) stx)
    (syntax-case stx ()
      [(_ test ... last) (quasisyntax/loc stx (#,form (truth #,form test) ... last))]
      [_ (plain-form form stx)])))

(define-syntax asking-if (one-test #'if 2 2))
(define-syntax asking-when (one-test #'when 1))
(define-syntax asking-unless (one-test #'unless 1))
(define-syntax asking-and (all-tests #'and))
(define-syntax asking-or (all-tests #'or))

(define-syntax (asking-cond stx)
  (syntax-case stx (else)
    [(_ [test . body] ... [else first . last])
     (with-tests stx #'((test . body) ...) #'([else first . last]))]
    [(_ [test . body] ...) (with-tests stx #'((test . body) ...) #'())]
    [_ (plain-form #'cond stx)]))

;; stx : the form; tail : () or its clause with else.  Racket refuses an else elsewhere, and a wrong
;; form behind =>, in the form as it was written.
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
