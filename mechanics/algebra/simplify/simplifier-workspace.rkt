#lang racket/base
;; The simplifier: one workspace serves an expression and everything within it.
;;
;; Each node is treated once, and signs taken for granted are written in a ledger.
;; The rooms below, which need parts simplified, know the workspace by its methods.

(require racket/list
         "argument-alignment.rkt" "normalize.rkt" "radicand.rkt" "stable-form.rkt"
         (only-in "../assumption/assumption-set.rkt" plainly-real?)
         (only-in "../assumption/ledger.rkt" make-ledger)
         "../expression/expression.rkt" "../expression/nodes.rkt" "../expression/operation.rkt"
         "../expression/pi.rkt" "../expression/simplifier.rkt" "../expression/size.rkt"
         "../field/field.rkt" "../field/work-bounds.rkt"
         "../presentation/linear-parts.rkt" "../presentation/present.rkt")

(provide make-workspace workspace-left workspace-simplify workspace-normal)

;; normals : expression -> normal form; simples : expression -> simplified
;; term-lists : expression -> terms; part-lists : expression -> linear parts.  These
;; tables know expressions by structure: kernels are met again and again in nodes of
;; their own.
;; involved? : expression -> boolean (argument-alignment.rkt)
;; left-unexpanded : nodes, the last met first
(struct workspace simplifier
  (normals simples term-lists part-lists involved? [left-unexpanded #:mutable])
  #:authentic)

;; q : the question (assumption/ledger.rkt)
(define (make-workspace A q [fuel (make-fuel)])
  (workspace workspace-methods (make-ledger A q) fuel
             (make-hash) (make-hash) (make-hash) (make-hash) (make-involved?) '()))

;; ---------------------------------------------------------------------------
;; Normal forms

(define (normal-of w e)
  (define n (if (node? e) e (make-node op:+ (list e))))
  (hash-ref! (workspace-normals w) n (lambda () (normalize (aligned w n) w))))

(define (aligned w n)
  (align n w (workspace-involved? w)
         (lambda (e) (field-kernels (normal-field (nested-normal w e))))))

(define (nested-normal w e)
  (call-nested (simplifier-fuel w) (lambda () (normal-of w e))))

;; (proceed field fraction), with room to present it
(define (with-normal w e proceed)
  (define n (roomy (nested-normal w e)))
  (proceed (normal-field n) (normal-fraction n)))

;; The normal form of e, with room to present it.
(define (workspace-normal w e) (roomy (normal-of w e)))

;; ---------------------------------------------------------------------------
;; Simplified expressions

(define (workspace-simplify w e) (if (plain? e) e (simplify-anew w e)))

(define (simplify w e)
  (cond [(plain? e) e]
        [(hash-ref (workspace-simples w) e #f)]
        [(and (fuel-empty? (simplifier-fuel w)) (not (small? e))) e]
        [else (call-nested (simplifier-fuel w) (lambda () (simplify-anew w e)))]))

;; The simplified expression has the normal form of e.
(define (simplify-anew w e)
  (define form (readable-form e (normal-of w e) w))
  (define simple (settle form w))
  (define simples (workspace-simples w))
  (hash-set! simples e simple)
  (when (node? simple)
    (leave! w (normal-unexpanded form))
    (hash-set! simples simple simple)
    (hash-set! (workspace-normals w) simple (normal-of w e)))
  simple)

;; Simplified even when there is no fuel left.
(define (small? e) (< (expression-size e) 60))

;; Nothing to do?
(define (plain? e)
  (if (node? e) (simple-application? e) (not (pi-alias? e))))

;; A literal function of symbols and exact numbers.
(define (simple-application? e)
  (and (node? e)
       (literal-head? (node-head e))
       (for/and ([a (in-list (node-args e))])
         (if (number? a) (exact? a) (settled-symbol? a)))))

(define (settled-symbol? e) (and (symbol? e) (not (pi-alias? e))))

;; ---------------------------------------------------------------------------
;; Terms and factors

(define (terms w e) (combination w e workspace-term-lists linear-terms))
(define (parts w e) (combination w e workspace-part-lists linear-parts))

;; e as ((number . expression) ...), which the table keeps
(define (combination w e table terms-of)
  (if (or (settled-symbol? e) (simple-application? e))
      (list (cons 1 e))
      (hash-ref! (table w) e (lambda () (with-normal w e terms-of)))))

(define (factors w e) (with-normal w e fraction-factors))

(define (irreducible-factors w e) (with-normal w e fraction-factors/irreducible))

(define (root-parts w e degree)
  (with-normal w e (lambda (F f) (split-root F f degree (plainly-real? e)))))

(define workspace-methods (methods simplify terms parts factors irreducible-factors root-parts))

;; ---------------------------------------------------------------------------
;; The parts left unexpanded

(define (leave! w nodes)
  (set-workspace-left-unexpanded! w (append (reverse nodes) (workspace-left-unexpanded w))))

;; Datums (left-unexpanded e) for the innermost operations that would have grown too large, a few
;; of them.
(define (workspace-left w)
  (define all (reverse (workspace-left-unexpanded w)))
  (define others (make-hasheq))
  (for ([e (in-list all)]) (hash-set! others e #t))
  (define innermost
    (filter-not (lambda (e) (contains-any? e others)) (remove-duplicates all)))
  (for/list ([e (in-list innermost)] [_ (in-range shown-limit)])
    (list 'left-unexpanded (expression->datum e))))

(define shown-limit 3)

;; Is one of these nodes below e?
(define (contains-any? e nodes)
  (some-node? (lambda (n) (and (not (eq? n e)) (hash-ref nodes n #f))) e))
