#lang racket/base
;; Kinks, jumps and points without a value: where they are, and whether there are any.
;;
;; |u| has a kink where u changes its sign, so at the factors of u of odd power.  √u = √∏fᵏ
;; has one where an f of even power passes through zero with |f|^(k/2) not smooth, as in
;; √(x²) = |x|; at an f of odd power it has an end.  asin u and acosh u are like √(1 − u²) and
;; √(u² − 1): so asin(sin x) has kinks where cos x vanishes.  atan u jumps where u passes
;; through a pole.  Ends and poles count only of a path, which must have a value; a potential
;; may have them; and so do branches on (= u v).
;;
;; Where u is never negative and its zeros are no surface (zero-surface.rkt), √u is a distance:
;; √(x² + y²) is 0 at a collision, where a potential has no value, or where it has a kink at one
;; point; so nothing is said of it.  A path that leads there has a kink, unless a potential has no
;; value there.
;;
;; Functions that are the same on both sides of a surface, up to their second derivatives, have no
;; kink: |x|³.
;;
;; A factor whose sign is known, or that has no real zeros, is dropped.  Parameters are at a
;; generic point, where none is 0; their signs are taken for granted nowhere but at
;; the cut of an angle.

(require racket/list
         "gap.rkt" "kink-place.rkt" "zero-surface.rkt"
         "../assumption/assumption-set.rkt" "../assumption/domain.rkt" "../assumption/signs.rkt"
         "../expression/expression.rkt" "../expression/nodes.rkt" "../expression/operation.rkt"
         "../expression/read.rkt" "../expression/substitute.rkt" "../expression/symbols.rkt"
         (only-in "../field/field.rkt" field-atlas)
         (only-in "../kernel/find-kernels.rkt" atlas-simplifier)
         "../solve/factors.rkt" (only-in "../solve/nonzero-conditions.rkt" not-zero)
         "../simplify/declare-relations.rkt" "../simplify/known-sign.rkt"
         "../simplify/simplify-expression.rkt"
         "../../error/computed-once.rkt" "../../error/refusal.rkt")

(provide find-kinks (struct-out kink))

