#lang racket/base
;; The forms of `#lang mechanics/worksheet`.  Each adds a part to the worksheet of its module,
;; in the order in which they stand; what is defined between them the teacher keeps.

(require (for-syntax racket/base racket/file)
         (prefix-in m: "../redefinition/module.rkt")
         "../../error/complain.rkt"
         "../../generic/on-demand.rkt"
         "../../worksheet/exercise.rkt" "../../worksheet/make-exercise.rkt"
         "../../worksheet/make-worksheet.rkt")

(provide (rename-out [worksheet-begin #%module-begin]
                     [title-form title] [text-form text] [given-form given]
                     [formula-form formula] [exercise-form exercise]))

;; title, due : or #f; parts : latest first
(struct draft ([title #:mutable] [due #:mutable] [parts #:mutable]))

(define (add-part! d part) (set-draft-parts! d (cons part (draft-parts d))))

(define (set-title! d title due)
  (unless (string? title) (complain 'title "expected a text\n  given: ~e" title))
  (set-draft-title! d title)
  (set-draft-due! d due))

(define (finished d name)
  (make-worksheet (draft-title d) (draft-due d) name (reverse (draft-parts d))))

;; ---------------------------------------------------------------------------
;; The module

;; The name under which a module has its draft; no reader can write it.
(define-for-syntax (draft-id stx) (datum->syntax stx (string->symbol "the worksheet")))

(define-syntax (worksheet-begin stx)
  (syntax-case stx ()
    [(_ form ...)
     (with-syntax ([d (draft-id stx)]
                   [name (source-name stx)]
                   [worksheet (datum->syntax stx 'worksheet)])
       (syntax/loc stx
         (m:#%module-begin
          (define-values (d) (draft #f #f '()))
          form ...
          (define-values (worksheet) (finished d 'name))
          (#%provide worksheet)
          (module* main #f
            (#%plain-app display (#%plain-app outline worksheet))
            (#%plain-app newline)))))]))

(define-for-syntax (source-name stx)
  (define source (syntax-source stx))
  (if (path? source)
      (let-values ([(folder name dir?) (split-path source)])
        (path->string (path-replace-extension name #"")))
      "worksheet"))

;; ---------------------------------------------------------------------------
;; Parts

(define-syntax (title-form stx)
  (syntax-case stx ()
    [(_ text) #`(set-title! #,(draft-id stx) text #f)]
    [(_ text #:due due) #`(set-title! #,(draft-id stx) text due)]))

(define-syntax (text-form stx)
  (syntax-case stx ()
    [(_ text ...)
     #`(add-part! #,(draft-id stx) (passage (string-append text ...)))]))

(define-syntax (formula-form stx)
  (syntax-case stx ()
    [(_ value) #`(add-part! #,(draft-id stx) (formula "" value))]
    [(_ label value) #`(add-part! #,(draft-id stx) (formula label value))]))

;; Definitions for both, the teacher and the student.
(define-syntax (given-form stx)
  (syntax-case stx ()
    [(_ form ...)
     #`(begin form ...
              (add-part! #,(draft-id stx)
                         (given #,(source-text (syntax->list #'(form ...))))))]))

(define-syntax (exercise-form stx)
  (syntax-case stx ()
    [(_ name kind question clause ...)
     (and (identifier? #'name) (identifier? #'kind))
     (with-syntax ([(made ...) (map clause-expression (syntax->list #'(clause ...)))])
       #`(add-part! #,(draft-id stx) (make-exercise 'name 'kind question (list made ...))))]
    [_ (raise-syntax-error
        #f "an exercise has a name, a kind and a question: (exercise name kind \"...\" clause ...)"
        stx)]))

(begin-for-syntax
  ;; Names are not evaluated, and keywords stand for themselves.
  (define (clause-expression clause)
    (syntax-case clause ()
      [(head argument ...)
       (identifier? #'head)
       (if (memq (syntax-e #'head) '(coordinates arguments constants))
           #''(head argument ...)
           (with-syntax ([(value ...)
                          (for/list ([a (in-list (syntax->list #'(argument ...)))])
                            (if (keyword? (syntax-e a)) #`'#,a a))])
             #'(list 'head value ...)))]
      [_ (raise-syntax-error
          #f "a clause is a list that begins with its name, such as (points 3)" clause)]))

  ;; The forms as they stand in the file; or as data where there is none.
  (define (source-text forms)
    (define first-form (car forms))
    (define source (syntax-source first-form))
    (define-values (start end)
      (let ([last-form (car (reverse forms))])
        (values (syntax-position first-form)
                (and (syntax-position last-form)
                     (+ (syntax-position last-form) (syntax-span last-form))))))
    (if (and (path? source) (file-exists? source) start end)
        (let ([text (regexp-replace* #rx"\r\n?" (file->string source) "\n")])
          (without-indentation (substring text (- start 1) (- end 1))
                               (syntax-column first-form)))
        (apply string-append
               (for/list ([f (in-list forms)]) (format "~s\n" (syntax->datum f))))))

  (define (without-indentation text column)
    (regexp-replace* (pregexp (format "\n {1,~a}" (max 1 column))) text "\n")))
