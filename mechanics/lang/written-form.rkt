#lang racket/base
;; Forms as they were written: their refusal, and Racket's form behind a name that is ours too.

(require (only-in racket/list append-map))

(provide plain-form refuse adjacent? prime-before? quoted-name about-prime form->text operands
         without-commas before-colon escaped? with-typed-names typed-name)

;; stx with `form` in place of its keyword; stx may be the keyword alone.
(define (plain-form form stx)
  (if (identifier? stx)
      (datum->syntax form (syntax-e form) stx stx)
      (datum->syntax stx (cons form (cdr (syntax-e stx))) stx stx)))

;; A mistake in the form stx, at a part of it, or #f; the text as `format` takes it
(define (refuse stx part text . operands)
  (raise-syntax-error #f (apply format text operands) stx part))

;; Is there nothing between the two syntaxes?
(define (adjacent? one other)
  (define-values (start span next)
    (values (syntax-position one) (syntax-span one) (syntax-position other)))
  (and (equal? (syntax-source one) (syntax-source other))
       start span next (= (+ start span) next)))

;; Has the text of the name, an identifier, signs that are no part of it: |x| or \alpha?
(define (escaped? id)
  (define span (syntax-span id))
  (and span (not (= span (string-length (symbol->string (syntax-e id)))))))

;; A form that was read from the text, each name of which that lost signs keeps its part of the
;; text: \sin\theta is the name sintheta to Racket.
(define (with-typed-names stx text)
  (define (part id)
    (define start (- (syntax-position id) 1))
    (substring text start (+ start (syntax-span id))))
  (cond [(identifier? stx) (if (escaped? stx) (syntax-property stx typed (part stx)) stx)]
        [(syntax->list stx)
         => (lambda (parts)
              (datum->syntax stx (for/list ([p (in-list parts)]) (with-typed-names p text))
                             stx stx))]
        [else stx]))

;; -> text or #f
(define (typed-name id) (syntax-property id typed))

(define typed 'mechanics:typed)

;; Does the second begin with a quote that touches the first, as in x't?
(define (prime-before? one other)
  (define d (syntax-e other))
  (and (pair? d) (eq? (syntax-e (car d)) 'quote) (adjacent? one other)))

;; The name of a quotation 'name, an identifier; or #f
(define (quoted-name stx)
  (syntax-case stx ()
    [(q name) (and (eq? (syntax-e #'q) 'quote) (identifier? #'name)) #'name]
    [_ #f]))

(define (about-prime name)
  (format "a prime is read as a quote; the derivative of ~a is (D ~a)" name name))

;; A datum as it is typed, with ' for quote.
(define (form->text d)
  (parameterize ([print-reader-abbreviations #t]) (format "~s" d)))

;; The name before a colon, as x of x: ; or #f
(define (before-colon name)
  (define found (regexp-match #rx"^(.+):$" (symbol->string name)))
  (and found (string->symbol (cadr found))))

;; The symbols of a formula, a datum, without those that are called.
(define (operands d)
  (cond [(symbol? d) (list d)]
        [(and (pair? d) (eq? (car d) 'quote)) '()]
        [(pair? d) (append (if (pair? (car d)) (operands (car d)) '())
                           (append-map operands (if (list? d) (cdr d) '())))]
        [else '()]))

;; The data without commas: f(x, y) is read as f and (x (unquote y)).
(define (without-commas data)
  (for/list ([d (in-list data)])
    (if (and (list? d) (= (length d) 2) (eq? (car d) 'unquote)) (cadr d) d)))
