;; Mutants that no behaviour tells from the library, or only a limit of work or of exactness, or a
;; layout: (file "the line as it was" "as it is" "reason" [limit or layout])

("algebra/polynomial/sparse-gcd.rkt"
 "(charge! R (* cost (skeleton-count s)))"
 "(charge! R (+ cost (skeleton-count s)))"
 "an estimate of work: it tells when dense methods take over, not what comes out" limit)
("algebra/polynomial/gcd.rkt"
 "(and (null? others) (equal? bounds (degrees R p kept))))"
 "(or (null? others) (equal? bounds (degrees R p kept))))"
 "a division in vain is tried; one that goes up is of the gcd all the same")
("algebra/kernel/roots.rkt"
 "(modulo (+ (if (negative? c) 1 0)"
 "(modulo (- (if (negative? c) 1 0)"
 "modulo 2 a sum is a difference")
("algebra/ball/ball-value.rkt"
 "[(or (memv x '(1 -1)) (<= (* (abs n) (rational-bits x)) most-exact-bits)) (expt x n)]"
 "[(or (memv x '(1 -1)) (<= (+ (abs n) (rational-bits x)) most-exact-bits)) (expt x n)]"
 "a power stays exact a little longer, and is inside the ball that it would be; at most 500 factors" limit)
("algebra/elimination/bareiss.rkt"
 "(sub1 (vector-ref place-counts (candidate-place c)))))"
 "(add1 (vector-ref place-counts (candidate-place c)))))"
 "another pivot of the least size: the determinant is the same, its speed is in tasks D12 and I8")
("algebra/elimination/minors.rkt"
 "(if (even? (- n 1 j)) m ((operations-subtract ops) 0 m)))"
 "(if (even? (+ n 1 j)) m ((operations-subtract ops) 0 m)))"
 "n - 1 - j and n + 1 + j are both even or both odd")
("calculus/moving-places.rkt"
 "(define direction (if (< end other) 1.0 -1.0))"
 "(define direction (if (<= end other) 1.0 -1.0))"
 "a piece of no length: the displacement is 0 in either direction")
("compile/reduced-sums.rkt"
 "(if (<= (abs a) (abs b))"
 "(if (< (abs a) (abs b))"
 "of cos² − sin² both forms, 1 − 2 sin² and 2 cos² − 1, have as many operations and digits")
("canonical/Lie/Lie-derivative.rkt"
 "(define large 500)                      ; nodes of a graph"
 "(define large 501)                      ; nodes of a graph"
 "from how many nodes on a form may have swollen: either form has the same value" limit)
("motion/system/separable.rkt"
 "(list (lambda (x k) (fl+ x (fl* (fl+ 1.0 (flabs x)) (fl+ 0.1 (fl/ 0.3 (->fl (+ k 1)))))))"
 "(list (lambda (x k) (fl+ x (fl* (fl+ 1.0 (flabs x)) (fl+ 0.1 (fl/ 0.6 (->fl (+ k 1)))))))"
 "any displacement shows whether a rate depends on what is displaced")
("canonical/quadratic/symplectic-modes.rkt"
 "(define (start k) (for/vector ([i (in-range n)]) (sin (+ 1.0 (* 1.7 i) (* 2.3 k (+ i 1))))))"
 "(define (start k) (for/vector ([i (in-range n)]) (sin (+ 2.0 (* 1.7 i) (* 2.3 k (+ i 1))))))"
 "an iteration towards a space begins with any vectors")
("motion/event/sign-change.rkt"
 "(cond [(or (zero? gb) (= count 100) (close? a b c)) (unless-pole b gb)]"
 "(cond [(or (zero? gb) (= count 101) (close? a b c)) (unless-pole b gb)]"
 "a guard: a secant with halving ends long before a hundred steps" limit)
("motion/event/certain-zeros.rkt"
 "(define most-places 400)"
 "(define most-places 401)"
 "a limit of the work, which few functions reach: one place more tells what 400 tell" limit)
("search/minimum-near.rkt"
 "[best #f] [count 0] [round 0])"
 "[best #f] [count 0] [round 1])"
 "a guard: no known search goes on for twenty rounds" limit)
("show/plot/axes/plot-legend.rkt"
 "(define symbol-x (+ x (* 4 space) (apply max (map text-width texts))))"
 "(define symbol-x (+ x (+ 4 space) (apply max (map text-width texts))))"
 "the gap between a label and its line is some pixels less" layout)
("show/plot/axes/plot-axes.rkt"
 "(draw-box dc left top (- right left) (- bottom top) #f 0.5)"
 "(draw-box dc left top (- right left) (- bottom top) #f 1.0)"
 "the box of a picture is drawn half a pixel thicker" layout)
("show/plot/axes/plot-axes.rkt"
 "(define head (if (view-title v) (* 3/2 (text-height (title-text dc v))) 0))"
 "(define head (if (view-title v) (* 3/2 (text-height (title-text dc v))) 1))"
 "without a title there is a pixel more above the picture" layout)
("show/animation/drawing.rkt"
 "#f #f '()))"
 "#f #t '()))"
 "a drawing without marks has no diagram: nobody asks for its sample")
("question/question-meaning.rkt"
 "(define (meaning-of-Hamiltonian H state) (about H state #f #f '() '()))"
 "(define (meaning-of-Hamiltonian H state) (about H state #f #t '() '()))"
 "a force that cannot be called has no expressions, as none has")
("show/typesetting/break.rkt"
 "(continuation sign (fitted right (- width 4) wide))))))"
 "(continuation sign (fitted right (- width 5) wide))))))"
 "the right side of a relation is cut a column earlier" layout)
("show/mechanism/mechanism-parts.rkt"
 "(times (/ (check-length who \"the width\" width) 2.0 (max 1e-9 (span along))) (crosswise along)))"
 "(times (/ (check-length who \"the width\" width) 2.0 (max 2e-9 (span along))) (crosswise along)))"
 "a spring whose ends are nearer than that is a point" limit)
("show/mechanism/draw-top.rkt"
 "#:when (> (nearness out) 0.0))"
 "#:when (>= (nearness out) 0.0))"
 "a face that is seen from its edge is drawn as a line on the edges of its neighbours" layout)
("show/notebook/program-cells.rkt"
 "(define (within? k) (for/or ([w (in-list wholes)]) (and (<= (car w) k) (< k (cdr w)))))"
 "(define (within? k) (for/or ([w (in-list wholes)]) (and (< (car w) k) (< k (cdr w)))))"
 "no part that stays whole begins with the end of a line, as gaps do")
("show/notebook/notebook-file.rkt"
 "(define cells (and (hash? x) (hash-ref x 'cells #f)))"
 "(define cells (and (hash? x) (hash-ref x 'cells #t)))"
 "neither is a list of cells")
("show/document/comments.rkt"
 "(< (+ (string-length line) (string-length (car (string-split next))) 12) widest)))"
 "(< (+ (string-length line) (string-length (car (string-split next))) 13) widest)))"
 "a line that leaves room for one letter less is taken for one that was meant to end there" layout)
("show/document/page-value.rkt"
 "(define wide 80)"
 "(define wide 81)"
 "formulas are cut a column later on a wide page" layout)
("show/document/web-page.rkt"
 "(define (next-number) (begin0 pictures (set! pictures (+ pictures 1))))"
 "(define (next-number) (begin0 pictures (set! pictures (- pictures 1))))"
 "the numbers in the names of pictures on a page need be different, no more")
("show/document/interaction-page.rkt"
 "(if (or (<= size room) (= n 1))"
 "(if (or (< size room) (= n 1))"
 "an interaction that fills its room to the last byte has fewer frames" limit)
("show/document/TeX-prose.rkt"
 "(values c #t)))"
 "(values c #f)))"
 "of what was found the keys alone are asked for")
("numeric/special/Bessel-recurrences.rkt"
 "(define side* (if (fl< d* 0.0) (fl- 0.0 side) side))"
 "(define side* (if (fl<= d* 0.0) (fl- 0.0 side) side))"
 "the reciprocal of a finite number is not 0")
("algebra/assumption/emptiness.rkt"
 "(not (find-reference expressions (assumptions concerned (hash) '() #t #f '())"
 "(not (find-reference expressions (assumptions concerned (hash) '() #f #f '())"
 "the search for a point asks for relations and domain alone")
("numeric/machine/assembler.rkt"
 "[movsd! #xF2 #x10] [movupd! #x66 #x10] [movapd! #x66 #x28] [ucomisd! #x66 #x2E]"
 "[movsd! #xF2 #x10] [movupd! #x66 #x10] [movapd! #x66 #x28] [ucomisd! #x66 47]"
 "comisd sets the same flags; the exception in which it differs is masked")
("motion/path-action.rkt"
 "(sample-at n (fl+ middle (fl* width (flvector-ref us k))) (fl* width (flvector-ref ws k))"
 "(sample-at n (fl- middle (fl* width (flvector-ref us k))) (fl* width (flvector-ref ws k))"
 "the nodes of Gauss and Legendre lie as far on either side, with equal weights")
("dynamics/map/fixed-points.rkt"
 "(define-plain (find-fixed-point map guess #:period [period 1] #:tolerance [tolerance 1e-13])"
 "(define-plain (find-fixed-point map guess #:period [period 1] #:tolerance [tolerance 2e-13])"
 "Newton's method doubles its digits: it ends as far below either tolerance" limit)
("dynamics/continuation/special-point.rkt"
 "(if (< (* (test p) (test a)) 0.0)"
 "(if (<= (* (test p) (test a)) 0.0)"
 "a place where the test is 0 is an end of the interval on either side")
("dynamics/continuation/curve-step.rkt"
 "(define newton-tolerance 1e-9)"
 "(define newton-tolerance 2e-9)"
 "Newton's method ends as far below either tolerance: it squares the error" limit)
("dynamics/continuation/special-point.rkt"
 "(define (same-place? p q) (< (distance (point-x p) (point-x q)) 1e-4))"
 "(define (same-place? p q) (<= (distance (point-x p) (point-x q)) 1e-4))"
 "a distance of 1e-4 exactly, which flonums do not come to")
("dynamics/continuation/special-point.rkt"
 "(define (turned? t) (< (abs (flvector-ref t (- (flvector-length t) 1))) 1e-2))"
 "(define (turned? t) (<= (abs (flvector-ref t (- (flvector-length t) 1))) 1e-2))"
 "a component of 1e-2 exactly, which flonums do not come to")
("calculus/infinitesimal-part.rkt"
 "(cond [(constant? x) x]"
 "(cond"
 "what holds no number stays as it is by the other clauses, too: speed, which benches of D watch")
("show/typesetting/pict-parts.rkt"
 "(define dots (apply hc-append (* 0.08 size) (for/list ([_ (in-range n)]) dot)))"
 "(define dots (apply hc-append (* 0.16 size) (for/list ([_ (in-range n)]) dot)))"
 "the dots are some pixels further apart" layout)
("show/typesetting/pict-parts.rkt"
 "[(\"]\") (bracket (* 0.1 w) (* 0.7 w))]"
 "[(\"]\") (bracket (* 0.2 w) (* 0.7 w))]"
 "the ends of a bracket are a pixel shorter" layout)
("show/typesetting/pict-parts.rkt"
 "(with-base-line (pin-over sign (+ hook (/ margin 2)) margin p) (pict-descent p)))"
 "(with-base-line (pin-over sign (+ hook (/ margin 3)) margin p) (pict-descent p)))"
 "what stands under a root is a pixel further to the left" layout)
("show/typesetting/formula-pict.rkt"
 "(if (string=? text \"D\") (italic g text) (upright g text)))"
 "(if (string=? text \"D\") (upright g text) (italic g text)))"
 "the D of an operator stands upright" layout)
("show/typesetting/break.rkt"
 "(and (application? factor) (<= (wide factor) (- width 4))))))"
 "(and (application? factor) (<= (wide factor) (+ width 4))))))"
 "a function that is a little wider than the line is put on one of its own before it is cut" layout)
("show/typesetting/break.rkt"
 "(and (application? factor) (<= (wide factor) (- width 4))))))"
 "(and (application? factor) (<= (wide factor) (- width 5))))))"
 "a function that just fits is cut a column earlier" layout)
("show/typesetting/break.rkt"
 "(define used (+ (* 2 (report-line-depth l)) (string-length (report-line-label l)) 1))"
 "(define used (+ (* 3 (report-line-depth l)) (string-length (report-line-label l)) 1))"
 "what stands in an indented line of a report is cut some columns earlier" layout)
("show/typesetting/break.rkt"
 "(cond [(or (<= (wide t) width) (< width least-room)) t]"
 "(cond [(or (<= (wide t) width) (< least-room least-room)) t]"
 "below the least room, which only the sides of a relation come to, lines are cut as well" layout)
("show/typesetting/pict-parts.rkt"
 "(define dot (filled-ellipse (* 0.13 size) (* 0.13 size) #:draw-border? #f))"
 "(define dot (filled-ellipse (* 0.26 size) (* 0.13 size) #:draw-border? #f))"
 "dots over letters are broader" layout)
