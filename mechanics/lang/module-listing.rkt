#lang racket/base
;; What the forms of a module define and use, as far as it is seen before they
;; are expanded: which names are defined more than once, and which are used too
;; early.
;;
;; A form is run where it stands, but the body of a function is not: it is run
;; wherever the function is called.  So going down the forms, the names *reached*
;; are those in a form that is run, and with a name of a function or a macro all
;; the names in it.  A name that is reached when its definition comes is early.
;; Names are told apart by how they are spelt, so that a local variable may make
;; a name early that is not: then it becomes an assigned variable in vain.

(require (for-template racket/base (prefix-in pattern: "pattern.rkt")))

(provide (struct-out listing) read-listing
         defined-by-define run-by-definition? same-name?)

;; defined : the identifiers that `define` and `define-values` define, each where
;; it is defined first.  repeated, early : those of them.
(struct listing (defined repeated early))

(define (read-listing forms)
  (define pieces (filter values (map read-piece (spliced forms))))
  (define-values (defined repeated) (first-and-repeated (append-map variables pieces)))
  (listing defined repeated (early-names pieces defined)))

(define (append-map f xs) (apply append (map f xs)))

;; Is it the same name, in the same context?
(define ((same-name? id) other) (bound-identifier=? id other))

(define (first-and-repeated ids)
  (for/fold ([seen (hasheq)] [firsts '()] [repeated '()]
             #:result (values (reverse firsts) (reverse repeated)))
            ([id (in-list ids)])
    (define before (hash-ref seen (syntax-e id) '()))
    (if (ormap (same-name? id) before)
        (values seen firsts (cons id repeated))
        (values (hash-set seen (syntax-e id) (cons id before)) (cons id firsts) repeated))))

;; ---------------------------------------------------------------------------
;; Forms

;; A form that defines or is run.  ids : what it defines; variables? : as
;; variables, not as macros; run? : is something run where it stands?;
;; content : syntax with the names it uses.
(struct piece (ids variables? run? content))

(define (variables p) (if (piece-variables? p) (piece-ids p) '()))

;; The forms, those inside `begin` included.
(define (spliced forms)
  (append-map (lambda (form)
                (syntax-case form (begin)
                  [(begin inner ...) (spliced (syntax->list #'(inner ...)))]
                  [_ (list form)]))
              forms))

;; A piece, or #f for a form that neither defines what we follow nor is run.
(define (read-piece form)
  (syntax-case form (define-values)
    [(_ head . body)
     (defined-by-define form)
     (piece (list (defined-by-define form)) #t
            (and (identifier? #'head) (run-by-definition? #'body))
            (if (identifier? #'head) #'body #'(head . body)))]
    [(define-values (id ...) value)
     (andmap identifier? (syntax->list #'(id ...)))
     (piece (syntax->list #'(id ...)) #t (run-by-definition? #'(value)) #'value)]
    [(keyword head . body)
     (head-among? #'keyword macro-definitions)
     (let ([id (defined-name #'head)])
       (and id (piece (list id) #f #f #'body)))]
    [(keyword . _) (head-among? #'keyword not-run) #f]
    [_ (piece '() #f #t form)]))

;; The name that a `define` defines, or #f if the form is none.
(define (defined-by-define form)
  (syntax-case form ()
    [(keyword head . _)
     (head-among? #'keyword (list #'pattern:define #'define))
     (defined-name #'head)]
    [_ #f]))

;; The name that a head defines, or #f.
(define (defined-name head)
  (syntax-case head ()
    [(inner . _) (defined-name #'inner)]
    [_ (and (identifier? head) head)]))

;; Of a definition (define id expression): is the expression more than a procedure?
(define (run-by-definition? body)
  (syntax-case body ()
    [((keyword . _)) (not (head-among? #'keyword procedures))]
    [_ #t]))

(define (head-among? id ids)
  (and (identifier? id)
       (ormap (lambda (other) (free-identifier=? id other)) ids)))

(define procedures
  (list #'pattern:lambda #'pattern:λ #'pattern:case-lambda #'lambda #'λ #'case-lambda))

(define macro-definitions (list #'define-syntax #'define-syntax-rule))

(define not-run
  (list #'require #'provide #'module #'module* #'module+ #'struct #'define-syntaxes
        #'begin-for-syntax #'define-for-syntax #'define-values-for-syntax))

;; ---------------------------------------------------------------------------
;; Reaching

;; Those of the identifiers `defined` that are reached before their definition,
;; or by it: in (define x (+ x 1)) the x that is added to is another's.
(define (early-names pieces defined)
  (define known
    (for*/hasheq ([p (in-list pieces)] [id (in-list (piece-ids p))]) (values (syntax-e id) #t)))
  (define r (make-reaching))
  (for*/list ([p (in-list pieces)]
              [names (in-value (names-in (piece-content p) known))]
              [id (in-list (reach-by! r p names))]
              #:when (memq id defined))
    id))

;; What the piece does to r; the identifiers it defines that are reached.
(define (reach-by! r p names)
  (define (reached-by-now? id) (reached? r (syntax-e id)))
  (when (piece-run? p) (for-each (lambda (name) (reach! r name)) names))
  (define reached (filter reached-by-now? (piece-ids p)))
  (unless (piece-run? p)
    (for ([id (in-list (piece-ids p))]) (put-inside! r (syntax-e id) names)))
  reached)

;; names : reached ones; inside : name -> names in functions of that name
(struct reaching (names inside))

(define (make-reaching) (reaching (make-hasheq) (make-hasheq)))

(define (reached? r name) (hash-ref (reaching-names r) name #f))

(define (reach! r name)
  (unless (reached? r name)
    (hash-set! (reaching-names r) name #t)
    (for ([n (in-list (hash-ref (reaching-inside r) name '()))]) (reach! r n))))

(define (put-inside! r name names)
  (hash-update! (reaching-inside r) name (lambda (before) (append names before)) '())
  (when (reached? r name) (for ([n (in-list names)]) (reach! r n))))

;; The known names in a piece of syntax, quotations apart.
(define (names-in stx known)
  (define found (make-hasheq))
  (let walk ([stx stx])
    (define d (if (syntax? stx) (syntax-e stx) stx))
    (cond [(symbol? d) (when (hash-ref known d #f) (hash-set! found d #t))]
          [(pair? d)
           (unless (and (identifier? (car d)) (free-identifier=? (car d) #'quote))
             (walk (car d))
             (walk (cdr d)))]
          [(vector? d) (for ([x (in-vector d)]) (walk x))]))
  (hash-keys found))
