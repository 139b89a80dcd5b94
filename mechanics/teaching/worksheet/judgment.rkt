#lang racket/base
;; Judgments on answers.

(require "exercise.rkt"
         "../../verdict/verdict.rkt")

(provide (struct-out judgment) right wrong partly undecided-judgment trivial unreadable judged-by
         (struct-out judged) judged-name judged-status wanting? judged-points sum-of-points)

;; status  : right, partly, wrong, trivial, undecided, unanswered, failed, kept; or marked, by hand
;; share   : of the points, from 0 to 1; #f where a person has to say
;; verdict : or #f
;; words   : strings, the most important first
(struct judgment (status share verdict words) #:transparent)

;; An answer, as data (answer-data.rkt), with the judgment on it.
(struct judged (exercise answer judgment) #:transparent)

(define (right v . words) (judgment 'right 1 v words))
(define (wrong v . words) (judgment 'wrong 0 v words))
(define (trivial v . words) (judgment 'trivial 0 v words))
(define (unreadable why) (judgment 'failed 0 #f (list why)))
(define (undecided-judgment v . words) (judgment 'undecided #f v words))
(define (partly share v . words)
  (judgment (if (eqv? share 0) 'wrong 'partly) share v words))

;; v : a verdict; share : residual of v -> the share of the points that a refuted answer gets
(define (judged-by v share . words)
  (case (verdict-status v)
    [(proved) (apply right v words)]
    [(undecided) (apply undecided-judgment v words)]
    [else (apply partly (share (verdict-residual v)) v words)]))

;; ---------------------------------------------------------------------------
;; Judged answers

(define (judged-name x) (exercise-name (judged-exercise x)))
(define (judged-status x) (judgment-status (judged-judgment x)))

;; Is the answer not right, and known to be so?
(define (wanting? x) (memq (judged-status x) '(wrong partly trivial)))

;; -> number, or #f where a person has to say
(define (judged-points x)
  (define share (judgment-share (judged-judgment x)))
  (and share (* share (exercise-points (judged-exercise x)))))

;; The points, as far as they are known.
(define (sum-of-points all) (for/sum ([x (in-list all)]) (or (judged-points x) 0)))
