#lang racket/base
;; Verdicts on questions of several kinds, and values of integrals, judged.
;;
;; The matter of a question is what it is about as S-expressions:
;;
;;     (integral f low high by claim)       of f by x; its derivative by a symbol, unless by is #f;
;;                                          claimed to be an expression, or #f
;;     (equivalent L1 L2 qs vs)             have they the same motions?
;;     (conserved L Q qs vs)                is Q conserved?
;;     (smooth (e numbers variables) ...)   has e a value at the numbers, or values beside them that
;;                                          stay bounded, and no jump or kink?
;;     (domain e ...)                       have all of them values at one point?
;;     (found V)                            has V a value at each equilibrium that was found?

(require "equations.rkt" "fault.rkt" "integral.rkt" "judge.rkt" "number.rkt" "refutation.rkt"
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
;; Jumps and kinks

(define step (expt 2 -40))
(define least 1/1000)

;; A place where another part of the question has no value, and is not bounded, is outside of it.
(define (valued? entry)
  (or (rational? ((along-line entry) 0)) (bounded? (along-line entry))))

;; Is the value 2⁻²⁰ away the same as 2⁻⁴⁰ away, or nearly, on both sides?
(define (bounded? value)
  (define (apart k) (let ([far (value (* k (expt 2 20)))] [near (value k)])
                      (if (and (rational? far) (rational? near)) (abs (- far near)) 1)))
  (and (< (apart 1) 1) (< (apart -1) 1)))

;; entry : (e ((symbol . number) ...) (variable ...))
;; -> k -> the value k steps away from the point, on a line through it
(define (along-line entry)
  (define numbers (make-immutable-hasheq (cadr entry)))
  (define direction (for/list ([_ (in-list (caddr entry))]) (pick '(1 -2 1/2 3/5))))
  (lambda (k)
    (number-at (car entry)
               (shifted numbers (for/list ([s (in-list (caddr entry))] [d (in-list direction)])
                                  (cons s (* k step d)))))))

;; On a line through the point the value jumps, or turns; else #f.  Two lines, as one may lie
;; in the surface.
(define (rough entry)
  (for/or ([_ (in-range 2)])
    (define value (along-line entry))
    (define-values (before here after) (values (value -1) (value 0) (value 1)))
    (and (andmap rational? (list before after))
         (or (> (abs (- after before)) least)
             (and (rational? here)
                  (or (> (abs (- before here)) least)
                      (> (abs (/ (- (+ before after) (* 2 here)) step)) least))))
         (fault 'not-smooth (make-immutable-hasheq (cadr entry)) before after))))

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
