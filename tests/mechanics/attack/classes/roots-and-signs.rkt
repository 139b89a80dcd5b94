#lang racket/base
;; Nested roots of what may have either sign, and the same flattened: (uᵃ)ᵇ to u^(ab),
;; √(uv) to √u √v, √(u²) to u or |u|, b - a for a - b.  Whether that is right depends on
;; signs; the judge finds out.

(require racket/match
         "../disguise.rkt" "../statement.rkt" "forms.rkt")

(provide roots-and-signs random-tower flattened)

(define (roots-and-signs)
  (define e (random-tower (random-between 1 3)))
  (statement e (variant e) '() '()))

(define (random-tower depth)
  (define (sub) (random-tower (- depth 1)))
  (if (eqv? depth 0)
      (random-form)
      (case (random 7)
        [(0 1) `(expt ,(sub) ,(random-exponent))]
        [(2) `(sqrt ,(sub))]
        [(3) `(sqrt (square ,(sub)))]
        [(4) `(sqrt (/ ,(pick '(1 -1 2)) ,(sub)))]
        [(5) `(* ,(sub) (sqrt ,(random-form)))]
        [(6) `(sqrt ,(pick (list `(* ,(sub) ,(random-form)) `(/ ,(sub) ,(random-form)))))])))

(define (variant e)
  (define r (for/fold ([e e]) ([_ (in-range (random-between 1 4))])
              (rewritten-somewhere e flattened)))
  (case (random 8)
    [(0) `(- ,r)]
    [(1) (disguise-once r)]
    [(2) (spoiled r)]
    [else r]))

(define (flattened e)
  (match e
    [`(sqrt (square ,u)) (pick (list u `(- ,u) `(abs ,u)))]
    [`(sqrt (/ ,u ,v)) (pick (list `(/ (sqrt ,u) (sqrt ,v)) `(/ (sqrt (* ,u ,v)) ,v)))]
    [`(sqrt (* ,u ,v)) `(* (sqrt ,u) (sqrt ,v))]
    [`(sqrt (expt ,u ,(? number? n))) `(expt ,u ,(/ n 2))]
    [`(sqrt (sqrt ,u)) `(expt ,u 1/4)]
    [`(sqrt ,u) `(expt ,u 1/2)]
    [`(expt (expt ,u ,(? number? m)) ,(? number? n)) `(expt ,u ,(* m n))]
    [`(expt (sqrt ,u) ,(? number? n)) `(expt ,u ,(/ n 2))]
    [`(expt (* ,u ,v) ,n) `(* (expt ,u ,n) (expt ,v ,n))]
    [`(expt (/ ,u ,v) ,n) `(/ (expt ,u ,n) (expt ,v ,n))]
    [`(- ,u ,v) `(- (- ,v ,u))]
    [`(log (expt ,u ,n)) `(* ,n (log ,u))]
    [_ #f]))
