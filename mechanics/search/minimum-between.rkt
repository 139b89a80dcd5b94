#lang racket/base
;; Minima of a function of one number between two ends.
;;
;; Brent's method finds one in a bracket.  It never asks for the ends, so these are compared
;; with the points found near them.  Where all values were the same, on a plateau, or where all
;; minima are wanted, the interval is sampled: each sample that is lower than its neighbours
;; brackets a minimum.  Samples are doubled until twice in a row no more minima come up; a
;; narrower one than their distance may still hide.

(require racket/list
         "../error/failure.rkt" "../error/note.rkt"
         "../numeric/constants.rkt" "../numeric/checked-arguments.rkt"
         "../numeric/optimization/point.rkt")

(provide minimum-between minima-between (struct-out found))

;; kind : 'inside, 'flat, 'pole, where there is no minimum, 'low or 'high, the end where it is
;; steps : of the method
;; evaluations : of the function, but for samples where all minima are looked for
(struct found (x y kind steps evaluations) #:authentic)

;; method : f low high -> (list argument value steps)
;; f : flonum -> real; low, high : real numbers, which the method checks
(define (minimum-between who f low high method)
  (define s (make-survey who f))
  (define (search a b) (apply judged s low high (method (survey-function s) a b)))
  (define m (search low high))
  (define from (and (eq? 'flat (found-kind m)) (lower-sample s low high (found-y m))))
  (define best (if from (search (first from) (second from)) m))
  (when (pole? best)
    (raise-singular who "no minimum found: the function falls without bound, at a pole"
                    (found-x best) "near" (found-x best) "value there" (found-y best)))
  best)

(define (pole? m) (eq? 'pole (found-kind m)))

;; ---------------------------------------------------------------------------
;; The values met

;; least, greatest : of the values, or #f
(struct survey (who f [least #:mutable] [greatest #:mutable] [count #:mutable]) #:authentic)

(define (make-survey who f) (survey who f #f #f 0))

(define ((survey-function s) x)
  (define y ((survey-f s) x))
  (set-survey-count! s (+ 1 (survey-count s)))
  (when (real? y)
    (set-survey-least! s (min y (or (survey-least s) y)))
    (set-survey-greatest! s (max y (or (survey-greatest s) y))))
  y)

(define (survey-level? s) (eqv? (survey-least s) (survey-greatest s)))

;; The value at a place that Brent's method would not have asked about; +inf.0 where f has none
(define (value-there s x)
  (define y (with-handlers ([no-value? (lambda (e) +nan.0)]) ((survey-function s) x)))
  (if (rational? y) (real->double-flonum y) +inf.0))

;; ---------------------------------------------------------------------------
;; Which kind it is

;; Where all values are equal, x is as good as any other.
(define (judged s low high x y steps)
  (if (survey-level? s)
      (found x y 'flat steps (survey-count s))
      (at-end-or-inside s low high x y steps)))

;; Is the minimum at an end that x is next to, or is x at a pole?
(define (at-end-or-inside s low high x y steps)
  (define (near? end)
    (<= (abs (- x end)) (* 1e-5 (max (abs x) (* 1e-2 (abs (- high low)))))))
  (define (the-end end kind)
    (define there (and (near? end) (value-there s (real->double-flonum end))))
    (and there (<= there y)
         (found (real->double-flonum end) there kind steps (survey-count s))))
  (define (value x) (value-there s x))
  (or (the-end low 'low)
      (the-end high 'high)
      (let ([kind (if (bottomless? value x y low high) 'pole 'inside)])
        (found x y kind steps (survey-count s)))))

;; ---------------------------------------------------------------------------
;; Samples

;; n + 1 samples from end to end, shifted so that they keep out of step with a periodic f.
(define (samples s low high n)
  (define step (/ (- high low) (real->double-flonum n)))
  (for/list ([k (in-range (+ n 1))])
    (define shift (if (< 0 k n) (* 0.4 (- (spread-fraction k) 0.5)) 0.0))
    (define x (if (= k n) (real->double-flonum high) (+ low (* step (+ k shift)))))
    (point x (value-there s x))))

(define plateau-samples 64)

;; The neighbours of the lowest sample, if it is lower than y; or #f
(define (lower-sample s low high y)
  (define all (samples s (min low high) (max low high) plateau-samples))
  (define best (argmin point-y all))
  (and (< (point-y best) y)
       (let ([k (index-of all best eq?)])
         (list (point-x (list-ref all (max 0 (- k 1))))
               (point-x (list-ref all (min plateau-samples (+ k 1))))))))

(define fewest-samples 64)
(define most-samples 4096)

;; All minima found, from left to right.
(define (minima-between who f low high method)
  (check-interval who low high)
  (define s (make-survey who f))
  (define-values (a b) (values (real->double-flonum (min low high))
                               (real->double-flonum (max low high))))
  (let loop ([n fewest-samples] [before #f] [again? #f])
    (define brackets (brackets-of (samples s a b n)))
    (define same? (eqv? before (length brackets)))
    (cond
      [(or (and same? again?) (>= n most-samples))
       (define all (filter values (for/list ([c (in-list brackets)]) (bracketed s c a b method))))
       (note-more who (length all) (/ (- b a) n))
       all]
      [else (loop (* 2 n) (length brackets) same?)])))

;; first, lowest, last : samples.  Of equal ones side by side the first stands for all.
(struct bracket (first lowest last) #:authentic)

(define (brackets-of all)
  (define distinct
    (let loop ([all all])
      (cond [(or (null? all) (null? (cdr all))) all]
            [(= (point-y (first all)) (point-y (second all)))
             (loop (cons (first all) (cddr all)))]
            [else (cons (first all) (loop (cdr all)))])))
  (for/list ([p (in-list (cons #f distinct))] [q (in-list distinct)]
             [r (in-list (append (cdr distinct) (list #f)))]
             #:when (and (or (not p) (< (point-y q) (point-y p)))
                         (or (not r) (< (point-y q) (point-y r)))
                         (< (point-y q) +inf.0)))
    (bracket (or p q) q (or r q))))

;; The minimum in a bracket; #f at a pole.
(define (bracketed s c low high method)
  (define-values (a b) (values (point-x (bracket-first c)) (point-x (bracket-last c))))
  (define lowest (bracket-lowest c))
  (cond
    [(= a b) (found a (point-y lowest) 'flat 0 (survey-count s))]
    [else
     (set-survey-count! s 0)
     (define x+y+steps (method (survey-function s) a b))
     (define-values (x y) (if (<= (second x+y+steps) (point-y lowest))
                              (values (first x+y+steps) (second x+y+steps))
                              (values (point-x lowest) (point-y lowest))))
     (define m (at-end-or-inside s low high x y (third x+y+steps)))
     (and (not (pole? m)) m)]))

(define (note-more who count distance)
  (note-with-result
   (format "~a: ~a found; the samples it went by are ~a apart, a narrower one may be missed"
           who (if (= count 1) "one minimum" (format "~a minima" count))
           (/ (round (* 1e3 distance)) 1e3))))

;; ---------------------------------------------------------------------------
;; Does a function fall without bound where a search found it least?
;;
;; Towards a minimum, or a kink as of |x| or √|x|, it falls by less and less from ten times a
;; distance to the distance, as that shrinks; towards a pole by more and more, and towards the
;; pole of a logarithm by as much.

;; value : flonum -> flonum, +inf.0 where there is none; y : the value at x
(define (bottomless? value x y low high)
  (define length (- high low))            ; of either sign: both sides are looked at
  (define (at distance)
    (define there (+ x (* distance length)))
    (if (<= (min low high) there (max low high)) (value there) +inf.0))
  (define ((fall side) distance) (- (at (* side 10.0 distance)) (at (* side distance))))
  (define (grows? fall)
    (define last (fall 1e-8))
    (and (< (* 1e-9 (abs y)) last +inf.0)
         (let ([middle (fall 1e-6)])
           (and (< 0.0 middle +inf.0) (>= last (* 0.9 middle))
                (let ([first (fall 1e-4)])
                  (and (< 0.0 first +inf.0) (>= middle (* 0.9 first))))))))
  (or (grows? (fall 1.0)) (grows? (fall -1.0))))
