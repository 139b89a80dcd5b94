#lang racket/base
;; Factors of a polynomial from those of its image.
;;
;; The image of a factor is a product of some of the factors of the image.  So
;; products of few of them are tried; a factor found is irreducible, since
;; products of fewer did not give one.

(require racket/list)

(provide recombine choices-limit)

;; More factors of an image than these are not combined.
(define choices-limit 14)

;; The irreducible factors of p, as of the factors `images` of its image.
;; split : polynomial, chosen and other images -> the factor with the chosen images,
;; and the quotient; #f and #f if there is none
(define (recombine p images split)
  (let loop ([p p] [images images] [k 1])
    (cond [(> (* 2 k) (length images)) (if (null? images) '() (list p))]
          [else
           (define-values (factor rest others) (first-factor p images k split))
           (if factor
               (cons factor (loop rest others k))
               (loop p images (+ k 1)))])))

;; -> a factor with k images, the quotient and the other images; or #f first
(define (first-factor p images k split)
  (for/fold ([factor #f] [rest #f] [others #f])
            ([chosen (in-list (combinations images k))] #:break factor)
    (define others (remq* chosen images))
    (define-values (factor rest) (split p chosen others))
    (values factor rest others)))
