#lang racket/base
;; Up to which parameter a family of maps has an invariant circle of a rotation number, as far as
;; series of so many terms tell.
;;
;; Near the parameter at which a circle breaks up it loses its smoothness: its series converges
;; ever slower, and with any number of terms Newton's method fails a little before the circle does.
;; So the result is a lower bound, for it is a circle that is found there; and more terms come
;; nearer to the end (J. M. Greene, Journal of Mathematical Physics 20, 1979: the golden circle of
;; the standard map is the last, and breaks up at K = 0.971635406).

(require "invariant-circle.rkt"
         "../../error/complain.rkt" "../../error/failure.rkt"
         "../../generic/define-plain.rkt" "../../generic/describe.rkt" "../../generic/function.rkt"
         "../../generic/number-argument.rkt")

(provide invariant-circle-limit)

;; family : parameter -> map of the plane; low, high : parameters with the limit between them
;; lowest, highest : ordinates at the angle 0, with the circles between them
;; -> (list found missing): the last parameter with a circle, and the first without one
(define-plain (invariant-circle-limit family rotation-number low high
                                      #:tolerance [tolerance 1e-3] #:from [lowest #f]
                                      #:to [highest #f] #:most-modes [most 4096])
  (define who 'invariant-circle-limit)
  (check-family who family)
  (define-values (from to) (values (parameter who low) (parameter who high)))
  (define enough (positive-number who tolerance "a tolerance, a positive number"))
  (define (circle-of k)
    (circle-for who (family k) rotation-number lowest highest most))
  (define missed (missed-at circle-of from))
  (when missed (raise-missing who missed from to))
  (unless (missed-at circle-of to) (raise-found who rotation-number to))
  (let narrow ([found from] [missing to])
    (define middle (/ (+ found missing) 2.0))
    (cond [(or (<= (abs (- missing found)) enough) (= middle found) (= middle missing))
           (list found missing)]
          [(missed-at circle-of middle) (narrow found middle)]
          [else (narrow middle missing)])))

;; -> the failure to find a circle, or #f
(define (missed-at circle-of k)
  (with-handlers ([exn:fail:mechanics:not-convergent? values])
    (circle-of k)
    #f))

(define (check-family who family)
  (unless (and (procedure? family) (accepts? family 1))
    (complain who
              (string-append "expected a family of maps, a function of one parameter such as "
                             "standard-map\n  given: ~a")
              (describe-function family))))

(define (parameter who x) (finite-number who x "a real number as the parameter"))

;; The failure tells why, and how much of the circle is known.
(define (raise-missing who failure from to)
  (define why (regexp-replace (format "^~a: " who) (exn-message failure) ""))
  (define message
    (format (string-append "~a: no circle was found at the first of the two parameters, where it "
                           "is to be\n  first: ~a\n  second: ~a\n  why: ~a")
            who from to why))
  (raise (struct-copy exn:fail:mechanics:not-convergent failure [message #:parent exn message])))

(define (raise-found who rotation-number to)
  (complain who
            "the circle is there at both ends\n  rotation number: ~a\n  greatest parameter: ~a"
            (value->text rotation-number) (value->text to)))
