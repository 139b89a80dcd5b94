#lang racket/base
;; Jacobi's rotations: turns in the plane of two coordinates, pair after pair, until nothing is left
;; to turn.

(require racket/flonum)

(provide turn-all-pairs! rotation mix!)

;; (turn! p q) -> was there anything to turn?
(define (turn-all-pairs! n turn!)
  (let sweep ([rest 60])
    (when (and (for*/fold ([any? #f]) ([p (in-range n)] [q (in-range (+ p 1) n)])
                 (or (turn! p q) any?))
               (> rest 0))
      (sweep (- rest 1)))))

;; Twice the angle to turn by has the cotangent x; the tangent of the angle is the smaller root of
;; t² + 2 t x − 1.
;; -> tangent, cosine and sine of the angle
(define (rotation x)
  (define size (fl/ 1.0 (fl+ (flabs x) (flsqrt (fl+ 1.0 (fl* x x))))))
  (define tangent (if (fl< x 0.0) (fl- 0.0 size) size))
  (define cosine (fl/ 1.0 (flsqrt (fl+ 1.0 (fl* tangent tangent)))))
  (values tangent cosine (fl* tangent cosine)))

;; Turns entry i of u and entry j of w.
(define (mix! u i w j c s)
  (define x (flvector-ref u i))
  (define y (flvector-ref w j))
  (flvector-set! u i (fl- (fl* c x) (fl* s y)))
  (flvector-set! w j (fl+ (fl* s x) (fl* c y))))
