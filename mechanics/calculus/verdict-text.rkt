#lang racket/base
;; A verdict in words: what was found and the evidence, one fact a line.

(require "../generic/describe.rkt" "../algebra/zero-test.rkt")

(provide write-verdict)

(define (write-verdict status residual tests port)
  (define lines
    (cons (headline status residual)
          (append* (for/list ([z (in-list tests)])
                     (if (eq? (zero-test-status z) 'proved) '() (evidence z))))))
  (define assumptions (distinct (append* (map zero-test-assumptions tests))))
  (write-lines (append lines
                       (for/list ([a (in-list assumptions)])
                         (format "  assuming ~a" (value->text a))))
               port))

(define (headline status residual)
  (case status
    [(proved) "proved: the residual is 0"]
    [(refuted) (format "refuted: the residual is ~a" (value->text residual))]
    [else (format "undecided: the residual ~a could be neither proved nor refuted to be 0"
                  (value->text residual))]))

(define (evidence z)
  (append (factored z) (condition z) (witness z) (bound z)))

(define (factored z)
  (define factor (zero-test-factor z))
  (if (and factor (not (eqv? factor 1)))
      (list (format "  = ~a × ~a" (value->text factor) (value->text (zero-test-core z))))
      '()))

(define (condition z)
  (define c (zero-test-condition z))
  (if c (list (format "  it is 0 when ~a" (equation->text c))) '()))

(define (equation->text c)
  (format "~a = ~a" (value->text (cadr c)) (value->text (caddr c))))

(define (witness z)
  (define w (zero-test-witness z))
  (cond [(not w) '()]
        [(null? w) '()]
        [else
         (list (format "  for instance ~a at ~a"
                       (value->text (zero-test-value z))
                       (join (for/list ([entry (in-list w)])
                               (format "~a = ~a" (value->text (car entry))
                                       (value->text (cdr entry)))))))]))

(define (bound z)
  (define b (zero-test-bound z))
  (if b
      (list (format "  at ~a points it is 0 to within ~a" (zero-test-points z) (value->text b)))
      '()))

(define (append* lists) (apply append lists))

(define (join strings)
  (apply string-append
         (for/list ([s (in-list strings)] [i (in-naturals)])
           (if (zero? i) s (string-append ", " s)))))

(define (distinct xs)
  (for/fold ([kept '()] #:result (reverse kept)) ([x (in-list xs)])
    (if (member x kept) kept (cons x kept))))

(define (write-lines lines port)
  (for ([line (in-list lines)] [i (in-naturals)])
    (unless (zero? i) (newline port))
    (write-string line port)))
