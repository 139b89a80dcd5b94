#lang racket/base
;; Interactions as values: their controls, what hosts ask of them, what they print as.

(require mechanics
         file/convertible
         (only-in mechanics/plot frame)
         (only-in racket/string string-prefix?)
         "../../../../mechanics/show/interact/control.rkt"
         "../../../../mechanics/show/interact/interaction.rkt"
         "../../../../mechanics/show/interact/outcome.rkt"
         (only-in "../../../../mechanics/show/interact/outcome-picture-on-demand.rkt"
                  outcome-elements why-no-pictures)
         "../../support/checks.rkt" "../../support/skip.rkt")

(define (only-control i) (car (interaction-controls i)))
(define (values-of i) (vector->list (control-values (only-control i))))

(test-case "whole numbers have a step of 1, from a range of five up to one of two hundred"
  (check-equal? (values-of (interact ([k 1 10]) k)) '(1 2 3 4 5 6 7 8 9 10))
  (check-equal? (values-of (interact ([k -2 3]) k)) '(-2 -1 0 1 2 3))
  (check-equal? (length (values-of (interact ([k 0 200]) k))) 201)
  (check-equal? (control-step (only-control (interact ([k 0 4]) k))) 1/20)
  (check-equal? (control-step (only-control (interact ([k 0 201]) k))) 5)
  (check-equal? (control-step (only-control (interact ([k 0 100000]) k))) 1000))

(test-case "other ranges have a round step, at most a hundred of them, and reach their end"
  (check-equal? (control-step (only-control (interact ([k 0 1]) k))) 1/100)
  (check-equal? (control-step (only-control (interact ([k 1/2 10]) k))) 1/10)
  (check-equal? (control-step (only-control (interact ([k 1.0 10]) k))) 0.1)
  (check-equal? (control-step (only-control (interact ([k 0 2e-7]) k))) 2e-9)
  (define angles (values-of (interact ([a 0 pi]) a)))
  (check-equal? (control-step (only-control (interact ([a 0 pi]) a))) 0.05)
  (check-equal? (list (car angles) (car (reverse angles)) (length angles)) (list 0.0 pi 64)))

(test-case "a step that is given is kept, and the end need not be reached"
  (check-equal? (values-of (interact ([k 1 10 #:step 2]) k)) '(1 3 5 7 9))
  (check-equal? (values-of (interact ([k 0 1 #:step 1/3]) k)) '(0 1/3 2/3 1))
  (check-equal? (values-of (interact ([k 0 1 #:step 0.1]) k))
                '(0.0 0.1 0.2 0.3 0.4 0.5 0.6 0.7 0.8 0.9 1.0)))

(test-case "exact numbers stay exact, and one flonum makes flonums of all"
  (check-equal? (start-values (interact ([k 1 10 #:start 5/2]) k)) '(5/2))
  (check-equal? (start-values (interact ([k 1 10 #:start 2.5]) k)) '(2.5))
  (check-equal? (car (values-of (interact ([k 1 10 #:start 2.5]) k))) 1.0)
  (check-equal? (start-values (interact ([k 1 10 #:start 1] [n 1 10 #:start 10]) (+ k n))) '(1 10))
  (check-equal? (values-of (interact ([k 0 2 #:step 1 #:start 1/2]) k)) '(0 1/2 1 2)))

(define every-kind
  (interact ([k 1 10 #:start 3] [n (list 'a sin "b") #:start sin] [damped? #t] [title "x"])
    (define double (* 2 k))
    (list double n damped? title)))

(test-case "controls are records, in their order"
  (define controls (interaction-controls every-kind))
  (check-equal? (map control-name controls) '(k n damped? title))
  (check-equal? (map control-kind controls) '(number choice boolean text))
  (check-equal? (map control-start controls) (list 3 sin #t "x"))
  (check-equal? (map control-values controls)
                (list (vector 1 2 3 4 5 6 7 8 9 10) (vector 'a sin "b") (vector #f #t) #f))
  (check-equal? (map control-step controls) '(1 #f #f #f))
  (check-equal? (map control-position (list (car controls) (cadr controls)) (list 1 "b"))
                '(0 2)))

(test-case "the body is a function of the values; nothing is computed before"
  (define count 0)
  (define i (interact ([k 1 10]) (set! count (+ count 1)) (* k k)))
  (check-equal? count 0)
  (check-equal? (interaction-result i '(4)) 16)
  (check-equal? ((interaction-first i)) 1)
  (check-equal? ((interaction-first i)) 1)
  (check-equal? count 2))

(test-case "values from outside become values of the controls"
  (check-equal? (check-values every-kind (list 3.4 2 #f "y")) (list 3 "b" #f "y"))
  (check-equal? (check-values every-kind (list 3.5 0 #f "")) (list 3 'a #f ""))
  (check-equal? (check-values every-kind (list 99 7 #t "")) (list 10 "b" #t ""))
  (check-equal? (check-values every-kind (list -99 -1 #t "")) (list 1 'a #t "")))

(test-case "what the body raises is told in its place, and the next value is found"
  (define i (interact ([k -1 5]) (/ 1 k)))
  (check-equal? (failed-text (interaction-outcome i '(0))) "/: division by zero")
  (check-equal? (interaction-outcome i '(2)) 1/2)
  (check-equal? (failed-text (interaction-outcome (interact ([k 1 9]) (raise 'no)) '(1)))
                "the body raises no")
  (check-equal? (failed-text ((interaction-first (interact ([k 1 9]) (error 'mine "no ~a" k)))))
                "mine: no 1"))

(test-case "a break is no error of the body"
  (define i (interact ([k 1 9]) (break-thread (current-thread)) (sleep 10)))
  (check-exn exn:break? (lambda () (interaction-outcome i '(1)))))

(test-case "it prints as what makes it"
  (define text
    (string-append "(interact ([k 1 10 #:step 1 #:start 3] [n (list a sin \"b\") #:start sin] "
                   "[damped? #t] [title \"x\"]) (define double (* 2 k)) "
                   "(list double n damped? title))"))
  (for ([form '("~a" "~s" "~v")]) (check-equal? (format form every-kind) text))
  (check-equal? (format "~a" (interact ([k 1 10]) '(k 'k)))
                "(interact ([k 1 10 #:step 1]) '(k 'k))")
  (check-equal? (convert every-kind 'text) text))

(test-case "the names of controls hide others, in the body alone"
  (define k 'outer)
  (check-equal? (interaction-result (interact ([k 1 10] [sin 1 9]) (list k sin)) '(2 3)) '(2 3))
  (check-equal? k 'outer))

(skip-unless (not (why-no-pictures)) "the shared libraries of racket/draw are not installed"
  (test-case "its picture is that of the first value, formula, words or error"
    (for ([i (list (interact ([k 1 10]) (* 'a k)) (interact ([k 1 10]) "words")
                   (interact ([k 1 10]) (error 'mine "no"))
                   (interact ([k 1 10]) (= 'a 'b)))])
      (define svg (convert i 'svg-bytes #f))
      (check-true (and svg (string-prefix? (bytes->string/utf-8 svg) "<?xml")))))
  (test-case "a frame is drawn of lines, in its size; a number is not"
    (define drawn (outcome-elements (frame 0 1 0 1 #:width 300 #:height 200)))
    (check-equal? (list (car drawn) (cadr drawn)) '(300 200))
    (check-false (outcome-elements 3)))
  (test-case "the picture of a frame is its own, and what has none is written"
    (define f (frame 0 1 0 1))
    (check-equal? (convert (interact ([k 1 10]) f) 'svg-bytes #f) (convert f 'svg-bytes #f))
    (struct written-only ()
      #:property prop:convertible (lambda (x request default) default)
      #:property prop:custom-write (lambda (x port mode) (write-string "it" port)))
    (define outcome->pict (dynamic-require 'mechanics/show/interact/outcome-picture 'outcome->pict))
    (define-values (picture grows?) (outcome->pict (written-only)))
    (check-false grows?)
    (check-true (> ((dynamic-require 'pict 'pict-width) picture) 20))))
