#lang racket/base
;; Work that takes too long is stopped, and nothing that others need is broken by it; a submission
;; whose answers take too long to judge costs no other.

(require (prefix-in m: mechanics)
         mechanics/teaching/class/grade
         mechanics/teaching/class/submission
         mechanics/teaching/class/within-limits
         mechanics/teaching/worksheet/judgment
         mechanics/teaching/worksheet/make-exercise
         mechanics/teaching/worksheet/make-worksheet
         "../../support/checks.rkt" "../../support/patience.rkt")

(define (forever) (let loop () (loop)))

(define (value-within seconds megabytes thunk)
  (define-values (value took) (call-within seconds megabytes thunk))
  value)

(test-case "what ends in time has its value, and is told what it took"
  (check-equal? (value-within 10 500 (lambda () 'value)) 'value)
  (define-values (value took) (call-within 10 500 void))
  (check-true (and (void? value) (real? took))))

(test-case "what does not is stopped, and so is what takes too much memory"
  (check-false (value-within 1/4 500 forever))
  (check-false (value-within 10 100 (lambda () (let loop ([l '()])
                                                (loop (cons (make-bytes 1000000) l)))))))

(test-case "what takes no break is done to its end, and tables stay whole"
  (define table (make-hash))
  (define (fill-without-end)
    (let loop ([i 0])
      (parameterize-break #f (hash-set! table (list (modulo i 1000)) i))
      (loop (+ i 1))))
  (check-false (value-within 1/2 500 fill-without-end))
  (define reader (thread (lambda () (hash-set! table '(7) 'read))))
  (check-equal? (sync/patience 30 reader) reader)
  (check-equal? (hash-ref table '(7)) 'read))

;; ---------------------------------------------------------------------------

(define w
  (make-worksheet
   "Slow" #f "slow"
   (list (make-exercise 'first 'expects "?"
                        (list (list 'expects (lambda (x) (if (m:= x 'slow) (forever) #t)))))
         (make-exercise 'second 'expression "?" '((key k)))
         (make-exercise 'third 'expression "?" '((key l))))))

(define (submission-of id answer)
  (submission id id
              (format (string-append "#lang mechanics\n(define first '~a)\n"
                                     "(define-values (second third) (values '~a '~a))\n")
                      answer id id)
              #f #f #f))

(test-case "what is long to judge is left to a person, with what follows it in that submission"
  (define r (grade-class w (list (submission-of "k" "quick") (submission-of "l" "slow")
                                 (submission-of "k" "slow"))
                         #:seconds (processor-seconds 2)))
  (check-equal? (for/list ([g (in-list (class-report-graded r))])
                  (map judgment-status (graded-judgments g)))
                '((right right wrong) (undecided undecided undecided) (undecided right wrong))
                (format "~s" (map graded-problem (class-report-graded r))))
  (check-equal? (judgment-words (car (graded-judgments (cadr (class-report-graded r)))))
                '("to judge it took too long, or too much memory")))

;; Of the seconds the judgment takes six tenths and the program, which may take two thirds, nearly
;; half: room is left for what either needs besides.
(test-case "the time that a program took is none for its judgment"
  (define seconds (processor-seconds 2))
  (define (milliseconds) (current-process-milliseconds (current-thread)))
  (define (look _)
    (define end (+ (milliseconds) (* 600 seconds)))
    (let loop () (or (> (milliseconds) end) (loop))))
  (define works
    (make-worksheet "Works" #f "works"
                    (list (make-exercise 'first 'expects "?" `((expects ,look))))))
  (define (status-of program)
    (define text (format "#lang mechanics\n~s\n(define first 1)\n" program))
    (define r (grade-class works (list (submission "s" "s" text #f #f #f)) #:seconds seconds))
    (judgment-status (car (graded-judgments (car (class-report-graded r))))))
  (check-equal? (status-of '(define second 2)) 'right)
  (check-equal? (status-of `(let* ([now current-process-milliseconds]
                                   [end (+ (now) ,(* 450 seconds))])
                              (let loop () (when (< (now) end) (loop)))))
                'undecided))
