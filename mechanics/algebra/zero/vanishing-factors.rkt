#lang racket/base
;; All the ways in which a product vanishes by a choice of parameters.
;;
;; It vanishes with any one of its factors; a factor that moves, with a time t say, vanishes
;; at all times if all its coefficients along sin ωt, t ... do, and each of these with any one
;; of its own factors.  So there are several *ways*, each a list of equations that hold
;; together: Ω x² − g x is zero with Ω = 0, g = 0, and with no less.
;;
;; Which of them make sense is another matter (kept-meaning.rkt).

(require racket/list
         "kept-meaning.rkt" "readable-equation.rkt"
         "../expression/expression.rkt"
         "../field/field.rkt"
         "../polynomial/fraction.rkt" "../polynomial/polynomial.rkt"
         "../presentation/present.rkt")

(provide ways-to-vanish same-equations? symbol-alone?)

;; f : a fraction over F; parameter? and may-vanish? : expression -> boolean
;; -> lists of equations (= expression expression), as data: short lists first
(define (ways-to-vanish F f parameter? may-vanish?)
  (define p (fraction-numerator f))
  (if (> (poly-term-count p) most-terms)
      '()
      (sort (minimal (append-map (lambda (g) (ways-of-factor F g parameter? may-vanish?))
                                 (factors F p may-vanish?)))
            < #:key weight)))

(define most-terms 200)

;; More equations than these, or more ways, tell nobody anything.
(define most-equations 3)
(define most-ways 12)

;; Irreducible factors that may be zero, variables of the polynomial among them.
(define (factors F p may-vanish?)
  (define R (field-ring F))
  (for*/list ([part (in-list (poly-parts R p))]
              [g (in-list (irreducible R (power-base part)))]
              #:when (may-vanish? (present-poly F g)))
    g))

;; The lists of equations by which a factor is zero whatever its variables are.
(define (ways-of-factor F g parameter? may-vanish?)
  (define options
    (for/list ([c (in-list (moving-coefficients F g parameter?))])
      (filter values (map (lambda (h) (equation-for F h)) (factors F c may-vanish?)))))
  (define short (choices (map telling options)))
  (if (null? short) (choices options) short))

;; One equation of each, in all ways in which they can hold together.
(define (choices options)
  (if (<= 1 (apply * (map length options)) most-ways)
      (for*/list ([choice (in-list (apply cartesian-product options))]
                  [way (in-value (independent-equations choice))]
                  #:when (and way (<= (length way) most-equations)))
        way)
      '()))

;; A coefficient ω (b − 2 γ m) is told to vanish with b = 2 γ m alone.
(define (telling equations)
  (define relations (filter-not symbol-alone? equations))
  (if (null? relations) equations relations))

(define (equation-for F h)
  (if (eqv? 1 (poly-term-count h))
      (list '= (expression->datum (kernel-at F (car (poly-variables (field-ring F) h)))) 0)
      (relation-for F h)))

;; ---------------------------------------------------------------------------

;; Without those that ask for more than another does.
(define (minimal ways)
  (define all (remove-duplicates ways same-equations?))
  (filter-not (lambda (way) (for/or ([w (in-list (remq way all))]) (within? w way))) all))

(define (within? a b) (null? (remove* b a)))
(define (same-equations? a b) (and (within? a b) (within? b a)))

;; Few equations come first, then those between several symbols.
(define (weight way)
  (+ (* 100 (length way))
     (for/sum ([q (in-list way)])
       (cond [(not (symbol-alone? q)) 0]
             [(symbol? (cadr q)) 1]
             [else 2]))))

;; Does the equation say that a symbol, or the sine of one, is zero?
(define (symbol-alone? q) (eqv? 0 (caddr q)))
