#lang racket/base
;; A motion as a theorem: the path, the Lagrangian along it, and Lagrange's equations by
;; Coquelicot's derivatives, so that nothing rests on ours.
;;
;; The theorem gives for each coordinate q four functions of the time or numbers that are what they
;; are called: v is the derivative of q, p the derivative of L by its velocity, f by its coordinate,
;; and the derivative of p is f and the force, with those of constraints: multipliers times their
;; derivatives. What has to have a value is a hypothesis, its relations strict, so that it holds at
;; times around t as well.  Of a Hamiltonian H the functions are q and p with the derivatives of H,
;; and Hamilton's equations.

(require racket/list racket/string
         "Coq-names.rkt" "derivative-theorem.rkt"
         "theorem-text.rkt"
         "Coq-term.rkt"
         "../algebra/expression/substitute.rkt" "../algebra/expression/symbols.rkt"
         "../calculus/derivative.rkt"
         "../constraint/constraint.rkt" "../constraint/constraint-jacobian.rkt"
         "../generic/arithmetic.rkt" "../generic/up-down.rkt"
         "../hamiltonian/Hamilton-equations.rkt"
         "../lagrangian/local-tuple.rkt"
         "../value/matrix/linear-algebra.rkt" "../value/shape.rkt" "../value/simplify.rkt"
         (only-in "../value/structure.rkt" list->down)
         "../verdict/verdict.rkt")

(provide motion-theorem)