("show/typesetting/pict-parts.rkt"
 "(send path curve-to to (* 0.25 h) to (* 0.75 h) from h)))"
 "(send path curve-to to (* 0.25 h) to (+ 0.75 h) from h)))"
 "parentheses are drawn a little rounder" layout)
("show/typesetting/pict-parts.rkt"
 "(for/fold ([whole (blank (apply + (map pict-width ps)) (+ ascent descent))] [x 0])"
 "(for/fold ([whole (blank (apply + (map pict-width ps)) (+ ascent descent))] [x 1])"
 "pieces side by side stand a pixel further to the right" layout)
("show/typesetting/pict-parts.rkt"
 "(cond [(eqv? n 0) p]"
 "(cond"
 "without dots there is nothing to be put above a letter" layout)
("algebra/kernel/circle.rkt"
 "(define o (circle u sign #f #f))"
 "(define o (circle u sign #t #f))"
 "the sine is set two lines below, before anyone asks for it")
("algebra/kernel/kernel.rkt"
 "[else 0]))"
 "[else 1]))"
 "the rank of a kernel without others, to which ranks are compared")
("algebra/kernel/kernel-collector.rkt"
 "(define form-limit 40)"
 "(define form-limit 41)"
 "from how many terms on a sum is an angle of its own" limit)
("algebra/kernel/kernel.rkt"
 "(define class (if (symbol? e) 0 (- 1000 (derivative-order e))))"
 "(define class (if (symbol? e) 1 (- 1000 (derivative-order e))))"
 "symbols come first all the same, before derivatives of an order below 999")
("algebra/kernel/circle.rkt"
 "(define o (circle u sign #f #f))"
 "(define o (circle u sign #f #t))"
 "the cosine is set three lines below, before anyone asks for it")
("algebra/field/field.rkt"
 "(and (or (not alone?) (single-term? p))"
 "(or (or (not alone?) (single-term? p))"
 "every fraction is reduced, those too where nothing is to be reduced: only time is lost" limit)
("algebra/field/field.rkt"
 "(if (and (fraction-polynomial? f) (short? (fraction-numerator f) 300))"
 "(if (and (fraction-polynomial? f) (short? (fraction-numerator f) 301))"
 "from how many terms on a product is reduced at once, and not at the end" limit)
("algebra/field/work-bounds.rkt"
 "(cond [(> (* terms n) bound) (raise-obstacle)]"
 "(cond [(>= (* terms n) bound) (raise-obstacle)]"
 "a bound of the work, one term less" limit)
("algebra/field/work-bounds.rkt"
 "[(and (< i k) (> n 1)) (loop (+ i 1) (/ (* terms (+ n i -1)) i))]"
 "[(and (< i k) (> n 2)) (loop (+ i 1) (/ (* terms (+ n i -1)) i))]"
 "a large power of two terms is given up by the meter, a second later, with the same outcome" limit)
("algebra/field/work-bounds.rkt"
 "(cond [(> (* terms n) bound) (raise-obstacle)]"
 "(cond [(> (+ terms n) bound) (raise-obstacle)]"
 "a bound of the work, foreseen one factor later" limit)
("algebra/field/field-extension.rkt"
 "(define sine² (if (eqv? (circle-sign o) 1) (poly- R one cosine²) (poly- R cosine² one)))"
 "(define sine² (if (eqv? (circle-sign o) 1) (poly- R one cosine²) (poly- cosine² cosine² one)))"
 "a difference of polynomials asks nothing of their ring")
("algebra/field/expression-value.rkt"
 "[(symbol? e) (resolved-value w e (resolution w e))]"
 ""
 "a symbol's value goes through the table of nodes: it is the same, a little later" limit)
("algebra/field/work-bounds.rkt"
 "[(and (< i k) (> n 1)) (loop (+ i 1) (/ (* terms (+ n i -1)) i))]"
 "[(and (< i k) (> n 1)) (loop (+ i 1) (/ (+ terms (+ n i -1)) i))]"
 "a large power is given up by the meter, a second later, with the same outcome" limit)
("algebra/field/field-extension.rkt"
 "(if (memq (node-head n) (list op:sqrt op:expt op:abs)) 1 0)))))"
 "(if (memq (node-head n) (list op:sqrt op:expt op:abs)) 2 0)))))"
 "twice the depth orders the tower as the depth")
("algebra/field/work-bounds.rkt"
 "(let loop ([i 1] [terms 1])"
 "(let loop ([i 2] [terms 1])"
 "a bound of the work, foreseen a factor later" limit)
("algebra/field/work-bounds.rkt"
 "(cond [(fuel-empty? tank) small-limits]"
 "(cond"
 "when the tank is empty steps stay as large as before, and take their time" limit)
("algebra/field/field-extension.rkt"
 "#:when (and (root? (relation-root F r)) (> (relation-degree r) 1)))"
 "#:when (and (root? (relation-root F r)) (>= (relation-degree r) 1)))"
 "a root that others make is taken along in vain: reduced, the fraction is the same" limit)
("algebra/field/rationalize.rkt"
 "(min 1 (poly-degree (field-ring F) h (relation-index s))))"
 "(min 2 (poly-degree (field-ring F) h (relation-index s))))"
 "denominators are reduced: of degree 1 at most in a sine")
("algebra/field/rationalize.rkt"
 "(define (from p) (fraction-from-poly R p))"
 "(define (from p) (fraction-from-poly p p))"
 "a fraction made of a polynomial asks nothing of its ring")
("calculus/moving-places.rkt"
 "(let loop ([distance (* 1e-13 (+ 1.0 (abs end)))])"
 "(let loop ([distance (* 1e-13 (+ 2.0 (abs end)))])"
 "the first of the distances at which a function is tried beside an end, all within rounding" limit)
("calculus/gradient-tape.rkt"
 "(begin-block! t (fxmin (fxmax (fx* 2 k) 16) longest-block) (flvector? slopes))"
 "(begin-block! t (fxmin (fxmax (fx* 3 k) 16) longest-block) (flvector? slopes))"
 "how long the blocks of a tape become: memory and speed alone" limit)
("calculus/moving-places.rkt"
 "[else (loop (* 4.0 distance))])))"
 "[else (loop (* 8.0 distance))])))"
 "the next of these distances" limit)
("calculus/infinitesimal-part.rkt"
 "(cond [(perturbed? x) (from-perturbed x)]"
 "(cond"
 "a dual number goes by the last clause: it is a leaf, for which the same is done, a little later" limit)
("algebra/polynomial/gcd.rkt"
 "[else (gcd-by-images R p q (poly-variables R p) (poly-variables R q) 0)]))"
 "[else (gcd-by-images R p q (poly-variables R p) (poly-variables R q) 1)]))"
 "the heuristic method, which is for the first try, is passed over: the gcd is the same, found by another" limit)
("algebra/polynomial/division.rkt"
 "[(single-term? q) (divide-by-term R p (car q) integral?)]"
 ""
 "by a single term, too, the general division gives the quotient: only time is lost" limit)
("algebra/polynomial/lifted-factor.rkt"
 "[(> (length images) choices-limit) #f]"
 "[(>= (length images) choices-limit) #f]"
 "one choice of factors less before it is given up" limit)
("algebra/polynomial/polynomial-parts.rkt"
 "(bitwise-and (+ (* 31 h)"
 "(bitwise-and (- (* 31 h)"
 "another hash, equal for equal polynomials")
("algebra/polynomial/modular-factor.rkt"
 "(equal-degree-factors other d P (+ seed 1)))]"
 "(equal-degree-factors other d P (- seed 1)))]"
 "other trial polynomials, as good as these: the factors are the same")
("algebra/polynomial/sparse-gcd.rkt"
 "(sample-residue (+ 1000 (problem-seed k)) (+ j (* 64 y)) P)))"
 "(sample-residue (+ 1000 (problem-seed k)) (- j (* 64 y)) P)))"
 "other numbers at which images are taken, as good as these")
("algebra/polynomial/sparse-gcd.rkt"
 "[(before? image h)"
 "[(before? h h)"
 "a candidate that no division confirms: another method finds the divisor, a little later" limit)
("algebra/polynomial/heuristic-gcd.rkt"
 "(define base (floor (* growth (least-base p* q*))))"
 "(define base (floor (+ growth (least-base p* q*))))"
 "another base, as large as it has to be; what its digits tell is divided by all the same" limit)
("algebra/polynomial/lifted-factor.rkt"
 "(* 2"
 "(* 3"
 "a bound for coefficients, half as large again as it has to be" limit)
("algebra/polynomial/arithmetic.rkt"
 "(max (words (leading-coefficient p))"
 "(min (words (leading-coefficient p))"
 "how long coefficients are is an estimate of work" limit)
("algebra/elimination/block-form.rkt"
 "(define inversions (count (lambda (y) (< y (car xs))) (cdr xs)))"
 "(define inversions (count (lambda (y) (<= y (car xs))) (cdr xs)))"
 "the numbers are distinct")
("algebra/elimination/exact-coefficients.rkt"
 "(for/fold ([d 0]) ([p (in-vector row)]) (max d (poly-total-degree R p)))))"
 "(for/fold ([d 0]) ([p (in-vector row)]) (min d (poly-total-degree R p)))))"
 "an estimate of how many terms there will be: it tells when elimination is not tried" limit)
("algebra/elimination/exact-coefficients.rkt"
 "(for/fold ([d 0]) ([p (in-vector row)]) (max d (poly-total-degree R p)))))"
 "(for/fold ([d 1]) ([p (in-vector row)]) (max d (poly-total-degree R p)))))"
 "the same estimate, a little greater" limit)
("algebra/elimination/elimination.rkt"
 "(and (<= (coefficients-most-terms c) limit)"
 "(and (< (coefficients-most-terms c) limit)"
 "a limit of the work, one term less" limit)
("algebra/ball/ball.rkt"
 "(define extra (max 0 (- 53 (integer-length m))))"
 "(define extra (max 0 (- 54 (integer-length m))))"
 "the same flonum in units half as large, and a radius of one unit with them" limit)
("algebra/ball/ball-elementary.rkt"
 "(unless (or (eqv? r 0) (<= (+ (integer-length r) (ball-scale b)) 0)) (raise unknown)))"
 "(unless (or (eqv? r 0) (< (+ (integer-length r) (ball-scale b)) 0)) (raise unknown)))"
 "from which uncertainty on, 1/2 or 1, a sine is not looked for" limit)
("algebra/ball/ball-elementary.rkt"
 "(unless (< (abs d) (arithmetic-shift one -8)) (raise unknown))"
 "(unless (< d (arithmetic-shift one -8)) (raise unknown))"
 "a guard: d is what the logarithm of flonums is off by, on either side")
("algebra/ball/ball-elementary.rkt"
 "(define k (whole-quotient (+ (* 4 X) pi) (* 2 pi)))"
 "(define k (whole-quotient (- (* 4 X) pi) (* 2 pi)))"
 "one quarter turn more is left in the angle: the series has a few terms more" limit)
("algebra/expression/operation.rkt"
 "(if (or (< y low) (>= y cut)) low y)]))"
 "(if (or (<= y low) (>= y cut)) low y)]))"
 "where both are equal either is the answer")
("algebra/expression/numeric-functions.rkt"
 "[(and (real? x) (< (abs x) 1e-2))   ; Taylor: no cancellation near 0"
 "[(and (real? x) (<= (abs x) 1e-2))   ; Taylor: no cancellation near 0"
 "at 0.01 the series and the formula differ by roundings" limit)
("algebra/radical/radical-sum.rkt"
 "(define most-parts 40)"
 "(define most-parts 41)"
 "up to how many parts a sum of roots is kept exactly" limit)
("algebra/radical/radical-sum.rkt"
 "(<= (for/sum ([(radical c) (in-hash s)])"
 "(< (for/sum ([(radical c) (in-hash s)])"
 "the same limit, one part less" limit)
("algebra/radical/radical-sum.rkt"
 "(if (and (rational? sum) (> (abs sum) (* 1/4 (apply + (map abs terms)))))"
 "(if (and (rational? sum) (> sum (* 1/4 (apply + (map abs terms)))))"
 "the decimals of a negative sum, too, are found by integers: slower, to within the last place" limit)
("algebra/radical/radical-sum.rkt"
 "(if (and (rational? sum) (> (abs sum) (* 1/4 (apply + (map abs terms)))))"
 "(if (and (rational? sum) (>= (abs sum) (* 1/4 (apply + (map abs terms)))))"
 "from how much cancellation on decimals are found by integers" limit)
("canonical/Lie/Lie-derivative.rkt"
 "(cond [(<= n end) (vector-ref known n)]"
 "(cond [(< n end) (vector-ref known n)]"
 "one power more than is asked for is found, and kept" limit)
("canonical/Lie/Lie-derivative.rkt"
 "(if (and (> size large) (> size (* swelling (graph-size e)))) e simple))"
 "(if (and (> size large) (>= size (* swelling (graph-size e)))) e simple))"
 "from how much swelling on a form stays as it is: either form has the same value" limit)
("canonical/perturbation/complex-polynomial.rkt"
 "(values (make-vector n 0) (make-vector (* 2 n) '()) (make-vector (* 2 n) '())))"
 "(values (make-vector n 1) (make-vector (* 2 n) '()) (make-vector (* 2 n) '())))"
 "the blocks set all of them: each coordinate is in one")
