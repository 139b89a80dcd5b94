#lang racket/base
;; Names in Coq of what a claim speaks of: symbols are real numbers, literal functions are functions
;; of them.  The user's names stay; the derivative of U is DU, ∂₁∂₁F is D1_1_F.

(require racket/list racket/string
         "proof-tactics.rkt"
         "../algebra/expression/expression.rkt" "../algebra/expression/nodes.rkt"
         "../algebra/expression/operation.rkt" "../algebra/expression/symbols.rkt"
         "../scale/export/variable-names.rkt")

(provide make-names names-without names-called name-of names-symbols names-functions names-texts
         function-type function-of function-order flat-arguments
         derivative-nodes derivative-orders
         (struct-out unknown-function))

;; table : symbol or unknown-function -> string
;; symbols, functions : those of the expressions, in order
;; texts : node -> its text; so that equal nodes, b + a and a + b, have one text, which `rewrite`
;; finds
(struct names (table symbols functions texts) #:authentic)

;; index : as of a literal head; arity : how many real numbers it takes
(struct unknown-function (name index arity) #:transparent)

;; es : expressions; taken : names that the theorem itself defines
(define (make-names es [taken '()])
  (define symbols (remove-duplicates (append-map symbols-in es) eq?))
  (define functions
    (sort (remove-duplicates (append-map functions-in es)) < #:key function-order))
  (define all (append symbols (map function-symbol functions)))
  (define texts
    (identifiers all (append taken words-of-Coq (names-in-tactics)
                             (filter numbered? (identifiers all '())))))
  (names (for/hash ([x (in-list (append symbols functions))] [text (in-list texts)])
           (values x text))
         symbols functions (make-hash)))

;; Without these symbols, which keep their names
(define (names-without ns symbols)
  (struct-copy names ns [symbols (remq* symbols (names-symbols ns))]))

;; With other texts for some symbols: ((symbol . text) ...)
(define (names-called ns texts)
  (struct-copy names ns
               [table (for/fold ([table (names-table ns)]) ([t (in-list texts)])
                        (hash-set table (car t) (cdr t)))]
               [texts (make-hash)]))

(define (name-of ns x) (hash-ref (names-table ns) x))

(define (functions-in e)
  (for/list ([n (in-list (nodes-in e))] #:when (literal-head? (node-head n))) (function-of n)))

;; n : a node headed by a literal function
(define (function-of n)
  (define h (node-head n))
  (unknown-function (literal-head-name h) (literal-head-index h) (length (flat-arguments n))))

(define (function-order f) (apply + (map cdr (unknown-function-index f))))

;; The real numbers among the arguments of n, those of tuples one after the other.
(define (flat-arguments n)
  (append-map (lambda (a)
                (if (and (node? a) (memq (node-head a) (list op:up op:down)))
                    (flat-arguments a)
                    (list a)))
              (node-args n)))

;; The derivatives of a literal function, by each of these arguments
(define (derivative-nodes n)
  (for/list ([path (in-list (argument-paths n))])
    (make-node (literal-head-derivative (node-head n) path) (node-args n))))

;; How often it is differentiated by each of them
(define (derivative-orders n)
  (for/list ([path (in-list (argument-paths n))])
    (cdr (or (assoc path (literal-head-index (node-head n))) '(_ . 0)))))

;; The places of the arguments, as the index of a literal head has them
(define (argument-paths n)
  (define args (node-args n))
  (define (paths a)
    (if (and (node? a) (memq (node-head a) (list op:up op:down))) (within (node-args a)) '(())))
  (define (within args)
    (for*/list ([(a k) (in-parallel args (in-naturals))] [path (in-list (paths a))])
      (cons k path)))
  (if (null? (cdr args)) (paths (car args)) (within args)))

(define (function-symbol f)
  (define prefix
    (for/list ([entry (in-list (unknown-function-index f))])
      (define times (cdr entry))
      (if (null? (car entry))
          (make-string times #\D)
          (string-append*
           (for/list ([_ (in-range times)])
             (format "D~a_" (string-join (map number->string (car entry)) "_")))))))
  (string->symbol (format "~a~a" (string-append* prefix) (unknown-function-name f))))

;; R -> R -> R
(define (function-type f)
  (string-join (for/list ([_ (in-range (+ 1 (unknown-function-arity f)))]) "R") " -> "))

;; Names that no variable may have: words of the language, names of its library that
;; certificates use, and their own.
(define words-of-Coq
  (string-split
   (string-append
    "R PI sin cos tan exp ln sqrt asin acos atan sinh cosh tanh arcsinh Rabs Rpower D "
    "as at cofix else end exists exists2 fix for forall fun if IF in let match mod Prop return "
    "Set SProp then Type using where with by Axiom Definition Theorem Lemma Ltac Proof Qed Section "
    "True False not and or ex eq conj nat Rlt Rle Rgt Rge Rplus Rminus Rmult Rdiv Rinv Ropp pow "
    "IZR Rgt_not_eq ln_exp exp_ln exp_pos f_equal sqrt_lem_1 sqrt_sqrt Coquelicot "
    "I given hypotheses claim not_vacuous is_derive ex_derive Derive locally auto_derive")))

;; Is it a name of hypotheses, of facts in proofs, or of differentiability in so many variables?
(define (numbered? text)
  (regexp-match? #px"^(given|kernel|law|moves|rate|equation|place|speed|differentiable)_[0-9]+$"
                 text))
