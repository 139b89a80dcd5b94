#lang racket/base
;; Circular and hyperbolic functions written in exponentials:
;;
;;     cos u = (eⁱᵘ + e⁻ⁱᵘ)/2,   sin u = (eⁱᵘ - e⁻ⁱᵘ)/2i,   cosh u = (eᵘ + e⁻ᵘ)/2 ...
;;
;; Nobody would read it, but where many angles are sums and multiples of a few
;; the normal form is far smaller: the cosine of 5a + 3b is two products of
;; powers of eⁱᵃ and eⁱᵇ, in cos a, sin a, cos b and sin b it has twelve terms.

(require "../expression/expression.rkt" "../expression/nodes.rkt" "../expression/operation.rkt"
         "../expression/substitute.rkt")

(provide in-exponentials hyperbolic-in-exponentials single-valued?)

;; -> expression; e itself if it has no such functions.
(define (in-exponentials e) (rewritten e rewritings))
(define (hyperbolic-in-exponentials e) (rewritten e hyperbolic-rewritings))

(define (rewritten e rewritings)
  (define exponential (make-exponential))
  (node-fold e
             values
             (lambda (n args)
               (define rewrite (hash-ref rewritings (node-head n) #f))
               (cond [rewrite (rewrite exponential (car args))]
                     [(andmap eq? args (node-args n)) n]
                     [else (rebuild (node-head n) args)]))))

;; One node for e^u however often it is wanted.
(define (make-exponential)
  (define table (make-hash))
  (lambda (u)
    (hash-ref! table u (lambda () (if (eqv? u 0) 1 (make-node op:exp (list u)))))))

(define ((even unit) E u)
  (define x (E (e:* unit u)))
  (e:* 1/2 (e:+ x (e:/ 1 x))))

(define ((odd unit) E u)
  (define x (E (e:* unit u)))
  (e:* (/ 1/2 unit) (e:- x (e:/ 1 x))))

(define ((ratio unit) E u)
  (e:/ ((odd unit) E u) ((even unit) E u)))

(define hyperbolic-rewritings
  (hasheq op:cosh (even 1) op:sinh (odd 1) op:tanh (ratio 1)))

(define rewritings
  (hash-set* hyperbolic-rewritings op:cos (even +i) op:sin (odd +i) op:tan (ratio +i)))

;; ---------------------------------------------------------------------------

;; Are all operations of e rational, or exponential, circular or hyperbolic
;; functions?  Then identities of exponentials of complex numbers hold for it.
(define (single-valued? e)
  (define (of-many-values? n)
    (define head (node-head n))
    (not (or (literal-head? head)
             (memq head single-valued)
             (hash-has-key? rewritings head)
             (integer-power? n))))
  (not (some-node? of-many-values? e)))

(define single-valued (list op:+ op:- op:* op:/ op:exp op:up op:down))
