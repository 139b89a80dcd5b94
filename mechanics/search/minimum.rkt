#lang racket/base
;; The result of a search for a minimum: place, value, kind.

(require "../generic/describe.rkt" "../generic/value-struct.rkt" "../generic/wrong-argument.rkt")

(provide minimum minimum?
         minimum->triple minimum-proper?)

;; kind : 'minimum     the gradient vanishes, and all curvatures are positive
;;        'degenerate  a curvature vanishes, too; nothing lower is near
;;        'flat        around it the function does not change
;;        'end         an end of the interval; the function falls beyond, or is not defined
;;        'kink        lower than all near; the gradient jumps there
;;        'saddle      a curvature is negative, yet nothing lower was found
;; gradient : its size, or #f; curvature : the least eigenvalue of the second derivatives, or #f
(value-struct minimum (argument value kind gradient curvature evaluations)
  #:text minimum->text)

(provide-parts minimum? "a minimum, such as find-minimum gives"
  minimum-argument minimum-value minimum-kind minimum-gradient minimum-curvature
  minimum-evaluations)

(define (minimum-proper? m) (eq? (minimum-kind m) 'minimum))

;; As the book's minimisers give it; `count` is theirs.
(define (minimum->triple m count) (list (minimum-argument m) (minimum-value m) count))

(define (minimum->text m)
  (define (line what x) (if x (format "\n  ~a: ~a" what x) ""))
  (string-append
   (format "~a ~a, where the value is ~a" (title (minimum-kind m))
           (value->text (minimum-argument m)) (value->text (minimum-value m)))
   (line "size of the gradient" (minimum-gradient m))
   (line "least curvature" (minimum-curvature m))
   (line "evaluations" (minimum-evaluations m))))

(define (title kind)
  (case kind
    [(minimum) "minimum at"]
    [(degenerate) "degenerate minimum at"]
    [(flat) "flat, and nothing lower found, at"]
    [(end) "least at the end of the interval, at"]
    [(kink) "minimum at a kink, at"]
    [else "saddle at"]))
