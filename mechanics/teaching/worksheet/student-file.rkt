#lang racket/base
;; The student's file: the questions as comments, what is given as it is, and holes to fill.
;; It runs as it is, and says that nothing is answered yet.

(require racket/list
         (only-in racket/string string-join string-split)
         "exercise-kind.rkt" "exercise.rkt" "judgment-words.rkt" "sealed-exercises.rkt")

(provide worksheet->student-file)

(define (worksheet->student-file w)
  (string-append
   "#lang mechanics\n"
   (comment (worksheet-title w))
   (if (worksheet-due w) (comment (format "Due: ~a" (worksheet-due w))) "")
   ";; Name: \n;;\n"
   (comment instructions)
   "\n(require mechanics/answers)\n\n"
   (string-join (parts->texts (worksheet-parts w)) "\n")
   (closing (exercises-of w))))

(define instructions
  (string-append
   "Put your answers in place of `unanswered`, and press Run: each is proved, refuted with a "
   "point where it fails, or left to your teacher. Symbols such as 'm stand for any number."))

(define (parts->texts parts)
  (define numbers (make-hasheq))
  (for ([e (in-list (filter exercise? parts))] [i (in-naturals 1)]) (hash-set! numbers e i))
  (for/list ([p (in-list parts)] #:unless (formula? p))
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
   (format "(define ~a unanswered)\n" (exercise-name e))))

(define (closing exercises)
  (format "\n~a(check-answers\n ~a\n ~a)\n"
          (comment "What follows checks your answers; leave it as it is.")
          (string-join (for/list ([e (in-list exercises)])
                         (format "[~a ~a]" (exercise-name e) (exercise-name e)))
                       "\n ")
          (string-join (for/list ([part (in-list (pieces (seal exercises) 90))]) (format "~s" part))
                       "\n ")))

(define (pieces text length)
  (for/list ([start (in-range 0 (string-length text) length)])
    (substring text start (min (string-length text) (+ start length)))))

;; ---------------------------------------------------------------------------

;; Paragraphs as comments of at most so many columns.
(define columns 92)

(define (comment text)
  (apply string-append
         (for*/list ([paragraph (in-list (add-between (regexp-split #rx"\n" text) #f))]
                     #:when paragraph
                     [line (in-list (filled (string-split paragraph)))])
           (format ";; ~a\n" line))))

(define (filled words)
  (let loop ([words words] [line ""])
    (cond [(null? words) (list line)]
          [(string=? line "") (loop (cdr words) (car words))]
          [(> (+ (string-length line) 1 (string-length (car words))) columns)
           (cons line (loop words ""))]
          [else (loop (cdr words) (string-append line " " (car words)))])))
