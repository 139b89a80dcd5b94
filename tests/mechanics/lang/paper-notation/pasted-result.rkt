#lang racket/base
;; Results typed or pasted again at the prompt.

(require mechanics/lang/unknown-name/known-name
         mechanics/lang/paper-notation/pasted-result
         "../../support/checks.rkt" "../../support/run-text.rkt")

(define-syntax-rule (asked entry ...)
  (parameterize ([current-namespace (make-base-namespace)])
    (eval '(require mechanics))
    (eval '(define known 3))
    (list (pasted-sentence 'entry known-name?) ...)))

(define said "a result that was printed is read by (read-expression '")

(test-case "operations on names that nothing is known of are read"
  (check-equal?
   (asked (+ (* m (((expt D 2) x) t)) (* k (x t)))
          (* a (cos (+ (* omega t) phi)))
          (* 2 (x known))
          (down (+ (* m (((expt D 2) r) t)) (* -1 m (r t) (expt ((D phi) t) 2)) ((D V) (r t))) 0))
   (list (string-append said "(+ (* m (((expt D 2) x) t)) (* k (x t))))")
         (string-append said "(* a (cos (+ (* omega t) phi))))")
         (string-append said "(* 2 (x known)))")
         (string-append said "(down ...))"))))

(test-case "of anything else nothing is said"
  (check-equal? (asked (* m v) (f (g x)) (Lagrange-equations (L m k)) (* known (+ 1 m)) m #f
                       (define (f x) (* a b)) (* a (simplify (+ b c))) (+ 'a (* b c)) (+ a (b . c)))
                '(#f #f #f #f #f #f #f #f #f #f)))

(test-case "at the prompt, after how a symbol is written"
  (define-values (output errors)
    (session '("-I" "mechanics")
             "(+ (* m (((expt D 2) x) t)) (* k (x t)))"
             "(define (f v) (list (* weight (+ v w))))"
             "(f 2)"))
  (check-equal?
   (regexp-replace #rx"  within: f\n" errors "")
   (lines "m: undefined;" " cannot reference an identifier before its definition"
          "  in module: top-level"
          "  as a symbol it is written 'm"
          (string-append "  " said "(+ (* m (((expt D 2) x) t)) (* k (x t))))")
          "weight: undefined;" " cannot reference an identifier before its definition"
          "  in module: top-level"
          "  as a symbol it is written 'weight")))

(test-case "in a module, where the first of its names is unknown"
  (check-equal?
   (refusal "(define x 3)" "(+ (* m (((expt D 2) r) t)) (* k (r t)))")
   (string-append "example:3:6: m: unbound identifier; " said
                  "(+ (* m (((expt D 2) r) t)) (* k (r t)))); as a symbol it is written 'm\n"
                  "  in: m"))
  (check-equal? (prints "(define (f a) (* 2 a))" "(define m 1) (define k 2)" "(define t 3)"
                        "(+ (* m (f t)) (* k (f t)))")
                "18\n"))
