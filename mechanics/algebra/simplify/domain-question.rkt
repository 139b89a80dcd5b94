#lang racket/base
;; Questions, of which the ledger asks where they have a value.

(require racket/list
         racket/promise
         "simplifier-workspace.rkt"
         "../assumption/assumption-set.rkt" "../assumption/domain.rkt"
         "../assumption/ledger.rkt" "../assumption/narrowing.rkt" "../assumption/signs.rkt"
         "../expression/expression.rkt" "../expression/operation.rkt" "../expression/symbols.rkt")

(provide question-about domain-assumptions neutral-workspace)

;; A workspace for expressions that belong to no question; it takes no sign for granted.
(define (neutral-workspace)
  (make-workspace (with-automatic-assumptions no-assumptions #f) (question '() #f)))

;; es : expressions, which are asked about under the assumptions A
(define (question-about es A)
  (question es (delay (domain-assumptions es A))))

;; A with the relations of the domain; #f if there are none, too many, or if they cannot
;; all hold: then there is no point to speak of.
(define (domain-assumptions es A)
  (define found (remove-duplicates (append-map domain-relations es)))
  (cond [(not (<= 1 (length found) most-relations)) #f]
        [(and (null? (assumptions-relations A)) (monomials-apart? found))
         (assumptions-of-monomials found A)]
        [else
         (define w (neutral-workspace))
         (define relations (for/list ([r (in-list found)]) (simplified r w)))
         (with-handlers ([exn:algebra:contradiction? (lambda (x) #f)])
           (add-relations A (filter (lambda (r) (met-inside? r A w)) relations) w))]))

;; √(-x²) is asked about where it is imaginary, not at x = 0 alone.
(define (met-inside? r A w)
  (not (eqv? zero (known-signs (meet (infer-signs A w (relation-expression r))
                                     (known (relation-signs r) '()))))))

(define most-relations 30)

(define (simplified r w)
  (relation #f (workspace-simplify w (relation-expression r)) (relation-signs r)))

;; ---------------------------------------------------------------------------
;; Frequencies √(k/m) are the roots met most often.  Such relations between k and m
;; say nothing of one of them, and no narrowing is needed to see that.

;; All of single unknowns, or all of products and quotients?
(define (monomials-apart? relations)
  (define (single? r) (unknown? (relation-expression r)))
  (and (andmap of-monomial? relations)
       (or (andmap single? relations) (not (ormap single? relations)))))

(define (of-monomial? r)
  (define e (relation-expression r))
  (or (unknown? e)
      (and (node? e)
           (memq (node-head e) (list op:* op:/))
           (andmap unknown? (node-args e))
           (not (check-duplicates (node-args e))))))

(define (assumptions-of-monomials relations A)
  (struct-copy assumptions A
               [relations relations]
               [table
                (for/fold ([table (hash)]) ([r (in-list relations)])
                  (hash-update table (list (cons 1 (relation-expression r)))
                               (lambda (k) (meet k (known (relation-signs r) '())))
                               unknown))]
               [sums '()]))
