#lang racket/base
;; Grouping the terms of a sum by shared factors.
;;
;; In ½ m v² + ½ m w² - ½ m ω² x² - ½ m ω² y² the last two share most, then the
;; first two: so ½ m (v² + w²) - ½ m ω² (x² + y²).  The pair of terms with the
;; heaviest common factor is looked for; all terms with that factor become one
;; product with a sum in it, if that is enough smaller; and so on.  A group is not
;; grouped again, ω (ω (x + y) + z), unless it is a sum that is shared.

(require racket/list
         "term.rkt"
         "../kernel/kernel.rkt")

(provide group-by-kernels group-by-factors)

;; Both take a sum and give a sum, with the help of
;; sum->term : terms -> one term equal to their sum,
;; better? : terms, the product they can be, the sum in it -> is that to be preferred?

;; ---------------------------------------------------------------------------
;; Terms that agree in everything but symbols

;; Terms with equal kernels become one term, a product with a sum in the symbols.
(define (group-by-kernels terms sum->term better?)
  (append*
   (for/list ([group (in-list (group-in-order kernel-part terms))])
     (if (or (null? (cdr group)) (null? (kernel-part (car group))))
         group
         (factored-if-better group sum->term better?)))))

(define (kernel-part t)
  (for/list ([p (in-list (term-powers t))] #:unless (symbol? (kernel-expression (car p))))
    (cons (kernel-rank (car p)) (cdr p))))

;; The sum, or one term with its content in front.
(define (factored-if-better terms sum->term better?)
  (define-values (c powers core) (extract-content terms #t))
  (define sum (sum->term core))
  (define product
    (make-term (* c (term-coefficient sum)) (append (term-powers sum) powers)))
  (if (better? terms product core) (list product) terms))

;; ---------------------------------------------------------------------------
;; Terms with a heavy factor in common

;; A factor lighter than this is not worth a parenthesis.
(define least-weight 2)

;; Longer sums are left alone.
(define limit 24)

;; weight : kernel exponent -> number, of a power that terms share
(define (group-by-factors terms weight sum->term better?)
  (if (> (length terms) limit)
      terms
      (let regroup ([terms terms] [made '()] [tried '()])
        (let try ([pairs (heavy-pairs terms weight)] [tried tried])
          (define factor (and (pair? pairs) (apply shared-factor (car pairs))))
          (cond [(not factor) terms]
                [(or (member-factor? factor tried)
                     (not (or (has-sum? factor) (unmade? (car pairs) made))))
                 (try (cdr pairs) tried)]
                [else
                 (define group
                   (filter (lambda (t)
                             (and (has-factor? t factor)
                                  (or (has-sum? factor) (not (memq t made)))))
                           terms))
                 (define new (factored-if-better group sum->term better?))
                 (if (eq? new group)
                     (try (cdr pairs) (cons factor tried))
                     (regroup (append new (remq* group terms))
                              (append new made)
                              tried))])))))

;; The pairs of terms whose common factor is heavy enough, the heaviest first.
(define (heavy-pairs terms weight)
  (define weighed
    (for*/list ([rest (in-list (in-tails terms))]
                [b (in-list (cdr rest))]
                [w (in-value (shared-weight (car rest) b weight))]
                #:when (>= w least-weight))
      (cons w (list (car rest) b))))
  (map cdr (sort weighed > #:key car)))

(define (unmade? pair made) (not (ormap (lambda (t) (memq t made)) pair)))

;; The weight of the part shared by two terms.  Of x² and x y nothing counts: the
;; square is worth more than the factor x.
(define (shared-weight a b weight)
  (let loop ([as (term-powers a)] [bs (term-powers b)]
             [sum (if (eqv? 1 (shared-number a b)) 0 1)])
    (cond [(or (null? as) (null? bs)) sum]
          [else
           (define i (kernel-place (caar as)))
           (define j (kernel-place (caar bs)))
           (cond [(< i j) (loop (cdr as) bs sum)]
                 [(> i j) (loop as (cdr bs) sum)]
                 [(eqv? (cdar as) (cdar bs))
                  (loop (cdr as) (cdr bs) (+ sum (weight (caar as) (cdar as))))]
                 [else (loop (cdr as) (cdr bs) sum)])])))

(define (shared-factor a b)
  (term (shared-number a b) (common-powers (term-powers a) (term-powers b) #t)))

(define (member-factor? f factors)
  (for/or ([g (in-list factors)])
    (and (= (term-coefficient f) (term-coefficient g))
         (equal? (term-powers f) (term-powers g)))))

(define (has-sum? t) (ormap sum-kernel? (map car (term-powers t))))

;; The number of two terms that differ in sign at most, else 1.
(define (shared-number a b)
  (define c (abs (term-coefficient a)))
  (if (= c (abs (term-coefficient b))) c 1))

(define (has-factor? t factor)
  (and (or (eqv? 1 (term-coefficient factor))
           (= (abs (term-coefficient t)) (term-coefficient factor)))
       (for/and ([p (in-list (term-powers factor))])
         (define q (assq (car p) (term-powers t)))
         (and q (eqv? (cdr p) (nearer-to-zero (cdr p) (cdr q)))))))
