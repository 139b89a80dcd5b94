#lang racket/base
;; A class: submissions are evaluated, several at a time, each in its process; what they answer
;; is judged here.
;;
;; A submission costs its own time at most: what it took to evaluate it is taken off the time for
;; its judgments.  The same answer of two students is judged once; what there was no time to judge
;; is left to a person.

(require racket/future
         "collect-answers.rkt" "isolation.rkt" "submission.rkt" "within-limits.rkt"
         "../worksheet/defined-names.rkt" "../worksheet/exercise.rkt" "../worksheet/judge.rkt" "../worksheet/judgment.rkt")

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

;; strictest : level of isolation, the first that is tried
;; tell : number of submissions graded so far -> any; called after each
(define (grade-class w submissions
                     #:seconds [seconds 10] #:megabytes [megabytes 512]
                     #:strictest [strictest 'namespaces] #:tell [tell void])
  (define known (make-hash))
  (call-with-isolation
   megabytes seconds #:strictest strictest
   (lambda (i)
     (class-report w (level-warning (isolation-level i))
                   (grade-all i (exercises-of w) submissions known tell)))))

;; known : table of the judgments made so far
(define (grade-all i exercises submissions known tell)
  (for/list ([next (in-list (start-all i exercises submissions))]
             [s (in-list submissions)]
             [n (in-naturals 1)])
    (begin0 (grade-one exercises s (next) known (isolation-seconds i))
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
                                                                  (exn-message x))
                                          0))])
    (if (submission-text s)
        (collect-answers i exercises (submission-text s))
        (collected (hasheq) (submission-problem s) 0))))

;; ---------------------------------------------------------------------------
;; Judgment

(define (grade-one exercises s found known seconds)
  (define answers (collected-answers found))
  (define problem (collected-problem found))
  (define nothing (if problem '(failed) '(unanswered)))
  (define-values (judgments left)
    (for/fold ([done '()] [left (- seconds (collected-spent found))]) ([e (in-list exercises)])
      (define-values (j took)
        (judge-once known e (hash-ref answers (exercise-name e) nothing) left))
      (values (cons j done) (- left took))))
  (graded s answers (reverse judgments) problem (notes-on exercises s found)))

(define (notes-on exercises s found)
  (define text (or (submission-text s) ""))
  (define part?
    (and (collected-problem found)
         (for/or ([d (in-hash-values (collected-answers found))]) (memq (car d) '(answer text)))))
  (append (if part? '("what could be run of it was judged") '())
          (definition-notes exercises text)))

;; -> a judgment, and the seconds that it took.  One that was not made is not remembered: the next
;; may have more time for it.
(define (judge-once known e d seconds)
  (define key (cons (exercise-name e) d))
  (define found (hash-ref known key #f))
  (cond [found (values found 0)]
        [(not (eq? 'answer (car d))) (values (judge e d) 0)]
        [else
         (define-values (j took)
           (if (> seconds 0)
               (call-within seconds most-megabytes (lambda () (judge e d)))
               (values #f 0)))
         (when j (hash-set! known key j))
         (values (or j not-made) took)]))

(define most-megabytes 1000)

(define not-made (undecided-judgment #f "to judge it took too long, or too much memory"))
