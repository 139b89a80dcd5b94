#lang racket/base
;; In which angles a polynomial is written.
;;
;; Choosing between sin² and cos², and contracting products, finds most short
;; forms.  A sum left over of terms that agree in all but sines and
;; cosines is also written as waves (waves.rkt): so 16 cos⁵t - 20 cos³t + 6 cos t
;; is cos 5t + cos t, and sin²(θ - φ), spread over four terms in sines and
;; cosines of θ and φ, is found again.  The shorter form is kept.

(require racket/list
         "contract.rkt" "sine-or-cosine.rkt" (only-in "term.rkt" group-in-order) "waves.rkt"
         "../field/field.rkt"
         "../kernel/kernel.rkt")

(provide spell)

;; -> summands (field/field.rkt) whose sum equals p modulo the relations.
(define (spell F p)
  (define usual
    (contract-angles F (shortest-squares F p)
                     (lambda (a b sign) (field-combined-circle F (list (cons a 1) (cons b sign))))
                     (lambda (o) (field-doubled? F o))))
  (define circular (occurring-circles F p 1))
  (define hyperbolic (occurring-circles F p -1))
  (if (eq? (null? circular) (null? hyperbolic))
      usual             ; with both, groups that agree outside one kind may not be equal
      (spell-in-waves F p usual (append circular hyperbolic))))

;; ---------------------------------------------------------------------------
;; Groups of summands that agree outside the circles

(define (spell-in-waves F p spelled circles)
  (define inside?
    (if (eqv? 1 (circle-sign (car circles))) circular-kernel? hyperbolic-kernel?))
  ;; the same for summands that agree outside
  (define (key s)
    (sort (for/list ([p (in-list (cdr s))] #:unless (inside? (car p)))
            (cons (kernel-rank (car p)) (cdr p)))
          < #:key car))
  (define groups (group-in-order key spelled))
  (cond [(andmap lone? groups) spelled]
        [else
         (define written
           (for/hash ([g (in-list (group-in-order key (summands F p)))])
             (values (key (car g)) g)))
         (append*
          (for/list ([g (in-list groups)])
            (if (lone? g)
                g
                (shorter-spelling F g (hash-ref written (key (car g))) circles))))]))

(define (lone? group) (null? (cdr group)))

;; ---------------------------------------------------------------------------
;; One group

;; usual, written : summands, those of the polynomial and others equal to them
(define (shorter-spelling F usual written circles)
  (define active (filter (lambda (o) (varies? o written)) circles))
  (define circular? (eqv? 1 (circle-sign (car circles))))
  (define (size w) (wave-size w active))
  (define rest (unvarying written active))
  (define waves
    (and (<= (wave-bound written active) wave-limit)
         (power-waves (for/list ([s (in-list written)])
                        (cons (car s) (exponents-of s active)))
                      circular?)))
  (cond [(and waves (<= (length waves) (* 2 (length usual))))
         (define paired (pair-waves waves circular? size))
         (define constant (powers-size rest))
         (if (shorter? (length paired)
                       (for/sum ([w (in-list paired)]) (+ 1 constant (size w)))
                       (length usual)
                       (for/sum ([s (in-list usual)])
                         (+ 1 (amplitude-size (car s)) (powers-size (cdr s)))))
             (for/list ([w (in-list paired)]) (wave->summand F w active rest))
             usual)]
        [else usual]))

;; Is the sum of n terms with this size to be preferred to the usual one?
(define (shorter? n size usual-n usual-size)
  (and (< size usual-size)
       (or (< n usual-n)
           (and (= n usual-n) (<= (* 6 size) (* 5 usual-size))))))

(define (powers-size powers)
  (for/sum ([p (in-list powers)])
    (+ 1 (kernel-size (car p)) (if (eqv? 1 (cdr p)) 0 2))))

;; Products of more exponentials than this are left alone.
(define wave-limit 4000)

(define (wave-bound written active)
  (for/sum ([s (in-list written)])
    (for/product ([e (in-list (exponents-of s active))]) (+ 1 (car e) (cdr e)))))

;; ((cosine-exponent . sine-exponent) ...)
(define (exponents-of s circles)
  (for/list ([o (in-list circles)])
    (cons (exponent-of (circle-cosine o) s) (exponent-of (circle-sine o) s))))

(define (exponent-of k s)
  (define p (assq k (cdr s)))
  (if p (cdr p) 0))

;; Do the exponents of the circle's functions differ among the summands?
(define (varies? o summands)
  (define (exponents s) (exponents-of s (list o)))
  (> (length (remove-duplicates (map exponents summands))) 1))

;; The powers that all summands share: those of no active circle.
(define (unvarying written active)
  (define kernels (append (map circle-sine active) (map circle-cosine active)))
  (filter-not (lambda (p) (memq (car p) kernels)) (cdar written)))

(define (wave->summand F w circles rest)
  (for/fold ([c (wave-amplitude w)] [powers rest] #:result (cons c powers))
            ([f (in-list (wave-factors w))])
    (define circle+sign
      (field-combined-circle F (for/list ([o (in-list circles)] [k (in-list (cdr f))]
                                          #:unless (eqv? k 0))
                                 (cons o k))))
    (define sine? (eq? (car f) 'sine))
    (values (if sine? (* c (cdr circle+sign)) c)
            (cons (cons ((if sine? circle-sine circle-cosine) (car circle+sign)) 1) powers))))
