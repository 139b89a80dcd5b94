#lang racket/base
;; Printing turned round: from a value's printed form, an S-expression or its text, to the
;; value.
;;
;; Words of the algebra stand for themselves: symbols, numbers, operations.  Any other name at
;; the head of a list is that of an unknown function, as in (x t), or of its derivative, as
;; in (((partial 0) V) q).  Tuples, matrices, series and quaternions are made by the names
;; they print with.  Equations and inequalities, of verdicts and of assumptions, are lists with
;; a value on either side.
;;
;; Parts that a datum shares are read once: the datum of an expression may be exponentially
;; longer, written out, than it is.

(require "matrix/matrix.rkt" "quaternion.rkt" "series/series-access.rkt"
         "../algebra/expression/expression.rkt" "../algebra/expression/operation.rkt"
         "../algebra/expression/read.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/elementary.rkt"
         "../generic/kind.rkt" "../generic/on-demand.rkt" "../generic/up-down.rkt")

(require-on-demand ["../algebra/notation/read-infix.rkt" infix->datum])

(provide read-expression)

;; x : a datum, a text, or a port, of which one datum is read
(define (read-expression x)
  (cond [(string? x) (read-value (only-datum x))]
        [(input-port? x)
         (define d (next-datum x))
         (if (eof-object? d) d (read-value d))]
        [else (read-value x)]))

;; ---------------------------------------------------------------------------
;; Text

(define (only-datum text)
  (define port (open-input-string text))
  (define d (next-datum port))
  (when (eof-object? d)
    (complain 'read-expression "there is no expression in the text\n  text: ~s" text))
  (unless (eof-object? (next-datum port))
    (complain 'read-expression
              "expected one expression; the text has several\n  text: ~s~a" text
              (if (on-paper? text) "\n  a formula as on paper is read by read-infix" "")))
  d)

(define (on-paper? text)
  (with-handlers ([exn:fail:contract? (lambda (e) #f)])
    (infix->datum text)
    #t))

(define (next-datum port)
  (with-handlers ([exn:fail:read?
                   (lambda (e)
                     (complain 'read-expression "the text is no whole expression\n  ~a"
                               (regexp-replace #rx"^[^\n]*:([0-9]+): read: " (exn-message e)
                                               "at character \\1: ")))])
    (call-with-default-reading-parameterization
     (lambda ()
       (parameterize ([read-accept-reader #f] [read-accept-lang #f] [read-accept-graph #f])
         (read port))))))

;; ---------------------------------------------------------------------------
;; Data

(define (read-value whole)
  (define memo (make-hasheq))
  (define (reject part [why ""]) (raise-no-expression part whole why))
  (define (read d)
    (cond [(vector? d) (apply up (map read (vector->list d)))]
          [(pair? d) (hash-ref! memo d (lambda () (read-list d read reject)))]
          [else (read-atom d reject)]))
  (read whole))

(define (read-atom d reject)
  (cond [(and (symbol? d) (left-out? d))
         (reject d (string-append "\n  it stands for what was not printed; (print-limit #f) has "
                                  "all of an expression printed"))]
        [(expression? d) d]
        [(and (has-kind? d) (not (pointwise-kind? d))) d]
        [(procedure? d) (reject d "\n  a function is no expression, but its value at 't is one")]
        [else (reject d)]))

;; Is it ... or ...12, which stands for parts left out in printing?
(define (left-out? s) (regexp-match? #rx"^[.][.][.]" (symbol->string s)))

(define (pointwise-kind? x) (memv (kind-rank (kind-of x)) (list rank:function rank:operator)))

(define (read-list d read reject)
  (define head (car d))
  (cond [(not (list? d)) (reject d)]
        [(and (eq? head 'quote) (= (length d) 2)) (read (cadr d))]
        [(list-of-relations? d) (map read d)]
        [(memq head relations) (read-relation d read reject)]
        [(hash-ref constructors head #f) => (lambda (make) (apply make (map read (cdr d))))]
        [(memq head no-functions)
         (reject d "\n  it is written like a function; an expression is its value, as ((D x) t)")]
        [(operation-name? head) (read-operation head (map read (cdr d)) d reject)]
        [else (datum->expression (cons head (map argument (map read (cdr d)))) reject)]))

(define constructors
  (hasheq 'up up 'down down 'list list 'matrix-by-rows matrix-by-rows
          'series series 'power-series power-series 'quaternion quaternion))

;; Heads that make functions, or programs.
(define no-functions
  '(D partial lambda λ define let literal-function compose quote))

;; A list of a literal function's arguments holds tuples as expressions do.
(define (argument x)
  (if (tuple? x)
      (make-node (if (up? x) op:up op:down)
                 (for/list ([e (in-vector (tuple-elements x))]) (argument e)))
      x))

;; Tuples and matrices, which no expression holds, are calculated with.
(define (read-operation head operands d reject)
  (cond [(andmap expression? operands)
         (define (misfit part) (reject d (format "\n  `~a` takes another number of values" head)))
         (or (as-it-stands head operands) (datum->expression (cons head operands) misfit))]
        [(hash-ref arithmetic head #f) => (lambda (f) (apply f operands))]
        [else (reject d)]))

;; A difference is read as one, though the constructors write x - 2 as a sum.
;; -> the expression that prints as given, or #f where none does
(define (as-it-stands head operands)
  (define op (hash-ref written-out head #f))
  (define n (length operands))
  (and op
       (>= n 2)
       (or (= n 2) (memq head '(+ *)))
       (not (andmap number? operands))
       (not (and (eq? head '/) (eqv? (cadr operands) 0)))
       (make-node op operands)))

(define written-out (hasheq '+ op:+ '- op:- '* op:* '/ op:/ 'expt op:expt))

(define arithmetic (hasheq '+ g:+ '- g:- '* g:* '/ g:/ 'expt g:expt))

;; ---------------------------------------------------------------------------
;; Relations

(define relations '(= < > <= >=))

(define (relation? d) (and (pair? d) (memq (car d) relations) #t))

;; ((= k 1) (= m 2)), or a list of such lists, but not ((D x) t)
(define (list-of-relations? d)
  (and (list? d)
       (pair? d)
       (andmap (lambda (part) (or (relation? part) (list-of-relations? part))) d)))

(define (read-relation d read reject)
  (unless (= (length d) 3)
    (reject d (format "\n  it has a left side and a right side: (~a left right)" (car d))))
  (list (car d) (read (cadr d)) (read (caddr d))))

;; ---------------------------------------------------------------------------

(define (raise-no-expression part whole why)
  (complain 'read-expression "~a is no expression~a~a"
            (part->text part)
            (if (eq? part whole) "" (format "\n  in: ~a" (value->text whole)))
            why))

(define (part->text x)
  (if (procedure? x) (describe-with-value x) (value->text x)))
