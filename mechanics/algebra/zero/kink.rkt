#lang racket/base
;; Kinks, jumps and points without a value: where they are, and whether there are any.
;;
;; |u| has a kink where u changes its sign, so at the factors of u of odd power.  √u = √∏fᵏ
;; has one where an f of even power passes through zero with |f|^(k/2) not smooth, as in
;; √(x²) = |x|; at an f of odd power it has an end.  asin u and acosh u are like √(1 − u²) and
;; √(u² − 1): so asin(sin x) has kinks where cos x vanishes.  atan u jumps where u passes
;; through a pole.  Ends and poles count only of what must have a value, a path; a potential
;; may have them; and so do branches on (= u v).
;;
;; A sum of squares vanishes where all of them do: √(x² + y²) is a distance, which is 0 at a
;; collision, where a potential has no value; so nothing is said of it, and neither in polar
;; coordinates, where it is √(r²).
;;
;; A factor whose sign is known, or that has no real zeros, is dropped.  Parameters are at a
;; generic point, where none is 0; what sign they have is taken for granted nowhere but at
;; the cut of an angle.

(require racket/list
         "kink-place.rkt"
         "../assumption/assumption-set.rkt" "../assumption/signs.rkt"
         "../expression/expression.rkt" "../expression/operation.rkt"
         "../expression/substitute.rkt" "../expression/symbols.rkt"
         (only-in "../field/field.rkt" field-atlas)
         (only-in "../kernel/find-kernels.rkt" atlas-simplifier)
         "../solve/factors.rkt"
         "../simplify/declare.rkt"
         "../simplify/simplify-expression.rkt")

(provide find-kinks (struct-out kink))

