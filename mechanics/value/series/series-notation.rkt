#lang racket/base
;; Series as they are typeset: a₀ + a₁ + ⋯, and a power series as the function
;; x ↦ a₀ + a₁ x + a₂ x² + ⋯ of a variable that its coefficients have not.

(require "../../algebra/notation/tree.rkt" "../../algebra/notation/tree-arithmetic.rkt")

(provide series-notation)

;; terms : trees, #f for a term that is 0
(define (series-notation terms finite? power?)
  (define x (and power? (unused-variable (filter values terms))))
  (define shown
    (for/list ([t (in-list terms)] [k (in-naturals)] #:when t)
      (if power? (with-power t x k) t)))
  (define sum (sum-of (if finite? shown (append shown (list (word "⋯"))))))
  (if power? (relation x "↦" sum) sum))

(define (with-power t x k)
  (define power (if (= k 1) x (power-of x (digits (number->string k)))))
  (cond [(= k 0) t]
        [(equal? t (digits "1")) power]
        [else (product-of (list t power) #t)]))

(define (unused-variable trees)
  (define used
    (let collect ([ts trees] [used (hasheq)])
      (for/fold ([used used]) ([t (in-list ts)])
        (if (name? t) (hash-set used (name-symbol t) #t) (collect (tree-parts t) used)))))
  (name (or (for/first ([s (in-list '(x z s u w y xi))] #:unless (hash-ref used s #f)) s)
            (for/first ([k (in-naturals 1)]
                        #:unless (hash-ref used (indexed-variable k) #f))
              (indexed-variable k)))))

(define (indexed-variable k) (string->symbol (format "x_~a" k)))
