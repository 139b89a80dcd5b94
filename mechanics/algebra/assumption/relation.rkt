#lang racket/base
;; Reading relations: (>= r 0), (> a b c), (positive m l).
;;
;; A relation of any spelling is between two expressions, and gives the
;; sign of their difference.

(require "assumption-set.rkt" "signs.rkt"
         "../../error/complain.rkt"
         "../expression/expression.rkt" "../expression/read.rkt")

(provide split-relation read-relation raise-no-relation)

(define relations
  (hasheq '> positive '>= nonnegative '< negative '<= nonpositive))

;; (positive m l) is (> m 0) and (> l 0).
(define adjectives
  (hasheq 'positive '> 'nonnegative '>= 'negative '< 'nonpositive '<=))

;; -> relations between two expressions, as datums
;; reject : the fault, and the part it is in -> does not return
(define (split-relation d [reject raise-no-relation])
  (define name (and (list? d) (pair? d) (car d)))
  (define operands (if name (map plain (cdr d)) '()))
  (cond [(not name) (reject 'form d)]
        [(hash-ref relations name #f)
         (unless (>= (length operands) 2) (reject 'operands d))
         (for/list ([a (in-list operands)] [b (in-list (cdr operands))]) (list name a b))]
        [(hash-ref adjectives name #f)
         => (lambda (relation)
              (when (null? operands) (reject 'operands d))
              (for/list ([a (in-list operands)]) (list relation a 0)))]
        [else (reject (if (eq? name '=) 'equation 'name) d)]))

;; A datum without expressions in it, nor quotes, as in '(> 'm 0).
(define (plain d)
  (cond [(node? d) (expression->datum d)]
        [(quotation? d) (plain (cadr d))]
        [(pair? d) (cons (plain (car d)) (plain (cdr d)))]
        [else d]))

(define (quotation? d) (and (list? d) (= (length d) 2) (eq? (car d) 'quote)))

;; d : a relation between two expressions, as a datum
(define (read-relation d [reject raise-no-relation])
  (define (side x)
    (define e (datum->expression x (lambda (part) (reject 'expression part))))
    (when (and (number? e) (not (and (real? e) (= e e)))) (reject 'number e))
    e)
  (relation d (e:- (side (cadr d)) (side (caddr d))) (hash-ref relations (car d))))

(define (raise-no-relation reason part)
  (complain-showing 'read-relation "not a relation between expressions"
                    "reason" reason "part" part))
