#lang racket/base
;; What Coq says of files, kept in build/certification/ between runs: a text that it has accepted or
;; rejected is not given to it again; one that it did not finish in time is.

(require file/sha1 racket/file racket/runtime-path racket/string
         mechanics/certificate/Coq-check)

(provide judged longest rejected-by-proof?)

(define-runtime-path folder "../../../../build/certification")
(define (kept-file) (build-path folder "judgements.rktd"))

(define longest 20)                     ; seconds in which a certificate is to be accepted

;; hash from texts' digests to (outcome seconds message)
(define kept #f)

(define (load-kept!)
  (make-directory* folder)
  (set! kept (make-hash (if (file-exists? (kept-file)) (file->list (kept-file)) '()))))

;; -> judgement; its text stands in the folder under the name while it is not accepted
(define (judged coqc name text)
  (unless kept (load-kept!))
  (define key (sha1 (open-input-string text)))
  (define old (hash-ref kept key #f))
  (define j (if old (apply judgement old) (check-by-Coq coqc text (* 2 longest))))
  (define late? (or (eq? 'unfinished (judgement-outcome j)) (> (judgement-seconds j) longest)))
  (unless (or old late?) (keep! key j))
  (define file (build-path folder (string-append (regexp-replace* #px"[^A-Za-z0-9]" name "_") ".v")))
  (if (judgement-accepted? j)
      (when (file-exists? file) (delete-file file))
      (display-to-file text file #:exists 'truncate))
  (if late? (struct-copy judgement j [outcome 'unfinished]) j))

(define (keep! key j)
  (define value (list (judgement-outcome j) (judgement-seconds j) (judgement-message j)))
  (hash-set! kept key value)
  (call-with-output-file (kept-file) #:exists 'append
    (lambda (out) (writeln (cons key value) out))))

;; Does Coq's message speak of a proof, and not of a text that it cannot read?
(define (rejected-by-proof? j)
  (not (regexp-match? #rx"Syntax error|not found in the current environment|has type"
                      (judgement-message j))))
