#lang racket/base
;; A class: submissions are evaluated, several at a time, each in its process; what they answer
;; is judged here.
;;
;; Whatever a submission does costs itself at most its time.  The same answer of two students
;; is judged once, and a judgment that takes too long is left to a person.

(require racket/future
         racket/sandbox
         "collect-answers.rkt" "isolation.rkt" "submission.rkt"
         "../exercise.rkt" "../judge.rkt" "../judgment.rkt")

(provide grade-class
         (struct-out graded) graded-points graded-open (struct-out class-report))

;; judgments : one for each exercise of the worksheet; answers : hasheq, as collected
;; notes     : strings, what else there is to say of it
(struct graded (submission answers judgments problem notes) #:transparent)

;; warning : what is to be told on top, or #f
(struct class-report (worksheet warning graded) #:transparent)

;; The points, as far as they are known.
(define (graded-points g w)
  (for/sum ([j (in-list (graded-judgments g))] [e (in-list (exercises-of w))])
    (or (judgment-points j (exercise-points e)) 0)))

;; How many answers are left to a person?
(define (graded-open g)
  (for/sum ([j (in-list (graded-judgments g))]) (if (judgment-share j) 0 1)))

;; tell : of each that is done, called with how many are
(define (grade-class w submissions
                     #:seconds [seconds 10] #:megabytes [megabytes 512]
                     #:namespaces? [namespaces? #t] #:tell [tell void])
  (define i (find-isolation megabytes seconds #:namespaces? namespaces?))
  (define judge-once (make-judge seconds))
  (dynamic-wind
   void
   (lambda ()
     (class-report w (isolation-warning i)
                   (grade-all i (exercises-of w) submissions judge-once tell)))
   (lambda () (close-isolation i))))

(define (grade-all i exercises submissions judge-once tell)
  (for/list ([next (in-list (start-all i exercises submissions))]
             [s (in-list submissions)]
             [n (in-naturals 1)])
    (begin0 (grade-one exercises s (next) judge-once)
            (tell n))))

;; ---------------------------------------------------------------------------
;; Evaluation

;; As many at a time as there are processors. -> list of procedures that wait for a result
(define (start-all i exercises submissions)
  (define seats (make-semaphore (max 1 (min 4 (processor-count)))))
  (for/list ([s (in-list submissions)])
    (define result (make-channel))
    (thread (lambda ()
              (channel-put result
                           (call-with-semaphore seats
                                                (lambda () (collect-one i exercises s))))))
    (lambda () (channel-get result))))

;; Whatever happens there is a result, for somebody waits for it: a system may have no process
;; left to start.
(define (collect-one i exercises s)
  (with-handlers ([exn:fail? (lambda (x)
                               (collected (hasheq) (string-append "it could not be evaluated: "
                                                                  (exn-message x))))])
    (if (submission-text s)
        (collect-answers i exercises (submission-text s))
        (collected (hasheq) (submission-problem s)))))

;; ---------------------------------------------------------------------------
;; Judgment

(define (grade-one exercises s found judge-once)
  (define answers (collected-answers found))
  (define problem (collected-problem found))
  (define nothing (if problem (list 'failed problem) '(unanswered)))
  (define judgments
    (for/list ([e (in-list exercises)])
      (judge-once e (hash-ref answers (exercise-name e) nothing))))
  (graded s answers judgments problem (answered-twice exercises s)))

(define (answered-twice exercises s)
  (for*/list ([e (in-list exercises)]
              [name (in-value (symbol->string (exercise-name e)))]
              #:when (> (times-defined name (or (submission-text s) "")) 1))
    (format "~a is answered twice; the last answer was judged" name)))

;; Definitions begin their lines.
(define (times-defined name text)
  (length (regexp-match* (pregexp (string-append "(?m:^\\(define[ \t]+\\(*" (regexp-quote name)
                                                 "(?=[ \t\r\n)]))"))
                         text)))

;; -> a procedure that judges, and remembers
(define (make-judge seconds)
  (define known (make-hash))
  (lambda (e d)
    (hash-ref! known (cons (exercise-name e) d) (lambda () (judge-within seconds e d)))))

(define (judge-within seconds e d)
  (with-handlers ([exn:fail:resource?
                   (lambda (x)
                     (undecided-judgment #f "to judge it took too long, or too much memory"))])
    (call-with-limits seconds 1000 (lambda () (judge e d)))))
