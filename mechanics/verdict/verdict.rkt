#lang racket/base
;; Verdicts: is a residual zero?
;;
;; A verdict says `proved`, `refuted` or `undecided` and carries its evidence:
;; the simplified residual, a point where it is not zero, the assumptions made.
;; The algebra judges scalars one by one; a structure is proved zero when every
;; scalar of it is, and refuted when one is.  A series that does not end cannot be
;; proved zero by its terms, but refuted by one.

(require "report.rkt"
         "../algebra/expression/evaluate.rkt" "../algebra/expression/expression.rkt"
         "../algebra/expression/operation.rkt" "../algebra/expression/symbols.rkt"
         "../algebra/zero/zero-test.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/function.rkt"
         "../generic/up-down.rkt"
         "../value/assumptions.rkt" "../value/operator.rkt"
         "../value/linear/matrix.rkt"
         "../value/series/access.rkt" "../value/series/series.rkt")

(provide prove-zero verify-equal
         verdict? verdict-status verdict-residual verdict-witness verdict-value
         verdict-assumptions verdict-conditions verdict-factored
         proved? refuted? undecided?
         (rename-out [report verdict-lines]))

;; residual    : the value judged, simplified
;; tests       : the zero-test of each of its scalars, in order
;; given       : the assumptions that were declared when it was judged
;; endless?    : is it, or has it, a series of which only the first terms were tested?
(struct verdict (status residual tests given endless?)
  #:authentic
  #:property prop:custom-print-quotable 'never
  #:property prop:custom-write
  (lambda (v port mode) (write-string (report->text (report v)) port)))

