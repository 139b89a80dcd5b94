#lang racket/base
;; The forms of `#lang mechanics/worksheet`.  Each adds a part to the worksheet of its module, in
;; their order; definitions between them stay with the teacher.

(require (for-syntax racket/base racket/file
                     "../error/spelling.rkt" "../teaching/worksheet/exercise-clauses.rkt")
         (prefix-in m: "redefinition/module.rkt")
         "../error/complain.rkt"
         "../generic/describe.rkt"
         "../teaching/worksheet/deadlines.rkt" "../teaching/worksheet/exercise.rkt"
         "../teaching/worksheet/make-exercise.rkt" "../teaching/worksheet/make-worksheet.rkt"
         "../teaching/worksheet/student-numbers.rkt")

(provide (rename-out [worksheet-begin #%module-begin]
                     [title-form title] [text-form text] [given-form given]
                     [deadline-form deadline] [credit-form credit] [parameters-form parameters]
                     [formula-form formula] [exercise-form exercise]))

;; title, due : or #f; credit : clauses of the exercises that follow; parts : latest first
(struct draft ([title #:mutable] [due #:mutable] [credit #:mutable] [parts #:mutable]))

(define (add-part! d part) (set-draft-parts! d (cons part (draft-parts d))))

(define (set-title! d title due)
  (check-text 'title title)
  (when due (check-text 'title due))
  (set-draft-title! d title)
  (set-draft-due! d due))

;; who : the form
(define (check-text who x)
  (unless (string? x)
    (complain who "expected a text, in quotation marks\n  given: ~a" (value->text x))))

;; Numbers may stand among them.
(define (joined-texts parts)
  (define texts (for/list ([p (in-list parts)]) (if (number? p) (value->text p) p)))
  (for ([t (in-list texts)]) (check-text 'text t))
  (apply string-append texts))

;; An exercise's own clause counts for more.
(define (with-credit d clauses)
  (if (assq 'credit clauses) clauses (append clauses (draft-credit d))))

(define (finished d name)
  (make-worksheet (draft-title d) (draft-due d) name (reverse (draft-parts d))))

;; ---------------------------------------------------------------------------
;; The module

;; The name of a module's draft, which no program can write.
(define-for-syntax (draft-id stx) (datum->syntax stx (string->symbol "the worksheet")))

(define-syntax (worksheet-begin stx)
  (syntax-case stx ()
    [(_ form ...)
     (with-syntax ([d (draft-id stx)]
                   [name (source-name stx)]
                   [worksheet (datum->syntax stx 'worksheet)])
       (syntax/loc stx
         (m:#%module-begin
          (define-values (d) (draft #f #f '() '()))
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
    [(_ text #:due due) #`(set-title! #,(draft-id stx) text due)]
    [_ (raise-syntax-error
        #f "a title is a text, and says perhaps when it is due: (title \"...\" #:due \"...\")"
        stx)]))

(define-syntax (text-form stx)
  (syntax-case stx ()
    [(_ text ...)
     #`(add-part! #,(draft-id stx) (passage (joined-texts (list text ...))))]))

(define-syntax (formula-form stx)
  (syntax-case stx ()
    [(_ value) #`(add-part! #,(draft-id stx) (formula "" value))]
    [(_ label value) #`(add-part! #,(draft-id stx) (formula label value))]))

(define-syntax (deadline-form stx)
  (define (options? parts)
    (or (null? parts)
        (and (memq (syntax-e (car parts)) '(#:grace #:per-day #:days))
             (pair? (cdr parts))
             (options? (cddr parts)))))
  (syntax-case stx ()
    [(_ time option ...)
     (options? (syntax->list #'(option ...)))
     #`(add-part! #,(draft-id stx) (make-deadline time option ...))]
    [_ (raise-syntax-error
        #f (string-append "a deadline is a time, with what lateness costs perhaps: "
                          "(deadline \"2026-11-20 18:00\" #:grace 15 #:per-day 1/10 #:days 3)")
        stx)]))

;; The credit of the exercises that follow.
(define-syntax (credit-form stx)
  (with-syntax ([clause (clause-expression 'credit stx stx)])
    #`(set-draft-credit! #,(draft-id stx) (list clause))))

;; Numbers that are each student's own.
(define-syntax (parameters-form stx)
  (define (choices entry)
    (syntax-case entry ()
      [(name #:from from #:to to #:step step) #'(stepped 'name from to step)]
      [(_ value ...) #'(list value ...)]))
  (define (entry? e)
    (syntax-case e () [(name value ...) (identifier? #'name)] [_ #f]))
  (define (expanded seed entries)
    (with-syntax ([seed seed]
                  [((name _ ...) ...) entries]
                  [(values ...) (map choices entries)])
      #`(begin (define name (student-number 'name seed values)) ...
               (add-part! #,(draft-id stx) (make-numbers '(name ...) (list name ...))))))
  (syntax-case stx ()
    [(_ #:seed seed entry ...)
     (andmap entry? (syntax->list #'(entry ...)))
     (expanded #'seed (syntax->list #'(entry ...)))]
    [(_ entry ...)
     (andmap entry? (syntax->list #'(entry ...)))
     (expanded #'0 (syntax->list #'(entry ...)))]
    [_ (raise-syntax-error
        #f (string-append "parameters are names with their values: "
                          "(parameters #:seed 2026 [l 1 3/2 2] [m #:from 1 #:to 3 #:step 1/2])")
        stx)]))

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
     (let ([who (syntax-e #'name)])
       (check-question who #'question stx)
       (with-syntax ([(made ...) (for/list ([c (in-list (syntax->list #'(clause ...)))])
                                   (clause-expression who c stx))])
         #`(add-part! #,(draft-id stx)
                     (make-exercise 'name 'kind question
                                    (with-credit #,(draft-id stx) (list made ...))))))]
    [_ (raise-syntax-error
        #f "an exercise has a name, a kind and a question: (exercise name kind \"...\" clause ...)"
        stx)]))

(begin-for-syntax
  (define (head-of stx)
    (define parts (syntax-e stx))
    (and (pair? parts) (identifier? (car parts)) (syntax-e (car parts))))

  (define (check-question who question stx)
    (when (and (identifier? question)
               (regexp-match? #rx"^[“”„«]" (symbol->string (syntax-e question))))
      (raise-syntax-error who "a text stands in straight quotation marks, \"...\"" stx question))
    (when (memq (head-of question) clause-names)
      (raise-syntax-error who "the question is missing, a text behind the kind of the exercise"
                          stx question)))

  ;; Names are not evaluated, and keywords stand for themselves.
  (define (clause-expression who clause stx)
    (define head (head-of clause))
    (define parts (syntax->list clause))
    (define (refuse text . operands)
      (raise-syntax-error who (apply format text operands) stx clause))
    (cond [(not (and head parts))
           (refuse "a clause is a list that begins with its name, such as (points 3)")]
          [(not (memq head clause-names))
           (refuse "there is no clause called ~a~a" head (among head clause-names))]
          [(odd-keyword head (cdr parts))
           => (lambda (k) (refuse "the clause `~a` takes no keyword ~a" head (syntax-e k)))]
          [(not (clause-fits? head (cdr parts)))
           (refuse "the clause `~a` takes ~a" head (values-wanted head))]
          [(names-clause? head) #`'#,clause]
          [else
           (with-syntax ([head (car parts)]
                         [(value ...) (for/list ([a (in-list (cdr parts))])
                                        (if (keyword? (syntax-e a)) #`'#,a a))])
             #'(list 'head value ...))]))

  (define (odd-keyword head parts)
    (findf (lambda (p) (and (keyword? (syntax-e p)) (not (memq (syntax-e p) (keywords-of head)))))
           parts))

  (define (clause-fits? head parts)
    (and (values-fit? head (length (without-keywords parts)))
         (or (not (eq? head 'credit)) (pair? parts))
         (or (not (names-clause? head)) (andmap identifier? parts))))

  ;; #:absolute stands alone, other keywords before their values.
  (define (without-keywords parts)
    (cond [(null? parts) '()]
          [(eq? '#:absolute (syntax-e (car parts))) (without-keywords (cdr parts))]
          [(and (keyword? (syntax-e (car parts))) (pair? (cdr parts)))
           (without-keywords (cddr parts))]
          [else (cons (car parts) (without-keywords (cdr parts)))]))

  ;; The forms as they stand in the file; or as data where there is none.
  (define (source-text forms)
    (define-values (first-form last-form) (values (car forms) (car (reverse forms))))
    (define source (syntax-source first-form))
    (define-values (start last-start)
      (values (syntax-position first-form) (syntax-position last-form)))
    (if (and (path? source) (file-exists? source) start last-start)
        (let ([text (regexp-replace* #rx"\r\n?" (file->string source) "\n")])
          (without-indentation
           (substring text (- start 1) (+ last-start (syntax-span last-form) -1))
           (syntax-column first-form)))
        (apply string-append
               (for/list ([f (in-list forms)]) (format "~s\n" (syntax->datum f))))))

  (define (without-indentation text column)
    (regexp-replace* (pregexp (format "\n {1,~a}" (max 1 column))) text "\n")))
