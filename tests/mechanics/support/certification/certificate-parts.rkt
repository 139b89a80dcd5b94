#lang racket/base
;; Parts of the file that is written for a verdict, spaces aside.

(require racket/string
         rackunit
         mechanics
         (only-in mechanics/certificate/certificate certificate-text))

(provide statement file-of has)

;; The text from the definition of hypotheses to the proof of the claim
(define (statement v)
  (string-normalize-spaces
   (cadr (regexp-match #rx"(Definition hypotheses.*)Proof[.].*Theorem not_vacuous"
                       (certificate-text (certificate v))))))

;; The whole file
(define (file-of v) (string-normalize-spaces (certificate-text (certificate v))))
(define (has part v) (check-true (string-contains? (file-of v) part) part))
