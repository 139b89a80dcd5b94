#lang racket/base
;; Right-hand sides of y' = f(y) with their derivatives, for implicit methods.
;;
;; The derivatives are those that came with f; where none did, differences of f, of
;; which only about half the digits are right.  An implicit method needs no more: they
;; decide how fast its equations are solved, not their solution.

(require racket/flonum
         "../../error/computed-once.rkt"
         "../flvector.rkt")

(provide differentiated jacobian-of differences when-asked)

;; run       : y dy -> void
;; jacobian! : y J -> void; stores the n² derivatives of f at y, those by the first
;;             component of y first
(struct differentiated (run jacobian!)
  #:authentic
  #:property prop:procedure 0)

;; -> jacobian! of a right-hand side in n variables
(define (jacobian-of f! n)
  (if (differentiated? f!) (differentiated-jacobian! f!) (differences f! n)))

;; (make) : -> jacobian!, made when derivatives are first asked for: a method may never do so
(define (when-asked make)
  (define made (once make))
  (lambda (y J) ((made) y J)))

(define root-of-rounding 1.5e-8)

(define (differences f! n)
  (define moved (make-flvector n))
  (define before (make-flvector n))
  (define after (make-flvector n))
  (lambda (y J)
    (f! y before)
    (flvector-copy! moved y)
    (for ([j (in-range n)])
      (define x (flvector-ref y j))
      (define there (fl+ x (fl* root-of-rounding (flmax 1e-3 (flabs x)))))
      (flvector-set! moved j there)
      (f! moved after)
      (flvector-set! moved j x)
      (for ([i (in-range n)])
        (flvector-set! J (+ i (* j n))
                       (fl/ (fl- (flvector-ref after i) (flvector-ref before i))
                            (fl- there x)))))))
