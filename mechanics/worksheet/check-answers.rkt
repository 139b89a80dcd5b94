#lang racket/base
;; What a student's file runs at its end: each answer is judged, and told in words.

(require "answer-data.rkt" "exercise-kind.rkt" "exercise.rkt" "judge.rkt" "judgment-words.rkt"
         "judgment.rkt" "seal.rkt")

(provide check-answers checking? judge-value-of tell-judgments)

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
       (cons e (judge-value-of e (if found (cdr found) unanswered)))))))

;; x : what the student wrote, a value
(define (judge-value-of e x)
  (define d
    (if (eq? (exercise-kind e) 'reason)
        (text-answer->datum x)
        (answer->datum x (rounds-of e))))
  (if (and (eq? (car d) 'answer) (not (exercise-practice? e)))
      (judgment 'kept #f #f '())
      (judge e d)))

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
