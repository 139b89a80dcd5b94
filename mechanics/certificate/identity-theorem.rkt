#lang racket/base
;; The identity of a verdict as a theorem: its residual, as the question states it, is zero for all
;; real values of its symbols where the hypotheses hold.

(require racket/list racket/string
         "claim-domain.rkt" "Coq-names.rkt" "Coq-term.rkt" "kernel-facts.rkt" "proof-script.rkt"
         "theorem-text.rkt")

(provide identity-theorem)

;; residuals : expressions that are zero; beside : expressions that are to have values as well
;; assumed : datums of relations
(define (identity-theorem residuals beside assumed)
  (define domain (domain-relations (append residuals beside)))
  (define ns (make-names (append residuals beside (append-map relation-sides assumed))))
  (define hypotheses (remove-duplicates (append assumed domain)))
  (define facts
    (kernel-facts (append residuals (append-map relation-sides hypotheses))
                  (relations->assumptions hypotheses) ns))
  (define-values (lines tactic) (proof-lines facts ns))
  (theorem (string-append
            (hypotheses-text assumed domain ns)
            (claim-text residuals (length hypotheses) ns lines tactic)
            (example-text hypotheses ns))
           (length hypotheses)))

(define (claim-text residuals count ns lines tactic)
  (define names (string-join (all-names ns) " "))
  (string-append
   (format "Theorem claim : ~a\n  hypotheses ~a ->\n  ~a.\n" (for-all ns) names
           (string-join (for/list ([e (in-list residuals)])
                          (wrapped (format "~a = 0" (term e ns))))
                        " /\\\n  "))
   (format "Proof.\n  unfold hypotheses. intros ~a ~a.\n" names
           (given-pattern count))
   (string-append* (for/list ([l (in-list lines)]) (format "  ~a\n" (wrapped l))))
   (format "  repeat split; ~a.\nQed.\n\n" (wrapped tactic))))
