#lang mechanics
;; The variation of functions of paths obeys the rules of a derivative
;; (SICM 1.5.1 and exercise 1.8).
;;
;; f and g below are arbitrary functions of paths, F ∘ Γ[q] and G ∘ Γ[q] with
;; literal F and G of a local tuple; each rule is proved for them.

(define F (literal-function 'F (-> (UP Real Real Real) Real)))
(define G (literal-function 'G (-> (UP Real Real Real) Real)))
(define h (literal-function 'h))

(define (f q) (compose F (Gamma q)))
(define (g q) (compose G (Gamma q)))

(define q (literal-function 'q))
(define eta (literal-function 'eta))

;; Both sides of a rule, as functions of the path, taken at q and t.
(define (same left right)
  (verify-equal ((left q) 't) ((right q) 't)))

(define rules
  (list
   (cons "the variation of the path is eta"
         (same ((delta eta) identity) (lambda (q) eta)))
   (cons "the variation of Dq is D eta"
         (same ((delta eta) D) (lambda (q) (D eta))))
   (cons "sums"
         (same ((delta eta) (+ f g)) (+ ((delta eta) f) ((delta eta) g))))
   (cons "products"
         (same ((delta eta) (* f g))
               (+ (* f ((delta eta) g)) (* ((delta eta) f) g))))
   (cons "constant multiples"
         (same ((delta eta) (* 'c f)) (* 'c ((delta eta) f))))
   (cons "the chain rule, for h ∘ f[q]"
         (same ((delta eta) (lambda (q) (compose h (f q))))
               (lambda (q) (* (compose (D h) (f q)) (((delta eta) f) q)))))
   (cons "variation and time derivative commute"
         (same ((delta eta) (lambda (q) (D (f q))))
               (lambda (q) (D (((delta eta) f) q)))))))

(for ([rule rules])
  (printf "~a: ~a\n" (car rule) (verdict-status (cdr rule))))

(module+ test
  (require rackunit)
  (for ([rule rules])
    (test-case (car rule)
      (check-eq? (verdict-status (cdr rule)) 'proved)))
  (test-case "a wrong product rule is refuted"
    (check-eq? (verdict-status
                (same ((delta eta) (* f g)) (* ((delta eta) f) ((delta eta) g))))
               'refuted)))
