#lang racket/base
;; Normal forms: the field of an expression's kernels, and its value there.
;;
;; The kernels of an expression are found, their arguments simplified first, by
;; the same means; then the expression is evaluated as a fraction of polynomials
;; in them, reduced by the relations among them.  One `workspace` serves an
;; expression and everything within it: each node is treated once, and what is
;; taken for granted is written in a ledger.

(require "align.rkt" "radicand.rkt"
         (only-in "../assumption/assumption-set.rkt" plainly-real?) "../assumption/ledger.rkt"
         "../assumption/services.rkt"
         "../expression/expression.rkt" "../expression/operation.rkt" "../expression/order.rkt"
         "../expression/size.rkt"
         "../field/bounds.rkt" "../field/field.rkt" "../field/rationalize.rkt"
         "../field/walk.rkt"
         "../kernel/find-kernels.rkt" "../kernel/kernel.rkt"
         "../polynomial/fraction.rkt" "../polynomial/polynomial.rkt"
         "../presentation/present.rkt")

(provide make-workspace workspace-assumptions workspace-left
         workspace-simplify workspace-normal workspace-atlas
         workspace-services workspace-revision poly-branch)

;; ---------------------------------------------------------------------------
;; What the work rests on; what was left unexpanded

(struct workspace (services normal-of simplify-anew ledger [left-unexpanded #:mutable])
  #:authentic)

;; What the work so far rests on, as datums such as (>= R 0).
(define (workspace-assumptions w) (ledger-grounds (workspace-ledger w)))

;; Assumptions with which to begin anew, or #f (see assumption/ledger.rkt).
(define (workspace-revision w)
  (ledger-revision (workspace-ledger w) (workspace-services w)))

(define (leave! w e)
  (set-workspace-left-unexpanded! w (cons e (workspace-left-unexpanded w))))

;; What would have grown too large, as datums (left-unexpanded e): the innermost
;; such operations, of which a few are told.
(define (workspace-left w)
  (define all (reverse (workspace-left-unexpanded w)))
  (define others (make-hasheq))
  (for ([e (in-list all)]) (hash-set! others e #t))
  (define innermost
    (filter (lambda (e) (not (contains-any? e others))) (distinct all)))
  (for/list ([e (in-list innermost)] [_ (in-range told-limit)])
    (list 'left-unexpanded (expression->datum e))))

(define told-limit 3)

;; Is one of these nodes below e?
(define (contains-any? e nodes)
  (define seen (make-hasheq))
  (define (below? e)
    (for/or ([a (in-list (node-args e))])
      (and (node? a)
           (not (hash-ref seen a #f))
           (begin (hash-set! seen a #t)
                  (or (hash-ref nodes a #f) (below? a))))))
  (below? e))

(define (distinct xs)
  (for/fold ([kept '()] #:result (reverse kept)) ([x (in-list xs)])
    (if (member x kept) kept (cons x kept))))

(define (workspace-simplify w e)
  (if (or (not (node? e)) (simple-application? e))
      e
      ((workspace-simplify-anew w) e)))

;; -> (field . fraction)
(define (workspace-normal w e) (roomy ((workspace-normal-of w) e)))

;; The kernels of e, without evaluating it.
(define (workspace-atlas w e) (collect-kernels e (workspace-services w)))

;; ---------------------------------------------------------------------------
;; The services kernels are collected with: everything once a node

;; The tables know expressions by structure: kernels are met again and again in
;; nodes of their own.  What something simplifies to has its normal form.
(define (make-workspace A [fuel (make-fuel)])
  (define ledger (make-ledger A))
  (define normals (make-hash))
  (define simples (make-hash))
  (define term-lists (make-hash))
  (define involved? (make-involved?))
  (define stuck-at (make-hasheq))           ; normal form -> nodes
  (define (normal e)
    (define n (if (node? e) e (make-node op:+ (list e))))
    (or (hash-ref normals n #f)
        (let ([form (normalize (aligned n) services*)])
          (hash-set! normals n form)
          form)))
  (define (aligned n)
    (define (alone e) (field-kernels (car (call-nested fuel (lambda () (normal e))))))
    (align n involved? alone simplify
           (lambda (e) (collect-kernels e services*))
           (lambda (atlas es) (call-nested fuel (lambda () (values-together atlas es services*))))))
  (define (call f e . more)
    (define n (roomy (call-nested fuel (lambda () (normal e)))))
    (apply f (car n) (cdr n) more))
  (define (simplify e)
    (cond [(or (not (node? e)) (simple-application? e)) e]
          [(hash-ref simples e #f)]
          [(and (fuel-empty? fuel) (not (small? e))) e]
          [else (call-nested fuel (lambda () (simplify-anew e)))]))
  (define (simplify-anew e)
    (define form (readable-form e (normal e) services*))
    (define simple (settle form services*))
    (when (node? simple)
      (for ([n (in-list (hash-ref stuck-at form '()))]) (leave! w n)))
    (hash-set! simples e simple)
    (when (node? simple)
      (hash-set! simples simple simple)
      (hash-set! normals simple (normal e)))
    simple)
  (define (terms e)
    (cond [(or (symbol? e) (simple-application? e)) (list (cons 1 e))]
          [else (hash-ref! term-lists e (lambda () (call linear-terms e)))]))
  (define (factors e) (call fraction-factors e))
  (define (irreducible e) (call fraction-factors/irreducible e))
  (define (branch e) (services-branch services* e))
  (define (split-root* e degree) (call split-root e degree branch (plainly-real? e)))
  (define (sign e) (ledger-sign! ledger services* e))
  (define (real? e) (ledger-real? ledger services* e))
  (define (assume! e) (ledger-assume! ledger services* e))
  (define (leave-open! e) (ledger-leave-open! ledger e))
  (define (stuck! form nodes) (hash-set! stuck-at form nodes))
  (define services*
    (services simplify terms factors irreducible split-root*
              sign real? assume! leave-open! stuck! fuel))
  (define w (workspace services* normal simplify-anew ledger '()))
  w)

;; A literal function of symbols and exact numbers: nothing to do.
(define (simple-application? e)
  (and (node? e)
       (literal-head? (node-head e))
       (for/and ([a (in-list (node-args e))])
         (or (symbol? a) (and (number? a) (exact? a))))))

;; What a normal form is presented as.  Which angles are basic depends on those
;; that occur, so a result in others is simplified again until it stays as it is or is
;; one that came before: the least of those that keep coming back.
(define (settle form services)
  (let loop ([form form] [seen '()])
    (define e (present (car form) (cdr form)))
    (define cycle (member e (reverse seen)))
    (cond [cycle (least-expression cycle)]
          [(or (not (node? e)) (settled? (car form) e services)) e]
          [(= (length seen) settle-limit) (least-expression (cons e seen))]
          [else (loop (normalize e services) (cons e seen))])))

(define settle-limit 4)

;; Simplified even when there is no fuel left.
(define (small? e) (< (expression-size e) 60))

;; Would e, presented from this field, come out again?
(define (settled? F e services)
  (or (not (or (atlas-dependent? (field-atlas F)) (new-angles? F e)))
      (same-field? F e services)))

;; Would e be simplified in this very field?
(define (same-field? F e services)
  (define known
    (for/hash ([k (in-vector (field-kernels F))]) (values (kernel-expression k) #t)))
  (define (known? e) (hash-ref known e #f))
  (define atlas (collect-kernels e services))
  (define kernels (atlas-kernels atlas))
  (and (= (length kernels) (hash-count known))
       (for/and ([k (in-list kernels)]) (known? (kernel-expression k)))
       (same-circles? (atlas-doubled atlas) (atlas-doubled (field-atlas F)))))

(define (same-circles? as bs)
  (define (expressions os) (for/hash ([o (in-list os)]) (values (circle-expression o) #t)))
  (equal? (expressions as) (expressions bs)))

;; Has presentation put angles together that did not occur?
(define (new-angles? F e)
  (define known
    (for/hash ([k (in-vector (field-kernels F))] #:when (circle? (kernel-relation k)))
      (values (circle-expression (kernel-relation k)) #t)))
  (define memo (make-memo))
  (define (new? e)
    (and (node? e) (memo e (lambda () (new-node? e)))))
  (define (new-node? n)
    (cond [(memq (node-head n) (list op:+ op:- op:* op:/ op:expt))
           (ormap new? (node-args n))]
          [(memq (node-head n) (list op:sin op:cos op:sinh op:cosh))
           (not (hash-ref known (car (node-args n)) #f))]
          [else #f]))
  (and (positive? (hash-count known)) (new? e)))

;; -> (field . fraction), the field of e's kernels and its value there.  Sums at which
;; the walk gets stuck are left unexpanded; after too many of them, or if there is
;; no fuel left, e is.
(define stuck-limit 8)

(define (normalize e services [blocked '()] [nodes '()])
  (define fuel (services-fuel services))
  (let retry ([blocked blocked] [nodes nodes])
    (define result
      (with-handlers ([stuck? values]) (normalize-around e services blocked)))
    (end-steps! fuel)
    (cond [(not (stuck? result))
           ((services-stuck! services) result (reverse nodes))
           result]
          [(or (fuel-empty? fuel) (>= (length nodes) stuck-limit))
           (retry (list e) (list e))]
          [else
           (define n (stuck-node result))
           (retry (append (sums-to-block n blocked) blocked) (cons n nodes))])))

;; The form itself or, if it has too many terms to be read, that of e with the
;; sums it multiplies left unexpanded.
(define (readable-form e form services)
  (if (readable? (cdr form))
      form
      (normalize e services (sums-to-block e '()) (list e))))

;; The sums among the factors of the operands of n; n itself if there are none.
(define (sums-to-block n blocked)
  (define seen (make-hasheq))
  (define (sums e)
    (cond [(or (not (node? e)) (memq e blocked) (hash-ref seen e #f)) '()]
          [else
           (hash-set! seen e #t)
           (cond [(memq (node-head e) (list op:+ op:-)) (list e)]
                 [(memq (node-head e) (list op:* op:/ op:expt)) (operand-sums e)]
                 [else '()])]))
  (define (operand-sums e) (apply append (map sums (node-args e))))
  (define found (operand-sums n))
  (if (null? found) (list n) found))

(define (normalize-around e services blocked)
  (call-with-field (collect-kernels e services blocked) e
    (lambda (F)
      (define f (field-value F e))
      (when (> (expanded-degree F f) degree-limit) (raise (stuck e)))
      (cons F f))))

;; (proceed F) in the field of the atlas, with as much room as that needs; stuck at e
;; if there is none.
(define (call-with-field atlas e proceed)
  (spend-on-nodes! (services-fuel (atlas-services atlas)) (hash-count (atlas-resolutions atlas)))
  (define kernels (place-kernels! (atlas-kernels atlas)))
  (let retry ([degree 7])
    (when (> degree degree-limit) (raise (stuck e)))
    (or (with-handlers ([exn:algebra:degree-overflow? (lambda (x) #f)])
          (proceed (make-field atlas kernels degree poly-branch)))
        (retry (+ 1 (* 2 degree))))))

(define (field-value F e)
  (define f (rationalize F (field-fraction F e)))
  (spend-on-terms! (services-fuel (atlas-services (field-atlas F)))
                   (poly-term-count (fraction-numerator f)))
  f)

;; -> a field and the values there of expressions whose kernels the atlas holds, or #f #f
(define (values-together atlas es services)
  (define found
    (with-handlers ([stuck? values])
      (call-with-field atlas (car es)
        (lambda (F) (cons F (for/list ([e (in-list es)]) (field-value F e)))))))
  (end-steps! (services-fuel services))
  (if (stuck? found) (values #f #f) (values (car found) (cdr found))))

;; Presentation may multiply out all of numerator and denominator, and their
;; conjugates.
(define (expanded-degree F f)
  (define R (field-ring F))
  (if (fraction-polynomial? f)
      0
      (* 2 (for/fold ([degree (poly-total-degree R (fraction-numerator f))])
                     ([h (in-list (fraction-denominator-factors f))])
             (+ degree (* (power-exponent h) (poly-total-degree R (power-base h))))))))

;; (field . fraction) in a ring with room for that.
(define (roomy n)
  (define degree (expanded-degree (car n) (cdr n)))
  (cond [(<= degree (ring-max-degree (field-ring (car n)))) n]
        [else
         (define-values (F f) (wider-field (car n) (cdr n) degree))
         (cons F f)]))

;; The sign of a polynomial, known or taken for granted, or #f.
(define (poly-branch F p)
  (services-branch (atlas-services (field-atlas F))
                   (present F (fraction-from-poly (field-ring F) p))))