(define (report v)
  (append
   (verdict-report (verdict-status v) (verdict-tests v) (scalar-labels (verdict-residual v))
                   (verdict-given v))
   (if (verdict-endless? v)
       (list (list 1 "examined:" (list (format "terms up to order ~a of a series that does not end"
                                               (sub1 compared-terms)))))
       '())))

(define (proved? v) (eq? (verdict-status v) 'proved))
(define (refuted? v) (eq? (verdict-status v) 'refuted))
(define (undecided? v) (eq? (verdict-status v) 'undecided))

;; ---------------------------------------------------------------------------
;; Evidence

(define (first-refuted v)
  (for/first ([z (in-list (verdict-tests v))] #:when (eq? (zero-test-status z) 'refuted)) z))

;; Substitutions ((expression . number) ...) at which the residual is not zero,
;; and its value there; #f unless refuted.
(define (verdict-witness v)
  (define z (first-refuted v))
  (and z (zero-test-witness z)))
(define (verdict-value v)
  (define z (first-refuted v))
  (and z (zero-test-value z)))

;; What the verdict rests on, declared or not.
(define (verdict-assumptions v)
  (distinct (apply append (map zero-test-assumptions (verdict-tests v)))))

;; Equations, each of which makes a scalar of the residual vanish.
(define (verdict-conditions v)
  (distinct
   (for*/list ([z (in-list (verdict-tests v))] [c (in-list (zero-test-conditions z))]) c)))

;; ((factor . core) ...) of the scalars that are not zero.
(define (verdict-factored v)
  (for/list ([z (in-list (verdict-tests v))] #:when (zero-test-core z))
    (cons (zero-test-factor z) (zero-test-core z))))

(define (distinct xs)
  (for/fold ([kept '()] #:result (reverse kept)) ([x (in-list xs)])
    (if (member x kept) kept (cons x kept))))

;; ---------------------------------------------------------------------------
;; Judging

;; x : a value, or a function, which is judged at symbolic arguments.
;; names : symbols that no condition may speak of, as x must vanish whatever they are
(define (prove-zero x #:variables [names '()])
  (check-variables names)
  (define A (assumptions-in-force))
  (define tests '())
  (define variables (make-hasheq (for/list ([s (in-list names)]) (cons s #t))))
  (define endless? #f)
  (define residual
    (map-leaves (lambda (leaf)
                  (define z (judge leaf A (hash-keys variables)))
                  (set! tests (cons z tests))
                  (zero-test-residual z))
                (at-symbolic-arguments x '() variables (lambda () (set! endless? #t)))))
  (for ([z (in-list tests)]) (note-used! (zero-test-assumptions z)))
  (define status (overall (map zero-test-status tests)))
  (verdict (if (and endless? (eq? status 'proved)) 'undecided status)
           residual (reverse tests) (assumptions 'declared) endless?))

(define (check-variables names)
  (unless (and (list? names) (andmap symbol? names))
    (raise-argument-error 'prove-zero "the variables, a list of symbols" names)))

;; x with the up tuple of its terms in place of a series; of one that does not end
;; as many as are compared, and (note!) is called.
(define (with-terms x note!)
  (cond [(series? x)
         (define endless? (not (finite-series? x)))
         (when endless? (note!))
         (structure 'up (list->vector (series:head x (if endless? compared-terms (series-length x)))))]
        [(tuple? x) (structure-map (lambda (e) (with-terms e note!)) (adopt x))]
        [else x]))

(define (verify-equal a b) (prove-zero (difference a b)))

;; a - b, where flonums are not subtracted yet: what is lost to rounding shows
;; only beside the numbers themselves.
(define (difference a b)
  (cond [(and (number? a) (number? b) (not (and (exact? a) (exact? b))))
         (make-node op:- (list a b))]
        [(and (tuple? a) (tuple? b) (compatible? (adopt a) (adopt b)))
         (structure-map2 difference (adopt a) (adopt b))]
        [else (g:- a b)]))

(define (overall statuses)
  (cond [(memq 'refuted statuses) 'refuted]
        [(memq 'undecided statuses) 'undecided]
        [else 'proved]))

(define (judge leaf A variables)
  (unless (expression? leaf)
    (raise
     (exn:fail:contract
      (format "prove-zero: expected a number, an expression, a tuple of them, or a function; given ~a"
              (describe-with-value leaf))
      (current-continuation-marks))))
  (zero-test leaf A variables))

(define (raise-operator o)
  (raise
   (exn:fail:contract
    (format "prove-zero: ~a is an operator; give it a function to act on, as in (~a (literal-function 'f))"
            (value->text o) (value->text o))
    (current-continuation-marks))))

;; ---------------------------------------------------------------------------
;; Functions are judged at symbolic arguments

;; A function, wherever it stands in x, is taken at symbols of its own, which
;; occur nowhere else; its value may be a function again.  In the result they
;; are renamed to t, or t0 t1 ... if there are several, or to what comes next if
;; the user has a t already.  Their names are added to the table `variables`.
(define (at-symbolic-arguments x arguments variables note!)
  (map-leaves
   (lambda (leaf)
     (cond [(operator? leaf) (raise-operator leaf)]
           [(procedure? leaf)
            (define fresh (fresh-arguments leaf))
            (at-symbolic-arguments (apply leaf fresh) (append arguments fresh) variables note!)]
           [(symbolic? leaf) (rename-arguments leaf arguments variables)]
           [else leaf]))
   (with-terms x note!)))

(define (fresh-arguments f)
  (define n (for/first ([n (in-sequences (in-range 1 21) '(0))] #:when (accepts? f n)) n))
  (unless n
    (raise-arguments-error 'prove-zero "cannot choose arguments for the function" "function" f))
  (for/list ([i (in-range n)])
    (string->uninterned-symbol (if (= n 1) "t" (format "t~a" i)))))

(define (rename-arguments e arguments variables)
  (define taken (make-hasheq (for/list ([s (in-list (symbols-in e))]) (cons s #t))))
  (substitute-expression
   e
   (for/list ([a (in-list arguments)])
     (define name (unused-name (symbol->string a) taken))
     (hash-set! taken name #t)
     (hash-set! variables name #t)
     (cons a name))))

(define (unused-name base taken)
  (for/first ([suffix (in-sequences '("") (in-naturals 1))]
              #:unless (hash-ref taken (string->symbol (format "~a~a" base suffix)) #f))
    (string->symbol (format "~a~a" base suffix))))

;; ---------------------------------------------------------------------------

;; What to call each scalar of a value, in the order they are judged in;
;; nothing for a value that is one itself.
(define (scalar-labels x)
  (define (walk x path)
    (cond [(tuple? x)
           (for/list ([e (in-vector (structure-elements (adopt x)))] [i (in-naturals)]
                      #:when #t
                      [label (in-list (walk e (format "~a ~a" path i)))])
             label)]
          [(matrix? x)
           (for*/list ([i (in-range (m:num-rows x))] [j (in-range (m:num-cols x))])
             (format "~a row ~a, column ~a" path i j))]
          [else (list path)]))
  (cond [(tuple? x) (for/list ([l (in-list (walk x ""))]) (string-append "component" l))]
        [(matrix? x) (for/list ([l (in-list (walk x ""))]) (substring l 1))]
        [else '()]))