;; sort : 'kink, 'jump or 'no-value           expression : in which it is, such as |t − 2|
;; equations : (= t 2) ... or, where these cannot be solved for, (= u 0), and what else holds
;; there; solved? tells which.  family? : do they hold for each integer n?
(struct kink (sort expression equations solved? family?) #:transparent)

;; zero : a factor that vanishes there         beside : what must be negative, or #f
(struct candidate (sort expression zero beside) #:authentic)

;; variables : symbols, of which a factor must have one to count
;; places : ((variable . expression) ...), put in for them in the end
;; unknowns : symbols to solve for         values? : must all have a value?
;; assumptions : not automatic; automatic? : were they?
;; grounds : datums of assumptions by which something was dropped
(struct search (variables places unknowns values? assumptions automatic? [grounds #:mutable])
  #:authentic)

;; operations : ((name argument ...) ...) that a derivative met; (nowhere e) of an e that has
;; no value anywhere
(define (find-kinks operations variables places unknowns values? A)
  (define strict (with-automatic-assumptions A #f))
  (define (search-under assumptions)
    (define s (search variables places unknowns values? assumptions (assumptions-automatic? A) '()))
    (define ks (together (kinks-of operations s)))
    (values ks (reverse (search-grounds s))))
  (define-values (all grounds) (search-under strict))
  (define facts (if (andmap hole? all) '() (domain operations places)))
  (define-values (inside more)
    (if (null? facts) (values all '()) (search-under (with-relations strict facts))))
  (values (append (filter-not hole? inside) (filter hole? all) (nowhere operations))
          (remove-duplicates (remove* facts (append grounds more)))))

(define (hole? k) (eq? (kink-sort k) 'no-value))

(define (nowhere operations)
  (for/list ([o (in-list operations)] #:when (eq? (car o) 'nowhere))
    (kink 'no-value (cadr o) '() #f #f)))

;; What holds wherever there are values, as datums: radicands are not negative, and of what
;; there is a logarithm is positive.  It costs nothing, and says nothing of ends themselves.
(define (domain operations places)
  (for*/list ([o (in-list operations)]
              [relation (in-value (case (car o)
                                    [(log) '>]
                                    [(sqrt) '>=]
                                    [(expt) (and (broken? (caddr o)) '>=)]
                                    [else #f]))]
              #:when relation
              [x (in-value (substitute-expression (cadr o) places))]
              #:when (symbolic? x))
    (list relation (expression->datum x) 0)))

(define (broken? n) (and (rational? n) (not (integer? n))))

(define (kinks-of operations s)
  (for*/list ([o (in-list operations)]
              [c (in-list (candidates (car o) (cdr o) s))]
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
  (define (like-root u n)
    (append (at 'kink (touching n) (if (search-values? s) u (without-distances u s)))
            (end (if (positive? n) odd? any) u)))
  (case name
    [(abs) (if (and (null? (search-places s)) (one-sided? x s)) '() (at 'kink odd? x))]
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
              (cond [(not n) (end any x)]
                    [(not (integer? n)) (like-root x n)]
                    [(negative? n) (end any x)]
                    [else '()]))]
    [(atan) (cond [(pair? (cdr arguments)) (at 'jump any x #:beside (cadr arguments))]
                  [(search-values? s) '()]        ; its poles are noted themselves
                  [else (append-map (lambda (u) (at 'jump odd? u)) (poles-within x))])]
    [else '()]))

(define (shown name arguments)
  (case name
    [(/) (make-node op:/ (cons 1 (cdr arguments)))]
    [(=) (make-node (make-literal-head '=) arguments)]
    [else (make-node (find-operation name) arguments)]))

(define (any k) #t)
(define ((touching n) k) (and (even? k) (not (whole-square? (* k n)))))
(define (whole-square? k) (and (integer? k) (even? k) (positive? k)))

(define (exact-power n) (and (rational? n) (inexact->exact n)))

;; u without those of its factors, as they are written, that are sums of squares.
(define (without-distances u s)
  (define head (and (node? u) (node-head u)))
  (define (args) (for/list ([a (in-list (node-args u))]) (without-distances a s)))
  (cond [(memq head (list op:* op:/)) (rebuild head (args))]
        [(sum-of-squares? u s) 1]
        [else u]))

(define (sum-of-squares? u s)
  (define terms (terms-of u))
  (define varying (filter (lambda (e) (varies? e s)) terms))
  (and (pair? varying)
       (pair? (cdr varying))
       (for/and ([e (in-list terms)])
         (signs-within? (known-signs (signs-of e s)) nonnegative))))

(define (terms-of u)
  (if (headed? u op:+)
      (append-map terms-of (node-args u))
      (list u)))

(define (varies? e s) (mentions? e (search-variables s)))
(define (mentions? e symbols) (ormap (lambda (x) (occurs? x e)) symbols))

;; Expressions that vanish where e has a pole.
(define (poles-within e)
  (define found '())
  (define (add! u) (set! found (cons u found)))
  (node-fold e void
             (lambda (n _)
               (define args (node-args n))
               (define head (node-head n))
               (cond [(eq? head op:/) (add! (cadr args))]
                     [(eq? head op:tan) (add! (e:apply op:cos (car args)))]
                     [(and (eq? head op:expt) (real? (cadr args)) (negative? (cadr args)))
                      (add! (car args))])))
  (reverse found))

;; The factors of u that vary, of the powers that are wanted.
(define (factors-where wanted? u s)
  (define factors
    (if (node? u) (expression-factors u (search-assumptions s)) (list (cons u 1))))
  (for/list ([f (in-list factors)]
             #:when (and (wanted? (cdr f)) (varies? (car f) s)))
    (car f)))

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
  (when yes? (set-search-grounds! s (append (reverse (known-because k)) (search-grounds s))))
  yes?)

(define (never-zero? e s) (by-signs (lambda (k) (eqv? 0 (bitwise-and zero k))) e s))

;; Not negative, or not positive, without being 0 always?
(define (one-sided? e s) (by-signs (lambda (k) (and (signs-decided? k) (not (eqv? k zero)))) e s))

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
                            [beside `((= ,f 0) (< ,beside 0))]
                            [else `((= ,f 0))])
                      solved?
                      (and solved? (wave? f))))))))

;; The operation itself stays, as |x| in the place of √(x²) would not say what was written.
(define (readable e simple) (make-node (node-head e) (map simple (node-args e))))

(define (dropped? c f beside s)
  (or (never-zero? f s)
      (parameter? f s)
      (and beside (or (never-negative? beside s) (taken-not-negative? beside s)))
      (and (eq? (candidate-sort c) 'kink) (null? (search-places s)) (one-sided? f s))))

;; Is e the same all along the path, and not 0?
(define (parameter? e s)
  (and (pair? (search-places s)) (not (eqv? e 0)) (not (mentions? e (search-unknowns s)))))

;; The sign of what does not vary may be assumed, where assumptions are automatic.
(define (taken-not-negative? e s)
  (define free?
    (and (search-automatic? s)
         (not (mentions? e (search-unknowns s)))
         (signs-within? positive (known-signs (signs-of e s)))))
  (when free?
    (set-search-grounds! s (cons (list '>= (expression->datum e) 0) (search-grounds s))))
  free?)
