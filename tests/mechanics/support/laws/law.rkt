#lang racket/base
;; Algebraic laws as data, so that any kind of value can be run through them.
;;
;; A law states two sides that must be the same, for all elements drawn.  A suite
;; is a list of laws over one record of operations.  To trust a law one must have
;; seen it fail: `check-broken` asks that it does, under operations made wrong.

(require "../checks.rkt" "../random.rkt")

(provide (struct-out law) define-laws
         check-laws check-broken counterexample law-named)

;; statement : operations element ... -> (values left right)
(struct law (name statement))

;; (define-laws suite (field-accessor ...) [name (x ...) left right] ...): each
;; accessor is a pair (local-name accessor) naming an operation within the laws.
(define-syntax-rule (define-laws id ([local accessor] ...) [name (x ...) left right] ...)
  (define id (list (one-law name ([local accessor] ...) (x ...) left right) ...)))

(define-syntax-rule (one-law name ([local accessor] ...) (x ...) left right)
  (law name (lambda (o x ...)
              (let ([local (accessor o)] ...)
                (values left right)))))

(define (law-named name laws)
  (or (for/first ([l (in-list laws)] #:when (equal? (law-name l) name)) l)
      (raise-argument-error 'law-named "the name of a law" name)))

;; The elements, left and right side of a failure, or #f if none is found.
(define (counterexample l operations draw same? rounds)
  (define n (sub1 (procedure-arity (law-statement l))))
  (for/or ([_ (in-range rounds)])
    (define elements (for/list ([_ (in-range n)]) (draw)))
    (define-values (left right) (apply (law-statement l) operations elements))
    (and (not (same? left right)) (list elements left right))))

;; One test case for each law.
(define (check-laws title laws operations draw same? #:seed seed #:rounds [rounds 20])
  (for ([l (in-list laws)])
    (test-case (format "~a: ~a" title (law-name l))
      (with-seed seed
        (define found (counterexample l operations draw same? rounds))
        (when found
          (with-check-info (['elements (car found)] ['left (cadr found)] ['right (caddr found)])
            (fail-check "the law does not hold")))
        (check-false found)))))

;; The wrong operations break the law of that name.
(define (check-broken name laws operations draw same? #:seed seed #:rounds [rounds 20])
  (test-case (format "wrong operations break: ~a" name)
    (with-seed seed
      (check-not-false (counterexample (law-named name laws) operations draw same? rounds)))))
