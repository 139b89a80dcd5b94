#lang racket/base
;; A bit that the disk had flipped in a checkpoint was not seen: wrong numbers came out of it, or
;; all that stood behind was lost.

(require racket/file racket/list
         mechanics/book
         mechanics
         "../support/checks.rkt")

(define (pendulum m l g) (Lagrangian->state-derivative (L-pendulum g m l)))
(define starts (for/list ([k 40]) (up 0 (* 0.05 k) 0.1)))

(define (follow file)
  (evolve-ensemble (pendulum 1.0 1.0 9.8) starts 3 #:jobs 1 #:batch 4 #:checkpoint file))

(define-syntax-rule (with-file file body ...)
  (let ([file (make-temporary-file "ensemble~a")])
    (dynamic-wind void
                  (lambda () (delete-file file) body ...)
                  (lambda () (when (file-exists? file) (delete-file file))))))

(define (rewrite file bytes) (call-with-output-file* file #:exists 'truncate
                               (lambda (out) (write-bytes bytes out))))

(define (flipped bytes k)
  (define other (bytes-copy bytes))
  (bytes-set! other k (bitwise-xor (bytes-ref bytes k) 16))
  other)

(define-syntax-rule (noted body)
  (let ([port (open-output-string)])
    (values (parameterize ([current-error-port port]) body) (get-output-string port))))

;; Where records begin
(define (marks bytes) (map car (regexp-match-positions* #rx#"\nrecord\n" bytes)))

(test-case "whichever bit is flipped, no number is wrong, and what is intact is used"
  (with-file file
    (define right (follow file))
    (define whole (file->bytes file))
    (define begin (cadr (marks whole)))           ; behind the fingerprint of the ensemble
    (check-equal? (length (marks whole)) 11)
    (for ([k (in-range begin (bytes-length whole) 397)])
      (rewrite file (flipped whole k))
      (define-values (result words) (noted (follow file)))
      (check-equal? result right)
      (define last? (>= k (last (marks whole))))
      (unless last?
        (check-regexp-match #rx"checkpoint is damaged in one place.*are done again.*file: " words))
      ;; one batch was added at the end
      (check-equal? (- (length (marks (file->bytes file))) (length (marks whole)))
                    (cond [last? 0]
                          [(for/or ([m (marks whole)]) (<= m k (+ m 7))) 0]
                          [else 1])))))

(test-case "two batches damaged side by side are done again, and no others"
  (with-file file
    (define right (follow file))
    (define whole (file->bytes file))
    (rewrite file (for/fold ([bytes whole]) ([m (take (drop (marks whole) 3) 2)])
                    (flipped bytes (+ m 40))))
    (define-values (result words) (noted (follow file)))
    (check-equal? result right)
    (check-regexp-match #rx"checkpoint is damaged in one place" words)
    (check-equal? (length (marks (file->bytes file))) (+ 2 (length (marks whole))))))

(test-case "where it says whose it is, it is damaged: told, and left"
  (with-file file
    (void (follow file))
    (define whole (file->bytes file))
    (define bad (flipped whole (+ 20 (car (marks whole)))))
    (rewrite file bad)
    (check-exn #rx"damaged where it says of which ensemble.*file: .*another name for #:checkpoint"
               (lambda () (follow file)))
    (check-equal? (file->bytes file) bad)))

(test-case "a process that ended while it wrote the beginning"
  (with-file file
    (define right (follow file))
    (define whole (file->bytes file))
    (for ([n (list 1 10 34 40 80)])
      (rewrite file (subbytes whole 0 n))
      (check-equal? (follow file) right)
      (check-equal? (file->bytes file) whole))))

(test-case "a file of the first version, which was never released, is no checkpoint, and is left"
  (with-file file
    (void (follow file))
    (define old
      (bytes-append #"mechanics: an ensemble, version 1\n" (subbytes (file->bytes file) 34)))
    (rewrite file old)
    (check-exn #rx"this file is no checkpoint of an ensemble; it is left as it is"
               (lambda () (follow file)))
    (check-equal? (file->bytes file) old)))
