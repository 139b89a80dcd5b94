#lang racket/base
;; How fast an orbit goes around, in turns for each step of the map (SICM 4.4).
;;
;; The mean of the steps of the angle converges as 1/n, for its ends are cut off.  With weights
;; that vanish at both ends with all their derivatives,
;;
;;     w(t) = exp(−1/(t (1 − t))),   0 < t < 1,
;;
;; it converges faster than any power of 1/n if the orbit is quasiperiodic (Das, Saiki, Sander
;; and Yorke 2017).  On a chaotic orbit it does not: there the means over the two halves of the
;; orbit differ.  That is how one is told from the other.  The halves of an orbit whose angle
;; comes back just after one of them are the same, and agree on anything: parts of other
;; lengths are looked at, too.

(require racket/flonum
         (only-in racket/math exact-floor exact-round)
         "compiled-map.rkt" "map-of-the-plane.rkt" "map-on-tuples.rkt" "plane-points.rkt"
         "../../error/complain.rkt"
         "../../generic/define-plain.rkt" "../../generic/describe.rkt"
         "../../generic/up-down.rkt" "../../generic/value-struct.rkt"
         "../../generic/wrong-argument.rkt"
         "../../numeric/constants.rkt" "../../numeric/flvector.rkt"
         "../../numeric/whole-turns.rkt")

(provide rotation-number rotation?)

