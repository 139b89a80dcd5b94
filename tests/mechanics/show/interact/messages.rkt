#lang racket/base
;; Messages on interactions that cannot be.

(require mechanics
         (only-in racket/base [expand expand-form])
         "../../../../mechanics/show/interact/interaction.rkt"
         "../../support/checks.rkt" "../../support/messages.rkt")

;; ---------------------------------------------------------------------------
;; Values

(says
 [(interact ([k 1 1]) k) "interact: the range of k is empty: from 1 to 1"]
 [(interact ([k 10 1]) k)
  "interact: the range of k goes down, from 10 to 1\n  the lesser number stands first: [k 1 10]"]
 [(interact ([k 1 10 #:start 11]) k)
  "interact: k starts at 11, outside of its range from 1 to 10"]
 [(interact ([k 1 10 #:start 'a]) k)
  "interact: expected a number at which k starts\n  given: the symbol a"]
 [(interact ([k 1 10 #:start +inf.0]) k)
  "interact: expected a number at which k starts\n  given: the number +inf.0"]
 [(interact ([k 1 10 #:step 0]) k)
  "interact: expected a positive number as step of k\n  given: the number 0"]
 [(interact ([k 1 10 #:step -1/2]) k)
  "interact: expected a positive number as step of k\n  given: the number -1/2"]
 [(interact ([k 1 10 #:step 9.5]) k)
  "interact: the step of k, 9.5, is larger than its range from 1 to 10"]
 [(interact ([k 0 1 #:step 1e-6]) k)
  "interact: k would have 1000001 values in steps of 1e-6; a slider has at most 10000\n"
  "  choose a larger #:step"]
 [(interact ([k 'a 10]) k)
  "interact: expected a number at which the range of k begins, as in [k 1 10]\n"
  "  given: the symbol a"]
 [(interact ([k 1 +inf.0]) k)
  "interact: expected a number at which the range of k ends, as in [k 1 10]\n"
  "  given: the number +inf.0"]
 [(interact ([k 1 (sqrt -1)]) k)
  "interact: expected a number at which the range of k ends, as in [k 1 10]\n"
  "  given: the number 0+1i"]
 [(interact ([n '()]) n) "interact: the list of choices of n is empty"]
 [(interact ([n '(1 2) #:start 3]) n)
  "interact: n starts at 3, which is none of its choices\n  choices: 1, 2"]
 [(interact ([b #t #:start #f]) b)
  "interact: b starts with what stands in place of a list; #:start is for numbers and choices\n"
  "  given: #t, a boolean"]
 [(interact ([k 3]) k)
  "interact: k has one number, and a range has two: [k from to]\n  given: the number 3"]
 [(interact ([k sin]) k)
  "interact: expected two numbers, a list of choices, #t, #f or a text for k\n"
  "  given: the procedure `sin`"]
 [(interact ([n (cons 1 2)]) n)
  "interact: expected a list of choices for n\n  given: (1 . 2)"])

;; ---------------------------------------------------------------------------
;; The body

(says
 [(interaction-result (interact ([k 1 10]) (void)) '(1))
  "interact: the body returns nothing to be shown\n"
  "  it ends with a value, such as the frame in which it has drawn"]
 [(interaction-result (interact ([k 1 10]) (values)) '(1))
  "interact: the body returns nothing to be shown\n"
  "  it ends with a value, such as the frame in which it has drawn"]
 [(interaction-result (interact ([k 1 10]) (interact ([n 1 10]) n)) '(1))
  "interact: the body returns an interaction\n"
  "  the controls of both stand in one: (interact ([k 1 10] [n 1 10]) body)"]
 [(interaction-result (interact ([k 1 10]) (values k k)) '(1))
  "interact: the body returns 2 values, and one is shown; (list ...) makes one of them"])

;; ---------------------------------------------------------------------------
;; Values from outside, and what is to be shown

(define every-kind (interact ([k 1 10] [n '(1 2)] [b #t] [s ""]) k))

(says
 [(check-values every-kind '(1)) "interact: expected a list of 4 values\n  given: '(1)"]
 [(check-values every-kind '("1" 0 #t "")) "interact: expected a number for k\n  given: \"1\""]
 [(check-values every-kind '(+nan.0 0 #t "")) "interact: expected a number for k\n  given: +nan.0"]
 [(check-values every-kind '(1 0.5 #t ""))
  "interact: expected the number of a choice for n\n  given: 0.5"]
 [(check-values every-kind '(1 0 1 "")) "interact: expected #t or #f for b\n  given: 1"]
 [(check-values every-kind '(1 0 #t 7)) "interact: expected a text for s\n  given: 7"]
 [(interaction-show 1)
  "interaction-show: expected an interaction, such as (interact ([k 1 10]) k)\n"
  "  given: the number 1"]
 [(interaction-show every-kind #:now #t)
  "interaction-show: there is no keyword #:now here\n  its keywords: (#:wait?)"])

;; ---------------------------------------------------------------------------
;; The form

(define-namespace-anchor here)

(define (refused form)
  (parameterize ([current-namespace (namespace-anchor->namespace here)])
    (message-of (expand-form form) exn:fail:syntax?)))

(define-syntax-rule (refuses [form text ...] ...)
  (begin
    (test-case (format "~s" 'form)
      (check-equal? (regexp-replace #rx"\n  in: .*" (refused 'form) "")
                    (string-append text ...)))
    ...))

(refuses
 [(interact) "interact: expected controls and a body: (interact ([k 1 10]) body)"]
 [(interact k 1 10) "interact: expected controls and a body: (interact ([k 1 10]) body)"]
 [(interact () 1) "interact: there are no controls, as in (interact ([k 1 10]) body)"]
 [(interact ([k 1 10])) "interact: the body is missing, an expression whose value is shown"]
 [(interact ([k 1 10] [j 1 10] [k 1 2]) k) "interact: two controls have the name k\n  at: k"]
 [(interact ([1 10]) k) "interact: a control begins with its name, as in [k 1 10]\n  at: (1 10)"]
 [(interact ([(k) 1 10]) k)
  "interact: a control begins with its name, as in [k 1 10]\n  at: ((k) 1 10)"]
 [(interact (k 1 10) k) "interact: a control begins with its name, as in [k 1 10]\n  at: k"]
 [(interact ([k]) k)
  "interact: a control takes two numbers, a list of choices, #t, #f or a text, as in [k 1 10]\n"
  "  at: (k)"]
 [(interact ([k 1 2 3]) k)
  "interact: a control takes two numbers, a list of choices, #t, #f or a text, as in [k 1 10]\n"
  "  at: (k 1 2 3)"]
 [(interact ([k 1 10 #:steps 2]) k)
  "interact: there is no keyword #:steps here, only #:step and #:start\n  at: #:steps"]
 [(interact ([k 1 10 #:step]) k) "interact: nothing stands behind #:step\n  at: (k 1 10 #:step)"]
 [(interact ([k 1 10 #:step 1 #:step 2]) k)
  "interact: #:step stands twice\n  at: (k 1 10 #:step 1 #:step 2)"]
 [(interact ([n '(1 2) #:step 2]) n)
  "interact: #:step is for a range of numbers, as in [k 1 10 #:step 1/2]\n  at: 2"])