("canonical/perturbation/normal-form-verdict.rkt"
 "#:when (> (magnitude c) (* rounded (hash-ref bounds e 0.0))))"
 "#:when (> (magnitude c) (* rounded (hash-ref bounds e 1.0))))"
 "each term of the difference has its bound, the sum of the magnitudes of what was added")
("canonical/quadratic/Hermitian-modes.rkt"
 "(if (> (magnitude z) (* 1e-6 (real-part (inner v v)))) (sqrt z) (leading v)))"
 "(if (> (magnitude z) (* 2e-6 (real-part (inner v v)))) (sqrt z) (leading v)))"
 "from which size on a sum of squares tells the phase: any phase makes a normal form" limit)
("canonical/quadratic/Hermitian-modes.rkt"
 "(for/first ([x (in-vector v)] #:when (> (magnitude x) (* 0.3 greatest))) x))"
 "(for/first ([x (in-vector v)] #:when (>= (magnitude x) (* 0.3 greatest))) x))"
 "from which size on a component leads, which flonums never have exactly" limit)
("lagrangian/swapped-arguments.rkt"
 "(check-comes-first who (swapped? who L q) \"Lagrangian\" \"path\"))"
 "(check-comes-first who (swapped? L L q) \"Lagrangian\" \"path\"))"
 "whether the other order would do is tried, and the message of what fails there is caught")
("dynamics/Floquet.rkt"
 "(define angular? (and (fl< part closure-tolerance all) (angle? derivative start k)))"
 "(define angular? (and (fl<= part closure-tolerance all) (angle? derivative start k)))"
 "a gap that equals the tolerance is refused in either case, and told of the part or of all" limit)
("dynamics/chaos-indicator.rkt"
 "(up 1.0 at (g:* at (g:* 0.5 (g:log (g:+ (g:* t t) 1e-300))))))"
 "(up 1.0 at (g:* at (g:* 0.5 (g:log (g:+ (g:* t t) 2e-300))))))"
 "a number added lest there be a logarithm of 0, which is then multiplied by 0")
("dynamics/Floquet.rkt"
 "(fl* closure-tolerance (fl+ 1.0 (flabs rate))))))"
 "(fl* closure-tolerance (fl+ 2.0 (flabs rate))))))"
 "up to which difference, beside rates of about 1, a coordinate counts as an angle: 2e-6 or 1e-6" limit)
("dynamics/map-indicator.rkt"
 "(and code #t)))"
 "(and code #f)))"
 "a compiled map is asked on one core, and not on all: the same numbers, later" limit)
("constraint/constrained-motion.rkt"
 "(for/list ([x (in-list (scalars state))] [k (in-naturals 1)])"
 "(for/list ([x (in-list (scalars state))] [k (in-naturals 2)])"
 "another state beside, at which the constraints may depend on each other by chance" limit)
("constraint/constrained-motion.rkt"
 "(+ x (* 1e-3 (+ 1 (abs x)) (spread-fraction k))))))"
 "(- x (* 1e-3 (+ 1 (abs x)) (spread-fraction k))))))"
 "another state beside, at which the constraints may depend on each other by chance" limit)
("constraint/constraint-jacobian.rkt"
 "(define columns (rows-transpose (list->vector (jacobian-rows who cs state))))"
 "(define columns (rows-transpose (list->vector (jacobian-rows cs cs state))))"
 "the name is for values that are no numbers, and those at this state have been checked by then")
("compile/program.rkt"
 "(define new-index (make-vector (vector-length needed) #f))"
 "(define new-index (make-vector (vector-length needed) #t))"
 "nothing that is kept reads an instruction that is not, whose new number is this")
("compile/jet/jet-program.rkt"
 "(define varying (for/vector ([x (in-list matrix)]) (> (degree r x) 0)))"
 "(define varying (for/vector ([x (in-list matrix)]) (>= (degree r x) 0)))"
 "coefficients of an entry that does not vary are 0: products with them take time alone" limit)
("motion/linearized-flow.rkt"
 "(raise-singular who \"a motion has no Taylor series by its start; D of D is taken\" #f))"
 "(raise-singular who \"a motion has no Taylor series by its start; D of D is taken\" #t))"
 "a word from one part of the library to another, D, which takes another way then")
("motion/system/make-system.rkt"
 "(define s (flvector->structure state (state-vector who state)))"
 "(define s (flvector->structure state (state-vector state state)))"
 "the name is for states that are none, and this one has been checked by then")
("motion/choose-method.rkt"
 "(define (long? s) (> (or (system-operations s) 0) most-operations))"
 "(define (long? s) (>= (or (system-operations s) 0) most-operations))"
 "from how many operations on the Taylor method is not tried: either method is right" limit)
("value/interpolation/barycentric.rkt"
 "4))"
 "5))"
 "a common factor of the weights, which cancels: only beyond some 3,000 points do products overflow" limit)
("verdict/vanishing-conditions.rkt"
 "(define most-equations 4)"
 "(define most-equations 5)"
 "how many equations together are worth telling: one more would be true as well" limit)
("verdict/report.rkt"
 "(define n (if (< x 1) (- digits) (- digits 1)))"
 "(define n (if (<= x 1) (- digits) (- digits 1)))"
 "asked of numbers that no flonum is near, and 1 is one")
("canonical/action-angle.rkt"
 "(define wait (* (orbit-period (orbit-at p)) (/ (- angle (* 2 pi (floor (/ angle (* 2 pi)))))"
 "(define wait (* (orbit-period (orbit-at p)) (/ (- angle (* 2 pi (floor (/ angle (+ 2 pi)))))"
 "another whole number of turns: the motion is followed longer, or backwards, to the same state" limit)
("canonical/inverse-formula.rkt"
 "(define point (for/list ([s (in-list names)] [k (in-naturals)]) (cons s (/ (+ 3 k) (+ 5 k)))))"
 "(define point (for/list ([s (in-list names)] [k (in-naturals)]) (cons s (/ (+ 3 k) (+ 6 k)))))"
 "another point at which a solution is tried: any with positive numbers would do")
("canonical/action-angle.rkt"
 "(widen high (if beyond (/ (+ high beyond) 2) (* 2 high)) beyond (sub1 rounds))])))"
 "(widen high (if beyond (/ (+ high beyond) 2) (* 3 high)) beyond (sub1 rounds))])))"
 "the next momentum that is tried, until the action is too large: the root between is the same" limit)
("canonical/action-angle.rkt"
 "(define enough (max 1e-9 (* 100 tolerance)))"
 "(define enough (min 1e-9 (* 100 tolerance)))"
 "the period is settled to more digits than were asked for, with more work" limit)
("canonical/action-angle.rkt"
 "(check-time-free who H (up 0 center p))"
 "(check-time-free who H (up 1 center p))"
 "the energy is compared at times of its own, whatever that of the state")
("algebra/rewriting/collect.rkt"
 "(> m n)))"
 "(>= m n)))"
 "where both are equal the branch before it answers")
("algebra/rewriting/factor.rkt"
 "(define below (find (poly- R c one)))"
 "(define below (find (poly- c c one)))"
 "a difference of polynomials asks nothing of their ring")
("algebra/simplify/simplifier-workspace.rkt"
 "[(and (fuel-empty? (simplifier-fuel w)) (not (small? e))) e]"
 ""
 "a large argument is simplified though no work was left for it: a bound of time" limit)
("dynamics/map/fixed-points.rkt"
 "[(and (= (length sizes) 2) (< (car multipliers) 0) (> determinant 0))"
 "[(and (= (length sizes) 2) (<= (car multipliers) 0) (> determinant 0))"
 "where the determinant is positive no multiplier is 0")
("dynamics/map/period-check.rkt"
 "(define (beside state) (changed state (lambda (x k) (if (= k 0) x (g:+ x (/ 0.1 k))))))"
 "(define (beside state) (changed state (lambda (x k) (if (= k 0) x (g:+ x (/ 0.2 k))))))"
 "another state beside the one at rest, at which the drive may vanish by chance" limit)
("dynamics/map/iterated-map.rkt"
 "(if (< n compilation-threshold)"
 "(if (<= n compilation-threshold)"
 "from how many iterations on a map is compiled: both ways give one image" limit)
("geometry/chart-calculus.rkt"
 "(if (> (graph-size simple) (* 2 (graph-size e))) e simple)]))"
 "(if (> (graph-size simple) (* 3 (graph-size e))) e simple)]))"
 "which of two equal forms is kept" limit)
("geometry/chart-calculus.rkt"
 "(if (> (graph-size simple) (* 2 (graph-size e))) e simple)]))"
 "(if (> (graph-size simple) (+ 2 (graph-size e))) e simple)]))"
 "which of two equal forms is kept" limit)
("geometry/relativity/four-tuple.rkt"
 "(when (and (real? length^2) (> (abs (- length^2 1)) 1e-12))"
 "(when (and (real? length^2) (> (abs (- length^2 1)) 2e-12))"
 "how much rounding a unit vector may have" limit)
("geometry/relativity/four-tuple.rkt"
 "(when (and (real? length^2) (> (abs (- length^2 1)) 1e-12))"
 "(when (and (real? length^2) (>= (abs (- length^2 1)) 1e-12))"
 "how much rounding a unit vector may have" limit)
("error/degree-overflow.rkt"
 "degree bound)"
 "bound bound)"
 "a word from one part of the algebra to another, which makes a wider ring then")
("algebra/zero/gap.rkt"
 "[(> (* most-error (ball-radius v)) (abs (ball-middle v))) #f]"
 ""
 "a value of which not even eight digits are known at 240 bits is taken by its middle" limit)
("canonical/perturbation/Poisson-series.rkt"
 "(cons (cons (zeros (length (Poisson-series-linear s))) (wave slope 0)) waves)))"
 "(cons (cons (zeros (length (Poisson-series-linear s))) (wave slope 1)) waves)))"
 "the sine of 0: in products it cancels between the waves of sum and difference, else it is dropped")
("motion/evolve-trajectory.rkt"
 "#:state (lambda (t) (state-within s (step from to at to) t))"
 "#:state (lambda (t) (state-within s (step from at at to) t))"
 "a state within a step is read between where its interpolant begins and ends, which stay")
("notebook/text-stream.rkt"
 "(> (cond [(>= byte #xF0) 4] [(>= byte #xE0) 3] [(>= byte #xC0) 2] [else 1]) k))"
 "(> (cond [(>= byte #xF0) 5] [(>= byte #xE0) 3] [(>= byte #xC0) 2] [else 1]) k))"
 "no more than three bytes are looked back at")
("notebook/text-stream.rkt"
 "(> (cond [(>= byte #xF0) 4] [(>= byte #xE0) 3] [(>= byte #xC0) 2] [else 1]) k))"
 "(> (cond [(>= byte #xF0) 4] [(>= byte #xE0) 3] [(> byte #xC0) 2] [else 1]) k))"
 "no character begins with the byte C0")
("notebook/text-stream.rkt"
 "(> (cond [(>= byte #xF0) 4] [(>= byte #xE0) 3] [(>= byte #xC0) 2] [else 1]) k))"
 "(> (cond [(>= byte #xF0) 4] [(>= byte #xE0) 3] [(>= byte 193) 2] [else 1]) k))"
 "no character begins with the byte C0")
("notebook/text-stream.rkt"
 "(define pause 0.02)"
 "(define pause 0.04)"
 "how often what is written is sent on" limit)
("certificate/linear-terms.rkt"
 "(e:/ (part 1) (part -1)))"
 "(e:/ (part 2) (part -1)))"
 "the sign alone of this number counts")
("motion/system/system.rkt"
 "[else (or (system-own s) (new-right-hand-side s))]))"
 "[else (and (system-own s) (new-right-hand-side s))]))"
 "an integration that does not keep what it computed of the start computes it again" limit)
("notebook/run-cells.rkt"
 "(list (map (lambda (_) '()) cells) (failure \"a cell ended the process of the notebook\" #f #f)))"
 "(list (map (lambda (_) '()) cells) (failure \"a cell ended the process of the notebook\" #f #t)))"
 "the flag of an interruption is read where a front end is answered, which these cells have not")
("notebook/mime-bundle.rkt"
 "(define height (+ 120 (if m (string->number (bytes->string/latin-1 (cadr m))) 360)))"
 "(define height (+ 120 (if m (string->number (bytes->string/latin-1 (cadr m))) 361)))"
 "the height of a frame for a page whose picture tells none" layout)
("canonical/quadratic/Hermitian-modes.rkt"
 "(rotate! V T p q (* 1e-15 size))"
 "(rotate! V T p q (* 2e-15 size))"
 "up to which entry of rounding a turn is spared" limit)
("canonical/quadratic/Hermitian-modes.rkt"
 "(let-values ([(tangent c s) (rotation (/ (- diagonal-q diagonal-p) (* 2 off)))])"
 "(let-values ([(tangent c s) (rotation (/ (- diagonal-q diagonal-p) (* 3 off)))])"
 "a turn leaves a part of the entry, and turns go on until all are small: more of them, to one result" limit)
