#lang racket/base
;; Operators: algebra, printing, commutators.

(require mechanics/generic/arithmetic
         mechanics/generic/elementary
         mechanics/generic/up-down
         mechanics/value/compose
         mechanics/value/operator
         mechanics/calculus/derivative
         mechanics/calculus/literal-function
         mechanics/value/series/series-access
         mechanics/value/signature
         "../support/checks.rkt" "../support/same.rkt")

(define V (literal-function 'V))
(define F (literal-function 'F (-> (X Real Real) Real)))
(define x identity)

;; ---------------------------------------------------------------------------
;; Algebra

(test-case "(D + 1)(D - 1) is D² - 1"
  (check-true (same? (g:* (g:+ D 1) (g:- D 1)) (g:- (g:expt D 2) 1)))
  (check-true (same? (g:* (g:+ D I-operator) (g:- D I-operator)) (g:- (g:square D) 1))))

(test-case "the square of an operator is its second power"
  (check-true (same? (g:square D) (g:expt D 2)))
  (check-equal? (((g:square D) V) 't) (((g:expt D 2) V) 't))
  (check-true (same? (g:cube D) (g:expt D 3))))

(test-case "a number is that multiple of the identity, a function is multiplication by it"
  (check-true (same? ((g:* 3 D) V) (g:* 3 (D V))))
  (check-true (same? ((g:+ D 3) V) (g:+ (D V) (g:* 3 V))))
  (check-true (same? ((g:* x D) V) (g:* x (D V))))
  (check-true (same? ((g:* D x) V) (D (g:* x V)))))

(test-case "an operator times a tuple multiplies by the tuple first"
  (check-true (same? ((g:* D (up 1 x)) V) (D (g:* (up 1 x) V))))
  (check-true (same? ((g:* (down 1 'a) D) V) (g:* (down 1 'a) (D V)))))

(test-case "D and x do not commute: [D, x] = 1"
  (check-true (same? (commutator D x) I-operator))
  (check-true (same? (commutator D (g:square x)) (g:* 2 x)))
  (check-true (same? (commutator (g:expt D 2) x) (g:* 2 D)))
  (check-true (same? (commutator D D) 0))
  (check-true (same? (anticommutator D x) (g:+ (g:* 2 (g:* x D)) 1))))

(test-case "commutators are antisymmetric and obey the Jacobi identity"
  (define A D)
  (define B (g:* g:sin D))
  (define C (g:* x (g:expt D 2)))
  (check-true (same? (commutator A B) (g:negate (commutator B A))))
  (check-true (same? (g:+ (commutator A (commutator B C))
                          (commutator B (commutator C A))
                          (commutator C (commutator A B)))
                     0)))

(test-case "partial derivatives commute as operators"
  (define c (commutator (partial 0) (partial 1)))
  (check-true (same? ((c F) 'x 'y) 0)))

(test-case "operators act on tuples of functions"
  (check-true (same? ((D (up V g:sin)) 't) (up ((D V) 't) (g:cos 't))))
  (check-true (same? (((g:expt D 2) (up V g:sin)) 't)
                     (up (((g:expt D 2) V) 't) (g:negate (g:sin 't))))))

;; ---------------------------------------------------------------------------
;; Making and printing

(test-case "an operator made of a procedure acts like it and prints by its name"
  (define shift (make-operator (lambda (f) (lambda (t) (f (g:+ t 1)))) 'shift))
  (check-pred operator? shift)
  (check-equal? ((shift V) 't) (V (g:+ 't 1)))
  (check-equal? (((g:- shift 1) g:square) 3) 7)
  (check-equal? (((g:expt shift 3) V) 0) (V 3))
  (check-equal? (format "~a" shift) "shift")
  (check-equal? (format "~a" (shift V)) "(shift V)")
  (check-equal? (format "~a" (make-operator (lambda (f) f) (list 'Lie V))) "(Lie V)"))

(test-case "operators print as what was typed, in all three modes"
  (for ([o (list D (g:expt D 2) (g:* D D) (g:* 2 D) (g:+ D 1) (g:- D V) (g:/ D 2)
                 (partial 1) (partial 1 0) (g:square (partial 2)) I-operator
                 (g:* (g:+ D 1) (g:- D 1)) (commutator D V))]
        [text '("D" "(expt D 2)" "(expt D 2)" "(* 2 D)" "(+ D 1)" "(- D V)" "(* 1/2 D)"
                "(partial 1)" "(partial 1 0)" "(expt (partial 2) 2)" "I"
                "(* (+ D 1) (- D 1))" "(- (* D V) (* V D))")])
    (check-equal? (format "~a" o) text)
    (check-equal? (format "~s" o) text)
    (check-equal? (format "~v" o) text)))

(test-case "what an operator makes of a function prints as that"
  (check-equal? (format "~a" (D V)) "(D V)")
  (check-equal? (format "~a" ((g:expt D 2) V)) "((expt D 2) V)")
  (check-equal? (format "~a" ((g:* (g:+ D 1) (partial 0)) F)) "((* (+ D 1) (partial 0)) F)")
  (check-equal? (format "~a" (D (g:* 2 V))) "(D (* 2 V))"))

(test-case "an elementary function of an operator is refused by name, but for exp"
  (for ([f (list g:sin g:sqrt g:abs g:log)])
    (check-exn #rx"cannot be taken of an operator" (lambda () (f D))))
  (check-pred operator? (g:exp D)))

(test-case "an operator has no powers but 0, 1, 2, ..."
  (for ([n (list -1 1/2 'n 0.5)])
    (check-exn
     #rx"^expt: cannot raise an operator to the power of .*\n  the powers of an operator are 0, 1, 2, ...$"
     (lambda () (g:expt D n))))
  (check-eq? (g:expt D 0) I-operator)
  (check-eq? (g:expt D 1) D))

(test-case "multiples of an operator know its powers"
  (define hD (g:* 'h D))
  (check-equal? (format "~a" (g:expt hD 3)) "(expt (* h D) 3)")
  (check-true (same? (g:expt hD 3) (g:* (g:expt 'h 3) (g:expt D 3))))
  (check-true (same? (g:expt (g:* 2 (g:expt hD 2)) 2) (g:* 4 (g:expt 'h 4) (g:expt D 4))))
  (check-true (same? (g:expt (g:* x D) 2) (g:+ (g:* x D) (g:* (g:square x) (g:expt D 2))))))

(test-case "exp(hD) shifts 1/(1 - x) by h: thirty powers of D without a nest of derivatives"
  (define (f x) (g:/ 1 (g:- 1 x)))
  (check-equal? (series:head (((g:exp (g:* 2 D)) f) 0) 30)
                (for/list ([k 30]) (expt 2 k))))
