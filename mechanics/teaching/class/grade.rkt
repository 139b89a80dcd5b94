#lang racket/base
;; A class: submissions are evaluated, several at a time, each in its process; their answers are
;; judged here.
;;
;; A submission costs its own time at most: the time of its evaluation is taken off that of its
;; judgments.  The same answer of two students is judged once; an answer without time left for it
;; is left to a person.

(require racket/future
         (only-in racket/list count)
         "collect-answers.rkt" "isolation.rkt" "submission.rkt" "within-limits.rkt"
         "../worksheet/defined-names.rkt" "../worksheet/exercise.rkt" "../worksheet/judge.rkt"
         "../worksheet/judgment.rkt")

(provide grade-class
         (struct-out graded) graded-judgments graded-points graded-open graded-remarks
         (struct-out class-report))

;; answers : judged answers, one for each exercise of the worksheet
;; problem : why there are not more answers, or #f; notes : further strings
(struct graded (submission answers problem notes) #:transparent)

;; warning : text for the top, or #f
(struct class-report (worksheet warning graded) #:transparent)

(define (graded-judgments g) (map judged-judgment (graded-answers g)))

(define (graded-points g) (sum-of-points (graded-answers g)))

;; The number of answers that are left to a person.
(define (graded-open g) (count (lambda (j) (not (judgment-share j))) (graded-judgments g)))

;; The problem, if there is one, and the notes.
(define (graded-remarks g)
  (define problem (graded-problem g))
  (if problem (cons problem (graded-notes g)) (graded-notes g)))

;; strictest : the level of isolation that is tried first
;; tell : called after each submission with the number graded so far
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

;; Starts as many at a time as there are processors. -> procedures that wait for a result each
(define (start-all i exercises submissions)
  (define seats (make-semaphore (max 1 (min 4 (processor-count)))))
  (for/list ([s (in-list submissions)])
    (define result (make-channel))
    (thread (lambda ()
              (channel-put result
                           (call-with-semaphore seats
                                                (lambda () (collect-one i exercises s))))))
    (lambda () (channel-get result))))

;; Gives a result even where the system has no process left to start: a thread waits for it.
(define (collect-one i exercises s)
  (define (none problem) (collected (hasheq) problem 0 #f))
  (with-handlers ([exn:fail? (lambda (x)
                               (none (string-append "it could not be evaluated: "
                                                    (exn-message x))))])
    (if (submission-text s)
        (collect-answers i exercises s)
        (none (submission-problem s)))))

;; ---------------------------------------------------------------------------
;; Judgment

(define (grade-one exercises handed-in found known seconds)
  (define outline (and (submission-notebook? handed-in) (or (collected-outline found) "")))
  (define s (if outline (with-outline handed-in outline) handed-in))
  (define problem (collected-problem found))
  (define nothing (if problem '(failed) '(unanswered)))
  (define answers
    (for/fold ([done '()] [left (- seconds (collected-spent found))] #:result (reverse done))
              ([e (in-list exercises)])
      (define d (hash-ref (collected-answers found) (exercise-name e) nothing))
      (define-values (j took) (judge-once known e d left))
      (values (cons (judged e d j) done) (- left took))))
  (graded s answers problem (notes-on exercises s found)))

(define (notes-on exercises s found)
  (define text (or (submission-text s) ""))
  (define part?
    (and (collected-problem found)
         (for/or ([d (in-hash-values (collected-answers found))]) (memq (car d) '(answer text)))))
  (append (if part? '("what could be run of it was judged") '())
          (definition-notes exercises text)))

;; -> a judgment, and the seconds that it took.  An answer that was not judged is not remembered:
;; the next submission may have more time for it.
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
