#lang racket/base
;; Judgments in words.

(require racket/list
         (only-in racket/string string-join)
         "exercise-kind.rkt" "exercise.rkt" "judgment.rkt"
         (only-in "../../error/message-words.rkt" joined)
         "../../generic/describe.rkt"
         "../../verdict/verdict.rkt")

(provide status->words judgment->text evidence-lines points->text points-of counted-points
         number->text)

(define (status->words status)
  (case status
    [(right) "right"]
    [(partly) "partly right"]
    [(wrong) "refuted"]
    [(trivial) "true, but trivial"]
    [(undecided) "undecided"]
    [(unanswered) "not answered"]
    [(failed) "no answer could be had"]
    [else "kept for the teacher"]))

;; whole? : with all that the verdict says, or only with what leaves the key unseen
;; hints  : strings
(define (judgment->text e j #:whole? [whole? #f] #:hints [hints '()])
  (string-join
   (append
    (list (format "~a: ~a~a" (exercise-name e) (headline j) (points->text e j)))
    (map indented (append (judgment-words j) (evidence-lines e j whole?)
                          (for/list ([h (in-list hints)]) (string-append "hint: " h)))))
   "\n"))

(define (headline j)
  (define v (judgment-verdict j))
  (define words (status->words (judgment-status j)))
  (cond [(and (eq? (judgment-status j) 'right) v) "proved"]
        [(eq? (judgment-status j) 'undecided)
         "undecided; it does not count as wrong, your teacher will look at it"]
        [else words]))

(define (indented text)
  (string-append "   " (regexp-replace* #rx"\n" text "\n   ")))

(define (points->text e j)
  (define got (judgment-points j (exercise-points e)))
  (if (and got (positive? (exercise-points e)))
      (format " (~a of ~a)" (number->text got)
              (points-of e))
      ""))

;; "1 point", "2.5 points"
(define (points-of e) (counted-points (exercise-points e)))
(define (counted-points n) (if (= n 1) "1 point" (string-append (number->text n) " points")))

;; 3/2 as 1.5, and what has more decimals to two of them.
(define (number->text x)
  (if (integer? x)
      (number->string (inexact->exact x))
      (regexp-replace #rx"[.]?0+$" (two-decimals x) "")))

(define (two-decimals x)
  (define hundredths (inexact->exact (round (* 100 x))))
  (define-values (whole part) (quotient/remainder hundredths 100))
  (format "~a.~a~a" whole (quotient part 10) (remainder part 10)))

;; ---------------------------------------------------------------------------
;; Evidence

;; Lines of text.  The residual and its value would tell the key to whoever subtracts.
(define (evidence-lines e j whole?)
  (define v (judgment-verdict j))
  (cond [(not v) '()]
        [(or whole? (kind-open? (kind-of-exercise e))) (regexp-split #rx"\n" (format "~a" v))]
        [(proved? v)
         (for/list ([a (in-list (verdict-assumptions v))]) (format "assuming ~a" (value->text a)))]
        [else (append (witness-line v) (condition-line v))]))

(define (witness-line v)
  (define point (or (verdict-witness v) '()))
  (if (null? point)
      '()
      (list (string-append
         "it fails at "
             (joined (for/list ([p (in-list point)])
                       (format "~a = ~a" (value->text (car p)) (value->text (cdr p)))))))))

(define (condition-line v)
  (define ways (verdict-alternatives v))
  (if (null? ways)
      '()
      (list (string-append "it would hold if "
                           (joined (for/list ([c (in-list (first ways))])
                                     (format "~a ~a ~a" (value->text (cadr c)) (car c)
                                             (value->text (caddr c))))
         " and ")))))
