#lang racket/base
;; Do two Lagrangians give equivalent equations?
;;
;; Their residuals E₁ and E₂ are linear in the accelerations: E = M a + b.  They vanish
;; together if E₂ = C E₁ with an invertible C, which may depend on the state.  In order of
;; their meaning for the Lagrangians:
;;
;;   C = 1             L₂ − L₁ is a total time derivative;
;;   C a constant c    L₂ − c L₁ is one;
;;   a matrix          C = M₂ M₁⁻¹, if M₁ and M₂ have inverses, and b₂ = C b₁.
;;
;; In the latter two c, and the determinants of M₁ and M₂, must not be 0: of the parameters in them
;; that is a condition.
;;
;; Failing these, the rows (M₁ b₁) and (M₂ b₂) must span the same space: as many of them
;; are independent, and (M₂ b₂) has the null space of (M₁ b₁).  That speaks of states in
;; general.  Where both equations restrict states, as y = 0 and y = 1 do, no motion is at
;; such a state, rows with 1 in place of 0 span the same, and nothing follows.

(require (only-in racket/list append-map in-combinations range)
         "gauge.rkt" "argument-order.rkt" "regular-masses.rkt"
         "../algebra/expression/symbols.rkt"
         "../algebra/solve/nonzero-conditions.rkt"
         "../algebra/zero/vanishing.rkt"
         "../calculus/derivative.rkt" "../calculus/expression-function.rkt"
         "../error/failure.rkt" "../error/refusal.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/notation.rkt"
         "../generic/no-truth-value.rkt"
         "../generic/value-struct.rkt" "../generic/wrong-argument.rkt"
         "../hamiltonian/as-Lagrangian.rkt"
         "../lagrangian/generic-state.rkt" "../lagrangian/Lagrange-equations.rkt"
         "../lagrangian/local-tuple.rkt" "../lagrangian/total-derivative.rkt"
         "../value/assumptions.rkt" "../value/shape.rkt"
         "../value/simplify.rkt" "../value/structure.rkt"
         "../value/matrix/linear-algebra.rkt" "../value/matrix/matrix.rkt"
         "../value/matrix/row-products.rkt"
         "../verdict/derivative-survey.rkt" "../verdict/prove-zero.rkt"
         "../verdict/question-domain.rkt"
         "../verdict/verdict.rkt")

(provide verify-equivalent-Lagrangians compare-Lagrangians
         equivalence?)

;; kind : 'total-derivative, 'proportional, 'combination, or #f if not equivalent
;; factor : C with E₂ = C E₁, a scalar or a matrix; #f if not known
;; gauge : f at the local tuple with L₂ = C L₁ + D_t f; #f if not known
(value-struct equivalence (kind factor gauge verdict)
  #:text equivalence->text
  #:notation equivalence-notation
  #:property prop:no-truth-value
  "what two Lagrangians share is neither true nor false; ask (proved? (equivalence-verdict e))")

(provide-parts equivalence? "what (compare-Lagrangians L1 L2 local) gives"
  equivalence-kind equivalence-factor equivalence-gauge equivalence-verdict)

