#lang racket/base
;; Random programs without end:  racket main.rkt [--count N] [--size N] [--seed N]
;;
;; Each disagreement is printed as a program for `racket -I mechanics`, shrunk.

(require racket/cmdline
         racket/pretty
         "check.rkt")

(provide run-batch)

;; -> counts of agreements and discards, and the disagreements.
(define (run-batch m count size seed)
  (parameterize ([current-pseudo-random-generator (make-pseudo-random-generator)])
    (random-seed seed)
    (for/fold ([agreed 0] [discarded 0] [failures '()]) ([_ (in-range count)])
      (define result (random-check m (+ 4 (random size))))
      (case result
        [(agrees) (values (add1 agreed) discarded failures)]
        [(discarded) (values agreed (add1 discarded) failures)]
        [else (values agreed discarded (cons result failures))]))))

(module+ main
  (define count 1000)
  (define size 40)
  (define seed 1)
  (command-line #:program "programs"
                #:once-each
                [("--count") n "programs in each mode (1000)" (set! count (string->number n))]
                [("--size") n "how large they may get (40)" (set! size (string->number n))]
                [("--seed") n "of the random numbers (1)" (set! seed (string->number n))])
  (for ([m (in-list (modes))])
    (define-values (agreed discarded failures) (run-batch m count size seed))
    (printf "~a: ~a agree, ~a discarded, ~a disagree\n"
            (mode-name m) agreed discarded (length failures))
    (for ([f (in-list failures)])
      (define-values (program verdict) (apply shrink f))
      (printf "~a, at ~a\n" verdict (caddr f))
      (pretty-write program))))
