#lang racket/base
;; Where a coordinate turns back: the zero of R nearest to where it is, ahead.
;;
;; It is looked for outwards in growing steps until R is below 0, then by halves.  Within a step
;; derivatives tell of two things that must not be passed over:
;;
;;   a barrier    R falls at the beginning of the step and rises at its end: there is a least
;;                value between, which may be below 0
;;   a pole       as of L²/r² at r = 0, a zero of the denominator D of R, behind which R may be
;;                above 0 again; Newton's step D/DD never leads farther, and half of it is taken.

(provide turning-point (struct-out radicand))

;; R, its derivative, its denominator, and the derivative of that: flonum -> flonum
(struct radicand (value slope denominator denominator-slope) #:authentic)

(define first-step 1e-3)
(define growth 1.1)
(define farthest 1e12)
(define at-a-pole 1e-6)

;; direction : −1.0 or 1.0 -> flonum, or #f if R stays above 0
(define (turning-point r start direction)
  (define scale (+ 1.0 (abs start)))
  (let walk ([inside start] [step (* first-step scale)] [last +inf.0])
    (define h (min step (* 0.5 (distance-to-pole r inside direction))))
    (define next (+ inside (* direction h)))
    (cond [(= next inside) (and (< last (* at-a-pole scale)) inside)]
          [(> (abs (- next start)) (* farthest scale)) #f]
          [(allowed? r next)
           (define barrier (barrier-between r inside next direction))
           (if barrier (halved r inside barrier) (walk next (* growth step) h))]
          [else (halved r inside next)])))

(define (allowed? r q) (>= ((radicand-value r) q) 0.0))

;; By Newton's step, or +inf.0 if none is ahead
(define (distance-to-pole r q direction)
  (define-values (D slope)
    (values ((radicand-denominator r) q) ((radicand-denominator-slope r) q)))
  (define d (if (= slope 0.0) +inf.0 (* -1.0 direction (/ D slope))))
  (cond [(= D 0.0) 0.0]
        [(> d 0.0) d]
        [else +inf.0]))

;; A place between that R does not allow, or #f: at the zero of its derivative
(define (barrier-between r inside next direction)
  (define (slope q) (* direction ((radicand-slope r) q)))
  (and (< (slope inside) 0.0)
       (> (slope next) 0.0)
       (let halve ([falling inside] [rising next])
         (define middle (* 0.5 (+ falling rising)))
         (cond [(not (allowed? r middle)) middle]
               [(or (= middle falling) (= middle rising)) #f]
               [(< (slope middle) 0.0) (halve middle rising)]
               [else (halve falling middle)]))))

(define (halved r inside outside)
  (define middle (* 0.5 (+ inside outside)))
  (cond [(or (= middle inside) (= middle outside)) inside]
        [(allowed? r middle) (halved r middle outside)]
        [else (halved r inside middle)]))
