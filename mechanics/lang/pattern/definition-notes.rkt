#lang racket/base
;; Definitions that Racket accepts, and that are hardly meant so:
;;
;;     (define (L (up t q v)) (* 'm 'v))       'v is a constant, not the velocity
;;     (define (L (up t q v)) (+ ...) (- ...))  the first expression is without effect
;;     (define (L (up q v t)) ...)              the time comes first
;;     (lambda t (* 2 t))                       t is the list of all arguments
;;
;; A note is printed where they are expanded, so when a file is compiled.  One definition has no
;; meaning, and is refused: (define (L m) (up t q v) ...), where the pattern belongs into the head.

(require (only-in racket/list append-map filter-map index-where)
         "pattern-syntax.rkt"
         "../written-form.rkt"
         "../paper-notation/operation-sign.rkt"
         "../../error/note.rkt"
         "../../operation/operation-column.rkt")

(provide check-pattern-in-head tell-slips)

;; ---------------------------------------------------------------------------
;; A pattern outside of the head

;; stx : a form that begins with `define`
(define (check-pattern-in-head stx)
  (syntax-case stx ()
    [(_ head pattern form . body)
     (shaped-like-pattern? #'pattern)
     (refuse stx #'pattern "a pattern stands among the arguments: ~s"
             (syntax->datum #'(define (head pattern) (... ...))))]
    [_ (void)]))

(define (shaped-like-pattern? stx)
  (syntax-case stx ()
    [(head part ...)
     (and (memq (syntax-e #'head) '(up down))
          (for/and ([p (in-list (syntax->list #'(part ...)))])
            (or (identifier? p) (shaped-like-pattern? p))))]
    [_ #f]))

;; ---------------------------------------------------------------------------
;; Notes

;; name : of the procedure, a symbol; formals, body : its argument list and its forms
(define (tell-slips name formals body)
  (define arguments (formal-names formals))
  (for ([form (in-list body)])
    (tell-quoted name (append-map named-in arguments) form))
  (when (identifier? formals) (tell-list name formals body))
  (tell-unused name body)
  (for ([a (in-list arguments)]) (tell-time name a)))

;; A form may be expanded several times, and is noted once.
(define noted (make-hash))

(define (tell name place text)
  (define line (and (path? (syntax-source place)) (syntax-line place)))
  (define whole (format "~a~a: ~a" name (if line (format ", line ~a" line) "") text))
  (unless (hash-ref noted whole #f)
    (hash-set! noted whole #t)
    (note whole)))

;; ---------------------------------------------------------------------------
;; Quoted arguments

;; symbol : of an argument; pattern : around it, as a datum, or #f
(struct named (symbol pattern))

(define (named-in argument)
  (define pattern (and (not (identifier? argument)) (syntax->datum argument)))
  (let names ([a argument])
    (cond [(identifier? a) (list (named (syntax-e a) pattern))]
          [(shaped-like-pattern? a) (append-map names (cdr (syntax->list a)))]
          [else '()])))

;; Looks among the operands of arithmetic, for elsewhere a symbol may well be meant.
(define (tell-quoted name arguments form)
  (let walk ([form form])
    (syntax-case form ()
      [(head . _) (memq (syntax-e #'head) '(quote quasiquote quote-syntax)) (void)]
      [(head . operands)
       (begin
         (when (arithmetic? #'head)
           (for ([s (in-list (filter-map quoted-name (or (syntax->list #'operands) '())))])
             (define a (findf (lambda (a) (eq? (named-symbol a) (syntax-e s))) arguments))
             (when a (tell name s (quoted-text a)))))
         (walk #'head)
         (walk #'operands))]
      [_ (void)])))

(define (quoted-text a)
  (define s (named-symbol a))
  (format "'~a is a symbol, a constant here; ~a is written ~a without a quote"
          s
          (if (named-pattern a) (format "the ~a of ~s" s (named-pattern a)) "the argument")
          s))

(define (arithmetic? head)
  (and (memq (syntax-e head) operations)
       (not (eq? (identifier-binding head) 'lexical))))

(define operations
  (append '(dot-product cross-product magnitude) (operation-names arithmetic) functions))

;; ---------------------------------------------------------------------------
;; (lambda t ...)

;; all : name of the list of arguments
(define (tell-list name all body)
  (define symbol (syntax-e all))
  (when (for/or ([form (in-list body)]) (operand-in? symbol form))
    (tell name all
          (format "~a without parentheses is the list of all arguments; one argument is (~a)"
                  symbol symbol))))

;; Does the symbol stand among the operands of arithmetic?
(define (operand-in? symbol form)
  (syntax-case form ()
    [(head operand ...)
     (for/or ([o (in-list (syntax->list #'(operand ...)))])
       (or (and (arithmetic? #'head) (eq? (syntax-e o) symbol))
           (operand-in? symbol o)))]
    [_ #f]))

;; ---------------------------------------------------------------------------
;; Expressions without effect

(define (tell-unused name body)
  (for ([form (in-list body)] [more (in-list (if (null? body) '() (cdr body)))])
    (when (without-effect? form)
      (tell name form
            (format "the value of ~a is not used; that of the last expression is the value"
                    (short form))))))

(define (without-effect? form)
  (syntax-case form ()
    [(head . _) (identifier? #'head)
                (or (arithmetic? #'head) (shaped-like-pattern? form))]
    [_ (or (identifier? form) (number? (syntax-e form)))]))

(define (short form)
  (define text (format "~s" (syntax->datum form)))
  (if (<= (string-length text) 50) text (string-append (substring text 0 46) " ...")))

;; ---------------------------------------------------------------------------
;; The order in a local tuple

(define (tell-time name argument)
  (define parts
    (if (shaped-like-pattern? argument) (map syntax->datum (cdr (syntax->list argument))) '()))
  (define late (and (>= (length parts) 3) (index-where parts time-name?)))
  (define (tell-order text) (tell name argument (format "~s: ~a" (syntax->datum argument) text)))
  (cond [(and late (> late 0))
         (tell-order (format "a local tuple begins with the time, and ~a stands ~a"
                             (list-ref parts late) (if (= late 1) "second" "behind")))]
        [(and (= (length parts) 3) (rate-of? (cadr parts) (caddr parts)))
         (tell-order "coordinates come before velocities in a local tuple")]))

(define (time-name? x) (memq x '(t time)))

;; Are the two called as a velocity and its coordinate are?
(define (rate-of? rate coordinate)
  (define (together? f) (equal? (format "~a" rate) (f (format "~a" coordinate))))
  (and (symbol? rate) (symbol? coordinate)
       (or (and (memq rate '(v velocity qd qdot rate)) (memq coordinate '(q x position coordinate)))
           (for/or ([end (in-list '("d" "dot" "-dot" "'" "prime"))])
             (together? (lambda (c) (string-append c end))))
           (together? (lambda (c) (string-append "v" c)))
           (together? (lambda (c) (string-append "v_" c))))
       #t))
