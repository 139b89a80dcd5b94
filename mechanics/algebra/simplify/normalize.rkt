#lang racket/base
;; Normal forms: the field of an expression's kernels, and its value there.
;;
;; The kernels of an expression are found, their arguments simplified first; then the
;; expression is evaluated as a fraction of polynomials in them, reduced by the
;; relations among them.  Where that would grow too large, sums are left unexpanded.

(require racket/list
         "../assumption/ledger.rkt"
         "../expression/expression.rkt" "../expression/operation.rkt"
         "../expression/simplifier.rkt"
         "../field/field.rkt" "../field/field-extension.rkt" "../field/work-bounds.rkt"
         "../field/expression-value.rkt" "../field/rationalize.rkt"
         "../kernel/find-kernels.rkt" "../kernel/kernel.rkt"
         "../polynomial/fraction.rkt" "../polynomial/polynomial.rkt"
         "../presentation/present.rkt")

(provide (struct-out normal) normalize readable-form roomy values-together poly-branch)

;; unexpanded : the nodes that would have grown too large, in the order they were met
(struct normal (field fraction unexpanded) #:authentic)

;; ---------------------------------------------------------------------------
;; Sums left unexpanded

;; After so many obstructions the whole expression is left as it is.
(define blocked-limit 8)

;; The normal form of e.  Where the walk meets an obstruction, the sums there are blocked, that
;; is, left as they are; after too many obstructions, or if no fuel is left, e itself is blocked.
;; nodes : the obstructions met before, the last first
(define (normalize e s [blocked '()] [nodes '()])
  (define result
    (with-handlers ([obstruction? values]) (normalize-around e s blocked nodes)))
  (end-steps! (simplifier-fuel s))
  (cond [(normal? result) result]
        [(or (fuel-empty? (simplifier-fuel s)) (>= (length nodes) blocked-limit))
         (normalize e s (list e) (list e))]
        [else
         (define n (obstruction-node result))
         (normalize e s (append (sums-to-block n blocked) blocked) (cons n nodes))]))

;; The form itself or, if it has too many terms to be read, that of e with the
;; sums it multiplies left unexpanded.
(define (readable-form e form s)
  (if (readable? (normal-fraction form))
      form
      (normalize e s (sums-to-block e '()) (list e))))

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
  (define (operand-sums e) (append-map sums (node-args e)))
  (define found (operand-sums n))
  (if (null? found) (list n) found))

;; ---------------------------------------------------------------------------
;; The field and the value

(define (normalize-around e s blocked nodes)
  (call-with-field (collect-kernels e s blocked) e
    (lambda (F)
      (define f (field-value F e))
      (when (> (expanded-degree F f) degree-limit) (raise (obstruction e)))
      (normal F f (reverse nodes)))))

;; (proceed F) in the field of the atlas, with as much room as that needs; e is an obstruction if
;; no ring has room.
(define (call-with-field atlas e proceed)
  (spend-on-nodes! (simplifier-fuel (atlas-simplifier atlas))
                   (hash-count (atlas-resolutions atlas)))
  (define kernels (place-kernels! (atlas-kernels atlas)))
  (let retry ([degree 7])
    (when (> degree degree-limit) (raise (obstruction e)))
    (or (with-handlers ([exn:algebra:degree-overflow? (lambda (x) #f)])
          (proceed (make-field atlas kernels degree poly-branch)))
        (retry (+ 1 (* 2 degree))))))

(define (field-value F e)
  (define f (rationalize F (field-fraction F e)))
  (spend-on-terms! (simplifier-fuel (field-simplifier F))
                   (poly-term-count (fraction-numerator f)))
  f)

;; -> a field and the values there of expressions whose kernels the atlas holds, or #f #f
(define (values-together atlas es)
  (define found
    (with-handlers ([obstruction? values])
      (call-with-field atlas (car es)
        (lambda (F) (cons F (for/list ([e (in-list es)]) (field-value F e)))))))
  (end-steps! (simplifier-fuel (atlas-simplifier atlas)))
  (if (obstruction? found) (values #f #f) (values (car found) (cdr found))))

;; The sign of a polynomial, known or taken for granted, or #f.
(define (poly-branch F p)
  (sign-or-assumed (field-simplifier F) (present-poly F p)))

;; ---------------------------------------------------------------------------
;; Room for presentation

;; Presentation may multiply out all of numerator and denominator, and their
;; conjugates.
(define (expanded-degree F f)
  (define R (field-ring F))
  (if (fraction-polynomial? f)
      0
      (* 2 (+ (poly-total-degree R (fraction-numerator f)) (fraction-denominator-degree R f)))))

;; The form in a ring with room for that.
(define (roomy n)
  (define F (normal-field n))
  (define f (normal-fraction n))
  (define degree (expanded-degree F f))
  (cond [(<= degree (ring-max-degree (field-ring F))) n]
        [else
         (define-values (W w) (wider-field F f degree))
         (normal W w (normal-unexpanded n))]))
