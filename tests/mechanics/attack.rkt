#lang racket/base
;; A small attack on every class, always the same; and the judge itself, judged.
;;
;; `make attack` makes a large one (attack/main.rkt).

(require "support/checks.rkt"
         "attack/classes/all.rkt" "attack/claims.rkt" "attack/disguise.rkt" "attack/known.rkt"
         "attack/shrink.rkt" "attack/statement.rkt" "attack/table.rkt" "attack/worker.rkt"
         "attack/judge/boxes.rkt" "attack/judge/evaluate.rkt" "attack/judge/fault.rkt"
         "attack/judge/fixed.rkt" "attack/judge/flonum.rkt" "attack/judge/interval.rkt"
         "attack/judge/judge.rkt" "attack/judge/matter.rkt" "attack/judge/motion.rkt"
         "attack/judge/point.rkt" "attack/judge/quadrature.rkt" "attack/judge/refutation.rkt"
         "support/random.rkt")

;; ---------------------------------------------------------------------------
;; The evaluator

(define digits
  '(((exp 1) 2.718281828459045) ((log 10) 2.302585092994046) ((sin 10) -0.5440211108893698)
    ((cos -3) -0.9899924966004454) ((atan 7) 1.4288992721907328) ((asin 1) 1.5707963267948966)
    ((acos -1/2) 2.0943951023931957) ((atan 1 -1) 2.356194490192345)
    ((tanh 1/2) 0.46211715726000973) ((asinh -2) -1.4436354751788103)
    ((acosh 3) 1.7627471740390859) ((atanh 1/3) 0.34657359027997264)
    ((expt 2 1/3) 1.2599210498948732) ((expt 5 -3/4) 0.29906975624424414)
    ((sqrt 2) 1.4142135623730951)
    ((sinh 3) 10.017874927409903)
    ((tan 1) 1.5574077246549023) ((erf 1/2) 0.5204998778130465) ((erf -3) -0.9999779095030014)
    ((abs -3) 3.0) ((sgn -1/9) -1.0)))

(define nowhere (make-point (hasheq) 0))
(define (value e A) (value-at e nowhere A))

(test-case "values are right to the digits of a flonum, in either arithmetic"
  (for* ([entry (in-list digits)] [A (list flonum-intervals (fixed-intervals 100))])
    (define v (value (car entry) A))
    (check-true (value? v) (format "~s" entry))
    (check-= (/ (exact->inexact (value->exact v A)) (cadr entry)) 1 1e-13 (format "~s" entry))))

