#lang racket/base
;; Signatures of literal functions: every form, quoted or not.

(require mechanics/generic/up-down
         mechanics/value/signature
         mechanics/calculus/dual
         "../support/checks.rkt")

(define (domain d) (map shape->datum (signature-domain (parse-signature d))))
(define (range d) (shape->datum (signature-range (parse-signature d))))

(test-case "a signature unquoted is the datum it is quoted"
  (check-equal? (-> Real Real) '(-> Real Real))
  (check-equal? (-> (UP Real (UP* Real 2) (DOWN* Real 2)) (DOWN Real Real))
                '(-> (UP Real (UP* Real 2) (DOWN* Real 2)) (DOWN Real Real)))
  (check-equal? (-> (X Real (X* Real 2) Any) Real) '(-> (X Real (X* Real 2) Any) Real))
  (check-equal? (-> (DOWN Real (UP Real)) Real) '(-> (DOWN Real (UP Real)) Real)))

(test-case "domains: one shape, or several of a product"
  (check-equal? (domain '(-> Real Real)) '(Real))
  (check-equal? (domain '(-> (X Real (UP Real Real)) Real)) '(Real (UP Real Real)))
  (check-equal? (domain '(-> (X* Real 3) Real)) '(Real Real Real))
  (check-equal? (domain '(-> (UP* Real 3) Real)) '((UP Real Real Real)))
  (check-equal? (domain '(-> (DOWN* (UP Real Real) 2) Real))
                '((DOWN (UP Real Real) (UP Real Real))))
  (check-equal? (domain '(-> (UP Real (X Real Real)) Real)) '((UP Real (UP Real Real)))))

(test-case "ranges may be structures"
  (check-equal? (range '(-> Real (UP Real (DOWN* Real 2)))) '(UP Real (DOWN Real Real)))
  (check-equal? (range '(-> Real Any)) 'Any))

(test-case "Lagrangian and Hamiltonian make the signatures of the book"
  (check-equal? (Lagrangian) '(-> (UP Real (UP* Real) (UP* Real)) Real))
  (check-equal? (Hamiltonian) '(-> (UP Real (UP* Real) (DOWN* Real)) Real))
  (check-equal? (Lagrangian 1) '(-> (UP Real Real Real) Real))
  (check-equal? (Lagrangian 2) '(-> (UP Real (UP* Real 2) (UP* Real 2)) Real))
  (check-equal? (Hamiltonian 2) '(-> (UP Real (UP* Real 2) (DOWN* Real 2)) Real)))

(test-case "a count may be left open"
  (define (fits? d x)
    (define-values (slot shape) (first-misfit (parse-signature d) x))
    (not slot))
  (define tuples '(-> (UP* Real) Real))
  (check-equal? (range '(-> Real (^ Real 2))) '(UP Real Real))
  (check-equal? (domain '(-> (^ Real 3) Real)) '(Real Real Real))
  (check-equal? (domain tuples) '((UP* Real)))
  (check-true (fits? tuples (list (up 1 2))))
  (check-true (fits? tuples (list (up 1 2 3))))
  (check-true (fits? tuples (list 1)))
  (check-false (fits? tuples (list (down 1 2))))
  (check-false (fits? tuples (list (up))))
  (check-false (fits? tuples (list (up 1 (up 2 3)))))
  (check-true (fits? '(-> (DOWN* (UP Real Real)) Real) (list (down (up 1 2) (up 3 4)))))
  (check-true (fits? '(-> (X* Real) Real) '(1 2 3)))
  (check-false (fits? '(-> (X* Real) Real) (list 1 (up 2 3)))))

(test-case "open counts in one tuple are the same"
  (define L (parse-signature (Lagrangian)))
  (define (fits? x)
    (define-values (slot shape) (first-misfit L (list x)))
    (not slot))
  (check-true (fits? (up 't 'q 'v)))
  (check-true (fits? (up 't (up 'x 'y) (up 'u 'v))))
  (check-false (fits? (up 't (up 'x 'y) (up 'u 'v 'w))))
  (check-false (fits? (up 't (up 'x 'y) 'v)))
  (check-false (fits? (up 't (up 'x) 'v))))

(test-case "a signature says how many arguments it takes"
  (define (mask d) (signature-arity-mask (parse-signature d)))
  (check-equal? (mask '(-> Real Real)) 2)
  (check-equal? (mask '(-> (X Real Real) Real)) 4)
  (check-equal? (mask '(-> (X* Real) Real)) -2))

(test-case "a range needs its counts"
  (check-exn #rx"^literal-function: the range needs a count, as in [(]-> Real [(]UP[*] Real 2[)][)]"
             (lambda () (parse-signature '(-> Real (UP Real (DOWN* Real)))))))

(test-case "what is no signature is refused with an example"
  (for ([d (list 'Real '(Real Real) '(-> Real) '(-> Real Real Real) 3 "(-> Real Real)" '())])
    (check-exn
     #rx"^literal-function: a signature has the form [(]-> domain range[)], as in [(]-> [(]X Real Real[)] Real[)]"
     (lambda () (parse-signature d)))))

(test-case "what is no shape is refused with the forms there are"
  (for ([d '((-> Reel Real) (-> (UP Real 3) Real) (-> (UP*) Real) (-> (UP* Real x) Real)
             (-> (^ Real) Real) (-> (UP* Real 1 2) Real)
             (-> (LEFT Real) Real) (-> (UP* Real -1) Real) (-> (X* Real 1.5) Real))])
    (check-exn #rx"^literal-function: expected Real, [(]UP shape [.][.][.][)]"
               (lambda () (parse-signature d)))))

(test-case "values fit shapes by orientation, length and depth"
  (define (fits? d x) (shape-fits? (car (signature-domain (parse-signature (-> d Real)))) x))
  (for ([x (list 1 2.5 'a +i (make-dual 1 'x 1))]) (check-true (fits? 'Real x)))
  (for ([x (list (up 1) "1" #t sin '(1) (void) #\1)]) (check-false (fits? 'Real x)))
  (check-true (fits? '(UP Real (DOWN Real Real)) (up 1 (down 'a 'b))))
  (check-true (fits? '(UP Real Real) (vector 1 'a)))
  (check-false (fits? '(UP Real Real) (down 1 2)))
  (check-false (fits? '(UP Real Real) (up 1 2 3)))
  (check-false (fits? '(UP Real Real) (up 1 (up 2))))
  (check-false (fits? '(UP Real Real) 1))
  (check-true (fits? 'Any (up 1 2)))
  (check-true (fits? '(UP Real Any) (up 1 (down 2 3)))))
