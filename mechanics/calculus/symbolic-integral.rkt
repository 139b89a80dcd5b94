#lang racket/base
;; Definite integrals with symbols in their ends or their integrands, as formulas:
;; F(high) − F(low), where F is an antiderivative (antiderivative.rkt).  Where none is found, a
;; claim is one itself if an end is a symbol, and its derivative there is the integrand.
;;
;; The conditions under which that is the integral (integral-conditions.rkt) are among the
;; assumptions used, as those of simplification are, unless they are declared or known.

(require racket/list
         "antiderivative.rkt" "expression-function.rkt" "integral.rkt" "integral-conditions.rkt"
         "perturbed-value.rkt" "Taylor-number.rkt"
         (only-in "../algebra/assumption/assumption-set.rkt"
                  relation-expression relation-signs with-automatic-assumptions)
         "../algebra/assumption/domain.rkt" "../algebra/assumption/signs.rkt"
         "../algebra/expression/expression.rkt" "../algebra/expression/nodes.rkt"
         (only-in "../algebra/expression/simplifier.rkt" left-unexpanded?)
         "../algebra/expression/substitute.rkt"
         "../algebra/expression/symbols.rkt"
         "../algebra/simplify/declare-relations.rkt" "../algebra/simplify/domain-question.rkt"
         "../algebra/simplify/necessary-assumptions.rkt"
         "../algebra/simplify/simplify-expression.rkt"
         "../algebra/zero/common-domain.rkt" "../algebra/zero/existence.rkt"
         "../algebra/zero/real-signs.rkt"
         "../error/complain.rkt" "../error/computed-once.rkt" "../error/failure.rkt"
         "../error/note.rkt"
         "../generic/describe.rkt" "../generic/operation-rule/kinks-met.rkt"
         "../generic/number-argument.rkt"
         "../generic/irrational.rkt" "../generic/wrong-argument.rkt"
         "../value/assumptions.rkt")

(provide symbolic-integral)

