#lang racket/base
;; Does a form, as Racket reads it when it is typed, have the values of a formula that was read?
;; Both are evaluated at some points: numbers for names, and of unknown functions some numbers that
;; depend on their arguments.

(require (only-in racket/math pi sgn)
         "../written-form.rkt")

(provide same-values?)

(define (same-values? reading form)
  (define typed (read (open-input-string (form->text form))))
  (for/and ([point (in-range 3)])
    (close? (value reading point) (value typed point))))

;; Where neither has a value, as 1/0, the forms must be equal.
(define (close? v w)
  (if (and (number? v) (number? w))
      (<= (magnitude (- v w)) (* 1e-9 (+ 1 (magnitude w))))
      (equal? v w)))

(define (value d point)
  (with-handlers ([exn:fail:contract? (lambda (e) d)])
    (let value ([d d])
      (cond [(number? d) d]
            [(eq? d 'pi) pi]
            [(not (pair? d)) (number-of (list point d))]
            [(eq? (car d) 'quote) (value (cadr d))]
            [(hash-ref operations (car d) #f)
             => (lambda (f) (apply f (map value (cdr d))))]
            [else
             (for/fold ([v (number-of (list point 'head (car d)))]) ([x (in-list (cdr d))])
               (+ (* 0.7 v) (value x)))]))))

;; Between 1/2 and 1
(define (number-of key) (/ 1.0 (+ 1 (/ (modulo (equal-hash-code (format "~s" key)) 1009) 1009))))

(define operations
  (hash '+ + '- - '* * '/ / 'expt expt 'sqrt sqrt 'exp exp 'log log
        'sin sin 'cos cos 'tan tan 'asin asin 'acos acos 'atan atan 'square (lambda (x) (* x x))
        'abs magnitude 'sgn sgn))
