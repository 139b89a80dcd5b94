#lang racket/base
;; The judgment on an answer.
;;
;; A wrong answer is compared with the slips that the teacher foresaw, by the same judgment with
;; the slip in place of the key; then with common ones (common-slips.rkt).

(require "answer-data.rkt" "answer-parts.rkt" "common-slips.rkt" "decimal-answers.rkt"
         "exercise.rkt" "exercise-kind.rkt"
         "judge-equations.rkt" "judge-questions.rkt" "judge-values.rkt" "judgment.rkt"
         "question-names.rkt" "written-answer.rkt"
         "../../error/failure.rkt" "../../error/message-words.rkt"
         (only-in "../../generic/describe.rkt" value->datum)
         "../../value/assumptions.rkt" "../../value/read-expression.rkt"
         "../../verdict/verdict.rkt")

(provide judge)

;; d : the answer as data (answer-data.rkt).  Only the exercise's own assumptions hold here.
(define (judge e d)
  (case (car d)
    [(unanswered) (judgment 'unanswered 0 #f '())]
    [(failed) (judgment 'failed 0 #f (cdr d))]
    [(text) (if (eq? (exercise-kind e) 'reason)
                (judgment 'kept #f #f '())
                (judge-written e (read-written-answer e (cadr d))))]
    [else (if (keyless? e) (judgment 'kept #f #f '()) (judge-datum e (cadr d)))]))

;; A formula as on paper is judged as it was read, which is told.
(define (judge-written e d)
  (define j (judge e d))
  (if (eq? 'answer (car d))
      (struct-copy judgment j
                   [words (append (judgment-words j) (list (reading-told e (cadr d))))])
      j))

(define (reading-told e d)
  (string-append "read as " (formula-read (exercise-coordinates e) d)))

;; The student's copy may lack the key.
(define (keyless? e)
  (if (eq? (exercise-kind e) 'expects)
      (not (setting e 'check))
      (not (exercise-key e))))

;; A datum that is no expression is the student's mistake; an error after it was read may be the
;; teacher's or ours, and the answer is left to a person.
(define (judge-datum e d)
  (define answer
    (with-handlers ([exn:fail? (lambda (x) (unreadable (exn-message x)))])
      (datum->answer d)))
  (if (judgment? answer) answer (judge-answer e answer)))

(define (judge-answer e answer)
  (with-handlers ([exn:fail? not-judged])
    (call-assuming (setting e 'assuming '())
                   (lambda () (with-slips e answer (judge-by-key e (exercise-key e) answer))))))

(define (not-judged x)
  (undecided-judgment #f (string-append "it could not be judged: " (exn-message x))))

;; key : a datum.  Cases that decimals leave undecided are judged with the exact numbers meant.
(define (judge-by-key e key answer)
  (define j (judge-once e key answer))
  (define (exact d) (with-exact-decimals d))
  (define again
    (and (eq? 'undecided (judgment-status j))
         (judge-once (with-exact-settings e) (exact key)
                     (read-expression (exact (value->datum answer))))))
  (if (and again (eqv? 1 (judgment-share again))) again j))

(define (with-exact-settings e)
  (struct-copy exercise e
               [settings (for/hasheq ([(name d) (in-hash (exercise-settings e))])
                           (values name (with-exact-decimals d)))]))

;; A failure of the mathematics leaves the answer undecided.
(define (judge-once e key answer)
  (define judge-it
    (case (exercise-kind e)
      [(number) judge-number]
      [(equations) judge-equations]
      [(Lagrangian) judge-Lagrangian]
      [(solution) judge-solution]
      [(conserved) judge-conserved]
      [(Hamiltonian) judge-Hamiltonian]
      [(canonical) judge-canonical]
      [(expects) judge-as-expected]
      [else judge-value]))
  (with-handlers ([exn:fail:mechanics? (lambda (x) (undecided-judgment #f (exn-message x)))])
    (as-asked e answer (judge-it e (and key (read-expression key)) answer))))

;; A trivial answer with names that the question lacks is wrong.
(define (as-asked e answer j)
  (if (and (eq? 'trivial (judgment-status j)) (names-not-asked-for e answer)) (wrong #f) j))

;; By the teacher's own procedure, which gives a verdict or a truth value.
(define (judge-as-expected e key answer)
  (define found ((setting e 'check) answer))
  (cond [(verdict? found) (judged-by found (lambda (_) 0))]
        [found (right #f)]
        [else (wrong #f)]))

;; ---------------------------------------------------------------------------
;; Slips

;; The judgment j, with the slip that explains it; j itself if a slip cannot be compared.
(define (with-slips e answer j)
  (define status (judgment-status j))
  (with-handlers ([exn:fail? (lambda (x) j)])
    (cond [(not (memq status '(wrong partly trivial))) j]
          [(foreseen-slip e answer)
           => (lambda (s) (with-message (with-share j (slip-credit s)) (slip-message s)))]
          [(and (not (eq? status 'trivial)) (common-slip e answer))
           => (lambda (text)
                (define credit (hash-ref (setting e 'credit (hasheq)) (slip-sort text) 0))
                (with-message (with-share j credit) text))]
          [else j])))

;; The share of the points is `least` or more.
(define (with-share j least)
  (define share (max (judgment-share j) least))
  (struct-copy judgment j [status (if (> share 0) 'partly (judgment-status j))] [share share]))

;; The message stands before the other words.
(define (with-message j text)
  (struct-copy judgment j [words (cons text (judgment-words j))]))

(define (foreseen-slip e answer)
  (findf (lambda (s) (slipped? e s answer)) (exercise-slips e)))

;; Motions, integrals and maps are judged without the key; as slips they are compared.
(define (slipped? e s answer)
  (case (exercise-kind e)
    [(solution conserved canonical expects) (same? (read-expression (slip-datum s)) answer)]
    [else (right-by-key? e (slip-datum s) answer)]))

(define (right-by-key? e key answer)
  (eq? 'right (judgment-status (judge-by-key e key answer))))

(define (common-slip e answer)
  (define key (and (exercise-key e) (read-expression (exercise-key e))))
  (define names (exercise-coordinates e))
  ;; a key that is refuted has no slip in it that we know
  (case (if (and key (same? key answer)) 'key (exercise-kind e))
    [(key reason expects) #f]
    [(number) (numeric-slip e key answer)]
    [(equations)
     (or (slip-of-equations names (along-path->symbols key names)
                            (along-path->symbols answer names)
                            (lambda (x) (right-by-key? e (exercise-key e) x)))
         (names-not-asked-for e answer))]
    [else (or (slip-of-values key answer) (names-not-asked-for e answer))]))

(define (numeric-slip e key answer)
  (define-values (k a) (values (real-value key) (real-value answer)))
  (and k a (slip-of-number k a (lambda (x y) (within? e x y)))))

;; A misspelt name is the commonest mistake.
(define (names-not-asked-for e answer)
  (define usual
    (append (setting e 'constants '()) (setting e 'arguments '()) (setting e 'names '())
            (prescribed-names (exercise-coordinates e))))
  (define found (unknown-names answer usual))
  (define told (joined (map symbol->string found)))
  (define velocity (and (ormap like-velocity? found) (velocity-told e)))
  (cond [(null? found) #f]
        [velocity
         (format "~a ~a for nothing here; ~a" told (if (null? (cdr found)) "stands" "stand")
                 velocity)]
        [else (format "it has ~a in it, of which the question does not speak" told)]))

;; Is it v, vx or v_x?
(define (like-velocity? name) (regexp-match? #rx"^v(.|_.*)?$" (symbol->string name)))
