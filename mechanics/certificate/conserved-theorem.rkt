#lang racket/base
;; A conserved quantity as a theorem: along every motion its derivative by the time is 0.
;;
;; The file defines what a motion is, for functions path and velocity of the time that are not
;; known: velocity is the derivative of path, and Lagrange's equations hold at t; or, of functions
;; coordinate and momentum, Hamilton's.  With E = 0 for these equations the rate of the quantity
;; is Σ w E, with multipliers w that are found here and checked there.
;;
;; A canonical transformation takes motions of the new Hamiltonian to motions of the old: so the old
;; time, coordinates and momenta are quantities with rates that the old Hamiltonian tells.

(require racket/list racket/string
         "claim-domain.rkt" "Coq-names.rkt" "Coq-term.rkt" "derivative-theorem.rkt"
         "example-point.rkt" "theorem-text.rkt"
         "../algebra/expression/substitute.rkt"
         "../calculus/derivative.rkt"
         "../generic/up-down.rkt"
         "../hamiltonian/Hamilton-equations.rkt" "../hamiltonian/Hamiltonian.rkt"
         "../lagrangian/local-tuple.rkt" "../lagrangian/state-derivative.rkt"
         "../question/conserved.rkt"
         "../value/matrix/linear-algebra.rkt" "../value/shape.rkt" "../value/simplify.rkt"
         "../verdict/verdict.rkt")

(provide conserved-theorem)

