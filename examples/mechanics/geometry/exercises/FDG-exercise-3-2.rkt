#lang mechanics
;; Exercise 3.2 (FDG 3): a 1-form in two charts
;; Checked: polar components of a 1-form are the rectangular ones times the slopes of the map
;; How: for unknown components, against the 1-form on the vector fields of each chart

(require mechanics/geometry)
(define omega (literal-1form-field 'a R2-rect))

(define rectangular (1form-field->components omega R2-rect))
(define polar (1form-field->components omega R2-polar))
(polar (up 'r 'theta))

;; The chain rule, with the map from polar to rectangular coordinates
(define polar->rect (compose (chart R2-rect) (point R2-polar)))
(define q (up 'r 'theta))
(define right
  (verify-equal (polar q) (* (rectangular (polar->rect q)) ((D polar->rect) q))))
right

;; The slip: the components of a 1-form changed as those of a vector are
(define wrong
  (verify-equal (polar q)
                (* (rectangular (polar->rect q))
                   ((D (compose (chart R2-polar) (point R2-rect))) (polar->rect q)))))
(verdict-status wrong)

(module+ test
  (require rackunit)
  (test-case "the change of components"
    (check-pred proved? right)
    (check-pred refuted? wrong)))
