#lang racket/base
;; Columns of the table of operations, and lists that are made from it.
;;
;; A column gives for every function of the table its counterpart in some language, or kind of
;; number.  It stands in the file that needs it, so that a new cell recompiles few files.

(require (for-syntax racket/base
                     (rename-in "operation-table.rkt" [reciprocals table:reciprocals])))

(provide define-column define-fact-column operation-names operation-key reciprocals)

;; (define-column id [key value] [(key ...) value] [key (none "why")] ...) defines id as an
;; immutable table from keys to values, without the keys that have none.  To lack a function is an
;; error of syntax; arithmetic and composite operations may be there.
(define-syntax (define-column stx)
  (syntax-case stx ()
    [(_ id clause ...)
     (let ([cells (apply append (map clause->cells (syntax->list #'(clause ...))))])
       (check-keys stx (map car cells))
       (with-syntax ([((key value) ...) (filter cell-value cells)])
         #'(define id (make-immutable-hasheq (list (cons 'key value) ...)))))]))

(begin-for-syntax
  ;; A cell is a list of key and value, the value #f where there is none.
  (define cell-value cadr)

  (define (clause->cells clause)
    (syntax-case clause ()
      [[(key ...) value] (for/list ([k (in-list (syntax->datum #'(key ...)))])
                           (list k (value-or-none #'value)))]
      [[key value] (list (list (syntax-e #'key) (value-or-none #'value)))]))

  (define (value-or-none value)
    (syntax-case value ()
      [(head why) (and (eq? 'none (syntax-e #'head)) (string? (syntax-e #'why))) #f]
      [_ value]))

  (define (check-keys stx keys)
    (define required (map entry-key (entries-where 'function)))
    (define (refuse what ks)
      (unless (null? ks) (raise-syntax-error #f (format "the column ~a: ~a" what ks) stx)))
    (refuse "lacks operations" (filter (lambda (k) (not (memq k keys))) required))
    (refuse "has operations that the table lacks"
            (filter (lambda (k) (not (find-entry k))) keys))))

;; (define-fact-column id fact) defines id as the table of that fact's values, by key; it is an
;; expression, read where the column stands.
(define-syntax (define-fact-column stx)
  (syntax-case stx ()
    [(_ id fact)
     (let ([entries (entries-where (syntax-e #'fact))])
       (with-syntax ([(key ...) (map entry-key entries)]
                     [(value ...) (for/list ([e (in-list entries)])
                                    (datum->syntax stx (car (entry-fact e (syntax-e #'fact)))))])
         #'(define id (make-immutable-hasheq (list (cons 'key value) ...)))))]))

;; The names of the operations in these groups, `arithmetic`, `function` or `reciprocal`, or of
;; those with these facts, a quoted list.
(define-syntax (operation-names stx)
  (syntax-case stx ()
    [(_ group ...)
     (with-syntax ([names (apply append (map group-names (syntax->datum #'(group ...))))])
       #''names)]))

(define-for-syntax (group-names group)
  (if (eq? group 'reciprocal)
      (map car table:reciprocals)
      (for/fold ([names '()] #:result (reverse names)) ([e (in-list (entries-where group))])
        (define name (entry-name e))
        (if (memq name names) names (cons name names)))))

;; Functions printed as quotients: ((name . function whose reciprocal it is) ...)
(define-syntax (reciprocals stx)
  #`'#,(for/list ([r (in-list table:reciprocals)]) (cons (car r) (cadr r))))

;; The key of the operation of that name and number of arguments.
(define (operation-key name arguments)
  (if (and (eq? name 'atan) (eqv? arguments 2)) 'atan2 name))
