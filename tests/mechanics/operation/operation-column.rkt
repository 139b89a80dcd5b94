#lang racket/base
;; Columns of the table of operations, and the facts that the table states.

(require racket/list
         mechanics/algebra/expression/operation
         mechanics/operation/operation-column
         (except-in mechanics/operation/operation-table reciprocals)
         "../support/checks.rkt" "../support/random.rkt")

(define-namespace-anchor here)

(define (expanded . cells)
  (expand `(module m racket/base
             (require mechanics/operation/operation-column)
             (define-column names ,@cells))))

(define functions (map entry-key (entries-where 'function)))
(define (cells-without . keys)
  (for/list ([k (in-list functions)] #:unless (memq k keys)) (list k (symbol->string k))))

(define-syntax-rule (check-refused message cell ...)
  (check-exn message (lambda ()
                       (parameterize ([current-namespace (namespace-anchor->namespace here)])
                         (apply expanded (append cell ...))))))

(test-case "a column that lacks an operation does not compile, and says which"
  (check-refused #rx"define-column: the column lacks operations: [(]sinh[)]" (cells-without 'sinh))
  (check-refused #rx"the column lacks operations: [(]sinh erf[)]" (cells-without 'sinh 'erf)))

(test-case "an operation may be lacking for a reason, alone or with others"
  (parameterize ([current-namespace (namespace-anchor->namespace here)])
    (check-not-exn (lambda () (apply expanded '[erf (none "why")] (cells-without 'erf))))
    (check-not-exn
     (lambda () (apply expanded '[(erf sinh) (none "why")] (cells-without 'sinh 'erf))))))

(test-case "a reason must be given"
  (check-refused #rx"none: unbound" '([erf (none)]) (cells-without 'erf)))

(test-case "a column of what the table does not know does not compile"
  (check-refused #rx"the column has operations that the table lacks: [(]sihn[)]"
                 '([sihn "sihn"]) (cells-without)))

(test-case "a column is a table of its cells"
  (define-column names
    [sin "sine"] [square "square"]
    [(sqrt exp log cos tan asin acos atan atan2 sinh cosh tanh asinh acosh atanh erf abs sgn)
     (none "not here")])
  (check-equal? names (hasheq 'sin "sine" 'square "square")))

(test-case "names of groups and of facts"
  (check-equal? (operation-names arithmetic) '(+ - * / expt))
  (check-equal? (operation-names reciprocal) '(sec csc cot sech csch coth))
  (check-equal? (operation-names circular) '(sin cos tan))
  (check-equal? (count (lambda (n) (eq? n 'atan)) (operation-names function)) 1)
  (check-equal? (map (lambda (k) (operation-key 'atan k)) '(1 2)) '(atan atan2))
  (check-equal? (map operation-name (operations-where total positive)) '(exp cosh)))

(test-case "partial derivatives stand in the order of the arguments"
  (define (partials key) (entry-partials (find-entry key)))
  (check-equal? (partials '-) '(1 -1))
  (check-equal? (partials '*) '(b a))
  (check-equal? (partials 'atan2) '((slope x (g:+ (g:square x) (g:square y)))
                                    (slope (g:negate y) (g:+ (g:square x) (g:square y))))))

;; ---------------------------------------------------------------------------
;; Facts

(test-case "facts that have a value hold for these"
  (check-equal? (map entry-key (entries-where 'inverse-of))
                '(sqrt log asin acos atan asinh acosh atanh))
  (check-equal? (map entry-key (entries-where 'real)) '(sqrt log asin acos acosh atanh))
  (check-equal? (entry-fact (find-entry 'log) 'inverse-of) '(exp)))

(define (number-function key)
  (operation-numeric (find-operation key)))

(define (random-in interval)
  (+ (car interval) (* (- (cadr interval) (car interval)) (random))))

(define-syntax-rule (for-facts fact (e f x) body ...)
  (with-seed 301
    (for* ([e (in-list (entries-where 'function fact))]
           [f (in-value (number-function (entry-name e)))]
           [_ (in-range 20)]
           [x (in-value (random-in (car (entry-domain e))))])
      (with-check-info (['operation (entry-key e)] ['at x]) body ...))))

(test-case "inverse functions take values back to arguments"
  (for-facts 'inverse-of (e f x)
    (define back (car (entry-fact e 'inverse-of)))
    (check-= (if (eq? back 'square) (* (f x) (f x)) ((number-function back) (f x))) x 1e-13)))

(test-case "odd and even functions are"
  (for-facts 'odd (e f x) (check-= (f (- x)) (- (f x)) 1e-15))
  (for-facts 'even (e f x) (check-= (f (- x)) (f x) 1e-15)))

(test-case "increasing functions do, and signs are as stated"
  (for-facts 'increasing (e f x) (check-true (> (f (+ x 1e-3)) (f x))))
  (for-facts 'positive (e f x) (check-true (> (f x) 0)))
  (for-facts 'nonnegative (e f x) (check-true (>= (f x) 0))))

(test-case "functions are real where the table says so, and not beyond"
  (for-facts 'total (e f x) (check-true (andmap real? (map f (list x -1e3 1e2)))))
  (for ([e (in-list (entries-where 'real))])
    (define-values (how bound) (apply values (entry-fact e 'real)))
    (define f (number-function (entry-name e)))
    (define inward (if (eq? how 'within) -0.5 0.5))
    (with-check-info (['operation (entry-key e)])
      (check-true (real? (f (+ bound inward))))
      (check-false (real? (f (- bound inward)))))))
