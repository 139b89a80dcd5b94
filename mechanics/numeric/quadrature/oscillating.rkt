#lang racket/base
;; Integrals to infinity of functions that change their sign again and again while they
;; decay, like sin x/x.
;;
;; The integrals from each zero to the next alternate in sign and fall, so that their sum
;; converges; slowly, but the epsilon algorithm finds its limit from some twenty of them
;; (I. M. Longman, 1956).  It finds one for sums that have none, too: that of sin x itself.
;; So the function must be seen to decay, here and very far away.

(require racket/list
         "epsilon-algorithm.rkt" "gauss-kronrod.rkt"
         "../finite-number.rkt"
         "../optimization/brent-root.rkt"
         "../../error/failure.rkt" "../../error/refusal.rkt")

(provide oscillating-quadrature)

(define least-parts 16)
(define most-parts 100)
(define most-panels 200)

;; The integral of f from 0 to infinity and a bound of its error, or #f twice;
;; unit : a length over which f may begin to change; (endless) is called where the parts
;; between zeros do not fall
(define (oscillating-quadrature f unit tolerance [endless void])
  (define z (next-zero f 0.0 (/ unit 16.0) 1000))
  (define first-part (and z (part-integral f 0.0 z tolerance most-panels)))
  (if first-part
      (sum-of-parts f z z first-part tolerance endless)
      (values #f #f)))

;; zeros, parts : the integrals between them, the last first; diagonal : of the sums; agreed :
;; how many limits in a row have
(define (sum-of-parts f z gap start tolerance endless)
  (let loop ([zeros (list z)] [gap gap] [sum start] [parts '()] [diagonal (list start)]
             [agreed 0])
    (define limit (estimated-limit diagonal))
    (define size (+ (abs limit) (apply max 0.0 (map abs parts))))
    (define (found?) (and (>= agreed 3) (decaying? f zeros parts)))
    (cond
      [(and (>= (length parts) least-parts) (found?)) (values limit (* tolerance size))]
      [(= (length parts) most-parts)
       (when (level? parts) (endless))
       (values #f #f)]
      [else
       (define next (next-zero f (car zeros) (/ gap 8.0) 200))
       (define p (and next (part-integral f (car zeros) next tolerance most-panels)))
       (cond
         [p
          (define longer (extend-diagonal diagonal (+ sum p)))
          (define close? (<= (abs (- (estimated-limit longer) limit)) (* 0.1 tolerance size)))
          (loop (cons next zeros) (- next (car zeros)) (+ sum p) (cons p parts) longer
                (if close? (+ agreed 1) 0))]
         [else (values #f #f)])])))

;; A zero after s, in steps; or #f.
(define (next-zero f s step most-steps)
  (let loop ([a (+ s (* 0.5 step))] [y (f (+ s (* 0.5 step)))] [left most-steps])
    (define b (+ a step))
    (define y* (f b))
    (cond [(not (and (finite? y) (finite? y*))) #f]
          [(< (* y y*) 0.0) (zero-between f a b)]
          [(= left 0) #f]
          [else (loop b y* (- left 1))])))

(define (zero-between f a b)
  (if-raised exn:fail:mechanics? #f
    (define-values (z error count) (bracketed-root f a b #:tolerance 1e-10 #:jump void))
    z))

;; ---------------------------------------------------------------------------

;; Do the parts alternate and fall, and the function far away, as a power at least?  Where its
;; waves become shorter, it is their area that must fall: sin x² does not decay.
(define (decaying? f zeros parts)
  (define half (list-tail parts (quotient (length parts) 2)))
  (define-values (z gap) (values (car zeros) (- (car zeros) (cadr zeros))))
  (define shorter (shortening zeros))
  (and (alternating-and-falling? parts)
       (<= (abs (car parts)) (* 0.9 (abs (car half))))
       (let ([near (amplitude f z gap)]
             [far (amplitude f (* 1e4 z) gap)]
             [farthest (amplitude f (* 1e8 z) gap)])
         (and near far farthest
              (<= (* far shorter) (* 0.2 near))
              (<= (* farthest shorter) (* 0.2 far))))))

(define (alternating-and-falling? parts)
  (for/and ([p (in-list parts)] [before (in-list (cdr parts))] [_ (in-range 6)])
    (and (< (* p before) 0.0) (< (abs p) (abs before)))))

;; The length of a wave 10⁴ times as far away beside that of the last, if lengths go as a power of
;; the distance; 1 if they do not fall.
(define (shortening zeros)
  (define half (list-tail zeros (quotient (length zeros) 2)))
  (define (gap zeros) (- (car zeros) (cadr zeros)))
  (define exponent (/ (log (/ (gap zeros) (gap half))) (log (/ (car zeros) (car half)))))
  (if (< exponent -0.1) (expt 1e4 exponent) 1.0))

;; Parts that are as large at the end as before, and alternate
(define (level? parts)
  (define half (list-tail parts (quotient (length parts) 2)))
  (and (for/and ([p (in-list parts)] [before (in-list (cdr parts))]) (< (* p before) 0.0))
       (>= (abs (car parts)) (* 0.999 (abs (car half))))
       (>= (abs (car half)) (* 0.99 (abs (last half))))))

;; The greatest value at points that are spread over a period.
(define (amplitude f z gap)
  (for/fold ([m 0.0]) ([k (in-range 40)] #:break (not m))
    (define y (abs (f (+ z (* gap 0.0618034 k)))))
    (and (< y +inf.0) (max m y))))
