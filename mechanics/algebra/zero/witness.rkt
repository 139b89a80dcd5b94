#lang racket/base
;; Points at which an expression is not zero.
;;
;; A witness is for a person to check, so the first points tried give small
;; integers to everything and 0 to symbols under a sine, an exponential or
;; the like, where the value is then exact.  If the expression vanishes there,
;; points with integers for all leaves follow, and then small fractions, sooner where angles
;; are counted in turns.  The points are always the same.  Where assumptions were made they
;; hold at every point.
;;
;; A point counts if each part of the expression has a real value there, and it is a
;; witness if the value of the expression as it is given is proved not to be 0, by balls.
;; Where the ball holds 0, smaller ones are tried: at the points that remain
;; "undecided" reports the greatest.
;;
;; Positive points come first: at √(b² - 4km) a person expects strong damping and
;; masses, not negative ones.

(require racket/list
         "existence.rkt" "further-tries.rkt" "trial-point.rkt" "point-value.rkt" "region.rkt"
         "../expression/flat-graph.rkt" "../expression/operation.rkt" "../expression/pi.rkt"
         "../expression/symbols.rkt")

(provide find-witness)

;; How many points with integers for all leaves are tried; where relations have
;; to hold, most may be in vain.
(define point-limit 12)
(define point-limit/relations 100)

;; How many of them have positive numbers only.
(define positive-points 6)

;; How many points with fractions are tried, and how many of these with positive ones only.
(define fraction-points 24)
(define positive-fraction-points 16)

;; Bits of the first balls, of all points that are looked at again, and of two of them.
(define (first-precision q) (if (> (tape-length (question-e q)) long) 56 80))
(define long 2000)
(define second-precision 160)
(define further-precisions '(640))
(define further-points 2)

;; Operations times bits: the cost allowed to a second look.
(define most-work (expt 2 23))

;; e, residual : the point is given in the leaves of the residual, or twice the same.  The
;; value is that of e itself, so simplification is no part of the evidence; it is given exactly
;; if that of the residual is exact.
;; place : region where the point has to be.  Where simplification took signs for
;; granted, `positive?`, all integers are that may be.
;; -> witness value bound points; witness is #f if none was found.
(define (find-witness e residual place positive?)
  (define q (make-question e residual place))
  (define found (exact-witness q))
  (if found
      (values (listed-point found) (shown found) 0 0)
      (search q (all-tries (region-free? place) positive? (counts-in-turns? residual)))))

;; ---------------------------------------------------------------------------
;; Points where transcendental functions have exact values

;; -> finding or #f
(define (exact-witness q)
  (define-values (under only-under)
    (let-values ([(under only-under) (leaves-under-functions (question-residual q))])
      (values (all-0 under) (all-0 only-under))))
  (define more
    (if (eqv? (hash-count under) (hash-count only-under)) '() (list (integer-try 0 under))))
  (for/or ([t (in-list (list* (integer-try 0 only-under) (integer-try 1 only-under) more))])
    (define f (look q t (first-precision q)))
    (and (finding? f) (exactly-not-zero? f) f)))

(define (all-0 leaves) (for/hash ([leaf (in-hash-keys leaves)]) (values leaf 0)))

;; ---------------------------------------------------------------------------
;; Points with numbers for all leaves

(define (all-tries free? positive? in-turns?)
  (define (tries make count positive-count)
    (for/list ([k (in-range count)])
      (make (if (or positive? (< k positive-count)) k (- positive-count k 1)) #hash())))
  (define integers
    (tries integer-try (if free? point-limit point-limit/relations) positive-points))
  (define fractions (tries fraction-try fraction-points positive-fraction-points))
  (if in-turns?
      (append (take integers positive-points) fractions (drop integers positive-points))
      (append integers fractions)))

;; Has it a sine or the like of a multiple of π, or of a decimal, which may be one?  At
;; integers sin 2πt is 0.
(define (counts-in-turns? t)
  (and (for/or ([head (in-vector (tape-heads t))]) (memq head circular-functions))
       (for/or ([x (in-vector (tape-items t))]) (or (flonum? x) (pi-symbol? x)))))

;; zeros : ((try . finding) ...), the points that gave no decision, latest first
(define (search q tries)
  (let loop ([tries tries] [zeros '()])
    (cond
      [(or (null? tries) (= (length zeros) point-limit)) (look-elsewhere q (reverse zeros))]
      [else
       (define f (look-twice q (car tries)))
       (cond [(symbol? f) (loop (cdr tries) zeros)]
             [(witness? f) (as-witness q (car tries) f)]
             [(not-zero? (finding-of-e f)) (loop (cdr tries) zeros)]
             [else (loop (cdr tries) (cons (cons (car tries) f) zeros))])])))

(define (look-twice q t)
  (define f (look q t (first-precision q)))
  (if (eq? f 'unknown) (look q t second-precision) f))

;; zeros : the points that gave no decision.  They are looked at with more bits, then others.
(define (look-elsewhere q zeros)
  (define-values (witness value bound points) (look-again q zeros))
  (define found
    (and (not witness)
         (for/or ([t (in-list (further-tries (question-e q) (question-place q)))])
           (define f (look-twice q t))
           (and (finding? f) (witness? f) (cons t f)))))
  (if found (as-witness q (car found) (cdr found)) (values witness value bound points)))

;; The points that gave no decision, with more bits as long as these are of use.
(define (look-again q zeros)
  (define inexact (filter-not (lambda (z) (number? (finding-of-e (cdr z)))) zeros))
  (define open (if (and (pair? inexact) (constant? (question-e q))) (list (car inexact)) inexact))
  (define-values (found left) (with-more-bits q open))
  (if found
      (as-witness q (car found) (cdr found))
      (values #f 0 (apply max 0 (map bound left)) (length zeros))))

;; Without leaves, so that one point is like another?
(define (constant? t)
  (for/and ([x (in-vector (tape-items t))] [head (in-vector (tape-heads t))])
    (or (operation? head) (not (unknown? x)))))

(define (bound z) (value-bound (finding-of-e (cdr z))))

;; -> a try with its finding, or #f, and the others with their last findings
(define (with-more-bits q open)
  (define (work precision points)
    (* precision (length points) (tape-length (question-e q))))
  (let loop ([precisions (cons second-precision further-precisions)] [open open] [done '()])
    (cond [(or (null? open) (null? precisions) (not (question-certain? q))
               (> (work (car precisions) open) most-work))
           (values #f (append open done))]
          [else
           (define again
             (for/list ([z (in-list open)])
               (define f (look q (car z) (car precisions)))
               (if (finding? f) (cons (car z) f) z)))
           (define found (findf (lambda (z) (witness? (cdr z))) again))
           (define-values (next rest) (split-at again (min further-points (length again))))
           (if found
               (values found '())
               (loop (cdr precisions) next (append rest done)))])))

;; ---------------------------------------------------------------------------
;; Witnesses

;; With more bits, until enough digits are right.
(define (as-witness q t f)
  (define best
    (let loop ([f f] [precisions (cons second-precision further-precisions)])
      (define more?
        (and (question-certain? q) (pair? precisions) (not (value-precise? (finding-of-e f)))))
      (define g (and more? (look q t (car precisions))))
      (if (and more? (finding? g) (witness? g)) (loop g (cdr precisions)) f)))
  (values (listed-point best) (shown best) 0 0))
