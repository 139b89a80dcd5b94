#lang racket/base
;; From an entry in the table of operations to the record that kinds see.
;;
;; (define-record id name arity procedure) defines id as the record of that
;; entry.  The derivatives are read where define-record stands, so that `g:cos`
;; in them is what `g:cos` means there.

(require (for-syntax racket/base)
         "kind.rkt"
         "../algebra/operation-table.rkt" "../algebra/operation.rkt")

(provide define-record)

(define-syntax (define-record stx)
  (syntax-case stx ()
    [(_ id name arity procedure)
     (syntax-case (find-entry (syntax-e #'name) (syntax-e #'arity)) ()
       [(_ arguments numeric domain partial ...)
        (let ([here (lambda (s) (datum->syntax stx (syntax->datum s) s))])
          (with-syntax ([op (here (datum->syntax #f (prefixed #'name)))]
                        [(argument ...) (here #'arguments)]
                        [value (here #'value)]
                        [slope (here #'slope)]
                        [slope-at (here #'slope-at)]
                        [(partial ...) (here #'(partial ...))])
            #'(define id
                (generic-op 'name op procedure
                            (list (lambda (argument ... value)
                                    (define-syntax-rule (slope a b)
                                      (slope-at 'name (list argument ...) a b))
                                    partial)
                                  ...)
                            'domain))))])]))

(define-for-syntax (prefixed name)
  (string->symbol (format "op:~a" (syntax-e name))))
