#lang racket/base
;; Labels of axes and legends: text, or formulas, which are kept as trees, so that a frame can be
;; written into files.

(require (only-in "../../../algebra/expression/expression.rkt" symbolic?)
         "../../../generic/value-tree.rkt" "../../../generic/wrong-argument.rkt")

(provide checked-label)

;; -> a string, a tree (algebra/notation/tree.rkt), or #f
(define (checked-label who what x)
  (cond [(or (not x) (string? x) (prefab-struct-key x)) x]
        [(symbolic? x) (value->tree x #t)]
        [else (complain-of-argument who (string-append "a string or a formula, such as 'theta, as "
                                                       what ", or #f")
                                    x)]))
