#lang racket/base
;; Mistakes of newcomers in definitions, refused with the correct form.
;;
;; A name is quoted where it is used as a symbol, never where it is defined.  Racket would
;; take (define 'm 5), which is (define (quote m) 5), for a definition of `quote`, and ('t)
;; among arguments for an optional argument of that name; and quotation would break.  And a
;; pattern that lost its parentheses, (lambda (up t q v) ...), makes a function of four arguments,
;; the first of them called `up`.

(require (only-in racket/list last)
         "incomplete-forms.rkt" "paper-definitions.rkt"
         "../written-form.rkt")

(provide check-definition check-argument-list)

;; stx : a form that begins with `define`
(define (check-definition stx)
  (syntax-case stx ()
    [(_ head . body)
     (begin
       (check-quoted unquoted-head #'head stx (lambda (d) (list 'define d (shown #'body))))
       (check-on-paper stx)
       (check-complete-definition stx)
       (check-head #'head #'body stx))]
    [_ (check-complete-definition stx)]))

;; Checks all argument lists of a head.
(define (check-head head body stx)
  (let check ([head head] [written (lambda (d) (list 'define d '...))])
    (syntax-case head ()
      [(inner . formals)
       (begin
         (check-names #'formals stx (lambda (d) (written (cons (datum #'inner) d))))
         (when (bare-pattern? #'formals body)
           (raise-bare stx #'formals `(define ,(list (datum #'inner) (datum #'formals)) ...)))
         (check #'inner (lambda (d) (written (cons d (datum #'formals))))))]
      [_ (void)])))

;; formals : an argument list of `stx`, a form such as lambda; body : its forms
(define (check-argument-list formals body stx)
  (define (written d) (list (datum (car (syntax-e stx))) d '...))
  (check-quoted unquoted-formals formals stx written)
  (check-names formals stx written)
  (when (bare-pattern? formals body)
    (raise-bare stx formals (written (list (datum formals))))))

(define datum syntax->datum)

;; ---------------------------------------------------------------------------
;; Quoted names

;; unquoted : one of the functions below; written : datum without quotes -> the correct form
(define (check-quoted unquoted part stx written)
  (define found '())
  (define d (unquoted part (lambda (stx) (set! found (cons stx found)))))
  (when (pair? found)
    (refuse stx (last found) "a name being defined is not quoted: ~a" (form->text (written d)))))

;; The name of 'name; calls found! with the quotation.
(define (unquoted-name stx found!)
  (found! stx)
  (datum (quoted-name stx)))

;; The datum of a head without its quotes.
(define (unquoted-head head found!)
  (syntax-case head ()
    [_ (quoted-name head) (unquoted-name head found!)]
    [(inner . formals) (cons (unquoted-head #'inner found!) (unquoted-formals #'formals found!))]
    [_ (datum head)]))

(define (unquoted-formals formals found!)
  (syntax-case formals ()
    [_ (quoted-name formals) (unquoted-name formals found!)]
    [(a . more) (cons (unquoted-argument #'a found!) (unquoted-formals #'more found!))]
    [_ (datum formals)]))

;; Patterns are taken apart; the default of an argument may well be a symbol.
(define (unquoted-argument a found!)
  (syntax-case a ()
    [_ (quoted-name a) (unquoted-name a found!)]
    [(up . components)
     (pattern-head? (syntax-e #'up))
     (cons (syntax-e #'up) (unquoted-formals #'components found!))]
    [(name default) (quoted-name #'name) (list (unquoted-name #'name found!) (datum #'default))]
    [_ (datum a)]))

(define (pattern-head? x) (memq x '(up down)))

;; ---------------------------------------------------------------------------
;; (lambda (up t q v) ...)

;; Is this argument list a pattern?  Not if `up` is a parameter, which the body uses otherwise than
;; in calls of the constructor, (up 1 2).
(define (bare-pattern? formals body)
  (syntax-case formals ()
    [(head next . _)
     (and (pattern-head? (syntax-e #'head))
          (not (used-among? (syntax-e #'head) (datum body))))]
    [_ #f]))

(define (used-among? name ds)
  (define (used? d)
    (if (pair? d)
        (or (and (pair? (car d)) (used? (car d))) (used-among? name (cdr d)))
        (eq? d name)))
  (and (pair? ds) (or (used? (car ds)) (used-among? name (cdr ds)))))

(define (raise-bare stx formals written)
  (refuse stx formals "an argument that is a tuple has parentheses of its own: ~a"
          (form->text written)))