("rigid/Euler-angles.rkt"
 "(when (and (real? s) (< (abs s) 1e-12)) (raise-at-pole who state)))"
 "(when (and (real? s) (< (abs s) 2e-12)) (raise-at-pole who state)))"
 "from how near on a state is told to be at the pole, in place of rates in the range of 1e12" limit)
("rigid/rotation.rkt"
 "(define (as-tuple M) (m->s (down 0 0 0) M (up 0 0 0)))"
 "(define (as-tuple M) (m->s (down 0 1 0) M (up 0 0 0)))"
 "tuples whose shape alone is looked at")
("rigid/top.rkt"
 "(if (and (>= (f end) 0) (>= (f (* end (- 1 1e-9))) 0)) end (zero-between f slopeless end)))"
 "(if (and (>= (f end) 0) (>= (f (* end (- 1 2e-9))) 0)) end (zero-between f slopeless end)))"
 "how near an end is looked at for a sign: that beside it, at either distance" limit)
("search/minimum-between.rkt"
 "(define last (fall 1e-8))"
 "(define last (fall 2e-8))"
 "how near a pole is looked at: falls that grow, or stay, from 1e-6 on do so at either distance" limit)
("search/minimum-between.rkt"
 "#:when (and (or (not p) (< (point-y q) (point-y p)))"
 "#:when (and (or (not p) (<= (point-y q) (point-y p)))"
 "of neighbours that are equal the first alone was kept")
("search/numeric-derivative.rkt"
 "#:step (or step (* 0.1 (max 1.0 (abs at))))"
 "#:step (or step (* 0.2 (max 1.0 (abs at))))"
 "the first of steps that are halved until quotients agree: one more of them is tried" limit)
("search/critical-point.rkt"
 "(define there (and (<= 1e-300 (abs s) (* 1e-2 (size x)))"
 "(define there (and (<= 2e-300 (abs s) (* 1e-2 (size x)))"
 "a guard against distances that underflow" limit)
("motion/event/event-polynomial.rkt"
 "(or (fl<= most (fl* (fl* 100.0 (follower-tolerance f)) (total c)))"
 "(or (fl<= most (fl* (fl* 200.0 (follower-tolerance f)) (total c)))"
 "how well a polynomial follows a function whose zeros it is to tell; else places are looked at" limit)
("motion/event/region-watch.rkt"
 "(fl* 4.0 (flabs (fl/ (fl- (view-rate b) (view-rate a))"
 "(fl* 8.0 (flabs (fl/ (fl- (view-rate b) (view-rate a))"
 "how much faster than before a function may fall: more looks, no other answer" limit)
("question/refined-modes.rkt"
 "[(> (vector-length K) most-rows) found]"
 ""
 "a bound of the work: digits lost beside fast modes are sought again in matrices of any size" limit)
("question/refined-modes.rkt"
 "(mode z (if (= z 0.0) 0.0 (* roundings (mode-terms M K z shape))) shape))]))"
 "(mode z (if (= z 0.0) 1.0 (* roundings (mode-terms M K z shape))) shape))]))"
 "the frequency of an exact 0 is 0 within any bound, and its bound is not told")
("question/gauge.rkt"
 "(define longer (lengthened local (+ (* 2 n) 2)))"
 "(define longer (lengthened local (+ (* 2 n) 3)))"
 "one more derivative in the state, on which no equation depends")
("numeric/ode/taylor-run.rkt"
 "(set-run-piece! r #f)"
 "(set-run-piece! r #t)"
 "it is compared with pieces alone, and #t is none, as #f is")
("numeric/linear-algebra/flonum-systems.rkt"
 "(for/fold ([v (make-vector (vector-length rows) 1.0)] [size 1.0] #:result size) ([_ 10])"
 "(for/fold ([v (make-vector (vector-length rows) 2.0)] [size 1.0] #:result size) ([_ 10])"
 "a vector that is divided by its size at each step begins with any multiple")
("numeric/linear-algebra/general-eigenvalues.rkt"
 "(for ([i (in-range first (+ 1 (min last (+ k 3))))])"
 "(for ([i (in-range first (+ 1 (min last (+ k 4))))])"
 "one row more, whose three entries are 0 in a Hessenberg matrix with its bulge")
("numeric/linear-algebra/general-eigenvalues.rkt"
 "(let loop ([last (- n 1)] [steps 0] [found '()])"
 "(let loop ([last (- n 1)] [steps 1] [found '()])"
 "after how many steps the shifts are unusual ones" limit)
("numeric/linear-algebra/flonum-systems.rkt"
 "(for*/fold ([row #f] [place #f] [size 0.0])"
 "(for*/fold ([row #t] [place #f] [size 0.0])"
 "the place of the greatest of entries that are all 0, which nobody asks for")
("numeric/linear-algebra/general-eigenvalues.rkt"
 "(when (= count 3) (put! h n (+ k 2) (- k 1) 0.0))]"
 "(when (= count 4) (put! h n (+ k 2) (- k 1) 0.0))]"
 "what rounding leaves where there are zeros: eigenvalues move within their rounding" limit)
("numeric/linear-algebra/general-eigenvalues.rkt"
 "(fl* epsilon (fl* (flabs x) (fl+ (beside (- m 1))"
 "(fl* epsilon (fl* (flabs x) (fl+ (beside (+ m 1))"
 "beside which of its neighbours a product counts as nothing" limit)
("numeric/linear-algebra/symmetric-eigenvalues.rkt"
 "(fl* (fl* 0.5 epsilon) (fl* (flsqrt (flabs app)) (flsqrt (flabs aqq)))))))"
 "(fl* (fl* 1.0 epsilon) (fl* (flsqrt (flabs app)) (flsqrt (flabs aqq)))))))"
 "which entry counts as nothing beside its diagonal: twice as great" limit)
("numeric/linear-algebra/numeric-modes.rkt"
 "(max (greatest-entry K) (* w w (greatest-entry M)) (* w (greatest-entry G))))"
 "(max (greatest-entry K) (+ w w (greatest-entry M)) (* w (greatest-entry G))))"
 "up to which size what elimination leaves counts as rounding" limit)
("numeric/special/Bessel-recurrences.rkt"
 "(define unit (fl* side 1e-290))"
 "(define unit (fl* side 2e-290))"
 "all three values are in one unit, which divides out")
("numeric/special/elliptic-integrals.rkt"
 "(/ (+ 1.0 (* s s (+ 3/10 (* s (+ 1/7 (* s (+ 3/8 (* s 9/22)))))))) (sqrt mean))]"
 "(/ (+ 1.0 (* s s (+ 3/10 (* s (+ 1/7 (* s (- 3/8 (* s 9/22)))))))) (sqrt mean))]"
 "the last term of a series, which is less than a rounding" limit)
("numeric/quadrature/gauss-kronrod.rkt"
 "(and (or (eq? p worst)"
 "(and (and (eq? p worst)"
 "the worst panel is halved alone, and those nearly as bad in the next rounds: work, not value" limit)
("numeric/ode/gauss-equations.rkt"
 "(unless (and count (<= count fast) (not (newton-turning? m))) (set-newton-step! m #f))"
 "(unless (and count (<= fast fast) (not (newton-turning? m))) (set-newton-step! m #f))"
 "after how many repetitions derivatives are taken anew: work, for the equations are the same" limit)
("numeric/ode/fallback-method.rkt"
 "(cond [(fl>= h (fl* collapse longest)) h]"
 "(cond [(fl>= h (fl+ collapse longest)) h]"
 "from how short a step on the other method is tried: work, for steps of either keep the tolerance" limit)
("numeric/ode/roundoff-detection.rkt"
 "(and full? (fl< (row-late r) (fl* still-shorter (row-early r))))]))"
 "(and full? (fl<= (row-late r) (fl* still-shorter (row-early r))))]))"
 "sums of hundreds of step lengths that are equal to the bit: a row more or less of steps" limit)
("numeric/ode/method-code.rkt"
 "(and (<= n most-components) (<= (vector-length instructions) most-instructions)))"
 "(and (<= most-components most-components) (<= (vector-length instructions) most-instructions)))"
 "which of two forms of machine code is written: the same values" limit)
("numeric/ode/radau-equations.rkt"
 "[(not (fl< size +inf.0)) #f]"
 ""
 "what is no number is told after the last iteration: work, not value" limit)
("numeric/ode/radau.rkt"
 "(if (fl< error too-large) (control h error (equations-iterations equations)) (fl* 0.5 h)))"
 "(if (fl<= error too-large) (control h error (equations-iterations equations)) (fl* 0.5 h)))"
 "an error that is this limit to the bit" limit)
("numeric/ode/taylor-run.rkt"
 "(cond [(or (fl= fitting unit) (= count 20) (not (fl< 1e-290 fitting 1e290)))"
 "(cond [(or (fl= fitting unit) (= count 20) (not (fl< 1e-290 fitting 2e+290)))"
 "up to which unit, far beyond all lengths, coefficients are computed anew" limit)
("numeric/ode/integrate.rkt"
 "(if (fl< 0.0 length +inf.0) length (fl+ 1.0 (flabs t))))"
 "(if (fl< 0.0 length +inf.0) length (fl+ 1.0 t)))"
 "a state that does not tell the time begins at 0, and one that tells it is never wholly at rest")
("numeric/ode/taylor-run.rkt"
 "(flmax (falling (last-size e 2) a) (falling (last-size e 3) b)))]"
 "(flmin (falling (last-size e 2) a) (falling (last-size e 3) b)))]"
 "which of two small terms tells the length of a step: other steps, which keep the same tolerance" limit)
("numeric/ode/method-code.rkt"
 "(write-stages! a n places 'old #f (explicit-formulas-further m) rates)"
 "(write-stages! a n places 'old #t (explicit-formulas-further m) rates)"
 "either is the name of no vector: nothing is stored under it")
("motion/event/event-polynomial.rkt"
 "(cond [(clear? row (expansion-order e) (flabs span)) 'clear]"
 "(cond"
 "a series that is plainly never 0 is looked at for zeros, and has none: a little more work" limit)
("motion/event/event-polynomial.rkt"
 "(if (fl> (flabs (flvector-ref c 0)) (fl* 1.01 varies))"
 "(if (fl> (flvector-ref c 0) (fl* 1.01 varies))"
 "a polynomial that is plainly negative is looked at for zeros, and has none: a little more work" limit)
("motion/event/sign-change.rkt"
 "#:close? [close? (lambda (a b c) (or (= c b) (<= (abs (- b a)) near)))]"
 "#:close? [close? (lambda (a b c) (and (= c b) (<= (abs (- b a)) near)))]"
 "a place that is good enough is made better still: a few values more of the function" limit)
("numeric/quadrature/tail.rkt"
 "(and (<= (car exponents) (+ 1.0 1e-6))"
 "(and (< (car exponents) (+ 1.0 1e-6))"
 "how near to 1 an exponent counts as 1, one flonum less" limit)
("numeric/quadrature/tail.rkt"
 "(define us (for/list ([k (in-range 8)]) (* to (expt 2.0 (* -0.5 k)))))"
 "(define us (for/list ([k (in-range 8)]) (* to (expt 4.0 (* -0.5 k)))))"
 "at which distances it is looked at whether a function falls as 1/u" limit)
("numeric/quadrature/probe-points.rkt"
 "(define aside (fl* 1e-3 (fl* strip (fl- (panel-centre p) edge))))"
 "(define aside (fl* 1e-3 (fl+ strip (fl- (panel-centre p) edge))))"
 "how far beside the edge of a panel it is looked at whether the panel is wrong" limit)
("numeric/quadrature/improper.rkt"
 "(cond [(near? a) a] [(near? b) b] [(near? 0.0) 0.0] [else c]))"
 "(cond  [(near? b) b] [(near? 0.0) 0.0] [else c]))"
 "a number next to an end does as well as the end: the distances looked at are greater by far" limit)
("numeric/quadrature/tail.rkt"
 "(define rounding (* 1e-15 (abs limit) (if (= left 0.0) 1.0 (/ 1.0 left))))"
 "(define rounding (* 1e-15 (abs limit) (if (= left 0.0) 2.0 (/ 1.0 left))))"
 "how much is added to a bound for rounding where the last part is 0" limit)
("motion/system/singular-coordinate.rkt"
 "(and (list? near) (<= (greatest near) (* 30 (greatest away)))))"
 "(and (list? near) (< (greatest near) (* 30 (greatest away)))))"
 "how much greater rates may be near a place than at a distance, thirty times, which is a choice" limit)
("motion/system/make-system.rkt"
 "(Lagrangian-code who derivative state)"
 "(Lagrangian-code derivative derivative state)"
 "the name is for complaints of a state that was looked at before")
("algebra/zero/vanishing-factors.rkt"
 "(if (> (poly-term-count p) most-terms)"
 "(if (>= (poly-term-count p) most-terms)"
 "from how many terms on no factors are sought, one less" limit)
("canonical/perturbation/Poisson-series.rkt"
 "(define (constant-series n c) (one-wave (zeros n) c 0))"
 "(define (constant-series n c) (one-wave (zeros n) c 1))"
 "the sine of 0 is put to 0 where waves are collected")
