#lang racket/base
;; GIF files, read by the book: what is in them, without their pixels.

(require "checks.rkt")

(provide (struct-out gif-image) parse-gif
         gif-size gif-images gif-loops?)

;; place : (list left top width height); delay : hundredths of a second
(struct gif-image (place delay) #:transparent)
(struct gif (size loops? images))

(define (parse-gif bytes)
  (check-equal? (subbytes bytes 0 6) #"GIF89a")
  (define (word i) (integer-bytes->integer bytes #f #f i (+ i 2)))
  (define (after-blocks i)
    (define n (bytes-ref bytes i))
    (if (= n 0) (+ i 1) (after-blocks (+ i n 1))))
  (define (colors flags)
    (if (bitwise-bit-set? flags 7) (* 3 (expt 2 (+ 1 (bitwise-and flags 7)))) 0))
  (let next ([i (+ 13 (colors (bytes-ref bytes 10)))] [delay #f] [loops? #f] [images '()])
    (case (bytes-ref bytes i)
      [(#x3B)
       (check-equal? (+ i 1) (bytes-length bytes) "nothing follows the end")
       (gif (list (word 6) (word 8)) loops? (reverse images))]
      [(#x21)
       (define control? (= (bytes-ref bytes (+ i 1)) #xF9))
       (define netscape? (equal? (subbytes bytes (+ i 3) (+ i 14)) #"NETSCAPE2.0"))
       (next (after-blocks (+ i 2)) (if control? (word (+ i 4)) delay) (or loops? netscape?)
             images)]
      [(#x2C)
       (define place (for/list ([k (in-range 4)]) (word (+ i 1 (* 2 k)))))
       (define data (+ i 10 (colors (bytes-ref bytes (+ i 9)))))
       (next (after-blocks (+ data 1)) #f loops? (cons (gif-image place delay) images))])))
