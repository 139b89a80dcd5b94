#lang racket/base
;; Roots as products and angles as sums of terms, as certificates write them: with the value of what
;; they were made of, at numbers; and numbers for which hypotheses hold.

(require mechanics/algebra/expression/expression
         mechanics/algebra/expression/read
         mechanics/certificate/Coq-names mechanics/certificate/Coq-term
         mechanics/certificate/example-point
         mechanics/certificate/linear-terms
         mechanics/certificate/root-parts
         mechanics/certificate/theorem-text
         mechanics/value/assumptions
         (only-in mechanics assuming)
         "../support/checks.rkt" "../support/evaluate.rkt")

(define (value-of e x y z)
  (define numbers (hasheq 'x x 'y y 'z z))
  (evaluate-expression e (lambda (leaf _) (hash-ref numbers leaf))))

;; ---------------------------------------------------------------------------
;; Roots

;; -> (list outer roots rest)
(define (parts-of datum)
  (define-values (outer roots rest) (root-parts (datum->expression datum) (assumptions-in-force)))
  (list outer roots rest))

;; At x, y > 0 > z.
(define (check-root datum expected-roots rest?)
  (define u (datum->expression datum))
  (define-values (outer roots rest) (apply values (parts-of datum)))
  (define-values (x y z) (values 0.7 1.3 -0.4))
  (define (root e) (sqrt (value-of e x y z)))
  (check-= (* (value-of outer x y z) (apply * (map root roots)) (if rest (root rest) 1))
           (root u) 1e-12 (format "~s" datum))
  (check-equal? (length roots) expected-roots)
  (check-equal? (and rest #t) rest?))

(test-case "a root is the product of its parts"
  (assuming ('(> x 0) '(< z 0))
    (check-root '(* 4 (expt x 2)) 0 #f)
    (check-root '(* 12 (expt x 3)) 2 #f)
    (check-root '(* -12 (expt x 5) z) 3 #f)
    (check-root '(/ (* 8 y) 3) 2 #t)
    (check-root '(* 18 (expt y 4) x) 2 #f)
    (check-root '(* -1 y z) 1 #t)
    (check-root '(/ (* 2 y (expt z 2)) (expt x 3)) 2 #t)
    (check-root '(+ (expt x 2) (* 2 x y) (expt y 2)) 0 #f)
    (check-root '(- (/ (+ x y) y) 1) 1 #t)
    (check-root '(* 45/49 (expt (+ x y) 3)) 1 #t)))

(test-case "a factor of unknown sign leaves a root as an absolute value"
  (check-equal? (parts-of '(expt y 2)) (list (datum->expression '(abs y)) '() #f))
  (check-equal? (parts-of '(* 9 y)) (list 3 '() 'y))
  (check-equal? (with-handlers ([no-certificate? no-certificate-reason])
                  (parts-of '(* -1 (expt y 2))))
                "a radicand is negative")
  (assuming ('(>= y 0)) (check-equal? (parts-of '(expt y 2)) '(y () #f)))
  (assuming ('(<= y 0))
    (check-equal? (parts-of '(expt y 2)) (list (e:negate 'y) '() #f))))

(test-case "what sign an expression is known to have"
  (define (sign datum) (weak-sign (datum->expression datum) (assumptions-in-force)))
  (assuming ('(> x 0) '(< z 0))
    (check-equal? (map sign '(x (* x x) (* -1 x) z (* x z) y (+ x z) (- x z)))
                  '(1 1 -1 -1 -1 #f #f 1))))

;; ---------------------------------------------------------------------------
;; Sums of terms

(define forms
  '((* 2 x) (+ (* 2 x) (* 1/3 y) x) (- x (* x y)) (* (+ x y) (- x y)) (/ (* 3 x) (* 2 y))
    (/ x (+ x y)) (expt (+ x 1) 3) (* x (expt y -2)) (expt (+ x y) -2) (- (* x y) (* y x)) 5
    (/ (* x y) x) (* (expt x 2) (expt x -2) y)))

(define (sum-of terms)
  (for/fold ([sum 0]) ([t terms]) (e:+ sum (e:* (car t) (monomial->expression (cdr t))))))

(test-case "an expression is the sum of its terms, each monomial once"
  (for ([datum forms])
    (define e (datum->expression datum))
    (define terms (linear-terms e))
    (for ([at '((0.7 1.3 0.4) (-1.7 0.6 2.0))])
      (check-= (apply value-of (sum-of terms) at) (apply value-of e at) 1e-12 (format "~s" datum))
      (check-= (apply value-of (form->expression terms) at) (apply value-of e at) 1e-12))
    (check-equal? (length terms) (length (hash-keys (for/hash ([t terms]) (values (cdr t) #t)))))
    (check-false (memv 0 (map car terms))))
  (check-equal? (linear-terms (datum->expression '(- (* x y) (* y x)))) '())
  (check-equal? (linear-terms (datum->expression '(/ (* x y) x))) '((1 (y . 1)))))

(test-case "a basic form for each monomial, or as few as do"
  (define (form datum) (linear-terms (datum->expression datum)))
  (define sums (map form '((+ (* 2 x) (* 2 y)) (+ (* 3 x) (* 3 y)))))
  (define (count-of separate?) (length (basics-expressions (basic-forms sums 12 separate?))))
  (check-equal? (list (count-of #t) (count-of #f)) '(2 1)))

(test-case "forms are whole multiples of the basic ones"
  (for* ([separate? '(#t #f)] [most '(12 2)])
    (define terms (for/list ([d '((* 2 x) (* 3 x) (+ x (* 1/2 y)) y (* 6 y))])
                    (linear-terms (datum->expression d))))
    (define b (basic-forms terms most separate?))
    (for ([t terms] [multiples (basics-multiples b)])
      (define combined
        (for/fold ([sum 0]) ([m multiples])
          (check-pred exact-integer? (cdr m))
          (e:+ sum (e:* (cdr m) (list-ref (basics-expressions b) (car m))))))
      (check-= (value-of combined 0.7 1.3 0.4) (value-of (form->expression t) 0.7 1.3 0.4) 1e-12))))

;; ---------------------------------------------------------------------------
;; Terms

(test-case "terms as Coq reads them: signs bind like sums, numbers stand before"
  (for ([(datum text)
         (in-hash (hash '(* -1 x) "- x"                   '(* -3 x y) "- 3 * x * y"
                        '(* -1 (+ x y)) "- (x + y)"       '(* -1/2 x) "- 1 / 2 * x"
                        '(- x (* -1 y)) "x - (- y)"       '(+ x (* -2 y)) "x - 2 * y"
                        '(/ x (* y 2)) "x / (2 * y)"      '(expt x -1/2) "1 / sqrt x"
                        '(* :pi x) "PI * x"               '(* 2 :pi x) "2 * PI * x"))])
    (check-equal? (term (datum->expression datum) (make-names '(x y))) text)))

;; ---------------------------------------------------------------------------
;; Examples

(define (holds? relation x y)
  (define (side datum) (value-of (datum->expression datum) x y 0))
  (define-values (a b) (values (side (cadr relation)) (side (caddr relation))))
  (case (car relation)
    [(<>) (not (= a b))]
    [(=) (< (abs (- a b)) 1e-9)]
    [else ((case (car relation) [(>) >] [(>=) >=] [(<) <] [(<=) <=]) a b)]))

(test-case "of a domain only what is not given yet is asked for, in whatever words it is given"
  (define size (datum->expression '(abs x)))
  (check-equal? (relations-beyond '((<> x 0) (> y 0))
                                  (list '(<> x 0) '(<> y 0) (list '> size 0) '(<> z 0)))
                '((<> z 0))))

(test-case "an example of hypotheses fulfils them all"
  (for ([hypotheses '(((> x 2)) ((< x 0) (> y x)) ((<> (* x y) 0) (>= x y))
                      ((< (sin x) 0)) ((>= (cos x) 1/2) (<> x 1)) ((> (* x y) 3) (<= (+ x y) 5))
                      ((= (* x y) 1) (<> x y)) ((> x 0) (< x 1/2)) ((<= y 0) (>= y 0) (<> x y))
                      ((= x (* -1 y)) (> x 0)))])
    (define relations
      (for/list ([h hypotheses]) (cons (car h) (map datum->expression (cdr h)))))
    (define found (example-values relations (make-names '(x y))))
    (define (number name) (cdr (assoc name found)))
    (for ([h hypotheses])
      (check-true (holds? h (number 'x) (number 'y)) (format "~s ~s" h found))))
  (define three (example-values '((> x 2) (> y 2) (> z 2)) (make-names '(x y z))))
  (for ([name '(x y z)]) (check-true (> (cdr (assoc name three)) 2)))
  (check-pred no-certificate?
              (with-handlers ([no-certificate? values])
                (example-values (list (list '> 'x 2) (list '< 'x 1)) (make-names '(x))))))