("canonical/perturbation/Poisson-series.rkt"
 "(for/or ([x (in-list a)] [y (in-list b)] #:unless (= x y)) (> x y)))"
 "(for/or ([x (in-list a)] [y (in-list b)] #:unless (= x y)) (>= x y)))"
 "equal ones are left out before")
("canonical/perturbation/complex-polynomial.rkt"
 "(define small (* 1e-15 (apply max 0 (map magnitude (hash-values found)))))"
 "(define small (* 2e-15 (apply max 0 (map magnitude (hash-values found)))))"
 "which decimals count as rounding of the greatest, and are dropped" limit)
("canonical/perturbation/Taylor-polynomial.rkt"
 "(for/fold ([p (make-hasheqv)]) ([j (in-range (if (> d limit) 0 (add1 d)))])"
 "(for/fold ([p (make-hasheqv)]) ([j (in-range (if (> limit limit) 0 (add1 d)))])"
 "terms are found too that later factors take beyond the degree: work alone" limit)
("pendulum/phase.rkt"
 "(if (and (real? r) (>= (abs r) 1)) (if (> r 0) :pi/2 (- :pi/2)) (g:asin s)))"
 "(if (and (real? r) (>= (abs r) 1)) (if (>= r 0) :pi/2 (- :pi/2)) (g:asin s)))"
 "a number of size 1 or more is not 0")
("reduction/half-turn-average.rkt"
 "(define closeness 1e-12)"
 "(define closeness 2e-12)"
 "when two means agree: they converge by all powers of the spacing, and the last is far closer" limit)
("numeric/optimization/brent-root.rkt"
 "(max (* 0.5 (real->double-flonum tolerance) (max (abs x) (* 1e-2 (abs width))))"
 "(max (* 0.5 (real->double-flonum tolerance) (max (abs x) (* 0.02 (abs width))))"
 "near zero the bracket ends at the width promised, no longer at half of it" limit)
("numeric/optimization/Levenberg-Marquardt.rkt"
 "(define least-eigenvalue 1e-12)"
 "(define least-eigenvalue 2e-12)"
 "from which of the last digits on a combination counts as not determined" limit)
("numeric/optimization/Levenberg-Marquardt.rkt"
 "(let ([size (norm c)]) (if (fl> size 0.0) size 1.0)))]"
 "(let ([size (norm c)]) (if (fl> size 0.0) size 2.0)))]"
 "a column of zeros is one in any unit; its variable stays, and is told as not determined")
("numeric/optimization/trust-region.rkt"
 "[(and (fl> (share f*) 0.75) long?) (fl* 2.0 radius)]"
 "[(or (fl> (share f*) 0.75) long?) (fl* 2.0 radius)]"
 "how far the next step may go: other steps, to the same zero" limit)
("numeric/optimization/differences.rkt"
 "(and (pair? row) (<= (entry-badness (least-bad row)) (* 10.0 tolerance))))"
 "(and (pair? row) (< (entry-badness (least-bad row)) (* 10.0 tolerance))))"
 "a badness that is ten times the tolerance to the bit" limit)
("numeric/optimization/differences.rkt"
 "(+ (* 2.0 (distance q v)) rounding (* 10.0 tolerance (max (abs v) scale))))))"
 "(+ (* 4.0 (distance q v)) rounding (* 10.0 tolerance (max (abs v) scale))))))"
 "how far the quotient over another step may be from the derivative: twice what it may be else" limit)
("numeric/optimization/brent-root.rkt"
 "(define all (- (point-x c) (point-x b)))"
 "(define all (+ (point-x c) (point-x b)))"
 "the length of the step before the first one, of which there was none: other steps, to the same root" limit)
("numeric/optimization/differences.rkt"
 "(and (> (length row) 2)"
 "(or (> (length row) 2)"
 "the search ends at the tolerance: digits beyond it are not looked for" limit)
("algebra/assumption/ledger.rkt"
 "(asked-once A s e (lambda () (real-valued? A s e)) #f))"
 "(asked-once s s e (lambda () (real-valued? A s e)) #f))"
 "a question that leads back to itself is stopped where it comes for the second time, not the first" limit)
("numeric/machine/instruction-builder.rkt"
 "(define code-limit (expt 2 25))"
 "(define code-limit (expt 3 25))"
 "keys of instructions that are no fixnums find them as well, a little later" limit)
("numeric/machine/instruction-code.rkt"
 "(define r (or (last-in-register c x k)"
 "(define r (or (last-in-register c k k)"
 "the result is made in another register, with one move more" limit)
("numeric/machine/executable.rkt"
 "(for/and ([x (in-flvector v)] [k (in-naturals)])"
 "(for/or ([x (in-flvector v)] [k (in-naturals)])"
 "a guard: there is no version of Racket in which only some of the components lie elsewhere")
("numeric/machine/executable.rkt"
 "(and (< pieces most-pieces)"
 "(and (<= pieces most-pieces)"
 "a limit of the pieces of memory at once, one more" limit)
("numeric/machine/instruction-builder.rkt"
 "(define code-limit (expt 2 25))"
 "(define code-limit (expt 2 26))"
 "the numbers by which instructions are found again: a larger base keeps them apart as well" limit)
("numeric/Taylor/polynomial-zeros.rkt"
 "(loop low high newton (+ count 1))]"
 "(loop low high newton (- count 1))]"
 "how often halving helps Newton's steps, which stay between the bounds: the zero is the same, found in more steps" limit)
("numeric/Taylor/polynomial-zeros.rkt"
 "[(or (fl= middle low) (fl= middle high)) middle]"
 "[(and (fl= middle low) (fl= middle high)) middle]"
 "a zero is looked for between two numbers side by side, to the end of the count: work, not value" limit)
("numeric/Taylor/expansion.rkt"
 "(>= order 3)"
 "(>= order 4)"
 "from which order on there is machine code: kernels give the same values, slower" limit)
("numeric/Taylor/polynomial-zeros.rkt"
 "[(and (fl< low newton) (fl< newton high) (not (= 7 (remainder count 8))))"
 "[(and (fl< low newton) (fl< newton high) (not (= 7 (remainder count 9))))"
 "how often a step is a halving where Newton's are slow" limit)
("numeric/Taylor/polynomial-zeros.rkt"
 "(define newton (fl- x (fl/ px slope)))"
 "(define newton (fl+ x (fl/ px slope)))"
 "Newton's steps lead away, and halvings find the same zeros, slower" limit)
("numeric/bigfloat/extrapolation.rkt"
 "(define (slopes j) (+ 1.0 (* j (+ j 1))))"
 "(define (slopes j) (+ 1.0 (* j (- j 1))))"
 "what rows are thought to cost: other steps are chosen, which keep the same tolerance" limit)
("numeric/bigfloat/extrapolation.rkt"
 "(if (< cost least) (values j H cost) (values rows longest least))))"
 "(if (<= cost least) (values j H cost) (values rows longest least))))"
 "of two rows that cost the same to the bit either is as good" limit)
("numeric/bigfloat/extrapolation.rkt"
 "(define-values (rows next) (best-choice errors (if last? far h) accepted? most))"
 "(define-values (rows next) (best-choice errors (if last? h h) accepted? most))"
 "the step after the one that was cut short at an end may be too long, and is tried again: work, not value" limit)
("numeric/bigfloat/extrapolation.rkt"
 "(fl* 0.94 (flexpt (fl/ 0.65 error) (fl/ 1.0 (->fl (- (* 2 j) 1)))))"
 "(fl* 0.94 (flexpt (fl/ 0.65 error) (fl/ 1.0 (->fl (+ (* 2 j) 1)))))"
 "how long a step a row would have borne, as if of two orders more: other steps, which keep the same tolerance" limit)
("numeric/bigfloat/extrapolation.rkt"
 "(define (most-rows digits) (+ 4 (inexact->exact (ceiling (* 0.8 digits)))))"
 "(define (most-rows digits) (+ 4 (inexact->exact (ceiling (+ 0.8 digits)))))"
 "so many rows at most: other steps, which keep the same tolerance" limit)
("numeric/bigfloat/extrapolation.rkt"
 "(define left (- (+ aim 1) j))"
 "(define left (- (+ aim 2) j))"
 "how many rows beyond those aimed at are tried: work, not value" limit)
("numeric/bigfloat/extrapolation.rkt"
 "(and (<= left 2)"
 "(and (< left 2)"
 "from which row on a step is given up beforehand: work, not value" limit)
("numeric/bigfloat/extrapolation.rkt"
 "(define (slopes j) (+ 1.0 (* j (+ j 1))))"
 "(define (slopes j) (+ 2.0 (* j (+ j 1))))"
 "what rows are thought to cost: other steps are chosen, which keep the same tolerance" limit)
("numeric/bigfloat/extrapolation.rkt"
 "(define last (+ 1 (length errors)))"
 "(define last (+ 2 (length errors)))"
 "which row bore how long a step is told by the next one's number: other steps, which keep the same tolerance" limit)
("dynamics/map/fixed-points.rkt"
 "(define return-tolerance 1e-9)"
 "(define return-tolerance 2e-9)"
 "how near a point must come back for a lesser period to be tried: it is found exactly, or there is none" limit)
("dynamics/map/invariant-manifold.rkt"
 "(define half (* 0.5 (- high low)))"
 "(define half (* 0.5 (+ high low)))"
 "how far from two pieces Newton's method may find their crossing: a crossing all the same, of other pieces" limit)
("dynamics/map/map-on-tuples.rkt"
 "(for/flvector #:length (flvector-length v) ([x (in-flvector v)] [k (in-naturals 1)])"
 "(for/flvector #:length (flvector-length v) ([x (in-flvector v)] [k (in-naturals 2)])"
 "another place beside the first, at which a turn may change an image by whole turns by chance" limit)
("dynamics/map/jacobian.rkt"
 "(for/flvector #:length 2 ([z (in-flvector (numbers (image (along s))))]"
 "(for/flvector #:length 3 ([z (in-flvector (numbers (image (along s))))]"
 "a third row of zeros, which nobody asks for: determinants and directions are those of two rows")
("dynamics/map/periodic-points.rkt"
 "(define (close? z edge) (< (abs (- z edge)) (* 1e-6 (+ 1 (abs z)))))"
 "(define (close? z edge) (< (abs (- z edge)) (* 1e-6 (+ 2 (abs z)))))"
 "how near to an edge a point leaves the count of indices undecided" limit)
("dynamics/map/periodic-points.rkt"
 "(define (close? z edge) (< (abs (- z edge)) (* 1e-6 (+ 1 (abs z)))))"
 "(define (close? z edge) (< (abs (- z edge)) (* 2e-6 (+ 1 (abs z)))))"
 "how near to an edge a point leaves the count of indices undecided" limit)
("dynamics/map/periodic-points.rkt"
 "(and d (fl< (norm d) 1e-8)))"
 "(and d (fl< (norm d) 2e-8)))"
 "within which distance a symmetry leaves a point where it is: Newton's method leaves 1e-13" limit)
("dynamics/invariant-curve/invariant-circle.rkt"
 "(if (fl< error before) (found x y error) (found before-x before-y before))]"
 "(if (fl<= error before) (found x y error) (found before-x before-y before))]"
 "of two curves with one residual, to the bit, either is as good" limit)
("dynamics/invariant-curve/invariant-circle.rkt"
 "(cond [(fl< error (if last? small-at-last small)) (found x y error)]"
 "(cond [(fl<= error (if last? small-at-last small)) (found x y error)]"
 "a residual that is the tolerance to the bit" limit)
("dynamics/invariant-curve/circle-equation.rkt"
 "(cond [(and (fl< error +inf.0) (fl> error enough) (< count 20)"
 "(cond [(and (fl< error 1.0) (fl> error enough) (< count 20)"
 "how far off a curve may be to be tried: from one that is off by a radian Newton's method leads nowhere" limit)
("dynamics/invariant-curve/circle-equation.rkt"
 "(for/vector #:length count ([k (in-range 1 (+ count 1))])"
 "(for/vector #:length count ([k (in-range 1 (+ count 2))])"
 "a vector of so many points takes no further one")
("dynamics/invariant-curve/circle-equation.rkt"
 "(let improve ([x x0] [y y0] [best-x x0] [best-y y0] [best +inf.0] [count 0])"
 "(let improve ([x x0] [y y0] [best-x x0] [best-y y0] [best 1.0] [count 0])"
 "the first curve is improved whatever its residual; where that is no number it is no circle, by either")
("dynamics/invariant-curve/invariant-circle.rkt"
 "(if (fl< error before) (found x y error) (found before-x before-y before))]"
 "(if (fl< before before) (found x y error) (found before-x before-y before))]"
 "the curve with fewer terms, whose residual is no more than four times that of the other, where more terms hardly help" limit)
("dynamics/invariant-curve/invariant-circle.rkt"
 "(loop b at-b next (miss next) (+ n 1))))))"
 "(loop b at-b next (miss next) (- n 1))))))"
 "a guard: secants end where nothing is missed, or two miss by the same, long before sixty" limit)
