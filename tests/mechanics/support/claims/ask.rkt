#lang racket/base
;; Claims as data, asked of the library: rows of `identities` and `integrals` become verdicts.
;;
;; A datum is built by the library's own operations, as a reader's program would build it.

(require racket/list
         mechanics
         "identities.rkt" "integrals.rkt" "motions.rkt")

(provide (struct-out claim) claims)

;; title, and procedures that make the verdicts on what is true and on its false neighbour
(struct claim (kind title true false))

(define operations
  (hasheq '+ + '- - '* * '/ / 'square square 'cube cube 'expt expt 'sqrt sqrt 'exp exp 'log log
          'sin sin 'cos cos 'tan tan 'asin asin 'acos acos 'atan atan
          'sinh sinh 'cosh cosh 'tanh tanh 'asinh asinh 'acosh acosh 'atanh atanh
          'abs abs 'sgn sgn 'max max 'min min 'erf erf))

;; A value of the library; the letter x is `at`.  Of constants that hold no letter, as
;; (sqrt 3), the exact value is read.
(define (build datum [at 'x])
  (let build ([d datum])
    (cond [(and (pair? d) (null? (letters d))) (read-expression d)]
          [(pair? d) (apply (hash-ref operations (car d)) (map build (cdr d)))]
          [(eq? d 'x) at]
          [else d])))

;; The symbols of d that are no operations
(define (letters d)
  (cond [(pair? d) (append-map letters (cdr d))]
        [(symbol? d) (if (eq? d ':pi) '() (list d))]
        [else '()]))

(define (under conditions thunk)
  (assuming-all conditions thunk))

;; A condition of a row, as `assuming` takes it
(define (assuming-all conditions thunk)
  (if (null? conditions)
      (thunk)
      (assuming ((car conditions)) (assuming-all (cdr conditions) thunk))))

(define (identity-claims group)
  (define title (first group))
  (for/list ([row (in-list (cddr group))])
    (define conditions (append (second group) (cdddr row)))
    (define ((asked other))
      (under conditions (lambda () (verify-equal (build (first row)) (build other)))))
    (claim 'identity (format "~a: ~s" title (first row)) (asked (second row))
     (asked (third row)))))

(define (integral-claim row)
  (define-values (integrand low high value other) (apply values (take row 5)))
  (define ((asked value))
    (under (drop row 5)
           (lambda ()
             (verify-integral (lambda (x) (build integrand x)) (build low) (build high)
                              (build value)))))
  (claim 'integral (format "~s from ~s to ~s" integrand low high) (asked value) (asked other)))

(define ((motion-claim kind) row)
  (claim kind (first row) (second row) (third row)))

(define claims
  (append (append-map identity-claims identities)
          (map integral-claim integrals)
          (map (motion-claim 'conserved) conserved)
          (map (motion-claim 'solution) solutions)
          (map (motion-claim 'canonical) transformations)))
