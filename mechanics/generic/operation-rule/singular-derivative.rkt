#lang racket/base
;; Points where a function has a value but no derivative.
;;
;; Kinks, jumps and infinite slopes are mathematical failures, whether the point
;; is exact or not: a flonum infinity would become a NaN at the next step, far
;; from where it could be understood.

(require "../describe.rkt"
         "../../error/failure.rkt" "../../error/message-words.rkt")

(provide raise-no-derivative-at)

;; why : a clause on the reason, such as "where it jumps", or #f.
(define (raise-no-derivative-at name arguments [why #f])
  (raise-singular name
                  (format "has no derivative ~aat ~a" (if why (string-append why ", ") "")
                          (joined (map value->text arguments)))
                  (if (null? (cdr arguments)) (car arguments) arguments)))
