#lang racket/base
;; Data that contain themselves, which no walk through them would come to the end of.

(provide cyclic?)

;; Does a list or vector contain itself?  What is shared is looked at once.
(define (cyclic? x)
  (define finished (make-hasheq))
  (let inside ([x x] [around (hasheq)])
    (define (part? y) (inside y (hash-set around x #t)))
    (cond [(hash-ref around x #f) #t]
          [(hash-ref finished x #f) #f]
          [(pair? x) (or (part? (car x)) (part? (cdr x)) (finish! finished x))]
          [(vector? x) (or (for/or ([e (in-vector x)]) (part? e)) (finish! finished x))]
          [else #f])))

(define (finish! finished x)
  (hash-set! finished x #t)
  #f)
