#lang racket/base
;; The function of an event along a step that is a polynomial in the time (numeric/ode/taylor).
;;
;; A coordinate is a polynomial already.  Of another function Taylor coefficients follow from
;; those of the state by the same recurrences.  Its radius of convergence may be less than
;; that of the motion, by which the step was chosen: where they do not tell zeros
;; (certain-zeros.rkt) each half of the step has coefficients of its own, and so on; where there are
;; still none, as at a pole, the step is looked at in places, as many as that radius asks for.

(require racket/flonum
         (only-in racket/list last)
         racket/unsafe/ops
         "event-noise.rkt" "certain-zeros.rkt"
         "../../compile/jet/jet-program.rkt" "../../compile/program.rkt"
         (only-in "../../numeric/constants.rkt" rounding)
         "../../numeric/flvector.rkt" "../../numeric/vector-map.rkt"
         "../../numeric/Taylor/expansion.rkt" "../../numeric/Taylor/polynomial-zeros.rkt"
         "../../numeric/ode/taylor-piece.rkt")

(provide polynomial-along zeros-along polynomial-end (struct-out zero))

;; p : the program of a function of a state of n scalars, or #f; value-at : flvector -> its value
;; -> (interpolant, the value where the step begins or #f -> parts of the step, with
;; coefficients along each; 'clear if there is plainly no zero; or how many places to look at),
;; and (part -> is the function only noise along it?), to be asked of the step looked at last
(define (polynomial-along p n tolerance value-at)
  (define coordinate (and p (coordinate-of p n)))
  (define make (and p (not coordinate) (program->expansion-maker p n #:follow? #t)))
  (define f
    (and (procedure? make)
         (follower make n tolerance value-at (expansion-maker-branches? make) #f 1.0)))
  (define along
    (cond [coordinate (lambda (e span first) (coordinate-along e coordinate span first))]
          [f (lambda (e span first) (function-along f e span first))]
          [else #f]))
  (values (lambda (at first)
            (if (and along (taylor-piece? at))
                (call-with-coefficients at (lambda (e) (along e (taylor-piece-span at) first)))
                usual-places))
          (lambda (p) (and f (follows-noise? f (part-rows p))))))

;; Of a step: where it begins and how wide it is, the step being 1; the coefficients along it; and
;; the rows of the state that gave them, if there are zeros, or #f where these were followed last.
(struct part (from width coefficients rows) #:authentic)

(define (coordinate-along e coordinate span first)
  (define row (coefficient-row e coordinate))
  (cond [(clear? row (expansion-order e) (flabs span)) 'clear]
        [else
         (define c (beginning-with first (scaled row (expansion-order e) span)))
         (if (flvector-finite? c) (list (part 0.0 1.0 c #f)) usual-places)]))

(define (function-along f e span first)
  (define order (expansion-order e))
  (define tolerance (follower-tolerance f))
  (define states (expansion-states e))
  (define c (beginning-with first (follow-function! f states order span)))
  (define (uncertain) (uncertainty f span))
  (define (halves)
    (define rows (for/vector ([row (in-vector states)]) (scaled row order span)))
    ;; half as long, a series of twenty terms ends a million times as small: little more work
    ;; leaves nothing of its rest
    (halves-along f rows order 0.0 1.0 first (flmax rounding (fl* 1e-3 tolerance)) most-halvings))
  (define least-places (if (follower-branches? f) places-about-branch usual-places))
  (cond [(not (flvector-finite? c)) least-places]
        [(not (tells-zeros? c tolerance uncertain)) (or (halves) (max least-places (places-for c)))]
        [(follows-polynomial? f states span c uncertain) (list (part 0.0 1.0 c #f))]
        [else (or (halves) least-places)]))

;; Beginning on the side of 0 on which the step before ended, lest a zero between is missed, or
;; found twice.  On the same side the function knows better.
(define (beginning-with first c)
  (when (and first (not (fl> (fl* first (flvector-ref c 0)) 0.0))) (flvector-set! c 0 first))
  c)

;; rows : of the state, along the part that begins at `from` -> the parts of its halves, or #f
(define (halves-along f rows order from width first tolerance halvings)
  (define half (fl* 0.5 width))
  (define (parts rows from first)
    (define c (beginning-with first (follow-function! f rows order 1.0)))
    (define (uncertain) (uncertainty f 1.0))
    (cond [(not (flvector-finite? c)) #f]
          [(and (tells-zeros? c tolerance uncertain) (follows-polynomial? f rows 1.0 c uncertain))
           (list (part from half c (and (pair? (zeros-of c (follower-tolerance f))) rows)))]
          [(= halvings 0) #f]
          [else (halves-along f rows order from half first tolerance (- halvings 1))]))
  (define left (vector-map halved rows))
  (define earlier (parts left from first))
  (define later
    (and earlier (parts (vector-map shifted left) (fl+ from half) (polynomial-end earlier))))
  (and later (append earlier later)))

(define places-about-branch 64)
(define most-halvings 12)

;; Is the row far enough from 0 all the way for that to be plain?
(define (clear? row order span)
  (let loop ([k order] [rest 0.0])
    (if (unsafe-fx= k 0)
        (unsafe-fl> (unsafe-flabs (unsafe-flvector-ref row 0)) (unsafe-fl* 1.01 rest))
        (loop (unsafe-fx- k 1)
              (unsafe-fl* span (unsafe-fl+ rest (unsafe-flabs (unsafe-flvector-ref row k))))))))

;; The index of the coordinate that the program gives, or #f.
(define (coordinate-of p n)
  (define o (vector-ref (program-outputs p) 0))
  (and (place? o) (< (place-index o) n) (place-index o)))

;; make : order inputs -> expansion; value-at : flvector -> value; branches? : may it leave its
;; series?  own : expansion of the function, made for the order when it is known; span : of the
;; step followed last, in the unit of its coefficients
(struct follower (make n tolerance value-at branches? [own #:mutable] [span #:mutable])
  #:authentic)

;; rows : of the state -> coefficients of the function along the span, from 0 to 1
(define (follow-function! f rows order span)
  (unless (follower-own f)
    (set-follower-own! f ((follower-make f) order (make-flvector (follower-n f)))))
  (define own (follower-own f))
  (for ([from (in-vector rows)] [to (in-vector (expansion-states own))]) (flvector-copy! to from))
  (set-follower-span! f span)
  (follow! own)
  (scaled (function-row own) order span))

;; Has the function the values of the polynomial c, in the middle and at the end?  Not where it has
;; taken another branch, nor where terms of higher order than these grow, as of exp(100 t).
(define (follows-polynomial? f rows span c uncertain)
  (define value-at (follower-value-at f))
  (define (off theta)
    (define point
      (for/flvector #:length (vector-length rows) ([row (in-vector rows)])
        (polynomial-value row (fl* theta span))))
    (flabs (fl- (value-at point) (polynomial-value c theta))))
  (define most (flmax (off 1.0) (off 0.5)))
  (or (fl<= most (fl* (fl* 100.0 (follower-tolerance f)) (total c)))
      (fl<= most (uncertain))))

(define (function-row own) (vector-ref (expansion-slopes own) 0))

;; rows : of the state, or #f : those that were followed last, which are changed for it
(define (follows-noise? f rows)
  (define own (follower-own f))
  (when rows (follow-function! f rows (expansion-order own) 1.0))
  (define (size row) (row-size row (expansion-order own) (follower-span f)))
  (define row (flvector-copy (function-row own)))
  (noise? (size row) (size (change! f))))

;; By how much the function that was followed last may be off where it begins, and its change from
;; there on.  Of higher orders nothing is said: they are large where there is no series.
(define (uncertainty f span)
  (define by (change! f))
  (fl+ (flabs (flvector-ref by 0)) (flabs (fl* span (flvector-ref by 1)))))

;; -> row, by how much the function changes with the uncertainty of the state
(define (change! f)
  (define own (follower-own f))
  (define row (flvector-copy (function-row own)))
  (vary-rows! (expansion-states own) (follower-tolerance f))
  (follow! own)
  (difference (function-row own) row))

(define (polynomial-end parts) (polynomial-value (part-coefficients (last parts)) 1.0))

;; In each part those that its own noise does not account for: a function that ends in nothing
;; but noise may well have had zeros before.
(define (zeros-along parts tolerance only-noise?)
  (for*/list ([p (in-list parts)]
              [zeros (in-value (zeros-of (part-coefficients p) tolerance))]
              #:unless (or (null? zeros) (only-noise? p))
              [z (in-list zeros)])
    (zero (fl+ (part-from p) (fl* (part-width p) (zero-at z))) (zero-kind z))))

;; Where the function hardly varies nothing is touched.
(define (zeros-of c tolerance)
  (define size (total c))
  (define varies (fl- size (flabs (flvector-ref c 0))))
  (define touch (flmax tolerance (fl* 1e-15 size)))
  (if (fl> (flabs (flvector-ref c 0)) (fl* 1.01 varies))
      '()
      (polynomial-zeros c (if (fl> varies (fl* 1e3 touch)) touch 0.0))))
