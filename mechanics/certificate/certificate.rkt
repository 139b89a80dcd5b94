#lang racket/base
;; Certificates: a proved verdict as a theorem that the proof assistant Coq checks.

(require racket/list racket/path racket/string
         "bracket-theorem.rkt" "conserved-theorem.rkt" "Coq-names.rkt" "Coq-term.rkt"
         "gauge-theorem.rkt" "identity-theorem.rkt" "motion-theorem.rkt"
         "proof-tactics.rkt" "theorem-text.rkt"
         "../algebra/expression/expression.rkt" "../algebra/expression/substitute.rkt"
         "../error/complain.rkt"
         "../generic/define-plain.rkt" "../generic/describe.rkt" "../generic/irrational.rkt"
         "../generic/output-file.rkt"
         "../generic/own-thread.rkt" "../generic/value-struct.rkt"
         "../generic/wrong-argument.rkt"
         "../value/algebra.rkt"
         "../verdict/verdict.rkt")

(provide certificate write-certificate certificate-or-reason certificate-in-time certificate?
         certificate-text certificate-level certificate-gap certificate-text?
         ;; for tests
         theorem-file)

;; level : 1, the identity alone, or 2, the claim with its derivatives
;; text  : of the file
;; gap   : of level 1, why a question that level 2 is for has none; else #f
(value-struct proof-certificate (level words text gap)
  #:text (lambda (c) (proof-certificate-words c)))

(define certificate? proof-certificate?)
(define certificate-level proof-certificate-level)
(define certificate-text proof-certificate-text)
(define certificate-gap proof-certificate-gap)

(define-plain (certificate v)
  (check-proved 'certificate v)
  (define c (certificate-in-time v))
  (when (string? c) (complain 'certificate "no certificate yet: ~a" c))
  c)

(define-plain (write-certificate v file)
  (define who 'write-certificate)
  (check-comes-first who (and (path-string? v) (or (verdict? file) (certificate? file)))
                     "verdict" "name of the file")
  (unless (certificate? v) (check-proved who v))
  (check-argument who path-string? file "the name of a file")
  (check-argument who name-for-Coq? file
                  "a file name as coqc takes it, a letter, then letters, digits and _, then .v")
  (check-file who file)
  (define c (if (certificate? v) v (certificate v)))
  (write-file who file (string->bytes/utf-8 (certificate-text c))))

;; coqc makes the name of a module from that of the file.
(define (name-for-Coq? file)
  (define name (file-name-from-path file))
  (and name (regexp-match? #px"^[A-Za-z][A-Za-z0-9_]*[.]v$" (path->string name))))

(define (check-proved who v)
  (check-argument who verdict? v "a verdict, such as verify-solution or verify-equal gives")
  (unless (proved? v)
    (complain who "only what is proved has a certificate\n  verdict: ~a" (verdict-status v))))

;; v : a proved verdict -> certificate, or a string that says why there is none yet
(define (certificate-or-reason v)
  (with-handlers ([no-certificate? no-certificate-reason])
    (define c (derivative-certificate v))
    (if (certificate? c) c (identity-certificate v c))))

;; The same where writing ends within a minute, else a string that says so
(define (certificate-in-time v)
  (call-in-own-thread
   (lambda () (certificate-or-reason v))
   most-seconds
   (lambda () (format "it takes more than ~a seconds to write" most-seconds))))

(define most-seconds 60)

;; -> certificate of level 2; or #f for another question, or a string: why there is none yet
(define (derivative-certificate v)
  (define c (claim-subject (verdict-claim v)))
  (define-values (make claim) (theorem-about c))
  (with-handlers ([no-certificate? no-certificate-reason])
    (cond [(not make) #f]
          [(not (andmap as-written? (verdict-readings v)))
           "the procedures hold the decimals themselves"]
          [else
           (define th (make c (verdict-assumptions v)))
           (define readings (verdict-readings v))
           (proof-certificate
            2
            (words claim th (string-append "by Coq's own derivatives" (readings-in-words readings)))
            (theorem-file th #t (readings-note readings))
            #f)])))

;; reading : (decimal expression) -> does its theorem read it so, 9.8 as 98/10?
(define (as-written? reading)
  (define-values (x e) (apply values reading))
  (and (real? e) (= e (rational-constant x))))

;; c : a claim's subject -> the function that makes its theorem, and words; or #f and #f
(define (theorem-about c)
  (cond [(motion-claim? c)
         (values motion-theorem
                 (format "the path is a motion of the ~a~a" (system-name (motion-claim-p c))
                         (with-outside (motion-claim-force c) (motion-claim-constraints c))))]
        [(conserved-claim? c)
         (values conserved-theorem
                 (format "the quantity is conserved along the motions of the ~a~a"
                         (system-name (conserved-claim-Hamiltonian? c))
                         (with-outside (conserved-claim-force c) #f)))]
        [(and (canonical-claim? c) (canonical-claim-H c))
         (values conserved-theorem
                 "the transformation takes motions of the new Hamiltonian to those of the old")]
        [(canonical-claim? c)
         (values bracket-theorem "the transformation keeps all Poisson brackets")]
        [(gauge-claim? c)
         (values gauge-theorem (format "~a a total time derivative" (gauge-words c)))]
        [else (values #f #f)]))

(define (gauge-words c)
  (define factor (gauge-claim-factor c))
  (cond [(not (gauge-claim-first c)) "the function is"]
        [(eqv? 1 factor) "the Lagrangians differ by"]
        [else (format "the second Lagrangian and the first, multiplied by ~a, differ by"
                      (value->text factor))]))

(define (system-name Hamiltonian?) (if Hamiltonian? "Hamiltonian" "Lagrangian"))

;; Words for a force and constraints, each of them #f where there is none
(define (with-outside force constraints)
  (define all (append (if force '("the force") '()) (if constraints '("the constraints") '())))
  (if (null? all) "" (format " with ~a" (string-join all " and "))))

;; gap : why there is none of level 2, or #f
(define (identity-certificate v gap)
  (define c (verdict-claim v))
  (define readings (append-map zero-test-decimals (verdict-tests v)))
  (define equations (filter (lambda (q) (not (equal? q '(0 . 0)))) (equations-of v)))
  (when (null? equations)
    (give-up "arithmetic makes 0 of it while it is formed, and no equation is left to state"))
  (define th
    (identity-theorem (remove-duplicates equations)
                      (for/list ([e (in-list (claim-domain c))]) (with-decimals-read e readings))
                      (verdict-assumptions v)))
  (proof-certificate
   1
   (words (cond [(andmap (lambda (q) (equal? (car q) (cdr q))) equations)
                 "both sides are one and the same expression"]
                [(andmap (lambda (q) (eqv? 0 (formed-anew (car q)))) equations)
                 "an expression, less one and the same expression, is zero"]
                [(equality-claim? (claim-subject c)) "both sides are equal"]
                [(null? (cdr (verdict-tests v))) "the residual is zero"]
                [else (format "the ~a components of the residual are zero"
                              (length (verdict-tests v)))])
          th
          (string-append "the derivatives are ours" (readings-in-words (verdict-readings v))))
   (theorem-file th #f (readings-note (verdict-readings v)))
   gap))

;; A difference that was not formed yet, as of decimals, which have been read since, is formed.
(define (formed-anew e)
  (node-fold e values (lambda (n args) (rebuild (node-head n) args))))

;; all : ((decimal expression) ...); write : expression -> string
(define (readings-text all before write)
  (if (null? all)
      ""
      (format "~a ~a" before
              (string-join (for/list ([r (in-list all)])
                             (format "~a as ~a" (car r) (write (cadr r))))
                           ", "))))

(define (readings-in-words all) (readings-text all "; reading" value->text))
(define (readings-note all)
  (readings-text all "Decimals are read as exact numbers:" constant-text))
(define (constant-text e) (term e (make-names '())))

;; Exact roots, numbers of ours, as expressions
(define (sides x) (map irrational-as-expression (leaves x)))

;; -> ((left . right) ...), expressions: the sides of an equality, or residuals and 0
(define (equations-of v)
  (define c (verdict-claim v))
  (define tests (verdict-tests v))
  (define (exact es)
    (for/list ([e (in-list es)] [z (in-list tests)])
      (if (expression? e) (with-decimals-read e (zero-test-decimals z)) e)))
  (define-values (lefts rights)
    (if (equality-claim? (claim-subject c))
        (values (exact (sides (equality-claim-left (claim-subject c))))
                (exact (sides (equality-claim-right (claim-subject c)))))
        (values '() '())))
  (define residuals (exact (leaves (claim-value c))))
  (if (and (= (length tests) (length lefts) (length rights))
           (andmap expression? (append lefts rights)))
      (map cons lefts rights)
      (map (lambda (e) (cons e 0)) residuals)))

(define (words claim th kind)
  (define (listed before texts)
    (if (null? texts) "" (string-append before (string-join texts ", "))))
  (format "a theorem for Coq to check: ~a~a~a; ~a" claim
          (listed " under " (theorem-hypotheses th))
          (listed ", where what was found for the proof has a value, " (theorem-found th))
          kind))

(define first-line "(* A certificate made by mechanics. To check it: coqc FILE.v *)\n")
;; text : of a file -> is it a certificate's?
(define (certificate-text? text) (string-prefix? text first-line))

(define (theorem-file th [derivatives? #f] [note ""])
  (string-append
   first-line
   (if (string=? note "") "" (format "(* ~a *)\n" note))
   "Require Import Reals Lra Psatz Nsatz.\n"
   (if derivatives? "From Coquelicot Require Import Coquelicot.\n" "")
   "Open Scope R_scope.\n\n"
   (proof-tactics) "\n" (if derivatives? (derivative-tactics) "")
   (if (regexp-match? #rx"atan2[ \n]" (theorem-text th)) (angle-definition) "")
   "\n" (theorem-text th)
   "Definition certificate := conj claim not_vacuous.\nPrint Assumptions certificate.\n"))
