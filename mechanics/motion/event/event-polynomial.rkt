#lang racket/base
;; The function of an event along a step that is a polynomial in the time (numeric/ode/taylor).
;;
;; A coordinate is a polynomial already.  Of another function Taylor coefficients follow from
;; those of the state by the same recurrences.  Its radius of convergence may be less than
;; that of the motion, by which the step was chosen: where the last terms are not small there
;; is no polynomial, and the step is looked at in places, as many as that radius asks for.

(require racket/flonum
         racket/unsafe/ops
         "event-noise.rkt"
         "../../compile/jet-program.rkt" "../../compile/program.rkt"
         "../../numeric/flvector.rkt" "../../numeric/unboxed.rkt"
         "../../numeric/jet/expansion.rkt" "../../numeric/jet/polynomial-zeros.rkt"
         "../../numeric/ode/taylor-piece.rkt")

(provide polynomial-along zeros-along polynomial-end (struct-out zero))

;; p : the program of a function of a state of n scalars, or #f
;; -> (interpolant, the value where the step begins or #f -> coefficients along the step, from
;; 0 to 1, an flvector; 'clear if there is plainly no zero; or how many places to look at), and
;; (interpolant -> is the function of that step, which was looked at last, only noise?)
(define (polynomial-along p n tolerance)
  (define coordinate (and p (coordinate-of p n)))
  (define make (and p (not coordinate) (program->expansion-maker p n #:follow? #t)))
  (define f (and (procedure? make) (follower make n tolerance #f)))
  (define row-along
    (cond [coordinate (lambda (e) (coefficient-row e coordinate))]
          [f (lambda (e) (follow-function! f e))]
          [else #f]))
  (values (polynomial-maker row-along coordinate tolerance)
          (lambda (at) (and f (follows-noise? f (taylor-piece-span at))))))

(define (polynomial-maker row-along coordinate tolerance)
  (lambda (at first)
    (if (and row-along (taylor-piece? at))
        (call-with-coefficients at
          (lambda (e)
            (define row (row-along e))
            (define span (taylor-piece-span at))
            (if (and coordinate (clear? row (expansion-order e) (flabs span)))
                'clear
                (polynomial row (expansion-order e) span first
                            (if coordinate #f tolerance)))))
        usual-places)))

(define usual-places 8)
(define most-places 400)

;; Is the row far enough from 0 all the way for that to be plain?
(define (clear? row order span)
  (let loop ([k order] [rest 0.0])
    (if (unsafe-fx= k 0)
        (unsafe-fl> (unsafe-flabs (unsafe-flvector-ref row 0)) (unsafe-fl* 1.01 rest))
        (loop (unsafe-fx- k 1)
              (unsafe-fl* span (unsafe-fl+ rest (unsafe-flabs (unsafe-flvector-ref row k))))))))

;; tolerance : of the last terms, or #f for the coefficients of a coordinate, good as they are
(define (polynomial row order span first tolerance)
  (define c (scaled row order span))
  (when first (flvector-set! c 0 first))
  (cond [(not (flvector-finite? c)) usual-places]
        [(not tolerance) c]
        [(converges? c tolerance) c]
        [else (places-for c)]))

;; Six for the radius of convergence.
(define (places-for c)
  (define n (- (flvector-length c) 1))
  (define (ratio k)
    (flexpt (fl/ (flabs (flvector-ref c k)) (fl+ 1e-300 (flabs (flvector-ref c 0))))
            (fl/ 1.0 (->fl k))))
  (define wanted (fl* 6.0 (flmax (ratio n) (ratio (- n 1)))))
  (if (fl< wanted (->fl most-places)) (max usual-places (fl->exact-integer (ceiling wanted)))
      most-places))

;; The index of the coordinate that the program gives, or #f.
(define (coordinate-of p n)
  (define o (vector-ref (program-outputs p) 0))
  (and (place? o) (< (place-index o) n) (place-index o)))

;; make : order inputs -> expansion; own : that of the function, made for the order when it is
;; known
(struct follower (make n tolerance [own #:mutable]) #:authentic)

;; -> the row of the function along the motion
(define (follow-function! f e)
  (unless (follower-own f)
    (set-follower-own! f ((follower-make f) (expansion-order e) (make-flvector (follower-n f)))))
  (define own (follower-own f))
  (for ([from (in-vector (expansion-states e))] [to (in-vector (expansion-states own))])
    (flvector-copy! to from))
  (follow! own)
  (function-row own))

(define (function-row own) (vector-ref (expansion-slopes own) 0))

;; The motion followed last is changed for it.
(define (follows-noise? f span)
  (define own (follower-own f))
  (define (size row) (row-size row (expansion-order own) span))
  (define row (flvector-copy (function-row own)))
  (vary-rows! (expansion-states own) (follower-tolerance f))
  (follow! own)
  (noise? (size row) (size (difference (function-row own) row))))

;; c_k span^k, 0 where c_k is, however long the step
(define (scaled row order span)
  (define c (make-flvector (+ order 1)))
  (let loop ([k 0] [power 1.0])
    (when (unsafe-fx<= k order)
      (define x (unsafe-flvector-ref row k))
      (unsafe-flvector-set! c k (if (unsafe-fl= x 0.0) 0.0 (unsafe-fl* power x)))
      (loop (unsafe-fx+ k 1) (unsafe-fl* span power))))
  c)

(define (converges? c tolerance)
  (define n (flvector-length c))
  (define last (fl+ (flabs (flvector-ref c (- n 1))) (flabs (flvector-ref c (- n 2)))))
  (fl<= last (fl* (fl* 10.0 tolerance) (flmax 1.0 (total c)))))

(define-syntax-rule (sum c of)
  (let loop ([k (unsafe-fx- (flvector-length c) 1)] [sum 0.0])
    (if (unsafe-fx< k 0)
        (unboxed sum)
        (loop (unsafe-fx- k 1) (unsafe-fl+ sum (of (unsafe-flvector-ref c k)))))))

(define (total c) (sum c unsafe-flabs))
(define (polynomial-end c) (sum c begin))

;; The zeros along a step.  Where the function hardly varies nothing is touched.
(define (zeros-along c tolerance)
  (define size (total c))
  (define varies (fl- size (flabs (flvector-ref c 0))))
  (define touch (flmax tolerance (fl* 1e-15 size)))
  (if (fl> (flabs (flvector-ref c 0)) (fl* 1.01 varies))
      '()
      (polynomial-zeros c (if (fl> varies (fl* 1e3 touch)) touch 0.0))))
