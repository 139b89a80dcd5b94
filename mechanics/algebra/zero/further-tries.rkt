#lang racket/base
;; Further points, where all of the usual ones gave zero: |x² − 1| is x² − 1 at every integer.
;;
;; One leaf after another runs through small fractions of both signs, large numbers, and numbers
;; just within the bounds declared, while the others keep theirs.  Then come points between the
;; kinks: arguments of |·|, sgn, roots and logarithms are solved for one symbol, and it is
;; given a number between any two zeros, and one beyond them.

(require racket/list
         "region.rkt" "trial-point.rkt"
         (only-in "../assumption/assumption-set.rkt" no-assumptions with-automatic-assumptions)
         "../expression/constant-value.rkt" "../expression/expression.rkt"
         "../expression/flat-graph.rkt" "../expression/operation.rkt" "../expression/size.rkt"
         "../expression/substitute.rkt" "../expression/symbols.rkt"
         "../solve/solve-equations.rkt"
         "../../error/refusal.rkt")

(provide further-tries)

;; t : tape; place : region -> tries; none for a long tape
(define (further-tries t place)
  (define leaves (filter unknown? (vector->list (tape-items t))))
  (define all
    (if (> (tape-length t) longest)
        '()
        (append (sweeps (limited leaves) place) (tries-between-kinks t (filter symbol? leaves)))))
  (take all (min (length all) (quotient most-work (tape-length t)))))

(define longest 300)
(define most-work 20000)
(define (limited leaves) (take leaves (min 4 (length leaves))))

(define bases
  (list (integer-try 2 #hash()) (fraction-try 10 #hash()) (integer-try -3 #hash())))

;; ---------------------------------------------------------------------------
;; One leaf after another

(define numbers
  (list -1/2 1/2 -3/2 3/2 -2 -1/10 1/1000 -1/1000 -30 1000 -1000 (expt 10 7) (- (expt 10 7))))

(define (sweeps leaves place)
  (for*/list ([base (in-list bases)]
              [leaf (in-list leaves)]
              [x (in-list (append (region-borders place leaf) numbers))])
    (placed-try base leaf x)))

;; ---------------------------------------------------------------------------
;; Between kinks

(define with-kinks (list op:abs op:sgn op:sqrt op:log))

(define (tries-between-kinks t symbols)
  (define us
    (remove-duplicates
     (for/list ([n (in-vector (tape-items t))]
                #:when (and (node? n) (memq (node-head n) with-kinks))
                #:when (< (expression-size n) longest-solved))
       (car (node-args n)))))
  (for*/list ([x (in-list (limited symbols))]
              [others (in-value (for/list ([s (in-list (remq x symbols))] [n (in-naturals)])
                                  (cons s (+ 1 (/ 1 (+ 2 n))))))]
              [value (in-list (between (append-map (lambda (u) (zeros-of u x others)) us)))])
    (for/fold ([t (placed-try (car bases) x value)]) ([other (in-list others)])
      (placed-try t (car other) (cdr other)))))

(define longest-solved 60)

;; -> flonums
(define (zeros-of u x others)
  (define found
    (and (occurs? x u)
         (if-raised refusal? #f
           (solve-equations (list (substitute-expression u others)) (list x)
                            (with-automatic-assumptions no-assumptions #f)))))
  (for*/list ([s (in-list (or found '()))]
              [entry (in-list (car s))]
              [value (in-value (if (real? (cdr entry))
                                   (exact->inexact (cdr entry))
                                   (constant-value (cdr entry))))]
              #:when (rational? value))
    value))

;; Simple numbers between any two, and beyond all
(define (between values)
  (define places (sort (remove-duplicates values) <))
  (if (null? places)
      '()
      (append (list (- (floor (inexact->exact (first places))) 1)
                    (+ (floor (inexact->exact (last places))) 1))
              (for/list ([a (in-list places)] [b (in-list (cdr places))])
                (rationalize (inexact->exact (/ (+ a b) 2)) (inexact->exact (/ (- b a) 4)))))))
