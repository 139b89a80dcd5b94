#lang racket/base
;; The proof of an equality: facts about kernels, each proved by those before it, then the equality
;; by polynomials modulo their relations.
;;
;; `rewrite` puts the kernels in, those with others within them first; `field_simplify_eq` clears
;; divisors, each of which is shown not to vanish; `ring` knows the relations.

(require racket/string
         "Coq-term.rkt" "kernel-fact.rkt")

(provide proof-lines)

;; facts : those that an equality rests on; ns : names of all in them; first : lines before
;; -> lines that assert them, and the tactic that proves the equality after these
(define (proof-lines facts ns [first '("divisors.")])
  (for/fold ([lines first] [known '()]
             #:result (values (reverse lines) (equality-tactic known)))
            ([f (in-list facts)] [i (in-naturals 1)])
    (define name (format "kernel_~a" i))
    (define-values (claim script) (values (fact-text f ns) (script-text f known)))
    (values (cons (if (memq (fact-sort f) '(divisor factor))
                      (format "first [assert (~a : ~a) by (~a) | assert (~a : True) by exact I]."
                              name claim script name)
                      (format "assert (~a : ~a). { ~a }" name claim script))
                  lines)
            (cons (cons name (fact-sort f)) known))))

(define (fact-text f ns)
  (define-values (left right) (values (fact-left f) (fact-right f)))
  (if (pair? right)
      (relation-text (list (car right) left (cdr right)) ns)
      (format "~a = ~a" (term left ns) (term right ns))))

(define (script-text f known)
  (string-append*
   (for/list ([part (in-list (fact-script f))])
     (if (eq? part 'identity) (equality-tactic known) part))))

;; known : ((name . sort) ...), the last first
(define (equality-tactic known)
  (define (of-sort . sorts) (for/list ([k (in-list known)] #:when (memq (cdr k) sorts)) (car k)))
  (define values (of-sort 'value 'divisor))
  (define relations (of-sort 'relation))
  (define ring
    (if (null? relations) "ring" (format "ring [~a]" (string-join relations " "))))
  (format "(~afirst [reflexivity | ~a | field_simplify_eq; first [~a | nonzero]])"
          (if (null? values)
              ""
              (format "rewrite ~a in *; "
                      (string-join (for/list ([v (in-list values)]) (string-append "?" v)) ", ")))
          ring ring))
