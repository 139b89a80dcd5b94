#lang racket/base
;; Maps of the plane (SICM 3.6.1, p. 247).
;;
;; A *map* takes a point by its two coordinates, and two procedures: it calls the first
;; with the coordinates of the image, or the second, without arguments, where there is
;; none.

(require "../../calculus/perturbed-value.rkt"
         "../../error/complain.rkt" "../../error/hint.rkt" "../../error/refusal.rkt"
         "../../error/message-words.rkt"
         "../../generic/describe.rkt" "../../generic/function.rkt" "../../generic/kind.rkt"
         "../../generic/number-argument.rkt"
         "../../generic/printed-function.rkt" "../../generic/up-down.rkt"
         "../../generic/wrong-argument.rkt"
         "../../lagrangian/function-name-hints.rkt" "../../lagrangian/function-of-momenta.rkt")

(provide check-map map? map-hint called-energy? energy-hint
         check-numbers check-steps
         image-of image-at image? point-image-at
         point-image-of check-image raise-no-image image-or-none
         image-or-else)

;; others : the arguments after it, one of which may be the map
(define (check-map who map . others)
  (unless (map? map)
    (when (ormap map? others)
      (complain who "the map comes first; it was given after ~a" (describe-with-value map)))
    (complain who
              (string-append "expected a map, a procedure of two "
                             "coordinates and of two procedures"
                             "\n  given: ~a~a")
              (describe-function map) (map-hint map))))

;; Tuples answer `procedure?`, and take any number of arguments.
(define (map? x) (and (pointwise? x) (accepts? x 4)))

;; The last lines of a complaint about a value that is no map.
(define (map-hint f)
  (cond [(not (pointwise? f)) (quoted-name-hint f)]
        [(called-energy? f) (energy-hint f)]
        [(or (accepts? f 2) (accepts? f 3))
         "\n  its image goes to the third argument: (define (map x y return fail) ...)"]
        [(gives-functions? f)
         (format "\n  parameters are supplied first: (~a ...)" (value->text f))]
        [(of-states? f)
         (string-append
          "\n  it takes a state; with it a map of the plane is (define (map q p return fail) "
          "(let ((s (f (up 0 q p)))) (return (coordinate s) (momentum s))))")]
        [else ""]))

;; Is it a Hamiltonian, or does its name say Hamiltonian or Lagrangian?
(define (called-energy? f)
  (or (of-momenta? f) (called-Hamiltonian? f) (called-Lagrangian? f)))

(define (energy-hint f)
  (string-append
   "\n  (stroboscopic-map f period) and (Poincare-map f event) make maps of its motion,\n  "
   "with f = "
   (if (called-Lagrangian? f)
       "(Lagrangian->state-derivative L)"
       "(Hamiltonian->state-derivative H)")))

;; Is it a map made of a motion (section.rkt)?
(define (of-states? f) (memq (made-by f) '(stroboscopic-map Poincare-map)))

;; Has it parameters, as (standard-map K) has one?
(define (gives-functions? f)
  (define n (for/first ([n (in-list '(1 5 6))] #:when (accepts? f n)) n))
  (and n
       (if-raised refusal? #f
         (pointwise? (apply f (for/list ([_ (in-range n)]) 1))))))

;; -> a function from points to their images, tuples of two
(define ((image-at who map) p) (image-of who map (structure-ref p 0) (structure-ref p 1) up))

;; The same, checked.
(define ((point-image-at who map) p)
  (point-image-of who map (structure-ref p 0) (structure-ref p 1)))

;; -> (up x' y'); the coordinates are real numbers, perhaps with perturbations
(define (point-image-of who map x y)
  (define image (image-of who map x y up))
  (check-image who map (vector->list (structure-elements image)))
  image)

;; xs : the scalars of an image
(define (check-image who map xs)
  (for ([x (in-list xs)])
    (unless (real? (comparand (innermost x)))
      (complain who "the image is not one of real numbers\n  map: ~a\n  in the image: ~a"
                (value->text map) (describe-with-value x)))))

;; -> the value of (receive x' y'); complains where the map has no image
(define (image-of who map x y receive)
  (image-or-else who map x y receive (lambda () (raise-no-image who map x y))))

(define (raise-no-image who map x y)
  (complain who "the map has no image of a point that is needed\n  map: ~a\n  point: ~a"
            (value->text map) (value->text (up x y))))

;; ---------------------------------------------------------------------------
;; Maps that may be written wrongly

;; -> the value of (receive x' y') with numbers, or #f where the map has no image
(define (image-or-none who map x y receive)
  (image-or-else who map x y
                 (lambda (x* y*)
                   (unless (and (number? (comparand x*)) (number? (comparand y*)))
                     (raise-misused who map x y (list x* y*) no-coordinates))
                   (receive x* y*))
                 (lambda () #f)))

(define (image? who map x y) (image-or-none who map x y (lambda (x y) #t)))

(define no-coordinates
  "the map calls `return` with other things than the coordinates of an image")

(define nowhere (string->uninterned-symbol "nowhere"))

;; -> the value of (receive x' y'), or of (none).  Complains of a map that does not end by
;; calling one of its two procedures once.
(define (image-or-else who map x y receive none)
  (define calls 0)
  (define answer #f)
  (define (answered by)
    (set! calls (+ calls 1))
    (set! answer by)
    by)
  (define return
    (case-lambda [(x* y*) (answered (cons x* y*))]
                 [given (raise-misused who map x y given no-coordinates)]))
  (define fail
    (case-lambda [() (answered nowhere)]
                 [given (raise-misused who map x y given
                                       "the map calls `fail` with arguments; it takes none")]))
  (define value (map x y return fail))
  (cond [(= calls 0) (raise-silent who map x y value)]
        [(> calls 1)
         (raise-misuse who map x y "the map calls `return` or `fail` more than once for one point")]
        [(not (eq? value answer))
         (raise-misuse who map x y (string-append "the map goes on after it has called `return` or "
                                                  "`fail`; what these give is to be its value"))]
        [(eq? answer nowhere) (none)]
        [else (receive (car answer) (cdr answer))]))

(define (raise-misuse who map x y what . more)
  (complain who "~a\n  map: ~a\n  point: ~a~a" what (value->text map) (value->text (up x y))
            (apply string-append more)))

(define (raise-misused who map x y given what)
  (raise-misuse who map x y what
                (format "\n  given: ~a" (joined (for/list ([z (in-list given)]) (value->text z))))))

(define (raise-silent who map x y value)
  (raise-misuse who map x y "the map calls neither `return` nor `fail`"
                (format "\n  value: ~a" (value->text value))
                (cond [(or (tuple? value) (pair? value))
                       "\n  the image goes to the third argument: (return x y)"]
                      [(pointwise? value)
                       (format "\n  parameters are supplied first: (~a ...)" (value->text map))]
                      [else ""])))

;; ---------------------------------------------------------------------------
;; Numbers that are given

;; names : a name for each of the xs
(define (check-numbers who xs names)
  (for ([x (in-list xs)] [name (in-list names)])
    (finite-number who x (string-append "a real number as " name))))

(define (check-steps who n)
  (check-argument who exact-positive-integer? n "how many steps of the map, a positive integer"))
