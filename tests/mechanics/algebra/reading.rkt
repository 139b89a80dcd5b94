#lang racket/base
;; Reading S-expressions as expressions, for tests: the datum an expression
;; prints as gives an equal expression back.

(require mechanics/algebra/expression mechanics/algebra/operation)

(provide datum->expression)

(define operations
  (for/hasheq ([o (in-list (list op:+ op:* op:- op:/ op:expt op:sqrt op:exp op:log
                                 op:sin op:cos op:tan op:asin op:acos op:atan
                                 op:sinh op:cosh op:tanh op:abs op:up op:down))])
    (values (operation-name o) o)))

(define (datum->expression d)
  (if (pair? d)
      (combine (car d) (map datum->expression (cdr d)))
      d))

(define (combine head args)
  (case head
    [(+) (for/fold ([sum 0]) ([a (in-list args)]) (e:+ sum a))]
    [(*) (for/fold ([product 1]) ([a (in-list args)]) (e:* product a))]
    [(-) (if (null? (cdr args))
             (e:negate (car args))
             (for/fold ([difference (car args)]) ([a (in-list (cdr args))]) (e:- difference a)))]
    [(/) (apply e:/ args)]
    [(expt) (apply e:expt args)]
    [else (make-node (datum->head head) args)]))

(define (datum->head h)
  (cond [(symbol? h) (or (hash-ref operations h #f) (make-literal-head h))]
        [else (differentiate (car h) (make-literal-head (cadr h)))]))

;; how : D, (partial i ...), (expt how n) or (* how ...)
(define (differentiate how head)
  (cond [(eq? how 'D) (literal-head-derivative head '())]
        [(eq? (car how) 'partial) (literal-head-derivative head (cdr how))]
        [(eq? (car how) 'expt)
         (for/fold ([h head]) ([i (in-range (caddr how))]) (differentiate (cadr how) h))]
        [else (for/fold ([h head]) ([one (in-list (cdr how))]) (differentiate one h))]))
