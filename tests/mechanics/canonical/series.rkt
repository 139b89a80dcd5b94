#lang racket/base
;; Series of structures and of operators: exact, readable, by powers of their parameter; and terms
;; that would swell stay as they are.

(require mechanics
         mechanics/book
         "../support/checks.rkt" "../support/messages.rkt" "../support/session.rkt")

(define line (up 't 'q 'p))

(define (terms W F n) (series:head (((Lie-transform W 'epsilon) F) line) n))

(test-case "a series of states: each term a state, with exact coefficients"
  (define head (terms (H-harmonic 'm 'k) identity 4))
  (check-prints (cadddr head)
                '(up 0
                     (/ (* -1/6 (expt epsilon 3) k p) (expt m 2))
                     (/ (* 1/6 (expt epsilon 3) (expt k 2) q) m)))
  (check-prints (car head) '(up t q p)))

(test-case "by powers: each term has its own power of the parameter, and no other"
  (define (W s) (* (sin (coordinate s)) (momentum s)))
  (for ([term (terms W coordinate 6)] [n (in-naturals)])
    (for ([k 7])
      (define c (coefficient term 'epsilon k))
      (if (= k n) (check-pred refuted? (prove-zero c)) (check-identity c 0)))))

(test-case "a sum of terms is collected by powers where that is asked for"
  (define (W s) (* (momentum s) (square (coordinate s))))
  (define sum (series:sum (((Lie-transform W 'epsilon) coordinate) line) 3))
  (check-equal? (expression (collect (expand sum) 'epsilon))
                '(+ (* (expt epsilon 3) (expt q 4)) (* (expt epsilon 2) (expt q 3))
                    (* epsilon (expt q 2)) q)))

(test-case "operators: products of exponentials, applied, give the product's terms by order"
  (define A (Lie-derivative (lambda (s) (* 1/2 (square (momentum s))))))
  (define B (Lie-derivative (lambda (s) (coordinate s))))
  (define product ((* (exp (* 'epsilon A)) (exp (* 'epsilon B))) (compose square momentum)))
  ;; exp(εB) p² = (p − ε)², which exp(εA) leaves as it is
  (for ([term (series:head (product line) 4)]
        [expected (list (square 'p) (* -2 'epsilon 'p) (square 'epsilon) 0)])
    (check-identity term expected)))

(test-case "what makes a series of operators prints as that"
  (check-equal? (format "~a" (exp (* 'epsilon (Lie-derivative (W 'alpha 'beta)))))
                "(exp (* epsilon (Lie-derivative W)))"))

(test-case "derivatives and transforms print as the calls that make them"
  (define (cubic s) (expt (momentum s) 3))
  (define L (Lie-derivative cubic))
  (check-equal? (format "~a" (L coordinate)) "((Lie-derivative cubic) coordinate)")
  (check-equal? (format "~a" ((expt L 2) coordinate))
                "((expt (Lie-derivative cubic) 2) coordinate)")
  (check-equal? (format "~a" (Lie-transform cubic 'epsilon)) "(Lie-transform cubic epsilon)"))

(says
 [(Lie-derivative 3)
  "Lie-derivative: a Hamiltonian is a function of the state (up t q p); given the number 3"]
 [(Lie-derivative-procedure 3)
  "Lie-derivative-procedure: a Hamiltonian is a function of the state (up t q p); "
  "given the number 3"]
 [((Lie-derivative coordinate) 3)
  "Lie-derivative: a quantity is a function of the state (up t q p); given the number 3"])

;; ---------------------------------------------------------------------------
;; Terms that would swell

(define ((steep a b c d) s)
  (+ (* 1/2 (square (momentum s))) (expt (+ (coordinate s) a b c d) 12)))

(define (characters x) (string-length (format "~a" (expression x))))

(test-case "powers of sums are not multiplied out on the way to high orders"
  (define term (series:ref (((Lie-transform (steep 'a 'b 'c 'd) 'dt) coordinate) line) 6))
  (check-true (< (characters term) 1000))
  (check-true (regexp-match? #rx"expt [(][+] " (format "~a" (expression term)))))

;; With numbers in place of the letters all is a polynomial in q and p, and multiplied out.
(test-case "and have the values that they are to have"
  (define letters (steep 'a 'b 'c 'd))
  (for ([n '(2 3 4 5 6)])
    (define (term H) (series:ref (((Lie-transform H 'dt) coordinate) line) n))
    (check-equal? (substitute (term letters) 'a 1/2 'b -1/3 'c 1 'd -1 'q 1/7 'p 2/5 'dt 1)
                  (substitute (term (steep 1/2 -1/3 1 -1)) 'q 1/7 'p 2/5 'dt 1))))

;; On H = p²/2 the rate of t q is q + t p, and of that 2 p.
(test-case "derivatives along a flow of a function that decides by numbers"
  (define (F (up t q p)) (if (> q 100) 0 (* t q)))
  (define (L n) ((expt (flow-derivative (lambda ((up t q p)) (* 1/2 (square p)))) n) F))
  (check-equal? ((L 1) (up 2 3 5)) 13)
  (check-equal? ((L 2) (up 2 3 5)) 10))
