#lang racket/base
;; Ways to make an expression zero, and whether a question keeps its meaning with them.

(require mechanics/algebra/assumption/assumption-set
         mechanics/algebra/expression/read
         mechanics/algebra/expression/substitute
         mechanics/algebra/simplify/declare-relations
         mechanics/algebra/simplify/simplify-expression
         mechanics/algebra/zero/vanishing-factors
         mechanics/algebra/zero/kept-meaning
         mechanics/algebra/zero/zero-test
         "../../support/checks.rkt")

(define (ways d [variables '()] [relations '()])
  (zero-test-ways (zero-test (datum->expression d)
                             (declare-relations no-assumptions relations)
                             variables)))

;; Is it zero where the equations hold that give symbols, and where sines do?
(define (zero-with? d way)
  (define replaced
    (for/fold ([e (datum->expression d)]) ([q (in-list way)])
      (substitute-expression e (list (cons (datum->expression (cadr q))
                                           (datum->expression (caddr q)))))))
  (eqv? 0 (simplify-expression replaced)))

(define (same? a b) (and (= (length a) (length b)) (andmap same-equations? a b)))

(test-case "a product is zero with any of its factors"
  (check-true (same? (ways '(* c (- k m) (sin b))) '(((= k m)) ((= c 0)) ((= (sin b) 0))))))

(test-case "a sum that moves is zero with all of its coefficients"
  (check-true (same? (ways '(* m (- (* w w x) g)) '(x)) '(((= m 0)) ((= w 0) (= g 0)))))
  (check-true (same? (ways '(+ (* w (- b c) (sin t)) (* k (cos t))) '(t))
                     '(((= b c) (= k 0))))))

(test-case "random sums of products are zero with each of their ways"
  (random-seed 3)
  (define (any . xs) (list-ref xs (random (length xs))))
  (define (parameter) (any 'a 'b 'c 'k 'm '(sin a)))
  (define (factor) (any (parameter) `(- ,(parameter) ,(parameter)) 't
                        `(+ (* ,(parameter) t) (* ,(parameter) (- ,(parameter) 1)))))
  (for ([_ (in-range 100)])
    (define d `(* ,(factor) ,(factor) ,(factor)))
    (for ([way (in-list (ways d '(t)))])
      (check-true (zero-with? d way) (format "~s ~s" d way)))))

(test-case "nothing is told of variables, nor of what has a sign"
  (check-equal? (ways '(* x y) '(x y)) '())
  (check-equal? (ways '(* a b) '() '((> a 0))) '(((= b 0))))
  (check-equal? (ways '(* (exp a) b)) '(((= b 0)))))

(define (keeps? equations #:values [vs '()] #:matrix [rows '()] #:moving [ms '()] . variables)
  (define (read ds) (map datum->expression ds))
  (meaningful? (make-meaning (read vs) (map read rows) (read ms) variables)
               equations no-assumptions))

(test-case "what was asked about has a value"
  (check-false (keeps? '((= R (* -1 r))) #:values '((/ 1 (+ R r)))))
  (check-false (keeps? '((= k (* m w w))) #:values '((/ a (- k (* m (expt w 2)))))))
  (check-false (keeps? '((= a 0)) #:values '((log a))))
  (check-true (keeps? '((= k (* m w w))) #:values '((/ a k))))
  ;; a sine that is 0, or 1, though the angle is not solved for
  (check-false (keeps? '((= (sin a) 0)) #:values '((/ 1 (sin a)))))
  (check-true (keeps? '((= (sin a) 1)) #:values '((/ 1 (sin a))))))

(test-case "the rank of the mass matrix does not fall"
  (check-false (keeps? '((= m 0)) #:matrix '((m 0) (0 M))))
  (check-false (keeps? '((= a b)) #:matrix '((a b) (b a))))
  (check-true (keeps? '((= a b)) #:matrix '((a 1) (1 b))))
  (check-true (keeps? '((= m 0)) #:matrix '((0 0) (0 M)))))

(test-case "what varied varies"
  (check-false (keeps? '((= A 0)) #:moving '((* A (cos t))) 't))
  (check-true (keeps? '((= A 0)) #:moving '((* A (cos t)) (* B t)) 't))
  (check-true (keeps? '((= A 0)) #:moving '(A) 't)))

(test-case "powers and products are solved, and several equations one after the other"
  (check-false (keeps? '((= (expt a 2) (expt b 2))) #:values '((/ 1 (- (* a a) (* b b))))))
  (check-false (keeps? '((= (* G M) (* (expt R 3) (expt n 2))))
                       #:values '((/ 1 (- (* G M) (* n n R R R))))))
  (check-false (keeps? '((= b (* 2 c)) (= d (* b c))) #:values '((/ 1 (- d (* 2 c c))))))
  (check-false (keeps? '((= a 1) (= a 2)))))

(test-case "equations that follow from others are superfluous, and some cannot all hold"
  (check-equal? (independent-equations '((= a b) (= b c) (= a c))) '((= a b) (= b c)))
  (check-false (independent-equations '((= a 1) (= a 2)))))
