#lang racket/base
;; The answers of one submission, collected from a process of its own.
;;
;; The process may cost two thirds of the seconds of a submission (process-cost.rkt), the rest being
;; for its judgments; and its output is limited.  Beyond either limit it is ended, with all
;; processes that it started.  Nothing that it writes is run.

(require racket/match
         racket/port
         "answer-lines.rkt" "process-cost.rkt" "evaluate.rkt" "isolation.rkt" "submission.rkt"
         "../worksheet/exercise.rkt")

(provide collect-answers request->text read-within collected-from (struct-out collected))

;; answers : hasheq of answers (answer-lines.rkt), by name
;; problem : why there are not more, or #f
;; spent   : seconds that the program has cost; outline : of a notebook (submission.rkt), or #f
(struct collected (answers problem spent outline) #:transparent)

(define most-output 250000)

;; exercises : of the worksheet; s : a submission with a text -> collected
(define (collect-answers i exercises s)
  (define custodian (make-custodian))
  (dynamic-wind
   void
   (lambda ()
     (parameterize ([current-custodian custodian])
       (run i (request->text i exercises s))))
   (lambda () (custodian-shutdown-all custodian))))

(define (seconds-to-run i) (* 2/3 (isolation-seconds i)))

(define (request->text i exercises s)
  (format "~s\n" (request (and (not (waits-known?)) (seconds-to-run i))
                          (isolation-megabytes i) (map without-key exercises)
                          (submission-text s) (submission-notebook? s))))

;; The exercise without all parts but those that tell how an answer is applied.
(define (without-key e)
  (exercise (exercise-name e) (exercise-kind e) "" (exercise-coordinates e)
            (for/hasheq ([(name value) (in-hash (exercise-settings e))]
                         #:when (memq name '(arguments Hamiltonian)))
              (values name value))
            #f 0 '() '() #f))

(define (run i request)
  (define-values (process out in err) (start-evaluator i))
  (thread (lambda ()
            (with-handlers ([exn:fail? void]) (write-string request in) (close-output-port in))))
  (thread (lambda () (copy-port err (open-output-nowhere))))
  (define-values (id nested?) (values (subprocess-pid process) (isolation-complete? i)))
  (define-values (text end spent)
    (read-within (seconds-to-run i) out (read-cost id nested?)
                 (lambda (last) (read-on last id nested?))))
  (define ended? (and (eq? end 'done) (sync/timeout 1 process)))
  (define failed? (and ended? (not (eqv? 0 (subprocess-status process)))))
  (subprocess-kill process #t)
  (collected-from text (if failed? 'ended end) spent))

;; text : output of the process; how : it ended, one of done, ended, late, long
(define (collected-from text how [spent 0])
  (define found (read-answer-lines text))
  (define outline
    (match (hash-ref found '*outline* #f)
      [(list 'text text) text]
      [_ #f]))
  (collected (for/fold ([f found]) ([name '(*program* *ready* *outline*)]) (hash-remove f name))
             (problem-of found how) spent outline))

;; start : a reading; read-on : last reading -> the present one
;; -> text; done, late or long; and the cost since the process wrote its first line, which says
;; that it has loaded the library
(define (read-within seconds in start read-on)
  (define buffer (make-bytes 65536))
  (let loop ([parts '()] [size 0] [start start] [now start])
    (define cost (cost-between start now))
    (define (ended how)
      (values (bytes->string/utf-8 (apply bytes-append (reverse parts)) #\?) how cost))
    (define n (sync/timeout pulse (read-bytes-avail!-evt buffer in)))
    (cond [(eof-object? n) (ended 'done)]
          [(> cost (if (null? parts) longest-start seconds)) (ended 'late)]
          [(not n) (loop parts size start (read-on now))]
          [(> (+ size n) most-output) (ended 'long)]
          [else
           (define later (read-on now))
           (loop (cons (subbytes buffer 0 n) parts) (+ size n)
                 (if (null? parts) later start) later)])))

(define longest-start 60)        ; seconds
(define pulse 1/5)               ; seconds, how often its cost is looked at

;; Why the program was stopped or did not run, or #f.  The entry *program* may be the program's
;; own invention, of any form.
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
        [(= 1 (hash-count (hash-remove found '*outline*))) "it ended without an answer"]
        [else #f]))
