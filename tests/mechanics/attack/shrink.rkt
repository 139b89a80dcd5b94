#lang racket/base
;; The least statement of which the same claim is still wrong in the same way.
;;
;; Parts are replaced by parts of their own, a part that occurs on both sides by a symbol
;; on both, and relations are left out; every step makes the statement smaller.

(require racket/list
         "claims.rkt" "statement.rkt")

(provide shrunk)

(define most-tries 150)

;; outcome, wrong -> outcome
(define (shrunk o)
  (define kind (fault-kind-of o))
  (define tries 0)
  (define (wrong-again s)
    (set! tries (+ tries 1))
    (define new (and (<= tries most-tries) (claim-again (outcome-claim o) s)))
    (and new (eq? kind (fault-kind-of new)) new))
  (if (or (not (statement-of o)) (memq kind '(opposites-proved slow)))
      o
      (let loop ([o o] [s (start o)])
        (define next
          (for/or ([candidate (in-list (smaller s))])
            (define new (wrong-again candidate))
            (and new (cons new candidate))))
        (if next (loop (car next) (cdr next)) o))))

;; The statement that was claimed: of an opposite, the one whose opposite that is.
(define (start o)
  (define s (statement-of o))
  (if (eq? 'opposite (outcome-claim o))
      (struct-copy statement s [right (cadr (statement-right s))])
      s))

(define (smaller s)
  (define-values (left right given) (values (statement-left s) (statement-right s)
                                            (statement-given s)))
  (define (with l r g) (statement l r g (statement-hints s)))
  (append
   (for/list ([g (in-list given)]) (with left right (remove g given)))
   (for*/list ([part (in-list (common-parts left right))] [leaf (in-list '(x y))]
               #:unless (equal? part leaf))
     (with (substituted left part leaf) (substituted right part leaf) given))
   (for/list ([l (in-list (smaller-forms left))]) (with l right given))
   (for/list ([r (in-list (smaller-forms right))]) (with left r given))))

(define (parts e) (if (pair? e) (cons e (append-map parts (cdr e))) '()))

(define (common-parts left right)
  (define other (parts right))
  (sort (remove-duplicates (filter (lambda (p) (member p other)) (parts left)))
        > #:key expression-size))

;; e with one of its parts replaced by an argument of that.
(define (smaller-forms e)
  (if (pair? e)
      (append
       (filter (lambda (a) (not (number? a))) (cdr e))
       (for*/list ([i (in-range 1 (length e))] [new (in-list (smaller-forms (list-ref e i)))])
         (list-set e i new)))
      '()))
