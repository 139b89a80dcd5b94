#lang racket/base
;; Branches: equilibria or periodic orbits as a parameter changes, with the points where something
;; happens to them.  A branch is a value: it prints as a table, and it can be extended.

(require racket/flonum
         racket/list
         "curve-step.rkt" "special-point.rkt"
         "../../error/complain.rkt"
         "../../error/progress.rkt" "../../error/refusal.rkt"
         "../../generic/compare.rkt" "../../generic/define-plain.rkt" "../../generic/describe.rkt"
         "../../generic/value-struct.rkt" "../../generic/wrong-argument.rkt"
         "../../motion/partial-result.rkt"
         "../../numeric/finite-number.rkt" "../../numeric/flvector.rkt")

(provide branch? special-point? extend-branch switch-branch branch-so-far
         ;; for those who begin one
         (struct-out family) (struct-out limits) branch-from make-limits
         ;; for programs in other languages
         branch-system)

;; A family of states.  noun : "equilibria", "periodic orbits"; orbit? : is its spectrum one of
;; multipliers?; state : unknowns -> value
;; onset : of equilibria, a point of Hopf's and limits -> the family of orbits that begin there and
;; a point of it; else #f
;; systems : parameter, or energy, -> state derivative
(struct family (equations noun orbit? state onset systems) #:authentic)

;; from, to : of the parameter; first, longest : lengths of steps; most : number of them
(struct limits (from to first longest most) #:authentic)

;; points : list of points of the curve, the latest first; specials : of special points, the latest
;; first; step : the length of the next; tangent : #f, or where to leave from the only point
;; ending : why it ended, a symbol, or a text where there was no next point; #f of one that was
;; broken off
(value-struct branch (family limits points specials step tangent ending)
  #:text branch->text)

(value-struct special-point (kind parameter state spectrum family at other)
  #:text (lambda (p)
           (format "~a at ~a: ~a" (special-point-kind p) (special-point-parameter p)
                   (value->text (special-point-state p)))))

(provide-parts special-point? "a special point of a branch, of (branch-special-points branch)"
  special-point-kind special-point-parameter special-point-state special-point-spectrum)

(define a-branch "a branch, such as continue-equilibrium gives")

(provide-parts branch? a-branch
  branch-parameters branch-states branch-periods branch-spectra branch-stabilities
  branch-special-points branch-end)

(define (in-order b) (reverse (branch-points b)))
(define (branch-parameters b) (map parameter-of (in-order b)))
(define (branch-states b) (map (family-state* b) (in-order b)))
(define (branch-periods b)
  (define period (equations-period (family-equations (branch-family b))))
  (and period (map (lambda (p) (period (point-x p))) (in-order b))))
(define (branch-spectra b) (map point-spectrum (in-order b)))
(define (branch-stabilities b) (map (stable-in b) (in-order b)))
;; The state derivative at a value of the parameter, or at a symbol for it
(define (branch-system b p) ((family-systems (branch-family b)) p))
(define (branch-special-points b) (reverse (branch-specials b)))

(define ((family-state* b) p) ((family-state (branch-family b)) (point-x p)))
(define ((stable-in b) p) (eqv? 0 (growing (family-orbit? (branch-family b)) (point-spectrum p))))

(define (parameter-of p)
  (define x (point-x p))
  (flvector-ref x (- (flvector-length x) 1)))

;; ---------------------------------------------------------------------------
;; Following one

(define shortest-step 1e-7)

(define (make-limits who from to first longest most)
  (define-values (a b) (values (comparand from) (comparand to)))
  (unless (and (finite? a) (finite? b) (not (= a b)))
    (complain who "expected two values of the parameter, from one to the other\n  given: ~a and ~a"
              (describe-with-value from) (describe-with-value to)))
  (for ([s (in-list (list first longest))])
    (unless (and (real? s) (< 0 s +inf.0))
      (complain-of-argument who "the length of a step, a positive number" s)))
  (check-argument who exact-positive-integer? most "how many steps at most, a positive integer")
  (limits (real->double-flonum a) (real->double-flonum b)
          (real->double-flonum first) (real->double-flonum longest) most))

;; start : a point of the curve; tangent : where to leave it, or #f for its own
(define (branch-from f l start [tangent #f])
  (followed 'continue (branch f l (list start) '() (limits-first l) tangent #f)))

;; The branch with further points, until it ends.
(define (followed who b)
  (define l (branch-limits b))
  (call-counting
   who "points" #f
   (lambda (count!)
     (let loop ([b b] [left (limits-most l)])
       (count! (length (branch-points b)))
       (define next (keeping-so-far (lambda () b) (lengthened b)))
       (cond [(branch-end next) next]
             [(eqv? left 1) (ended next 'steps)]
             [else (loop next (- left 1))])))))

(define (ended b why) (struct-copy branch b [ending why]))

(define (branch-end b) (if (string? (branch-ending b)) 'no-next-point (branch-ending b)))

;; The reason why a branch ends at a: the message of a refusal a little beyond it, or that there is
;; no point
(define (reason e a t)
  (define beyond
    (along (point-x a) (* 1e3 shortest-step) (flvector-map fl* t (equations-scales e))))
  (with-handlers ([refusal? exn-message])
    ((equations-evaluate e) beyond (point-x a))
    "no next point was found, however short the step"))

;; One step further
(define (lengthened b)
  (define-values (f l a) (values (branch-family b) (branch-limits b) (first (branch-points b))))
  (define t (or (branch-tangent b) (point-tangent a)))
  (define-values (p s next)
    (step-along (family-equations f) a (branch-step b) (limits-longest l) shortest-step t))
  (cond [(not p) (ended b (reason (family-equations f) a t))]
        [else
         (define specials
           (if (branch-tangent b)
               '()
               (points-between (family-equations f) (family-orbit? f) a p s)))
         (define out? (outside? l (parameter-of p)))
         (define inside
           (filter (lambda (s) (not (outside? l (parameter-of (found-at s))))) specials))
         (struct-copy branch b
                      [points (cons (or (and out? (at-the-end f l a p)) p) (branch-points b))]
                      [specials (append (reverse (map (special-of f) inside)) (branch-specials b))]
                      [step next] [tangent #f]
                      [ending (and out? 'range)])]))

;; The point between a and p where the parameter leaves its range
(define (at-the-end f l a p)
  (define high (max (limits-from l) (limits-to l)))
  (define bound (if (> (parameter-of p) high) high (min (limits-from l) (limits-to l))))
  (define-values (one other) (values (parameter-of a) (parameter-of p)))
  (define share (/ (- bound one) (- other one)))
  (define x (along (point-x a) share (difference (point-x p) (point-x a))))
  (flvector-set! x (- (flvector-length x) 1) bound)
  (start-on-curve (family-equations f) x (if (> other one) 1 -1)))

(define ((special-of f) s)
  (define p (found-at s))
  (special-point (found-kind s) (parameter-of p) ((family-state f) (point-x p))
                 (point-spectrum p) f p (found-other s)))

(define (outside? l x)
  (define-values (low high) (values (min (limits-from l) (limits-to l))
                                    (max (limits-from l) (limits-to l))))
  (not (<= low x high)))

;; ---------------------------------------------------------------------------
;; Going on, and to others

;; With further points: to another end of the parameter, or as many more steps.
(define-plain (extend-branch b #:to [to #f] #:most-steps [most #f])
  (define who 'extend-branch)
  (check-argument who branch? b a-branch)
  (define l (branch-limits b))
  (define further
    (make-limits who (limits-from l) (or to (limits-to l))
                 (limits-first l) (limits-longest l) (or most (limits-most l))))
  (define last (first (branch-points b)))
  (when (outside? further (parameter-of last))
    (complain who
              (string-append "the branch has left that range of the parameter; #:to says how far "
                             "it is to go\n  parameter at its end: ~a\n  range: from ~a to ~a")
              (parameter-of last) (limits-from further) (limits-to further)))
  (followed who (struct-copy branch b [limits further] [ending #f])))

;; The branch that leaves a special point of b; a period doubling is left by orbits of twice the
;; period, a point of Hopf's by orbits about the equilibrium, which have one side.
;; direction : 1 or -1, the two sides
(define-plain (switch-branch b s #:direction [side 1] #:most-steps [most #f])
  (define who 'switch-branch)
  (check-argument who branch? b a-branch)
  (check-argument who special-point? s
                  "a special point of the branch, of (branch-special-points b)")
  (check-argument who (lambda (x) (memv x '(1 -1))) side "a direction, 1 or -1")
  (define l (branch-limits b))
  (define-values (f p other) (leaving who s l))
  (define all
    (if most
        (make-limits who (limits-from l) (limits-to l) (limits-first l) (limits-longest l) most)
        l))
  (branch-from f all p (and other (flvector-scaled (->fl side) other))))

;; -> family, point and tangent, or #f for the point's own, with which another branch begins
(define (leaving who s l)
  (define f (special-point-family s))
  (cond
    [(special-point-other s) (values f (special-point-at s) (special-point-other s))]
    [(eq? (special-point-kind s) 'period-doubling)
     (define once (special-point-at s))
     (define t (point-tangent once))
     (define-values (e x) ((equations-doubled (family-equations f)) (point-x once)))
     (define p (struct-copy point (point-at e x ((equations-evaluate e) x x) t) [tangent t]))
     (define-values (_own other) (crossing-directions e p t))
     (values (struct-copy family f [equations e]) p other)]
    [(eq? (special-point-kind s) 'Hopf)
     (define-values (g p) ((family-onset f) (special-point-at s) l))
     (values g p #f)]
    [else
     (complain who
               (string-append "no other branch of ~a leaves a point of this kind: ~a\n"
                              "  pitchfork, transcritical, Hopf and period-doubling points have one")
               (family-noun f) (special-point-kind s))]))

;; e : an exception that ended a continuation, a break among them -> the branch until then, or #f
(define (branch-so-far e)
  (check-argument 'branch-so-far exn? e "an exception, as a handler of with-handlers gets it")
  (so-far e branch?))

;; ---------------------------------------------------------------------------
;; As a table

(define (branch->text b)
  (define all (in-order b))
  (define last (first (branch-points b)))
  (define (row what parameter state spectrum)
    (define stability (if spectrum (stability-text b spectrum) ""))
    (list (value->text parameter) what stability (value->text state)))
  (define (point-row what p)
    (row what (parameter-of p) ((family-state* b) p) (point-spectrum p)))
  (define rows
    (append (list (list "parameter" "" "" "state") (point-row "start" (first all)))
            (for/list ([s (in-list (branch-special-points b))])
              (row (symbol->string (special-point-kind s)) (special-point-parameter s)
                   (special-point-state s) #f))
            (list (point-row "end" last))))
  (string-append (format "branch of ~a ~a" (length all) (family-noun (branch-family b)))
                 (table->text rows) (end-text b)))

(define (stability-text b spectrum)
  (define n (growing (family-orbit? (branch-family b)) spectrum))
  (if (eqv? n 0) "stable" (format "unstable (~a)" n)))

(define (table->text rows)
  (define (width k) (apply max (map (lambda (r) (string-length (list-ref r k))) rows)))
  (define widths (map width '(0 1 2)))
  (define (padded s width) (string-append s (make-string (- width (string-length s)) #\space)))
  (apply string-append
         (for/list ([r (in-list rows)])
           (string-append "\n  "
                          (apply string-append
                                 (for/list ([s (in-list r)] [w (in-list widths)])
                                   (string-append (padded s w) "  ")))
                          (last r)))))

(define (end-text b)
  (case (branch-end b)
    [(range) ""]
    [(steps) "\n  more follows: (extend-branch b) goes on"]
    [(no-next-point) (string-append "\n  it ends there: " (branch-ending b))]
    [else "\n  it was broken off: (extend-branch b) goes on"]))
