#lang racket/base
;; A class: submissions are evaluated, several at a time, each in its process; their answers are
;; judged here.
;;
;; A submission costs its own time at most: the time of its evaluation is taken off that of its
;; judgments.  The same answer of two students is judged once; an answer without time left for it
;; is left to a person.

(require racket/future
         (only-in racket/list count)
         (only-in racket/string string-trim)
         "class-list.rkt" "collect-answers.rkt" "isolation.rkt" "lateness.rkt" "likeness.rkt"
         "submission.rkt" "within-limits.rkt"
         "../worksheet/defined-names.rkt" "../worksheet/exercise.rkt" "../worksheet/judge.rkt"
         "../worksheet/judgment.rkt" "../worksheet/student-file.rkt"
         (only-in "../../error/message-words.rkt" joined))

(provide grade-class
         (struct-out graded) graded-judgments graded-points graded-open graded-remarks graded-person
         (struct-out class-report))

;; answers : judged answers, one for each exercise of the worksheet
;; problem : why there are not more answers, or #f; notes : further strings
;; participant : whose it is, of the class list, or #f; share : of the points, that lateness leaves
(struct graded (submission answers problem notes participant share) #:transparent)

;; warning : text for the top, or #f; class : participants; remarks : strings for the teacher alone
(struct class-report (worksheet warning graded class remarks) #:transparent)

(define (graded-judgments g) (map judged-judgment (graded-answers g)))

(define (graded-points g) (* (graded-share g) (sum-of-points (graded-answers g))))

;; The name of the class list, or of the submission.
(define (graded-person g)
  (define p (graded-participant g))
  (if p (participant-name p) (submission-person (graded-submission g))))

;; The number of answers that are left to a person.
(define (graded-open g) (count (lambda (j) (not (judgment-share j))) (graded-judgments g)))

;; The problem, if there is one, and the notes.
(define (graded-remarks g)
  (define problem (graded-problem g))
  (if problem (cons problem (graded-notes g)) (graded-notes g)))

;; class : participants; worksheet-of : the key of one -> the worksheet with that student's numbers
;; strictest : the level of isolation that is tried first
;; collect : isolation, exercises, submission -> collected; tell : called after each submission with
;; the number graded so far
(define (grade-class w submissions
                     #:class [class '()] #:worksheet-of [worksheet-of (lambda (key) w)]
                     #:seconds [seconds 10] #:megabytes [megabytes 512]
                     #:strictest [strictest 'namespaces] #:collect [collect collect-answers]
                     #:tell [tell void])
  (define c (course w class worksheet-of (make-hash)))
  (call-with-isolation
   megabytes seconds #:strictest strictest
   (lambda (i)
     (define all (grade-all i c submissions collect tell))
     (class-report w (level-warning (isolation-level i)) all class
                   (append (remarks-on-class class all)
                           (likenesses (for/list ([g (in-list all)]) (as-handed-in c g))))))))

;; known : table of the judgments made so far
(struct course (worksheet class worksheet-of known))

(define (grade-all i c submissions collect tell)
  (define exercises (exercises-of (course-worksheet c)))
  (define (answers-of s) (collect-one (lambda () (collect i exercises s)) s))
  (for/list ([next (in-list (start-all answers-of submissions))]
             [s (in-list submissions)]
             [n (in-naturals 1)])
    (begin0 (grade-one c s (next) (isolation-seconds i))
            (tell n))))

;; ---------------------------------------------------------------------------
;; For the teacher

(define (remarks-on-class class all)
  (define (of p) (filter (lambda (g) (eq? p (graded-participant g))) all))
  (define (ids gs) (joined (map (lambda (g) (submission-id (graded-submission g))) gs)))
  (define strangers (filter (lambda (g) (not (graded-participant g))) all))
  (define absent (filter (lambda (p) (null? (of p))) class))
  (append
   (if (and (pair? class) (pair? strangers))
       (list (format "of nobody on the list of the class: ~a" (ids strangers)))
       '())
   (for*/list ([p (in-list class)] [several (in-value (of p))]
               #:when (and (pair? several) (pair? (cdr several))))
     (format "~a has several submissions: ~a" (participant-name p) (ids several)))
   (if (pair? absent)
       (list (format "nothing was handed in by ~a" (joined (map participant-name absent))))
       '())))

(define (as-handed-in c g)
  (handed-in (graded-person g)
             (or (submission-text (graded-submission g)) "")
             (worksheet->student-file (worksheet-for c (graded-participant g)))
             (graded-answers g)))

(define (worksheet-for c owner)
  (if owner ((course-worksheet-of c) (participant-key owner)) (course-worksheet c)))

;; ---------------------------------------------------------------------------
;; Evaluation

;; Starts as many at a time as there are processors. -> procedures that wait for a result each
(define (start-all answers-of submissions)
  (define seats (make-semaphore (max 1 (min 4 (processor-count)))))
  (for/list ([s (in-list submissions)])
    (define result (make-channel))
    (thread (lambda ()
              (channel-put result (call-with-semaphore seats (lambda () (answers-of s))))))
    (lambda () (channel-get result))))

;; Gives a result even where the system has no process left to start: a thread waits for it.
(define (collect-one collect s)
  (define (none problem) (collected (hasheq) problem 0 #f))
  (with-handlers ([exn:fail? (lambda (x)
                               (none (string-append "it could not be evaluated: "
                                                    (exn-message x))))])
    (if (submission-text s)
        (collect)
        (none (submission-problem s)))))

;; ---------------------------------------------------------------------------
;; Judgment

(define (grade-one c handed-in found seconds)
  (define outline (and (submission-notebook? handed-in) (or (collected-outline found) "")))
  (define s (if outline (with-outline handed-in outline) handed-in))
  (define owners (participants-of (course-class c) s))
  (define owner (and (pair? owners) (null? (cdr owners)) (car owners)))
  (define w (worksheet-for c owner))
  (define known-numbers?
    (or (not (numbers-of w)) (numbers-student (numbers-of w))))
  (define problem (if known-numbers? (collected-problem found) numbers-unknown))
  (define answers
    (judge-all (exercises-of w) (if known-numbers? (collected-answers found) (hasheq))
               (if problem '(failed) '(unanswered))
               (course-known c) (- seconds (collected-spent found))))
  (define-values (share late) (lateness-of w s owner))
  (graded s answers problem
          (append (if late (list late) '()) (notes-on w s found))
          owner share))

(define numbers-unknown
  "whose it is the list of the class does not tell, so its numbers are not known")

;; otherwise : the answer where there is none
(define (judge-all exercises answers otherwise known seconds)
  (for/fold ([done '()] [left seconds] #:result (reverse done))
            ([e (in-list exercises)])
    (define d (hash-ref answers (exercise-name e) otherwise))
    (define-values (j took) (judge-once known e d left))
    (values (cons (judged e d j) done) (- left took))))

;; Times of a platform count before that of the file.
(define (lateness-of w s owner)
  (lateness (deadline-of w)
            (or (and owner (participant-handed-in owner)) (submission-time s))
            (if owner (participant-extension owner) 0)))

(define (notes-on w s found)
  (define text (or (submission-text s) ""))
  (define part?
    (and (collected-problem found)
         (for/or ([d (in-hash-values (collected-answers found))]) (memq (car d) '(answer text)))))
  (append (if part? '("what could be run of it was judged") '())
          (strange-numbers w text)
          (definition-notes (exercises-of w) text)))

;; The file of a student says whose its numbers are.
(define (strange-numbers w text)
  (define own (and (numbers-of w) (numbers-student (numbers-of w))))
  (define m (regexp-match #px"(?m:^;; The numbers of ([^\r\n]*))" text))
  (if (and own m (not (equal? own (string-trim (cadr m)))))
      (list (format "the numbers in it are those of ~a" (string-trim (cadr m))))
      '()))

;; -> a judgment, and the seconds that it took.  An answer that was not judged is not remembered:
;; the next submission may have more time for it.
(define (judge-once known e d seconds)
  (define key (cons e d))
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
