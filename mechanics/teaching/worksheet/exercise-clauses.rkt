#lang racket/base
;; The names of an exercise's clauses, and how many values each takes: known when a worksheet is
;; compiled, so that the error names the clause, not an unknown variable.

(provide clause-names values-fit? values-wanted names-clause? keywords-of)

(define with-names '(coordinates arguments constants))
(define with-any '(besides assuming))
(define with-one '(key of of-Hamiltonian force becomes starts within unit points hint expects))

(define clause-names (append with-names with-one with-any '(slip no-practice credit)))

;; Are its parts names, which are not evaluated?
(define (names-clause? name) (memq name with-names))

;; n : the number of values, without keywords
(define (values-fit? name n)
  (cond [(memq name with-one) (= n 1)]
        [(eq? name 'slip) (= n 2)]
        [(memq name '(no-practice credit)) (= n 0)]
        [else (>= n 1)]))

;; In words.
(define (values-wanted name)
  (cond [(eq? name 'hint) "one text, in quotation marks"]
        [(memq name with-one) "one value"]
        [(eq? name 'slip) "a wrong answer, and a text in quotation marks"]
        [(eq? name 'no-practice) "nothing"]
        [(eq? name 'credit) "shares of the points, as in (credit #:sign 1/2 #:factor 1/2)"]
        [(names-clause? name) "names, without quotes"]
        [else "a value, or several"]))

(define (keywords-of name)
  (case name
    [(slip) '(#:credit)]
    [(credit) '(#:sign #:factor)]
    [(hint) '(#:after)]
    [(within) '(#:absolute)]
    [else '()]))
