#lang racket/base
;; Definitions as a newcomer may write them, refused with how they are written.
;;
;; A name is quoted where it is used as a symbol, never where it is defined.  Racket would
;; take (define 'm 5), which is (define (quote m) 5), for a definition of `quote`, and ('t)
;; among arguments for an optional argument of that name; and nothing quoted would be what
;; it was.  And a pattern that lost its parentheses, (lambda (up t q v) ...), makes a function
;; of four arguments, the first of them called `up`.

(require "incomplete.rkt" "on-paper.rkt"
         "../written-form.rkt")

(provide check-definition check-argument-list)

;; stx : a form that begins with `define`
(define (check-definition stx)
  (syntax-case stx ()
    [(_ head . body)
     (let ([found (quoted-in-head #'head)])
       (when found
         (raise-quoted stx found (list 'define (unquoted-head (datum #'head)) (shown #'body))))
       (check-on-paper stx)
       (check-complete-definition stx)
       (check-names-in-head #'head stx)
       (check-bare-in-head #'head #'body stx))]
    [_ (check-complete-definition stx)]))

(define (check-names-in-head head stx)
  (let check ([head head] [written (lambda (d) (list 'define d '...))])
    (syntax-case head ()
      [(inner . formals)
       (begin
         (check-names #'formals stx (lambda (d) (written (cons (datum #'inner) d))))
         (check #'inner (lambda (d) (written (cons d (datum #'formals))))))]
      [_ (void)])))

;; formals : an argument list of `stx`, a form such as lambda; body : its forms
(define (check-argument-list formals body stx)
  (check-quoted formals stx)
  (check-names formals stx (lambda (d) (list (datum (car (syntax-e stx))) d '...)))
  (when (bare-pattern? formals body)
    (raise-bare stx formals (list (datum (car (syntax-e stx))) (list (datum formals)) '...))))

(define (check-quoted formals stx)
  (define found (or (quoted-name formals) (quoted-among formals)))
  (when found
    (define clean ((if (quoted-name formals) cadr unquoted-arguments) (datum formals)))
    (raise-quoted stx found (list (datum (car (syntax-e stx))) clean '...))))

(define (raise-quoted stx found written)
  (raise-syntax-error #f (format "a name being defined is not quoted: ~a" (form->text written))
                      stx found))

;; ---------------------------------------------------------------------------
;; Quoted names

;; 'x, or #f
(define (quoted-name stx)
  (syntax-case stx ()
    [(q name) (and (eq? (syntax-e #'q) 'quote) (identifier? #'name)) stx]
    [_ #f]))

(define (quoted-in-head head)
  (or (quoted-name head)
      (syntax-case head ()
        [(inner . formals) (or (quoted-in-head #'inner) (quoted-among #'formals))]
        [_ #f])))

;; Among arguments, patterns taken apart; the default of one may well be a symbol.
(define (quoted-among formals)
  (syntax-case formals ()
    [(a . more)
     (or (quoted-name #'a)
         (syntax-case #'a ()
           [(up . components) (pattern-head? (syntax-e #'up)) (quoted-among #'components)]
           [(name default) (quoted-name #'name)]
           [_ #f])
         (quoted-among #'more))]
    [_ #f]))

(define (pattern-head? x) (memq x '(up down)))

;; ---------------------------------------------------------------------------
;; As it is written, without the quotes

(define datum syntax->datum)

(define (quoted? d) (and (list? d) (= (length d) 2) (eq? (car d) 'quote) (symbol? (cadr d))))

(define (unquoted-head d)
  (cond [(quoted? d) (cadr d)]
        [(pair? d) (cons (unquoted-head (car d)) (unquoted-arguments (cdr d)))]
        [else d]))

(define (unquoted-arguments ds)
  (if (pair? ds)
      (cons (unquoted-argument (car ds)) (unquoted-arguments (cdr ds)))
      ds))

(define (unquoted-argument d)
  (cond [(quoted? d) (cadr d)]
        [(and (pair? d) (pattern-head? (car d))) (cons (car d) (unquoted-arguments (cdr d)))]
        [(pair? d) (cons (unquoted-argument (car d)) (cdr d))]
        [else d]))

;; ---------------------------------------------------------------------------
;; (lambda (up t q v) ...)

;; Is this argument list a pattern?  A parameter called `up` is used; what is only called, as
;; (up 1 2), is the constructor.
(define (bare-pattern? formals body)
  (syntax-case formals ()
    [(head next . _)
     (and (pattern-head? (syntax-e #'head))
          (not (used-among? (syntax-e #'head) (datum body))))]
    [_ #f]))

(define (used? name d)
  (cond [(pair? d) (or (and (pair? (car d)) (used? name (car d)))
                       (used-among? name (cdr d)))]
        [else (eq? d name)]))

(define (used-among? name ds)
  (and (pair? ds) (or (used? name (car ds)) (used-among? name (cdr ds)))))

(define (check-bare-in-head head body stx)
  (syntax-case head ()
    [(inner . formals)
     (begin
       (when (bare-pattern? #'formals body)
         (raise-bare stx #'formals
                     (list 'define (with-parentheses (datum head) (datum #'formals)) '...)))
       (check-bare-in-head #'inner body stx))]
    [_ (void)]))

(define (with-parentheses head formals) (list (car head) formals))

(define (raise-bare stx formals written)
  (raise-syntax-error
   #f
   (format "an argument that is a tuple has parentheses of its own: ~a" (form->text written))
   stx formals))