;; t, xs, ys   : the symbols of the state
;; as          : symbols for the rates of ys
;; function    : the expression of L or H
;; bys, byx    : its derivatives, by ys and by xs
;; Fs          : forces outside, or zeros
;; Qs          : quantities
;; laws        : of a Lagrangian, the rates of its derivatives by ys
;; multipliers : of each quantity, those of the laws; of a Hamiltonian none
;; rates       : expressions that the rates of the quantities hold, for what stands in them
;; accelerated : the rates along motions of ys; of a Hamiltonian, of xs and ys
;; old         : of a transformation, the old Hamiltonian; else #f
(struct flow (Hamiltonian? t xs ys as function by-ys by-xs Fs Qs laws multipliers rates accelerated
                           old)
  #:authentic)

;; H : of the symbols of an old state; there : at the image of the state, as its derivatives
(struct old (symbols H there by-ps by-qs) #:authentic)

;; c : conserved-claim, or canonical-claim with Hamiltonians; assumed : datums of relations
(define (conserved-theorem c assumed)
  (define M
    (cond [(canonical-claim? c) (transformed-flow c)]
          [(conserved-claim-Hamiltonian? c) (Hamiltonian-flow c)]
          [else (Lagrangian-flow c)]))
  (define before (flow-old M))
  (define stated
    (append (list (flow-function M)) (flow-by-ys M) (flow-by-xs M) (flow-Fs M) (flow-Qs M)
            (if before (cons (old-there before) (old-slopes before)) '())))
  (define proved (append stated (flow-laws M) (append* (flow-multipliers M)) (flow-rates M)))
  (define own (all-hypotheses assumed (open-relations stated (differentiated M))))
  (define found (relations-beyond own (open-relations (append* (flow-multipliers M)) '())))
  (define relations (append own found))
  (define symbols (if before (old-symbols before) '()))
  (define ns
    (names-without
     (make-names (append stated (append-map relation-sides relations) (state-symbols M) symbols
                         (if before (list (old-H before)) '()))
                 (append (list "s" "motion" "path" "velocity") (names-defined M)))
     symbols))
  (define along (names-along M ns relations stated))
  (theorem-with-found (string-append (hypotheses-text assumed relations ns found)
                                     (definitions M ns)
                                     (statement M ns along)
                                     (proof M stated proved relations ns along)
                                     (example M relations ns along))
                      relations found ns))

;; Expressions of which the theorem takes derivatives
(define (differentiated M)
  (define before (flow-old M))
  (append (list (flow-function M)) (flow-Qs M)
          (if before (list (old-there before)) '())
          (if (flow-Hamiltonian? M) '() (flow-by-ys M))))

(define (old-slopes before) (append (old-by-ps before) (old-by-qs before)))

(define (state-symbols M) (cons (flow-t M) (append (flow-xs M) (flow-ys M))))

;; ---------------------------------------------------------------------------
;; Expressions

(define (Lagrangian-flow c)
  (define-values (L Q state force)
    (values (conserved-claim-system c) (conserved-claim-Q c) (conserved-claim-state c)
            (conserved-claim-force c)))
  (define v (velocity state))
  (define a (s:map/r (lambda (_) (string->uninterned-symbol "a")) v))
  (define (number state) (car (scalars-in (L state))))
  (define P ((partial 2) number))
  (define (rates f) (along-flow f state v a))
  (define fs (scalars-in (((partial 1) number) state)))
  (define Fs (forces force state fs))
  (define n (length (scalars-in (Q state))))
  (flow #f (time state) (scalars-in (coordinate state)) (scalars-in v) (scalars-in a)
        (number state) (scalars-in (P state)) fs Fs (scalars-in (Q state))
        (rates P)
        (for/list ([k (in-range n)])
          (laws-multipliers number (lambda (s) (list-ref (scalars-in (Q s)) k)) state))
        (append (rates P) (rates Q))
        (scalars-in (simplify ((Lagrangian->acceleration L #:force force) state)))
        #f))

(define (Hamiltonian-flow c)
  (flow-of-Hamiltonian (conserved-claim-system c) (conserved-claim-Q c) (conserved-claim-state c)
                       (conserved-claim-force c) #f))

(define (transformed-flow c)
  (define-values (C state) (values (canonical-claim-C c) (canonical-claim-state c)))
  (define H (number-valued 'verify-canonical (canonical-claim-H c)))
  (define image (C state))
  (define any
    (up (symbols-for (time state) "T") (symbols-for (coordinate state) "Q")
        (symbols-for (velocity state) "P")))
  (flow-of-Hamiltonian (canonical-claim-H-prime c) C state #f
                       (old (scalars-in any) (H any) (H image)
                            (scalars-in (((partial 2) H) image))
                            (scalars-in (((partial 1) H) image)))))

(define (flow-of-Hamiltonian H Q state force before)
  (define number (number-valued 'verify-conserved H))
  (define by-ps (((partial 2) number) state))
  (define by-qs (((partial 1) number) state))
  (define Fs (forces force state (scalars-in by-qs)))
  (define-values (q-rates p-rates) ((flow-direction 'verify-conserved H force) state))
  (flow #t (time state) (scalars-in (coordinate state)) (scalars-in (velocity state)) '()
        (number state) (scalars-in by-ps) (scalars-in by-qs) Fs (scalars-in (Q state)) '() '()
        (along-flow Q state q-rates p-rates)
        (append (scalars-in q-rates) (scalars-in p-rates))
        before))

(define (forces force state like)
  (if force (scalars-in (force state)) (map (lambda (_) 0) like)))

(define (along-flow f state x-rate y-rate)
  (define-values (_ rate) (value-and-derivative-along f state (up 1 x-rate y-rate)))
  (scalars-in rate))

;; w with ∂₂Q = w ∂₂∂₂L: a simple one, or by the inverse
(define (laws-multipliers L Q state)
  (define slope (((partial 2) Q) state))
  (define simple (multipliers-of L slope state))
  (map simplify
       (scalars-in (if (pair? simple)
                       (last simple)
                       (solve-linear-left (((partial 2) ((partial 2) L)) state) slope)))))

;; ---------------------------------------------------------------------------
;; Names

(define (names-like M base) (numbered base (length (flow-xs M))))
(define (quantity-names M)
  (if (flow-old M)
      (cons "old_time" (append (names-like M "old_coordinate") (names-like M "old_momentum")))
      (numbered "quantity" (length (flow-Qs M)))))
(define (base M) (cond [(flow-old M) "new_H"] [(flow-Hamiltonian? M) "H"] [else "L"]))
(define (old-rate-names M) (if (flow-old M) (names-like M "old_rate") '()))
(define (old-slope-names M) (if (flow-old M) (names-like M "old_slope") '()))
(define (by-ys-names M) (names-like M (if (flow-Hamiltonian? M) "rate" "momentum")))
(define (by-xs-names M) (names-like M "slope"))
(define (force-names M) (names-like M "force"))
(define (forced? M) (not (andmap (lambda (F) (eqv? F 0)) (flow-Fs M))))

;; The functions of the time that a motion is
(define (x-paths M) (names-like M (if (flow-Hamiltonian? M) "coordinate" "path")))
(define (y-paths M) (names-like M (if (flow-Hamiltonian? M) "momentum" "velocity")))
(define (accelerations M) (numbered "acceleration" (length (flow-as M))))

(define (names-defined M)
  (append (list (base M)) (by-ys-names M) (by-xs-names M) (force-names M) (quantity-names M)
          (x-paths M) (y-paths M) (accelerations M) (of-old-only M)))

(define (of-old-only M)
  (if (flow-old M) (cons "old_H" (append (old-rate-names M) (old-slope-names M))) '()))

;; The names of functions that the file defines and that proofs unfold
(define (to-unfold M)
  (append (list (base M)) (by-ys-names M) (by-xs-names M) (if (forced? M) (force-names M) '())
          (quantity-names M) (of-old-only M)))

(define (names-along M ns relations stated)
  (names-on-paths ns (flow-t M) (append (flow-xs M) (flow-ys M)) (append (x-paths M) (y-paths M))
                  relations stated
                  (map cons (flow-as M) (accelerations M))))

;; ---------------------------------------------------------------------------
;; The statement

(define (definitions M ns)
  (define arguments (state-symbols M))
  (define (each comment names es) (definition-lines comment names arguments es ns))
  (define H? (flow-Hamiltonian? M))
  (string-join
   (append
    (list "Section system." (parameters-text ns arguments))
    (each (if H? "The Hamiltonian" "The Lagrangian") (list (base M)) (list (flow-function M)))
    (each (format "Its derivatives, the theorem says, by the ~a and by the coordinates"
                  (if H? "momenta" "velocities"))
          (append (by-ys-names M) (by-xs-names M)) (append (flow-by-ys M) (flow-by-xs M)))
    (if (forced? M)
        (each (format "The force outside the ~a" (if H? "Hamiltonian" "Lagrangian"))
              (force-names M) (flow-Fs M))
        '())
    (each (if (flow-old M) "The transformation" "The quantity") (quantity-names M) (flow-Qs M))
    (if (flow-old M) (old-definitions M each ns) '())
    (list "(* What a motion does at the time t *)"
          (format "Definition motion (~a : R -> R) (t : R) : Prop :=\n  ~a.\n\n"
                  (string-join (append (x-paths M) (y-paths M)) " ")
                  (conjunction (motion-parts M)))))
   "\n"))

(define (old-definitions M each ns)
  (define before (flow-old M))
  (append
   (definition-lines "The old Hamiltonian" '("old_H") (old-symbols before) (list (old-H before)) ns)
   (each "and, the theorem says, its derivatives by the old momenta and coordinates"
         (append (old-rate-names M) (old-slope-names M)) (old-slopes before))))

;; f t (x t) (y t)
(define (value-along M f t)
  (string-join (list* f t (at (append (x-paths M) (y-paths M)) t)) " "))

(define (motion-parts M)
  (define (there f) (value-along M f "t"))
  (define (with-force text F) (if (forced? M) (format "~a + ~a" text (there F)) text))
  (define (is f d) (format "is_derive ~a t (~a)" f d))
  (if (flow-Hamiltonian? M)
      (append (map (lambda (x v) (is x (there v)))
                   (x-paths M) (by-ys-names M))
              (map (lambda (y f F) (is y (with-force (format "- ~a" (there f)) F)))
                   (y-paths M) (by-xs-names M) (force-names M)))
      (append (map (lambda (x v) (is x (format "~a t" v))) (x-paths M) (y-paths M))
              (map (lambda (v) (format "ex_derive ~a t" v)) (y-paths M))
              (map (lambda (p f F) (is (format "(fun s => ~a)" (value-along M p "s"))
                                       (with-force (there f) F)))
                   (by-ys-names M) (by-xs-names M) (force-names M)))))

;; The derivatives of L or H
(define (derivatives M ns)
  (define arguments (for/list ([s (in-list (state-symbols M))]) (name-of ns s)))
  (define n (length (flow-xs M)))
  (define (each names first-place)
    (for/list ([name (in-list names)] [k (in-naturals first-place)])
      (derivative-text (base M) arguments k (string-join (cons name arguments) " "))))
  (define (there f) (string-join (cons f arguments) " "))
  (define image (map (lambda (Q) (format "(~a)" (there Q))) (quantity-names M)))
  (define (each-old names first-place)
    (for/list ([name (in-list names)] [k (in-naturals first-place)])
      (derivative-text "old_H" image k (there name))))
  (append (each (by-ys-names M) (+ n 1)) (each (by-xs-names M) 1)
          (each-old (old-rate-names M) (+ n 1)) (each-old (old-slope-names M) 1)))

(define (conserved M t)
  (define changes
    (if (flow-old M)
        (cons "1" (append (for/list ([f (in-list (old-rate-names M))]) (value-along M f t))
                          (for/list ([f (in-list (old-slope-names M))])
                            (format "- ~a" (value-along M f t)))))
        (map (lambda (_) "0") (flow-Qs M))))
  (for/list ([Q (in-list (quantity-names M))] [change (in-list changes)])
    (format "is_derive (fun s => ~a) ~a ~a" (value-along M Q "s") t
            (if (string-contains? change " ") (format "(~a)" change) change))))

(define (statement M ns along)
  (define t (name-of ns (flow-t M)))
  (define paths (string-join (append (x-paths M) (y-paths M)) " "))
  (string-append
   (format "Theorem claim :\n  (forall ~a : R, hypotheses ~a ->\n    ~a) /\\\n"
           (string-join (map (lambda (s) (name-of ns s)) (state-symbols M)) " ")
           (string-join (all-names ns) " ")
           (conjunction (derivatives M ns) "    "))
   (format (string-append "  (forall (~a : R -> R) (~a : R),\n    hypotheses ~a ->\n"
                          "    motion ~a ~a ->\n    ~a).\n")
           paths t (wrapped (string-join (all-names along) " ")) paths t
           (conjunction (conserved M t) "    "))))

;; ---------------------------------------------------------------------------
;; The proof

(define (proof M stated proved relations ns along)
  (define unfold (string-join (to-unfold M) ", "))
  (define given (given-pattern (length relations)))
  (define-values (lines tactic) (known-lines stated relations ns))
  (define-values (lines-along tactic-along) (known-lines proved relations along))
  (define t (name-of ns (flow-t M)))
  (string-append
   "Proof.\n  split.\n  { unfold hypotheses. intros "
   (string-join (map (lambda (s) (name-of ns s)) (state-symbols M)) " ") " " given ".\n"
   lines
   (format "  unfold ~a.\n  ~a;\n  ~a. }\n" unfold
           (refine-text (* (if (flow-old M) 4 2) (length (flow-xs M))))
           (derivative-proof tactic ns))
   (format "  unfold hypotheses, motion. intros ~a ~a ~a ~a.\n"
           (string-join (append (x-paths M) (y-paths M)) " ") t given (motion-pattern M))
   (format "  unfold ~a in *.\n" unfold)
   lines-along
   (laws-used M along (derivative-proof tactic-along ns))
   (format "  ~a.\n" (refine-text (length (flow-Qs M))))
   (string-append* (map (lambda (k) (quantity-proof M k along tactic-along))
                        (range (length (flow-Qs M)))))
   "Qed.\nEnd system.\n\n"))

;; The parts of a motion, taken apart
(define (motion-pattern M)
  (define n (length (flow-xs M)))
  (define (names base) (numbered-from-1 base n))
  (pattern-of
   (if (flow-Hamiltonian? M)
       (append (names "moves") (names "law"))
       (append (names "moves")
               (map (lambda (a r) (format "(~a & ~a)" a r)) (accelerations M) (names "rate"))
               (names "law")))))

;; Lagrange's equations: differences that are 0
(define (law-texts M along)
  (define (in-parentheses e) (format "(~a)" (term e along)))
  (for/list ([p (in-list (flow-laws M))] [f (in-list (flow-by-xs M))] [F (in-list (flow-Fs M))])
    (wrapped (if (forced? M)
                 (format "~a - (~a + ~a)" (in-parentheses p) (in-parentheses f) (in-parentheses F))
                 (format "~a - ~a" (in-parentheses p) (in-parentheses f))))))

;; By derivatives of unknown functions.  A law whose momentum is a velocity would be taken for the
;; rate of that velocity: each is forgotten when it has given its equation.
(define (laws-used M along derivative)
  (define ks (range 1 (+ 1 (length (flow-laws M)))))
  (define forget
    (string-append "clear" (string-append* (for/list ([k (in-list ks)]) (format " law_~a" k)))))
  (define (equation E k)
    (format "  assert (equation_~a : ~a = 0).\n  { ~a ~a.\n    ~a. }\n" k E
            (format "refine (same_derivative _ _ _ _ _ law_~a)." k) forget derivative))
  (if (flow-Hamiltonian? M)
      ""
      (string-append (string-append* (map equation (law-texts M along) ks))
                     (format "  ~a.\n" forget))))

(define (quantity-proof M k along tactic)
  (cond [(flow-Hamiltonian? M) (format "  ~a.\n" (derivative-proof tactic along))]
        [else
         (define ws (list-ref (flow-multipliers M) k))
         (define terms
           (for/list ([w (in-list ws)] [E (in-list (law-texts M along))] [k (in-naturals 1)]
                      #:unless (eqv? w 0))
             (cons (format "(~a) * (~a)" (term w along) E) k)))
         (define sum (if (null? terms) "0" (string-join (map car terms) " + ")))
         (format "  { assert (law : ~a = 0) by (~aring).\n    ~a. }\n" (wrapped sum)
                 (string-append* (for/list ([t (in-list terms)])
                                   (format "rewrite equation_~a; " (cdr t))))
                 (derivative-proof (format "(refine (eq_trans _ law); ~a)" tactic) along))]))

;; ---------------------------------------------------------------------------
;; An example: a motion at a point where the hypotheses hold

(define (example M relations ns along)
  (define values
    (example-values (append relations (domain-relations (flow-accelerated M))) ns))
  (define t (name-of ns (flow-t M)))
  (define own (names-without ns (cdr (state-symbols M))))
  (define paths (append (x-paths M) (y-paths M)))
  (format (string-append
           "Theorem not_vacuous : exists ~a (~a : R -> R),\n"
           "  ~a /\\\n  ~a.\n"
           "Proof.\n~a  exists ~a, ~a.\n"
           "  split.\n  { ~a. unfold hypotheses. cbv beta.\n~a  }\n~a"
           "Qed.\n\n")
          (binders own) (string-join paths " ")
          (wrapped (format "hypotheses ~a" (string-join (all-names along) " ")))
          (wrapped (string-join (append '("motion") (motion-parameters M ns) paths (list t)) " "))
          (through-text M values ns)
          (wrapped (string-join (witness-texts values own) ", ")) (string-join paths ", ")
          (placed M) (example-steps relations values ns)
          (motion-at-numbers M values ns)))

;; Paths through the point, as hypotheses about them
(define (through-text M values ns)
  (define (number s) (value-text s (cdr (assoc s values)) ns))
  (define (at-point e) (format "(~a)" (term (put-numbers e values) ns)))
  (define t (number (flow-t M)))
  (define xs (map number (flow-xs M)))
  (define ys (map number (flow-ys M)))
  (define rates (map at-point (flow-accelerated M)))
  (define n (length rates))
  (if (flow-Hamiltonian? M)
      (paths-through (append xs ys) rates (make-list n "0") t (append (x-paths M) (y-paths M))
                     (numbered-from-1 "velocity" n) "_")
      (paths-through xs ys rates t (x-paths M) (y-paths M))))

;; Puts the point in place of the paths.
(define (placed M)
  (define n (length (flow-xs M)))
  (define (names base n) (numbered-from-1 (string-append "?" base) n))
  (format "rewrite ~a"
          (string-join (if (flow-Hamiltonian? M)
                           (names "place" (* 2 n))
                           (append (names "place" n) (names "speed" n)))
                       ", ")))

(define (motion-at-numbers M values ns)
  (define rates (map cons (flow-as M) (if (flow-Hamiltonian? M) '() (flow-accelerated M))))
  (define es
    (for/list ([e (in-list (append (flow-laws M) (flow-by-xs M) (flow-by-ys M) (flow-Fs M)
                                   (flow-accelerated M)))])
      (put-numbers (in-place-of rates e) values)))
  (define-values (lines tactic) (known-lines es '() ns))
  (define unfold
    (remove* (append (quantity-names M) (of-old-only M))
             (cons "motion" (remove (base M) (to-unfold M)))))
  (define here (string-append (placed M) "; cbv beta"))
  (define equal
    (format "first [numbers_equal | ~a]"
            (string-replace tactic "nonzero" "first [nonzero | at_numbers]")))
  (format "~a  unfold ~a. ~a;\n  ~a.\n" lines
          (string-join unfold ", ") (refine-text (length (motion-parts M)))
          (wrapped
           (format (string-append
                    "first [ derivative_there "
                    "| match goal with H : is_derive ?f ?x _ |- is_derive ?f ?x _ => "
                    "refine (derivative_as _ _ _ _ H _) end; ~a; ~a "
                    "| auto_derive; [ ~a; conditions_at_numbers "
                    "| derivatives_known; ~a; ~a ] ]")
                   here equal here here equal))))

;; The parameters that the definition of a motion speaks of, as Coq takes them out of the section
(define (motion-parameters M ns)
  (define es (append (flow-by-ys M) (flow-by-xs M) (flow-Fs M)))
  (define inner (make-names es))
  (define state (state-symbols M))
  (append
   (for/list ([s (in-list (names-symbols ns))]
              #:when (and (memq s (names-symbols inner)) (not (memq s state))))
     (name-of ns s))
   (for/list ([f (in-list (names-functions ns))] #:when (member f (names-functions inner)))
     (name-of ns f))))