;; The expressions of a motion: t, and those of each coordinate, in the order of the coordinates.
;; q, v, p, f, Q : expressions in t; L : in t and the symbols x and w of coordinates and velocities
;; ties : of the constraints
;; Hamiltonian? : is L one, w and v the momenta, and p the derivatives by these?
(struct motion (t L xs ws qs vs ps fs Qs ties Hamiltonian?) #:authentic)

;; G       : the constraint, in t, x and w
;; first   : the place, among t, x and w, of the first by which it is differentiated
;; normals : these derivatives along the path
;; multiplier : expression in t
(struct tie (G first normals multiplier) #:authentic)

;; m : motion-claim; assumed : datums of relations
(define (motion-theorem m assumed)
  (define M (expressions-of m assumed))
  (define ties (motion-ties M))
  (define differentiated
    (append (motion-qs M) (if (motion-Hamiltonian? M) (motion-vs M) (motion-ps M))
            (map (lambda (e) (along-path M e)) (cons (motion-L M) (map tie-G ties)))))
  (define multipliers (map tie-multiplier ties))
  (define (with multipliers)
    (append differentiated (motion-vs M) (motion-fs M) (motion-Qs M)
            multipliers (append-map tie-normals ties)))
  (define along (with multipliers))
  (define asked (if (motion-claim-multipliers m) along (with '())))
  (define own (all-hypotheses assumed (open-relations asked differentiated)))
  (define found (relations-beyond own (open-relations multipliers '())))
  (define relations (append own found))
  (define dummies (append (motion-xs M) (motion-ws M)))
  (define ns
    (names-without (make-names (append along (append-map relation-sides relations)
                                       (list* (motion-L M) (motion-t M) (map tie-G ties)) dummies)
                               (cons "s" (names-defined M)))
                   dummies))
  (define-values (lines tactic) (known-lines along relations ns))
  (theorem-with-found (string-append (hypotheses-text assumed relations ns found)
                                     (definitions M ns)
                                     (statement M ns)
                                     (proof M (length relations) ns lines tactic)
                                     (example-text relations ns))
                      relations found ns))

;; ---------------------------------------------------------------------------
;; Expressions

(define (expressions-of m assumed)
  (define-values (L force) (values (motion-claim-system m) (motion-claim-force m)))
  (define t (time-symbol m assumed))
  (define states (states-of m))
  (define local (states t))
  (define state (up t (symbols-for (coordinate local) "q") (symbols-for (velocity local) "v")))
  (define-values (xs ws) (values (scalars-in (coordinate state)) (scalars-in (velocity state))))
  (define-values (qs vs) (values (scalars-in (coordinate local)) (scalars-in (velocity local))))
  (define (along x)
    (for/list ([e (in-list (scalars-in x))])
      (in-place-of (append (map cons xs qs) (map cons ws vs)) e)))
  (define (momentum t) (((partial 2) L) (states t)))
  (define fs (along (((partial 1) L) state)))
  (define Qs (if force (along (force state)) (map (lambda (_) 0) xs)))
  (define (residual)
    (define rates (scalars-in (derivative-at momentum t)))
    (for/list ([p (in-list rates)] [f (in-list fs)] [Q (in-list Qs)])
      (g:- p (g:+ f Q))))
  (motion t (L state) xs ws qs vs (along (((partial 2) L) state)) fs Qs
          (ties-of m local state residual) (and (motion-claim-p m) #t)))

;; t -> local tuple, or state with momenta
(define (states-of m)
  (if (motion-claim-p m)
      (states-along 'certificate (motion-claim-q m) (motion-claim-p m))
      (Gamma (motion-claim-q m))))

;; 't, or 'time where that is a parameter; assumptions about 't may mean either.
(define (time-symbol m assumed)
  (define (assumed? name)
    (for*/or ([d (in-list assumed)] [e (in-list (relation-sides d))]) (occurs? name e)))
  (cond [(not (parameter? 't m)) 't]
        [(or (assumed? 't) (assumed? 'time))
         (give-up "the symbol t is a parameter, and assumptions may mean it or the time")]
        [(parameter? 'time m) (give-up "the symbols t and time are parameters")]
        [else 'time]))

;; Does the symbol occur in what is asked, at another time?
(define (parameter? name m)
  (define local ((states-of m) (string->uninterned-symbol "t")))
  (define-values (force constraints multipliers)
    (values (motion-claim-force m) (motion-claim-constraints m) (motion-claim-multipliers m)))
  (define all
    (list local
          ((motion-claim-system m) local)
          (if force (force local) 0)
          (if multipliers (multipliers (time local)) 0)
          (if constraints
              (constraint-values 'certificate
                                 (gather-with 'certificate (motion-claim-system m) constraints)
                                 local)
              0)))
  (for*/or ([x (in-list all)] [e (in-list (scalars-in x))]) (occurs? name e)))

;; find-residual : -> what the forces of constraints have to be, where no multipliers are given
(define (ties-of m local state find-residual)
  (define-values (L constraints multipliers)
    (values (motion-claim-system m) (motion-claim-constraints m) (motion-claim-multipliers m)))
  (define cs (if constraints (constraint-set-parts (gather-with 'certificate L constraints)) '()))
  (define (values-at c state)
    (scalars-in (value-of 'certificate c (time state) (coordinate state) (velocity state))))
  (define rows
    (if constraints
        (map vector->list
             (jacobian-rows 'certificate (gather-with 'certificate L constraints) local))
        '()))
  (define lambdas
    (if multipliers (scalars-in (multipliers (time local))) (multipliers-by rows find-residual)))
  (define n (shape-length (coordinate local)))
  (for/list ([G (in-list (append-map (lambda (c) (values-at c state)) cs))]
             [c (in-list (append-map (lambda (c) (map (lambda (_) c) (values-at c state))) cs))]
             [row (in-list rows)] [multiplier (in-list lambdas)])
    (tie G (if (holonomic? c) 1 (+ n 1)) row multiplier)))

;; λ with J Jᵀ λ = J r
(define (multipliers-by rows find-residual)
  (define (dot a b) (apply g:+ (map g:* a b)))
  (cond [(null? rows) '()]
        [else
         (define r (find-residual))
         (define J-J (list->down (for/list ([a (in-list rows)])
                                   (list->down (for/list ([b (in-list rows)]) (dot a b))))))
         (define J-r (list->down (map (lambda (a) (dot a r)) rows)))
         (scalars-in (simplify (solve-linear-left J-J J-r)))]))

(define (along-path M e)
  (in-place-of (append (map cons (motion-xs M) (motion-qs M))
                       (map cons (motion-ws M) (motion-vs M)))
               e))

;; ---------------------------------------------------------------------------
;; The text

;; The names that a file of a Hamiltonian has for the same
(define names-for-Hamiltonian
  (hash "L" "H" "path" "coordinate" "velocity" "momentum" "momentum" "rate"))

(define (own-name base M)
  (if (motion-Hamiltonian? M) (hash-ref names-for-Hamiltonian base base) base))

;; The names of the functions of all coordinates: path, or path_0, path_1 ...
(define (names-like base M) (numbered (own-name base M) (length (motion-qs M))))

(define (names-tied base M)
  (if (null? (motion-ties M)) '() (numbered base (length (motion-ties M)))))

;; Of each constraint, of the functions of all coordinates
(define (normal-names M)
  (for/list ([name (in-list (names-tied "normal" M))]) (names-like name M)))

;; The names that the file defines, whether or not there is a force
(define (names-defined M)
  (append (list (own-name "L" M))
          (append-map (lambda (base) (names-like base M))
                      '("path" "velocity" "momentum" "slope" "force"))
          (names-tied "constraint" M) (names-tied "multiplier" M) (append* (normal-names M))))

(define (forced? M) (not (andmap (lambda (Q) (eqv? Q 0)) (motion-Qs M))))

(define (definitions M ns)
  (define-values (system second path)
    (if (motion-Hamiltonian? M)
        (values "Hamiltonian" "momenta" "The path: coordinates and momenta")
        (values "Lagrangian" "velocities" "The path and, the theorem says, its velocity")))
  (define L (own-name "L" M))
  (define (of-time comment bases . es)
    (definition-lines comment (append-map (lambda (base) (names-like base M)) bases)
                      (list (motion-t M)) (append* es) ns))
  (string-join
   (append
    (list "Section motion." (parameters-text ns (list (motion-t M))))
    (definition-lines (format "The ~a, of the time, the coordinates and the ~a" system second)
                      (list L) (state-symbols M) (list (motion-L M)) ns)
    (of-time path '("path" "velocity") (motion-qs M) (motion-vs M))
    (of-time (format "The derivatives of ~a along it, by the ~a and by the coordinates" L second)
             '("momentum" "slope") (motion-ps M) (motion-fs M))
    (if (forced? M)
        (of-time (format "The force outside the ~a" system) '("force") (motion-Qs M))
        '())
    (tie-definitions M ns)
    '("" ""))
   "\n"))

(define (state-symbols M) (cons (motion-t M) (append (motion-xs M) (motion-ws M))))

(define (tie-definitions M ns)
  (define-values (ties t) (values (motion-ties M) (list (motion-t M))))
  (append
   (definition-lines "The constraints" (names-tied "constraint" M) (state-symbols M)
                     (map tie-G ties) ns)
   (definition-lines "their derivatives" (append* (normal-names M)) t
                     (append-map tie-normals ties) ns)
   (definition-lines "and multipliers" (names-tied "multiplier" M) t (map tie-multiplier ties) ns)))

(define (claims M ns)
  (define t (name-of ns (motion-t M)))
  (define state
    (cons t (append (at (names-like "path" M) t) (at (names-like "velocity" M) t))))
  (append
   (append* (for/list ([k (in-range (length (motion-qs M)))]) (equations M k state t)))
   (for/list ([name (in-list (names-tied "constraint" M))])
     (format "~a ~a = 0" name (string-join state " ")))
   (for*/list ([(G normals name) (in-parallel (motion-ties M) (normal-names M)
                                              (names-tied "constraint" M))]
               [(normal k) (in-parallel normals (in-naturals (tie-first G)))])
     (derivative-text name state k (format "~a ~a" normal t)))))

;; Of the k-th coordinate
(define (equations M k state t)
  (define-values (q v p f Q)
    (apply values (for/list ([base (in-list '("path" "velocity" "momentum" "slope" "force"))])
                    (list-ref (names-like base M) k))))
  (define (slope f place) (derivative-text (own-name "L" M) state place (format "~a ~a" f t)))
  (define-values (rate moved sign)
    (if (motion-Hamiltonian? M) (values p v "- ") (values v p "")))
  (list (format "is_derive ~a ~a (~a ~a)" q t rate t)
        (slope p (+ 1 k (length (motion-qs M))))
        (slope f (+ 1 k))
        (format "is_derive ~a ~a (~a~a ~a~a~a)" moved t sign f t
                (if (forced? M) (format " + ~a ~a" Q t) "") (constraint-force M k t))))

;; Multipliers times the derivatives by the k-th coordinate
(define (constraint-force M k t)
  (string-append*
   (for/list ([normals (in-list (normal-names M))] [factor (in-list (names-tied "multiplier" M))])
     (format " + ~a ~a * ~a ~a" factor t (list-ref normals k) t))))

(define (statement M ns)
  (format "Theorem claim : forall ~a : R, hypotheses ~a ->\n  ~a.\n"
          (name-of ns (motion-t M)) (wrapped (string-join (all-names ns) " "))
          (conjunction (claims M ns))))

(define (proof M count ns lines tactic)
  (define all (if (forced? M) (names-defined M) (remove* (names-like "force" M) (names-defined M))))
  (format "Proof.\n  intro ~a. unfold hypotheses. intros ~a.\n~a  unfold ~a.\n  ~a;\n  ~a.\n~a"
          (name-of ns (motion-t M)) (given-pattern count) lines
          (wrapped (string-join all ", "))
          (refine-text (length (claims M ns)))
          (if (null? (motion-ties M))
              (derivative-proof tactic ns)
              (format "first [~a | ~a]" (derivative-proof tactic ns) tactic))
          "Qed.\nEnd motion.\n\n"))
