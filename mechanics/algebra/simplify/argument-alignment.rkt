#lang racket/base
;; Arguments that are equal though they are written differently.
;;
;; A function applied is known by its argument as that is presented, and the kernels
;; that an argument is written in depend on its parts: sin 2a and 2 sin a cos a,
;; each by itself, are written in the angles 2a and a.  So the arguments of all
;; functions are looked at together: in the field of all their kernels those that are
;; equal have one value.  Mostly every argument has the kernels there that it has by
;; itself, and nothing is to be done.  Otherwise
;;
;; - the function of an argument is that of the least of those that are equal;
;; - the argument of an exponential, angle, root or logarithm, whose terms and
;;   factors count, is written in the kernels of all.

(require "normalize.rkt"
         "../expression/expression.rkt" "../expression/operation.rkt"
         "../expression/simplifier.rkt" "../expression/substitute.rkt"
         "../field/field.rkt" "../field/work-bounds.rkt"
         "../kernel/find-kernels.rkt" "../kernel/kernel.rkt"
         "../polynomial/fraction.rkt" "../polynomial/polynomial.rkt")

(provide align make-involved? least-expression)

;; s : simplifier
;; involved? : does a function occur in an expression? (make-involved?)
;; alone : expression -> the kernels of its field, a vector
;; -> an expression equal to e
(define (align e s involved? alone)
  (define (align-all es) (node-args (align (make-node op:+ es) s involved? alone)))
  (define arguments (involved-arguments e involved?))
  (define table
    (and (> (length arguments) 1) (spellings arguments (align-all arguments) s alone)))
  (if table (respell e table) e))

(define (least-expression es)
  (for/fold ([best (car es)]) ([e (in-list (cdr es))])
    (if (shorter-expression? e best) e best)))

;; ---------------------------------------------------------------------------
;; Arguments

(define by-parts (append (list op:exp op:log op:sqrt op:expt op:abs) functions-of-angles))

;; A node whose operands are no arguments.
(define (transparent? n) (or (arithmetic-node? n) (memq (node-head n) (list op:up op:down))))

;; The arguments, each once, in which functions occur: others have one form.
(define (involved-arguments e involved?)
  (define seen (make-hasheq))
  (define met (make-hash))
  (let visit ([e e] [argument? #f])
    (cond [(not (node? e)) (void)]
          [(and argument? (not (memq (node-head e) (list op:up op:down))))
           (when (involved? e) (hash-ref! met e (lambda () (hash-count met))))]
          [(not (hash-ref seen e #f))
           (hash-set! seen e #t)
           (for ([a (in-list (node-args e))])
             (visit a (or argument? (not (transparent? e)))))]))
  (map car (sort (hash->list met) < #:key cdr)))

;; -> expression -> does a function other than an unknown one of symbols occur in it?
(define (make-involved?)
  (define memo (make-memo))
  (define (involved? e)
    (and (node? e)
         (memo e (lambda ()
                   (or (and (memq (node-head e) by-parts) (not (transparent? e)))
                       (ormap involved? (node-args e)))))))
  involved?)

;; e with its arguments as (table argument parts?) has them.
(define (respell e table)
  (define memo (make-memo))
  (define (walk e) (if (node? e) (memo e (lambda () (walk-node e))) e))
  (define (walk-node n)
    (define parts? (and (memq (node-head n) by-parts) #t))
    (rebuilt n (if (transparent? n) walk (lambda (a) (argument a parts?)))))
  (define (argument a parts?)
    (cond [(not (node? a)) a]
          [(memq (node-head a) (list op:up op:down))
           (rebuilt a (lambda (b) (argument b parts?)))]
          [else (table a parts?)]))
  (walk e))

(define (rebuilt n f) (with-operands n (map f (node-args n))))

;; ---------------------------------------------------------------------------
;; Spellings

;; inner : the arguments, those of their own functions aligned.
;; -> argument parts? -> expression; or #f if all may stay as they are
(define (spellings arguments inner s alone)
  (define atlas (collect-kernels (make-node op:+ inner) s))
  (define own (map alone inner))
  (define-values (F fractions)
    (if (comparable? atlas own)
        (values #f #f)
        (call-nested (simplifier-fuel s) (lambda () (values-together atlas inner)))))
  (cond [F (table-of arguments (spell-by-parts F inner fractions own)
                     (spell-by-wholes F inner fractions s))]
        [(andmap eq? arguments inner) #f]
        [else (table-of arguments inner inner)]))

(define (table-of arguments by-parts wholes)
  (define table
    (for/hash ([a (in-list arguments)] [p (in-list by-parts)] [w (in-list wholes)])
      (values a (cons p w))))
  (lambda (a parts?)
    (define entry (hash-ref table a #f))
    (cond [(not entry) a]
          [parts? (car entry)]
          [else (cdr entry)])))

;; Has each argument by itself kernels that all together have, without roots that may
;; depend on each other?
(define (comparable? atlas own)
  (define known (kernel-expressions (atlas-kernels atlas)))
  (and (<= (length (atlas-tower atlas)) 1)
       (for*/and ([kernels (in-list own)] [k (in-vector kernels)])
         (hash-ref known (kernel-expression k) #f))))

;; The arguments; one whose value has kernels other than its own is written in those of all.
(define (spell-by-parts F arguments fractions own)
  (for/list ([a (in-list arguments)] [f (in-list fractions)] [kernels (in-list own)])
    (define known (kernel-expressions kernels))
    (if (for/and ([k (in-list (fraction-kernels F f))])
          (hash-ref known (kernel-expression k) #f))
        a
        (fraction->expression F f))))

(define (fraction-kernels F f)
  (define factors (map power-base (fraction-denominator-factors f)))
  (for*/list ([p (in-list (cons (fraction-numerator f) factors))]
              [i (in-list (poly-variables (field-ring F) p))])
    (field-kernel F i)))

(define (fraction->expression F f)
  (e:/ (poly->expression F (fraction-numerator f))
       (product-of-powers (fraction-denominator-factors f) (lambda (p) (poly->expression F p)))))

(define (poly->expression F p)
  (rebuild op:+ (for/list ([s (in-list (summands F p))])
                  (e:* (car s) (product-of-powers (cdr s) kernel-expression)))))

(define (product-of-powers powers base->expression)
  (rebuild op:* (for/list ([h (in-list powers)])
                  (e:expt (base->expression (power-base h)) (power-exponent h)))))

;; The least of those that are equal, simplified by itself.
(define (spell-by-wholes F arguments fractions s)
  (define R (field-ring F))
  (define (simplified e) (simplifier-simplify s e))
  (define groups (make-hasheqv))        ; hash -> ((fraction . argument) ...)
  (for ([f (in-list fractions)] [a (in-list arguments)])
    (hash-update! groups (fraction-hash R f) (lambda (group) (cons (cons f a) group)) '()))
  (for/list ([f (in-list fractions)] [a (in-list arguments)])
    (define equals
      (for/list ([g (in-list (hash-ref groups (fraction-hash R f)))]
                 #:when (fraction=? R f (car g)))
        (cdr g)))
    (if (null? (cdr equals)) a (least-expression (map simplified equals)))))
