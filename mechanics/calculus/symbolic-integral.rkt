#lang racket/base
;; Definite integrals with symbols in their ends or their integrands, as formulas:
;; F(high) − F(low), where F is an antiderivative (antiderivative.rkt).
;;
;; That is the integral if F has no jump between the ends, and if the integrand has a value
;; all along.  Polynomials, sines, cosines, exponentials and their products are continuous;
;; where F or the integrand has a logarithm, a quotient or a root that the variable is in, the
;; condition is that it keeps a value between the ends, and is said in a note.

(require "antiderivative.rkt" "expression-function.rkt" "integral.rkt" "perturbed.rkt"
         "../algebra/expression/expression.rkt" "../algebra/expression/operation.rkt"
         "../algebra/expression/substitute.rkt" "../algebra/expression/symbols.rkt"
         "../algebra/simplify/simplify-expression.rkt"
         "../error/complain.rkt" "../error/failure.rkt" "../error/note.rkt"
         "../generic/describe.rkt"
         "../value/assumptions.rkt")

(provide symbolic-integral)

;; Within a derivative an end may be perturbed: the formula is one of symbols first.  Where the
;; integrand is, each of its components has a formula.
(define (symbolic-integral who f low high)
  (define (name end) (if (perturbed? end) (string->uninterned-symbol "end") end))
  (define-values (from to) (values (name low) (name high)))
  (define x (string->uninterned-symbol "x"))
  (let integral ([f f])
    (define y (f x))
    (cond [(perturbed? y) (integral-by-components integral f y)]
          [(or (perturbed? low) (perturbed? high))
           (evaluate-generically (between-expressions who x y from to)
                                 (list (cons from low) (cons to high)))]
          [else (between-expressions who x y from to)])))

;; y : the integrand at x
(define (between-expressions who x y low high)
  (define A (assumptions-in-force))
  (define e
    (cond [(expression? y) (simplify-expression y A)]
          [else (complain who "expected a function that gives an expression or a number; given ~a"
                          (describe-with-value y))]))
  (check-ends who low high)
  (define F (antiderivative e x A))
  (unless F
    (raise-no-answer who
                     (string-append "no formula was found for the integral of ~a"
                                    "\n  give its symbols values first: "
                                    "(substitute expression 'm 3 ...)")
                     (value->text e)))
  (define (at end) (value-at F x end))
  (define result (simplify-expression (e:- (at high) (at low)) A))
  (define doubtful (remove-duplicates-of (append (breaks e x) (breaks F x))))
  (unless (null? doubtful) (note-condition who doubtful x low high))
  result)

(define (check-ends who low high)
  (for ([end (list low high)])
    (unless (and (expression? end) (not (and (real? end) (not (rational? end)))))
      (complain who
                (string-append "an integral with symbols goes from one expression to another"
                               "\n  given: ~a\n  to infinity, give its symbols values first")
                (describe-with-value end)))))

(define (value-at F x end)
  (with-handlers ([no-value? (lambda (e)
                               (raise-singular 'definite-integral
                                               "the integrand has no integral up to this end"
                                               end "end" end))])
    (substitute-expression F (list (cons x end)))))

;; Denominators that x is in, arguments of logarithms and roots.
(define (breaks e x)
  (define found '())
  (define (note! u) (when (occurs? x u) (set! found (cons u found))))
  (let walk ([e e])
    (when (node? e)
      (define args (node-args e))
      (cond [(eq? (node-head e) op:/) (note! (cadr args))]
            [(memq (node-head e) (list op:log op:sqrt)) (note! (car args))]
            [(and (eq? (node-head e) op:expt)
                  (not (exact-nonnegative-integer? (cadr args))))
             (note! (car args))])
      (for-each walk args)))
  found)

(define (remove-duplicates-of xs)
  (for/fold ([kept '()] #:result (reverse kept)) ([x (in-list xs)])
    (if (member x kept) kept (cons x kept))))

(define (note-condition who us x low high)
  (for ([u (in-list us)])
    (note-once (format "~a: the formula holds if ~a is not 0 for x from ~a to ~a"
                       who (value->text (substitute-expression u (list (cons x 'x))))
                       (value->text low) (value->text high)))))
