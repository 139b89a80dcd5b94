#lang racket/base
;; Steps that crawl, because rounding in f is more than the error tolerated of a step.
;;
;; Near a place where a formula is 0/0 the slope has few digits left.  The error of a step is no
;; shorter step's to mend then: a step of length h is wrong by h δ, where δ is the rounding
;; error of f, and h is made so short that this is tolerated.  The nearer the place, the shorter
;; the steps, and an integration would go on for ever.
;;
;; A crawl is a long row of steps that are much shorter than the longest, and get shorter
;; still: a stiff system takes as many short ones, each a little wrong by rounding, and arrives.
;; δ is found from the sixth difference of f within a part of such a step, where nothing else is
;; left of it.

(require racket/flonum
         "stepper.rkt"
         (only-in "../constants.rkt" epsilon) "../flvector.rkt" "../record-fields.rkt")

(provide make-crawl crawls? rounding-exceeds? state-too-coarse)

;; longest : of the steps so far; row : of the short ones since, or #f
;; least   : of the steps since one that was not short
;; coarse  : the time and the state where it had too few digits, or #f
(struct crawl ([longest #:mutable] [row #:mutable] [least #:mutable] [coarse #:mutable])
  #:authentic)

;; short       : how many there are
;; half        : when its lengths are compared, those of so many are to be the later ones
;; early, late : the sums of lengths in both halves
(struct row (short half early late) #:authentic)

(define (make-crawl) (crawl 0.0 #f +inf.0 #f))

(define much-shorter 1e-4)
(define still-shorter 0.9)
(define first-half 500)
(define most-half 32000)

;; Told of a step of length h: is it the last of a long row of short ones, which get shorter?
;; Where a row does not tell, one of twice its length may: lengths fall as powers of the number
;; of steps do.
(define (crawls? c h)
  (cond [(fl> h (fl* much-shorter (crawl-longest c)))
         (when (fl> h (crawl-longest c)) (set-crawl-longest! c h))
         (set-crawl-row! c #f)
         #f]
        [else
         (define r (one-longer (or (crawl-row c) (row 0 first-half 0.0 0.0)) h))
         (define full? (= (row-short r) (* 2 (row-half r))))
         (set-crawl-row! c (if full? (lengthened r) r))
         (and full? (fl< (row-late r) (fl* still-shorter (row-early r))))]))

(define (one-longer r h)
  (define-fields row r short half early late)
  (if (< short half)
      (row (+ 1 short) half (fl+ h early) late)
      (row (+ 1 short) half early (fl+ h late))))

(define (lengthened r)
  (define-fields row r short half early late)
  (and (< half most-half) (row short (* 2 half) (fl+ early late) 0.0)))

;; Is h δ a fair part of the tolerance, relative to 1 + |y|, and δ more than rounding makes of f
;; where nothing cancels?
(define (rounding-exceeds? f! y h tolerated)
  (define here (rates-at f! y))
  (define slopes
    (for/list ([j (in-range -3 4)])
      (rates-at f! (along y (fl* (->fl j) (fl* part h)) here))))
  (define usual (fl* usual-noise (greatest here)))
  (for/or ([x (in-flvector y)] [i (in-naturals)])
    (define sum
      (for/fold ([sum 0.0]) ([s (in-list slopes)] [c (in-list sixth-difference)])
        (fl+ sum (fl* c (flvector-ref s i)))))
    (define noise (fl/ (flabs sum) size-of-difference))
    (not (fl<= noise
               (flmax usual (fl/ (fl* (fl* fair-part tolerated) (fl+ 1.0 (flabs x))) h))))))

(define part (fl/ 1.0 32.0))
(define sixth-difference '(1.0 -6.0 15.0 -20.0 15.0 -6.0 1.0))
(define size-of-difference (flsqrt 924.0))
(define fair-part 0.1)
(define usual-noise 1e-12)

;; ---------------------------------------------------------------------------
;; Steps that do not crawl
;;
;; A method that computes its steps from derivatives, as Taylor's does, has no error that would
;; tell it, and others may be lucky: a few short steps lead through the narrow place and out of it.
;; There the state itself has too few digits: of an angle near π, 4e-16 is the next number, and
;; where f goes as the angle's distance from π to the power −3, that is much.

;; Is a step of length h to y at the time t one out of such a place?  The places are looked at
;; where the steps are the shortest so far of some that are much shorter than the longest: would y
;; rounded otherwise, in one of its numbers, change f's effect in the time h by far more than the
;; tolerance?  A motion that ends there, for f is not finite, has better to say.
;; -> #f, or the time and a copy of the state in that place
(define (state-too-coarse c f! t y h tolerated)
  (define short? (fl<= h (fl* shorter (crawl-longest c))))
  (define found (crawl-coarse c))
  (cond [(and found (fl> h (fl* out (crawl-least c)))) found]
        [(not short?) (set-crawl-least! c +inf.0) #f]
        [else
         (when (fl< h (crawl-least c)) (look-at-state! c f! t y h tolerated))
         #f]))

(define (look-at-state! c f! t y h tolerated)
  (set-crawl-least! c h)
  (when (fl> (fl* h (change-by-rounding f! y)) (fl* far-more tolerated))
    (set-crawl-coarse! c (cons t (flvector-copy y)))))

(define shorter 1e-3)
(define far-more 100.0)
(define out 4.0)

;; The greatest change of f, relative to 1 + |y|, by a change of one number to the next.
(define (change-by-rounding f! y)
  (define here (rates-at f! y))
  (define beside (flvector-copy y))
  (for/fold ([most 0.0]) ([x (in-flvector y)] [k (in-naturals)])
    (flvector-set! beside k (fl+ x (fl* epsilon x)))
    (define there (rates-at f! beside))
    (flvector-set! beside k x)
    (for/fold ([most most]) ([a (in-flvector here)] [b (in-flvector there)] [x (in-flvector y)])
      (flmax most (fl/ (flabs (fl- b a)) (fl+ 1.0 (flabs x)))))))