("scale/ensemble/checkpoint.rkt"
 "(values (if f (length (finished-outcomes f)) 0) (length (batch-starts b))))"
 "(values (if f (length (finished-outcomes f)) 1) (length (batch-starts b))))"
 "where nothing was kept nobody asks how much")
("scale/ensemble/evolve-ensemble.rkt"
 "(define (useful jobs) (min jobs (* 4 (processor-count))))"
 "(define (useful jobs) (min jobs (+ 4 (processor-count))))"
 "how many workers a thousand jobs are" limit)
("scale/ensemble/perform-task.rkt"
 "(define last-system #f)"
 "(define last-system #t)"
 "no list of parameters is #f: the first one makes a system")
("scale/ensemble/prepare-task.rkt"
 "(and code collect (null? events) (compile-traced collect example #:name who)))"
 "(and code collect (null? events) (compile-traced example example #:name who)))"
 "what is collected is computed here, of the states that workers send: the same, slower" limit)
("scale/export/program-text.rkt"
 "(define longest 68)"
 "(define longest 69)"
 "how long a formula may be that stands in another" layout)
("scale/export/C.rkt"
 "(C-function who s \"derivative\" \"dy\" (exported-slope s))"
 "(C-function s s \"derivative\" \"dy\" (exported-slope s))"
 "who complains of an operation that C lacks: it has a function for each")
("scale/export/python.rkt"
 "(for/list ([f (in-list (C-files who s))]) (cons (in (in name \"csrc\") (car f)) (cdr f)))))"
 "(for/list ([f (in-list (C-files s s))]) (cons (in (in name \"csrc\") (car f)) (cdr f)))))"
 "who complains of an operation that C lacks: it has a function for each")
("scale/export/program-text.rkt"
 "(formula (number->literal x) (if (or (< x 0.0) (eqv? x -0.0)) sum atom)))"
 "(formula (number->literal x) (if (or (< x 0.0) (eqv? x -0.0)) atom atom)))"
 "a negative number in a product stands without parentheses" layout)
("error/DrRacket-run.rkt"
 "\"--jobs\" (number->string (min 4 (processor-count))) \"--DrRacket\""
 "\"--jobs\" (number->string (min 5 (processor-count))) \"--DrRacket\""
 "how many processes compile at once" limit)
("error/stale-files.rkt"
 "(define (seconds path) (file-or-directory-modify-seconds path #f (lambda () 0)))"
 "(define (seconds path) (file-or-directory-modify-seconds path #f (lambda () 1)))"
 "what is not there is older than all files but those of the first second of 1970")
("error/spelling.rkt"
 "(and (> (string-length s) n) (string-ci=? beginning (substring s 0 n))))"
 "(and (>= (string-length s) n) (string-ci=? beginning (substring s 0 n))))"
 "a name that ends with the hyphen is one slip away, and told before beginnings are looked at")
("error/spelling.rkt"
 "(and (<= (abs (- m n)) most)"
 "(and (<= (abs (- n n)) most)"
 "lengths that differ by more are found to be too many slips in the end, too" limit)
("canonical/quadratic/phase-space-equilibrium.rkt"
 "(> (abs (- x y)) (* 1/10 (+ 1 (abs x))))))"
 "(>= (abs (- x y)) (* 1/10 (+ 1 (abs x))))))"
 "how far from the place that is given an equilibrium may be" limit)
("canonical/quadratic/phase-space-equilibrium.rkt"
 "(> (abs (- x y)) (* 1/10 (+ 1 (abs x))))))"
 "(> (abs (- x y)) (* 1/10 (+ 2 (abs x))))))"
 "how far from the place that is given an equilibrium may be" limit)
("geometry/motion/continuous-angles.rkt"
 "(define part (if (even? halvings) 0.45 0.6))"
 "(define part (if (even? halvings) 0.6 0.45))"
 "where an interval is parted first" limit)
("geometry/motion/continuous-angles.rkt"
 "(if (and (> (abs short) (- pi 1e-5)) (> (* r short) 0))"
 "(if (and (> (abs short) (- pi 2e-5)) (> (* r short) 0))"
 "what is taken for half a turn, as through a pole" limit)
("geometry/motion/event-on-manifold.rkt"
 "(define by (* 1e-9 (- (stretch-end s) at)))"
 "(define by (* 2e-9 (- (stretch-end s) at)))"
 "within what time two occurrences at the end of a stretch are one" limit)
("algebra/simplify/normalize.rkt"
 "(retry (+ 1 (* 2 degree))))))"
 "(retry (- 1 (* 2 degree))))))"
 "every other ring tried has no room at all, and a wider one is tried after it: time" limit)
("algebra/simplify/domain-question.rkt"
 "(or (andmap single? relations) (not (ormap single? relations)))))"
 "(and (andmap single? relations) (not (ormap single? relations)))))"
 "a way that is shorter where nothing narrows is not taken, and the long one finds the same signs" limit)
("algebra/simplify/stable-form.rkt"
 "(and (in-front? (car (node-args e))) (andmap exact-expression? (cdr (node-args e)))))"
 "(and (in-front? (car (node-args e))) (ormap exact-expression? (cdr (node-args e)))))"
 "with a flonum in front sums have whole coefficients, so that others are in arguments of functions: they are not simplified once more to the same" limit)
("algebra/simplify/necessary-assumptions.rkt"
 "(and x y (> (abs (- x y)) (* 1e-9 (+ 1.0 (abs x))))))"
 "(and x y (> (abs (- x y)) (* 1e-9 (+ 2.0 (abs x))))))"
 "from which difference of two values on they differ, for values about 1" limit)
("algebra/simplify/stable-form.rkt"
 "[(= (length seen) settle-limit) (least-expression (cons e seen))]"
 ""
 "a guard: no known form is presented five times without coming back" limit)
("algebra/assumption/emptiness.rkt"
 "[(or (eqv? left 0) (null? relations)) #f]"
 "[(or (eqv? left 1) (null? relations)) #f]"
 "of 200 boxes the last is not looked at" limit)
("algebra/assumption/interval.rkt"
 "(if (reaches? top) 1 (extreme greatest 1))))"
 "(if (reaches? top) 2 (extreme greatest 1))))"
 "the interval is cut to that from -1 to 1 around it")
("algebra/assumption/reference-point.rkt"
 "(define (seed k n) (if (< k last-dependent) n (* n n)))"
 "(define (seed k n) (if (< last-dependent last-dependent) n (* n n)))"
 "which points are looked at where the first will not do: any at which question and declarations hold is as good" limit)
("algebra/assumption/reference-point.rkt"
 "(+ low (* (- high low) (/ (abs x) (+ 1.0 (abs x)))))]"
 "(+ low (* (- high low) (/ (abs x) (+ 2.0 (abs x)))))]"
 "where between two bounds a point is taken: any within is as good" limit)
("algebra/assumption/reference-point.rkt"
 "(/ (modulo (quotient x 64) 65536) 65536.0))"
 "(/ (modulo (quotient x 65) 65536) 65536.0))"
 "other numbers for the points after the first, as good as these" limit)
("algebra/assumption/reference-point.rkt"
 "[b (scattered (seed k (+ 17 (* 2003 k) (* 57 i))))]"
 "[b (scattered (seed k (+ 17 (* 2003 k) (* 58 i))))]"
 "other numbers for the points after the first, as good as these" limit)
("algebra/assumption/reference-point.rkt"
 "[(<= k last-mostly-positive) (eqv? (remainder k 6) (remainder i 6))]"
 "[(< k last-mostly-positive) (eqv? (remainder k 6) (remainder i 6))]"
 "one of two hundred points has its negative numbers elsewhere" limit)
("algebra/assumption/reference-point.rkt"
 "(+ 1.0 (/ 5.0 (+ 11.0 (* 7.0 i))))"
 "(+ 1.0 (/ 5.0 (+ 22.0 (* 7.0 i))))"
 "another first point; its numbers are between 1 and π/2, the first the greatest, as promised" limit)
("algebra/elimination/exact-coefficients.rkt"
 "(define rest (fraction* R f (fraction-from-poly R d)))"
 "(define rest (fraction* R f (fraction-from-poly d d)))"
 "a polynomial becomes a fraction without a look at its ring")
("algebra/elimination/exact-coefficients.rkt"
 "(for/fold ([terms 1]) ([i (in-range 1 (add1 (ring-size R)))])"
 "(for/fold ([terms 1]) ([i (in-range 1 (sub1 (ring-size R)))])"
 "a bound of the work beforehand, of fewer variables: from where on it is given up" limit)
("algebra/elimination/bareiss.rkt"
 "(define place-counts (make-vector (vector-length columns) 0))"
 "(define place-counts (make-vector (vector-length columns) 1))"
 "which of several pivots of one size is taken, by how much it is guessed to fill: a guess of the work" limit)
("algebra/elimination/bareiss.rkt"
 "(define (increment! v i) (vector-set! v i (add1 (vector-ref v i))))"
 "(define (increment! v i) (vector-set! v i (sub1 (vector-ref v i))))"
 "counted down instead of up: another pivot of the least size" limit)
("algebra/expression/order.rkt"
 "(cond [(literal-head? head) (if (null? (literal-head-index head)) 3 5)]"
 "(cond [(literal-head? head) (if (null? (literal-head-index head)) 3 6)]"
 "5 is the last rank, and ranks are compared alone")
("algebra/expression/flat-graph.rkt"
 "(when (fx> (fx* 2 (merged-count m)) (fxvector-length (merged-places m))) (widen! m))"
 "(when (fx> (fx* 3 (merged-count m)) (fxvector-length (merged-places m))) (widen! m))"
 "how full a table may be" limit)
("algebra/expression/flat-graph.rkt"
 "(define most-tapes (fx- (fxlshift 1 31) 1))"
 "(define most-tapes (fx- (fxlshift 1 32) 1))"
 "after how many tapes their numbers begin anew" limit)
("algebra/expression/flat-graph.rkt"
 "(define nodes (make-vector n #f))"
 "(define nodes (make-vector n #t))"
 "each place is set before it is read: operands stand before what they are operands of")
("algebra/expression/numeric-functions.rkt"
 "[(and (real? x) (> x 6)) 1.0]"
 "[(and (real? x) (>= x 6)) 1.0]"
 "at 6 the error function, by the other formula, is 1 when rounded")
("algebra/expression/numeric-functions.rkt"
 "[(not (and (real? x) (>= x 1)))"
 "[(not (and (real? x) (> x 1)))"
 "at 1.0 either formula is the logarithm of 1.0")
("algebra/expression/order.rkt"
 "(cond [(eq? a b) 0]"
 "(cond"
 "the same is equal by the clauses below, too, a little later" limit)
("algebra/expression/constant-range.rkt"
 "(and (<= least-normal size) (<= size greatest)))"
 "(and (<= least-normal size) (< size greatest)))"
 "the greatest flonum is told from the others: a constant that nobody writes" limit)
("algebra/expression/constant-range.rkt"
 "(and (<= least-normal size) (<= size greatest)))"
 "(and (< least-normal size) (<= size greatest)))"
 "the least normal flonum is told from the others: a constant that nobody writes" limit)
("algebra/expression/expression.rkt"
 "[(exact-zero? a) b]"
 ""
 "0 beside a sum is that sum by a later clause, too, made anew" limit)
("algebra/ball/ball-elementary.rkt"
 "(define small (if (positive? X) (- (integer-length X) (integer-length Y)) 0))"
 "(define small (if (positive? X) (- (integer-length X) (integer-length Y)) 1))"
 "one bit more is worked out than is asked for" limit)
("algebra/ball/fixed-point.rkt"
 "(+ 2 (down (* (+ y y bound) bound) v)))))"
 "(+ 3 (down (* (+ y y bound) bound) v)))))"
 "a bound that is wider by one unit at each step" limit)
("algebra/ball/fixed-point.rkt"
 "(let loop ([power (abs T)] [k 1] [sum 0] [s 1])"
 "(let loop ([power (abs T)] [k 1] [sum 1] [s 1])"
 "the sum is off by one unit more, of which the bound has four to spare beside two for each term" limit)
("algebra/ball/ball.rkt"
 "(define s (max 0 (- (+ p (integer-length n)) (integer-length m))))"
 "(define s (max 0 (+ (+ p (integer-length n)) (integer-length m))))"
 "bits are worked out that are dropped at once: a radius of two units in place of one" limit)
("algebra/ball/ball-elementary.rkt"
 "(define spare 28)"
 "(define spare 29)"
 "one bit more of log 2 than is needed" limit)
("algebra/ball/ball-functions.rkt"
 "(if (and (< k last) (>= n (arithmetic-shift 1 (max 0 (ball-magnitude s)))))"
 "(if (and (<= k last) (>= n (arithmetic-shift 1 (max 0 (ball-magnitude s)))))"
 "the series ends a term earlier; the radius holds its rest all the same" limit)
("algebra/ball/ball.rkt"
 "(unless (< (- most-scale) scale most-scale) (raise unknown))"
 "(unless (<= (- most-scale) scale most-scale) (raise unknown))"
 "one scale more, 2^40, of numbers that nobody asks for" limit)
("algebra/ball/ball-elementary.rkt"
 "(when (> far (+ 4096 (* 8 p))) (raise unknown))"
 "(when (>= far (+ 4096 (* 8 p))) (raise unknown))"
 "a bound of the work, one bit less" limit)
