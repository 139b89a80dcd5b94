#lang racket/base
;; Structs that are values: their kind, their printed form, their equality.
;;
;;     (value-struct name [super] (field ...) clause ... option ...)
;;
;; is an authentic `struct`, with these clauses before its own options:
;;
;;     #:kind kind            it joins the arithmetic, and prints as its kind says
;;     #:datum f              it prints as the datum (f value)
;;     #:text f               it prints as the text (f value)
;;     #:word text            messages call it so: "a point of a manifold"
;;     #:notation f           it is typeset as the tree (f value see) (notation.rkt); else as
;;                            its datum or the lines of its text
;;     #:equal-by part        two are equal if (part value) is
;;     #:equality same? hash  (same? a b recur) tells, and (hash value recur)
;;
;; Its text is the same under `print`, `write` and `display`.  The procedures may be
;; defined after the struct.

(require (for-syntax racket/base)
         "describe.rkt" "kind.rkt" "notation.rkt")

(provide value-struct)

(define-syntax (value-struct stx)
  (syntax-case stx ()
    [(_ name super fields . clauses)
     (identifier? #'super)
     (quasisyntax/loc stx (struct name super fields #:authentic #,@(options #'clauses)))]
    [(_ name fields . clauses)
     (quasisyntax/loc stx (struct name fields #:authentic #,@(options #'clauses)))]))

;; The clauses in the terms of `struct`.  They stay lambdas that it sees, for then the
;; compiler knows that to make the type does nothing else.
(define-for-syntax (options clauses)
  (syntax-case clauses ()
    [(#:kind kind . more)
     #`(#:property prop:kind kind
        #,@(if (says-how-it-prints? #'more) '() (printing #'write-value #'values))
        #,@(options #'more))]
    [(#:datum f . more)
     #`(#,@(printing #'write-value #'f) #,@(typesetting #'datum-notation #'f #'more)
        #:property prop:printed-datum (lambda (v) (f v))
        #,@(options #'more))]
    [(#:text f . more)
     #`(#,@(printing #'write-string #'f) #,@(typesetting #'text-notation #'f #'more)
        #,@(options #'more))]
    [(#:word text . more)
     #`(#:property prop:word text #,@(options #'more))]
    [(#:notation f . more)
     #`(#:property prop:notation (lambda (v see) (f v see)) #,@(options #'more))]
    [(#:equal-by part . more)
     #`(#,@(equality #'(lambda (a b recur) (recur (part a) (part b)))
                     #'(lambda (v recur) (recur (part v))))
        #,@(options #'more))]
    [(#:equality same? hash . more)
     #`(#,@(equality #'(lambda (a b recur) (same? a b recur)) #'(lambda (v recur) (hash v recur)))
        #,@(options #'more))]
    [own #'own]))

(define-for-syntax (says-how-it-prints? clauses) (mentions? clauses '(#:datum #:text)))

(define-for-syntax (mentions? clauses names)
  (for/or ([c (in-list (syntax->list clauses))]) (memq (syntax-e c) names)))

;; Nothing where the clauses that follow say it.
(define-for-syntax (typesetting make part clauses)
  (if (mentions? clauses '(#:notation))
      '()
      #`(#:property prop:notation (lambda (v see) (#,make (#,part v) see)))))

(define-for-syntax (printing write part)
  #`(#:property prop:custom-print-quotable 'never
     #:property prop:custom-write (lambda (v port mode) (#,write (#,part v) port))))

(define-for-syntax (equality same? hash)
  #`(#:property prop:equal+hash (list #,same? #,hash #,hash)))
