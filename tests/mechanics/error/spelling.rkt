#lang racket/base
;; Names that an unknown one may have been meant for.

(require mechanics/error/spelling "../support/checks.rkt")

(define known
  '(Lagrange-equations Lagrangian->energy determinant invert simplify verify-solution
    matrix? matrix-by-rows matrix-by-columns matrix-ref matrix-size
    sin sinh square D Gamma literal-function velocity))

(define-check (check-suggests name names)
  (define found (likely-names name known))
  (unless (equal? found names)
    (with-check-info (['name name] ['expected names] ['found found]) (fail-check))))

(test-case "a letter left out, put in, exchanged or swapped"
  (check-suggests 'Lagrange-equation '(Lagrange-equations))
  (check-suggests 'literal--function '(literal-function))
  (check-suggests 'determinent '(determinant))
  (check-suggests 'simplfiy '(simplify))
  (check-suggests 'sqaure '(square))
  (check-suggests 'isnh '(sinh))
  (check-suggests 'sonh '(sinh))
  (check-suggests 'gamma '(Gamma))
  (check-suggests 'lagrangian->Energy '(Lagrangian->energy)))

(test-case "the nearest alone, as many as there are"
  (check-suggests 'sine '(sin sinh))
  (check-suggests 'inverse '(invert)))

(test-case "without a near one, the names that it begins, three at most; no predicates"
  (check-suggests 'matrix '(matrix-by-columns matrix-by-rows matrix-ref)))

(test-case "predicates for a predicate"
  (check-suggests 'matirx? '(matrix?)))

(test-case "no suggestion for short names, for what is far away, for what is known"
  (check-suggests 'm '())
  (check-suggests 'd '())
  (check-suggests 'sim '())
  (check-suggests 'theta '())
  (check-suggests 'omega '())
  (check-suggests 'eigenvectors '())
  (check-suggests 'simplify '()))

(test-case "alternatives are told as a sentence would"
  (check-equal? (alternatives '(a)) "a")
  (check-equal? (alternatives '(a b)) "a or b")
  (check-equal? (alternatives '(a b c)) "a, b or c"))

(test-case "among few names one slip is allowed for two letters, and for three"
  (check-equal? (nearest-names "cat" '(cut dot)) '(cut))
  (check-equal? (nearest-names "cat" '(dot)) '())
  (check-equal? (nearest-names "rismg" '(rising falling)) '(rising)))
