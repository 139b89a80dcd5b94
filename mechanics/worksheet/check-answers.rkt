#lang racket/base
;; What a student's file runs at its end: each answer is judged, and told in words.

(require "answer-data.rkt" "exercise-kind.rkt" "exercise.rkt" "judge.rkt" "judgment-words.rkt"
         "judgment.rkt" "seal.rkt")

(provide check-answers checking? sealed-exercises tell-judgments)

;; Not while answers are collected for the teacher.
(define checking? (make-parameter #t))

;; (check-answers [name value] ... "sealed" ...)
(define-syntax check-answers
  (syntax-rules ()
    [(_ [name value] ... sealed) (check-sealed (list (cons 'name value) ...) sealed)]
    [(_ part ...) (collect () part ...)]))

;; The texts, which are one, behind the pairs.
(define-syntax collect
  (syntax-rules ()
    [(_ (pair ...) [name value] part ...) (collect (pair ... [name value]) part ...)]
    [(_ ([name value] ...) text ...)
     (check-sealed (list (cons 'name value) ...) (string-append text ...))]))

(define (check-sealed answers sealed)
  (when (checking?)
    (define exercises (unseal sealed))
    (tell-judgments
     (for/list ([e (in-list exercises)])
       (define found (assq (exercise-name e) answers))
       (cons e (judge e (answer-of-kind e (if found (cdr found) unanswered))))))))

;; The exercises in the envelope of a student's file, given as text; or #f
(define (sealed-exercises text)
  (define m (regexp-match #rx"[(]check-answers(.*)$" text))
  (define parts
    (if m (regexp-match* #px"\"([A-Za-z0-9+/=]+)\"" (cadr m) #:match-select cadr) '()))
  (and (pair? parts) (unseal (apply string-append parts))))


;; found : list of (exercise . judgment)
(define (tell-judgments found)
  (for ([f (in-list found)] [i (in-naturals 1)])
    (define-values (e j) (values (car f) (cdr f)))
    (printf "~a. ~a\n" i (judgment->text e j #:hints (fitting-hints e j))))
  (define got (for/sum ([f (in-list found)])
                (or (judgment-points (cdr f) (exercise-points (car f))) 0)))
  (define all (for/sum ([f (in-list found)]) (exercise-points (car f))))
  (printf "~a of ~a.\n" (number->text got) (counted-points all)))

(define (fitting-hints e j)
  (if (memq (judgment-status j) '(wrong partly trivial))
      (map hint-text (exercise-hints e))
      '()))
