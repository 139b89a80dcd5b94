#lang racket/base
;; A map of the plane, compiled.
;;
;; A map that takes no decision is arithmetic on two numbers, and is compiled.  A map that takes
;; decisions is called itself.

(require racket/flonum
         "map-of-the-plane.rkt"
         "../../compile/compile-function.rkt"
         "../../generic/compare.rkt"
         "../../generic/up-down.rkt"
         "../../numeric/flvector.rkt")

(provide compile-map orbit-stepper stepper-at)

;; -> the map as a compiled function from (up x y) to (up x y), or #f
(define (compile-map map x y)
  (compile-traced (image-at 'map map) (up x y) #:name 'iterated-map))

;; -> a procedure that moves the point in the flvector p to its image, and returns #f where
;; there is no finite one.  Each orbit needs its own.  who : complains of a map written wrongly
(define (orbit-stepper map p [who 'map])
  (define code (compile-map map (flvector-ref p 0) (flvector-ref p 1)))
  (if code (compiled-stepper code) (calling-stepper who map)))

;; The same, or #f where the map has no image of the start.
(define (stepper-at who map x y)
  (and (image? who map x y) (orbit-stepper map (flvector (flonum x) (flonum y)) who)))

(define (compiled-stepper code)
  (define run! (compiled-function-runner code))
  (define to (make-flvector 2))
  (lambda (p)
    (run! p to)
    (flvector-copy! p to)
    (flvector-finite? p)))

(define ((calling-stepper who map) p)
  (image-or-none who map (flvector-ref p 0) (flvector-ref p 1)
                 (lambda (x y)
                   (flvector-set! p 0 (flonum x))
                   (flvector-set! p 1 (flonum y))
                   (flvector-finite? p))))

(define (flonum x)
  (define number (comparand x))
  (if (real? number) (real->double-flonum number) +nan.0))
