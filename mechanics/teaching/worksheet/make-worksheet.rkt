#lang racket/base
;; A worksheet made of its parts, and tried: its own keys are judged as answers, and so is
;; every slip.  A wrong key would be unjust to a whole class.

(require racket/list
         "answer-data.rkt" "answer-parts.rkt" "defined-names.rkt" "exercise-kind.rkt"
         "exercise.rkt" "judge.rkt"
         "judgment-words.rkt" "judgment.rkt" "prescribed-symbols.rkt"
         "../../error/complain.rkt" "../../error/message-words.rkt"
         "../../generic/describe.rkt"
         "../../lagrangian/Lagrange-equations.rkt"
         "../../value/read-expression.rkt")

(provide make-worksheet trying-keys? outline)

;; #f where a worksheet that was tried is made again for a student.
(define trying-keys? (make-parameter #t))

(define (make-worksheet title due name parts)
  (define w (worksheet title due name (with-given-numbers parts)))
  (define all (exercises-of w))
  (define twice (check-duplicates (map exercise-name all)))
  (unless title (complain 'worksheet "it has no title, as in (title \"Small oscillations\")"))
  (when (null? all) (complain 'worksheet "it has no exercise"))
  (when twice (complain 'worksheet "two exercises are called ~a" twice))
  (check-names all (filter given? parts))
  (when (trying-keys?) (for-each try-exercise all))
  w)

;; A text may use the numbers that are given by their names.
(define (with-given-numbers parts)
  (define given-numbers
    (append-map (lambda (g) (defined-numbers (given-source g))) (filter given? parts)))
  (define (informed e)
    (struct-copy exercise e
                 [settings (hash-set (exercise-settings e) 'given-numbers given-numbers)]))
  (if (null? given-numbers)
      parts
      (for/list ([p (in-list parts)]) (if (exercise? p) (informed p) p))))

;; Given definitions and answers must have different names: the student's file holds both.
(define (check-names exercises givens)
  (define names (append-map defined-names (map given-source givens)))
  (for ([e (in-list exercises)] #:when (memq (exercise-name e) names))
    (complain (exercise-name e)
              "what is given has that name already; call the exercise otherwise")))

(define (try-exercise e)
  (define key (exercise-key e))
  (when key
    (try-key e key)
    (when (and (setting e 'system) (eq? (exercise-kind e) 'equations))
      (try-key (with-key-of-system e) key)))
  (for ([s (in-list (exercise-slips e))]) (try-slip e s)))

(define (judgment-on e datum) (judge e (list 'answer datum)))

(define (try-key e key)
  (define j (judgment-on e key))
  (define problem
    (case (judgment-status j)
      [(right) #f]
      [(undecided) "cannot be proved right, so no answer could be"]
      [else "is refuted"]))
  (when problem
    (complain (exercise-name e) "its own key ~a\n~a" problem
              (judgment->text (judged e key j) #:whole? #t))))

;; Equations that are given with their Lagrangian must agree with it.
(define (with-key-of-system e)
  (define names (exercise-coordinates e))
  (define L (value-function (read-expression (setting e 'system)) (local-tuple-of names)))
  (define right (answer->datum (Lagrange-equations L) (rounds-of e)))
  (struct-copy exercise e [key (cadr right)]))

(define (try-slip e s)
  (define j (judgment-on (struct-copy exercise e [slips '()]) (slip-datum s)))
  (when (eq? (judgment-status j) 'right)
    (complain (exercise-name e) "what is given as a slip is a right answer\n  slip: ~a"
              (value->text (slip-datum s)))))

;; -> text
(define (outline w)
  (define all (exercises-of w))
  (joined
   (cons (format "~a: ~a, ~a; all keys hold." (worksheet-title w)
                 (counted (length all) "exercise")
                 (counted-points (total-points all)))
         (for/list ([e (in-list all)] [i (in-naturals 1)])
           (format "  ~a. ~a (~a), ~a" i (exercise-name e) (exercise-kind e) (points-of e))))
   "\n"))