;; sort : 'kink, 'jump, 'branch (a jump of an angle by a whole turn, which its derivatives do not
;; have), 'no-value, or 'gap (no value, and nothing that keeps a motion from passing)
;; expression : in which it is, such as |t − 2|
;; equations : (= t 2) ... or, where these cannot be solved for, (= u 0), and other conditions
;; there; solved? tells which.  family? : do they hold for each integer n?
(struct kink (sort expression equations solved? family?) #:transparent)

;; zero : a factor that vanishes there         beside : a factor that must be negative, or #f
(struct candidate (sort expression zero beside) #:authentic)

;; variables ... order : as find-kinks has them
;; assumptions : not automatic; automatic? : were they?
;; grounds : datums of assumptions by which something was dropped
(struct search
  (variables places unknowns values? functions order assumptions automatic? [grounds #:mutable])
  #:authentic)

;; operations : ((name argument ...) ...) that a derivative met; (nowhere e) of an e that has
;; no value anywhere
;; variables : symbols, of which a factor must have one to count
;; places : ((variable . expression) ...), put in for them in the end
;; unknowns : symbols to solve for         values? : must all have a value?
;; domain : expressions, places put in, that are to have a value; where one has none is no kink
;; functions : expressions in the variables, differentiated `order` times; if all of them are
;; smooth at a kink, it is none
;; -> kinks, and datums of assumptions under which there are no more
;; It is a variable, since a macro would have to be loaded to be known for one.
(define-values (find-kinks)
  (lambda (operations variables A #:places [places '()] #:unknowns [unknowns variables]
           #:values? [values? #f] #:domain [domain '()] #:functions [functions '()]
           #:order [order 2])
    (define (search-under assumptions)
      (define s (search variables places unknowns values? functions order
                        assumptions (assumptions-automatic? A) '()))
      (define ks (together (kinks-of operations s)))
      (values ks (reverse (search-grounds s))))
    (define-values (inside grounds)
      (search-in-domain search-under (append-map needs-of domain) operations places A))
    (define-values (gaps more)
      (gaps-within (if (null? places) (list domain functions) (list domain))
                   (search (if (null? places) variables unknowns) '() unknowns values? '() order
                           (with-automatic-assumptions A #f) #f '())))
    (define known (append-map kink-equations inside))
    (define new (filter (lambda (k) (not (subset? (kink-equations k) known))) gaps))
    (values (append inside new) (remove-duplicates (append grounds more)))))

(define (subset? xs ys) (andmap (lambda (x) (member x ys)) xs))

;; The search is repeated with the facts that hold wherever there are values, if it found kinks.
;; search-under : assumptions -> kinks and grounds
(define (search-in-domain search-under needs operations places A)
  (define strict (with-automatic-assumptions A #f))
  (define find-nonzero (once (lambda () (nonzero-factors needs A))))
  (define-values (all grounds) (search-under strict))
  (define facts
    (if (andmap hole? all) '() (facts-of (append needs (needs-met operations)) places)))
  (define-values (kept more)
    (if (null? facts) (values all '()) (search-under (with-relations strict facts))))
  (define inside
    (for*/list ([k (in-list kept)]
                #:unless (hole? k)
                [left (in-value (within-domain k needs find-nonzero A))]
                #:when left)
      left))
  (values (append inside (filter hole? all) (nowhere operations))
          (filter (lambda (d) (not (required? d find-nonzero)))
                  (remove-duplicates (remove* facts (append grounds more))))))

;; groups : lists of expressions.  A quantity may have a gap where a Lagrangian has none.
;; -> places where those of a group have a gap, and grounds on which there are no more
(define (gaps-within groups s)
  (define (surface? f)
    (not (by-signs (lambda (k) (and (signs-decided? k) (not (eqv? k zero)))) f s)))
  (define found
    (for*/list ([es (in-list (remove-duplicates groups))]
                [g (in-list (gaps es (search-variables s) surface? (search-assumptions s)))]
                [k (in-value (located (candidate 'gap (car g) (cdr g) #f) s))]
                #:when k)
      k))
  (values (together found) (reverse (search-grounds s))))

;; Is it (> (abs u) 0) with a u that is not 0 where all has a value?
(define (required? datum find-nonzero)
  (define left (cadr datum))
  (and (pair? left)
       (eq? (car left) 'abs)
       (member (datum->expression (cadr left)) (find-nonzero))
       #t))

(define (hole? k) (eq? (kink-sort k) 'no-value))

(define (nowhere operations)
  (for/list ([o (in-list operations)] #:when (eq? (car o) 'nowhere))
    (kink 'no-value (cadr o) '() #f #f)))

;; ---------------------------------------------------------------------------
;; The domain

;; The kink without its places at which something required does not hold; #f if none is left.
(define (within-domain k needs find-nonzero A)
  (define equations (kink-equations k))
  (cond [(or (null? needs) (null? equations)) k]
        [(kink-solved? k)
         (define left (filter (lambda (q) (not (excluded? q needs A))) equations))
         (and (pair? left) (struct-copy kink k [equations left]))]
        [else (and (not (member (cadr (car equations)) (find-nonzero))) k)]))

;; place : (= symbol expression)
(define (excluded? place needs A)
  (for/or ([r (in-list needs)])
    (define u
      (if-raised divided-by-zero? #f
        (simplify-expression
         (substitute-expression (relation-expression r) (list (cons (cadr place) (caddr place))))
         A)))
    (define sign (and u (known-sign u A)))
    (or (not u)                         ; it has no value there itself
        (and sign (not (signs-within? (number-signs sign) (relation-signs r)))))))

;; -> the factors of all that may not be 0, simplified, with either sign
(define (nonzero-factors needs A)
  (for*/list ([r (in-list needs)]
              #:unless (signs-within? zero (relation-signs r))
              [g (in-list (expression-factors (relation-expression r) A))]
              [sign (in-list '(1 -1))])
    (simplify-expression (e:* sign (without-absolute-value (car g))) A)))

(define (without-absolute-value e)
  (if (or (headed? e op:abs) (headed? e op:sqrt)) (car (node-args e)) e))

;; Relations that hold where e has a value
(define (needs-of e) (append-map node-relations (nodes-in e)))

;; Relations of roots and logarithms met.  A derivative of uⁿ meets uⁿ⁻¹, which may have no
;; value at an end of uⁿ.
(define (needs-met operations)
  (for*/list ([o (in-list operations)]
              #:when (memq (car o) '(sqrt log expt))
              [r (in-list (node-relations (shown (car o) (cdr o))))])
    (if (and (eq? (car o) 'expt) (eqv? positive (relation-signs r)))
        (struct-copy relation r [signs nonnegative])
        r)))

;; Signs that they tell, as datums, with places put in.  It costs nothing, and says nothing of
;; ends themselves.
(define (facts-of needs places)
  (remove-duplicates
   (for*/list ([r (in-list needs)]
               #:unless (eqv? nonzero (relation-signs r))
               [u (in-value (substitute-expression (relation-expression r) places))]
               #:when (symbolic? u))
     (list (if (eqv? positive (relation-signs r)) '> '>=) (expression->datum u) 0))))

(define (kinks-of operations s)
  (for*/list ([o (in-list operations)]
              [c (in-list (candidates (car o) (cdr o) s))]
              #:unless (smooth-across? (candidate-zero c) s)
              [k (in-value (located c s))]
              #:when k)
    k))

;; The places of one expression in one kink, as long as they are solved for.
(define (together ks)
  (for/list ([group (in-list (group-by key (remove-duplicates ks)))])
    (struct-copy kink (car group) [equations (append-map kink-equations group)])))

(define (key k)
  (if (and (kink-solved? k) (not (kink-family? k)))
      (list (kink-sort k) (kink-expression k))
      k))

;; ---------------------------------------------------------------------------
;; Where operations have them

(define (candidates name arguments s)
  (define x (car arguments))
  (define (node) (shown name arguments))
  (define (at sort wanted? u #:beside [beside #f])
    (for/list ([f (in-list (factors-where wanted? u s))]) (candidate sort (node) f beside)))
  (define (end wanted? u) (if (search-values? s) (at 'no-value wanted? u) '()))
  (define (kinks fs) (for/list ([f (in-list fs)]) (candidate 'kink (node) (surface-zero f) #f)))
  (define (like-root u n)
    (append (kinks (kinks-of-root u n s)) (end (if (positive? n) odd? any) u)))
  (case name
    [(abs) (kinks (kinks-of-absolute-value x s))]
    [(sgn) (at 'jump any x)]
    [(sqrt) (like-root x 1/2)]
    [(asin acos) (like-root (e:- 1 (e:expt x 2)) 1/2)]
    [(acosh) (like-root (e:- (e:expt x 2) 1) 1/2)]
    [(atanh) (end any (e:- 1 (e:expt x 2)))]
    [(log) (end any x)]
    [(/) (end any (cadr arguments))]
    [(tan) (end any (e:apply op:cos x))]
    [(=) (if (search-values? s) (at 'jump any (e:- x (cadr arguments))) '())]
    [(expt) (let ([n (exact-power (cadr arguments))])
              (cond [(not n) (append (kinks (kinks-of-root x 1/2 s)) (end any x))]
                    [(not (integer? n)) (like-root x n)]
                    [(negative? n) (end any x)]
                    [else '()]))]
    [(atan) (cond [(pair? (cdr arguments)) (at (if (branch-alone? (node) s) 'branch 'jump)
                                                any x #:beside (cadr arguments))]
                  [(search-values? s) '()]        ; its poles are noted themselves
                  [else (append-map (lambda (u) (at 'jump odd? u)) (poles-within x))])]
    [else '()]))

;; Is all that is differentiated linear in the angle, so that a turn adds a constant?  Then nothing
;; but the formula jumps.  A path that jumps is none.
(define (branch-alone? angle s)
  (define (simple e) (simplify-expression e (search-assumptions s)))
  (define turn (string->uninterned-symbol "turn"))
  (define (turn-of f)
    (define (with e) (substitute-expression f (list (cons angle e))))
    (define slope (simple (e:- (with 1) (with 0))))
    (define rise (e:- (with (e:+ angle turn)) (with angle)))
    (and (eqv? 0 (simple (e:- rise (e:* turn slope)))) slope))
  (define turns (if (search-values? s) '() (map turn-of (search-functions s))))
  (and (pair? turns)
       (andmap (lambda (c) (and c (not (varies? c s)))) turns)))

(define (shown name arguments)
  (case name
    [(/) (make-node op:/ (cons 1 (cdr arguments)))]
    [(=) (make-node (make-literal-head '=) arguments)]
    [else (make-node (find-operation name) arguments)]))

(define (any k) #t)

;; -> the factors of u at whose zeros |u| has a kink
(define (kinks-of-absolute-value u s)
  (for/list ([f (in-list (surfaces-of u s))]
             #:when (odd? (surface-power f))
             #:when (abrupt? (surface-power f) s)
             #:unless (one-sided? f s))
    f))

;; -> the same of uⁿ, n being half an odd number or the like
(define (kinks-of-root u n s)
  (define fs (surfaces-of (if (search-values? s) u (without-radii u s)) s))
  (define-values (even odd) (partition (lambda (f) (even? (surface-power f))) fs))
  (define may-be-0 (filter (lambda (f) (not (never-zero? (surface-zero f) s))) odd))
  (append (filter (lambda (f) (and (abrupt? (* n (surface-power f)) s) (not (one-sided? f s))))
                  even)
          (filter (lambda (f) (touched? f n (surfaces-apart? may-be-0) s)) may-be-0)))

;; Has |x|^k a kink, when it is differentiated so often?
(define (abrupt? k s)
  (not (or (and (integer? k) (even? k) (positive? k))
           (> k (search-order s)))))

;; f : a factor of odd power of the radicand u ≥ 0.  Has uⁿ a kink where f is 0?  It has along a
;; path, and on a surface of zeros; zeros that are no surface are those of a distance, for
;; parameters that are not 0: that is noted.  apart? : has f no zeros in common with other factors?
(define (touched? f n apart? s)
  (define A (search-assumptions s))
  (cond [(> (* 2 n (surface-power f)) (search-order s)) #f]
        [(and (pair? (search-places s)) (one-sided? f s)) #t]
        [(and apart? (surface-separate? f A))
         (for ([u (in-list (degenerate-parameters f A))] #:unless (never-zero? u s))
           (note-grounds! (not-zero u A) s))
         #f]
        [else (not (search-values? s))]))

;; u without those of its factors that are the square of a radius in polar coordinates: r² as the
;; sum of (r cos θ)² and (r sin θ)² stays a distance.
(define (without-radii u s)
  (define head (and (node? u) (node-head u)))
  (cond [(memq head (list op:* op:/))
         (rebuild head (for/list ([a (in-list (node-args u))]) (without-radii a s)))]
        [(radius? u s) 1]
        [else u]))

(define (radius? u s)
  (define terms (if (headed? u op:+) (node-args u) '()))
  (define (turns? n) (and (memq (node-head n) circular-functions) (varies? n s)))
  (and (pair? terms)
       (andmap (lambda (e) (some-node? turns? e)) terms)
       (andmap (lambda (e) (signs-within? (known-signs (signs-of e s)) nonnegative)) terms)
       (let ([r (simplify-expression u (search-assumptions s))])
         (and (headed? r op:expt) (symbol? (car (node-args r))) (eqv? 2 (cadr (node-args r)))))))

(define (surfaces-of u s)
  (surfaces u (search-variables s) (search-assumptions s)))

(define (exact-power n) (and (rational? n) (inexact->exact n)))

(define (varies? e s) (any-occurs? (search-variables s) e))
(define (any-occurs? symbols e) (ormap (lambda (x) (occurs? x e)) symbols))

;; Expressions that vanish where e has a pole.
(define (poles-within e)
  (parts-in e (lambda (n)
                (if (headed? n op:tan)
                    (e:apply op:cos (car (node-args n)))
                    (divisor-of n)))))

;; The factors of u that vary, of the powers that are wanted.
(define (factors-where wanted? u s)
  (define factors
    (if (node? u) (expression-factors u (search-assumptions s)) (list (cons u 1))))
  (for/list ([f (in-list factors)]
             #:when (and (wanted? (cdr f)) (varies? (car f) s)))
    (car f)))

;; ---------------------------------------------------------------------------
;; Functions that are smooth across a surface

;; x : a factor.  If it is a variable, every function is compared on both sides: with
;; x > 0 and x < 0 |x|³ is x³ and −x³, and the difference 2x³ has derivatives that are 0 at 0.
(define (smooth-across? x s)
  (and (symbol? x)
       (pair? (search-functions s))
       (let ([above (with-relations (search-assumptions s) `((> ,x 0)))]
             [below (with-relations (search-assumptions s) `((< ,x 0)))])
         (and (both-sides? above below s)
              (for/and ([e (in-list (search-functions s))])
                (or (not (occurs? x e)) (joined? x e above below s)))))))

;; Where the variable has a sign by declaration, nothing was added to one of the sets.
(define (both-sides? above below s)
  (not (memq (search-assumptions s) (list above below))))

(define (joined? x e above below s)
  (define-values (upper lower) (values (simplify-expression e above) (simplify-expression e below)))
  (define difference (simplify-expression (e:- upper lower) (search-assumptions s)))
  (and (plain-at-0? x upper)
       (plain-at-0? x lower)
       (same-at-0? x e upper s)
       (or (eqv? difference 0)
           (let ([power (assoc x (expression-factors difference (search-assumptions s)))])
             (and power (> (cdr power) (search-order s)))))))

;; Has e, where x is 0, the value to which it leads?  sgn(x²) has not.
(define (same-at-0? x e upper s)
  (if-raised divided-by-zero? #f
    (define (at-0 e) (substitute-expression e (list (cons x 0))))
    (eqv? 0 (simplify-expression (e:- (at-0 e) (at-0 upper)) (search-assumptions s)))))

;; Is e, where x is 0, defined and without a kink, as a formula?
(define (plain-at-0? x e)
  (and (not (some-node? (lambda (n) (not (plain-node? x n))) e))
       (if-raised divided-by-zero? #f
         (substitute-expression e (list (cons x 0)))
         #t)))

(define (plain-node? x n)
  (define head (node-head n))
  (or (literal-head? head)
      (not (occurs? x n))
      (memq head plain-operations)
      (and (eq? head op:expt) (exact-integer? (cadr (node-args n))))))

(define plain-operations (append (list op:+ op:- op:* op:/) (operations-where total meromorphic)))

;; ---------------------------------------------------------------------------
;; Signs

(define (signs-of e s)
  (define A (search-assumptions s))
  (define-values (F f simple notes) (normal-form+simplified e A))
  (infer-signs A (atlas-simplifier (field-atlas F)) simple))

;; Do the signs that e may have satisfy the predicate?  What the answer yes rests on is noted.
(define (by-signs good? e s)
  (define k (signs-of e s))
  (define yes? (good? (known-signs k)))
  (when yes? (note-grounds! (known-because k) s))
  yes?)

(define (note-grounds! data s)
  (set-search-grounds! s (append (reverse data) (search-grounds s))))

(define (never-zero? e s) (by-signs (lambda (k) (eqv? 0 (bitwise-and zero k))) e s))

;; Not negative, or not positive, without being 0 always?
(define (one-sided? f s)
  (for/or ([e (in-list (remove-duplicates (list (surface-zero f) (surface-polynomial f))))])
    (by-signs (lambda (k) (and (signs-decided? k) (not (eqv? k zero)))) e s)))

(define (never-negative? e s) (by-signs (lambda (k) (signs-within? k nonnegative)) e s))

;; ---------------------------------------------------------------------------
;; Where it is

;; -> kink, or #f if there is none
(define (located c s)
  (define (put e) (substitute-expression e (search-places s)))
  (define (simple e) (simplify-expression (put e) (search-assumptions s)))
  (define f (simple (candidate-zero c)))
  (define beside (and (candidate-beside c) (put (candidate-beside c))))
  (and (not (dropped? c f beside s))
       (let ([places (places-of f (search-unknowns s) (search-assumptions s))])
         (and places
              (let ([solved? (and (pair? places) (not beside))])
                (kink (candidate-sort c) (readable (candidate-expression c) simple)
                      (cond [solved? places]
                            [(eqv? f 0) '()]        ; everywhere
                            [beside `((= ,f 0) (< ,beside 0))]
                            [else `((= ,f 0))])
                      solved?
                      (and solved? (wave? f))))))))

;; The operation itself stays, as |x| in the place of √(x²) would not be as written.
(define (readable e simple) (make-node (node-head e) (map simple (node-args e))))

(define (dropped? c f beside s)
  (or (never-zero? f s)
      (parameter? f s)
      (and beside (or (never-negative? beside s) (taken-not-negative? beside s)))))

;; Is e the same all along the path, and not 0?
(define (parameter? e s)
  (and (pair? (search-places s)) (not (eqv? e 0)) (not (any-occurs? (search-unknowns s) e))))

;; The sign of a constant may be assumed, where assumptions are automatic.
(define (taken-not-negative? e s)
  (define free?
    (and (search-automatic? s)
         (not (any-occurs? (search-unknowns s) e))
         (signs-within? positive (known-signs (signs-of e s)))))
  (when free?
    (note-grounds! (list (list '>= (expression->datum e) 0)) s))
  free?)
