#lang racket/base
;; A worksheet in a notebook: `(exercises "sealed" ...)` in its first cell opens the envelope, and
;; `(check name)` beneath an answer judges it in place.
;;
;; The exercises, and the wrong answers, after which hints come, are kept as long as the session.

(require (for-syntax racket/base)
         "answer-data.rkt" "check-answers.rkt" "exercise.rkt" "judgment.rkt" "sealed-exercises.rkt"
         "written-answer.rkt"
         "../../error/complain.rkt" "../../error/spelling.rkt")

(provide exercises check)

(define opened (box '()))
(define tries (box '()))

;; texts : the sealed exercises, in pieces
(define (exercises . texts)
  (when (checking?) (set-box! opened (unseal (apply string-append texts)))))

;; A cell may be run before the one that defines a name, which is not answered then.
(define-syntax (check stx)
  (syntax-case stx ()
    [(_ _ ...)
     (and (pair? (cdr (syntax-e stx))) (andmap identifier? (cdr (syntax->list stx))))
     #`(check-named (list #,@(for/list ([name (in-list (cdr (syntax->list stx)))])
                               #`(cons '#,name (value-or-unanswered #,name)))))]
    [_ (raise-syntax-error 'check "expected names of exercises, as in (check motion)" stx)]))

(define-syntax (value-or-unanswered stx)
  (syntax-case stx ()
    [(_ name) (if (identifier-binding #'name 0 #t) #'name #'unanswered)]))

;; answers : pairs of names and values
(define (check-named answers)
  (when (checking?)
    (define all
      (for/list ([a (in-list answers)]) (judged-answer-to (exercise-named (car a)) (cdr a))))
    (set-box! tries (tell-judgments all (unbox tries) (unbox opened)))
    (for-each show-reading all)
    (unless (null? (cdr all)) (tell-total all))))

;; An answer as on paper, as it was read, typeset
(define (show-reading j)
  (define d (reading-of (judged-exercise j) (judged-answer j)))
  (when (eq? 'answer (car d)) ((current-print) (formula-as-read (cadr d)))))

(define (exercise-named name)
  (define all (unbox opened))
  (when (null? all)
    (complain 'check "the worksheet is not open: run its first cell, which opens it"))
  (or (findf (lambda (e) (eq? name (exercise-name e))) all)
      (complain 'check "there is no exercise ~a~a" name
                (did-you-mean (nearest-names (symbol->string name) (map exercise-name all))))))
