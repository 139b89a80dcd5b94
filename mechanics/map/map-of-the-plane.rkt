#lang racket/base
;; What a map of the plane is (SICM 3.6.1, p. 247).
;;
;; A *map* takes a point by its two coordinates, and two procedures: it calls the first
;; with the coordinates of the image, or the second, without arguments, where there is
;; none.

(require "../calculus/perturbed.rkt"
         "../error/complain.rkt" "../error/words.rkt"
         "../generic/compare.rkt"
         "../generic/describe.rkt" "../generic/function.rkt" "../generic/up-down.rkt")

(provide check-map image-of point-image-of check-image raise-no-image image-or-none)

(define (check-map who map)
  (unless (and (procedure? map) (accepts? map 4))
    (complain who
              (string-append "expected a map, a procedure of two "
                             "coordinates and of two procedures"
                             "\n  given: ~a~a")
              (describe-with-value map)
              (if (and (procedure? map) (accepts? map 2))
                  "\n  its image goes to the third argument: (define (map x y return fail) ...)"
                  ""))))

;; -> (up x' y'), of real numbers, which may be being differentiated
(define (point-image-of who map x y)
  (define image (image-of who map x y up))
  (unless (and (structure? image) (= 2 (structure-length image)))
    (complain who "the map does not call `return` with the two coordinates of the image\n  ~a: ~a"
              "map" (value->text map)))
  (check-image who map (vector->list (structure-elements image)))
  image)

;; xs : the scalars of an image
(define (check-image who map xs)
  (for ([x (in-list xs)])
    (unless (real? (comparand (innermost x)))
      (complain who "the image is not one of real numbers\n  map: ~a\n  in the image: ~a"
                (value->text map) (describe-with-value x)))))

;; -> (receive x' y'), where the map has an image
(define (image-of who map x y receive)
  (map x y receive (lambda () (raise-no-image who map x y))))

(define (raise-no-image who map x y)
  (complain who "the map has no image of a point that is needed\n  map: ~a\n  point: ~a"
            (value->text map) (value->text (up x y))))

;; ---------------------------------------------------------------------------
;; Maps that may be written wrongly

(define nowhere (string->uninterned-symbol "nowhere"))

;; -> (receive x' y'), or #f where the map has no image; who complains of a map that does not
;; end by calling one of its procedures, once and as it should
(define (image-or-none who map x y receive)
  (define calls 0)
  (define answer #f)
  (define ((answered-by image) . given)
    (set! calls (+ calls 1))
    (set! answer (image given))
    answer)
  (define (return given) (checked-image who map x y given))
  (define (fail given) (checked-failure who map x y given))
  (define value (map x y (answered-by return) (answered-by fail)))
  (cond [(= calls 0) (raise-silent who map x y value)]
        [(> calls 1)
         (raise-misuse who map x y "the map calls `return` or `fail` more than once for one point")]
        [(not (eq? value answer))
         (raise-misuse who map x y (string-append "the map goes on after it has called `return` or "
                                                  "`fail`; what these give is to be its value"))]
        [(eq? answer nowhere) #f]
        [else (receive (car answer) (cdr answer))]))

(define (checked-image who map x y given)
  (unless (and (= (length given) 2) (for/and ([z (in-list given)]) (number? (comparand z))))
    (raise-misused who map x y given
                   "the map calls `return` with other things than the coordinates of an image"))
  (cons (car given) (cadr given)))

(define (checked-failure who map x y given)
  (unless (null? given)
    (raise-misused who map x y given "the map calls `fail` with arguments; it takes none"))
  nowhere)

(define (raise-misuse who map x y what . more)
  (complain who "~a\n  map: ~a\n  point: ~a~a" what (value->text map) (value->text (up x y))
            (apply string-append more)))

(define (raise-misused who map x y given what)
  (raise-misuse who map x y what
                (format "\n  given: ~a" (joined (for/list ([z (in-list given)]) (value->text z))))))

(define (raise-silent who map x y value)
  (raise-misuse who map x y "the map calls neither `return` nor `fail`"
                (format "\n  value: ~a" (value->text value))
                (if (or (tuple? value) (pair? value))
                    "\n  the image goes to the third argument: (return x y)"
                    "")))
