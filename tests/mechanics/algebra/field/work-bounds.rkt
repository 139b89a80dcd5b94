#lang racket/base
;; Graphs that would be enormous written out, or expanded, do not hold things up.

(require mechanics/algebra/expression/expression
         mechanics/algebra/expression/operation
         mechanics/algebra/expression/order
         mechanics/algebra/expression/substitute
         mechanics/algebra/simplify/simplify-expression
         mechanics/algebra/zero/zero-test
         "../../support/checks.rkt" "../../support/evaluate.rkt")

;; step applied n times; each node is used twice, so the tree has 2^n leaves.
(define (iterate n step start)
  (for/fold ([e start]) ([i (in-range n)]) (step e)))

(define (doubled e) (make-node op:+ (list e e)))
(define (squared e) (make-node op:* (list e e)))
(define (mixed e) (e:+ (make-node op:* (list e 'a)) (make-node op:* (list e 'b))))
(define (fraction e) (make-node op:/ (list (e:+ e 'a) (e:+ e 'b))))

(test-case "shared sums and products simplify in the size of the graph"
  (check-equal? (simplify-expression (iterate 60 doubled 'a))
                (e:* (expt 2 60) 'a))
  (check-equal? (simplify-expression (iterate 6 squared 'a)) (e:expt 'a 64)))

(test-case "what would expand without bound is left unexpanded"
  (define (power n) (e:expt (for/fold ([e 0]) ([s '(a b c d e f)]) (e:+ e s)) n))
  (check-equal? (simplify-expression (power 60)) (power 60))
  (for ([step (list squared mixed fraction)])
    (check-true (node? (simplify-expression (iterate 60 step (e:+ 'a 'b)))))))

(define (left-unexpanded e)
  (define-values (simple notes) (simplify-expression/assumptions e))
  (for/list ([n (in-list notes)] #:when (eq? (car n) 'left-unexpanded)) (cadr n)))

(define (sum-of . symbols) (for/fold ([sum 0]) ([s (in-list symbols)]) (e:+ sum s)))

(test-case "what is left unexpanded is told, and only then is there something to tell"
  (define s (sum-of 'a 'b 'c 'd 'e 'f))
  (check-equal? (left-unexpanded (e:expt s 60)) '((expt (+ a b c d e f) 60)))
  (check-equal? (left-unexpanded (e:* (e:+ 'x 1) (e:expt s 60))) '((expt (+ a b c d e f) 60)))
  (check-equal? (left-unexpanded (e:- (e:expt s 60) (e:expt s 60))) '())
  (check-equal? (left-unexpanded (e:expt s 5)) '()))

(test-case "the innermost of what is left unexpanded is told"
  (define (power n . symbols) (e:expt (apply sum-of symbols) n))
  (check-equal? (left-unexpanded (e:+ 'x (e:* (power 60 'a 'b 'c 'd 'e) (power 60 'f 'g 'h 'i 'j))))
                '((expt (+ a b c d e) 60) (expt (+ f g h i j) 60))))

(test-case "a power of many terms that nobody would read keeps its form"
  (define e (e:* 'x (e:expt (sum-of 'a 'b 'c 'd 'e 'f) 12)))
  (check-equal? (simplify-expression e) e)
  (check-equal? (left-unexpanded e) '((* x (expt (+ a b c d e f) 12)))))

(test-case "an absolute value is not squared if that would be enormous"
  (define sum (e:- (e:expt (sum-of 'a 'b 'c 'd) 40) 'x))
  (define size (e:apply op:abs sum))
  (check-true (node? (simplify-expression size)))
  (check-equal? (simplify-expression (e:- size size)) 0))

(test-case "a power of a high degree and its square are compared without being made"
  (define e (iterate 40 squared (e:+ 'a 'b)))
  (check-true (node? (simplify-expression e)))
  (check-eq? (zero-test-status (zero-test (e:- (squared e) (e:expt e 2)))) 'proved))

(test-case "unexpanded factors are still recognized"
  (define (big a b) (e:expt (e:+ (e:+ a b) (e:+ 'c 'd)) 20))
  (define p (e:* (big 'a 'b) (e:expt (e:+ (e:+ 'x 'y) (e:+ 'z 'w)) 20)))
  (define q (e:* (e:expt (e:+ (e:+ 'w 'z) (e:+ 'y 'x)) 20) (big 'b 'a)))
  (check-equal? (simplify-expression (e:- p q)) 0))

(test-case "a kernel nested in itself again and again comes to an end"
  (define (nest e) (make-node op:* (list (make-node op:cos (list (e:+ e 'a))) (e:+ e 'b))))
  (check-true (node? (simplify-expression (iterate 12 nest 'a)))))

(test-case "large residuals are judged"
  (define e (iterate 60 mixed (e:+ 'a 'b)))
  (check-equal? (zero-test-status (zero-test (e:- e (iterate 60 mixed (e:+ 'b 'a))))) 'proved)
  (check-equal? (zero-test-status (zero-test (iterate 60 fraction 'a))) 'refuted))

(test-case "evaluation, substitution and comparison cost the graph"
  (define e (iterate 60 doubled 'a))
  (check-equal? (evaluate-expression e (lambda (leaf arguments) 1)) (expt 2 60))
  (check-equal? (evaluate-expression (substitute-expression e '((a . b))) (lambda (leaf _) 3))
                (* 3 (expt 2 60)))
  (check-equal? (expression-compare e (iterate 60 doubled 'a)) 0)
  (check-true (expression<? e (iterate 60 doubled 'b))))
