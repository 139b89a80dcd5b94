#lang racket/base
;; Every name that mechanics or another of our libraries exports has an entry in the manual,
;; and every entry is of a name that one of the modules the manual describes exports.
;;
;; Entries are found by reading the manual's source, without running it.

(require (for-label mechanics mechanics/animate mechanics/answers mechanics/book mechanics/geometry
                    mechanics/pict
                    mechanics/plot mechanics/rackunit mechanics/scmutils
                    (except-in mechanics/worksheet #%module-begin))
         racket/file
         racket/list
         racket/path
         racket/runtime-path
         "support/checks.rkt" "support/house/exports.rkt")

(define-runtime-path manual "../../scribblings/mechanics")

;; ---------------------------------------------------------------------------
;; The manual

(define (manual-forms)
  (for/list ([file (in-list (find-files (lambda (p) (path-has-extension? p #".scrbl")) manual))])
    (call-with-input-file file read-form)))

(define (read-form port)
  (parameterize ([read-accept-reader #t]
                 [read-accept-lang #t])
    (syntax->datum (read-syntax (object-name port) port))))

;; (visit form) -> list, for every part of a form that is a list with a symbol
;; at its head, joined.
(define (collect form visit)
  (cond [(not (pair? form)) '()]
        [else
         (append (if (and (symbol? (car form)) (list? form)) (visit form) '())
                 (collect (car form) visit)
                 (collect (cdr form) visit))]))

;; The names that the entries in a form are about.
(define (documented-names form)
  (remove-duplicates
   (collect form
            (lambda (entry)
              (define arguments (without-keywords (cdr entry)))
              (if (null? arguments) '() (entry-names (car entry) entry arguments))))))

(define (entry-names kind entry arguments)
  (define first-argument (car arguments))
  (case kind
    [(defproc) (head-name first-argument)]
    [(defproc*) (append-map (lambda (clause) (head-name (car clause))) first-argument)]
    [(defform defform/subs defform/none)
     (cond [(memq '#:id entry) => (lambda (rest) (head-name (cadr rest)))]
           [(eq? kind 'defform/none) '()]
           [else (head-name first-argument)])]
    [(defform* defform*/subs) (append-map head-name first-argument)]
    [(defthing defparam defparam* defboolparam defidform) (head-name first-argument)]
    [(defthing* defthings) (append-map head-name first-argument)]
    [(defstruct defstruct*) (struct-names (car (head-name first-argument)) (cadr arguments))]
    [else '()]))

;; name, (name argument ...), ((name argument ...) argument ...)
(define (head-name head)
  (cond [(symbol? head) (list head)]
        [(pair? head) (head-name (car head))]
        [else '()]))

(define (struct-names name fields)
  (append (list name (symbol-append name '?))
          (for/list ([field (in-list fields)])
            (symbol-append name '- (car (head-name field))))))

(define (symbol-append . parts)
  (string->symbol (apply string-append (map symbol->string parts))))

(define (without-keywords arguments)
  (cond [(null? arguments) '()]
        [(not (keyword? (car arguments))) (cons (car arguments) (without-keywords (cdr arguments)))]
        [(memq (car arguments) '(#:link-target? #:kind #:id #:literals #:value #:grammar #:contracts
                                 #:auto-value #:extra-constructor-name #:constructor-name))
         (without-keywords (drop arguments (min 2 (length arguments))))]
        [else (without-keywords (cdr arguments))]))

;; The modules that the manual describes.
(define (described-modules form)
  (remove-duplicates
   (collect form
            (lambda (entry)
              (define arguments (without-keywords (cdr entry)))
              (if (and (memq (car entry) '(defmodule defmodule*))
                       (pair? arguments)
                       (symbol? (car arguments)))
                  (list (car arguments))
                  '())))))

(define (in-order names) (sort names symbol<?))

;; ---------------------------------------------------------------------------

(define sample-page
  #<<end
#lang scribble/manual
@defmodule[mechanics/sample #:use-sources (x)]
Text with @racket[(defproc (not-an-entry) any/c)] in it.
@defproc[(evolve [f procedure?] [#:step h real? 1]) procedure?]{Text.}
@defproc[((curried [a any/c]) [b any/c]) any/c]{Text.}
@defproc*[([(one [a any/c]) any/c] [(two) any/c])]{Text.}
@deftogether[(@defthing[#:kind "constant" pi real?] @defthing[:pi real?])]{Text.}
@defform[(with-literals (name ...) body ...+)]{Text.}
@defform[#:id up #:literals (x) (up pattern ...)]{Text.}
@defform*[((three a) (four b))]
@defparam[limit n integer?]
@defstruct*[verdict ([status symbol?] [witness any/c])]
end
  )

(test-case "entries of every kind are found"
  (define form (read-form (open-input-string sample-page)))
  (check-equal? (in-order (remove 'not-an-entry (documented-names form)))
                (in-order '(evolve curried one two pi :pi with-literals up three four limit
                            verdict verdict? verdict-status verdict-witness)))
  (check-equal? (described-modules form) '(mechanics/sample)))

(test-case "what a module passes on from racket/base is not its own"
  (check-equal? (own-names 'racket/base) '())
  (check-not-false (memq 'first (own-names 'racket/list)))
  (check-false (memq 'car (own-names 'racket))))

(define forms (manual-forms))
(define documented (remove-duplicates (append-map documented-names forms)))

(for ([module-path '(mechanics mechanics/animate mechanics/answers mechanics/book mechanics/geometry
                      mechanics/pict
                     mechanics/plot mechanics/rackunit mechanics/scmutils mechanics/worksheet)])
  (test-case (format "every name that ~a exports is documented" module-path)
    (check-equal? (in-order (remove* documented (own-names module-path))) '())))

(test-case "every documented name is exported by a module the manual describes"
  (define modules (remove-duplicates (cons 'mechanics (append-map described-modules forms))))
  (define exported (append-map (lambda (m) (hash-keys (export-table m))) modules))
  (check-equal? (in-order (remove* exported documented)) '()))