;; Within a derivative an end may be perturbed: the formula is one of symbols first.  Where the
;; integrand is, each of its components has a formula.
;; receive : formula and conditions -> any
(define (symbolic-integral who f low high [receive formula-with-notes] #:claim [claim #f])
  (check-function-of-one-variable who f)
  (define (name end)
    (if (perturbed? end) (string->uninterned-symbol "end") (irrational-as-expression end)))
  (define-values (from to) (values (name low) (name high)))
  (define names (list (cons from low) (cons to high)))
  (define x (string->uninterned-symbol "x"))
  (define conditions '())
  (define (note! more)
    (set! conditions (remove-duplicates (append conditions (map (named names) more)))))
  (check-ends who from to)
  (define formula
    (let integral ([f f] [left #f])     ; so many derivatives are to be taken; #f if all are
      (define-values (y kinks?) (value-and-kinks f x))
      (when (and kinks? (not (eqv? left 0))) (check-without-jumps who (innermost y) x from to))
      (define (component-integral f) (integral f (- (or left (order-of-perturbation y)) 1)))
      (cond [(perturbed? y) (integral-by-components component-integral f y)]
            [(or (perturbed? low) (perturbed? high))
             (evaluate-generically (between-expressions who x y from to claim note!) names)]
            [else (between-expressions who x y from to claim note!)])))
  (define open (undeclared conditions))
  (note-used! open)
  (receive formula open))

(define (formula-with-notes formula conditions)
  (for ([c (in-list conditions)])
    (note-with-result (format "definite-integral: the formula holds if ~s" c)
                      (list c (value->text formula))))
  formula)

;; f at x; and has it a sign, or the like, of a perturbed value?
(define (value-and-kinks f x)
  (define-values (y kinks) (call-noting-kinks (lambda () (f x))))
  (for ([k (in-list kinks)]) (apply note-kink! (met-name k) (met-arguments k)))
  (values y (ormap (lambda (k) (memq (met-name k) '(sgn abs sqrt expt))) kinks)))

(define (order-of-perturbation y)
  (if (perturbed? y)
      (+ (if (jet? y) (jet-order y) 1) (order-of-perturbation ((parts-value (parts-of y)) y)))
      0))

;; The place of a jump may move with perturbed values, which derivatives of e, the integrand at x,
;; do not show.
(define (check-without-jumps who e x low high)
  (when (and (expression? e) (jumps-between? e x low high (assumptions-in-force)))
    (raise-no-answer who
                     (string-append "no formula was found for a derivative of the integral of ~a, "
                                    "which jumps\n  give its symbols values first: "
                                    "(substitute expression 'm 3 ...)")
                     (value->text e))))

;; A datum with values in place of names that stood for perturbed ends
(define ((named names) datum)
  (let walk ([d datum])
    (define entry (and (symbol? d) (assq d names)))
    (cond [(and entry (perturbed? (cdr entry)))
           (define value (innermost (cdr entry)))
           (if (expression? value) (expression->datum value) d)]
          [(pair? d) (cons (walk (car d)) (walk (cdr d)))]
          [else d])))

;; y : the integrand at x; note! : is told the conditions
(define (between-expressions who x y low high claim note!)
  (define A (assumptions-in-force))
  (define inside (between-ends x low high A))
  (check-argument who expression? y "a function that gives an expression or a number")
  (define e (simplified-integrand y x inside))
  (define F (or (antiderivative e x inside #t) (antiderivative-in-claim claim e x low high inside)))
  (unless F (raise-no-formula who e (remq x (append-map symbols-in (list e low high))) low high))
  (define conditions (integral-conditions-of e F x low high A))
  (unless conditions (raise-interrupted who e))
  (note! conditions)
  (define continuous (continuous-logarithms F e x low high A))
  (define (at end) (value-at continuous x end (and claim #t)))
  (define formula (difference (at high) (at low) A note!))
  (unless (and (or (real-leaves? formula) (not (andmap real-leaves? (list y low high))))
               (somewhere-real? (domain-expressions (list formula)) (with-relations A conditions)))
    (raise-interrupted who e))
  formula)

;; The claim with x in place of an end, if its derivative is proved to be e between the ends, and it
;; is real wherever e is
(define (antiderivative-in-claim claim e x low high A)
  (define (candidate end other sign)
    (and (symbol? end)
         (not (or (occurs? end e) (occurs? end other)))
         (e:* sign (substitute-expression claim (list (cons end x))))))
  (define (right? F)
    (and (real-wherever? F e A)
         (proved-zero? (e:- (expression-derivative F x) e) A)))
  (and (expression? claim)
       (findf (lambda (F) (and F (right? F)))
              (list (candidate high low 1) (candidate low high -1)))))

;; Has F no gap that e has not, as √(x² − 1) has one?  Beyond it a constant may be another.  Gaps
;; that begin where u = 0 in log u or 1/√u are cuts (integral-conditions.rkt).
(define (real-wherever? F e A)
  (define B (or (domain-assumptions (list e) A) A))
  (for/and ([r (in-list (remove* (domain-relations e) (domain-relations F)))]
            #:unless (eqv? positive (relation-signs r)))
    (signs-within? (real-signs (relation-expression r) B) (relation-signs r))))

;; A sign that the result takes for granted is a condition, too: √(a²) = a where a ≥ 0.
(define (difference high low A note!)
  (define-values (simple grounds) (simplify-expression/needed (e:- high low) A))
  (note! (filter-not left-unexpanded? (at-last grounds)))
  simple)

;; Nothing is taken for granted of x, as √(x²) = x would be: it leaves no trace in the formula.
(define (simplified-integrand y x A)
  (define-values (e grounds) (simplify-expression/assumptions y A))
  (if (ormap (lambda (g) (memq x (flatten g))) grounds)
      (simplify-expression y (with-automatic-assumptions A #f))
      e))

;; names : the symbols that keep the integral from being a number
(define (raise-no-formula who e names low high)
  (raise-no-answer who
                   (string-append "no formula was found for the integral of ~a\n  "
                                  (if (null? names)
                                      (format "its number is (definite-integral f ~a ~a)"
                                              (value->text low) (value->text high))
                                      (string-append "give its symbols values first: "
                                                     "(substitute expression 'm 3 ...)")))
                   (value->text e)))

(define (raise-interrupted who e)
  (raise-singular who
                  (string-append "the integrand has no integral between these ends, or none that "
                                 "a formula was found for\n  integrand: " (value->text e))
                  (value->text e)))

(define (check-ends who low high)
  (for ([end (list low high)])
    (unless (and (expression? end) (not (and (real? end) (not (rational? end)))))
      (complain who
                (string-append "an integral with symbols goes from one expression to another"
                               "\n  given: ~a\n  to infinity, give its symbols values first")
                (describe-with-value end)))))

;; exactly? : a function of an exact number stays as it is, log 2 not being a decimal.
(define (value-at F x end exactly?)
  (define (exact-node head args)
    (if (and (null? (cdr args)) (number? (car args)) (exact? (car args)))
        (make-node head args)
        (rebuild head args)))
  (with-handlers ([no-value? (lambda (e)
                               (raise-singular 'definite-integral
                                               "the integrand has no integral up to this end"
                                               end "end" end))])
    (substitute-expression F (list (cons x end)) (if exactly? exact-node rebuild))))
