#lang racket/base
;; Conditions for F(high) − F(low) to be the integral of e, of which F is an antiderivative.
;;
;; F must be continuous on the whole path of x, from low to high: divisors in F, and arguments u
;; of logarithms, signs and, as cos v, of tan v, have no zero there.  That u has none is
;; known from its sign, or told by relations between the ends and the parameters:
;;
;;   u a line in x, or monotone        u(low) u(high) > 0
;;   u = sin v or cos v, v a line      the same, and |v(high) − v(low)| < π
;;   u = a + b with a root in b        a² − b² has no zero
;;   u = a + b sin v or a + b cos v    a² − b² > 0
;;   u quadratic, with roots r         as for the lines x − r
;;
;; Of anything else nothing can be told, and there is no formula.  A condition never speaks of x,
;; which has no meaning outside its integral.  Grounds of F' = e must hold on the path, too.
;; That radicands are not negative there is left to the integrand, which has no value where they
;; are; where that is known there is no formula.
;;
;; A divisor of F and not of e is not 0 either, as k in the integral of e^(kx), n + 1 in that of xⁿ,
;; a − b in that of sin ax sin bx.
;;
;; A condition is a relation as `assume` takes it; that u is not 0 is (> (abs u) 0).

(require racket/list
         "expression-function.rkt" (only-in "known-antiderivatives.rkt" linear-in)
         (only-in "../algebra/assumption/assumption-set.rkt" with-automatic-assumptions)
         "../algebra/expression/expression.rkt" "../algebra/expression/nodes.rkt"
         "../algebra/expression/operation.rkt" "../algebra/expression/pi.rkt"
         "../algebra/expression/read.rkt"
         (only-in "../algebra/expression/simplifier.rkt" left-unexpanded?)
         "../algebra/expression/substitute.rkt" "../algebra/expression/symbols.rkt"
         "../algebra/solve/nonzero-conditions.rkt" (only-in "../algebra/solve/root.rkt" applied)
         "../algebra/simplify/declare-relations.rkt" "../algebra/simplify/known-sign.rkt"
         "../algebra/simplify/simplify-expression.rkt"
         "../algebra/zero/zero-test.rkt" "../error/failure.rkt")

(provide between-ends integral-conditions-of continuous-logarithms jumps-between? proved-zero?)

