#lang racket/base
;; Verdicts as checks of rackunit, for tests and for files of exercises.
;;
;; A check fails unless its verdict is the one it is for; then the failure shows the verdict:
;; the residual, the point that refutes, the condition under which it would hold.  Each takes
;; what the question takes that it asks, and, if that is a text, a message at the end.

(require (for-syntax racket/base)
         rackunit
         "canonical-map.rkt"
         "../error/words.rkt"
         "../generic/describe.rkt"
         "../question/on-demand.rkt" "../question/verify-solution.rkt"
         "../verdict/prove-zero.rkt" "../verdict/verdict.rkt")

(provide check-solution check-not-solution check-residual check-equal-expression
         check-conserved check-canonical check-proved check-refuted)

;; name : symbol of the check; wanted : 'proved or 'refuted; find : -> verdict
(define-check (check-verdict name wanted find message)
  (define v (find))
  (unless (verdict? v)
    (with-check-info (['name name] ['given (string-info (describe-with-value v))])
      (fail-check "it is no verdict, as verify-solution or prove-zero gives one")))
  (define infos
    (append (list (make-check-name name)
                  (make-check-info 'expected wanted)
                  (make-check-info 'verdict (string-info (verdict->text v))))
            (if message (list (make-check-message message)) '())))
  (unless (eq? (verdict-status v) wanted)
    (with-check-info* infos (lambda () (fail-check)))))

;; The verdict, its lines one below the other, set off from the word before it.
(define (verdict->text v)
  (joined (map (lambda (line) (string-append "\n    " line))
               (regexp-split #rx"\n" (format "~a" v)))
          ""))

;; Macros, so that a failure is told where it stands; a text at the end is the message.
(define-syntax-rule (define-verdict-check name wanted question)
  (define-syntax (name stx)
    (syntax-case stx ()
      [(_ argument (... ...))
       (let* ([given (syntax->list #'(argument (... ...)))]
              [end (and (pair? given) (car (reverse given)))]
              [message (and end (string? (syntax-e end)) end)])
         (with-syntax ([(it (... ...)) (if message (reverse (cdr (reverse given))) given)]
                       [told message])
           (syntax/loc stx
             (check-verdict 'name 'wanted (lambda () (question it (... ...))) told))))])))

(define-verdict-check check-solution proved verify-solution)
(define-verdict-check check-not-solution refuted verify-solution)
(define-verdict-check check-residual proved prove-zero)
(define-verdict-check check-equal-expression proved verify-equal)
(define-verdict-check check-conserved proved verify-conserved)
(define-verdict-check check-canonical proved verify-canonical-map)
(define-verdict-check check-proved proved values)
(define-verdict-check check-refuted refuted values)
