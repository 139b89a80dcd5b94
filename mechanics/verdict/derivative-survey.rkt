#lang racket/base
;; Surveys: points met by the derivatives that a verdict is about.
;;
;; That a residual vanishes wherever it is defined does not make |t − 2| a free motion: the
;; derivatives in it do not see the kink.  Whoever makes a residual by differentiating has the
;; operations noted that have kinks, jumps or poles somewhere
;; (generic/operation-rule/kinks-met.rkt); the algebra finds out whether and where they do
;; (algebra/zero/kink.rkt).

(require (only-in racket/list append-map)
         "../algebra/expression/expression.rkt" "../algebra/expression/substitute.rkt"
         "../algebra/expression/symbols.rkt"
         "../generic/describe.rkt" "../generic/irrational.rkt"
         "../generic/operation-rule/kinks-met.rkt"
         "../value/algebra.rkt")

(provide survey-derivatives survey-of-values unused-name)

;; A survey: assumptions -> kinks, and the assumptions under which there are no more

;; variables : symbols by which one differentiates
;; places : -> ((variable . expression) ...), put in for them in the end
;; unknowns : symbols to solve for              values? : must all have a value, as a path must?
;; domain : -> expressions, the places put in, that are to have a value: outside there is no kink
;; functions : -> expressions in the variables, of which the derivatives are; if all of them are
;; smooth at a kink, it is none
;; order : how often a function is differentiated
;; -> the value of (thunk), and a survey of it
(define (survey-derivatives thunk variables #:put [find-places nothing]
                            #:solve-for [unknowns variables] #:have-values? [values? #f]
                            #:domain [domain nothing] #:functions [functions nothing]
                            #:order [order 2])
  (define-values (x found) (call-noting-kinks thunk))
  (define (survey A)
    (define places (find-places))
    (define names
      (names-of unknowns (append (append-map met-arguments found) (map cdr places))))
    (define (rename e) (substitute-expression (irrational-as-expression e) names))
    (find-kinks
     (for/list ([m (in-list found)]) (cons (met-name m) (map rename (met-arguments m))))
     (map rename variables)
     A
     #:places (for/list ([entry (in-list places)]) (cons (car entry) (rename (cdr entry))))
     #:unknowns (map rename unknowns)
     #:values? values?
     #:domain (for/list ([e (in-list (domain-expressions (domain)))]) (in-place-of names e))
     #:functions (map rename (functions))
     #:order order))
  (values x (if (null? found) without-kinks survey)))

(define (nothing) '())
(define (without-kinks A) (values '() '()))

;; A survey of the value x itself: of expressions in it that hold a non-number.
(define (survey-of-values x)
  (define holes
    (for/list ([leaf (in-list (leaves x))]
               #:when (and (expression? leaf) (holds-no-number? leaf)))
      (list 'nowhere leaf)))
  (if (null? holes) without-kinks (lambda (A) (find-kinks holes '() A))))

(define (holds-no-number? e)
  (some-leaf? (lambda (leaf) (and (number? leaf) (not (rational? (magnitude leaf))))) e))

;; ---------------------------------------------------------------------------

;; An alist of names for the symbols that are uninterned.
(define (names-of symbols es)
  (define taken (make-hasheq))
  (for* ([e (in-list es)] [name (in-list (symbols-in e))]) (hash-set! taken name #t))
  (for/list ([s (in-list symbols)] #:unless (symbol-interned? s))
    (define name (unused-name (symbol->string s) taken))
    (hash-set! taken name #t)
    (cons s name)))

;; A name for a symbol that is to be shown: base, or base1, base2 ... if the table has it already
(define (unused-name base taken)
  (for/first ([suffix (in-sequences '("") (in-naturals 1))]
              #:unless (hash-ref taken (string->symbol (format "~a~a" base suffix)) #f))
    (string->symbol (format "~a~a" base suffix))))
