#lang racket/base
;; The answers of one submission, collected from a process of its own.
;;
;; The process is given so many seconds of the processor's time, and may write so much; then it
;; is ended, with whatever it started.  Nothing that it writes is run.

(require racket/match
         racket/port
         "answer-lines.rkt" "evaluate.rkt" "isolation.rkt"
         "../exercise.rkt")

(provide collect-answers collected-from (struct-out collected))

;; answers : hasheq of answers (answer-lines.rkt), by name
;; problem : why there are not more, or #f
(struct collected (answers problem) #:transparent)

(define most-output 250000)

;; exercises : of the worksheet; text : the program -> collected
(define (collect-answers i exercises text)
  (define custodian (make-custodian))
  (dynamic-wind
   void
   (lambda ()
     (parameterize ([current-custodian custodian])
       (run i (request->text i exercises text))))
   (lambda () (custodian-shutdown-all custodian))))

(define (request->text i exercises text)
  (define bare (for/list ([e (in-list exercises)]) (without-key e)))
  (format "~s\n" (request (isolation-patience i) (isolation-megabytes i) bare text)))

;; What tells how an answer is applied, and no more.
(define (without-key e)
  (exercise (exercise-name e) (exercise-kind e) "" (exercise-coordinates e)
            (for/hasheq ([(name value) (in-hash (exercise-settings e))]
                         #:when (memq name '(arguments Hamiltonian)))
              (values name value))
            #f 0 '() '() #f))

(define (run i request)
  (define-values (process out in err)
    (start-isolated i '("-l" "racket/base" "-l" "mechanics/worksheet/class/evaluate-main")))
  (thread (lambda ()
            (with-handlers ([exn:fail? void]) (write-string request in) (close-output-port in))))
  (thread (lambda () (copy-port err (open-output-nowhere))))
  (define-values (text end) (read-in-time out (isolation-patience i)))
  (define status (sync/timeout 1 process))
  (subprocess-kill process #t)
  (define killed? (and status (not (eqv? 0 (subprocess-status process)))))
  (collected-from text (if (and (eq? end 'done) killed?) 'ended end)))

;; text : what the process wrote; how : it ended, done, ended, late or long
(define (collected-from text how)
  (define found (read-answer-lines text))
  (collected (hash-remove (hash-remove found '*program*) '*ready*) (problem-of found how)))

;; -> text, and how it ended: done, late or long.  Its time begins when it says that it is
;; loaded, and has read what it is asked.
(define (read-in-time in seconds)
  (define buffer (make-bytes 65536))
  (define (late-after s)
    (wrap-evt (alarm-evt (+ (current-inexact-milliseconds) (* 1000 s))) (lambda (_) 'late)))
  (let loop ([parts '()] [size 0] [late (late-after longest-start)])
    (define (text) (bytes->string/utf-8 (apply bytes-append (reverse parts)) #\?))
    (define n (sync late (read-bytes-avail!-evt buffer in)))
    (cond [(eof-object? n) (values (text) 'done)]
          [(eq? n 'late) (values (text) 'late)]
          [(> (+ size n) most-output) (values (text) 'long)]
          [else (loop (cons (subbytes buffer 0 n) parts) (+ size n)
                      (if (null? parts) (late-after seconds) late))])))

(define longest-start 60)        ; seconds

;; A program that was stopped, or did not run at all.  What is said of the program may be the
;; program's own invention, and of any form.
(define (problem-of found end)
  (define program
    (match (hash-ref found '*program* #f)
      [(list 'failed (? string? why)) why]
      [_ #f]))
  (cond [(eq? end 'late) "it took too long, and was stopped"]
        [(and (eq? end 'ended) (hash-has-key? found '*ready*))
         "it took too long, or too much memory, and was stopped"]
        [(eq? end 'long) "it wrote without end, and was stopped"]
        [program (string-append "it does not run: " program)]
        [(not (hash-has-key? found '*ready*)) "Racket could not be started for it"]
        [(= 1 (hash-count found)) "it ended without an answer"]
        [else #f]))
