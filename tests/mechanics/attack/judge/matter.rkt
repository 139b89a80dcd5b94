#lang racket/base
;; Verdicts on questions of several kinds, and values of integrals, judged.
;;
;; The matter of a question is what it is about as S-expressions:
;;
;;     (integral f low high by claim)       of f by x; its derivative by a symbol, unless by is #f;
;;                                          claimed to be an expression, or #f
;;     (equivalent L1 L2 qs vs)             have they the same motions?
;;     (conserved L Q qs vs)                is Q conserved?
;;     (smooth (e numbers variables) ...)   has e a value at the numbers, and no jump or kink?
;;     (domain e ...)                       have all of them values at one point?
;;     (found V)                            has V a value at each equilibrium that was found?

(require "equations.rkt" "fault.rkt" "flonum.rkt" "judge.rkt"
         "point.rkt" "quadrature.rkt" "refutation.rkt" "relation.rkt" "witness.rkt"
         "../statement.rkt")

(provide judge-matter)

;; status : 'proved, 'refuted, 'found or 'undecided; found : a datum, where there is one
;; -> #f, 'unjudged or a fault
(define (judge-matter matter status assumed witness found)
  (define parts (cdr matter))
  (case (and (not (eq? status 'undecided)) (car matter))
    [(integral) (judge-integral parts status assumed witness found)]
    [(equivalent conserved) (judge-motions (car matter) parts status assumed witness)]
    [(smooth) (and (eq? status 'proved) (andmap valued? parts) (ormap rough parts))]
    [(domain) (judge-domain `(+ ,@parts) status assumed witness)]
    [(found) (ormap (lambda (entry)
                      (define e (substituted (car parts) 'x (car entry)))
                      (proof-fault e (append (cadr entry) assumed)))
                    found)]
    [else #f]))

;; ---------------------------------------------------------------------------
;; Points

(define tries 120)

;; On both sides of every condition: small numbers, often 0 and equal ones.
(define (small-numbers symbols)
  (define few (pick '((0 1 2 -1) (1 2 1/2 -1 -2 -1/2 3 1/3 -5/2 3/2 -3))))
  (for/hasheq ([s (in-list symbols)]) (values s (pick few))))

;; judge : numbers -> #t where all is right, a fault, or #f where it cannot tell
;; enough : points at which all is right
(define (judged-at-points symbols assumed draw enough judge)
  (let loop ([k 0] [right 0])
    (define numbers (draw symbols))
    (define held? (all-hold? assumed (make-point numbers 0) flonum-intervals))
    (define v (and held? (judge numbers)))
    (cond [(fault? v) v]
          [(= right enough) #f]
          [(= k tries) (if (zero? right) 'unjudged #f)]
          [else (loop (+ k 1) (if v (+ right 1) right))])))

;; A refutation is right if it is so for one choice of numbers its witness does not name.
(define (judged-at-witness symbols witness draw judge)
  (define named (witness-numbers (or witness '())))
  (define verdicts
    (for/list ([_ (in-range 6)])
      (judge (for/fold ([all (draw symbols)]) ([(s x) (in-hash named)]) (hash-set all s x)))))
  (cond [(memq #t verdicts) #f]
        [(memq #f verdicts) 'unjudged]
        [else (car verdicts)]))

;; ---------------------------------------------------------------------------
;; Integrals

(define (judge-integral parts status assumed witness found)
  (define-values (e low high by claim) (apply values parts))
  (define symbols (remq 'x (symbols-of e low high (or by 0) (or claim 0) (or found 0))))
  (case status
    [(refuted)
     (judged-at-witness symbols witness small-numbers
                        (lambda (numbers)
                          (define v (compared e low high #f claim #f numbers))
                          (cond [(eq? v #t) (fault 'no-difference-at-witness numbers #f #f)]
                                [(not (fault? v)) v]
                                [(eq? 'values-differ (fault-kind v)) #t]
                                [else (fault 'no-value-at-witness numbers #f #f)])))]
    [else
     (judged-at-points symbols assumed small-numbers 8
                       (lambda (numbers)
                         (compared e low high by (or found claim) (and found #t) numbers)))]))

;; The integral and an expression: #t where they are equal, #f where that is not known
;; must? : must the expression have a value where the integral has?
(define (compared e low high by formula must? numbers)
  (define-values (left right) (values (quadrature e low high by numbers)
                                      (number-at formula numbers)))
  (define (wrong kind) (fault kind numbers (and (rational? left) left)
                              (and (rational? right) right)))
  (cond [(and (eq? left 'infinite) (rational? right)) (wrong 'no-integral)]
        [(not (rational? left)) #f]
        [(eq? right 'none) (and must? (wrong 'result-nowhere-defined))]
        [(not right) #f]
        [(> (abs (- left right)) (* 1e-12 (+ 1 (abs left)))) (wrong 'values-differ)]
        [else #t]))

(define (quadrature e low high by numbers)
  (define (at step)
    (integral-value e low high (if by (hash-update numbers by (lambda (x) (+ x step))) numbers)))
  (define h (expt 2 -40))
  (define-values (here before after)
    (values (at 0) (and by (at (- h))) (and by (at h))))
  (cond [(not by) here]
        [(andmap rational? (list before here after))
         ;; where the derivative jumps, nothing is to be judged
         (and (< (abs (- (+ before after) (* 2 here))) (* h 1e-6)) (/ (- after before) (* 2 h)))]
        [else (and (not (rational? here)) here)]))

;; ---------------------------------------------------------------------------
;; Motions

;; Parameters are small numbers, states are generic ones.
(define ((draw-state state) symbols)
  (for/fold ([n (small-numbers symbols)]) ([s (in-list state)])
    (hash-set n s (/ (+ 1 (random 40)) (+ 7 (random 20))))))

(define (judge-motions question parts status assumed witness)
  (define-values (L other qs vs) (apply values parts))
  (define state (cons 't (append qs vs)))
  (define symbols (symbols-of L other (cons '+ state)))
  ;; -> are the same, or is conserved; 'open
  (define (holds? numbers)
    (define rows (motion-rows L qs vs numbers))
    (define other-rows
      ((if (eq? question 'equivalent) motion-rows (lambda (Q . more) (apply rate-row Q more)))
       other qs vs numbers))
    (cond [(not (and rows other-rows)) 'open]
          [(eq? question 'equivalent)
           (if (ormap consistent? (list rows other-rows)) (same-motions? rows other-rows) 'open)]
          [(consistent? rows) (follows? other-rows rows)]
          [else 'open]))
  (define ((judge wanted kind) numbers)
    (define v (holds? numbers))
    (cond [(eq? v 'open) #f] [(eq? v wanted) #t] [else (fault kind numbers #f #f)]))
  (if (eq? status 'proved)
      (judged-at-points symbols assumed (draw-state state) 30 (judge #t 'motions-differ))
      (judged-at-witness symbols witness (draw-state state)
                         (judge #f 'no-difference-at-witness))))

;; ---------------------------------------------------------------------------
;; Jumps and kinks

(define step (expt 2 -40))
(define least 1/1000)

;; A place where another part of the question has no value is outside of it.
(define (valued? entry) (rational? (number-at (car entry) (make-immutable-hasheq (cadr entry)))))

;; entry : (e ((symbol . number) ...) (variable ...))
;; On a line through the point the value jumps, or turns; else #f.  Two lines, as one may lie
;; in the surface.
(define (rough entry)
  (define numbers (make-immutable-hasheq (cadr entry)))
  (for/or ([_ (in-range 2)])
    (define direction (for/list ([s (in-list (caddr entry))]) (cons s (pick '(1 -2 1/2 3/5)))))
    (define (value k)
      (number-at (car entry)
                 (for/fold ([n numbers]) ([d (in-list direction)])
                   (hash-update n (car d) (lambda (x) (+ x (* k step (cdr d))))))))
    (define-values (before here after) (values (value -1) (value 0) (value 1)))
    (and (andmap rational? (list before here after))
         (or (> (abs (- after here)) least)
             (> (abs (- before here)) least)
             (> (abs (/ (- (+ before after) (* 2 here)) step)) least))
         (fault 'not-smooth numbers before after))))

;; ---------------------------------------------------------------------------
;; Domains

(define (proof-fault e assumed)
  (define v (judge-proof e e '() assumed '()))
  (and (fault? v) v))

;; e : the sum of all that must have a value
(define (judge-domain e status assumed witness)
  (or (proof-fault e (if (eq? status 'proved) assumed '()))
      (and (eq? status 'refuted)
           (let ([v (judge-refutation e `(+ 1 ,e) '() '() (or witness '()))])
             (and (fault? v) (eq? 'no-value-at-witness (fault-kind v)) v)))))