;; x : the variable, which goes from low to high
;; A : assumptions; inside : the same, with x between the ends, if their order is known
(struct path (x low high A inside) #:authentic)

(define (make-path x low high A) (path x low high A (between-ends x low high A)))

;; The assumptions with x between the ends, if their order is known
(define (between-ends x low high A)
  (define (between from to) (list (relation-of '<= from x) (relation-of '<= x to)))
  (define facts
    (case (known-sign (e:- high low) A)
      [(1) (between low high)]
      [(-1) (between high low)]
      [else '()]))
  (with-relations A facts))

(define (relation-of head a b) (list head (expression->datum a) (expression->datum b)))

;; -> a list of datums, among them declared ones; #f if there are none under which F will do
(define (integral-conditions-of e F x low high A)
  (define p (make-path x low high A))
  (define-values (moving still)
    (partition (moves? p) (factors-of (append (denominators F) (sizes-in-logarithms F)) A)))
  (with-handlers ([nothing-told? (lambda (_) #f)]
                  [exn:algebra:contradiction? (lambda (_) #f)])
    (check-domain e p)
    (define conditions
      (remove-duplicates
       (append
        (append-map (lambda (u) (without-zero u p)) (append moving (other-cuts F p)))
        (append-map (lambda (power) (finite-power power p)) (symbolic-powers F x))
        (append-map (lambda (u) (not-zero u A)) (remove* (factors-of (denominators e) A) still))
        (grounds-of F e p))))
    (declare-relations A conditions)
    conditions))

;; Raised where no conditions are known.
(struct nothing-told ())
(define (fail) (raise (nothing-told)))

;; u of log|u|, which is a constant beside a kink (piecewise-antiderivative.rkt)
(define (sizes-in-logarithms F)
  (for/list ([u (in-list (logarithms-in F))] #:when (headed? u op:abs)) (car (node-args u))))

(define ((moves? p) u) (occurs? (path-x p) u))
(define (at u p end) (substitute-expression u (list (cons (path-x p) end))))
(define (at-low u p) (at u p (path-low p)))
(define (at-high u p) (at u p (path-high p)))

;; F with log(u/u(low)), or else with log|u|, in place of log u, where u may be negative, F' = e
;; remains, and F goes on where a sign changes: so values are real.
(define (continuous-logarithms F e x low high A)
  (define p (make-path x low high A))
  (define (known? u) (or (not (occurs? x u)) (eqv? 1 (known-sign u (path-inside p)))))
  (define (positive-in-e? u) (member u (logarithms-in e)))
  (define by-ends (with-logarithms-of F known? (lambda (u) (e:/ u (at-low u p)))))
  (define by-size
    (with-logarithms-of F (lambda (u) (or (known? u) (positive-in-e? u)))
                        (lambda (u) (e:apply op:abs u))))
  (define (difference F) (e:- (derivative F p) e))
  (define (zero? e) (or (eqv? 0 (simplify-expression e A)) (proved-zero? e A)))
  (cond [(and (not (jumps? by-ends p)) (zero? (difference by-ends))) by-ends]
        [(and (not (eq? by-size F)) (not (jumps? by-size p)) (proved-zero? (difference by-size) A))
         by-size]
        [else F]))

;; F with logarithms of the values that the function makes of u, but where u is to stay
(define (with-logarithms-of F stays? real)
  (node-fold F values
             (lambda (n args)
               (define change? (and (headed? n op:log) (not (stays? (car args)))))
               (define new (if change? (map real args) args))
               (cond [(andmap eq? new (node-args n)) n]
                     [(eq? new args) (rebuild (node-head n) new)]
                     [else (e:apply op:log (car new))]))))

(define (logarithms-in e) (parts-in e (lambda (n) (and (headed? n op:log) (car (node-args n))))))

(define (proved-zero? e A)
  (eq? 'proved (zero-test-status (zero-test e (with-automatic-assumptions A #f)))))

;; ---------------------------------------------------------------------------
;; Parts of an expression

(define (denominators e) (parts-in e divisor-of))

;; Expressions besides denominators without a zero on the path; fails where F may jump elsewhere.
(define (other-cuts F p)
  (define (cut n)
    (define u (car (node-args n)))
    (define (either-sign) (if (pair? (cdr (node-args n))) (fail) #f))
    (cond [(not (ormap (moves? p) (node-args n))) #f]
          [else
           (case (operation-name (node-head n))
             [(log) u]
             [(sgn) (if (continuous-over? n F p) #f u)]
             [(tan) (e:apply op:cos u)]
             [(atanh) (e:- 1 (e:expt u 2))]
             [(atan) (either-sign)]
             [(floor ceiling round truncate) (fail)]
             [else #f])]))
  (factors-of (parts-in F (lambda (n) (and (operation? (node-head n)) (cut n))))
              (path-A p)
              (moves? p)))

;; Has F the same value for all signs, 0 too, where the line u of n = sgn u is zero, and is it the
;; only sign that changes there?
(define (continuous-over? n F p)
  (define u (car (node-args n)))
  (define (with sign) (substitute-expression F (list (cons n sign))))
  (and (line? u p)
       (let ()
         (define (zero-there? e) (eqv? 0 (at-zero-of-line e u p)))
         (and (not (ormap zero-there? (remove u (signed-parts F p))))
              (zero-there? (e:- (with 1) (with -1)))
              (zero-there? (e:- (with 1) (with 0)))))))

;; The value of e where the line u is zero; #f if there is none
(define (at-zero-of-line e u p)
  (define zero (simplify-expression (e:- (path-x p) (e:/ u (derivative u p)))))
  (with-handlers ([no-value? (lambda (_) #f)])
    (simplify-expression (at e p zero) (path-A p))))

;; Has e a sign of x, or |u| divided by u, so that it may jump between the ends?
(define (jumps-between? e x low high A)
  (define p (make-path x low high A))
  (define simple (simplify-expression e (with-automatic-assumptions (path-inside p) #f)))
  (or (jumps? simple p)
      (for*/or ([u (in-list (parts-headed op:abs simple p))]
                [divisor (in-list (filter (moves? p) (denominators simple)))])
        (or (not (line? u p)) (eqv? 0 (at-zero-of-line divisor u p))))))

(define (jumps? e p)
  (not (andmap (lambda (u) (continuous-over? (make-node op:sgn (list u)) e p)) (signed-parts e p))))

(define (signed-parts e p) (parts-headed op:sgn e p))

;; The arguments, those that move, of the operation in e
(define (parts-headed head e p)
  (parts-in e (lambda (n) (and (headed? n head) ((moves? p) n) (car (node-args n))))))

;; (base . exponent) of powers with an exponent that is no number
(define (symbolic-powers F x)
  (parts-in F (lambda (n)
                (define args (node-args n))
                (and (headed? n op:expt)
                     (occurs? x (car args))
                     (not (real? (cadr args)))
                     (cons (car args) (cadr args))))))

;; ---------------------------------------------------------------------------
;; Values on the path

;; Fails where a radicand, or e's argument of a logarithm, is negative at an end or in the middle.
(define (check-domain e p)
  (define places (list (path-low p) (path-high p) (e:/ (e:+ (path-low p) (path-high p)) 2)))
  (for* ([u (in-list (parts-in e radicand))] [x (in-list places)])
    (when (eqv? -1 (known-sign (at u p x) (path-A p))) (fail))))

(define (radicand n)
  (define args (node-args n))
  (and (or (memq (node-head n) (list op:sqrt op:log))
           (and (headed? n op:expt)
                (rational? (cadr args))
                (not (integer? (cadr args)))))
       (car args)))

;; ---------------------------------------------------------------------------
;; No zero on the path

;; -> conditions
(define (without-zero u p)
  (cond [(memv (known-sign u (path-inside p)) '(1 -1)) '()]
        [(headed? u op:abs) (factors-without-zero (car (node-args u)) p)]
        [(radicand-of-root u) => (lambda (v) (factors-without-zero v p))]
        [(or (line? u p) (monotone? u p)) (same-sign-at-ends u p)]
        [(wave-of-line? u p)
         (append (within-half-turn (car (node-args u)) p) (same-sign-at-ends u p))]
        [(norm u p) => (lambda (n) (factors-without-zero n p))]
        [(discriminant-of u p) => (lambda (d) (quadratic-without-zero u d p))]
        [(excess-over-wave u p) => (lambda (excess) (more-than-0 excess p))]
        [else (fail)]))

;; a² − b² of u = a + b w, where w is a sine or a cosine; else #f
(define (excess-over-wave u p)
  (define (wave n)
    (and (memq (node-head n) (list op:sin op:cos)) ((moves? p) n) n))
  (define waves (parts-in u wave))
  (define-values (a b)
    (if (= (length waves) 1) (linear-in (car waves) u (path-x p) (path-A p)) (values #f #f)))
  (and a (simplify-expression (e:- (e:expt a 2) (e:expt b 2)) (path-A p))))

;; v of √v and other roots
(define (radicand-of-root u) (and (node? u) (not (headed? u op:log)) (radicand u)))

(define (factors-without-zero n p)
  (append-map (lambda (u) (if ((moves? p) u) (without-zero u p) (not-zero u (path-A p))))
              (factors-of (list n) (path-A p))))

(define (same-sign-at-ends u p)
  (define (simple e) (simplify-expression e (path-A p)))
  (define-values (a b) (values (simple (at-low u p)) (simple (at-high u p))))
  (more-than-0 (e:* (sign-if-known a p) (sign-if-known b p)) p))

(define (sign-if-known e p) (or (known-sign e (path-A p)) e))

(define (more-than-0 e p)
  (case (known-sign e (path-A p))
    [(1) '()]
    [(0 -1) (fail)]
    [else (list (positive e (path-A p)))]))

(define (within-half-turn angle p)
  (define turn (simplify-expression (e:- (at-high angle p) (at-low angle p)) (path-A p)))
  (more-than-0 (e:- exact-pi (e:apply op:abs turn)) p))

(define (derivative u p) (expression-derivative u (path-x p)))

(define (line? u p)
  (and (smooth? u p)
       (eqv? 0 (simplify-expression (derivative (derivative u p) p) (path-A p)))))

;; Has u neither kinks nor jumps that its derivatives would not show?
(define (smooth? u p)
  (not (some-node? (lambda (n) (and (memq (node-head n) (list op:abs op:sgn)) ((moves? p) n))) u)))

;; Do all factors of the derivative that move keep their signs, but for zeros?
(define (monotone? u p)
  (and (smooth? u p)
       (for/and ([f (in-list (factors-of (list (derivative u p)) (path-A p) (moves? p)))])
         (one-sided? f (path-inside p)))))

(define (one-sided? f A) (or (never-positive? f A) (never-positive? (e:negate f) A)))

(define (never-positive? e A)
  (eqv? 0 (simplify-expression (e:+ (e:apply op:abs e) e) (with-automatic-assumptions A #f))))

(define (wave-of-line? u p)
  (and (node? u)
       (memq (node-head u) (list op:sin op:cos))
       (line? (car (node-args u)) p)))

;; a² − b² of u = a + b, where it has fewer roots than u; else #f.  It is 0 wherever u is.
(define (norm u p)
  (define-values (b a) (partition (rooted? p) (operands-of u op:+)))
  (and (pair? a)
       (pair? b)
       (let ([n (simplify-expression (e:- (e:expt (sum a) 2) (e:expt (sum b) 2)) (path-A p))])
         (and (not ((rooted? p) n)) (not (eqv? n 0)) n))))

(define (sum es) (rebuild op:+ es))

(define ((rooted? p) e)
  (some-node? (lambda (n) (and (headed? n op:sqrt) ((moves? p) n))) e))

;; c₁² − 4c₀c₂ of a quadratic polynomial c₀ + c₁x + c₂x²; else #f
(define (discriminant-of u p)
  (define A (path-A p))
  (define slope (simplify-expression (derivative u p) A))
  (and (smooth? u p)
       (line? slope p)
       (let ([c1 (at slope p 0)])
         (simplify-expression
          (e:- (e:expt c1 2) (e:* 2 (e:* (derivative slope p) (at u p 0)))) A))))

(define (quadratic-without-zero u discriminant p)
  (define slope (derivative u p))
  (define (root sign)
    (e:/ (e:- (e:* sign (applied op:sqrt discriminant)) (at slope p 0)) (derivative slope p)))
  (case (known-sign discriminant (path-A p))
    [(-1) '()]
    [(1) (append-map (lambda (sign) (same-sign-at-ends (e:- (path-x p) (root sign)) p))
                     '(1 -1))]
    [else (if (never-positive? discriminant (path-A p))
              (factors-without-zero discriminant p)
              (fail))]))

;; uⁿ on the path: u is positive, or 0 at an end, and n positive.
(define (finite-power power p)
  (define-values (u n) (values (car power) (cdr power)))
  (unless (or (eqv? 1 (known-sign u (path-inside p))) (line? u p) (monotone? u p)) (fail))
  (append-map (lambda (end)
                (define v (simplify-expression (at u p end) (path-A p)))
                (more-than-0 (if (eqv? v 0) n v) p))
              (list (path-low p) (path-high p))))

;; ---------------------------------------------------------------------------
;; Grounds of F' = e

(define (grounds-of F e p)
  (define-values (_ grounds)
    (simplify-expression/assumptions (e:- (derivative F p) e) (path-A p)))
  (append-map (lambda (g) (on-path g p))
              (filter-not left-unexpanded? grounds)))

;; The conditions under which a relation holds on the whole path
(define (on-path ground p)
  (define sides (map datum->expression (cdr ground)))
  (define (difference) (e:- (car sides) (cadr sides)))
  (cond [(not (ormap (moves? p) sides)) (list ground)]
        [else
         (case (car ground)
           [(>) (not-negative (difference) p)]
           [(>=) (not-negative (difference) p)]
           [(< <=) (not-negative (e:negate (difference)) p)]
           [else (fail)])]))

;; Of a line that is told by the ends; where its values there are opposite, it is not.
(define (not-negative u p)
  (define (simple e) (simplify-expression e (path-A p)))
  (define ends (list (simple (at-low u p)) (simple (at-high u p))))
  (cond [(headed? u op:abs) (without-zero (car (node-args u)) p)]
        [(memv (known-sign u (path-inside p)) '(1 0)) '()]
        [(and (line? u p) (not (eqv? 0 (simple (sum ends)))))
         (append-map (lambda (v)
                       (case (known-sign v (path-A p))
                         [(1 0) '()]
                         [(-1) (fail)]
                         [else (list (relation-of '>= v 0))]))
                     ends)]
        [else (fail)]))
