#lang racket/base
;; Requires of which no name stands in the file.
;;
;; Names are compared as they are written, and nothing is expanded: all files take seconds, where
;; an analysis of the expanded modules takes minutes, and cannot see into submodules.  A require
;; passes if one of its names stands in the file for something else.  Required modules are loaded,
;; so they had better be compiled.

(require racket/list racket/match racket/set syntax/modread syntax/modresolve)

(provide unnamed-requires)   ; file -> the module paths, as they stand there

(define (unnamed-requires file)
  (define body (module-body file))
  (define-values (requires rest) (partition (lambda (form) (headed? form 'require)) body))
  (define names (symbols-of rest (mutable-seteq)))
  (define handed-on (modules-handed-on rest))
  (for*/list ([form (in-list requires)]
              [spec (in-list (cdr form))]
              [part (in-list (parts spec))]
              #:unless (or (member (car part) handed-on) (named? part names file)))
    (car part)))

(define (headed? form head) (and (pair? form) (eq? (car form) head)))

;; The forms of a module in racket/base; '() of other files, whose language may read differently.
(define (module-body file)
  (define form
    (call-with-input-file file
      (lambda (in)
        (port-count-lines! in)
        (with-module-reading-parameterization
         (lambda () (syntax->datum (read-syntax file in)))))))
  (match form
    [`(module ,_ racket/base (#%module-begin . ,body)) body]
    [`(module ,_ racket/base . ,body) body]
    [_ '()]))

;; The modules of which all names are provided.
(define (modules-handed-on forms)
  (let walk ([x forms])
    (match x
      [`(all-from-out . ,modules) modules]
      [(cons a b) (append (walk a) (walk b))]
      [_ '()])))

(define (symbols-of x found)
  (let walk ([x x])
    (cond [(pair? x) (walk (car x)) (walk (cdr x))]
          [(symbol? x) (set-add! found x)]
          [(vector? x) (for ([e (in-vector x)]) (walk e))]
          [(box? x) (walk (unbox x))]))
  found)

;; ---------------------------------------------------------------------------
;; Names of a require

;; A module of a require, and what becomes of a name it provides: the local name, or #f.
;; Where no name is chosen, the module is wanted for being loaded.
;; -> ((path . rename) ...)
(define (parts spec [rename values])
  (match spec
    [`(only-in ,_) '()]
    [`(only-in ,m . ,chosen)
     (define local
       (for/hasheq ([c (in-list chosen)])
         (if (pair? c) (values (car c) (cadr c)) (values c c))))
     (parts m (lambda (name) (let ([new (hash-ref local name #f)]) (and new (rename new)))))]
    [`(except-in ,m . ,left-out)
     (parts m (lambda (name) (and (not (memq name left-out)) (rename name))))]
    [`(prefix-in ,prefix ,m)
     (parts m (lambda (name) (rename (string->symbol (format "~a~a" prefix name)))))]
    [`(rename-in ,m . ,changes)
     (parts m (lambda (name) (rename (cond [(assq name changes) => cadr] [else name]))))]
    [`(,(or 'for-syntax 'for-template 'combine-in) . ,specs)
     (append-map (lambda (s) (parts s rename)) specs)]
    [`(,(or 'for-meta 'only-meta-in) ,_ . ,specs)
     (append-map (lambda (s) (parts s rename)) specs)]
    [`(,(or 'for-label 'quote) . ,_) '()]
    [_ (list (cons spec rename))]))

;; Forms such as #%app are used without being written; where a module gives nothing, it is
;; required for what it does.
(define (named? part names file)
  (define given (exported-names (car part) file))
  (or (null? given)
      (for/or ([name (in-list given)])
        (define local ((cdr part) name))
        (and local (or (set-member? names local) (implicit? name))))))

(define (implicit? name) (regexp-match? #rx"^#%" (symbol->string name)))

(define (exported-names path file)
  (define module (resolve-module-path path file))
  (parameterize ([current-namespace namespace])
    (dynamic-require module (void))
    (define-values (variables syntaxes) (module->exports module))
    (remove-duplicates
     (for*/list ([level (in-list (append variables syntaxes))] [entry (in-list (cdr level))])
       (car entry)))))

(define namespace (make-base-empty-namespace))
