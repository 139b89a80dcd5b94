#lang racket/base
;; The end of a student's file: each answer is judged, and the judgment printed; hints come after
;; wrong answers, whose number is kept in a file beside the student's.

(require (for-syntax racket/base)
         (only-in racket/file file->string file->value write-to-file)
         (only-in racket/list count index-of remove-duplicates)
         "answer-data.rkt" "defined-names.rkt" "exercise-kind.rkt" "exercise.rkt"
         "judge.rkt" "judgment-words.rkt" "judgment.rkt" "sealed-exercises.rkt")

(provide check-answers checking? judged-answer-to sealed-exercises
         tell-judgments tell-judgments-of-file tell-total)

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
       (and (identifier? #'value) (not (identifier-binding #'value 0 #t)))
       #'(name unanswered)]
      [_ pair])))

(define (check-sealed answers sealed file-name)
  (when (checking?)
    (define exercises (unseal sealed))
    (define file (and file-name (bytes->path file-name)))
    (for ([note (in-list (definition-notes exercises (text-of file)))]) (printf "~a\n" note))
    (tell-judgments-of-file
     (for/list ([e (in-list exercises)])
       (define found (assq (exercise-name e) answers))
       (judged-answer-to e (if found (cdr found) unanswered)))
     file)))

;; x : the answer, a value
(define (judged-answer-to e x)
  (define d (answer-of-kind e x))
  (judged e d (judge e d)))

;; The file as it was saved last.
(define (text-of file)
  (with-handlers ([exn:fail? (lambda (x) "")]) (if file (file->string file) "")))

;; The exercises in the envelope of a student's file or notebook, given as text; or #f
(define (sealed-exercises text)
  (define m (regexp-match #rx"[(](?:check-answers|exercises)(.*)$" text))
  (define parts
    (if m (regexp-match* #px"\"([A-Za-z0-9+/=]+)\"" (cadr m) #:match-select cadr) '()))
  (and (pair? parts) (unseal (apply string-append parts))))

;; ---------------------------------------------------------------------------
;; Judgments, printed

;; all : judged answers; tries : the wrong answers before, each once; exercises : of the worksheet
;; -> the wrong answers, with those of this time
(define (tell-judgments all [before '()] [exercises (map judged-exercise all)])
  (define tries (with-wrong-answers before (filter wanting? all)))
  (for ([j (in-list all)])
    (define number (+ 1 (index-of exercises (judged-exercise j))))
    (printf "~a. ~a\n" number
            (judgment->text j #:hints (if (wanting? j) (hints-due j tries) '()))))
  tries)

(define (tell-total all)
  (printf "~a of ~a.\n" (number->text (sum-of-points all))
          (counted-points (total-points (map judged-exercise all)))))

;; The wrong answers are kept in a file beside the student's, `file`.
(define (tell-judgments-of-file all [file #f])
  (define place (and file (path-replace-extension file #".tries")))
  (define before (if place (read-tries place) '()))
  (define tries (tell-judgments all before))
  (tell-total all)
  (when (and place (not (equal? tries before))) (write-tries place tries)))

;; The hints that come after so many wrong answers.
(define (hints-due j tries)
  (define given (count (lambda (entry) (eq? (judged-name j) (car entry))) tries))
  (for/list ([h (in-list (exercise-hints (judged-exercise j)))] #:when (<= (hint-after h) given))
    (hint-text h)))

;; ---------------------------------------------------------------------------
;; Wrong answers, each once: the name of its exercise, and a number that tells it from others

(define (with-wrong-answers before wrong)
  (remove-duplicates
   (append before (for/list ([j (in-list wrong)])
                    (list (judged-name j) (equal-hash-code (format "~s" (judged-answer j))))))))

(define (read-tries place)
  (define found (with-handlers ([exn:fail? (lambda (e) '())]) (file->value place)))
  (if (and (list? found) (andmap entry? found)) found '()))

(define (entry? x) (and (list? x) (= 2 (length x)) (symbol? (car x)) (exact-integer? (cadr x))))

;; In a folder that cannot be written to every try is the first.
(define (write-tries place all)
  (with-handlers ([exn:fail:filesystem? void])
    (write-to-file all place #:exists 'truncate)))
