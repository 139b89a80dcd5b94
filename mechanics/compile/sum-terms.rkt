#lang racket/base
;; Sums of products, of which programs are made anew.
;;
;; A *sum* is a list of terms, a *term* a number times a *monomial*, and a monomial the ascending
;; list of its factors' ids, () being 1.  A *factor* is
;;
;;     (input k)                   an input
;;     (constant c)                a number that is no coefficient
;;     (sum term ...)              a sum that is multiplied, or used more than once
;;     (inverse term ...)          1 over a sum of one term
;;     (operation name sum ...)    any other operation
;;     (component k sum)           of the solution of a system
;;
;; each once.  Terms keep the order in which they were added.

(provide coefficient monomial unit?
         make-factors factor-of intern! known sums-of map-sums
         plus plus-term negative scaled term-of replaced
         with-factor without monomial<?)

(define coefficient car)
(define monomial cdr)
(define (unit? t) (= 1.0 (abs (coefficient t))))

;; ---------------------------------------------------------------------------
;; Factors

;; ids : key -> id; items : id -> factor
(struct factors (ids items) #:authentic)
(define (make-factors) (factors (make-hash) (make-hasheqv)))

(define (factor-of f id) (hash-ref (factors-items f) id))

;; The id of a factor, or #f
(define (known f factor) (hash-ref (factors-ids f) factor #f))

;; The id of a factor; key : of all that are the same
(define (intern! f factor [key factor])
  (define ids (factors-ids f))
  (or (hash-ref ids key #f)
      (let ([id (hash-count ids)])
        (hash-set! ids key id)
        (hash-set! (factors-items f) id factor)
        id)))

;; The sums that a factor is made of.
(define (sums-of factor)
  (case (car factor)
    [(sum inverse) (list (cdr factor))]
    [(operation component) (cddr factor)]
    [else '()]))

;; The factor with other sums in place of these.
(define (map-sums change factor)
  (case (car factor)
    [(sum inverse) (cons (car factor) (change (cdr factor)))]
    [(operation component) (list* (car factor) (cadr factor) (map change (cddr factor)))]
    [else factor]))

;; ---------------------------------------------------------------------------
;; Terms

(define (plus s more)
  (for/fold ([s s]) ([t (in-list more)]) (plus-term s t)))

(define (plus-term s t)
  (define old (term-of s (monomial t)))
  (if old
      (replaced s old (+ (coefficient old) (coefficient t)))
      (append s (list t))))

(define (term-of s m)
  (for/first ([t (in-list s)] #:when (equal? m (monomial t))) t))

;; With another coefficient for that of the term; without it, if that is 0.
(define (replaced s term c)
  (if (zero? c)
      (remq term s)
      (for/list ([t (in-list s)]) (if (eq? t term) (cons c (monomial t)) t))))

(define (negative s) (scaled -1.0 s))

(define (scaled c s)
  (for/list ([t (in-list s)]) (cons (* c (coefficient t)) (monomial t))))

;; ---------------------------------------------------------------------------
;; Monomials

(define (with-factor id m)
  (if (or (null? m) (<= id (car m))) (cons id m) (cons (car m) (with-factor id (cdr m)))))
(define (without id m) (remv id m))

(define (monomial<? m n)
  (define difference (for/first ([i (in-list m)] [j (in-list n)] #:unless (= i j)) (- i j)))
  (if difference (< difference 0) (< (length m) (length n))))
