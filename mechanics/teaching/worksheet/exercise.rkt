#lang racket/base
;; What a worksheet consists of.
;;
;; Everything in an exercise is data, values being kept as the S-expressions they print as: so
;; the same exercise is judged in the teacher's program, in the student's, and in a class.

(provide (struct-out worksheet) (struct-out passage) (struct-out given) (struct-out formula)
         (struct-out exercise) (struct-out slip) (struct-out hint)
         exercises-of setting total-points)

;; parts : passages, givens, formulas and exercises, in their order
(struct worksheet (title due name parts) #:transparent)

(struct passage (text) #:transparent)
;; Definitions that the student gets, as they are written.
(struct given (source) #:transparent)
;; A value to be shown on the hand-out; label : text before it
(struct formula (label value) #:transparent)

;; name        : symbol, what the answer is to be defined as
;; kind        : symbol, of exercise-kind.rkt
;; coordinates : list of symbols
;; settings    : hasheq of data, what the clauses of the exercise say
;; key         : datum of the right answer, or #f
;; practice?   : may the student's own copy hold the key?
(struct exercise (name kind question coordinates settings key points slips hints practice?)
  #:prefab)

;; A mistake with a message of its own; credit : share of the points
(struct slip (datum message credit) #:prefab)
;; after : how many wrong answers come first
(struct hint (text after) #:prefab)

(define (exercises-of w) (filter exercise? (worksheet-parts w)))
(define (setting e name [otherwise #f]) (hash-ref (exercise-settings e) name otherwise))
(define (total-points w) (for/sum ([e (in-list (exercises-of w))]) (exercise-points e)))
