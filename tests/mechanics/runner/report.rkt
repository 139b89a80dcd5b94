#lang racket/base
;; What the runner prints: a line for each file that passed, all the output of
;; each that failed, the reasons for skips, and a last line with the counts.

(require racket/path
         racket/string
         "process.rkt")

(provide print-outcome print-skips tally failed-total)

(define (print-outcome o)
  (define title
    (format "~a ~a  ~a s" (pad (counts o)) (short-name (outcome-file o))
            (in-tenths (outcome-seconds o))))
  (cond [(eqv? 0 (outcome-failed o))
         (printf "ok   ~a\n" title)]
        [else
         (printf "FAIL ~a\n" title)
         (print-output (outcome-output o))
         (when (outcome-reason o)
           (printf "~a ~a\n" (short-name (outcome-file o)) (outcome-reason o)))
         (newline)])
  (flush-output))

(define (counts o)
  (if (eqv? 0 (outcome-failed o))
      (number->string (outcome-passed o))
      (format "~a of ~a" (outcome-failed o)
              (+ (outcome-passed o) (outcome-failed o)))))

(define (pad text)
  (string-append (make-string (max 0 (- 6 (string-length text))) #\space) text))

(define (in-tenths seconds)
  (number->string (/ (round (* 10.0 seconds)) 10.0)))

(define (short-name file)
  (define relative (find-relative-path (current-directory) (simple-form-path file)))
  (if (string-prefix? (path->string relative) "..")
      (path->string file)
      (path->string relative)))

(define (print-output bytes)
  (define text (bytes->string/utf-8 bytes #\?))
  (write-string text)
  (unless (or (string=? text "") (string-suffix? text "\n"))
    (newline)))

;; Each skip on a line of its own, then their number, if there are any.
(define (print-skips outcomes)
  (for* ([o (in-list outcomes)]
         [reason (in-list (outcome-skips o))])
    (printf "skipped: ~a: ~a\n" (short-name (outcome-file o)) reason))
  (define skips (total (lambda (o) (length (outcome-skips o))) outcomes))
  (unless (eqv? skips 0)
    (printf "~a skipped\n" skips)))

(define (total part outcomes)
  (for/sum ([o (in-list outcomes)]) (part o)))

(define (failed-total outcomes) (total outcome-failed outcomes))

;; The last line, always in this form.
(define (tally outcomes)
  (format "~a passed, ~a failed" (total outcome-passed outcomes) (failed-total outcomes)))
