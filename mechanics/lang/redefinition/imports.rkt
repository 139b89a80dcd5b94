#lang racket/base
;; Names that a module both imports and defines.

(require (only-in racket/list append-map partition)
         "import-clash.rkt" "definitions.rkt" "specification.rkt"
         (for-template racket/base
                       "start-with.rkt"))

(provide start-as-outside
         require-without-clashes)

;; ---------------------------------------------------------------------------
;; From the language, or from the module around a submodule

;; A form that defines a name as its meaning outside the module.
(define (start-as-outside id)
  #`(start-with #,id #,(bound-as (syntax-e id) (identifier-binding id))))

;; An identifier with this binding, whatever the binding of its name.
(define (bound-as name binding)
  (syntax-binding-set->syntax
   (syntax-binding-set-extend (syntax-binding-set) name 0 (car binding)
                              #:source-symbol (cadr binding))
   name))

;; ---------------------------------------------------------------------------
;; By `require`

;; Forms for a `require` of names that the module defines: they are not imported.  Names used
;; before get the imported values, and so do names defined before that are listed one by one.
;; Other names defined before stay, and a note says so.  #f for all other forms.
(define (require-without-clashes ds form)
  (syntax-case form ()
    [(keyword spec ...)
     (and (identifier? #'keyword) (free-identifier=? #'keyword #'require))
     (let* ([specs (distinct-specifications (syntax->list #'(spec ...)))]
            [clashes (for/list ([spec (in-list specs)]) (clashing-names ds spec))])
       (and (ormap pair? clashes)
            (append-map (lambda (spec ids) (without-clashes ds #'keyword spec ids))
                        specs clashes)))]
    [_ #f]))

(define (clashing-names ds spec)
  (for/list ([id (in-list (or (names-imported spec) '()))] #:when (defining-occurrence ds id))
    id))

;; keyword : `require` as it was written, for editors
(define (without-clashes ds keyword spec ids)
  (define by-name (named-by spec))
  (define-values (staying open)
    (partition (lambda (id) (and (defined? ds id) (not (memq (syntax-e id) by-name)))) ids))
  (tell-clashes ds spec staying)
  (define wanted (filter (lambda (id) (or (used-early? ds id) (defined? ds id))) open))
  (define hidden (for/list ([id (in-list wanted)]) (datum->syntax #'here (syntax-e id))))
  (append
   (list (if (null? ids) #`(#,keyword #,spec) #`(#,keyword (except-in #,spec #,@ids))))
   (if (null? wanted) '() (list #`(#,keyword (only-in #,spec #,@(map list wanted hidden)))))
   (for/list ([id (in-list wanted)] [h (in-list hidden)])
     #`(start-with #,(defining-occurrence ds id) #,(as-if-written h)))))

;; Prints the note during expansion, so once for each time the module is compiled.
(define (tell-clashes ds spec ids)
  (unless (null? ids)
    (tell-clash (syntax->datum spec)
                (for/list ([id (in-list ids)])
                  (define-values (header line) (definition-header-and-line ds id))
                  (clash (syntax-e id) header line)))))

;; For editors, which find unused libraries by the identifiers that the program writes.
(define (as-if-written id)
  (syntax-property id 'original-for-check-syntax #t))
