#lang racket/base
;; Verdicts as checks of rackunit, for tests and for files of exercises.
;;
;; A check fails unless its verdict is the one it wants; then the failure shows the verdict: the
;; residual, the point that refutes, the condition under which it would hold.  Each takes the
;; arguments of its question, and perhaps a text at the end, the message.

(require (for-syntax racket/base)
         rackunit
         "canonical-map.rkt"
         "../../generic/describe.rkt"
         "../../question/on-demand.rkt"
         "../../verdict/prove-zero.rkt" "../../verdict/verdict.rkt")

(provide check-solution check-not-solution check-residual check-equal-expression
         check-conserved check-canonical check-proved check-refuted)

;; name : symbol of the check; place : of it; wanted : 'proved or 'refuted; find : -> verdict
(define (check-verdict name place wanted find message)
  (with-check-info*
   (append (list (make-check-name name)
                 (make-check-location place)
                 (make-check-info 'expected wanted))
           (if message (list (make-check-message message)) '()))
   (lambda ()
     ((current-check-around) (lambda () (check-found (find) wanted))))))

(define (check-found v wanted)
  (cond [(not (verdict? v))
         (fail-check (format "it is no verdict, as verify-solution or prove-zero gives one: ~a"
                             (describe-with-value v)))]
        [(not (eq? (verdict-status v) wanted))
         (with-check-info (['verdict (string-info (verdict->text v))]) (fail-check))]
        [else (void)]))

;; The verdict on lines of its own, indented.
(define (verdict->text v)
  (regexp-replace* #rx"\n" (format "\n~a" v) "\n    "))

;; Macros, so that a failure names its place; a text at the end is the message.
(define-syntax-rule (define-verdict-check name wanted question)
  (define-syntax (name stx)
    (syntax-case stx ()
      [(_ argument (... ...))
       (let* ([given (syntax->list #'(argument (... ...)))]
              [end (and (pair? given) (car (reverse given)))]
              [message (and end (string? (syntax-e end)) end)])
         (with-syntax ([(it (... ...)) (if message (reverse (cdr (reverse given))) given)]
                       [told message]
                       [place (list (syntax-source stx) (syntax-line stx) (syntax-column stx)
                                    (syntax-position stx) (syntax-span stx))])
           #'(check-verdict 'name 'place 'wanted (lambda () (question it (... ...))) told)))])))

(define-verdict-check check-solution proved verify-solution)
(define-verdict-check check-not-solution refuted verify-solution)
(define-verdict-check check-residual proved prove-zero)
(define-verdict-check check-equal-expression proved verify-equal)
(define-verdict-check check-conserved proved verify-conserved)
(define-verdict-check check-canonical proved verify-canonical-map)
(define-verdict-check check-proved proved values)
(define-verdict-check check-refuted refuted values)
