#lang racket/base
;; Messages on a relation that cannot be declared or withdrawn.

(require "../algebra/expression/write.rkt"
         "../error/complain.rkt" "../error/message-words.rkt"
         "../generic/describe.rkt")

(provide complaint raise-contradiction raise-not-declared)

;; -> a procedure that complains, of a reason and a part of the relation
;; (algebra/assumption/relation.rkt)
(define ((complaint who relation) reason part)
  (complain who "~a~a" (explain reason part)
            (if (eq? relation part) "" (format "\n  in: ~a" (value->text relation)))))

(define (explain reason part)
  (case reason
    [(form) (format "expected a quoted relation such as '(>= r 0); given ~a"
                    (describe-with-value part))]
    [(operands) (format "the relation lacks an operand: ~a" (value->text part))]
    [(name)
     (format "unknown relation ~a; known are ~a\n  given: ~a~a"
             (value->text (car part)) known-relations (value->text part) (instead part))]
    [(equation)
     (format (string-append "an equation is no assumption about a sign\n  given: ~a\n"
                            "  (impose L '~a) puts it into L, (verify-again verdict '~a) into a "
                            "question")
             (value->text part) (value->text part) (value->text part))]
    [(number) (format "only real numbers are greater or less than others; given ~a" part)]
    [else (format "expected an expression in the relation; given ~a" (describe-with-value part))]))

;; Advice on a relation of an unknown name, a line; or "".
(define (instead d)
  (define name (car d))
  (define (write-as meant) (format "\n  write: ~a" (datum->text meant)))
  (cond [(eq? name 'and) "\n  several relations are arguments of their own, each quoted"]
        [(and (= (length d) 3) (memq (cadr d) '(> >= < <=)))
         (write-as (list (cadr d) name (caddr d)))]
        [(assq name '((positive? . positive) (negative? . negative)))
         => (lambda (entry) (write-as (cons (cdr entry) (cdr d))))]
        [else ""]))

(define known-relations
  (string-append "> >= < <= between expressions, "
                 "and positive, negative, nonpositive, nonnegative before some"))

;; data : relations to be declared; because : relations that cannot all hold
(define (raise-contradiction who data because)
  (define others (filter (lambda (d) (not (member d data))) because))
  (define own (filter (lambda (d) (member d data)) because))
  (cond [(pair? others)
         (complain who "~a contradicts what was assumed: ~a~a" (list-text own) (list-text others)
                   "\n  forget-assumptions withdraws what was assumed")]
        [(= 1 (length own)) (complain who "the relation cannot hold: ~a" (list-text own))]
        [else (complain who "the relations contradict each other: ~a" (list-text own))]))

(define (list-text data) (joined (map datum->text data)))

;; declared : relations that are
(define (raise-not-declared d declared)
  (complain 'forget-assumptions "~a was not declared~a" (datum->text d)
            (if (null? declared)
                "; nothing is"
                (format "\n  declared: ~a" (list-text declared)))))