(test-case "arithmetics agree, and more digits lie within fewer"
  (define few (fixed-intervals 100))
  (define many (fixed-intervals 400))
  (define (within? inner outer)
    (and (<= (/ (interval-low outer) (expt 2 100)) (/ (interval-low inner) (expt 2 400)))
         (<= (/ (interval-high inner) (expt 2 400)) (/ (interval-high outer) (expt 2 100)))))
  (with-seeds 40
    (define q (abs (random-rational)))
    (for ([f (in-list '(exp log sin cos atan sqrt sinh asinh))])
      (define e (list f (list '+ q '(exp 1))))
      (define-values (u v) (values (value e few) (value e many)))
      (check-true (within? v u) (format "~s" e))
      (check-false (apart? (value e flonum-intervals)
                           (interval (exact->inexact (/ (interval-low u) (expt 2 100)))
                                     (exact->inexact (/ (interval-high u) (expt 2 100)))))))))

(test-case "there is no value where a part is not real"
  (for ([e (in-list '((sqrt -1) (log 0) (log -2) (asin 2) (expt -8 1/3) (/ 1 0) (* 0 (log -1))
                      (atanh 1) (acosh 0) (sqrt (- (cos 1) 2)) (atan 0 0) (expt 0 -1/2)))])
    (for ([A (list flonum-intervals (fixed-intervals 100))])
      (check-true (no-value? (value e A)) (format "~s" e)))))

(test-case "what is too close to tell is not told"
  (check-true (too-hard? (value '(sqrt (- (square (sin 1)) (square (sin 1)))) flonum-intervals)))
  (check-equal? (value '(sqrt (- 9/4 2 1/4)) flonum-intervals) 0))

(test-case "what is less than a unit of the scale has a value with more digits"
  (for ([e (in-list '((log 1/1000000000000) (/ (exp 1) 1/1000000000000)))])
    (check-true (too-hard? (value e (fixed-intervals 20))) (format "~s" e))
    (check-true (value? (value e (fixed-intervals 60))) (format "~s" e))))

(test-case "the derivative of a literal function is that of its polynomial"
  (define (V x) (value `(V ,x) flonum-intervals))
  (define h 1/1000000)
  (check-= (/ (- (V (+ 2 h)) (V (- 2 h))) (* 2 h)) (value '((D V) 2) flonum-intervals) 1e-6)
  (check-equal? (value '(((* (partial 0) (partial 1)) F) 1/2 3) flonum-intervals)
                (value '(((* (partial 1) (partial 0)) F) 1/2 3) flonum-intervals)))

(test-case "a question without a point is found to be so"
  (check-true (empty? '((sqrt (- x (exp x)))) '()))
  (check-true (empty? '((log (- (cos y) 2)) (log (- y z))) '()))
  (check-true (empty? '((sqrt (- 1 x))) '((> x 2))))
  (check-false (empty? '((sqrt (- x 1))) '((< x 2)))))

;; ---------------------------------------------------------------------------
;; The judge

(define (kind-of judgement) (if (fault? judgement) (fault-kind judgement) judgement))
(define (proof left right [given '()] [assumed '()])
  (kind-of (judge-proof left right given assumed '())))
(define (refutation left right witness [given '()])
  (kind-of (judge-refutation left right given '() witness)))
(define (form e simple [given '()] [assumed '()])
  (kind-of (judge-simplified e simple given assumed '())))

(define turned '(sqrt (/ 1 (sqrt (- 1 x)))))

(test-case "right and wrong proofs are told apart"
  (with-seed 1
    (check-false (proof turned '(/ 1 (expt (- 1 x) 1/4))))
    (check-equal? (proof turned '(/ -1 (expt (- 1 x) 1/4))) 'values-differ)
    (check-equal? (proof '(sin x) '(+ (sin x) (/ (exp x) 1000000000000000000000))) 'values-differ)
    (check-equal? (proof turned '(/ -1 (expt (- 1 x) 1/4)) '() '((>= (- x 1) 0)))
                  'assumptions-hold-nowhere)
    (check-false (proof '(sqrt (square x)) '(- x) '() '((<= x 0))))
    (check-false (proof '(sqrt (square x)) '(- x) '((< x 0))))
    (check-equal? (proof '(sqrt (- (cos x) 2)) '(sqrt (- (cos x) 2))) 'nowhere-defined)
    (check-equal? (proof '(V (+ x x)) '(V x)) 'values-differ)
    (check-false (proof '(V (+ x x)) '(V (* 2 x))))))

(test-case "relations that hold together at few points are not taken for none"
  (for ([seed (in-range 1 9)])
    (with-seed seed
      (check-false (form '(sqrt (square (* y a))) '(* a y)
                         '((<= (+ y z) 0) (< x 0) (< (- a 1) 0)) '((>= y 0) (>= a 0)))))))

(test-case "nor where the way there from one point is blocked"
  (for ([seed (in-range 20)])
    (with-seed seed
      (check-false (proof '(sqrt (square x)) '(- x) '()
                          '((> (* x y) 50) (< (+ x y) -9) (< (abs (- y z)) 1/9) (> z -4))))
      (check-false (proof '(sqrt (square x)) 'x '()
                          '((> (* x y z) 3) (< y -1) (< (+ z 3) 0) (> (+ x y z) 1) (< x 50)))))))

(test-case "right and wrong refutations are told apart"
  (with-seed 1
    (check-false (refutation '(sqrt x) '(- (sqrt x)) '((x . 2))))
    (check-equal? (refutation '(/ 1 (sqrt x)) '(sqrt (/ 1 x)) '((x . -1))) 'no-value-at-witness)
    (check-equal? (refutation '(square x) 'x '((x . 1))) 'no-difference-at-witness)
    (check-equal? (refutation '(sin (* 2 x)) '(* 2 (sin x) (cos x)) '((x . 3)))
                  'no-difference-at-witness)
    (check-equal? (refutation '(abs x) 'x '((x . -1)) '((> x 0))) 'witness-outside-given)
    (check-equal? (refutation '(V (* 1/2 q)) '(V (/ q 2))
                              '((q . 2) ((V (* 1/2 q)) . 1) ((V (/ q 2)) . 2)))
                  'function-of-two-values)
    (check-false (refutation '(V x) '(V (* 2 x)) '((x . 1) ((V x) . 1) ((V (* 2 x)) . 2))))
    (check-equal? (refutation '(sgn (- (asinh x) (log (+ x (sqrt (+ 1 (square x))))))) 0 '((x . 1)))
                  'no-difference-at-witness)))

(test-case "right and wrong forms are told apart"
  (with-seed 1
    (check-false (form '(sqrt (square x)) 'x '() '((>= x 0))))
    (check-false (form '(- (* 1e-18 x) x) '(- x)))
    (check-equal? (form '(- (* 1e-3 x) x) '(- x)) 'values-differ)
    (check-equal? (form '(sqrt (square x)) 'x) 'values-differ)
    (check-equal? (form '(sqrt (square x)) 'x '((< x 0)) '((>= x 0))) 'assumptions-hold-nowhere)
    (check-equal? (form '(sqrt (- 2 (cos x))) '(sqrt (- (cos x) 2))) 'result-nowhere-defined)))

(test-case "paths that turn or jump are told from smooth ones"
  (check-equal? (kink-near '(+ t (abs (- t 1))) '(0 1)) 1)
  (check-equal? (kink-near '(* 5 (sgn t)) '(0)) 0)
  (check-equal? (kink-near '(/ (square t) t) '(0)) 0)
  (check-false (kink-near '(* (sgn t) (abs t)) '(0 1)))
  (check-true (< (residual-size '(cos t) 'oscillator 1/7) 1e-15))
  (check-true (> (residual-size '(cos t) 'none 1/7) 0.9)))

(test-case "integrals are right to 28 digits, and poles on the path are noticed"
  (define (integral e low high [numbers (hasheq)]) (integral-value e low high numbers))
  (define (digits x) (round (* x (expt 10 28))))
  (check-equal? (digits (integral '(exp x) 0 1)) 17182818284590452353602874714)
  (check-equal? (digits (integral '(/ 1 (sqrt x)) 0 1)) (* 2 (expt 10 28)))
  (check-equal? (digits (integral '(abs (- x a)) 1 0 (hasheq 'a 1/3)))
                (round (* -5/18 (expt 10 28))))
  (check-equal? (digits (integral '(asin (sin x)) 0 5)) 8232822662807848530425481670)
  (for ([e (in-list '((/ 1 x) (/ 1 (square x)) (/ 1 (- 1 (cos x))) (tan (- x 2))))])
    (check-equal? (integral e -1 1) 'infinite (format "~s" e)))
  (check-equal? (integral '(sqrt (- a (square x))) -1 1 (hasheq 'a 1/2)) 'none))

(define (matter kind . parts) (cons kind parts))
(define (judged m status [assumed '()] [witness #f] [found #f])
  (with-seed 1 (kind-of (judge-matter m status assumed witness found))))

(test-case "false formulas of integrals are noticed, and true ones are not"
  (define pole (matter 'integral '(/ 1 (- x a)) 0 'b #f '(log (abs (/ (- b a) a)))))
  (check-equal? (judged pole 'proved) 'no-integral)
  (check-false (judged pole 'proved '((> (* a (- a b)) 0))))
  (define sign (matter 'integral '(sqrt (square x)) 0 'b #f '(* 1/2 (square b))))
  (check-equal? (judged sign 'proved) 'values-differ)
  (check-false (judged sign 'proved '((> b 0))))
  (check-false (judged sign 'refuted '() '((b . -1))))
  (check-equal? (judged sign 'refuted '() '((b . 1))) 'no-difference-at-witness)
  (define slope (matter 'integral '(abs (- x a)) 0 'b 'b #f))
  (check-equal? (judged slope 'found '() #f '(- b a)) 'values-differ)
  (check-false (judged slope 'found '() #f '(abs (- b a)))))

(test-case "factors that vanish are noticed where they count"
  (define (same one two) (matter 'equivalent one two '(x) '(v)))
  (define oscillator '(- (square v) (square x)))
  (check-equal? (judged (same oscillator `(* (- a b) ,oscillator)) 'proved) 'motions-differ)
  (check-false (judged (same oscillator `(* (- a b) ,oscillator)) 'proved '((> (abs (- a b)) 0))))
  (check-equal? (judged (same '(square v) '(+ (* 3 (square v)) (* x v))) 'refuted)
                'no-difference-at-witness)
  (define (kept L Q) (matter 'conserved L Q '(x) '(v)))
  (check-equal? (judged (kept '(* c (square v)) 'v) 'proved) 'motions-differ)
  (check-false (judged (kept '(* c (square v)) '(* c v)) 'proved))
  (check-false (judged (kept '(* c (square v)) 'v) 'refuted '() '((c . 0)))))

(test-case "jumps and kinks on surfaces are noticed where values stay bounded"
  (define (there e) (matter 'smooth (list e '((x . 0) (v . 2)) '(x v))))
  (for ([e (in-list '((sgn x) (sqrt (+ (square x) (square (* x v)))) (sgn (abs x))
                      (sqrt (- 1 (cos x))) (/ (abs x) x) (atan (/ 1 x))))])
    (check-equal? (judged (there e) 'proved) 'not-smooth (format "~s" e)))
  (for ([e (in-list '((/ 1 (abs x)) (log (abs x)) (/ (sin x) x)
                      (sqrt (+ (square x) (square v))) (cube (abs x)) (sqrt x)))])
    (check-false (judged (there e) 'proved) (format "~s" e))))

(test-case "answers without a real value are noticed"
  (check-equal? (judged '(domain (log (- -1 (square x)))) 'proved) 'nowhere-defined)
  (check-false (judged '(domain (log (- 1 (square x)))) 'proved))
  (check-equal? (judged '(domain (sqrt x)) 'refuted '() '((x . -1))) 'no-value-at-witness)
  (check-equal? (judged '(found (atanh x)) 'found '() #f '((1/2 ()) (2 ()))) 'nowhere-defined))

(test-case "sound rewrites keep values"
  (with-seeds 300
    (define e '(/ (+ (sin (* x y)) (square (- x (exp y)))) (+ 2 (cos x))))
    (define r (disguised e 3))
    (check-false (fault? (judge-proof e r '() '() '())) (format "~s" r))))

(test-case "a wrong claim is shrunk to one that is wrong in the same way"
  (define o (claim-again 'equal (statement '(+ (sqrt (square x)) (* y (sin y)))
                                           '(+ x (* (sin y) y)) '((< x y 0)) '())))
  (check-pred outcome? (shrunk (struct-copy outcome o [judgement (fault 'made-up #f #f #f)]))))

;; ---------------------------------------------------------------------------
;; The library

(define subjects 25)

(for ([class (in-list class-names)])
  (test-case (format "claims of the class ~a are right, but for known faults" class)
    (define t (make-table))
    (for ([k (in-range subjects)])
      (define report (report-on class 1 k (make-hash)))
      (table-add! t report)
      (define kinds (filter wrong-judgement? (map cdr (caddr report))))
      (for ([kind (in-list kinds)] [program (in-list (cdddr report))])
        (check-true (and (known-fault? class kind) #t) (format "~a\n~a" kind program))))
    (when (> (table-wrong t) 0)
      (printf "~a: ~a of ~a claims have known faults\n" class (table-wrong t) (table-claims t)))))
