#lang racket/base
;; Conditions imposed: what a verdict says would have to hold is made to hold in what was asked
;; about, and the question is asked again.
;;
;; A condition is a list of equations that hold together.  Each is solved for one of its
;; symbols, which is replaced wherever it stands; if it may be either root of a square, by the
;; one that is not negative, and if both sides have a factor in common, as if that were not 0:
;; the verdict says so.  In a function it is replaced in the value;
;; of derivatives of the function in their parts.  Only the tape of a gradient knows values
;; from before: a function is given symbols in place of those, and what it makes of them is
;; evaluated on the tape.

(require (only-in racket/list append-map count remove-duplicates)
         (only-in racket/string string-join)
         "../algebra/expression/constant-value.rkt" "../algebra/expression/expression.rkt"
         "../algebra/expression/operation.rkt" "../algebra/expression/symbols.rkt"
         "../calculus/expression-function.rkt" "../calculus/perturbed.rkt"
         "../calculus/recorded.rkt"
         "../constraint/constraint.rkt"
         "../error/complain.rkt"
         "../generic/describe.rkt" "../generic/function.rkt" "../generic/kind.rkt"
         "../value/algebra.rkt" "../value/assumptions.rkt" "../value/read-expression.rkt"
         "../value/shape.rkt"
         "../verdict/verdict.rkt")

(provide impose verify-again)

