#lang racket/base
;; Surveys: what derivatives met that a verdict is about.
;;
;; That a residual vanishes wherever it is defined does not make |t − 2| a free motion: the
;; derivatives in it do not see the kink.  Whoever makes a residual by differentiating has the
;; operations noted that have kinks, jumps or poles somewhere (generic/kinks-met.rkt); the
;; algebra finds out whether and where they do (algebra/zero/kink.rkt).

(require (only-in racket/list append-map)
         "../algebra/expression/expression.rkt" "../algebra/expression/substitute.rkt"
         "../algebra/expression/symbols.rkt"
         "../generic/describe.rkt" "../generic/kinks-met.rkt"
         "../value/algebra.rkt")

(provide survey-derivatives survey-of-values survey-kinks unused-name)

;; operations : ((name expression ...) ...) that were met
;; variables : symbols by which one differentiates
;; places : -> ((variable . expression) ...), put in for them in the end
;; unknowns : symbols to solve for              values? : must all have a value, as a path must?
;; domain : -> expressions, the places put in, that are to have a value: what is beyond is no kink
;; functions : -> expressions in the variables, of which the derivatives are; if all of them are
;; smooth at a kink, it is none
;; order : how often a function is differentiated
(struct survey (operations variables places unknowns values? domain functions order) #:authentic)

(define (nothing) '())

;; -> the value of (thunk), and a survey of it
(define (survey-derivatives thunk variables #:put [places nothing]
                            #:solve-for [unknowns variables] #:have-values? [values? #f]
                            #:domain [domain nothing] #:functions [functions nothing]
                            #:order [order 2])
  (define-values (x found) (call-noting-kinks thunk))
  (define operations (for/list ([m (in-list found)]) (cons (met-name m) (met-arguments m))))
  (values x (survey operations variables places unknowns values? domain functions order)))

;; A survey of the value x itself: of expressions in it that hold a non-number.
(define (survey-of-values x)
  (define holes
    (for/list ([leaf (in-list (leaves x))]
               #:when (and (expression? leaf) (holds-no-number? leaf)))
      (list 'nowhere leaf)))
  (survey holes '() nothing '() #t nothing nothing 2))

(define (holds-no-number? e)
  (some-leaf? (lambda (leaf) (and (number? leaf) (not (rational? (magnitude leaf))))) e))

;; ---------------------------------------------------------------------------

;; -> kinks under assumptions A, and the assumptions under which there are no more
(define (survey-kinks s A)
  (if (null? (survey-operations s)) (values '() '()) (kinks-among s A)))

(define (kinks-among s A)
  (define places ((survey-places s)))
  (define names
    (names-of (survey-unknowns s)
              (append (append-map cdr (survey-operations s)) (map cdr places))))
  (define (rename e) (if (null? names) e (substitute-expression e names)))
  (find-kinks
   (make-kink-question
    (for/list ([o (in-list (survey-operations s))]) (cons (car o) (map rename (cdr o))))
    (map rename (survey-variables s))
    (for/list ([entry (in-list places)]) (cons (car entry) (rename (cdr entry))))
    (map rename (survey-unknowns s))
    (survey-values? s)
    (for/list ([e (in-list (domain-expressions ((survey-domain s))))]) (in-place-of names e))
    (map rename ((survey-functions s)))
    (survey-order s))
   A))

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
