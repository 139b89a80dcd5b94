#lang racket/base
;; Points that a map moves radially: to another action, at the same angle (SICM 4.5, p. 321).

(require "map-of-the-plane.rkt"
         "../generic/arithmetic.rkt"
         "../numeric/constants.rkt"
         "../search/find-root.rkt"
         "../value/principal-value.rkt")

(provide radially-mapping-points)

;; -> the action between Jmin and Jmax where the angle phi is mapped to itself
(define (radially-mapping-points map Jmin Jmax phi eps)
  (check-map 'radially-mapping-points map)
  (define (turned J)
    (define image (image-of 'radially-mapping-points map phi J (lambda (angle action) angle)))
    (half-turn (g:- phi image)))
  (bisect turned Jmin Jmax eps))

(define half-turn (principal-value :pi))
