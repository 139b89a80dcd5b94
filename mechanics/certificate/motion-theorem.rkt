#lang racket/base
;; A motion as a theorem: the path, the Lagrangian along it, and Lagrange's equations by
;; Coquelicot's derivatives, so that nothing rests on ours.
;;
;; The theorem gives for each coordinate q four functions of the time or numbers that are what they
;; are called: v is the derivative of q, p the derivative of L by its velocity, f by its coordinate,
;; and the derivative of p is f and the force. What has to have a value is a hypothesis, its
;; relations strict, so that it holds at times around t as well.

(require racket/list racket/string
         "claim-domain.rkt" "Coq-names.rkt" "Coq-term.rkt" "kernel-facts.rkt" "proof-script.rkt"
         "theorem-text.rkt"
         "../algebra/expression/substitute.rkt"
         "../calculus/derivative.rkt"
         "../generic/up-down.rkt"
         "../lagrangian/local-tuple.rkt"
         "../value/shape.rkt"
         (only-in "../verdict/verdict.rkt" motion-claim-L motion-claim-q motion-claim-force))

(provide motion-theorem)

;; The expressions of a motion: t, and those of each coordinate, in the order of the coordinates.
;; q, v, p, f, Q : expressions in t; L : in t and the symbols x and w of coordinates and velocities
(struct motion (t L xs ws qs vs ps fs Qs) #:authentic)

;; m : motion-claim; assumed : datums of relations
(define (motion-theorem m assumed)
  (define M (expressions-of m))
  (define along (append (motion-qs M) (motion-vs M) (motion-ps M) (motion-fs M) (motion-Qs M)
                        (list (L-along M))))
  (define domain (map strict (domain-relations along)))
  (define relations (remove-duplicates (append assumed domain)))
  (define dummies (append (motion-xs M) (motion-ws M)))
  (define ns
    (names-without (make-names (append along (append-map relation-sides assumed)
                                       (list (motion-L M) (motion-t M)) dummies)
                               (names-defined M))
                   dummies))
  (unless (null? (names-functions ns)) (give-up "it speaks of unknown functions"))
  (define facts
    (kernel-facts (append along (append-map relation-sides relations))
                  (relations->assumptions relations) ns))
  (define-values (lines tactic) (proof-lines facts ns))
  (theorem (string-append (hypotheses-text assumed domain ns)
                          (definitions M ns)
                          (statement M ns)
                          (proof M (length relations) ns lines tactic)
                          (example-text relations ns))
           (hypothesis-texts relations ns)))

;; A radicand along a motion has a derivative where it is positive.
(define (strict d)
  (case (car d)
    [(>=) (cons '> (cdr d))]
    [(<=) (cons '< (cdr d))]
    [else d]))

;; ---------------------------------------------------------------------------
;; Expressions

(define (expressions-of m)
  (define-values (L q force)
    (values (motion-claim-L m) (motion-claim-q m) (motion-claim-force m)))
  (define t 't)
  (define local ((Gamma q) t))
  (define state (up t (symbols-for (coordinate local) "q") (symbols-for (velocity local) "v")))
  (define-values (xs ws) (values (scalars (coordinate state)) (scalars (velocity state))))
  (define here
    (append (map cons xs (scalars (coordinate local))) (map cons ws (scalars (velocity local)))))
  (define (along x) (for/list ([e (in-list (scalars x))]) (in-place-of here e)))
  (motion t (L state) xs ws
          (scalars (coordinate local)) (scalars (velocity local))
          (along (((partial 2) L) state)) (along (((partial 1) L) state))
          (if force (along (force state)) (map (lambda (_) 0) xs))))

;; Symbols that the user cannot have, in the shape of x
(define (symbols-for x name)
  (if (= 1 (shape-length x))
      (scalars->structure x (lambda (_) (string->uninterned-symbol name)))
      (symbols-like x (string-append name "_"))))

(define (L-along M)
  (in-place-of (append (map cons (motion-xs M) (motion-qs M))
                       (map cons (motion-ws M) (motion-vs M)))
               (motion-L M)))

;; ---------------------------------------------------------------------------
;; The text

;; The names of the functions of all coordinates: path, or path_0, path_1 ...
(define (names-like base M)
  (define n (length (motion-qs M)))
  (if (= n 1) (list base) (for/list ([i (in-range n)]) (format "~a_~a" base i))))

;; The names that the file defines, whether or not there is a force
(define (names-defined M)
  (cons "L" (append-map (lambda (base) (names-like base M))
                        '("path" "velocity" "momentum" "slope" "force"))))

(define (definitions M ns)
  (define (of-time base es)
    (for/list ([name (in-list (names-like base M))] [e (in-list es)])
      (wrapped (format "Definition ~a (~a : R) : R := ~a." name (name-of ns (motion-t M))
                       (term e ns)))))
  (define ps (symbol-names (names-without ns (list (motion-t M)))))
  (string-join
   (append
    (list "Section motion.")
    (if (null? ps) '() (list (format "Variables ~a : R." (string-join ps " "))))
    (list "" "(* The Lagrangian, of the time, the coordinates and the velocities *)"
          (wrapped (format "Definition L (~a ~a : R) : R := ~a." (name-of ns (motion-t M))
                           (string-join (map (lambda (s) (name-of ns s))
                                             (append (motion-xs M) (motion-ws M)))
                                        " ")
                           (term (motion-L M) ns)))
          "(* The path and, the theorem says, its velocity *)")
    (of-time "path" (motion-qs M)) (of-time "velocity" (motion-vs M))
    (list "(* The derivatives of L along it, by the velocities and by the coordinates *)")
    (of-time "momentum" (motion-ps M)) (of-time "slope" (motion-fs M))
    (if (forced? M)
        (cons "(* The force outside the Lagrangian *)" (of-time "force" (motion-Qs M)))
        '())
    '("" ""))
   "\n"))

(define (forced? M) (not (andmap (lambda (Q) (eqv? Q 0)) (motion-Qs M))))

(define (claims M ns)
  (define t (name-of ns (motion-t M)))
  (define (at names) (map (lambda (name) (format "(~a ~a)" name t)) names))
  (define-values (qs vs) (values (names-like "path" M) (names-like "velocity" M)))
  (define (L-by k first?)               ; L as a function of one of its arguments
    (define arguments (append (at qs) (at vs)))
    (format "(fun x => L ~a ~a)" t
            (string-join (list-set arguments (+ k (if first? 0 (length qs))) "x") " ")))
  (append*
   (for/list ([q (in-list qs)] [v (in-list vs)] [p (in-list (names-like "momentum" M))]
              [f (in-list (names-like "slope" M))] [Q (in-list (names-like "force" M))]
              [k (in-naturals)])
     (list (format "is_derive ~a ~a (~a ~a)" q t v t)
           (format "is_derive ~a (~a ~a) (~a ~a)" (L-by k #f) v t p t)
           (format "is_derive ~a (~a ~a) (~a ~a)" (L-by k #t) q t f t)
           (format "is_derive ~a ~a (~a ~a~a)" p t f t
                   (if (forced? M) (format " + ~a ~a" Q t) ""))))))

(define (statement M ns)
  (format "Theorem claim : forall ~a : R, hypotheses ~a ->\n  ~a.\n"
          (name-of ns (motion-t M)) (string-join (symbol-names ns) " ")
          (string-join (claims M ns) " /\\\n  ")))

(define (proof M count ns lines tactic)
  (define n (length (claims M ns)))
  (define all (if (forced? M) (names-defined M) (remove* (names-like "force" M) (names-defined M))))
  (string-append
   (format "Proof.\n  intro ~a. unfold hypotheses. intros ~a.\n" (name-of ns (motion-t M))
           (given-pattern count))
   (string-append* (for/list ([l (in-list lines)]) (format "  ~a\n" (wrapped l))))
   (format "  unfold ~a.\n" (string-join all ", "))
   (format "  refine ~a;\n"
           (for/fold ([text "_"]) ([_ (in-range (- n 1))]) (format "(conj _ ~a)" text)))
   ;; auto_derive writes x - y as x + - y, and x / y as x * / y.
   (format "  (auto_derive; [conditions | ~a]).\nQed.\nEnd motion.\n\n"
           (wrapped (format "first [~a | unfold Rminus, Rdiv in *; ~a]" tactic tactic)))))