;; value : turns for each step; error : difference between the means over parts of the orbit
;; steps : length of the orbit; steps-needed : length at which both halves agree, or #f if they
;; never did; of-abscissa? : is the angle the first coordinate?
(value-struct rotation (value error steps steps-needed of-abscissa?)
  #:text rotation->text)

(provide-parts rotation? "what (rotation-number map start) gives"
  rotation-value rotation-error rotation-steps-needed rotation-regular?)

(define (rotation-regular? r) (and (rotation-steps-needed r) #t))

;; Means over parts of a regular orbit differ by less.
(define least-irregular 1e-5)

;; All steps are kept in memory; beyond a million they bring nothing but rounding.
(define longest-orbit 10000000)

;; about : the point around which angles are taken, or #f if the first coordinate is one
(define-plain (rotation-number map start [n 10000] #:about [about #f])
  (define who 'rotation-number)
  (check-map who map start)
  (unless (and (exact-integer? n) (>= n 100))
    (complain-of-argument who "the length of the orbit, an integer of 100 or more" n))
  (when (> n longest-orbit)
    (complain-of-argument who (format "an orbit of at most ~a steps" longest-orbit) n
                          "\n  10000 give ten digits and more where the orbit is regular"))
  (define p (start-point who start))
  (define angle
    (if about (angle-about who map (start-point who about)) (lambda (p) (flvector-ref p 0))))
  (define next-step! (angle-stepper map p angle))
  (define (missing) (raise-no-image who map (flvector-ref p 0) (flvector-ref p 1)))
  (check-goes-around who about p)
  (define steps (followed (flvector) n next-step! missing))
  (define-values (value error apart) (means steps (not about)))
  (rotation value error n (steps-to-agree steps apart next-step! (not about)) (not about)))

;; To see whether an orbit is regular, it is followed for up to 8 times as many steps, at most
;; 10000.
(define-values (times-as-many most-steps) (values 8 10000))

;; Doubles the number of steps until both halves agree; returns that number, or #f.
(define (steps-to-agree steps apart next-step! forwards?)
  (define most (min most-steps (* times-as-many (flvector-length steps))))
  (let look ([steps steps] [apart apart])
    (define twice (* 2 (flvector-length steps)))
    (cond [(fl< apart least-irregular) (flvector-length steps)]
          [(> twice most) #f]
          [(followed steps twice next-step! (lambda () #f))
           => (lambda (more)
                (define-values (value error apart) (means more forwards?))
                (look more apart))]
          [else #f])))

;; -> turns for each step, the error of that, at least the one of rounding, and the
;; difference between both halves.
(define (means steps forwards?)
  (define n (flvector-length steps))
  (define turned (within-half-a-turn steps (mean-direction steps forwards?)))
  (define (mean from to) (fl/ (weighted-mean turned from to) :2pi))
  (define (apart at) (flabs (fl- (mean 0 at) (mean at n))))
  (define-values (whole half) (values (mean 0 n) (quotient n 2)))
  (define-values (halves others) (values (apart half) (apart (exact-floor (* golden-fraction n)))))
  (define rounded (fl* (flsqrt (->fl n)) epsilon))
  (values (if forwards? (flmax 0.0 whole) whole)
          (flmax (flmax halves others) (flmax (flabs (fl- whole (mean 0 half))) rounded))
          halves))

;; A point has no direction from itself.
(define (check-goes-around who about p)
  (when (and about (fl= (distance p (start-point who about)) 0.0))
    (complain who
              (string-append "the orbit starts at the point that it is to go around"
                             "\n  point: ~a\n  (find-fixed-point map point) gives the angle "
                             "by which neighbours turn")
              (value->text about))))

;; Angles grow counterclockwise.  A coordinate that is an angle differs from the center's by at
;; most half a turn.
(define (angle-about who map center)
  (define angles
    (map-on-tuples-angles
     (make-map-on-tuples who map (up (flvector-ref center 0) (flvector-ref center 1)) 1)))
  (define (off p k angle?)
    (define d (fl- (flvector-ref p k) (flvector-ref center k)))
    (if angle? (whole-turns-less d) d))
  (lambda (p) (atan (off p 1 (cadr angles)) (off p 0 (car angles)))))

;; -> a procedure that moves p to its image and returns the change of the angle, or #f
;; where p has no image.
(define (angle-stepper map p angle)
  (define step! (orbit-stepper map p))
  (define q (flvector-copy p))
  (define before (angle p))
  (lambda ()
    (and (step! q)
         (let ([after (angle q)])
           (flvector-copy! p q)
           (begin0 (fl- after before)
                   (set! before after))))))

;; Continues the steps to a number of n; returns the value of (missing) where an image is missing.
(define (followed steps n next-step! missing)
  (define all (make-flvector n))
  (flvector-copy! all steps)
  (let loop ([k (flvector-length steps)])
    (define step (and (< k n) (next-step!)))
    (cond [(= k n) all]
          [step
           (flvector-set! all k step)
           (loop (+ k 1))]
          [else (missing)])))

;; Changes each step by whole turns, until it is within half a turn of the mean direction.
(define (within-half-a-turn steps middle)
  (flvector-map (lambda (step) (fl+ middle (whole-turns-less (fl- step middle)))) steps))

;; Between 0 and a turn if all steps go forwards, else within half a turn on both sides of 0.
(define (mean-direction steps forwards?)
  (define-values (c s)
    (for/fold ([c 0.0] [s 0.0]) ([x (in-flvector steps)])
      (values (fl+ c (flcos x)) (fl+ s (flsin x)))))
  (define a (atan s c))
  (if (and forwards? (fl< a 0.0)) (fl+ a :2pi) a))

(define (weighted-mean steps from to)
  (define-values (sum weights)
    (for/fold ([sum 0.0] [weights 0.0]) ([k (in-range from to)])
      (define t (fl/ (fl+ (->fl (- k from)) 1.0) (fl+ (->fl (- to from)) 1.0)))
      (define w (flexp (fl/ -1.0 (fl* t (fl- 1.0 t)))))
      (values (fl+ sum (fl* w (flvector-ref steps k))) (fl+ weights w))))
  (fl/ sum weights))

(define (rotation->text r)
  (define-values (value error) (values (rotation-value r) (rounded (rotation-error r))))
  (define-values (steps needed) (values (rotation-steps r) (rotation-steps-needed r)))
  (cond [(eqv? needed steps)
         (format "rotation number ~a, to about ~a~a" value error
                 (if (and (rotation-of-abscissa? r) (<= value (rotation-error r))) rest-hint ""))]
        [needed
         (format (string-append "rotation number about ~a: ~a steps are too few to tell it better"
                                "\n  over parts of them it differs by ~a; ~a steps would do")
                 (two-digits value) steps error needed)]
        [else
         (format (string-append "rotation number about ~a, if there is one:"
                                "\n  the orbit does not look regular; over parts of it "
                                "it differs by ~a")
                 (two-digits value) error)]))

(define rest-hint
  (string-append "\n  the first coordinate, taken for an angle, does not turn; "
                 "how an orbit turns about a point, #:about tells"))

(define (two-digits x) (/ (round (* 100 x)) 100))

;; Rounds to one digit, as 3e-14.
(define (rounded x)
  (cond [(= x 0) 0]
        [else
         (define power (exact-floor (/ (log (abs x)) (log 10))))
         (define digit (exact-round (/ x (expt 10.0 power))))
         (real->double-flonum (* digit (expt 10 power)))]))