("algebra/radical/radical-sum.rkt"
 "(if (and (rational? sum) (> (abs sum) (* 1/4 (apply + (map abs terms)))))"
 "(if (and (rational? sum) (> (abs sum) (+ 1/4 (apply + (map abs terms)))))"
 "the decimals of all sums are found by integers: slower, to within the last place" limit)
("algebra/radical/radical-power.rkt"
 "(define most-steps 4)"
 "(define most-steps 5)"
 "how many roots within roots are looked for" limit)
("algebra/radical/radical-sum.rkt"
 "(in-units (* 2 bits))))))"
 "(in-units (* 3 bits))))))"
 "how many more bits are tried where a sum cancels: those that stand are the same" limit)
("algebra/radical/radical-sum.rkt"
 "(and (andmap (lambda (f) (<= (car f) largest-known-prime)) factors)"
 "(and (andmap (lambda (f) (< (car f) largest-known-prime)) factors)"
 "a million is no prime, nor what is left without small primes")
("algebra/radical/radical-power.rkt"
 "(and (< (abs t) 1e15) (/ (inexact->exact (round t)) denominators)))"
 "(and (<= (abs t) 1e15) (/ (inexact->exact (round t)) denominators)))"
 "a bound of the size of what is rounded, which no number reaches exactly" limit)
("algebra/radical/radical-sum.rkt"
 "(if (> (integer-length units) 64)"
 "(if (>= (integer-length units) 64)"
 "64 bits of the sum stand instead of 65: more than a decimal has" limit)
("geometry/motion/geodesic-motion.rkt"
 "(if (and (real? last-one) (<= last-one (* 1e-4 (determinant (trajectory-start tr)))))"
 "(if (and (real? last-one) (<= last-one (* 0.0002 (determinant (trajectory-start tr)))))"
 "by what part of its determinant a metric has lost a direction" limit)
("geometry/motion/continuous-angles.rkt"
 "(define there (if-raised refusal? #f (place->coordinates C (coordinates->place C q))))"
 "(define there (if-raised refusal? #t (place->coordinates C (coordinates->place C q))))"
 "neither #f nor #t is numeric, and what is not is refused three lines below")
("geometry/motion/continuous-angles.rkt"
 "[(if forth? (<= at t) (>= at t)) (search middle high)]"
 "[(if forth? (<= at t) (> at t)) (search middle high)]"
 "at the time of a node its own coordinates are those next to the node before")
("geometry/motion/vector-transport.rkt"
 "(g:* ((D (lambda (q) ((transition A B) (up 0 q)))) q) u)))"
 "(g:* ((D (lambda (q) ((transition A B) (up 1 q)))) q) u)))"
 "the coordinates in another chart do not depend on the time")
("geometry/motion/chart-choice.rkt"
 "(define x (for/list ([k (in-range n)]) (+ 0.4 (/ k 7.0))))"
 "(define x (for/list ([k (in-range n)]) (+ 0.8 (/ k 7.0))))"
 "at any regular place a turn of an angle comes back, and one of another coordinate does not")
("teaching/worksheet/extra-motions.rkt"
 "[zero (in-value (zero-between at (- (/ i 10.) 4.03) (- (/ (+ i 1) 10.) 4.03)))]"
 "[zero (in-value (zero-between at (- (/ i 10.) 8.06) (- (/ (+ i 1) 10.) 4.03)))]"
 "between which places a change of sign is looked for: one zero of several is enough" limit)
("teaching/worksheet/decimal-answers.rkt"
 "(max (for/sum ([t (in-list terms)]) (abs (or (value-at t point) 0)))"
 "(max (for/sum ([t (in-list terms)]) (abs (or (value-at t point) 1)))"
 "where the key has a value its terms have")
("teaching/worksheet/decimal-answers.rkt"
 "(cons s (expt 50. (- (* 2 (scattered i j)) 1)))))"
 "(cons s (expt 50. (- (* 3 (scattered i j)) 1)))))"
 "at what positive numbers an answer is compared with its key" limit)
("teaching/worksheet/answer-bounds.rkt"
 "(define longest-symbol 60)"
 "(define longest-symbol 61)"
 "from how many letters on a name is none" limit)
("teaching/worksheet/extra-motions.rkt"
 "(and x (< (abs x) 1e6))))"
 "(and x (< (abs x) 2000000.0))))"
 "how great an acceleration is taken for a singular one" limit)
("teaching/class/collect-answers.rkt"
 "[(> cost (if (null? parts) longest-start seconds)) (ended 'late)]"
 "[(>= cost (if (null? parts) longest-start seconds)) (ended 'late)]"
 "a cost that equals the seconds granted to the bit" limit)
("teaching/class/collect-answers.rkt"
 "(let loop ([parts '()] [size 0] [start start] [now start])"
 "(let loop ([parts '()] [size 1] [start start] [now start])"
 "one byte less of what may be written" limit)
("teaching/class/within-limits.rkt"
 "(define first-event (sync/timeout pulse worker full))"
 "(define first-event (sync/timeout pulse full full))"
 "that the work has ended is seen a tenth of a second later" limit)
("teaching/class/within-limits.rkt"
 "(unless (ends-within? worker seconds (make-custodian-box full #t)) (stop-thread worker))"
 "(unless (ends-within? worker seconds (make-custodian-box full #f)) (stop-thread worker))"
 "the box is waited for as an event, and its content looked at by nobody")
("teaching/class/likeness.rkt"
 "(if (>= (string-length text) 25)"
 "(if (> (string-length text) 25)"
 "from which length on the words of a reason are somebody's own" limit)
("teaching/class/isolation.rkt"
 "(define i (isolation megabytes seconds prlimit? nobody? level folder (box #f)))"
 "(define i (isolation megabytes seconds prlimit? nobody? level folder (box #t)))"
 "works? puts an evaluator into the box before anybody looks, or the isolation is dropped")
("teaching/class/isolation.rkt"
 "(isolation megabytes seconds #f #f 'own #f (box #f))))"
 "(isolation megabytes seconds #f #t 'own #f (box #f))))"
 "whether it is nobody is asked where there are limits, or another level, and here is neither")
("show/display/formula-snip.rkt"
 "(max 1 (steps (drawing-height (present-drawing)))))"
 "(max 2 (steps (drawing-height (present-drawing)))))"
 "in how many steps an editor scrolls past a low formula" layout)
("show/display/formula-drawing.rkt"
 "(define p (inset (formula->pict f (* larger letter-size)) 0 margin))"
 "(define p (inset (formula->pict f (* larger letter-size)) 1 margin))"
 "the space beside a drawn formula" layout)
("teaching/class/grade.rkt"
 "(cond [found (values found 0)]"
 "(cond"
 "an answer that others gave, too, is judged again, to the same judgment: time" limit)
("teaching/class/submission.rkt"
 "(string-append (make-string (max 0 (- 12 (string-length digits))) #\\0) digits))"
 "(string-append (make-string (max 0 (- 13 (string-length digits))) #\\0) digits))"
 "up to how many digits a number in a name is taken for one, when submissions are put in order" limit)
("teaching/class/grade.rkt"
 "(define seats (make-semaphore (max 1 (min 4 (processor-count)))))"
 "(define seats (make-semaphore (max 1 (max 4 (processor-count)))))"
 "how many submissions are run at once: on four processors or more, as many or more" limit)
("teaching/class/collect-answers.rkt"
 "[(> (+ size n) most-output) (ended 'long)]"
 "[(>= (+ size n) most-output) (ended 'long)]"
 "a bound of the output, a byte lower" limit)
("calculus/derivative.rkt"
 "(derivative procedure mask make-datum base path order))))"
 "(derivative procedure mask make-datum base order order))))"
 "a derivative of a derivative is taken one inside the other: the same value, with more work" limit)
("value/matrix/division-free.rkt"
 "(min most-products (quotient (expt n 4) 2)))))"
 "(min most-products (quotient (expt n 4) 3)))))"
 "an estimate of work: it tells by which formulas a determinant is computed, not what it is" limit)
("value/matrix/perturbed-system.rkt"
 "(define (many-rows? A) (> (vector-length A) longest-formula))"
 "(define (many-rows? A) (>= (vector-length A) longest-formula))"
 "from how many rows on derivatives are taken of the system, and not of its formula" limit)
("value/matrix/surd.rkt"
 "(define more (max 0 (- 128 (quotient (integer-length n) 2))))"
 "(define more (max 0 (- 129 (quotient (integer-length n) 2))))"
 "a bit more than the 128 of which a flonum keeps 53" limit)
("search/minimum-near.rkt"
 "[(or (not better?) (= round most-rounds)) (judged t e* o all)]"
 "[(and (not better?) (= round most-rounds)) (judged t e* o all)]"
 "a search that found nothing better is asked again up to the guard; the best is kept" limit)
("search/minimum-between.rkt"
 "(define x (if (= k n) (real->double-flonum high) (+ low (* step (+ k shift)))))"
 "(define x (if (= k n) (real->double-flonum high) (+ low (* step (- k shift)))))"
 "samples are shifted the other way, and keep out of step with a periodic function as well" limit)
("search/minimum-between.rkt"
 "(define shift (if (< 0 k n) (* 0.4 (- (spread-fraction k) 0.5)) 0.0))"
 "(define shift (if (< 0 k n) (+ 0.4 (- (spread-fraction k) 0.5)) 0.0))"
 "samples are shifted further, in order still, and keep out of step as well" limit)
("search/find-root.rkt"
 "(define-plain (newton-search f start [tolerance 1e-12]"
 "(define-plain (newton-search f start [tolerance 2e-12]"
 "Newton's method doubles its digits: it ends as far below either tolerance" limit)
("constraint/accelerations.rkt"
 "(unary-function (apply call-datum who L (gather who constraints) (force->datum Q)) (state)"
 "(unary-function (apply call-datum who L (gather constraints constraints) (force->datum Q)) (state)"
 "the constraints have been gathered before: nothing is left to complain of by that name")
("constraint/constrained-motion.rkt"
 "(+ x (* 1e-3 (+ 1 (abs x)) (spread-fraction k))))))"
 "(+ x (* 1e-3 (+ 2 (abs x)) (spread-fraction k))))))"
 "how far beside a state constraints are tried: at any place they depend on each other as at most" limit)
("compile/program-builder.rkt"
 "(define greatest-unrolled 64)"
 "(define greatest-unrolled 65)"
 "up to which exponent a power is written as products: its value is the same" limit)
("compile/program-builder.rkt"
 "[else (< (place-index x) (place-index y))]))"
 "[else (<= (place-index x) (place-index y))]))"
 "two operands at one place are the same in either order")
("question/stability.rkt"
 "(when (and (refuted? v) (> (magnitude (verdict-value v)) 1e-8))"
 "(when (and (refuted? v) (> (magnitude (verdict-value v)) 2e-8))"
 "up to which size a force by rounding is none" limit)
("hamiltonian/equation-solver.rkt"
 "[(independent? slopes x) 'exactly]"
 ""
 "what is linear is solved by the formula that solves what is not: the same value, with more work" limit)
("question/refined-modes.rkt"
 "(define least (apply min 1 (filter positive? (map abs squares))))"
 "(define least (apply min 2 (filter positive? (map abs squares))))"
 "how far beside a square of frequency a system is solved that has none at it" limit)
("question/refined-modes.rkt"
 "[(> (vector-length K) most-rows) found]"
 "[(>= (vector-length K) most-rows) found]"
 "a bound of the work, one row lower: digits lost beside fast modes are sought again in matrices of fewer rows" limit)
("certificate/kernel-facts.rkt"
 "(term d ns 2) (term e ns))"
 "(term d ns 3) (term e ns))"
 "a product that is a divisor stands in parentheses within a proof" layout)
("certificate/Coq-term.rkt"
 "(define-values (sum product power atom) (values 1 2 3 4))"
 "(define-values (sum product power atom) (values 1 2 3 5))"
 "levels are compared, and the last is the greatest with either number")
("certificate/conserved-theorem.rkt"
 "(proof M stated proved relations ns along)"
 "(proof M proved proved relations ns along)"
 "the first part of the proof has facts that only the second uses" layout)
("show/plot/window.rkt"
 "(define (loaded?) #t)"
 "(define (loaded?) #f)"
 "it is called in order that its module be loaded; nobody looks at its value")
("show/plot/phase-portrait.rkt"
 "(lambda (a b) (< (abs (- a b)) (* 1e-9 (+ 1.0 (abs a)))))))"
 "(lambda (a b) (<= (abs (- a b)) (* 1e-9 (+ 1.0 (abs a)))))))"
 "two energies differ by just the bound in no portrait" limit)
("show/plot/phase-portrait.rkt"
 "(define most-steps 30)"
 "(define most-steps 31)"
 "one step more of Newton's method for a place of rest" limit)
("show/plot/frame.rkt"
 "(lambda () (values (frame 0 1 0 1) void))))  ; never in a cycle"
 "(lambda () (values (frame 0 1 0 2) void))))  ; never in a cycle"
 "nothing that a frame holds holds the frame: it is not asked for")
