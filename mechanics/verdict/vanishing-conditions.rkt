#lang racket/base
;; The choices of parameters that a verdict tells: for each scalar of a residual, and for all.
;;
;; One is told if the question keeps its meaning.  That a single symbol is zero is told only
;; where the matter of the question is known: of a residual alone nobody knows which of
;; its symbols are masses.

(require racket/list
         "../value/algebra.rkt")

(provide sensible-ways ways-for-all)

;; z : test of the expression e; given : #f or the meaning of the question; A : assumptions
;; -> lists of equations, each of which makes e zero
(define (sensible-ways z e given A)
  (define m (meaning-with (list e) given))
  (define (known? way) (or given (not (ormap symbol-alone? way))))
  (filter (lambda (way) (and (known? way) (meaningful? m way A))) (zero-test-ways z)))

;; ways : those of each scalar that is not zero
;; -> those that make all of them zero: the shared ones, or else the first ones together
(define (ways-for-all ways given A)
  (define shared
    (for/list ([way (in-list (if (null? ways) '() (car ways)))]
               #:when (for/and ([others (in-list ways)])
                        (memf (lambda (w) (same-equations? w way)) others)))
      way))
  (cond [(pair? shared) shared]
        [(and (pair? ways) (andmap pair? ways))
         (define together (independent-equations (append-map car ways)))
         (if (and together
                  (<= (length together) most-equations)
                  (meaningful? (meaning-with '() given) together A))
             (list together)
             '())]
        [else '()]))

(define most-equations 4)
