#lang racket/base
;; Points that a map moves radially: to another action, at the same angle (SICM 4.5, p. 321).

(require "map-of-the-plane.rkt"
         "../../error/complain.rkt"
         "../../generic/arithmetic.rkt" "../../generic/compare.rkt" "../../generic/describe.rkt"
         "../../generic/number-argument.rkt"
         "../../numeric/constants.rkt"
         "../../search/find-root.rkt"
         "../../value/principal-value.rkt")

(provide radially-mapping-points)

;; -> the action between Jmin and Jmax at which the map leaves the angle phi
(define (radially-mapping-points map Jmin Jmax phi eps)
  (define who 'radially-mapping-points)
  (check-map who map)
  (check-numbers who (list Jmin Jmax phi eps)
                 '("least action" "greatest action" "angle" "tolerance"))
  (positive-number who eps "a positive tolerance")
  (define (turned J)
    (define image (image-of who map phi J (lambda (angle action) angle)))
    (half-turn (g:- phi image)))
  (check-bracket phi Jmin (turned Jmin) Jmax (turned Jmax))
  (bisect turned Jmin Jmax eps))

(define (check-bracket phi Jmin at-Jmin Jmax at-Jmax)
  (when (> (* (comparand at-Jmin) (comparand at-Jmax)) 0)
    (complain 'radially-mapping-points
              (string-append "the map turns the angle the same way at both actions; one between "
                             "them need not keep it\n  angle: ~a\n  at the action ~a it turns by ~a"
                             "\n  at the action ~a it turns by ~a")
              (value->text phi)
              (value->text Jmin) (value->text (g:- 0 at-Jmin))
              (value->text Jmax) (value->text (g:- 0 at-Jmax)))))

(define half-turn (principal-value :pi))