;; condition : an equation, a list of them, or a verdict, whose first choice it is
;; x : a value, a function, a constraint, or a list of these
(define (impose condition x)
  (define equations (equations-of 'impose condition x))
  (check-thing x)
  (put (solved 'impose equations) equations x))

;; The verdict on the question of v under the condition, by default the one that v tells.
(define (verify-again v [condition v])
  (check-verdict v condition)
  (define equations (equations-of 'verify-again condition))
  (define replacements (solved 'verify-again equations))
  (define met (make-hasheq))
  (define (change x)
    (put replacements equations x (lambda (replaced) (hash-set! met replaced #t))))
  (define again
    (call-assuming (known-relations (map change (verdict-given v)))
                   (lambda () ((verdict-question v) change))
                   'verify-again))
  (unless (eq? condition v) (check-met v equations replacements met))
  (with-remark again
               (string-append "under the condition " (equations->text equations)
                              (choices->text (roots-taken equations replacements)
                                             (factors-in-common equations)))))

(define (check-verdict v condition)
  (unless (verdict? v)
    (if (verdict? condition)
        (complain 'verify-again
                  "the verdict comes first, then the condition: (verify-again v '(= k m))")
        (raise-argument-error 'verify-again "verdict?" v))))

;; met : those symbols that were replaced in what was asked.  Others may stand in another
;; equation.
(define (check-met v equations replacements met)
  (define (linked? s)
    (> (count (lambda (q) (or (occurs? s (cadr q)) (occurs? s (caddr q)))) equations) 1))
  (for ([r (in-list replacements)])
    (define s (car r))
    (unless (or (not (symbol? s)) (hash-ref met s #f) (linked? s))
      (complain 'verify-again
                (string-append "the symbol ~a does not occur in what was asked, so that the "
                               "condition changes nothing\n  symbols of the residual: ~a")
                s (value->text (residual-symbols v))))))

(define (residual-symbols v)
  (remove-duplicates
   (append-map (lambda (e) (if (expression? e) (symbols-in e) '()))
               (scalars (verdict-residual v)))))

(define (equations->text equations)
  (string-join (for/list ([q (in-list equations)])
                 (format "~a = ~a" (value->text (cadr q)) (value->text (caddr q))))
               ", "))

;; roots : equations; factors : expressions that are taken not to be 0
(define (choices->text roots factors)
  (define texts
    (append (if (null? roots) '() (list (equations->text roots)))
            (for/list ([f (in-list factors)]) (format "~a not 0" (value->text f)))))
  (if (null? texts) "" (string-append ", with " (string-join texts ", "))))

;; Relations that still speak of something.
(define (known-relations relations)
  (for/list ([r (in-list relations)]
             #:unless (and (number? (cadr r)) (number? (caddr r)) (eval-relation r)))
    r))

(define (eval-relation r)
  (define compare (case (car r) [(>) >] [(>=) >=] [(<) <] [else <=]))
  (compare (cadr r) (caddr r)))

;; ---------------------------------------------------------------------------
;; The condition

;; other : what came with the condition
;; -> ((= value value) ...)
(define (equations-of who condition [other #f])
  (cond [(verdict? condition) (equations-of who (first-alternative who condition))]
        [(equation? condition) (list (read-equation who condition))]
        [(list-of-equations? condition)
         (for/list ([q (in-list condition)]) (read-equation who q))]
        [else
         (complain who "expected a verdict, an equation '(= k 1) or a list of them; given ~a~a"
                   (describe-with-value condition)
                   (condition-hint condition other))]))

(define (condition-hint x other)
  (define (list-of? what?) (and (pair? x) (list? x) (andmap what? x)))
  (cond [(list-of? (lambda (c) (and (list? c) (andmap equation? c))))
         "\n  these are alternatives: choose one, as (car (verdict-alternatives v))"]
        [(and (pair? x) (memq (car x) '(< > <= >=))) "\n  an inequality is declared by assume"]
        [(or (procedure? x) (verdict? other) (equation? other) (list-of-equations? other))
         "\n  the condition comes first"]
        [else ""]))

(define (list-of-equations? x) (and (pair? x) (list? x) (andmap equation? x)))

(define (equation? x)
  (and (list? x) (= (length x) 3) (eq? (car x) '=)))

(define (read-equation who x)
  (define q (read-expression x))
  (unless (and (expression? (cadr q)) (expression? (caddr q)))
    (complain who "an equation is between numbers or expressions\n  given: ~a" (value->text q)))
  q)

(define (first-alternative who v)
  (define all (verdict-alternatives v))
  (when (null? all)
    (complain who "the verdict names no condition~a\n  verdict: ~a"
              (if (proved? v) ": what was asked is proved" "") (verdict-status v)))
  (car all))

;; -> ((expression . replacement) ...), to be made one after the other
(define (solved who equations)
  (define replacements (solutions equations))
  (unless replacements
    (complain who "the equations cannot hold together\n  equations: ~a" (value->text equations)))
  (for ([q (in-list equations)] #:unless (kept? q replacements))
    (complain who (string-append "the equation cannot be solved for one of its symbols\n"
                                 "  equation: ~a\n  write it as (= symbol expression)")
              (value->text q)))
  (for ([q (in-list equations)] #:when (product-alone? q))
    (complain who (string-append "a product is zero with any of its factors\n  equation: ~a\n"
                                 "  write the factor that is meant, as (= ~a 0)")
              (value->text q) (value->text (car (car replacements)))))
  replacements)

;; Does the equation say that a product of several unknowns is zero, or a quotient or root of
;; one?
(define (product-alone? q)
  (define (several? e)
    (cond [(or (headed? e op:/) (headed? e op:sqrt)) (several? (car (node-args e)))]
          [else
           (and (headed? e op:*)
                (> (count (lambda (f) (not (constant-value f))) (node-args e)) 1))]))
  (or (and (eqv? (caddr q) 0) (several? (cadr q)))
      (and (eqv? (cadr q) 0) (several? (caddr q)))))

;; Equations x = 2 for what is replaced by one root of two, as where x² = 4.
(define (roots-taken equations replacements)
  (for/list ([r (in-list replacements)]
             #:unless (eqv? (cdr r) 0)
             #:when (let ([others (map (lambda (s) (if (eq? s r) (negated s) s)) replacements)])
                      (andmap (lambda (q) (kept? q others)) equations)))
    (list '= (car r) (simplify-expression (cdr r)))))

;; What both sides of an equation are divided by when it is solved: x, where x y = x z.  Where
;; that is 0 the equation says nothing of the rest.
(define (factors-in-common equations)
  (remove-duplicates
   (append-map (lambda (q)
                 (define right (factors-above (caddr q)))
                 (filter (lambda (f) (member f right)) (factors-above (cadr q))))
               equations)))

;; Those of a numerator that are not constant, each once.
(define (factors-above e)
  (define-values (factored grounds) (factored-expression e))
  (let factors ([e factored])
    (cond [(headed? e op:*) (append-map factors (node-args e))]
          [(ormap (lambda (op) (headed? e op)) (list op:/ op:sqrt op:expt))
           (factors (car (node-args e)))]
          [(constant-value e) '()]
          [else (list e)])))

(define (negated r) (cons (car r) (e:negate (cdr r))))

;; Does the equation hold after the replacements?
(define (kept? q replacements)
  (define-values (left right) (values (cadr q) (caddr q)))
  (eqv? 0 (simplify-expression (e:- (replaced left replacements) (replaced right replacements)))))

;; ---------------------------------------------------------------------------
;; What it is imposed on

(define (check-thing x)
  (cond [(verdict? x)
         (complain 'impose "a verdict's question is asked again by (verify-again v condition)")]
        [(or (expression? x) (has-kind? x) (vector? x) (procedure? x) (constraint? x)
             (list? x))
         (void)]
        [else
         (complain 'impose "expected a value, a function or a constraint; given ~a"
                   (describe-with-value x))]))

;; note! : called with what is replaced somewhere
(define (put replacements equations x [note! void])
  (define (at-leaf leaf)
    (cond [(number? leaf) leaf]
          [(symbolic? leaf) (replaced-noting leaf replacements note!)]
          [(perturbed? leaf) ((parts-map (parts-of leaf)) within leaf)]
          [(other-number? leaf) leaf]
          [(constraint? leaf)
           (define make (if (holonomic? leaf) holonomic nonholonomic))
           (make (within (constraint-function leaf)))]
          [(procedure? leaf) (function-under leaf within equations)]
          [(pair? leaf) (cons (within (car leaf)) (within (cdr leaf)))]
          [else leaf]))
  (define (within x) (map-leaves at-leaf x))
  (within x))

(define (replaced-noting e replacements note!)
  (for/fold ([e e]) ([r (in-list replacements)])
    (define new (replaced e (list r)))
    (unless (eq? new e) (note! (car r)))
    new))

;; within : value -> value with the condition imposed
(define (function-under f within equations)
  (make-function (lambda args
                   (if (ormap recorded? (apply append (map scalars args)))
                       (value-on-tape f args within)
                       (within (apply f args))))
                 (arity-mask f)
                 (lambda () `(impose ,(value->datum equations) ,(value->datum f)))))

(define (value-on-tape f args within)
  (define point '())
  (define (symbol-for x)
    (define s (string->uninterned-symbol "x"))
    (set! point (cons (cons s x) point))
    s)
  (define symbols
    (for/list ([a (in-list args)])
      (define xs (map symbol-for (scalars a)))
      (scalars->structure a (lambda (k) (list-ref xs k)))))
  (map-leaves (lambda (leaf) (if (symbolic? leaf) (evaluate-generically leaf point) leaf))
              (within (apply f symbols))))
