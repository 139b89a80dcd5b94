#lang racket/base
;; Common to theorems with derivatives: definitions of functions of the real numbers, statements
;; that one of them is the derivative of another, and their proofs.
;;
;; `is_derive f x d` says that f has a derivative at x and that it is d; `Derive f x` alone would be
;; a number of which nothing is known where there is no derivative.  So of an unknown function U the
;; hypotheses are is_derive U x (DU x), at the places where the claim speaks of it.

(require racket/list racket/string
         "angle-facts.rkt" "claim-domain.rkt" "Coq-names.rkt" "Coq-term.rkt" "kernel-facts.rkt"
         "proof-script.rkt" "theorem-text.rkt"
         "../algebra/expression/expression.rkt" "../algebra/expression/nodes.rkt"
         "../algebra/expression/operation.rkt"
         (only-in "../generic/irrational.rkt" irrational-as-expression)
         (only-in "../value/shape.rkt" scalars scalars->structure shape-length symbols-like))

(provide scalars-in symbols-for open-relations numbered
         parameters-text definition-lines derivative-text at
         names-on-paths paths-through
         conjunction pattern-of refine-text
         known-lines derivative-proof)

;; The scalars of a value, of which theorems speak as expressions
(define (scalars-in x) (map irrational-as-expression (scalars x)))

;; Symbols that the user cannot have, in the shape of x
(define (symbols-for x name)
  (if (= 1 (shape-length x))
      (scalars->structure x (lambda (_) (string->uninterned-symbol name)))
      (symbols-like x (string-append name "_"))))

;; Where all parts of es have values and derivatives; differentiated : those of es of which
;; derivatives are taken.  All relations hold around the point as well: a radicand is positive.
(define (open-relations es differentiated)
  (append (append-map unknown-derivatives (append-map nodes-in differentiated))
          (map strict (domain-relations es))))

(define (strict d)
  (case (car d)
    [(>=) (cons '> (cdr d))]
    [(<=) (cons '< (cdr d))]
    [else d]))

;; n : a node -> of an unknown function that it has the derivative it is said to have
(define (unknown-derivatives n)
  (define h (node-head n))
  (cond [(eq? h op:abs) (give-up "it takes the derivative of an absolute value")]
        [(angle-of-point? n) (give-up "it takes the derivative of an angle of two arguments")]
        [(literal-head? h) (list (list* 'is-derivative n (derivative-nodes n)))]
        [else '()]))

;; ---------------------------------------------------------------------------
;; Texts

;; base if there is one of them, else base_0, base_1 ...
(define (numbered base n)
  (if (= n 1) (list base) (for/list ([i (in-range n)]) (format "~a_~a" base i))))

;; The parameters of all definitions, without those symbols that are their arguments
(define (parameters-text ns arguments)
  (define own (names-without ns arguments))
  (string-append*
   (append
    (if (null? (names-symbols own))
        '()
        (list (wrapped (format "Variables ~a : R." (string-join (symbol-names own) " "))) "\n"))
    (for/list ([f (in-list (names-functions own))])
      (format "Variable ~a : ~a.\n" (name-of ns f) (function-type f))))))

(define (definition-text name arguments e ns)
  (wrapped
   (format "Definition ~a (~a : R) : R := ~a." name
           (string-join (for/list ([a (in-list arguments)]) (name-of ns a)) " ")
           (term e ns))))

;; Definitions of functions of these arguments, a comment before them; none without names
(define (definition-lines comment names arguments es ns)
  (if (null? names)
      '()
      (cons (format "(* ~a *)" comment)
            (for/list ([name (in-list names)] [e (in-list es)])
              (definition-text name arguments e ns)))))

;; f, of the arguments (texts), has by the one of place k the derivative d.
(define (derivative-text f arguments k d)
  (format "is_derive (fun s => ~a ~a) ~a (~a)" f (string-join (list-set arguments k "s") " ")
          (list-ref arguments k) d))

;; (f t), of each
(define (at fs t) (for/list ([f (in-list fs)]) (format "(~a ~a)" f t)))

;; Along paths x is (path t).  Of equal nodes, b + a and a + b, the text is to be that of the
;; definitions: they are written first, in their order.
;; more : further symbols with their texts
(define (names-on-paths ns t xs paths relations stated [more '()])
  (define along (names-called ns (append (map cons xs (at paths (name-of ns t))) more)))
  (hypothesis-texts relations along)
  (for ([e (in-list stated)]) (term e along))
  along)

;; The k-th path through a place with a velocity and an acceleration, and what is known of it
(define (path-through k place speed acceleration t path velocity rate)
  (format "  destruct (path_through ~a ~a ~a ~a) as (~a & ~a & ~a & ~a & moves_~a & ~a).\n"
          place speed acceleration t path velocity
          (format "place_~a" k) (format "speed_~a" k) k rate))

;; The same of each; places, speeds, accelerations, t : texts
(define (paths-through places speeds accelerations t paths velocities [rate #f])
  (string-append*
   (for/list ([place (in-list places)] [speed (in-list speeds)] [a (in-list accelerations)]
              [path (in-list paths)] [velocity (in-list velocities)] [k (in-naturals 1)])
     (path-through k place speed a t path velocity (or rate (format "rate_~a" k))))))

(define (conjunction texts [indent "  "])
  (string-join (map wrapped texts) (format " /\\\n~a" indent)))

;; (a & b & c)
(define (pattern-of names)
  (if (null? (cdr names)) (car names) (format "(~a)" (string-join names " & "))))

(define (refine-text n)
  (format "refine ~a"
          (for/fold ([text "_"]) ([_ (in-range (- n 1))]) (format "(conj _ ~a)" text))))

;; ---------------------------------------------------------------------------
;; Proofs

;; -> lines with the facts about kernels in es, and the tactic that proves equalities by them
(define (known-lines es relations ns)
  (define-values (lines tactic)
    (proof-lines (kernel-facts (append es (append-map relation-sides relations))
                               (relations->assumptions relations) ns (divisors-in relations))
                 ns '()))               ; factors of divisors would be tried too often here
  (values (string-append* (for/list ([l (in-list lines)]) (format "  ~a\n" (wrapped l))))
          (wrapped tactic)))

;; auto_derive writes x - y as x + - y, and x / y as x * / y.
(define (derivative-proof tactic ns)
  (define several? (ormap (lambda (f) (> (unknown-function-arity f) 1)) (names-functions ns)))
  (define equal (format "first [~a | unfold Rminus, Rdiv in *; ~a]" tactic tactic))
  (if several?
      (format "(along_paths; auto_derive; [conditions | derivatives_known; paths_back; ~a])" equal)
      (format "(auto_derive; [conditions | derivatives_known; ~a])" equal)))
