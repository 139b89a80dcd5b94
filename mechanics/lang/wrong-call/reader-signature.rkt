#lang racket/base
;; Hints beneath a message of a wrong number of arguments for a procedure of the reader's: how it
;; is called, which argument is missing, and that a local tuple is one argument, where its parts
;; were given.

(require racket/list
         racket/string
         "count-message.rkt" "error-location.rkt" "marked-line.rkt"
         "../written-form.rkt"
         "../help/card.rkt"
         "../redefinition/definition-head.rkt" "../redefinition/prompt.rkt"
         "../unknown-name/known-name.rkt")

(provide own-count-hint tuple-hint-of-library head->text)

;; message : Racket's; entry : the form typed at the prompt, a datum, or #f -> text or #f
(define (own-count-hint message marks entry)
  (define m (read-miscount message))
  (define name (and m (miscount-name m) (string->symbol (miscount-name m))))
  (define head (and name (own-head name marks)))
  (define formals (and head (list-at-fault m head)))
  (and formals
       (string-append
        (format "\n  it is called as ~a" (head->text head))
        (missing (map form->text (signature-needed (formals->signature formals)))
                 (miscount-given m))
        (tuple-hint formals (miscount-given m)
                    (call-in (or entry (form-evaluated marks)) name (miscount-given m))))))

;; ---------------------------------------------------------------------------
;; Argument lists

;; Of a head ((L m k) local), the one of the lists (m k) and (local) that the call did not fit;
;; or #f
(define (list-at-fault m head)
  (define expected (string->number (or (miscount-expected m) "")))
  (define (fits? formals n) (takes? (formals->signature formals) n))
  (define others
    (filter (lambda (formals) (not (fits? formals (miscount-given m)))) (argument-lists head)))
  (or (and expected (findf (lambda (formals) (fits? formals expected)) others))
      (and (pair? others) (car others))))

(define (argument-lists head)
  (if (pair? head)
      (append (argument-lists (car head)) (list (cdr head)))
      '()))

;; As a signature of the manual, without keywords; its arguments are data.
(define (formals->signature formals)
  (let loop ([formals formals] [positional '()])
    (cond [(not (pair? formals))
           (define-values (optional needed) (partition optional? (reverse positional)))
           (signature 'procedure '() #f needed optional '() (not (null? formals)) '())]
          [(and (keyword? (car formals)) (pair? (cdr formals))) (loop (cddr formals) positional)]
          [else (loop (cdr formals) (cons (car formals) positional))])))

(define (optional? a) (and (pair? a) (not (memq (car a) '(up down)))))

;; ---------------------------------------------------------------------------
;; A tuple, given as its parts

;; call : the call as it was written, or #f
(define (tuple-hint formals given call)
  (define pattern (and (list? formals) (= (length formals) 1) (car formals)))
  (cond [(or (not pattern) (keyword? pattern) (< given 2) (optional? pattern)) ""]
        [(and (pair? pattern) (not (= (length (cdr pattern)) given))) ""]
        [(and (symbol? pattern) (< given 3)) ""]
        [else
         (define parts (cond [call (cdr call)]
                             [(pair? pattern) (cdr pattern)]
                             [else '(t q v)]))
         (define tuple (cons (if (pair? pattern) (car pattern) 'up) parts))
         (one-tuple given (if call (list (car call) tuple) tuple))]))

(define (one-tuple n form)
  (format "\n  one ~atuple: ~a" (if (>= n 3) "local " "") (form->text form)))

;; For functions of the library that take a local tuple: ((Lagrangian->energy L) 't 'q 'v), and
;; (p->r 't 'q 'v), of which `said` tells the signature.
(define (tuple-hint-of-library message said marks entry)
  (define made-by
    (regexp-match #px"^\\(*([^\\s()]+) [^\n]*\\): takes 1 argument; it was given ([3-9])" message))
  (define m
    (cond [made-by (miscount (cadr made-by) #f (string->number (caddr made-by)))]
          [(regexp-match? #rx"[()][^ ()]* (local|state)[)]" said) (read-miscount message)]
          [else #f]))
  (define call
    (and m (>= (miscount-given m) 3)
         (call-in (or entry (form-evaluated marks))
                  (string->symbol (miscount-name m)) (miscount-given m))))
  (and call (one-tuple (miscount-given m) (list (car call) (cons 'up (cdr call))))))

;; The first call of the procedure with so many arguments in the form, a datum; or #f.  It may be
;; called in several steps.
(define (call-in form name given)
  (cond [(not (pair? form)) #f]
        [(and (list? form) (= (length form) (add1 given)) (eq? (head-name-in form) name)) form]
        [else (or (call-in (car form) name given) (call-in (cdr form) name given))]))

;; ---------------------------------------------------------------------------
;; As the manual has it: [y 2] for an argument that may be left out, [#:k k] for one with a
;; keyword.

(define (head->text head)
  (if (pair? head)
      (format "(~a~a)" (head->text (car head)) (formals->text (cdr head)))
      (format "~s" head)))

(define (formals->text formals)
  (cond [(null? formals) ""]
        [(not (pair? formals)) (format " ~s ..." formals)]
        [(and (keyword? (car formals)) (pair? (cdr formals)))
         (string-append (keyword->text (car formals) (cadr formals))
                        (formals->text (cddr formals)))]
        [else (string-append " " (argument->text (car formals)) (formals->text (cdr formals)))]))

(define (argument->text a)
  (if (optional? a) (format "[~a]" (string-join (map form->text a))) (form->text a)))

(define (keyword->text k a)
  (if (optional? a) (format " [~s ~a]" k (car a)) (format " ~s ~a" k (form->text a))))

;; ---------------------------------------------------------------------------
;; The head in the definition of a reader's procedure: typed at the prompt, or in a file

;; name : symbol; marks : of the exception -> head such as ((L m k) local), a datum, or #f
(define (own-head name marks)
  (define line (marked-line marks))
  (define file (or (own-file (defining-module name)) (and line (own-file (car line)))))
  (define head (or (head-at-prompt name) (and file (head-in-file name file))))
  (and (pair? head) head))

;; place : of a module -> path of its file, if that is the reader's, or #f
(define (own-file place)
  (and (path? place) (file-exists? place) (not (of-library? place)) place))

(define (head-in-file name file)
  (for/last ([form (in-list (forms-from file 1))]
             #:when (definition-of? name form))
    (definition-head form)))

(define (definition-of? name d)
  (and (list? d) (> (length d) 2)
       (eq? (car d) 'define)
       (eq? (head-name-in (cadr d)) name)))

;; The form that was being evaluated, of a file of the reader's, a datum; or #f
(define (form-evaluated marks)
  (define line (marked-line marks))
  (define file (and line (own-file (car line))))
  (define forms (if file (forms-from file (cdr line)) '()))
  (and (pair? forms) (car forms)))

;; The forms from that line on, as far as they can be read, without the line of the language.
(define (forms-from file line)
  (define kept
    (for/list ([text (in-list (lines-of file))] [i (in-naturals 1)] #:when (>= i line))
      (if (string-prefix? text "#lang") "" text)))
  (define port (open-input-string (string-join kept "\n")))
  (let loop ()
    (define form (with-handlers ([exn:fail:read? (lambda (e) eof)]) (read port)))
    (if (eof-object? form) '() (cons form (loop)))))
