#lang racket/base
;; The student's file: the questions as comments, given definitions as they are, and holes to fill.
;; Before it is filled it runs, too, and says that nothing is answered yet.

(require (only-in racket/string string-append* string-join string-split)
         "exercise-kind.rkt" "exercise.rkt" "judgment-words.rkt" "sealed-exercises.rkt"
         "../../show/display/filled-lines.rkt")

(provide worksheet->student-file sealed-pieces)

(define (worksheet->student-file w)
  (string-append
   "#lang mechanics\n"
   (comment (worksheet-title w))
   (if (worksheet-due w) (comment (format "Due: ~a" (worksheet-due w))) "")
   ";; Name: \n;;\n"
   (comment instructions)
   "\n(require mechanics/answers)\n\n"
   (string-join (part-texts w) "\n")
   (closing (exercises-of w))))

(define instructions
  (string-append
   "Put your answers in place of `unanswered`, and press Run: each is proved, refuted with a "
   "point where it fails, or left to your teacher. Symbols such as 'm stand for any number. "
   "A formula may also be a text as on paper, such as \"m x'' + k x = 0\"."))

(define (part-texts w)
  (define numbers (numbered-exercises w))
  (for/list ([p (in-list (worksheet-parts w))] #:unless (formula? p))
    (cond [(passage? p) (comment (passage-text p))]
          [(given? p) (string-append (given-source p) "\n")]
          [else (exercise->text p (hash-ref numbers p))])))

(define (exercise->text e number)
  (define unit (setting e 'unit))
  (string-append
   (comment (format "~a. (~a) ~a" number (points-of e) (exercise-question e)))
   (comment (format "~a~a, as" (kind-says (kind-of-exercise e))
                    (if unit (format " in ~a" unit) "")))
   (format ";;    ~a\n" (answer-form e))
   (if (answer-names e) (comment (answer-names e)) "")
   (format "(define ~a unanswered)\n" (exercise-name e))))

(define (closing exercises)
  (format "\n~a(check-answers\n ~a\n ~a)\n"
          (comment "What follows checks your answers; leave it as it is.")
          (string-join (for/list ([e (in-list exercises)])
                         (format "[~a ~a]" (exercise-name e) (exercise-name e)))
                       "\n ")
          (sealed-pieces exercises)))

;; The envelope, as strings in lines
(define (sealed-pieces exercises)
  (string-join (for/list ([part (in-list (pieces (seal exercises) 90))]) (format "~s" part))
               "\n "))

(define (pieces text size)
  (for/list ([start (in-range 0 (string-length text) size)])
    (substring text start (min (string-length text) (+ start size)))))

;; ---------------------------------------------------------------------------

(define columns 92)

;; Paragraphs as comments; an empty line is one, too.
(define (comment text)
  (string-append*
   (for*/list ([paragraph (in-list (regexp-split #rx"\n" text))]
               [words (in-value (string-split paragraph))]
               [line (in-list (if (null? words) '("") (filled words columns)))])
     (format ";; ~a\n" line))))