;; local : a local tuple of symbols (up t q v), or of Hamiltonians a state (up t q p)
(define (verify-equivalent-Lagrangians L1 L2 local)
  (equivalence-verdict (compared 'verify-equivalent-Lagrangians L1 L2 local)))

(define (compare-Lagrangians L1 L2 local)
  (compared 'compare-Lagrangians L1 L2 local))

(define (compared who first second state)
  (check-order-of-arguments who '(L1 L2 local) (list first second state))
  (define-values (L1 _none1) (as-Lagrangian-at who first state))
  (define-values (L2 _none2) (as-Lagrangian-at who second state))
  (define given (as-local state))
  (check-generic-states who given L1 L2)
  (define local (lengthened ((clip-state 3) given) 4))
  (define-values (S1 S2) (values (scalar-valued who L1) (scalar-valued who L2)))
  (define-values (E1 survey1) (surveyed S1 local (domain-of S1 S2 local)))
  (define-values (E2 survey2) (surveyed S2 local (domain-of S1 S2 local)))
  (or (proportional S1 S2 E1 E2 local 1 'total-derivative)
      (let ([c (constant-ratio E1 E2 local)])
        (and c (proportional S1 S2 E1 E2 local c 'proportional)))
      (combined who (mass-rows S1 local) (mass-rows S2 local) E1 E2 local
                (list survey1 survey2) (domain-of S1 S2 local))))

;; -> expressions that have a value wherever both Lagrangians have one
(define ((domain-of L1 L2 local)) (values-at (list L1 L2) ((clip-state 3) local)))

;; -> a list of scalars, and the points that the derivatives in them met
(define (surveyed L local domain)
  (survey-derivatives (lambda () (scalars ((Euler-Lagrange-operator L) local))) (scalars local)
                      #:domain domain #:functions (lambda () (values-at (list L) local))))

;; ---------------------------------------------------------------------------
;; A constant factor

(define (proportional L1 L2 E1 E2 local c kind)
  (define domain (domain-of L1 L2 local))
  (define v
    (judged (map (lambda (a b) (g:- b (g:* c a))) E1 E2) local
            (lambda () (list (survey-of-difference (g:- L2 (g:* c L1)) local domain)))
            domain
            (nonzero-conditions c (assumptions-in-force))
            (gauge-claim L1 L2 c ((clip-state 3) local))))
  (and (proved? v)
       (equivalence kind c (gauge-at (g:- L2 (g:* c L1)) ((clip-state 3) local)) v)))

(define (gauge-at F local)
  (with-handlers ([refusal? (lambda (e) #f)])
    (simplify ((gauge-function F local) local))))

;; A kink that both have is none of the difference, simplified without taking a sign for
;; granted.
(define (survey-of-difference F local domain)
  (define state ((clip-state 3) local))
  (define rest (simplify-strictly (F state)))
  (define-values (_ survey)
    (surveyed (lambda (at) (evaluate-at rest state at)) local domain))
  survey)

;; relied-on : conditions under which the Lagrangians have the same motions if xs are zero
(define (judged xs local surveys domain [relied-on '()] [subject #f])
  (prove-zero (single-or list->down xs)
              #:domain domain #:variables (scalars local) #:surveys surveys #:resting-on relied-on
              #:about subject))

;; The quotient of two components if it is no function of the state; else #f.
(define (constant-ratio E1 E2 local)
  (define ratio
    (for/first ([a (in-list E1)] [b (in-list E2)] #:unless (zero-expression? a))
      (simplify (g:/ b a))))
  (and ratio
       (not (eqv? ratio 0))
       (not (ormap (lambda (name) (occurs? name ratio)) (scalars local)))
       ratio))

(define (zero-expression? e) (vanishes? e (assumptions-in-force)))

;; ---------------------------------------------------------------------------
;; A matrix

;; M as rows of scalars, by the accelerations in the residual.  No sign is taken for granted here:
;; the verdict would not know of it.
(define (mass-rows L local)
  (define q (coordinate local))
  (define (residual-at a)
    ((Euler-Lagrange-operator L) (up (time local) q (velocity local) a)))
  (define columns (scalars ((D residual-at) (g:* 0 q))))
  (define n (shape-length q))
  (for/list ([i (in-range n)])
    (for/list ([j (in-range n)]) (simplify-strictly (list-ref columns (+ (* n j) i))))))

;; The parts of the residual without accelerations.
(define (without-accelerations E local)
  (define rest
    (for/fold ([e (list->down E)]) ([a (in-list (scalars (acceleration local)))])
      (substitute e a 0)))
  (map simplify-strictly (scalars rest)))

(define (combined who rows1 rows2 E1 E2 local surveys domain)
  (define-values (b1 b2)
    (values (without-accelerations E1 local) (without-accelerations E2 local)))
  (define-values (M1 M2) (values (apply matrix-by-rows rows1) (apply matrix-by-rows rows2)))
  (define (regular? M) (not (zero-expression? (determinant M))))
  (if (and (regular? M1) (regular? M2))
      (by-matrix M1 M2 b1 b2 local surveys domain)
      (let ([A1 (augmented rows1 b1)] [A2 (augmented rows2 b2)])
        (when (and (restricting? M1 A1) (restricting? M2 A2)) (raise-restricting who E1 E2))
        (by-row-spaces A1 A2 local surveys domain))))

(define (by-matrix M1 M2 b1 b2 local surveys domain)
  (define C (simplify-strictly (g:* M2 (g:invert M1))))
  (define v
    (judged (map g:- b2 (matrix-times-list C b1)) local surveys domain
            (append-map (lambda (M) (regular-conditions M local)) (list M1 M2))))
  (define factor (if (null? (cdr b1)) (matrix-ref C 0 0) C))
  (equivalence (and (proved? v) 'combination) (and (proved? v) factor) #f v))

(define (matrix-times-list C b)
  (rows-times-list (map vector->list (vector->list (matrix-rows C))) b))

;; ---------------------------------------------------------------------------
;; Rows that span the same space

;; Are there accelerations at special states only?
(define (restricting? M A) (< (rank M) (rank (apply matrix-by-rows A))))

(define (raise-restricting who E1 E2)
  (raise-no-answer who
                   (string-append
                    "the equations of both Lagrangians restrict coordinates and velocities"
                    "\n  such equations are compared only where the ones are a constant "
                    "multiple of the others"
                    "\n  residuals: ~a"
                    "\n             ~a")
                   (value->text (simplify (list->down E1)))
                   (value->text (simplify (list->down E2)))))

(define (augmented rows b)
  (for/list ([row (in-list rows)] [x (in-list b)]) (append row (list x))))

;; Conditions under which a matrix of these rows has rank r: a minor keeps its value.
(define (rank-conditions rows r local)
  (define minor
    (for*/first ([chosen (in-combinations rows r)]
                 [columns (in-combinations (range (length (car rows))) r)]
                 [m (in-value (for/list ([row (in-list chosen)])
                                (for/list ([k (in-list columns)]) (list-ref row k))))]
                 #:unless (or (null? m) (zero-expression? (determinant (apply matrix-by-rows m)))))
      m))
  (if minor (regular-conditions (apply matrix-by-rows minor) local) '()))

;; Each vector that one matrix takes to zero the other must take to zero; the one of the lesser rank
;; is asked first.
(define (by-row-spaces A1 A2 local surveys domain)
  (define-values (m1 m2) (values (apply matrix-by-rows A1) (apply matrix-by-rows A2)))
  (define v
    (let-values ([(m other) (if (<= (rank m1) (rank m2)) (values m1 A2) (values m2 A1))])
      (judged (append-map (lambda (y) (rows-times-list other (scalars y))) (null-space m))
              local surveys domain
              (append-map (lambda (m A) (rank-conditions A (rank m) local))
                          (list m1 m2) (list A1 A2)))))
  (equivalence (and (proved? v) 'combination) #f #f v))

;; ---------------------------------------------------------------------------
;; In words

(define (equivalence->text e)
  (case (equivalence-kind e)
    [(total-derivative)
     (format "equivalent: the second is the first~a" (plus-derivative e))]
    [(proportional)
     (format "equivalent: the second is ~a times the first~a"
             (value->text (equivalence-factor e)) (plus-derivative e))]
    [(combination)
     (format "equivalent: the equations of the second Lagrangian combine those of the first~a"
             (if (equivalence-factor e)
                 (format "\n  factor: ~a" (value->text (equivalence-factor e)))
                 ""))]
    [else (format "~a\n~a" (inequivalence-headline e) (equivalence-verdict e))]))

(define (equivalence-notation e see)
  (define factor (equivalence-factor e))
  (define gauge (equivalence-gauge e))
  (define derivative
    (if (or (not gauge) (number? gauge))
        '()
        (list (list 1 "plus the total time derivative of" (see gauge)))))
  (case (equivalence-kind e)
    [(proportional)
     (apply statement (list 0 "equivalent: the second is" (see factor)
                            (string-append "times the first" (if gauge "" (plus-derivative e))))
            derivative)]
    [(combination)
     (apply statement
            (list 0 "equivalent: the equations of the second Lagrangian combine those of the first")
            (if factor (list (list 1 "factor:" (see factor))) '()))]
    [(total-derivative)
     (apply statement
            (list 0 (string-append "equivalent: the second is the first"
                                   (if gauge "" (plus-derivative e))))
            derivative)]
    [else (tree:listing (list (statement (list 0 (inequivalence-headline e)))
                              (see (equivalence-verdict e))))]))

(define (inequivalence-headline e)
  (if (refuted? (equivalence-verdict e))
      "not equivalent: motions of one Lagrangian leave a residual of the other"
      "undecided whether the equations are equivalent"))

(define (plus-derivative e)
  (define f (equivalence-gauge e))
  (cond [(not f) ", plus a total time derivative"]
        [(number? f) ""]
        [else (format ", plus the total time derivative of\n  ~a" (value->text f))]))
