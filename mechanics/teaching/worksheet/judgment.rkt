#lang racket/base
;; What is found about an answer.

(provide (struct-out judgment) right wrong partly undecided-judgment trivial judged-by
         with-message judgment-points)

;; status  : right, partly, wrong, trivial, undecided, unanswered, failed, kept
;; share   : of the points, from 0 to 1; #f where a person has to say
;; verdict : or #f
;; words   : strings, what there is to say, first things first
(struct judgment (status share verdict words) #:transparent)

(define (right v . words) (judgment 'right 1 v words))
(define (wrong v . words) (judgment 'wrong 0 v words))
(define (trivial v . words) (judgment 'trivial 0 v words))
(define (undecided-judgment v . words) (judgment 'undecided #f v words))
(define (partly share v . words)
  (judgment (if (eqv? share 0) 'wrong 'partly) share v words))

;; status : of a verdict; share : -> what part of it is right
(define (judged-by status v share . words)
  (case status
    [(proved) (judgment 'right 1 v words)]
    [(undecided) (judgment 'undecided #f v words)]
    [else (apply partly (share) v words)]))

;; One thing more to say, before the others.
(define (with-message j text)
  (struct-copy judgment j [words (cons text (judgment-words j))]))

;; -> number, or #f
(define (judgment-points j points)
  (and (judgment-share j) (* points (judgment-share j))))
