#lang racket/base
;; Procedures of MIT Scheme, the language of the book's programs, that Racket has under other names
;; or lacks.

(require (for-syntax racket/base)
         (only-in racket/list make-list)
         "../show/display/result.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/compare.rkt" "../generic/describe.rkt"
         "../generic/naming.rkt" "../generic/on-demand.rkt" "../generic/wrong-argument.rkt"
         (only-in "../generic/kind.rkt" has-kind?)
         "../numeric/constants.rkt" "../numeric/finite-number.rkt")

(require-on-demand [racket/pretty pretty-write])

(provide iota (rename-out [successor 1+] [predecessor -1+])
         floor->exact close-enuf? (rename-out [epsilon *machine-epsilon*])
         list-head make-list fold-left fold-right
         write-line pp
         runtime show-time)

;; ---------------------------------------------------------------------------
;; Numbers

(define (successor x) (g:+ x 1))
(define (predecessor x) (g:- x 1))

;; The list start, start + step, ... of n values.
(define (iota n [start 0] [step 1])
  (check-argument 'iota exact-nonnegative-integer? n "a length, a natural number")
  (for/list ([i (in-range n)]) (g:+ start (g:* i step))))

;; The greatest integer that is not greater, exact.
(define (floor->exact x)
  (define number (comparand x))
  (unless (finite? number) (complain-of-argument 'floor->exact "a real number" x))
  (inexact->exact (floor number)))

;; Do two numbers differ by no more than tolerance times half the sum of their sizes and
;; `scale`?
(define (close-enuf? a b [tolerance (* 10 epsilon)] [scale 1])
  (for ([x (in-list (list a b))])
    (unless (number? (comparand x))
      (complain 'close-enuf? "expected two numbers; given ~a" (describe-with-value x))))
  (define-values (x y) (values (comparand a) (comparand b)))
  (<= (magnitude (- x y))
      (* tolerance (+ (* 1/2 (+ (magnitude x) (magnitude y))) scale))))

;; ---------------------------------------------------------------------------
;; Lists

;; The first n elements.
(define (list-head xs n)
  (unless (and (list? xs) (exact-nonnegative-integer? n) (<= n (length xs)))
    (complain-showing 'list-head "expected a list, and a number of its first elements"
                      "list" xs "number" n))
  (for/list ([x (in-list xs)] [_ (in-range n)]) x))

;; (f (f start x) y): f takes the accumulator first, in Racket's foldl last.
(define (fold-left f start xs . more)
  (check-folded 'fold-left f xs more)
  (for/fold ([sum start]) ([elements (in-list (apply map list xs more))]) (apply f sum elements)))

;; (f x (f y start))
(define (fold-right f start xs . more)
  (check-folded 'fold-right f xs more)
  (apply foldr f start xs more))

(define (check-folded who f xs more)
  (check-argument who procedure? f "a procedure")
  (unless (and (list? xs) (andmap list? more)
               (andmap (lambda (ys) (= (length ys) (length xs))) more))
    (complain-showing who "expected lists of one length" "lists" (cons xs more))))

;; ---------------------------------------------------------------------------
;; Output

;; Writes the value on one line, not simplified.
(define (write-line x [port (current-output-port)])
  (write x port)
  (newline port))

(define line-width 79)

;; Writes the value on as many lines as it needs, not simplified.
(define (pp x [port (current-output-port)])
  (define shown (plain-result x line-width))
  (cond [(eq? shown x) (pretty-write x port)]
        [else (write shown port) (newline port)]))

;; ---------------------------------------------------------------------------
;; Time

;; Seconds of the processor's time that the program has used, without those of garbage collections.
(define (runtime)
  (/ (- (current-process-milliseconds) (current-gc-milliseconds)) 1000.0))

;; (show-time expression), and (show-time (lambda () expression)) as MIT Scheme has it
(define-syntax (show-time stx)
  (syntax-case stx ()
    [(_ expression) #'(time-thunk (lambda () (called-if-thunk expression)))]
    [(_ . _) (raise-syntax-error #f "it is written (show-time expression)" stx)]
    [_ #'show-value-time]))

(define-named show-value-time show-time
  (lambda (x) (time-thunk (lambda () (called-if-thunk x)))))

(define-syntax-rule (called-if-thunk expression)
  (call-with-values (lambda () expression)
                    (case-lambda [(x) (if (thunk? x) (x) x)]
                                 [xs (apply values xs)])))

;; A tuple can be called, too.
(define (thunk? x) (and (procedure? x) (procedure-arity-includes? x 0) (not (has-kind? x))))

;; The values of (thunk), whose time is printed.
(define (time-thunk thunk)
  (define-values (results cpu real gc) (time-apply thunk '()))
  (printf "process time: ~a ms (~a run + ~a gc); real time: ~a ms\n" cpu (- cpu gc) gc real)
  (apply values results))
