#lang racket/base
;; Worksheets and their parts.
;;
;; An exercise holds data alone, values as the S-expressions that they print as: so the same
;; exercise is judged in the teacher's program, in the student's, and in a class.

(provide (struct-out worksheet) (struct-out passage) (struct-out deadline)
         (struct-out given) (struct-out numbers) (struct-out formula)
         (struct-out exercise) (struct-out slip) (struct-out hint)
         exercises-of deadline-of numbers-of numbered-exercises setting total-points)

;; parts : passages, givens, formulas and exercises, in their order
(struct worksheet (title due name parts) #:transparent)

(struct passage (text) #:transparent)
;; seconds : since 1970; grace : minutes that do not count; per-day : share of the points that a day
;; costs, or #f; days : after which nothing counts, or #f.  The text says all that to the student.
(struct deadline passage (seconds grace per-day days) #:transparent)
;; Definitions for the student, as the teacher wrote them.
(struct given (source) #:transparent)
;; Definitions of numbers that are the student's own; student : a name, or #f
(struct numbers given (student) #:transparent)
;; A value to be shown on the hand-out; label : text before it
(struct formula (label value) #:transparent)

;; name        : symbol, under which the student defines the answer
;; kind        : symbol, of exercise-kind.rkt
;; coordinates : list of symbols
;; settings    : hasheq of data, from the clauses of the exercise
;; key         : datum of the right answer, or #f
;; practice?   : may the student's own copy hold the key?
(struct exercise (name kind question coordinates settings key points slips hints practice?)
  #:prefab)

;; A mistake with a message of its own; credit : share of the points
(struct slip (datum message credit) #:prefab)
;; after : number of wrong answers that come first
(struct hint (text after) #:prefab)

(define (exercises-of w) (filter exercise? (worksheet-parts w)))
(define (deadline-of w) (findf deadline? (worksheet-parts w)))
(define (numbers-of w) (findf numbers? (worksheet-parts w)))

;; -> hasheq, from the exercises to their numbers
(define (numbered-exercises w)
  (for/hasheq ([e (in-list (exercises-of w))] [i (in-naturals 1)]) (values e i)))

(define (setting e name [otherwise #f]) (hash-ref (exercise-settings e) name otherwise))
(define (total-points exercises) (apply + (map exercise-points exercises)))
