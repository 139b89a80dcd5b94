#lang racket/base
;; Answers as data, and back.
;;
;; The student's program applies an answer to the symbols that its kind prescribes, and writes
;; down the value; the judge reads that as an expression, and never runs it.  An answer as data
;; is a list:
;;
;;   (answer datum)   (text "...")   (unanswered)   (failed "why")
;;
;; A text is a sentence, or a formula as on paper, which the judge reads (written-answer.rkt).

(require (only-in racket/list append*)
         (only-in racket/string string-trim)
         "answer-bounds.rkt"
         "../../algebra/expression/expression.rkt"
         "../../error/complain.rkt" "../../error/message-words.rkt"
         "../../generic/describe.rkt" "../../generic/function.rkt"
         (only-in "../../generic/irrational.rkt" irrational?) "../../generic/up-down.rkt"
         "../../value/matrix/matrix.rkt" "../../value/read-expression.rkt" "../../value/shape.rkt")

(provide unanswered answer->datum text-answer->datum datum->answer longest-text)

;; The value of a hole in a student's file.
(struct no-answer ()
  #:property prop:custom-write (lambda (x port mode) (write-string "unanswered" port)))
(define unanswered (no-answer))
(define (unanswered? x) (eq? x unanswered))

(define longest-text 4000)

;; rounds : lists of arguments, to which x is applied one after the other.  An error that x itself
;; raises is data, too.
(define (answer->datum x rounds)
  (cond [(or (unanswered? x) (void? x)) '(unanswered)]
        [else (with-handlers ([exn:fail? (lambda (e) (list 'failed (exn-message e)))])
                (applied x rounds))]))

(define (applied x rounds)
  (define value (apply-rounds x rounds))
  (define d (and (value? value) (value->datum value)))
  (define why (if d (why-not-an-answer d) (not-a-value value)))
  (cond [(string? value) (text-answer->datum value)]
        [(and (pair? value) (list? value) (andmap string? value))
         (text-answer->datum (joined value))]
        [why (list 'failed why)]
        [else (list 'answer d)]))

(define (text-answer->datum x)
  (cond [(unanswered? x) '(unanswered)]
        [(not (string? x)) '(failed "it is no text; a text stands in quotation marks")]
        [(string=? "" (string-trim x)) '(unanswered)]
        [(> (string-length x) longest-text)
         (list 'failed (format "it has more than ~a characters" longest-text))]
        [else (list 'text x)]))

;; The value of a datum, which anybody may have written.
(define (datum->answer d)
  (define why (why-not-an-answer d))
  (when why (complain 'answer "~a" why))
  (read-expression d))

;; ---------------------------------------------------------------------------
;; Application

;; An expression in the symbols themselves is its own value; a function may take all arguments at
;; once.
(define (apply-rounds f rounds)
  (cond [(or (null? rounds) (not (function? f))) f]
        [(accepts? f (length (car rounds))) (apply-rounds (apply f (car rounds)) (cdr rounds))]
        [(accepts? f (length (append* rounds))) (apply f (append* rounds))]
        [else (complain 'answer "the function takes ~a; here it is applied to ~a"
                        (arity->text f) (joined (map value->text (car rounds)) " and "))]))

;; Tuples are procedures, too; a tuple of expressions is a value.
(define (function? x)
  (if (tuple? x)
      (ormap function? (scalars x))
      (procedure? x)))

(define (value? x)
  (or (matrix? x) (for/and ([e (in-list (scalars x))]) (or (expression? e) (irrational? e)))))

(define (not-a-value x)
  (cond [(and (procedure? x) (not (tuple? x)))
         "it is a function where an expression is expected: it takes one argument more"]
        [(list? x) "it is a list; what has components is a tuple, (up 1 2)"]
        [else (format "it is ~a" (describe x))]))
