#lang racket/base
;; Where only numbers will do: the number that an argument stands for, and the message if it
;; stands for none.

(require "function.rkt" "kind.rkt" "multiplied-function.rkt" "wrong-argument.rkt"
         "../algebra/expression/constant-value.rkt" "../algebra/expression/expression.rkt"
         "../error/complain.rkt" "../error/hint.rkt"
         "../numeric/finite-number.rkt")

(provide known-number number number-beneath
         finite-number positive-number
         check-function-of-one-variable)

;; -> the real number that x is: one of higher precision as one of Racket's, exact; one that π
;; is in as a flonum; or #f
(define (known-number x)
  (cond [(real? x) x]
        [(other-number? x) (comparand x)]
        [(symbolic? x) (constant-value x)]
        [else #f]))

;; The same of an x that must be one.
(define (number who x)
  (or (known-number x)
      (complain-of-argument who "a real number" x
                            (if (symbolic? x)
                                (string-append symbols-hint ": (substitute expression 'm 3 ...)")
                                (string-append (multiplied-hint x) (list-hint x))))))

;; The same of an x that may be in the course of being differentiated
(define (number-beneath who x) (number who (comparand x)))

;; The finite number that x is, with whatever is differentiated left away.
;; expected : the message's word for x
(define (finite-number who x [expected "a real number"])
  (define r (comparand x))
  (unless (finite? r) (complain-of-argument who expected x))
  r)

(define (positive-number who x expected)
  (define r (finite-number who x expected))
  (unless (positive? r) (complain-of-argument who expected x))
  r)

(define (check-function-of-one-variable who f)
  (unless (and (procedure? f) (accepts? f 1))
    (if (and (symbol? f) (regexp-match? #rx".[-+*/^]." (symbol->string f)))
        (complain who
                  (string-append "expected a function of one variable\n  given: the symbol ~a"
                                 "\n  ~a is one name; a function is (lambda (x) (+ x 1))")
                  f f)
        (raise-other-function who "a function of one variable" f))))
