#lang racket/base
;; Certificates: a proved verdict as a theorem that the proof assistant Coq checks.

(require racket/list racket/string
         "Coq-term.rkt" "identity-theorem.rkt" "proof-script.rkt"
         "../algebra/expression/expression.rkt"
         "../error/complain.rkt"
         "../generic/describe.rkt" "../generic/output-file.rkt" "../generic/value-struct.rkt"
         "../generic/wrong-argument.rkt"
         "../value/algebra.rkt"
         "../verdict/verdict.rkt")

(provide certificate write-certificate certificate-or-reason certificate?
         certificate-text certificate-level)

;; level : 1, the identity alone, or 2, the claim with its derivatives
;; text  : of the file
(value-struct proof-certificate (level words text)
  #:text (lambda (c) (proof-certificate-words c)))

(define certificate? proof-certificate?)
(define certificate-level proof-certificate-level)
(define certificate-text proof-certificate-text)

(define (certificate v)
  (check-proved 'certificate v)
  (define c (certificate-or-reason v))
  (when (string? c) (complain 'certificate "no certificate yet: ~a" c))
  c)

(define (write-certificate v file)
  (check-file 'write-certificate file)
  (define c (if (certificate? v) v (certificate v)))
  (write-file 'write-certificate file (string->bytes/utf-8 (certificate-text c))))

(define (check-proved who v)
  (check-argument who verdict? v "a verdict, such as verify-solution or verify-equal gives")
  (unless (proved? v)
    (complain-showing who "only what is proved has a certificate" "verdict" (verdict-status v))))

;; v : a proved verdict -> certificate, or a string that says why there is none yet
(define (certificate-or-reason v)
  (with-handlers ([no-certificate? no-certificate-reason])
    (identity-certificate v)))

(define (identity-certificate v)
  (define c (verdict-claim v))
  (define residuals
    (for/list ([e (in-list (filter expression? (leaves (claim-value c))))]
               [z (in-list (verdict-tests v))])
      (with-decimals-read e (zero-test-decimals z))))
  (define stated (filter (lambda (e) (not (eqv? e 0))) residuals))
  (define th
    (identity-theorem (if (null? stated) '(0) (remove-duplicates stated))
                      (claim-domain c) (verdict-assumptions v)))
  (proof-certificate 1 (words th (length residuals)) (file-text th)))

(define (words th n)
  (format "a theorem of Coq: ~a zero~a; the identity, the derivatives are ours"
          (if (= n 1) "the residual is" (format "the ~a components of the residual are" n))
          (case (theorem-hypotheses th)
            [(0) ""]
            [(1) " under 1 hypothesis"]
            [else (format " under ~a hypotheses" (theorem-hypotheses th))])))

(define (file-text th)
  (string-append
   "(* A certificate made by mechanics. To check it: coqc FILE.v *)\n"
   "Require Import Reals Lra Psatz Nsatz.\nOpen Scope R_scope.\n\n"
   (proof-tactics) "\n" (theorem-text th)
   "Print Assumptions claim.\nPrint Assumptions not_vacuous.\n"))