("show/plot/plot-images.rkt"
 "(define (times cells length) (max 1 (exact-round (/ (* fineness length) cells))))"
 "(define (times cells length) (max 1 (exact-round (/ (+ fineness length) cells))))"
 "cells are enlarged into more pixels than the picture has" layout)
("show/plot/chaos-map.rkt"
 "(define regular (log (max n 2) 10))"
 "(define regular (log (max n 3) 10))"
 "the colours of a map of two steps are those of one of three" limit)
("show/plot/picture-page.rkt"
 "(unless (= scale 1) (send dc set-scale scale scale))"
 "(unless (= scale 1) (send dc scale scale scale))"
 "the scale of a fresh drawing is one, which a factor and a new value change alike")
("show/animation/player.rkt"
 "(send (player-timer p) start (performance-pause (player-performance p)) #t))"
 "(send (player-timer p) start (performance-pause (player-performance p)) #f))"
 "each picture starts the timer anew, or stops it, before it could ring twice")
("show/animation/drawing.rkt"
 "(define bounds (extent (filter (lambda (s) (not (lettering? s))) shapes) +inf.0))"
 "(define bounds (extent (filter (lambda (s) (not (lettering? s))) shapes) 1.0))"
 "a sketch is smaller by its margin" layout)
("show/animation/pict-recorder.rkt"
 "(define-values (wide high) (values (max 1 (exact-ceiling w)) (max 1 (exact-ceiling h))))"
 "(define-values (wide high) (values (max 2 (exact-ceiling w)) (max 1 (exact-ceiling h))))"
 "a section of a bitmap that is narrower than a pixel is two wide" layout)
("show/animation/formats.rkt"
 "(vl-append 4"
 "(vl-append 5"
 "the time of a picture stands a pixel lower" layout)
("show/animation/scenery.rkt"
 "(values (if back (index (- now (* forward back))) 0) (index now)))"
 "(values (if back (index (- now (* forward back))) 1) (index now)))"
 "the trail of the whole motion lacks its first piece, a share of one picture" layout)
("show/interact/interaction-window.rkt"
 "(regexp-replace* #rx\"&\" (if (> (string-length text) 99) (substring text 0 99) text) \"\\\\&\\\\&\"))"
 "(regexp-replace* #rx\"&\" (if (> (string-length text) 100) (substring text 0 99) text) \"\\\\&\\\\&\"))"
 "a label of 100 letters is shown whole; 200 may be" limit)
("show/interact/interaction-window.rkt"
 "(when bitmap (send (get-dc) draw-bitmap bitmap 0 0)))"
 "(when bitmap (send (get-dc) draw-bitmap bitmap 1 0)))"
 "the picture is a pixel further to the right in its window" layout)
("show/interact/outcome-picture.rkt"
 "(define (line l) (if (string=? l \"\") (blank 1 12) (text l 'modern 12)))"
 "(define (line l) (if (string=? l \"\") (blank 2 12) (text l 'modern 12)))"
 "an empty line among words is a pixel broader" layout)
("show/interact/outcome-picture.rkt"
 "(define (line l) (if (string=? l \"\") (blank 1 12) (text l 'modern 12)))"
 "(define (line l) (if (string=? l \"\") (blank 1 13) (text l 'modern 12)))"
 "an empty line among words is a pixel higher" layout)
("show/interact/outcome-picture.rkt"
 "(inset (apply vl-append 2 (map line lines)) margin))"
 "(inset (apply vl-append 3 (map line lines)) margin))"
 "lines of words are a pixel further apart" layout)
("show/interact/interaction-window.rkt"
 "(new message% [parent row] [label (number-label (control-start c))] [min-width 90]))"
 "(new message% [parent row] [label (number-label (control-start c))] [min-width 91]))"
 "the number beside a slider has a pixel more room" layout)
("show/interact/outcome-picture.rkt"
 "1 (vector 1 0 0 1 0 0)))"
 "1 (vector 1 0 0 1 0 1)))"
 "an image of many points is a pixel lower" layout)
("show/interact/outcome-picture.rkt"
 "1 (vector 1 0 0 1 0 0)))"
 "1 (vector 1 0 0 1 1 0)))"
 "an image of many points is a pixel further to the right" layout)
("show/interact/outcome-picture.rkt"
 "(image-element (pict->bitmap picture) 0 0 (pict-width picture) (pict-height picture)"
 "(image-element (pict->bitmap picture) 1 0 (pict-width picture) (pict-height picture)"
 "an image of many points is a pixel further to the right" layout)
("show/interact/interaction-window.rkt"
 "(define (window-loaded?) #t)"
 "(define (window-loaded?) #f)"
 "to call it loads the file; what it returns is asked by nobody")
("show/interact/interaction-window.rkt"
 "(let again ([values #f] [outcome #f])"
 "(let again ([values #t] [outcome #f])"
 "the values of a window are a list, which no boolean is")
("show/explorer/explorer-board.rkt"
 "(send dc set-pen \"gray\" 1 'short-dash)"
 "(send dc set-pen \"gray\" 2 'short-dash)"
 "the width of the dashes around what the mouse selects" layout)
("show/explorer/explorer-board.rkt"
 "(set-board-fresh?! b #t))"
 "(set-board-fresh?! b #f))"
 "pixels are copied at each painting, though none has changed: time" limit)
("show/explorer/explore-in-window.rkt"
 "(send dc set-pen \"gray\" 1 'solid)"
 "(send dc set-pen \"gray\" 2 'solid)"
 "what was drawn before is drawn thicker" layout)
("show/explorer/explorer-board.rkt"
 "(define-values (left right top bottom) (values 56 12 12 28))"
 "(define-values (left right top bottom) (values 57 12 12 28))"
 "there is a pixel more beside the axis" layout)
("show/explorer/explorer.rkt"
 "(new message% [parent window] [label keys-text] [stretchable-width #t]))"
 "(new message% [parent window] [label keys-text] [stretchable-width #f]))"
 "the line of the keys is no broader than its words" layout)
("show/explorer/explorer.rkt"
 "(define row (new horizontal-panel% [parent window] [stretchable-height #f] [border 2]))"
 "(define row (new horizontal-panel% [parent window] [stretchable-height #f] [border 3]))"
 "there is a pixel more around the buttons" layout)
("show/explorer/explorer-board.rkt"
 "(max 20 (- width left right)) (max 20 (- height top bottom))))"
 "(max 20 (- width left right)) (max 21 (- height top bottom))))"
 "the least height of the picture in a tiny window" layout)
("show/explorer/explorer-board.rkt"
 "(drag! b #f #f)"
 "(drag! b #f #t)"
 "what is dragged is drawn where both of its ends are known, and only there")
("show/explorer/explorer-board.rkt"
 "(< (abs (- (cdr start) (cdr end))) least-drag))"
 "(<= (abs (- (cdr start) (cdr end))) least-drag))"
 "a drag of just five pixels is a click" limit)
("show/explorer/explorer-board.rkt"
 "(define b (board exploration background on-point on-zoom #f #f #f #f #f #f))"
 "(define b (board exploration background on-point on-zoom #f #f #f #t #f #f))"
 "a board that has no pixels draws them before it is painted, and these are not fresh")
("show/explorer/explore-map.rkt"
 "(if (= first 0) x-min (edge (at first) (at (- first 1))))"
 "(if (= first 0) x-min (edge (at first) (at (- first 2))))"
 "the first halving gives the other's place without an image: one of thirty less" limit)
("compile/program-builder.rkt"
 "[(and (number? y) (not (eqv? y 0)) (reciprocal-fits? (/ 1 y) y)) (multiply! b (/ 1 y) x)]"
 "[(and (number? y) (not (eqv? y 1)) (reciprocal-fits? (/ 1 y) y)) (multiply! b (/ 1 y) x)]"
 "a function that divides by an exact 0 is evaluated, not compiled: the same value, slower" limit)
("compile/jet/jet-degrees.rkt"
 "(for/fold ([w (work 0 0 0 0 coded?)])"
 "(for/fold ([w (work 0 0 1 0 coded?)])"
 "an estimate of work: it tells which of two ways is taken, not what comes out" limit)
("compile/jet/jet-linear-combinations.rkt"
 "(if (or (> c 0) (integer? n))"
 "(if (or (> c 1) (integer? n))"
 "a multiple by 0 to 1 is a quantity of its own before its root is taken: the same value, an operation more" limit)
("compile/jet/jet-operation-recurrences.rkt"
 "(not (equation-leading e))"
 "(equation-leading e)"
 "a sine and its cosine are found one after the other, not in one loop: the same values, slower" limit)
("constraint/constrained-code.rkt"
 "(define-values (positions velocities) (positions-and-velocities who cs state))"
 "(define-values (positions velocities) (positions-and-velocities cs cs state))"
 "the name is for complaints of values that have been looked at before, at this very state")
("constraint/constrained-motion.rkt"
 "(define c (constrained-code who L cs outside kept ready state))"
 "(define c (constrained-code L L cs outside kept ready state))"
 "the name is for complaints of values that were looked at before, at this very state")
("compile/flonum-coefficients.rkt"
 "(define (moderate? c) (<= 1e-60 (abs c) 1e60))"
 "(define (moderate? c) (< 1e-60 (abs c) 1e60))"
 "up to which size a coefficient is combined with others: the values are the same" limit)
("algebra/solve/solve-by-cases.rkt"
 "(define most-cases 4)"
 "(define most-cases 5)"
 "one absolute value more is taken apart" limit)
("algebra/presentation/form.rkt"
 "(form (+ (form-size (car d)) (if (eqv? 1 (cdr d)) 0 2))"
 "(form (+ (form-size (car d)) (if (eqv? 1 (cdr d)) 2 0))"
 "nobody asks for the size of a form with divisors")
("algebra/presentation/waves.rkt"
 "(< (size product) (+ 1 (size w) (size v)))"
 "(<= (size product) (+ 1 (size w) (size v)))"
 "of two forms of one size the product" layout)
("algebra/presentation/form.rkt"
 "(if (< (form-size other) (form-size usual)) other usual))"
 "(if (<= (form-size other) (form-size usual)) other usual))"
 "of two forms of one size the other" layout)
("algebra/presentation/waves.rkt"
 "(+ (if (negative? x) 1 0) (if (eqv? 1 (abs x)) 0 1)))"
 "(+ (if (negative? x) 1 0) (if (eqv? 1 x) 0 1)))"
 "a wave of amplitude −1 counts as longer by one where forms are chosen" layout)
("compile/compile-function.rkt"
 "(define numbers (example->flvector who example))"
 "(define numbers (example->flvector example example))"
 "the example has been looked at before, under the right name")
("scale/data/NPY.rkt"
 "(bytes-append magic (bytes 3 0) (integer->integer-bytes (bytes-length content) 4 #f #f) content))"
 "(bytes-append magic (bytes 3 0) (integer->integer-bytes (bytes-length content) 4 #t #f) content))"
 "the head of a file is shorter than numbers of 32 bits with a sign reach")
("numeric/Fourier.rkt"
 "(define count (max 1 (quotient n 2)))"
 "(define count (max 2 (quotient n 2)))"
 "tables for one node or two have an entry more, which nobody asks for")
("numeric/Fourier.rkt"
 "(if (and (> bit 0) (> (bitwise-and j bit) 0))"
 "(if (and (> bit 0) (> (bitwise-and j bit) 1))"
 "the lowest bit is carried after the last number alone, when nobody asks for the next")
("generic/rounding.rkt"
 "(cond [(real? simple) (numeric simple)]"
 "(cond"
 "the bounds of a number are the number: the same value, a little later" limit)
("generic/arithmetic.rkt"
 "(cond [(number? a) (- a)]"
 "(cond"
 "a product by -1 is the same number, a little later" limit)
("generic/operation-rule/branches.rkt"
 "(note x (cond [(> c 0) 1] [(< c 0) -1] [else 0]) (lambda (one other) 0)))))"
 "(note x (cond [(> c 1) 1] [(< c 0) -1] [else 0]) (lambda (one other) 0)))))"
 "a place more is looked at, where nothing jumps" limit)
("teaching/derivation/derivations.rkt"
 "(make-step '(* lambda ((partial 1) constraint)) force (verify-equal equations force))))"
 "(make-step '(* lambda ((partial 1) constraint)) force (verify-equal force force))))"
 "the two are equal, as the line says: no derivation tells that they are not compared")
("teaching/derivation/derivations.rkt"
 "(g:+ (((partial 0) H) state)"
 "(g:- (((partial 0) H) state)"
 "the other terms cancel: that is what the derivation shows")
("lang/help/document.rkt"
 "(define in-lesser-title 20)    ; of names rarely meant"
 "(define in-lesser-title 21)    ; of names rarely meant"
 "of two findings with as many words the order may be another where names are rarely meant" limit)
("lang/help/program-documents.rkt"
 "(if lesser? 4 10)))"
 "(if lesser? 5 10)))"
 "a figure or worksheet comes earlier among findings that are nearly as good" limit)
("lang/command/program-systems.rkt"
 "(define most-motions 500)"
 "(define most-motions 501)"
 "of a program that makes so many systems one more is told" limit)
