#lang racket/base
;; Adding relations to a set of assumptions.
;;
;; A relation on an expression narrows down the signs that its parts may
;; have: m r > 0 and m > 0 give r > 0; v < c and v > 0 give c > 0.  All relations
;; are imposed again and again until the table of signs does not change; it only
;; gets narrower, so this ends, and the order of the relations makes no difference.
;; An expression that is left without a possible sign is a contradiction.

(require "assumption-set.rkt" "range.rkt" "signs.rkt"
         "../expression/simplifier.rkt")

(provide add-relations raise-contradiction (struct-out exn:algebra:contradiction))

;; The relations with these datums cannot all hold.
(struct exn:algebra:contradiction exn:fail (because))

;; Raises a contradiction if they cannot hold with those that are there.
(define (add-relations A new s)
  (define relations (append (assumptions-relations A) new))
  (define sums
    (append (assumptions-sums A)
            (for*/list ([r (in-list new)] #:unless (number? (relation-expression r))
                        [ts (in-value (key-of (simplifier-terms s (relation-expression r))))]
                        #:when (pair? (cdr ts)))
              ts)))
  (define (with-table table)
    (struct-copy assumptions A [relations relations] [table table] [sums sums]))
  (define (impose table r)
    (narrow (with-table table) s
            (relation-expression r)
            (known (relation-signs r) (list (relation-datum r)))))
  (let loop ([table (assumptions-table A)])
    (define next (for/fold ([table table]) ([r (in-list relations)]) (impose table r)))
    (if (equal? next table) (with-table table) (loop next))))

(define (raise-contradiction because)
  (raise (exn:algebra:contradiction "contradiction" (current-continuation-marks) because)))

(define (key-of terms)
  (define-values (key c) (normalized terms))
  key)

;; e has these signs: -> the table with that, and the consequences for its parts.
(define (narrow A s e k)
  (define now (meet (meet (infer-signs A s e) (by-range e)) k))
  (when (eqv? 0 (known-signs now))
    (raise-contradiction (known-because now)))
  (if (number? e)
      (assumptions-table A)
      (narrow-parts A s e now)))

;; cos x is not greater than 2.
(define (by-range e) (if (plainly-real? e) (known (range-signs e) '()) unknown))

(define (narrow-parts A s e k)
  (define ts (simplifier-terms s e))
  (define table (record (assumptions-table A) ts k))
  (define-values (number parts) (simplifier-irreducible-factors s e))
  (if (and (eqv? 1 number) (single? parts))
      (narrow-terms A s table ts k)
      (narrow-factors A s table number parts k)))

(define (record table terms k)
  (define-values (key c) (normalized terms))
  (hash-update table key (lambda (old) (meet old (scaled c k))) unknown))

(define (narrow-factors A s table number parts k)
  (define signs
    (for/list ([p (in-list parts)])
      (known-power (infer-signs A s (car p)) (cdr p))))
  (for/fold ([table table]) ([p (in-list parts)] [i (in-naturals)])
    (define others (scaled number (known-product (without signs i))))
    (narrow (struct-copy assumptions A [table table]) s (car p)
            (derive (lambda (s o) (factor-signs s (cdr p) o)) k others))))

(define (narrow-terms A s table ts k)
  (define signs
    (for/list ([t (in-list ts)]) (scaled (car t) (infer-signs A s (cdr t)))))
  (for/fold ([table table]) ([t (in-list ts)] [i (in-naturals)]
                             #:unless (or (null? (cdr ts)) (number? (cdr t))))
    (define own (derive term-signs k (known-sum (without signs i))))
    (narrow (struct-copy assumptions A [table table]) s (cdr t) (scaled (car t) own))))

(define (without xs i)
  (for/list ([x (in-list xs)] [j (in-naturals)] #:unless (eqv? i j)) x))
