#lang racket/base
;; Assumptions in the algebra: what follows from declared relations, what
;; simplification makes of it, and what it says it rests on.

(require mechanics/algebra/assumption/assumption-set
         mechanics/algebra/simplify/declare-relations
         mechanics/algebra/expression/expression
         mechanics/algebra/assumption/relation
         mechanics/algebra/simplify/simplify-expression
         mechanics/algebra/expression/read
         "../../support/checks.rkt")

(define (sort-data ds) (sort ds string<? #:key (lambda (d) (format "~s" d))))

(define (declare . relations)
  (define data
    (apply append (for/list ([r (in-list relations)]) (split-relation r))))
  (declare-relations no-assumptions data))

(define (careful A) (with-automatic-assumptions A #f))

;; -> the simplified datum, and the grounds
(define (under A d)
  (define-values (e grounds) (simplify-expression/assumptions (datum->expression d) A))
  (values (expression->datum e) grounds))

;; Each: what is declared, what is simplified, to what, resting on what.
(define-syntax-rule (check-under [(relation ...) before after (ground ...)] ...)
  (begin
    (let-values ([(d grounds) (under (declare 'relation ...) 'before)])
      (check-equal? d 'after)
      (check-equal? (sort-data grounds) (sort-data '(ground ...))))
    ...))

;; ---------------------------------------------------------------------------
;; Signs

(test-case "a root of a square takes the declared sign"
  (check-under
   [((>= x 0)) (sqrt (expt x 2)) x ((>= x 0))]
   [((> x 0)) (sqrt (expt x 2)) x ((> x 0))]
   [((< x 0)) (sqrt (expt x 2)) (* -1 x) ((< x 0))]
   [((<= x 0)) (sqrt (expt x 2)) (* -1 x) ((<= x 0))]
   [((< x 0)) (expt (expt x 2) 3/2) (* -1 (expt x 3)) ((< x 0))]
   [((< x 0)) (sqrt (* m (expt x 2))) (* -1 x (sqrt m)) ((< x 0))]
   [((< ((D q) t) 0)) (sqrt (expt ((D q) t) 2)) (* -1 ((D q) t)) ((< ((D q) t) 0))]))

(test-case "signs go through products, quotients and powers"
  (check-under
   [((> r 0) (> k 0)) (sqrt (/ (* (expt r 2) (expt m 4)) (expt k 2)))
    (/ (* (expt m 2) r) k) ((> r 0) (> k 0))]
   [((< x 0) (< y 0)) (abs (* x y)) (* x y) ((< x 0) (< y 0))]
   [((< x 0)) (abs (expt x 3)) (* -1 (expt x 3)) ((< x 0))]
   [((> k 0)) (abs (/ x k)) (/ (abs x) k) ((> k 0))]
   [((>= x 0)) (abs (sqrt x)) (sqrt x) ((>= x 0))]))

(test-case "sums of what is not negative are not"
  (check-under
   [() (abs (+ 1 (expt x 2))) (+ 1 (expt x 2)) ()]
   [() (sqrt (expt (exp x) 2)) (exp x) ()]
   [() (abs (+ (cosh u) (expt v 2))) (+ (expt v 2) (cosh u)) ()]
   [((>= a 0) (< b 0)) (abs (- a b)) (- a b) ((>= a 0) (< b 0))]))

(test-case "a relation may be between compound expressions"
  (check-under
   [((> (- a b) 0)) (sqrt (expt (- a b) 2)) (- a b) ((> (- a b) 0))]
   [((> a b)) (sqrt (expt (- b a) 2)) (- a b) ((> a b))]
   [((>= (sin theta) 0)) (sqrt (- 1 (expt (cos theta) 2))) (sin theta) ((>= (sin theta) 0))]
   [((<= (sin theta) 0)) (sqrt (- 1 (expt (cos theta) 2))) (* -1 (sin theta)) ((<= (sin theta) 0))]
   [((> a b c)) (abs (- a c)) (- a c) ((> a b) (> b c))]
   [((positive a b)) (abs (+ a b)) (+ a b) ((> a 0) (> b 0))]))

(test-case "what follows for the parts of a relation is known"
  (check-under
   [((> (* m r) 0) (> m 0)) (sqrt (expt r 2)) r ((> (* m r) 0) (> m 0))]
   [((> c v) (> v 0)) (sqrt (expt c 2)) c ((> c v) (> v 0))]
   [((> x 1)) (abs x) x ((> x 1))]
   [((> x 2)) (abs (- x 1)) (- x 1) ((> x 2))]
   [((< 0 e 1)) (abs (- 1 (expt e 2))) (- 1 (expt e 2)) ((< 0 e) (< e 1))]
   [((< (* x y) 0)) (abs (* x y)) (* -1 x y) ((< (* x y) 0))]))

(test-case "relations are known by what their expressions simplify to under the others"
  (check-under
   [((> (sqrt (expt x 2)) 1) (> x 0)) (abs (- x 1)) (- x 1) ((> (sqrt (expt x 2)) 1))]))

;; ---------------------------------------------------------------------------
;; Rules that need signs

(test-case "logarithms are split by the declared signs"
  (check-under
   [((> x 0)) (log (expt x 2)) (* 2 (log x)) ((> x 0))]
   [((< x 0)) (log (expt x 2)) (* 2 (log (* -1 x))) ((< x 0))]
   [((> x 0) (> y 0)) (- (log (* x y)) (log x)) (log y) ((> x 0) (> y 0))]
   [((< x 0) (< y 0)) (- (log (* x y)) (log (* -1 x))) (log (* -1 y)) ((< x 0) (< y 0))]))

(test-case "powers of powers and products of roots use what is declared"
  (check-under
   [((> x 0)) (expt (expt x a) b) (expt x (* a b)) ((> x 0))]
   [((> x 0)) (expt (expt x 2) a) (expt x (* 2 a)) ((> x 0))]
   [() (log (expt x a)) (* a (log x)) ((>= x 0))]
   [((> x 0) (> y 0)) (- (sqrt (* x y)) (* (sqrt x) (sqrt y))) 0 ((> x 0) (> y 0))]
   [((< x 0) (< y 0)) (+ (sqrt (* x y)) (* (sqrt x) (sqrt y))) 0 ((< x 0) (< y 0))]
   [((> x 0)) (- (sqrt (* x y)) (* (sqrt x) (sqrt y))) 0 ((> x 0))]))

(test-case "an odd root of what is negative keeps its branch"
  (check-under
   [((> x 0)) (expt (expt x 3) 1/3) x ((> x 0))]
   [((< x 0)) (expt (* m (expt x 3)) 1/3) (* -1 x (expt (* -1 m) 1/3)) ((< x 0))]
   [((> y 0)) (expt (* (expt x 19) (expt y 3)) 1/9) (* (expt x 19/9) (expt y 1/3)) ((> y 0))]))

(test-case "roots that depend on each other need the signs of all that occurs in them"
  (define-values (e grounds)
    (under no-assumptions '(- (sqrt (* x z)) (* (sqrt (/ x y)) (sqrt (* y z))))))
  (check-equal? e 0)
  (check-not-false (member '(>= y 0) grounds)))

;; ---------------------------------------------------------------------------
;; Assuming by itself, or not

(test-case "an assumption made in one place counts in all others"
  (check-under
   [() (- (sqrt (expt x 2)) (abs x)) 0 ((>= x 0))]
   [() (- (abs x) (sqrt (expt x 2))) 0 ((>= x 0))]
   [() (+ (log (expt x 2)) (sqrt (expt x 2))) (+ x (* 2 (log x))) ((>= x 0))]
   [() (abs x) (abs x) ()]))

(test-case "where nothing may be assumed absolute values remain"
  (define-syntax-rule (check-careful [(relation ...) before after] ...)
    (begin
      (let-values ([(d grounds) (under (careful (declare 'relation ...)) 'before)])
        (check-equal? d 'after)
        (check-equal? grounds '(relation ...)))
      ...))
  (check-careful
   [() (sqrt (expt x 2)) (abs x)]
   [() (- (sqrt (expt x 2)) (abs x)) 0]
   [() (expt (expt x 2) 3/2) (* (expt x 2) (abs x))]
   [() (sqrt (* m (expt x 2))) (* (abs x) (sqrt m))]
   [() (- (/ 1 (sqrt (expt x 2))) (/ 1 (abs x))) 0]
   [() (sqrt (expt x 4)) (expt x 2)]
   [() (expt (expt x 3) 1/3) x]
   [() (expt (expt x 9) 1/3) (expt x 3)]
   [() (log (expt x 2)) (log (expt x 2))]
   [() (- (log (expt x 2)) (* 2 (log (abs x)))) 0]
   [() (expt (expt x a) b) (expt (expt x a) b)]
   [() (- (sqrt (* x y)) (* (sqrt x) (sqrt y))) 0]
   [((> (* x y) 0)) (sqrt (* (expt x 2) (expt y 2))) (* x y)]
   [((< (* x y) 0)) (sqrt (* (expt x 2) (expt y 2))) (* -1 x y)]
   [((> y 0)) (sqrt (* (expt x 2) (expt y 2))) (* y (abs x))]))

;; ---------------------------------------------------------------------------
;; Sets

(test-case "contradictions are found, with the relations they are between"
  (define-syntax-rule (check-contradictory [relation ...] ...)
    (begin
      (check-equal? (with-handlers ([exn:algebra:contradiction?
                                     (lambda (x)
                                       (sort-data (exn:algebra:contradiction-because x)))])
                      (declare 'relation ...)
                      'none)
                    (sort-data '(relation ...)))
      ...))
  (check-contradictory
   [(> x 0) (< x 0)]
   [(>= x 1) (<= x 0)]
   [(< (exp x) 0)]
   [(< (expt x 2) 0)]
   [(> 1 2)]
   [(> a b) (> b c) (> c a)]
   [(> (* x y) 0) (> x 0) (< y 0)]))

(test-case "what is no contradiction is accepted"
  (check-equal? (declared-relations (declare '(>= x 0) '(<= x 0) '(> x -1) '(>= x x)))
                '((>= x 0) (<= x 0) (> x -1) (>= x x))))

(test-case "the order of relations makes no difference"
  (define relations '((> (* m r) 0) (> m 0) (> c v) (> v m) (< x 0)))
  (for ([d (in-list '((sqrt (expt (* c r x) 2)) (abs (- c m)) (log (* (expt r 2) (expt c 2)))))])
    (define-values (e grounds) (under (apply declare relations) d))
    (for ([order (in-list (list (reverse relations)
                                (append (cddr relations) '((> m 0) (> (* m r) 0)))))])
      (define-values (f other-grounds) (under (apply declare order) d))
      (check-equal? f e)
      (check-equal? (sort-data other-grounds) (sort-data grounds)))))

(test-case "declaring makes a new set and leaves the old one alone"
  (define A (declare '(> x 0)))
  (define B (declare-relations A '((> y 0))))
  (check-equal? (declared-relations A) '((> x 0)))
  (check-equal? (declared-relations B) '((> x 0) (> y 0)))
  (check-equal? (declared-relations (without-relations B '((> x 0)))) '((> y 0)))
  (define-values (e grounds) (under (without-relations B '((> x 0))) '(abs x)))
  (check-equal? e '(abs x)))

(test-case "what follows from a relation goes with it"
  (define A (without-relations (declare '(> (* m r) 0) '(> m 0)) '((> m 0))))
  (define-values (e grounds) (under A '(abs r)))
  (check-equal? e '(abs r)))

(test-case "what no real number satisfies contradicts itself"
  (for ([d '((> (cos x) 2) (< (exp x) 0) (> (atan x) 2) (< (+ 1 (expt x 2)) 0)
             (>= (* (sin x) (cos y)) 3/2))])
    (check-exn exn:algebra:contradiction?
               (lambda () (declare-relations no-assumptions (list d)))
               (format "~s" d)))
  (check-not-exn (lambda () (declare-relations no-assumptions '((> (cos x) 1/2))))))
