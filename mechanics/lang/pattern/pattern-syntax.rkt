#lang racket/base
;; Structure patterns as syntax: recognising them, and compiling them.
;;
;; A pattern (up p ...) or (down p ...) holds identifiers, `_` for a component
;; that is not wanted, and patterns.  Compiled, every pattern of an argument
;; list becomes one check of shape, outermost first, and all the identifiers
;; are then bound together, each to one vector reference:
;;
;;     (let*-values ([(v) (components argument up 2 ...)] ...)
;;       (let-values ([(x) (unsafe-vector*-ref v 0)] ...)
;;         body ...))
;;
;; Identifiers keep the syntax they were written with, so that editors draw
;; their arrows.

(require (only-in racket/list append* append-map)
         "../written-form.rkt"
         (for-template racket/base
                       (only-in '#%unsafe unsafe-vector*-ref)
                       "mismatch.rkt" "tuple.rkt"))

(provide pattern? (struct-out bound) destructure
         head-name argument-lists
         formal-names fold-formals has-pattern? rewrite-formals rewrite-bindings
         check-arguments check-distinct note-pattern-heads)

;; ---------------------------------------------------------------------------
;; Patterns

(define (pattern? stx)
  (syntax-case stx ()
    [(head . _) (identifier? #'head) (and (orientation #'head) #t)]
    [_ #f]))

(define (orientation head)
  (cond [(free-identifier=? head #'up) 'up]
        [(free-identifier=? head #'down) 'down]
        [else #f]))

(define (components-of pattern)
  (or (syntax->list (datum->syntax #f (cdr (syntax-e pattern))))
      (raise-syntax-error #f "a structure pattern is a proper list" pattern)))

(define (wildcard? stx)
  (and (identifier? stx) (free-identifier=? stx #'_)))

(define (variable? stx)
  (cond [(not (identifier? stx)) #f]
        [(free-identifier=? stx #'(... ...))
         (raise-syntax-error
          #f "an ellipsis is allowed in the patterns of `match` only" stx)]
        [else (not (wildcard? stx))]))

(define (pattern-variables pattern)
  (append-map
   (lambda (p)
     (cond [(pattern? p) (pattern-variables p)]
           [(variable? p) (list p)]
           [(wildcard? p) '()]
           [else
            (raise-syntax-error
             #f "expected an identifier or a pattern (up ...) or (down ...)"
             pattern p)]))
   (components-of pattern)))

(define (pattern-heads pattern)
  (cons (car (syntax-e pattern))
        (append-map pattern-heads (filter pattern? (components-of pattern)))))

;; The pattern in messages.
(define (pattern->datum pattern)
  (cons (orientation (car (syntax-e pattern)))
        (for/list ([p (in-list (components-of pattern))])
          (if (pattern? p) (pattern->datum p) (syntax-e p)))))

;; ---------------------------------------------------------------------------
;; Compilation

;; A pattern, the identifier of the value it takes apart, and the name of that value in messages.
(struct bound (pattern value what))

;; The expression that runs body, a list of forms, with these patterns bound.
(define (destructure bounds who body)
  (define-values (checks variables)
    (for/lists (checks variables) ([b (in-list bounds)]) (compile-pattern b who)))
  #`(let*-values #,(append* checks)
      (let-values #,(append* variables) #,@body)))

;; Clauses of let*-values that check shapes, clauses of let-values that bind.
(define (compile-pattern b who)
  (define datum (pattern->datum (bound-pattern b)))
  (let compile ([pattern (bound-pattern b)] [value (bound-value b)])
    (define parts (components-of pattern))
    (define elements (fresh 'elements))
    (define check
      #`[(#,elements)
         (components #,value #,(orientation (car (syntax-e pattern)))
                     #,(length parts) '#,who '#,(bound-what b)
                     #,datum #,(bound-value b))])
    (for/fold ([checks (list check)] [variables '()])
              ([p (in-list parts)] [i (in-naturals)])
      (define component #`(unsafe-vector*-ref #,elements #,i))
      (cond
        [(pattern? p)
         (define part (fresh 'part))
         (define-values (inner-checks inner-variables) (compile p part))
         (values (append checks (list #`[(#,part) #,component]) inner-checks)
                 (append variables inner-variables))]
        [(variable? p)
         (values checks (append variables (list #`[(#,p) #,component])))]
        [else (values checks variables)]))))

(define (fresh name) (car (generate-temporaries (list name))))

;; ---------------------------------------------------------------------------
;; Heads of definitions and argument lists

;; The name that a head defines, however many argument lists follow it, or #f.
(define (head-name head)
  (syntax-case head ()
    [(inner . formals) (head-name #'inner)]
    [_ (and (identifier? head) head)]))

;; The argument lists of a head, from the inside out.
(define (argument-lists head)
  (syntax-case head ()
    [(inner . formals) (append (argument-lists #'inner) (list #'formals))]
    [_ '()]))

;; keyword : keyword, as syntax, or #f.  name : identifier, pattern, or any other form, for Racket
;; to refuse.  default : expression or #f.
(struct argument (keyword name default))

;; An argument list as arguments and a tail, () or the name of the rest.
(define (parse-formals formals)
  (let parse ([formals formals] [keyword #f])
    (syntax-case formals ()
      [(k . more)
       (and (not keyword) (keyword? (syntax-e #'k)))
       (parse #'more #'k)]
      [(a . more)
       (let-values ([(arguments tail) (parse #'more #f)])
         (values (cons (parse-argument #'a keyword) arguments) tail))]
      [tail
       (values (if keyword (list (argument #f keyword #f)) '()) #'tail)])))

(define (parse-argument a keyword)
  (syntax-case a ()
    [(name default)
     (not (pattern? a))
     (argument keyword #'name #'default)]
    [_ (argument keyword a #f)]))

;; step : name, default or #f, and an accumulator -> the next accumulator, along the arguments
(define (fold-formals step start formals)
  (define-values (arguments tail) (parse-formals formals))
  (define end
    (for/fold ([sum start]) ([a (in-list arguments)])
      (step (argument-name a) (argument-default a) sum)))
  (if (identifier? tail) (step tail #f end) end))

;; The names and patterns of an argument list, with that of the rest.
(define (formal-names formals)
  (reverse (fold-formals (lambda (name default names) (cons name names)) '() formals)))

(define (has-pattern? formals) (ormap pattern? (formal-names formals)))

;; Refuses a form in parentheses that is neither a pattern nor an optional argument: a pattern
;; whose head was forgotten.
(define (check-arguments formals stx)
  (for ([name (in-list (formal-names formals))])
    (when (and (pair? (syntax-e name)) (not (pattern? name)))
      (define written (syntax->datum name))
      (refuse stx name "~s is no argument; a structure pattern begins with up or down: ~s"
              written (cons 'up written)))))

;; An argument list without patterns, the patterns taken out of it, and the
;; identifiers it binds.  The default of an optional argument sees the
;; variables of the patterns before it.
(define (rewrite-formals formals who)
  (define-values (arguments tail) (parse-formals formals))
  (for/fold ([new '()] [bounds '()] [ids '()]
             #:result (values (append (reverse new) tail)
                              (reverse bounds)
                              (cons tail ids)))
            ([a (in-list arguments)]
             [what (in-list (argument-positions arguments))])
    (define-values (b here) (bind-name (argument-name a) what))
    (values (append (reverse (argument->syntax a b (reverse bounds) who)) new)
            (if b (cons b bounds) bounds)
            (append here ids))))

;; -> bound, or #f if the name is no pattern; and the identifiers that are bound
(define (bind-name name what)
  (if (pattern? name)
      (values (bound name (fresh 'tuple) what) (pattern-variables name))
      (values #f (list name))))

(define (argument->syntax a b earlier who)
  (define name (if b (bound-value b) (argument-name a)))
  (define default (argument-default a))
  (define written
    (cond [(not default) name]
          [(null? earlier) #`[#,name #,default]]
          [else #`[#,name #,(destructure earlier who (list default))]]))
  (if (argument-keyword a)
      (list (argument-keyword a) written)
      (list written)))

;; The name of each argument in messages.
(define (argument-positions arguments)
  (define (positional? a) (not (argument-keyword a)))
  (define alone? (= 1 (length (filter positional? arguments))))
  (let name ([arguments arguments] [i 1])
    (cond [(null? arguments) '()]
          [(positional? (car arguments))
           (cons (position i alone?) (name (cdr arguments) (add1 i)))]
          [else
           (cons (format "argument ~a" (syntax-e (argument-keyword (car arguments))))
                 (name (cdr arguments) i))])))

(define (position i alone?)
  (if alone? "the argument" (format "argument ~a" i)))

;; The left-hand sides of `let`, likewise; those of a loop are its arguments.
(define (rewrite-bindings names loop?)
  (define alone? (= 1 (length names)))
  (for/fold ([lefts '()] [bounds '()] [ids '()]
             #:result (values (reverse lefts) (reverse bounds) ids))
            ([name (in-list names)] [i (in-naturals 1)])
    (define-values (b here) (bind-name name (if loop? (position i alone?) "the value")))
    (values (cons (if b (bound-value b) name) lefts)
            (if b (cons b bounds) bounds)
            (append ids here))))

;; ---------------------------------------------------------------------------
;; Messages and notes of the expander, as if no pattern were there

(define (check-distinct ids kind stx)
  (define twice (check-duplicate-identifier (filter identifier? ids)))
  (when twice (refuse stx twice "duplicate ~a" kind)))

;; Pattern heads vanish in the expansion; editors are told that they were uses
;; of `up` and `down`.
(define (note-pattern-heads stx bounds)
  (syntax-property
   stx 'disappeared-use
   (map syntax-local-introduce
        (append-map pattern-heads (map bound-pattern bounds)))))
