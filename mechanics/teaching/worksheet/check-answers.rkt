#lang racket/base
;; What a student's file runs at its end: each answer is judged, and told in words.

(require (for-syntax racket/base)
         (only-in racket/file file->string)
         "answer-data.rkt" "defined-names.rkt" "exercise-kind.rkt" "exercise.rkt"
         "judge.rkt" "judgment-words.rkt" "judgment.rkt" "sealed-exercises.rkt" "attempt-count.rkt")

(provide check-answers checking? sealed-exercises (struct-out judged) tell-judgments)

;; Not while answers are collected for the teacher.
(define checking? (make-parameter #t))

;; (check-answers [name value] ... "sealed" ...), the texts being one.  What it stands behind is
;; known only when the whole module is: so it is looked at then.
(define-syntax (check-answers stx)
  (syntax-case stx ()
    [(_ part ...) #`(#%expression #,(syntax/loc stx (check-defined part ...)))]))

(define-syntax (check-defined stx)
  (define source (syntax-source stx))
  (syntax-case stx ()
    [(_ part ...)
     (let-values ([(texts pairs)
                   (partition-texts (syntax->list #'(part ...)))])
       (with-syntax ([([name value] ...) (map without-unbound pairs)]
                     [(text ...) texts]
                     [file (and (path? source) (path->bytes source))])
         #'(check-sealed (list (cons 'name value) ...) (string-append text ...) file)))]))

(begin-for-syntax
  (define (partition-texts parts)
    (define (text? p) (string? (syntax-e p)))
    (values (filter text? parts) (filter (lambda (p) (not (text? p))) parts)))

  ;; A name that is not defined is not answered.
  (define (without-unbound pair)
    (syntax-case pair ()
      [(name value)
       (and (identifier? #'value) (not (identifier-binding #'value)))
       #'(name unanswered)]
      [_ pair])))

(define (check-sealed answers sealed file-name)
  (when (checking?)
    (define exercises (unseal sealed))
    (define file (and file-name (bytes->path file-name)))
    (for ([note (in-list (definition-notes exercises (text-of file)))]) (printf "~a\n" note))
    (tell-judgments
     (for/list ([e (in-list exercises)])
       (define found (assq (exercise-name e) answers))
       (define d (answer-of-kind e (if found (cdr found) unanswered)))
       (judged e d (judge e d)))
     file)))

;; As it was saved last.
(define (text-of file)
  (with-handlers ([exn:fail? (lambda (x) "")]) (if file (file->string file) "")))

;; The exercises in the envelope of a student's file, given as text; or #f
(define (sealed-exercises text)
  (define m (regexp-match #rx"[(]check-answers(.*)$" text))
  (define parts
    (if m (regexp-match* #px"\"([A-Za-z0-9+/=]+)\"" (cadr m) #:match-select cadr) '()))
  (and (pair? parts) (unseal (apply string-append parts))))

;; ---------------------------------------------------------------------------

;; answer : data
(struct judged (exercise answer judgment))

;; file : of the student, or #f
(define (tell-judgments all [file #f])
  (define tries
    (count-tries file (for/list ([one (in-list all)] #:when (wanting? one))
                        (cons (exercise-name (judged-exercise one)) (judged-answer one)))))
  (for ([one (in-list all)] [i (in-naturals 1)])
    (printf "~a. ~a\n" i (judgment->text (judged-exercise one) (judged-judgment one)
                                         #:hints (fitting-hints one tries))))
  (printf "~a of ~a.\n" (number->text (total all)) (counted-points (possible all))))

(define (wanting? one) (memq (judgment-status (judged-judgment one)) '(wrong partly trivial)))

;; Those of which enough wrong answers have been given.
(define (fitting-hints one tries)
  (define e (judged-exercise one))
  (define given (hash-ref tries (exercise-name e) 0))
  (if (wanting? one)
      (for/list ([h (in-list (exercise-hints e))] #:when (<= (hint-after h) given)) (hint-text h))
      '()))

(define (total all)
  (for/sum ([one (in-list all)])
    (or (judgment-points (judged-judgment one) (exercise-points (judged-exercise one))) 0)))

(define (possible all)
  (for/sum ([one (in-list all)]) (exercise-points (judged-exercise one))))
