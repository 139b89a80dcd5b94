#lang racket/base
;; A map of the plane, done again and again (SICM 4.3, p. 308).
;;
;; A map that takes no decision is arithmetic on two numbers; if it is to be done often it is
;; compiled.  The map itself is called otherwise, and where the numbers stop being real.

(require racket/flonum
         "compiled-map.rkt" "map-of-the-plane.rkt"
         "../../compile/compile-function.rkt"
         "../../error/complain.rkt" "../../error/message-words.rkt"
         "../../generic/describe.rkt" "../../generic/function.rkt"
         "../../generic/wrong-argument.rkt"
         "../../numeric/flvector.rkt")

(provide iterated-map)

;; From this number of iterations on, the few milliseconds of compilation do not matter.
(define compilation-threshold 10000)

(define (iterated-map map n)
  (check-map 'iterated-map map n)
  (check-argument 'iterated-map exact-nonnegative-integer? n "how many times, a natural number")
  (define step #f)                      ; compiled, or 'none if it cannot be
  (define (compiled-step x y)
    (unless step (set! step (or (compile-map map x y) 'none)))
    (and (compiled-function? step) step))
  (define (further n x y return fail)
    (define code (and (real? x) (real? y) (or (flonum? x) (flonum? y)) (compiled-step x y)))
    (define image (and code (compiled-image code n x y)))
    (if image
        (return (flvector-ref image 0) (flvector-ref image 1))
        (image-by-calls map n x y return fail)))
  ;; The first call shows whether exact numbers stay exact.
  (define (iterated x y return fail)
    (if (< n compilation-threshold)
        (image-by-calls map n x y return fail)
        (image-or-else 'iterated-map map x y
                       (lambda (x y) (further (- n 1) x y return fail)) fail)))
  (define (datum) (list 'iterated-map (value->datum map) n))
  (define call
    (case-lambda [(x y return fail) (iterated x y return fail)]
                 [arguments (raise-other-call (datum) (length arguments))]))
  (make-function call 16 datum))

(define (raise-other-call datum n)
  (complain-of-arity (value->text datum)
                     (string-append "takes two coordinates, what to do with their images, and what "
                                    "to do where there are none; it was given ~a")
                     (counted n "argument")))

;; The first call shows whether it is a map.
(define (image-by-calls map n x y return fail)
  (define (loop n x y)
    (if (eqv? n 0)
        (return x y)
        (map x y (lambda (x y) (loop (- n 1) x y)) fail)))
  (if (eqv? n 0)
      (return x y)
      (image-or-else 'iterated-map map x y (lambda (x y) (loop (- n 1) x y)) fail)))

;; -> the image as an flvector, or #f if a coordinate is not finite
(define (compiled-image code n x y)
  (define run! (compiled-function-runner code))
  (let loop ([n n]
             [from (flvector (real->double-flonum x) (real->double-flonum y))]
             [to (make-flvector 2)])
    (cond [(eqv? n 0) (and (flvector-finite? from) from)]
          [else
           (run! from to)
           (loop (- n 1) to from)])))
