#lang racket/base
;; Answers that are compared with the key: expressions, functions, numbers, Hamiltonians.

(require (only-in racket/list count)
         "answer-parts.rkt" "decimal-answers.rkt" "exercise.rkt" "judgment.rkt"
         "prescribed-symbols.rkt" "question-names.rkt"
         (only-in "../../error/message-words.rkt" joined)
         "../../calculus/derivative.rkt"
         "../../generic/arithmetic.rkt" "../../generic/describe.rkt"
         "../../value/shape.rkt" "../../value/structure.rkt"
         "../../verdict/prove-zero.rkt" "../../verdict/verdict.rkt")

(provide judge-value judge-number judge-Hamiltonian
         ;; for slips
         within?)

;; Equal to the key; of a tuple each component counts by itself.  Decimals are right as far as they
;; tell.
(define (judge-value e key answer)
  (cond [(not (alike? key answer))
         (wrong #f (format "the answer is ~a where ~a is expected" (describe answer)
                           (describe key)))]
        [else
         (define v (verify-equal answer key))
         (if (or (proved? v) (not (ormap has-decimals? (append (scalars key) (scalars answer)))))
             (judged-by v share-proved)
             (judge-decimals e v (scalars key) (scalars answer)))]))

(define (judge-decimals e v ks as)
  (define tolerance (setting e 'within usual-tolerance))
  (define near (count (lambda (k a) (decimals-agree? k a tolerance)) ks as))
  (if (= near (length ks))
      (right #f (format "as far as decimals tell, within ~a %" (value->text (* 100 tolerance))))
      (partly (/ near (length ks)) (and (refuted? v) v))))

(define usual-tolerance 1/100)

;; Within a relative tolerance of the key; absolute, where the key is 0 or the question says so.
(define (judge-number e key answer)
  (define-values (k a) (values (real-value key) (real-value answer)))
  (define names (if a '() (unknown-names answer '())))
  (cond [(pair? names) (unreadable (number-wanted names (setting e 'unit)))]
        [(not a) (wrong #f (format "the answer is no number: ~a" (value->text answer)))]
        [(within? e k a) (right #f)]
        [else (wrong #f)]))

(define (within? e k a)
  (define tolerance (setting e 'within usual-tolerance))
  (define least (if (or (setting e 'absolute) (zero? k)) 1 (abs k)))
  (<= (abs (- a k)) (* tolerance least)))

;; Names in a number are a unit, or symbols that the student has numbers for.
(define (number-wanted names unit)
  (format "it has ~a in it: give the number alone~a" (joined (map symbol->string names))
          (if unit (format ", in ~a" unit) "")))

;; Equal but for a function of the time, which no equation sees.
(define (judge-Hamiltonian e key answer)
  (define state (state-of (exercise-coordinates e)))
  (cond
    [(not (alike? key answer)) (judge-value e key answer)]
    [else
     (define difference (value-function (g:- answer key) state))
     (define gradient
       (list->up (append (scalars (((partial 1) difference) state))
                         (scalars (((partial 2) difference) state)))))
     (define v (verify-equal answer key))
     (cond [(proved? v) (right v)]
           [else
            (define by-time-alone (prove-zero gradient #:variables (scalars state)))
            (if (proved? by-time-alone)
                (right by-time-alone "it differs by a term that no equation of motion sees")
                (judged-by v (lambda (_) 0)))])]))
