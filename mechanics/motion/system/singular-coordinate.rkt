#lang racket/base
;; Coordinates that are singular where the motion need not be.
;;
;; Euler angles tell no direction when θ = 0: precession and spin are turns about one axis
;; then, the mass matrix has no inverse, and momenta that are equal leave 0/0.  The motion of the
;; top passes through the vertical all the same.
;;
;; A coordinate that is near 0 or another multiple of a quarter of a turn is put exactly there.  It
;; is singular if the mass matrix then has no inverse, though it has one at some distance; or if
;; there are no rates, though near there they are not greater than at some distance, as those of a
;; collision would be: a formula is 0/0.

(require racket/list
         racket/string
         "system.rkt"
         "../../error/failure.rkt"
         "../../generic/up-down.rkt"
         "../../numeric/constants.rkt" "../../numeric/finite-number.rkt"
         "../../value/shape.rkt" "../../value/structure.rkt")

(provide singular-coordinate-text)

;; Lines of a message, "" if no coordinate is known to be singular near the state y.
(define (singular-coordinate-text s y)
  (define state (system-state s y))
  (define found
    (for*/first ([path (in-list (coordinate-paths s state))]
                 [quarter (in-value (quarter-near (apply ref state path)))]
                 #:when (and quarter (singular-at? s state path quarter)))
      (format (string-append
               "\n  singular where ~a is ~a, of which the coordinates may be the cause, not the"
               " motion\n  use coordinates that are regular there, such as Euler angles about another"
               " axis or\n  quaternions; or a greater tolerance, which may step over it")
              (path->text path) (quarter->text quarter))))
  (or found ""))

;; Of the coordinates of a local tuple or of a state with momenta; else of all but the time.
(define (coordinate-paths s state)
  (define all (scalar-paths state))
  (define coordinates (filter (lambda (p) (eqv? 1 (car p))) all))
  (cond [(and (system-clock? s) (pair? coordinates)) coordinates]
        [else (remove '(0) all)]))

;; How `ref` reaches the scalars of x.
(define (scalar-paths x)
  (if (tuple? x)
      (for*/list ([k (in-range (structure-length x))] [p (in-list (scalar-paths (ref x k)))])
        (cons k p))
      '(())))

(define (path->text path)
  (define (reference base path)
    (if (null? path) base (format "(ref ~a ~a)" base (string-join (map number->string path)))))
  (if (eqv? 1 (car path)) (reference "(coordinate state)" (cdr path)) (reference "state" path)))

;; ---------------------------------------------------------------------------

(define near 1e-3)
(define some-distance 0.1)

;; How many quarters of a turn x is, nearly; or #f.
(define (quarter-near x)
  (define k (round (/ x (* 0.5 pi))))
  (and (< (abs (- x (* k 0.5 pi))) near) (inexact->exact k)))

(define (quarter->text k)
  (define n (if (even? k) (quotient k 2) k))
  (if (eqv? k 0)
      "0"
      (format "~aπ~a" (case n [(1) ""] [(-1) "-"] [else n]) (if (even? k) "" "/2"))))

(define (singular-at? s state path quarter)
  (define place (* 0.5 pi (exact->inexact quarter)))
  (define (at x) (rates s (with-scalar state path x)))
  (define away (at (+ place some-distance)))
  (and (list? away)
       (case (at place)
         [(no-inverse) #t]
         [(no-value) (bounded-by? away (at (apply ref state path)))]
         [else #f])))

;; The rates as a list of finite numbers, or why there are none.
(define (rates s state)
  (with-handlers ([exn:fail:mechanics:singular:matrix? (lambda (e) 'no-inverse)]
                  [no-value? (lambda (e) 'no-value)])
    (define all (scalars ((system-derivative s) state)))
    (if (andmap finite? all) all 'no-value)))

(define (bounded-by? away near)
  (define (greatest xs) (apply max (map abs xs)))
  (and (list? near) (<= (greatest near) (* 30 (greatest away)))))

;; The state with x as the scalar that the path leads to.
(define (with-scalar state path x)
  (define place (index-where (scalar-paths state) (lambda (p) (equal? p path))))
  (define all (list->vector (scalars state)))
  (vector-set! all place x)
  (vector->structure state all))
