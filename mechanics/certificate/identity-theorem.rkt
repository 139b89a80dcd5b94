#lang racket/base
;; The identity of a verdict as a theorem: both sides, as the question states them, are equal for
;; all real values of their symbols where the hypotheses hold.

(require racket/list racket/string
         "claim-domain.rkt" "Coq-names.rkt" "Coq-term.rkt" "kernel-facts.rkt" "proof-script.rkt"
         "theorem-text.rkt")

(provide identity-theorem)

;; equations : ((left . right) ...) of expressions
;; beside    : expressions that are to have values as well
;; assumed   : datums of relations
(define (identity-theorem equations beside assumed)
  (define sides (append (map car equations) (map cdr equations)))
  (define domain (domain-relations (append sides beside)))
  (define ns (make-names (append sides beside (append-map relation-sides assumed))))
  (define hypotheses (all-hypotheses assumed domain))
  (define facts
    (kernel-facts (append sides (append-map relation-sides hypotheses))
                  (relations->assumptions hypotheses) ns (divisors-in hypotheses)))
  (define-values (lines tactic) (proof-lines facts ns))
  (theorem (string-append
            (hypotheses-text assumed hypotheses ns)
            (claim-text equations (length hypotheses) ns lines tactic)
            (example-text hypotheses ns))
           (hypothesis-texts hypotheses ns)
           '()))

(define (claim-text equations count ns lines tactic)
  (define names (string-join (all-names ns) " "))
  (string-append
   (format "Theorem claim : ~a\n  hypotheses ~a ->\n  ~a.\n" (for-all ns) names
           (string-join (for/list ([q (in-list equations)])
                          (wrapped (format "~a = ~a" (term (car q) ns) (term (cdr q) ns))))
                        " /\\\n  "))
   (format "Proof.\n  unfold hypotheses. intros ~a ~a.\n" names
           (given-pattern count))
   (string-append* (for/list ([l (in-list lines)]) (format "  ~a\n" (wrapped l))))
   (format "  repeat split; ~a.\nQed.\n\n" (wrapped tactic))))
