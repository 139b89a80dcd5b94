#lang racket/base
;; What one simplification rests on: the relations it used, the signs it took
;; for granted, and those it had to leave open.
;;
;; The assumptions are the same from beginning to end, so that the order in which
;; an expression's parts are met makes no difference.  If what was taken for
;; granted in one place decides what was left open in another, as in √(x²) + |x|,
;; the ledger has a revision: with those assumptions all is done again.
;;
;; All signs are asked of a simplifier, which has the ledger they are noted in.

(require "assumption-set.rkt" "narrowing.rkt" "signs.rkt"
         "../expression/expression.rkt" "../expression/simplifier.rkt")

(provide make-ledger decided-sign sign-or-assumed sign-or-left-open known-real?
         simplifier-grounds simplifier-revision)

;; grounds : datums, newest first, each once; noted : the same as a table
;; taken, open : expressions taken not to be negative, and of unknown sign
(struct ledger (assumptions noted [grounds #:mutable] [taken #:mutable] [open #:mutable])
  #:authentic)

(define (make-ledger A) (ledger A (make-hash) '() '() '()))

;; What all rests on, as datums such as (>= R 0), in the order they were needed.
(define (simplifier-grounds s) (reverse (ledger-grounds (simplifier-ledger s))))

(define (note! l datum)
  (unless (hash-ref (ledger-noted l) datum #f)
    (hash-set! (ledger-noted l) datum #t)
    (set-ledger-grounds! l (cons datum (ledger-grounds l)))))

(define (declared s) (ledger-assumptions (simplifier-ledger s)))

;; ---------------------------------------------------------------------------
;; Signs: 1 of what is not negative, -1 of what is not positive

;; -> 1, -1 or, if it is not known, #f
(define (decided-sign s e)
  (define k (infer-signs (declared s) s e))
  (define branch (decided-branch k))
  (when branch
    (for ([d (in-list (known-because k))]) (note! (simplifier-ledger s) d)))
  branch)

(define (decided-branch k)
  (cond [(signs-within? (known-signs k) nonnegative) 1]
        [(signs-within? (known-signs k) nonpositive) -1]
        [else #f]))

;; The same, or 1 where e may be taken not to be negative.
(define (sign-or-assumed s e) (or (decided-sign s e) (assume! s e)))

;; The same if it is known; else it is left open.
(define (sign-or-left-open s e) (or (decided-sign s e) (leave-open! s e)))

;; -> 1, or #f where nothing may be taken for granted, as of what is not real
(define (assume! s e)
  (and (assumptions-automatic? (declared s))
       (known-real? s e)
       (let ([l (simplifier-ledger s)] [r (taken-relation e)])
         (note! l (relation-datum r))
         (set-ledger-taken! l (cons r (ledger-taken l)))
         1)))

(define (taken-relation e) (relation (list '>= (expression->datum e) 0) e nonnegative))

;; -> #f
(define (leave-open! s e)
  (define l (simplifier-ledger s))
  (set-ledger-open! l (cons e (ledger-open l)))
  #f)

;; Are all numbers in e, its roots and its logarithms real?
(define (known-real? s e) (real-valued? (declared s) s e))

;; ---------------------------------------------------------------------------

;; The assumptions with those taken for granted, if they decide what is open;
;; else #f.
(define (simplifier-revision s)
  (define l (simplifier-ledger s))
  (define extended
    (and (pair? (ledger-open l))
         (pair? (ledger-taken l))
         (with-handlers ([exn:algebra:contradiction? (lambda (x) #f)])
           (add-relations (ledger-assumptions l) (reverse (ledger-taken l)) s))))
  (and extended
       (for/or ([e (in-list (ledger-open l))]) (decided-branch (infer-signs extended s e)))
       extended))
