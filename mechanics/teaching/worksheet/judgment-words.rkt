#lang racket/base
;; Judgments in words.

(require (only-in racket/string string-join)
         "exercise-kind.rkt" "exercise.rkt" "judgment.rkt"
         (only-in "../../error/message-words.rkt" joined)
         "../../generic/describe.rkt"
         "../../verdict/verdict.rkt")

(provide status->words judgment->text evidence-lines points->text points-of counted-points
         number->text)

;; j : a judged answer, throughout

(define (status->words status)
  (case status
    [(right) "right"]
    [(partly) "partly right"]
    [(wrong) "refuted"]
    [(trivial) "true, but trivial"]
    [(undecided) "undecided"]
    [(unanswered) "not answered"]
    [(failed) "no answer could be had"]
    [(marked) "marked by the teacher"]
    [else "kept for the teacher"]))

;; whole? : with the whole verdict, or without the lines that would show the key
;; hints  : strings
(define (judgment->text j #:whole? [whole? #f] #:hints [hints '()])
  (string-join
   (append
    (list (format "~a: ~a~a" (judged-name j) (headline j) (points->text j)))
    (map indented (append (judgment-words (judged-judgment j)) (evidence-lines j whole?)
                          (for/list ([h (in-list hints)]) (string-append "hint: " h)))))
   "\n"))

(define (headline j)
  (define status (judged-status j))
  (cond [(and (eq? status 'right) (judgment-verdict (judged-judgment j))) "proved"]
        [(eq? status 'undecided)
         "undecided; it does not count as wrong, your teacher will look at it"]
        [else (status->words status)]))

(define (indented text)
  (string-append "   " (regexp-replace* #rx"\n" text "\n   ")))

(define (points->text j)
  (define-values (e got) (values (judged-exercise j) (judged-points j)))
  (if (and got (positive? (exercise-points e)))
      (format " (~a of ~a)" (number->text got) (points-of e))
      ""))

;; "1 point", "2.5 points"
(define (points-of e) (counted-points (exercise-points e)))
(define (counted-points n) (if (= n 1) "1 point" (string-append (number->text n) " points")))

;; With at most two decimals: 3/2 is "1.5".
(define (number->text x)
  (if (integer? x)
      (number->string (inexact->exact x))
      (regexp-replace #rx"[.]?0+$" (real->decimal-string x 2) "")))

;; ---------------------------------------------------------------------------
;; Evidence

;; Lines of text.  The residual and its value would give away the key: one could subtract.
(define (evidence-lines j whole?)
  (define v (judgment-verdict (judged-judgment j)))
  (cond [(not v) '()]
        [(or whole? (kind-open? (kind-of-exercise (judged-exercise j))))
         (regexp-split #rx"\n" (format "~a" v))]
        [(proved? v)
         (for/list ([a (in-list (verdict-assumptions v))]) (format "assuming ~a" (value->text a)))]
        [else (filter values (list (witness-line v) (condition-line v)))]))

;; -> text, or #f without a witness
(define (witness-line v)
  (define point (or (verdict-witness v) '()))
  (and (pair? point)
       (string-append
        "it fails at "
        (joined (for/list ([p (in-list point)])
                  (format "~a = ~a" (value->text (car p)) (value->text (cdr p))))))))

;; -> text, or #f without a condition
(define (condition-line v)
  (define alternatives (verdict-alternatives v))
  (and (pair? alternatives)
       (string-append
        "it would hold if "
        (joined (for/list ([c (in-list (car alternatives))])
                  (format "~a ~a ~a" (value->text (cadr c)) (car c) (value->text (caddr c))))
                " and "))))
