#lang racket/base
;; What one simplification rests on: the relations it used, the signs it took
;; for granted, and those it had to leave open.
;;
;; The assumptions are the same from beginning to end, so that the order in which
;; an expression's parts are met makes no difference.  If what was taken for
;; granted in one place decides what was left open in another, as in √(x²) + |x|,
;; the ledger has a revision: with those assumptions all is done again.

(require "assumption-set.rkt" "narrowing.rkt" "signs.rkt"
         "../expression/expression.rkt")

(provide make-ledger ledger-sign! ledger-real? ledger-assume! ledger-leave-open!
         ledger-grounds ledger-revision)

;; grounds : datums, newest first, each once; noted : the same as a table
;; taken, open : expressions taken not to be negative, and of unknown sign
(struct ledger (assumptions noted [grounds* #:mutable] [taken #:mutable] [open #:mutable])
  #:authentic)

(define (make-ledger A) (ledger A (make-hash) '() '() '()))

;; What all rests on, as datums such as (>= R 0), in the order they were needed.
(define (ledger-grounds l) (reverse (ledger-grounds* l)))

(define (note! l datum)
  (unless (hash-ref (ledger-noted l) datum #f)
    (hash-set! (ledger-noted l) datum #t)
    (set-ledger-grounds*! l (cons datum (ledger-grounds* l)))))

;; -> 1 or -1, if e is known to be not negative or not positive, else #f
(define (ledger-sign! l s e)
  (define k (infer-signs (ledger-assumptions l) s e))
  (define branch (decided-branch k))
  (when branch (for-each (lambda (d) (note! l d)) (known-because k)))
  branch)

(define (decided-branch k)
  (cond [(signs-within? (known-signs k) nonnegative) 1]
        [(signs-within? (known-signs k) nonpositive) -1]
        [else #f]))

;; -> 1, or #f where nothing may be taken for granted, as of what is not real
(define (ledger-assume! l s e)
  (and (assumptions-automatic? (ledger-assumptions l))
       (ledger-real? l s e)
       (let ([r (taken-relation e)])
         (note! l (relation-datum r))
         (set-ledger-taken! l (cons r (ledger-taken l)))
         1)))

(define (ledger-real? l s e) (real-valued? (ledger-assumptions l) s e))

(define (taken-relation e) (relation (list '>= (expression->datum e) 0) e nonnegative))

;; -> #f
(define (ledger-leave-open! l e)
  (set-ledger-open! l (cons e (ledger-open l)))
  #f)

;; The assumptions with those taken for granted, if they decide what is open;
;; else #f.
(define (ledger-revision l s)
  (define extended
    (and (pair? (ledger-open l))
         (pair? (ledger-taken l))
         (with-handlers ([exn:algebra:contradiction? (lambda (x) #f)])
           (add-relations (ledger-assumptions l) (reverse (ledger-taken l)) s))))
  (and extended
       (for/or ([e (in-list (ledger-open l))]) (decided-branch (infer-signs extended s e)))
       extended))
