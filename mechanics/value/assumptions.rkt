#lang racket/base
;; Assumptions about signs: of a session, and of a scope.
;;
;; The set in force is the value of a parameter; to declare is to set it, for the
;; thread or within `assuming`.  The algebra knows no parameter: who calls it
;; takes the set from `assumptions-in-force`, once, and tells `note-used!` the
;; grounds of the result.

(require (for-syntax racket/base)
         "algebra.rkt" "assumption-errors.rkt"
         (except-in "../algebra/assumption/assumption-set.rkt" assumptions)
         "../algebra/assumption/relation.rkt"
         "../algebra/expression/expression.rkt"
         (only-in "../algebra/expression/simplifier.rkt" left-unexpanded?)
         "../error/computed-once.rkt"
         "../generic/describe.rkt" "../generic/wrong-argument.rkt")

(provide assume assuming assumptions forget-assumptions automatic-assumptions
         ;; for those who call the algebra
         assumptions-in-force call-without-assumptions with-domain common-assumptions
         note-used! undeclared call-assuming call-telling-used)

;; ---------------------------------------------------------------------------
;; The state

(define current-declared (make-parameter no-assumptions))

;; Assumptions that results rest on, newest first: lists of datums, or procedures that find them.
;; To find them costs as much as the result, so it waits until somebody asks.
(define current-used (make-parameter '()))

;; May simplification assume that factors drawn out of a root are not negative?
(define automatic-assumptions (make-parameter #t (lambda (on?) (and on? #t))))

(define (assumptions-in-force)
  (with-automatic-assumptions (current-declared) (automatic-assumptions)))

;; Results of (thunk) hold whatever is assumed.
(define (call-without-assumptions thunk)
  (parameterize ([current-declared no-assumptions] [automatic-assumptions #f]) (thunk)))

;; A for the scalars of x, which take open signs at one point.
(define (common-assumptions A x)
  (define found (filter node? (leaves x)))
  (if (or (null? found) (null? (cdr found))) A (at-common-reference A found)))

;; At most so many procedures wait, and at most so many datums are remembered.
(define waiting-limit 100)
(define used-limit 1000)

;; notes : grounds, and expressions left unexpanded; or a procedure that finds them
(define (note-used! notes)
  (unless (null? notes)
    (define A (current-declared))
    (current-used (cons (lambda () (undeclared (at-last notes) A)) (current-used)))
    (when (> (length (current-used)) waiting-limit) (settle-used!))))

;; -> the datums, oldest first
(define (settle-used!)
  (define data
    (for*/fold ([known '()] #:result (reverse known))
               ([notes (in-list (reverse (current-used)))] [d (in-list (at-last notes))])
      (if (or (left-unexpanded? d) (member d known) (= (length known) used-limit))
          known
          (cons d known))))
  (current-used (if (null? data) '() (list data)))
  data)

;; -> the value of (thunk), and the datums that it rests on without their being declared
(define (call-telling-used thunk)
  (define-values (value used)
    (parameterize ([current-used '()])
      (let ([value (thunk)]) (values value (undeclared (settle-used!))))))
  (note-used! used)
  (values value used))

;; The datums that are not declared in A.
(define (undeclared grounds [A (current-declared)])
  (define declared (if (null? grounds) '() (declared-relations A)))
  (filter (lambda (d) (not (member d declared))) grounds))

;; ---------------------------------------------------------------------------
;; Declaring and withdrawing

;; (assume '(>= r 0) '(> m 0) ...)
(define (declare! . relations)
  (current-declared (declare 'assume relations)))

;; The set in force with the relations, or an error.
(define (declare who relations)
  (define data (read-relations who relations))
  (with-handlers ([exn:algebra:contradiction?
                   (lambda (x)
                     (raise-contradiction who data (exn:algebra:contradiction-because x)))])
    (declare-relations (current-declared) data (lambda (d) (complaint who d)))))

(define (read-relations who relations)
  (for*/list ([r (in-list relations)] [d (in-list (split-relation r (complaint who r)))])
    d))

;; (forget-assumptions) forgets all, declared or used; (forget-assumptions '(> m 0) ...) these.
(define (forget-assumptions . relations)
  (cond [(null? relations)
         (current-declared no-assumptions)
         (current-used '())]
        [else
         (define data (read-relations 'forget-assumptions relations))
         (define unknown (undeclared data))
         (unless (null? unknown) (raise-not-declared (car unknown) (assumptions 'declared)))
         (current-declared (without-relations (current-declared) data))]))

;; The relations declared, then those used without being declared; or one of both lists.
(define (assumptions [which #f])
  (define declared (declared-relations (current-declared)))
  (define used (undeclared (settle-used!)))
  (case which
    [(#f) (append declared used)]
    [(declared) declared]
    [(used) used]
    [else (complain-of-argument 'assumptions "'declared or 'used, or no argument" which)]))

;; ---------------------------------------------------------------------------
;; Scopes

;; The values of the body, simplified under its assumptions.
(define (call-assuming relations body [who 'assuming])
  (parameterize ([current-declared (declare who relations)])
    (call-with-values body (lambda results
                             (define A (assumptions-in-force))
                             (apply values (map (lambda (x) (settle x A)) results))))))

;; A series is asked for its terms later, so the set is not read again.
(define (settle x A)
  (cond [(list? x) (map (lambda (e) (settle e A)) x)]
        [else
         (define B (common-assumptions A x))
         (map-leaves (lambda (e) (if (symbolic? e) (settle-expression e B) e)) x)]))

(define (settle-expression e A)
  (cond [(requested? e) e]
        [else
         (define-values (simple notes) (simplify-expression/needed e A))
         (note-used! notes)
         (request-form simple (at-last notes))]))

;; ---------------------------------------------------------------------------
;; The forms: a relation without a quote is noticed where it is written

(begin-for-syntax
  (define (check-quoted stx relations)
    (for ([r (in-list (syntax->list relations))] #:when (relation? r))
      (raise-syntax-error #f (format "a relation is quoted here: write '~s" (prefix r)) stx r)))

  ;; Is it written as (> m 0), or as (m > 0)?
  (define (relation? stx)
    (syntax-case stx ()
      [(left name right) (comparison? #'name) #t]
      [(name . operands)
       (and (identifier? #'name)
            (memq (syntax-e #'name)
                  '(> >= < <= = positive negative nonpositive nonnegative)))]
      [_ #f]))

  (define (comparison? stx) (memq (syntax-e stx) '(> >= < <= =)))

  ;; As it is written, with the name first and without quotes.
  (define (prefix stx)
    (syntax-case stx ()
      [(left name right)
       (comparison? #'name)
       (unquoted (syntax->datum #'(name left right)))]
      [_ (unquoted (syntax->datum stx))]))

  (define (nested? stx) (pair? (syntax-e stx)))

  (define (quotation? stx) (syntax-case stx (quote) [(quote x) #t] [_ #f]))

  ;; Relations, quoted or not, where a list of them is due: as data, or #f.
  (define (bare-relations stx)
    (syntax-case stx (quote)
      [(quote (r ...)) (andmap nested? (syntax->list #'(r ...)))
                       (map prefix (syntax->list #'(r ...)))]
      [(quote r) (nested? #'r) (list (prefix #'r))]
      [_ (and (relation? stx) (list (prefix stx)))]))

  (define (quoted-text d) (format "'~s" d))

  ;; The datum without the quotes in it: (> m 0) for (> 'm 0).
  (define (unquoted d)
    (cond [(and (pair? d) (eq? (car d) 'quote)) (unquoted (cadr d))]
          [(list? d) (map unquoted d)]
          [else d])))

(define-syntax (assume stx)
  (syntax-case stx ()
    [(_ relation ...)
     (begin (check-quoted stx #'(relation ...))
            (syntax/loc stx (declare! relation ...)))]
    [id (identifier? #'id) (syntax/loc stx declare!)]))

(define-syntax (assuming stx)
  (syntax-case stx ()
    [(_ relations . rest)
     (bare-relations #'relations)
     (raise-syntax-error
      #f (format "relations stand in parentheses: (assuming ~a body)"
                 (map quoted-text (bare-relations #'relations)))
      stx #'relations)]
    [(_ (relation ...) body0 body ...)
     (not (quotation? #'(relation ...)))
     (begin (check-quoted stx #'(relation ...))
            (syntax/loc stx (call-assuming (list relation ...) (lambda () body0 body ...))))]
    [_ (raise-syntax-error
        #f "expected relations in parentheses, then a body: (assuming ('(> m 0)) body)" stx)]))
