#lang racket/base
;; Claims that the library makes of a statement, and their judgement.

(require "judge/fault.rkt" "judge/judge.rkt" "judge/matter.rkt" "judge/motion.rkt"
         "judge/refutation.rkt"
         "classes/motions.rkt" "library.rkt" "statement.rkt"
         "../support/patience.rkt")

(provide (struct-out outcome) outcomes-of wrong? fault-kind-of claim-again statement-of)

;; claim : 'equal, 'opposite, 'form, 'motion or 'question; subject : statement, proposal, inquiry
;; answer : 'proved, 'refuted, 'undecided, 'form, 'found, 'raised, 'slow or 'rejected
;; judgement : #f where it is right, 'unjudged, or a fault
;; detail : text or datum to be shown: what was answered
(struct outcome (claim subject answer judgement detail) #:prefab)

(define (wrong? o) (fault? (outcome-judgement o)))
(define (fault-kind-of o) (and (wrong? o) (fault-kind (outcome-judgement o))))
(define (statement-of o) (and (statement? (outcome-subject o)) (outcome-subject o)))

;; subject -> (listof outcome)
(define (outcomes-of subject)
  (cond [(proposal? subject) (list (claim-again 'motion subject))]
        [(inquiry? subject) (list (claim-again 'question subject))]
        [else
         (define first (claim-again 'equal subject))
         (define second (claim-again 'opposite subject))
         (list first (with-both-proved first second subject) (claim-again 'form subject))]))

;; The statement as the library gets it.  One with a number that is not real, perhaps since
;; something has cancelled, is another matter: its values may be complex.
(define (settled s)
  (define-values (left right) (values (folded (statement-left s)) (folded (statement-right s))))
  (when (or (complex-within? left) (complex-within? right)
            (complex-within? (as-handed-over left)) (complex-within? (as-handed-over right)))
    (raise 'rejected))
  (struct-copy statement s [left left] [right right]))

(define (complex-within? e)
  (cond [(pair? e) (ormap complex-within? (cdr e))]
        [else (and (number? e) (not (and (real? e) (rational? e))))]))

;; The outcome of one claim.
(define (claim-again claim subject)
  (guarded claim subject
           (lambda ()
             (case claim
               [(equal) (judged-zero 'equal (settled subject))]
               [(opposite) (judged-zero 'opposite (opposite (settled subject)))]
               [(form) (judged-form (settled subject))]
               [(motion) (judged-motion subject)]
               [(question) (judged-question subject)]))))

;; ---------------------------------------------------------------------------
;; Statements

(define (judged-zero claim s)
  (define-values (left right given) (values (statement-left s) (statement-right s)
                                            (statement-given s)))
  (define a (asked-zero left right given))
  (outcome claim s (answer-status a)
           (case (answer-status a)
             [(proved) (judge-proof left right given (answer-assumptions a) (statement-hints s))]
             [(refuted) (judged-refutation s (answer-witness a))]
             [else #f])
           (if (eq? 'refuted (answer-status a)) (answer-witness a) (answer-assumptions a))))

;; The library cannot know of parts that the constructors cancelled, as in x/x.
(define (judged-refutation s witness)
  (define (judged left right)
    (judge-refutation left right (statement-given s) (statement-hints s) witness))
  (define-values (left right) (values (statement-left s) (statement-right s)))
  (define found (judged left right))
  (if (and (fault? found) (eq? 'no-value-at-witness (fault-kind found)))
      (and (judged (as-handed-over left) (as-handed-over right)) found)
      found))

(define (opposite s)
  (statement (statement-left s) `(- ,(statement-right s)) (statement-given s)
             (statement-hints s)))

;; A statement and its opposite cannot both hold where the right side is not zero.
(define (with-both-proved first second s)
  (define both? (and (eq? 'proved (outcome-answer first)) (eq? 'proved (outcome-answer second))))
  (define numbers
    (and both? (not (wrong? first)) (not (wrong? second))
         (both-nonzero? (statement-left s) (statement-right s) (statement-given s)
                        (statement-hints s))))
  (if numbers
      (struct-copy outcome second [judgement (fault 'opposites-proved numbers #f #f)])
      second))

(define (judged-form s)
  (define-values (simple assumed) (asked-form (statement-left s) (statement-given s)))
  (outcome 'form s 'form
           (judge-simplified (statement-left s) simple (statement-given s) assumed
                             (statement-hints s))
           (cons simple assumed)))

;; ---------------------------------------------------------------------------
;; Motions

(define (judged-motion p)
  (define-values (path force) (values (proposal-path p) (proposal-force p)))
  (define a (asked-solution path force))
  (outcome 'motion p (answer-status a)
           (case (answer-status a)
             [(proved)
              (define kink (kink-near path (proposal-places p)))
              (if kink
                  (fault 'not-smooth (hasheq 't kink) #f #f)
                  (differing-time path force times >))]
             [(refuted) (judged-motionless path force (assq 't (answer-witness a)))]
             [else #f])
           (answer-assumptions a)))

(define times '(1/7 -13/9 31/8 22/3 -25/4))

;; entry : of the time in the witness, or #f where any will do
(define (judged-motionless path force entry)
  (define found
    (for/list ([t (in-list (if entry (list (cdr entry)) times))]
               #:unless (kink-near path (list t)))
      (differing-time path force (list t) <)))
  (and (pair? found) (andmap values found) (car found)))

;; A time at which the residual is greater, or less, than rounding; as a fault.
(define (differing-time path force times compare)
  (for/or ([t (in-list times)])
    (define size (residual-size path force t))
    (and size (compare size 1e-12)
         (fault 'residual (hasheq 't t) size 0))))

;; ---------------------------------------------------------------------------
;; Questions of any kind

(define (judged-question q)
  (define a (asked (inquiry-program q)))
  (define-values (status assumed witness value)
    (values (answer-status a) (answer-assumptions a) (answer-witness a) (answer-value a)))
  (outcome 'question q status
           (judge-matter (inquiry-matter q) status assumed witness value)
           (case status [(refuted) witness] [(found) (cons value assumed)] [else assumed])))

;; ---------------------------------------------------------------------------
;; Guards

;; For one claim.
(define-values (most-seconds most-megabytes) (values 20 1500))

;; In a thread of its own, so that declarations are forgotten and time is limited.  What
;; the constructors refuse, as division by zero, is no claim; questions about systems have none.
(define (guarded claim subject thunk)
  (value-within most-seconds most-megabytes (lambda () (answered claim subject thunk))
                (outcome claim subject 'slow 'open #f)))

(define (answered claim subject thunk)
  (with-handlers ([(no-claim? subject) (lambda (e) (outcome claim subject 'rejected #f #f))]
                  [exn:fail? (lambda (e) (raised claim subject (exn-message e)))])
    (thunk)))

(define ((no-claim? subject) e)
  (or (eq? e 'rejected)
      (and (exn:fail:contract:divide-by-zero? e) (not (about-system? subject)))))

(define (about-system? subject)
  (and (inquiry? subject) (not (eq? 'integral (car (inquiry-matter subject))))))

;; Contradictory declarations, and tan of an angle without one, are the user's mistakes.
(define (raised claim subject message)
  (if (regexp-match? #rx"contradict|assum" message)
      (outcome claim subject 'rejected #f message)
      (outcome claim subject 'raised (fault 'raised #f #f #f) message)))
