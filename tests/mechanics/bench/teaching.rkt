#lang racket/base
;; A class: submissions of a worksheet with five exercises, judged by the command that a teacher
;; types.  The clock, and the memory of all processes together, are looked at from
;; outside, once.

(require compiler/find-exe
         mechanics/teaching/class/process-cost
         mechanics/teaching/worksheet/student-file
         racket/file
         racket/port
         racket/runtime-path
         racket/string
         "clock.rkt")

(provide class-heading class-rows write-class)

(define-runtime-path pendulum "../../../examples/mechanics/worksheets/pendulum.rkt")

(define class-heading
  '("a class" "submissions" "points" "CPU s" "seconds" "to reach" "MB at most" "to reach"))

;; to-reach : seconds on two idle processors, megabytes
(define (class-rows students . to-reach)
  (define folder (make-temporary-file "mechanics-bench~a" 'directory))
  (define submissions (build-path folder "class"))
  (make-directory submissions)
  (write-class submissions students)
  (define before (processes-milliseconds))
  (define-values (text seconds megabytes)
    (run-watched "-l-" "mechanics/lang/command/raco" "check" submissions
                 "--worksheet" pendulum "--report" (build-path folder "report.html")))
  (delete-directory/files folder)
  (list (list "five exercises each"
              (number->string (length (regexp-match* #rx"\n" text)))
              (points-in text)
              (figure (/ (- (processes-milliseconds) before) 1e3))
              (figure seconds) (figure (car to-reach)) (figure megabytes)
              (figure (cadr to-reach)))))

(define (figure x) (number->string (inexact->exact (round x))))

;; The least and the most: all that was answered is right in the first half of the class.
(define (points-in text)
  (define all
    (sort (map string->number (regexp-match* #px"([\\d.]+) of" text #:match-select cadr)) <))
  (if (null? all) "none" (format "~a to ~a" (car all) (car (reverse all)))))

;; ---------------------------------------------------------------------------
;; The class

(define (write-class folder students)
  (define text (worksheet->student-file (dynamic-require pendulum 'worksheet)))
  (for ([n (in-range 1 (+ 1 students))])
    (display-to-file (for/fold ([text text]) ([(name answer) (in-hash (answers n students))])
                       (string-replace text (format "(define ~a unanswered)" name)
                                       (format "(define ~a ~a)" name answer)))
                     (build-path folder (format "student-~a.rkt" n)))))

;; Answers, different for each student, so that each has to be judged; wrong in the second half.
(define (answers n students)
  (define sign (if (<= n (/ students 2)) '+ '-))
  (define (local sum) (format "(lambda ((up t a b)) ~a)" sum))
  (hash "L-bob" (local (format "(~a (* ~a 'm (square (* 'l b))) (* ~a 'm 'g 'l (cos a)))"
                               sign (/ n 2) n))
        "motion" (format "(lambda (theta t) (~a (* ~a 'l ~a) (* ~a 'g (sin (theta t)))))"
                         sign n "(((expt D 2) theta) t)" n)
        "constant" (local (format "(~a (* ~a (cos a) 'g) (* ~a 'l (square b)))"
                                  (if (eq? sign '+) '- '+) n (/ n 2)))
        "period" (format "~a" (if (eq? sign '+) (+ 2.006 (/ n 1e4)) (/ n 10.)))
        "why" (format "\"It cancels, says ~a.\"" n)))

;; ---------------------------------------------------------------------------
;; A command, watched

;; -> what it wrote, the seconds that it took, and the most megabytes that it and all that it
;; started had at a time, what they share counted for each
(define (run-watched . arguments)
  (define start (current-inexact-milliseconds))
  (define-values (process out in err)
    (parameterize ([current-subprocess-custodian-mode 'kill])
      (apply subprocess #f #f #f (find-exe) arguments)))
  (close-output-port in)
  (define teller (thread (lambda () (copy-port err (current-error-port)))))
  (define most 0)
  (define watcher
    (thread (lambda ()
              (let loop ()
                (set! most (max most (megabytes-of (subprocess-pid process))))
                (sleep 1/20)
                (loop)))))
  (define text (port->string out))
  (subprocess-wait process)
  (define end (current-inexact-milliseconds))
  (kill-thread watcher)
  (thread-wait teller)
  (close-input-port out)
  (close-input-port err)
  (values text (/ (- end start) 1000.) most))

;; Linux tells in pages of 4096 bytes (man 5 proc).
(define (megabytes-of id)
  (define m
    (with-handlers ([exn:fail:filesystem? (lambda (e) #f)])
      (regexp-match #px"^\\d+ (\\d+)" (file->string (format "/proc/~a/statm" id)))))
  (for/fold ([sum (if m (/ (* 4096 (string->number (cadr m))) 1e6) 0)])
            ([c (in-list (children-of id))])
    (+ sum (megabytes-of c))))
