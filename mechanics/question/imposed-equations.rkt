#lang racket/base
;; Conditions that are imposed: equations that hold together, each solved for one of its symbols.
;;
;; If a symbol may be either root of a square, the root of the declared sign is taken, or the one
;; that is not negative; an equation is divided by a common factor of its sides, as if that were not
;; 0.  Where nothing is declared these are choices, of which the reader is told.

(require (only-in racket/list append-map count remove-duplicates)
         (only-in racket/string string-join)
         "../algebra/expression/constant-value.rkt" "../algebra/expression/expression.rkt"
         "../algebra/expression/operation.rkt"
         (only-in "../algebra/solve/root.rkt" known-branch)
         "../error/complain.rkt"
         "../generic/describe.rkt" "../generic/wrong-argument.rkt"
         "../value/algebra.rkt" "../value/assumptions.rkt" "../value/read-expression.rkt"
         "../verdict/verdict.rkt")

(provide equations-of solved equations->text choices->text)

;; ---------------------------------------------------------------------------
;; Equations

;; other : a value that came with the condition
;; -> ((= value value) ...)
(define (equations-of who condition [other #f])
  (cond [(verdict? condition) (equations-of who (first-alternative who condition))]
        [(equation? condition) (list (read-equation who condition))]
        [(list-of-equations? condition)
         (for/list ([q (in-list condition)]) (read-equation who q))]
        [else
         (complain-of-argument who "a verdict, an equation '(= k 1) or a list of them" condition
                               (condition-hint condition other))]))

(define (condition-hint x other)
  (cond [((list-of list-of-equations?) x)
         "\n  these are alternatives: choose one, as (car (verdict-alternatives v))"]
        [(and (pair? x) (memq (car x) '(< > <= >=))) "\n  an inequality is declared by assume"]
        [(or (procedure? x) (verdict? other) (equation? other) (list-of-equations? other))
         "\n  the value comes first, then the condition, as in (impose L '(= k 1))"]
        [else ""]))

(define (equation? x)
  (and (list? x) (= (length x) 3) (eq? (car x) '=)))

(define ((list-of what?) x) (and (pair? x) (list? x) (andmap what? x)))
(define list-of-equations? (list-of equation?))

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

(define (equations->text equations)
  (string-join (for/list ([q (in-list equations)])
                 (format "~a = ~a" (value->text (cadr q)) (value->text (caddr q))))
               ", "))

;; ---------------------------------------------------------------------------
;; Solving them

;; -> ((expression . replacement) ...), to be made one after the other
(define (solved who equations)
  (define replacements (with-declared-signs equations (solutions equations)))
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

;; Does the equation hold after the replacements?
(define (kept? q replacements)
  (eqv? 0 (simplify-expression (e:- (replaced (cadr q) replacements)
                                    (replaced (caddr q) replacements)))))

;; ---------------------------------------------------------------------------
;; Choices

;; ", with x = 2, y not 0": choices made when the equations were solved so, or ""
(define (choices->text equations replacements)
  (define roots (roots-taken equations replacements))
  (define texts
    (append (if (null? roots) '() (list (equations->text roots)))
            (for/list ([f (in-list (factors-in-common equations))])
              (format "~a not 0" (value->text f)))))
  (if (null? texts) "" (string-append ", with " (string-join texts ", "))))

;; Equations x = 2 for expressions replaced by one root of two, as where x² = 4.
(define (roots-taken equations replacements)
  (for/list ([r (in-list replacements)]
             #:when (other-root r equations replacements)
             #:unless (known-branch (car r) (assumptions-in-force)))
    (list '= (car r) (simplify-expression (cdr r)))))

;; The replacements with r negated, or #f if the equations do not hold then
(define (other-root r equations replacements)
  (define others (map (lambda (s) (if (eq? s r) (negated s) s)) replacements))
  (and (not (eqv? (cdr r) 0)) (andmap (lambda (q) (kept? q others)) equations) others))

;; replacements : or #f
(define (with-declared-signs equations replacements)
  (for/fold ([all replacements]) ([r (in-list (or replacements '()))]
                                  #:when (eqv? -1 (known-branch (car r) (assumptions-in-force))))
    (or (other-root r equations all) all)))

;; -> the factors by which both sides of an equation are divided when it is solved: x of x y = x z.
;; Where x is 0 the equation says nothing of the rest.
(define (factors-in-common equations)
  (remove-duplicates
   (append-map (lambda (q)
                 (define right (factors-above (caddr q)))
                 (filter (lambda (f) (member f right)) (factors-above (cadr q))))
               equations)))

;; Factors of a numerator that are not constant.
(define (factors-above e)
  (define-values (factored grounds) (factored-expression e))
  (let factors ([e factored])
    (cond [(headed? e op:*) (append-map factors (node-args e))]
          [(ormap (lambda (op) (headed? e op)) (list op:/ op:sqrt op:expt))
           (factors (car (node-args e)))]
          [(constant-value e) '()]
          [else (list e)])))

(define (negated r) (cons (car r) (e:negate (cdr r))))
