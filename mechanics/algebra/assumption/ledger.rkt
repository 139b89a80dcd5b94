#lang racket/base
;; The grounds of one simplification: the relations it used, the signs it took
;; for granted, and those it had to leave open.
;;
;; A sign is known by declarations, by the nature of real numbers (cos x is less than 2), and by
;; the question's domain: where √(1 - x) has a value, x is at most 1.  A sign unknown so far
;; is that at the question's reference point (reference-point.rkt), if signs may be taken for
;; granted.
;;
;; The assumptions are the same from beginning to end, so that the order in which
;; an expression's parts are met makes no difference.  If a sign taken for
;; granted in one place decides one left open in another, as in √(x²) + |x|,
;; the ledger has a revision: with those assumptions all is done again.
;;
;; All signs are asked of a simplifier, which has the ledger they are noted in.

(require racket/promise
         "assumption-set.rkt" "narrowing.rkt" "range.rkt" "reference-point.rkt" "signs.rkt"
         "../expression/expression.rkt" "../expression/simplifier.rkt")

(provide make-ledger (struct-out question)
         decided-sign strict-sign sign-or-assumed sign-or-left-open taken-not-negative? known-real?
         simplifier-grounds simplifier-revision)

;; The question.
;; expressions : all that is to have a value
;; domain : promise of the assumptions with the relations of its domain; or #f
(struct question (expressions domain) #:authentic)

;; point : promise of the lookup of the reference point, or of #f
;; grounds : datums, newest first, each once; noted : the same as a table
;; taken, open : expressions taken not to be negative, and of unknown sign
;; asked : (assumptions . expression) pairs, whose signs are being looked for
(struct ledger (assumptions domain point noted
                            [grounds #:mutable] [taken #:mutable] [open #:mutable]
                            [asked #:mutable])
  #:authentic)

(define (make-ledger A q)
  (ledger A
          (question-domain q)
          (delay (or (common-point A) (find-reference (question-expressions q) A)))
          (make-hash) '() '() '() '()))

;; The reference point of the question of which this is a part, or #f.
(define (common-point A)
  (define point (assumptions-reference A))
  (and point (point)))

;; The grounds of the result, as datums such as (>= R 0), in the order they were needed.
(define (simplifier-grounds s) (reverse (ledger-grounds (simplifier-ledger s))))

;; Relations of the domain have no datum.
(define (note! l datum)
  (unless (or (not datum) (hash-ref (ledger-noted l) datum #f))
    (hash-set! (ledger-noted l) datum #t)
    (set-ledger-grounds! l (cons datum (ledger-grounds l)))))

(define (declared s) (ledger-assumptions (simplifier-ledger s)))

;; ---------------------------------------------------------------------------
;; Signs: 1 if not negative, -1 if not positive

;; -> 1, -1 or, if it is not known, #f
(define (decided-sign s e) (known-branch s e decided-branch))

;; -> 1, -1 or 0, the sign of e wherever it has a value, or #f
(define (strict-sign s e) (known-branch s e strict-branch))

;; branch-of : signs -> the branch that they decide, or #f
(define (known-branch s e branch-of)
  (or (branch-under (declared s) s e branch-of)
      (and (known-real? s e) (branch-of (range-signs e)))
      (branch-in-domain s e branch-of)))

;; As the assumptions decide it; the grounds are noted.
(define (branch-under A s e branch-of)
  (define l (simplifier-ledger s))
  (define k (asked-once A s e (lambda () (infer-signs A s e)) unknown))
  (define branch (branch-of (known-signs k)))
  (when branch
    (for ([d (in-list (known-because k))]) (note! l d)))
  branch)

;; Result of find.  A relation may hold sgn u or |u|: then the sign of u is asked for while it is
;; looked for, and the answer is `unknown`.
(define (asked-once A s e find unknown)
  (define l (simplifier-ledger s))
  (define before (ledger-asked l))
  (define (asked? q) (and (eq? (car q) A) (equal? (cdr q) e)))
  (if (ormap asked? before)
      unknown
      (dynamic-wind (lambda () (set-ledger-asked! l (cons (cons A e) before)))
                    find
                    (lambda () (set-ledger-asked! l before)))))

(define (branch-in-domain s e branch-of)
  (define A (force (ledger-domain (simplifier-ledger s))))
  (and A (branch-under A s e branch-of)))

(define (decided-branch signs)
  (cond [(signs-within? signs nonnegative) 1]
        [(signs-within? signs nonpositive) -1]
        [else #f]))

(define (strict-branch signs)
  (cond [(signs-within? signs positive) 1]
        [(signs-within? signs negative) -1]
        [(signs-within? signs zero) 0]
        [else #f]))

;; -> the decided sign, else that at the reference point, which is assumed; or #f
(define (sign-or-assumed s e)
  (or (decided-sign s e)
      (let ([sign (sign-to-assume s e)])
        (when sign (assume! s e sign))
        sign)))

;; -> the decided sign, or #f, and then the sign is noted as open
(define (sign-or-left-open s e) (or (decided-sign s e) (leave-open! s e)))

;; Is e known not to be negative, or taken to be so from now on?
(define (taken-not-negative? s e)
  (define known (decided-sign s e))
  (cond [known (eqv? known 1)]
        [(eqv? 1 (sign-to-assume s e)) (assume! s e 1) #t]
        [else #f]))

;; -> 1, -1, or #f where nothing may be taken for granted, as if e is not real
(define (sign-to-assume s e)
  (define lookup
    (and (assumptions-automatic? (declared s))
         (known-real? s e)
         (force (ledger-point (simplifier-ledger s)))))
  (and lookup (reference-sign e lookup)))

(define (assume! s e sign)
  (define l (simplifier-ledger s))
  (define r (taken-relation s e sign))
  (note! l (relation-datum r))
  (set-ledger-taken! l (cons r (ledger-taken l))))

;; Of sums the positive one is told: 1 - x ≥ 0, but x ≤ 0.
(define (taken-relation s e sign)
  (define (related name e signs) (relation (list name (expression->datum e) 0) e signs))
  (cond [(eqv? sign 1) (related '>= e nonnegative)]
        [(null? (cdr (simplifier-terms s e))) (related '<= e nonpositive)]
        [else (related '>= (simplifier-simplify s (e:negate e)) nonnegative)]))

;; -> #f
(define (leave-open! s e)
  (define l (simplifier-ledger s))
  (set-ledger-open! l (cons e (ledger-open l)))
  #f)

;; Are all numbers in e, its roots and its logarithms real?
(define (known-real? s e)
  (define A (declared s))
  (asked-once A s e (lambda () (real-valued? A s e)) #f))

;; ---------------------------------------------------------------------------

;; The assumptions with those taken for granted, if they decide open signs;
;; else #f.
(define (simplifier-revision s)
  (define l (simplifier-ledger s))
  (define extended
    (and (pair? (ledger-open l))
         (pair? (ledger-taken l))
         (with-handlers ([exn:algebra:contradiction? (lambda (x) #f)])
           (add-relations (ledger-assumptions l) (ledger-taken l) s))))
  (and extended
       (for/or ([e (in-list (ledger-open l))])
         (decided-branch (known-signs (infer-signs extended s e))))
       extended))
