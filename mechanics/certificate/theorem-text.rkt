#lang racket/base
;; Common to the files of all theorems: hypotheses as a definition, that they hold
;; together at a point, names and lines.

(require racket/format racket/list racket/string
         "angle-facts.rkt" "Coq-names.rkt" "Coq-term.rkt" "example-point.rkt" "kernel-facts.rkt"
         "proof-script.rkt"
         "../algebra/expression/expression.rkt" "../algebra/expression/nodes.rkt"
         "../algebra/expression/operation.rkt" "../algebra/expression/read.rkt"
         "../algebra/expression/substitute.rkt"
         "../value/algebra.rkt"
         (only-in "../algebra/assumption/assumption-set.rkt" no-assumptions))

(provide (struct-out theorem) relation-sides divisors-in relations->assumptions
         all-hypotheses relations-beyond hypotheses-text hypothesis-texts given-pattern
         theorem-with-found numbered-from-1
         example-text witness-texts example-steps
         binders all-names symbol-names for-all wrapped)

;; text       : Coq's, without what all certificates have in common
;; hypotheses : their texts
;; found      : texts of more, the domain of what was found for the proof
(struct theorem (text hypotheses found) #:authentic)

;; found : those of the relations that are the domain of what was found
(define (theorem-with-found text relations found ns)
  (theorem text (hypothesis-texts (remq* found relations) ns) (hypothesis-texts found ns)))

;; Assumptions that the algebra knows, as far as it can
(define (relations->assumptions ds)
  (with-relations no-assumptions (filter-map declarable ds)))

(define (relation-sides d)
  (for/list ([x (in-list (cdr d))]) (if (expression? x) x (datum->expression x))))

;; The expressions that are not 0
(define (divisors-in ds)
  (for/list ([d (in-list ds)] #:when (and (eq? (car d) '<>) (eqv? 0 (caddr d))))
    (car (relation-sides d))))

;; The relation as assumptions know it
(define (declarable d)
  (define sides (map expression->datum (relation-sides d)))
  (case (car d)
    [(<>) (and (eqv? 0 (cadr sides)) (list '> (list 'abs (car sides)) 0))]
    [(= is-derivative) #f]
    [else (cons (car d) sides)]))

;; ---------------------------------------------------------------------------
;; The text

;; (a m t : R) (U : R -> R)
(define (binders ns)
  (string-join
   (append (if (null? (names-symbols ns))
               '()
               (list (format "(~a : R)" (string-join (symbol-names ns) " "))))
           (for/list ([f (in-list (names-functions ns))])
             (format "(~a : ~a)" (name-of ns f) (function-type f))))
   " "))

(define (symbol-names ns) (map (lambda (s) (name-of ns s)) (names-symbols ns)))
(define (all-names ns)
  (append (symbol-names ns) (map (lambda (f) (name-of ns f)) (names-functions ns))))

(define (hypothesis-texts relations ns)
  (for/list ([d (in-list relations)]) (relation-text d ns)))

;; assumed, domain : relations -> all of them, without x <> 0 of a symbol where its sign is one, and
;; without |x| > 0 where x <> 0 is one
(define (all-hypotheses assumed domain)
  (define all (remove-duplicates (append assumed domain)))
  (filter (lambda (d) (not (implied? d all))) all))

(define (implied? d ds)
  (define x (nonzero-in d))
  (or (and x (eq? (car d) '>) (member (list '<> x 0) ds))
      (and (symbol? x)
           (for/or ([sign (in-list '(> <))]) (member (list sign x 0) ds)))))

;; x of x <> 0 and of |x| > 0, else #f
(define (nonzero-in d)
  (define left (car (relation-sides d)))
  (and (eqv? 0 (caddr d))
       (case (car d)
         [(<>) left]
         [(>) (and (headed? left op:abs) (car (node-args left)))]
         [else #f])))

;; Relations of the domain of a function found, beyond those that the claim's own imply
(define (relations-beyond own domain)
  (define not-zero (filter-map nonzero-in own))
  (define (said? d) (or (member d own) (implied? d own) (member (nonzero-in d) not-zero)))
  (filter (lambda (d) (not (said? d))) domain))

;; assumed : those of the relations that are not of the domain; found : the last of them, the
;; domain of what was found for the proof
(define (hypotheses-text assumed relations ns [found '()])
  (define own (remq* found relations))
  (define (assumed? d) (member d assumed))
  (define (listed title ds)
    (if (null? ds)
        '()
        (list (cons (format "  (* ~a *)" title) (hypothesis-texts ds ns)))))
  (define groups
    (append (listed "assumed" (filter assumed? own))
            (listed "domain: each part of the claim has a value"
                    (filter (lambda (d) (not (assumed? d))) own))
            (listed "no part of the claim: what was found for the proof has a value" found)))
  (format "~aDefinition hypotheses ~a : Prop :=\n~a.\n\n"
          (differentiable-texts relations) (binders ns)
          (if (null? groups)
              "  True"
              (string-join (for/list ([g (in-list groups)])
                             (format "~a\n  ~a" (car g) (string-join (cdr g) " /\\\n  ")))
                           " /\\\n"))))

;; Of functions of several variables, for each number of these that there is
(define (differentiable-texts relations)
  (define counts
    (for/list ([d (in-list relations)] #:when (eq? (car d) 'is-derivative)) (length (cddr d))))
  (string-append*
   (for/list ([n (in-list (sort (remove-duplicates (remv* '(1) counts)) <))])
     (define (each text) (for/list ([k (in-range 1 (+ n 1))]) (string-replace text "#" (~a k))))
     (define (words text) (string-join (each text) " "))
     (format
      (string-append
       "(* Differentiable at x, with derivatives d: along each path through x that has a velocity v,\n"
       "   f has the rate d v. *)\n"
       "Definition differentiable_~a (f : ~aR) (~a ~a : R) : Prop :=\n"
       "  forall (~a : R -> R) (t ~a : R),\n    ~a ->\n    ~a ->\n    ~a.\n\n")
      n (string-append* (make-list n "R -> ")) (words "x_#") (words "d_#") (words "p_#")
      (words "v_#")
      (string-join (each "p_# t = x_#") " -> ")
      (wrapped (string-join (each "is_derive p_# t v_#") " -> "))
      (wrapped (format "is_derive (fun s => f ~a) t (~a)" (words "(p_# s)")
                       (string-join (each "d_# * v_#") " + ")))))))

;; base_1 ... base_n
(define (numbered-from-1 base n)
  (for/list ([k (in-range 1 (+ n 1))]) (format "~a_~a" base k)))

;; The pattern that takes so many hypotheses apart, as given_1, given_2 ...
(define (given-pattern count)
  (define given (numbered-from-1 "given" count))
  (cond [(null? given) "given"]
        [(null? (cdr given)) (car given)]
        [else (format "(~a)" (string-join given " & "))]))

(define (for-all ns)
  (define b (binders ns))
  (if (string=? b "") "" (format "forall ~a," b)))

;; There are numbers for which the hypotheses hold.
(define (example-text hypotheses ns)
  (define values (example-values hypotheses ns))
  (define witnesses (witness-texts values ns))
  (define b (binders ns))
  (format "~a\nProof.\n  ~aunfold hypotheses. cbv beta.\n~aQed.\n\n"
          (wrapped (format "Theorem not_vacuous : ~ahypotheses ~a."
                           (if (string=? b "") "" (format "exists ~a, " b))
                           (string-join (all-names ns) " ")))
          (if (null? witnesses) "" (format "exists ~a. " (string-join witnesses ", ")))
          (example-steps hypotheses values ns)))

;; The values of symbols and functions, in the order of the names
(define (witness-texts values ns)
  (for/list ([u (in-list (append (names-symbols ns) (names-functions ns)))])
    (value-text u (cdr (assoc u values)) ns)))

;; Proofs of the hypotheses there
(define (example-steps hypotheses values ns)
  (steps-text (for/list ([d (in-list hypotheses)]) (at-numbers d values ns))))

;; steps : the proofs of the hypotheses, each by those before
(define (steps-text steps)
  (define n (length steps))
  (if (= n 0)
      "  exact I.\n"
      (string-append*
       (for/list ([step (in-list steps)] [k (in-naturals 1)])
         (format "  ~a\n"
                 (wrapped (if (= k n)
                              step
                              (format "apply and_later. { ~a } intro given_~a." step k))))))))

;; A hypothesis about what simplifies there is proved by the identity, and of the simpler
;; expression.
(define (at-numbers d values ns)
  (cond [(not (eq? (car d) 'is-derivative)) (relation-at-numbers d values ns)]
        [(null? (cdddr d)) "polynomial_derivative."]
        [else "polynomial_derivatives."]))

(define (relation-at-numbers d values ns)
  (define side (car (relation-sides d)))
  (define left (put-numbers (if (headed? side op:abs) (car (node-args side)) side) values))
  (define simple
    (and (node? left) (some-node? kernel-node? left) (or (simpler left) (by-points left))))
  (cond [simple
         (define-values (lines tactic)
           (proof-lines (kernel-facts (list left simple) no-assumptions ns) ns))
         (format (string-append "~a assert (number : ~a = ~a). { ~a. } "
                                "first [rewrite number; at_numbers | at_numbers].")
                 (string-join lines " ") (term left ns) (term simple ns) tactic)]
        [else "at_numbers."]))

;; e without sines and cosines of angles of points, if it has some, else #f
(define (by-points e)
  (define waves
    (for*/list ([n (in-list (nodes-in e))] [w (in-value (wave-of-angle n))] #:when w) (cons n w)))
  (and (pair? waves) (in-place-of waves e)))

(define (kernel-node? n) (not (arithmetic-node? n)))

;; Lines of at most so many columns, broken at spaces
(define (wrapped text)
  (define out (open-output-string))
  (define n (string-length text))
  (let loop ([start 0] [column #f])
    (define end
      (or (for/first ([k (in-range start n)] #:when (eqv? #\space (string-ref text k))) k) n))
    (define size (- end start))
    (define-values (before from)
      (cond [(not column) (values "" 0)]
            [(> (+ column size) 94) (values "\n    " 4)]
            [else (values " " (+ column 1))]))
    (write-string before out)
    (write-string text out start end)
    (when (< end n) (loop (+ end 1) (+ from size))))
  (get-output-string out))
