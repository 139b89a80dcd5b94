#lang racket/base
;; The list of mutants: wrong laws, wrong signs, forgotten conditions.

(require "mutate.rkt")

(provide mutants)

(define-syntax-rule (define-mutants id [name file old new] ...)
  (define id (list (mutant name file old new) ...)))

(define-mutants mutants
  ;; relations between kernels
  ["sin² + cos² = 2" "field/field-extension.rkt"
   "(if (eqv? (circle-sign o) 1) (poly- R one cosine²) (poly- R cosine² one))"
   "(if (eqv? (circle-sign o) 1) (poly- R (poly-constant R 2) cosine²) (poly- R cosine² one))"]
  ["cosh² + sinh² = 1" "field/field-extension.rkt"
   "(if (eqv? (circle-sign o) 1) (poly- R one cosine²) (poly- R cosine² one))"
   "(poly- R one cosine²)"]
  ["the relation of an absolute value is |u|² = u" "field/field-extension.rkt"
   "(reduce-fraction F square)"
   "(reduce-fraction F u)"]
  ["what is left of a reduced power is all of it" "field/field.rkt"
   "(make-slice (remainder (slice-degree s) q) (slice-coefficient s))"
   "(make-slice (slice-degree s) (slice-coefficient s))"]
  ["a relation is applied to quotients of powers only" "field/field.rkt"
   "(fraction-expt R (relation-radicand r) j)"
   "(relation-radicand r)"]
  ;; angles
  ["cos(a + b) = cos a cos b + sin a sin b" "field/expression-value.rkt"
   "(constant F sign) (product (cdr t) (cdr u))"
   "(constant F (- sign)) (product (cdr t) (cdr u))"]
  ["sin(a + b) = sin a cos b + sin a sin b" "field/expression-value.rkt"
   "(field-sum F (product (cdr t) (car u)) (product (car t) (cdr u)))"
   "(field-sum F (product (cdr t) (car u)) (product (cdr t) (cdr u)))"]
  ["sin(-a) = sin a" "field/expression-value.rkt"
   "(if (negative? n) (field-product F (constant F -1) sine) sine)"
   "sine"]
  ["tan = cos / sin" "field/expression-value.rkt"
   "[else (field-quotient (walk-field w) (cdr t) (car t))]"
   "[else (field-quotient (walk-field w) (car t) (cdr t))]"]
  ["cos(asin u) = 1 - u²" "kernel/angles.rkt"
   "(values u (root (e:- 1 (square u))))"
   "(values u (e:- 1 (square u)))"]
  ["atan(y, x) = atan(x, y)" "kernel/angles.rkt"
   "(values (e:/ u r) (e:/ x r))"
   "(values (e:/ x r) (e:/ u r))"]
  ["cos(a - b) is taken for cos(a + b)" "presentation/contract.rkt"
   "(if cosine? (- alike) alike)"
   "alike"]
  ["a lattice with a coordinate wrong" "kernel/integer-lattice.rkt"
   "(cons position (* d (coordinate v k)))"
   "(cons position (abs (* d (coordinate v k))))"]
  ;; sines and cosines shown
  ["1 - cos² = -sin²" "presentation/sine-or-cosine.rkt"
   "(define without-sines (merge R p cosine sine -1 sign))"
   "(define without-sines (merge R p cosine sine -1 (- sign)))"]
  ;; exponentials, logarithms, absolute values
  ["e^(k log b) = b^(-k)" "kernel/exponentials.rkt"
   "(exact-exponent (car t))))"
   "(- (exact-exponent (car t)))))"]
  ["sinh = cosh" "kernel/exponentials.rkt"
   "(define sine (e:* 1/2 (e:- up down)))"
   "(define sine (e:* 1/2 (e:+ up down)))"]
  ["products of exponentials forget their exponents" "kernel/exponentials.rkt"
   "(cons (cdr p) (exponential-exponent (kernel-relation (car p))))"
   "(cons 1 (exponential-exponent (kernel-relation (car p))))"]
  ["log xy = log x - log y" "kernel/logarithms.rkt"
   "(rebuild op:+ (for/list ([p (in-list parts)]) (e:* (car p) (part-logarithm c (cdr p)))))"
   "(for/fold ([sum 0]) ([p (in-list parts)]) (e:- sum (e:* (car p) (part-logarithm c (cdr p)))))"]
  ["log √u = 2 log u" "kernel/logarithms.rkt"
   "(values (car (node-args f)) 1/2)"
   "(values (car (node-args f)) 2)"]
  ["signs are taken for granted in silence" "assumption/ledger.rkt"
   "(note! l (relation-datum r))"
   "(void)"]
  ["|xy| = x |y|" "kernel/logarithms.rkt"
   "(define sign (if (even? e) 1 "
   "(define sign (if (or (symbol? f) (even? e)) 1 "]
  ["|-3 x| = -3 |x|" "kernel/logarithms.rkt"
   "(for/fold ([product (abs number)])"
   "(for/fold ([product number])"]
  ;; roots
  ["√(u²) = -u" "simplify/radicand.rkt"
   "(values (e:* joint
                  (e:* nested"
   "(values (e:* -1
                  (e:* nested"]
  ["a root of a product leaves with the wrong sign" "simplify/radicand.rkt"
   "(if sign (values sign group others) (values 1 '() factors))"
   "(if sign (values 1 group others) (values 1 '() factors))"]
  ["the domain of a root is where it is not real" "assumption/domain.rkt"
   "[(eq? head op:sqrt) (need nonnegative u)]"
   "[(eq? head op:sqrt) (need nonpositive u)]"]
  ["the sign of what may be 0 is strict" "assumption/ledger.rkt"
   "(cond [(signs-within? signs positive) 1]"
   "(cond [(signs-within? signs nonnegative) 1]"]
  ["a sign that is looked up is the other" "assumption/reference-point.rkt"
   "[(> x distinct) 1]"
   "[(> x distinct) -1]"]
  ["a sine is less than one half" "assumption/interval.rkt"
   "(define unit (interval -1 1))"
   "(define unit (interval -1/2 1/2))"]
  ["a box that is not looked at is empty" "assumption/emptiness.rkt"
   "[(or (eqv? left 0) (null? relations)) #f]"
   "[(or (eqv? left 0) (null? relations)) #t]"]
  ["a condition may leave the mass matrix singular" "zero/kept-meaning.rkt"
   "(= (rank (meaning-matrix n) after) (rank (meaning-matrix m) before))"
   "#t"]
  ["of several equations that must hold one is enough" "zero/vanishing-factors.rkt"
   "(in-list (apply cartesian-product options))"
   "(map list (append* options))"]
  ["what is nowhere defined is proved" "zero/existence.rkt"
   "(not (symbol? (value t number precision))))"
   "#t)"]
  ["a decimal is read at a distance" "zero/decimal-readings.rkt"
   "(define unit (expt 2 -52))"
   "(define unit (expt 2 -40))"]
  ["√(x³) = x √(x²)" "simplify/radicand.rkt"
   "(define e (- (cdr part) (cdr (whole-part part))))"
   "(define e (cdr part))"]
  ["√6 = √2 √3 √5" "polynomial/fraction.rkt"
   "(fraction-scale R (expt b e) product)"
   "(fraction-scale R (expt (abs b) (+ e 1)) product)"]
  ["a norm is to the first power" "field/rationalize.rkt"
   "(fraction-expt R norm e)"
   "norm"]
  ["a conjugate is multiplied below only" "field/rationalize.rkt"
   "(fraction* R (above) (reduce-fraction F (fraction-expt R (from c) e)))"
   "(above)"]
  ;; presentation
  ["x √x = √x" "presentation/form.rkt"
   "(+ (cdr p) (* (root-degree r) (cdr x)))"
   "(cdr p)"]
  ["a content loses its sign" "presentation/term.rkt"
   "(values signed powers"
   "(values c powers"]
  ["a denominator's sign is dropped" "presentation/present.rkt"
   "(expt (* (if flip? -1 1) (term-coefficient below))"
   "(expt (* 1 (term-coefficient below))"]
  ["a radicand comes back with the wrong power" "presentation/fraction-pieces.rkt"
   "(* k (base-degree b))"
   "(* k (+ 1 (base-degree b)))"]
  ["squares of sums have a wrong middle sign" "presentation/squares-of-sums.rkt"
   "(cons (term (* sign ratio) (term-powers new))"
   "(cons (term ratio (term-powers new))"]
  ;; polynomials and fractions
  ["a product adds where it should multiply" "polynomial/arithmetic.rkt"
   "(cons (make-term (leading-monomial p) (* c (leading-coefficient p))) (scale c (cdr p)))"
   "(cons (make-term (leading-monomial p) (+ c (leading-coefficient p))) (scale c (cdr p)))"]
  ["cancelling divides the numerator alone" "polynomial/fraction.rkt"
   "(define others (basis-insert R + '() (poly-divide R h d) e))"
   "(define others (basis-insert R + '() h e))"]
  ["cancelled factors are forgotten" "polynomial/fraction.rkt"
   "(values p* (append rest kept))"
   "(values p* kept)"]
  ["a fraction is inverted without its content" "polynomial/fraction.rkt"
   "(expand R (poly-constant R (/ 1 content)) (fraction-denominator-factors f))"
   "(expand R (poly-constant R 1) (fraction-denominator-factors f))"]
  ["what divides nothing is a gcd" "polynomial/gcd.rkt"
   "[(null? kept) (poly-constant R 1)]"
   "[(null? kept) p]"]
  ["division adds what it should subtract" "polynomial/division.rkt"
   "(shift-terms n (- d) (cdr q))"
   "(shift-terms n d (cdr q))"]
  ["the square-free parts drop a factor" "polynomial/square-free.rkt"
   "(if (poly-constant? f) rest (cons (make-power f i) rest))"
   "(if (poly-constant? f) rest (cons (make-power f 1) rest))"]
  ["a basis forgets an exponent" "polynomial/coprime-basis.rkt"
   "(basis-insert R add others d (add k e))"
   "(basis-insert R add others d k)"]
  ;; fingerprints and verdicts
  ["the fingerprint of a difference is that of a sum" "zero/residues.rkt"
   "(mod- (one) (two) p)"
   "(mod+ (one) (two) p)"]
  ["the fingerprint of the circle is off it" "zero/residues.rkt"
   "(mod* (mod* 2 t p) inverse p)"
   "(mod* t inverse p)"]
  ["fingerprints take derivatives for their functions" "zero/fingerprint.rkt"
   "(cons (literal-head-name head) (literal-head-index head))"
   "(literal-head-name head)"]
  ["a fingerprint looks at one residue and calls it zero" "zero/fingerprint.rkt"
   "[(eqv? value 0) (loop (+ chain 1))]"
   "[(even? value) (loop (+ chain 1))]"]
  ["whatever has a witness is proved" "zero/zero-test.rkt"
   "(cond [witness (make-zero-test 'refuted "
   "(cond [witness (make-zero-test 'proved "]
  ["a witness has another value" "zero/witness.rkt"
   "(values (listed-point best) (shown best) 0 0)"
   "(values (listed-point best) (- (shown best)) 0 0)"]
  ["quotients of balls are sharper than they are" "ball/ball.rkt"
   "(make-ball q (+ 2 (quotient spread room))"
   "(make-ball q 0"]
  ["a sign is known where a ball holds 0" "ball/ball.rkt"
   "(define (ball-positive? b) (> (ball-middle b) (ball-radius b)))"
   "(define (ball-positive? b) (> (ball-middle b) 0))"]
  ["flonums are proved" "zero/flonum-independence.rkt"
   "(and (number? e) (not (exact? e)))"
   "#f"]
  ;; expressions
  ["functions of the same arguments in another order are equal" "expression/expression.rkt"
   "(define (commutative? head) (or (eq? head op:+) (eq? head op:*)))"
   "(define (commutative? head) #t)"]
  ["x - y = y - x" "expression/expression.rkt"
   "[(exact-zero? a) (e:negate b)]"
   "[(exact-zero? a) b]"]
  ["(x^m)^n = x^(m + n)" "expression/expression.rkt"
   "(e:expt (car (node-args b)) (* n (cadr (node-args b))))"
   "(e:expt (car (node-args b)) (+ n (cadr (node-args b))))"]
  ;; decimals, and what witnesses name
  ["different decimals are read as one number" "zero/decimal-readings.rkt"
   "(eqv? size (hash-ref! sizes"
   "(real? (hash-ref! sizes"]
  ["a witness is silent on what cancels" "zero/existence.rkt"
   "(if (or (eqv? mark 1) (decided-by? e i)) 1 0)"
   "0"]
  ["a numerator decides whether there is a value, not a denominator" "zero/existence.rkt"
   "(and (eq? (node-head n) op:/) (eqv? i 0))"
   "(and (eq? (node-head n) op:/) (eqv? i 1))"]
  ["the scale of a decimal is taken out of a root" "simplify/radicand.rkt"
   "(> (denominator x) most-scale)"
   "#f"]
  ;; kinks and domains
  ["1 - cos x stands once" "zero/zero-surface.rkt"
   "(andmap (lambda (g) (eqv? 1 (cdr g))) parts)"
   "#t"]
  ["1 + cos x is never 0" "zero/zero-surface.rkt"
   "(* -1 (cdr f) (degree (car f) (stand-in-symbol t) A))"
   "0"]
  ["x and sin x are independent" "zero/zero-surface.rkt"
   "[(= (length own) (length all)) #t]"
   "[#t #t]"]
  ["at every value of a parameter a distance is one" "zero/zero-surface.rkt"
   "#:when (square-where-0? u f A)"
   "#:when #f"]
  ["functions that agree on both sides are smooth" "zero/kink.rkt"
   "(> (cdr power) (search-order s))"
   "#t"]
  ["outside the domain is inside" "zero/kink.rkt"
   "(and sign (not (signs-within? (number-signs sign) (relation-signs r))))"
   "#f"]
  ["inside the domain is outside" "zero/kink.rkt"
   "(and sign (not (signs-within? (number-signs sign) (relation-signs r))))"
   "(and sign #t)"]
  ["a reference point need not be in the domain" "assumption/reference-point.rkt"
   "(all-real? domain lookup)"
   "#t"]
  ["a witness need not be in the domain" "zero/region.rkt"
   "(for/list ([e (in-list (assumptions-domain A))])"
   "(for/list ([e (in-list '())])"]
  ["a sign is 1 or -1" "zero/sign-cases.rkt"
   "(if (and jumps? (possible? zero)) (at-zero e u A) '())"
   "'()"]
  ["what vanishes beside a zero of u vanishes there" "zero/sign-cases.rkt"
   "(beside 1 (if jumps? positive nonnegative))"
   "(beside 1 positive)"]
  ["what is a whole turn is 0" "zero/inverse-functions.rkt"
   "(and (< (- turn) (interval-low range)) (< (interval-high range) turn))"
   "#t"]
  ["squares that are equal are of equals" "zero/real-proof.rkt"
   "(and (opposite-signs? P Q A)"
   "(and #t"])
