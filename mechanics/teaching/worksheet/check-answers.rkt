#lang racket/base
;; The end of a student's file: each answer is judged, and the judgment printed; hints come after
;; wrong answers, whose number is kept in a file beside the student's.

(require (for-syntax racket/base)
         (only-in racket/file file->string file->value write-to-file)
         (only-in racket/list remove-duplicates)
         "answer-data.rkt" "defined-names.rkt" "exercise-kind.rkt" "exercise.rkt"
         "judge.rkt" "judgment-words.rkt" "judgment.rkt" "sealed-exercises.rkt")

(provide check-answers checking? sealed-exercises tell-judgments)

;; #f while answers are collected for the teacher.
(define checking? (make-parameter #t))

;; (check-answers [name value] ... "sealed" ...), the texts being one.  All definitions of the
;; module are known only after its expansion: so the names are looked up then.
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

;; The file as it was saved last.
(define (text-of file)
  (with-handlers ([exn:fail? (lambda (x) "")]) (if file (file->string file) "")))

;; The exercises in the envelope of a student's file, given as text; or #f
(define (sealed-exercises text)
  (define m (regexp-match #rx"[(]check-answers(.*)$" text))
  (define parts
    (if m (regexp-match* #px"\"([A-Za-z0-9+/=]+)\"" (cadr m) #:match-select cadr) '()))
  (and (pair? parts) (unseal (apply string-append parts))))

;; ---------------------------------------------------------------------------
;; Judgments, printed

;; all : judged answers; file : the student's, or #f
(define (tell-judgments all [file #f])
  (define tries (count-tries file (filter wanting? all)))
  (for ([j (in-list all)] [i (in-naturals 1)])
    (printf "~a. ~a\n" i (judgment->text j #:hints (if (wanting? j) (hints-due j tries) '()))))
  (printf "~a of ~a.\n" (number->text (sum-of-points all))
          (counted-points (total-points (map judged-exercise all)))))

;; The hints that come after so many wrong answers.
(define (hints-due j tries)
  (define given (hash-ref tries (judged-name j)))
  (for/list ([h (in-list (exercise-hints (judged-exercise j)))] #:when (<= (hint-after h) given))
    (hint-text h)))

;; ---------------------------------------------------------------------------
;; Wrong answers, counted

;; wrong : the wrong answers of this run -> hasheq, from the name of an exercise to the number of
;; different wrong answers so far
(define (count-tries file wrong)
  (define place (and file (path-replace-extension file #".tries")))
  (define before (if place (read-tries place) '()))
  (define all
    (remove-duplicates
     (append before (for/list ([j (in-list wrong)])
                      (list (judged-name j) (equal-hash-code (format "~s" (judged-answer j))))))))
  (when (and place (not (equal? all before))) (write-tries place all))
  (for/fold ([counts (hasheq)]) ([entry (in-list all)])
    (hash-update counts (car entry) add1 0)))

(define (read-tries place)
  (define found (with-handlers ([exn:fail? (lambda (e) '())]) (file->value place)))
  (if (and (list? found) (andmap entry? found)) found '()))

(define (entry? x) (and (list? x) (= 2 (length x)) (symbol? (car x)) (exact-integer? (cadr x))))

;; In a folder that cannot be written to every try is the first.
(define (write-tries place all)
  (with-handlers ([exn:fail:filesystem? void])
    (write-to-file all place #:exists 'truncate)))
