#lang racket/base
;; What a map of the plane is (SICM 3.6.1, p. 247).
;;
;; A *map* takes a point by its two coordinates, and two procedures: it calls the first
;; with the coordinates of the image, or the second, without arguments, where there is
;; none.

(require "../calculus/perturbed.rkt"
         "../error/complain.rkt"
         "../generic/compare.rkt"
         "../generic/describe.rkt" "../generic/function.rkt" "../generic/up-down.rkt")

(provide check-map image-of point-image-of check-image raise-no-image)

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
