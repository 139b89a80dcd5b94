#lang racket/base
;; Where an expression has a value: a radicand is not negative, an argument of a logarithm
;; is positive, inverse functions are real.
;;
;; These relations hold wherever there is anything to say of the expression at all.  So
;; they may be used without being told: in √(1 - x) x is at most 1.  They have no datum.
;; A relation that holds everywhere, as x² + y² ≥ 0 does, says nothing, and is left out.

(require racket/promise
         "assumption-set.rkt" "range.rkt" "signs.rkt"
         "../expression/expression.rkt" "../expression/operation.rkt")

(provide domain-relations node-relations)

;; e : an expression; -> relations, inner ones first; none where e holds a number that is not
;; real, for then its values are complex
(define (domain-relations e)
  (define found '())
  (define (note! n range)
    (define (always-holds? r)
      (and (eq? (relation-expression r) (car (node-args n)))
           (signs-within? (interval-signs (force range)) (relation-signs r))))
    (for ([r (in-list (node-relations n))])
      (unless (or (eqv? (relation-signs r) nonzero) (always-holds? r))
        (set! found (cons r found)))))
  (define all-real? #t)
  (node-fold e
             (lambda (leaf)
               (unless (or (symbol? leaf) (real? leaf)) (set! all-real? #f))
               (delay (leaf-range leaf)))
             (lambda (n ranges)         ; promises: few are asked for
               (when (pair? ranges) (note! n (car ranges)))
               (delay (node-range n (map force ranges)))))
  (if all-real? (reverse found) '()))

;; The relations without which the node has no value, though its arguments have; none of numbers
(define (node-relations n)
  (define head (node-head n))
  (define args (node-args n))
  (define u (and (pair? args) (car args)))
  (define (need signs e)
    (if (or (number? e) (eqv? signs any-sign)) '() (list (relation #f e signs))))
  (define (within-1 signs) (append (need signs (e:- u -1)) (need signs (e:- 1 u))))
  (cond [(eq? head op:/) (need nonzero (cadr args))]
        [(eq? head op:tan) (need nonzero (e:apply op:cos u))]
        [(eq? head op:sqrt) (need nonnegative u)]
        [(eq? head op:log) (need positive u)]
        [(eq? head op:expt) (need (base-signs (cadr args)) u)]
        [(memq head (list op:asin op:acos)) (within-1 nonnegative)]
        [(eq? head op:atanh) (within-1 positive)]
        [(eq? head op:acosh) (need nonnegative (e:- u 1))]
        [else '()]))

;; The signs of u for which uⁿ has a value; of a symbolic power any: (-2)³ is real.
(define (base-signs n)
  (cond [(not (rational? n)) any-sign]
        [(integer? n) (if (negative? n) nonzero any-sign)]
        [else (if (negative? n) positive nonnegative)]))
