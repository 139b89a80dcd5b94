#lang racket/base
;; A worksheet made of its parts, and tried: its own keys are judged as answers, and so is
;; every slip.  What is refused here would have been unjust to a whole class.

(require racket/list
         "answer-data.rkt" "answer-parts.rkt" "defined-names.rkt" "exercise-kind.rkt"
         "exercise.rkt" "judge.rkt"
         "judgment-words.rkt" "judgment.rkt" "prescribed-symbols.rkt"
         "../../error/complain.rkt" "../../error/message-words.rkt"
         "../../generic/describe.rkt"
         "../../lagrangian/Lagrange-equations.rkt"
         "../../value/read-expression.rkt")

(provide make-worksheet outline)

(define (make-worksheet title due name parts)
  (define w (worksheet title due name parts))
  (define all (exercises-of w))
  (define twice (check-duplicates (map exercise-name all)))
  (unless title (complain 'worksheet "it has no title, as in (title \"Small oscillations\")"))
  (when (null? all) (complain 'worksheet "it has no exercise"))
  (when twice (complain 'worksheet "two exercises are called ~a" twice))
  (check-names all (filter given? parts))
  (for-each try-exercise all)
  w)

;; The students' file would define such a name twice.
(define (check-names exercises givens)
  (define names (append-map defined-names (map given-source givens)))
  (for ([e (in-list exercises)] #:when (memq (exercise-name e) names))
    (complain (exercise-name e)
              "what is given has that name already; call the exercise otherwise")))

(define (try-exercise e)
  (define key (exercise-key e))
  (when key
    (try-key e (judge e (list 'answer key)))
    (when (setting e 'system) (try-with-system e key)))
  (for ([s (in-list (exercise-slips e))]) (try-slip e s)))

(define (try-key e j)
  (case (judgment-status j)
    [(right) (void)]
    [(undecided)
     (complain (exercise-name e)
         "its own key cannot be proved right, so no answer could be\n~a" (told e j))]
    [else (complain (exercise-name e) "its own key is refuted\n~a" (told e j))]))

;; Equations are given with their Lagrangian: do they go together?
(define (try-with-system e key)
  (when (eq? (exercise-kind e) 'equations)
    (define names (exercise-coordinates e))
    (define L (value-function (read-expression (setting e 'system)) (local-tuple-of names)))
    (define right (answer->datum (Lagrange-equations L) (rounds-of e)))
    (try-key e (judge (struct-copy exercise e [key (cadr right)]) (list 'answer key)))))

(define (try-slip e s)
  (define j (judge (struct-copy exercise e [slips '()]) (list 'answer (slip-datum s))))
  (when (eq? (judgment-status j) 'right)
    (complain (exercise-name e) "what is given as a slip is a right answer\n  slip: ~a"
              (value->text (slip-datum s)))))

(define (told e j) (judgment->text e j #:whole? #t))

;; -> text
(define (outline w)
  (define all (exercises-of w))
  (joined
   (cons (format "~a: ~a, ~a; all keys hold." (worksheet-title w)
                 (counted (length all) "exercise")
                 (counted-points (total-points w)))
         (for/list ([e (in-list all)] [i (in-naturals 1)])
           (format "  ~a. ~a (~a), ~a" i (exercise-name e) (exercise-kind e) (points-of e))))
   "\n"))
