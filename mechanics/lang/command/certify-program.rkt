#lang racket/base
;; `raco mechanics certify FILE`: a certificate for each proved verdict that a program shows, and
;; what Coq says of it.

(require racket/file (only-in racket/list count) racket/path racket/string
         "program-verdicts.rkt" "written-files.rkt"
         "../../certificate/certificate.rkt" "../../certificate/Coq-check.rkt"
         "../../error/complain.rkt"
         "../../error/message-words.rkt"
         "../../generic/describe.rkt"
         "../../verdict/verdict.rkt")

(provide certify-command)

(define who 'certify)

(define (certify-command arguments)
  (define-values (file option) (read-arguments who arguments #:switches '("--write")))
  (define path (simple-form-path file))
  (define folder
    (simple-form-path (or (option "-o") (path-replace-extension path "-certificates"))))
  (when (file-exists? folder)
    (complain who "certificates go into a folder, and there is a file of that name\n  given: ~a"
              (short-path folder)))
  (define above (path-only folder))
  (unless (directory-exists? above)
    (complain who "there is no such folder\n  given: ~a" (short-path above)))
  (define-values (all problem) (program-verdicts who path file))
  (define proved (filter (lambda (s) (proved? (shown-verdict-verdict s))) all))
  (define coqc (and (not (option "--write")) (find-Coq)))
  (when problem (eprintf "certify: ~a did not run to its end:\n~a\n" file problem))
  (define good (certify-all all folder (identifier-of path) coqc))
  (print-sum (map shown-verdict-verdict all) good coqc (option "--write"))
  (if (or problem (not (= good (length proved)))) 1 0))

;; A file of Coq is named by letters, digits and underscores.
(define (identifier-of path)
  (define name (path->string (path-replace-extension (file-name-from-path path) #"")))
  (define plain (regexp-replace* #px"[^A-Za-z0-9_]" name "_"))
  (if (regexp-match? #px"^[A-Za-z]" plain) plain (string-append "p" plain)))

;; -> how many certificates are written, and accepted where there is Coq
(define (certify-all all folder name coqc)
  (define statuses (map (lambda (s) (verdict-status (shown-verdict-verdict s))) all))
  (when (memq 'proved statuses) (make-directory* folder))
  (remove-old folder name)
  (for/fold ([k 1] [good 0] #:result good) ([s (in-list all)] [status (in-list statuses)])
    (printf "~a\n" (brief (shown-verdict-form s)))
    (flush-output)
    (cond [(eq? status 'proved)
           (define file (build-path folder (format "~a_~a.v" name k)))
           (values (+ k 1) (+ good (if (certify (shown-verdict-verdict s) file coqc) 1 0)))]
          [else
           (printf "    ~a\n" status)
           (values k good)])))

;; A failure with one verdict leaves the others their certificates.
;; -> is it written, and accepted where there is Coq?
(define (certify v file coqc)
  (define c
    (with-handlers ([exn:fail? (lambda (e) (first-line (exn-message e)))])
      (certificate-in-time v)))
  (cond [(string? c)
         (printf "    no certificate yet: ~a\n" c)
         #f]
        [else
         (when (file-exists? file)
           (complain who "there is a file of that name, which is no certificate\n  given: ~a"
                     (short-path file)))
         (write-certificate c file)
         (printf "    ~a: ~a\n" (short-path file) c)
         (or (not coqc) (check-and-tell coqc c file))]))

;; Certificates that a run before wrote of a program of that name: some of its verdicts may be no
;; more.
(define (remove-old folder name)
  (define ours (regexp (format "^~a_[0-9]+[.]v$" (regexp-quote name))))
  (when (directory-exists? folder)
    (for ([file (in-list (directory-list folder #:build? #t))]
          #:when (regexp-match? ours (path->string (file-name-from-path file)))
          #:when (certificate-text? (file->string file)))
      (delete-file file))))

(define (first-line text) (car (string-split text "\n" #:trim? #f)))

;; -> does Coq accept it?
(define (check-and-tell coqc c file)
  (define j (check-by-Coq coqc (certificate-text c)))
  (define seconds (/ (round (* 10 (judgement-seconds j))) 10.0))
  (if (judgement-accepted? j)
      (printf "    accepted by Coq in ~a s\n" seconds)
      (printf "    NOT accepted by Coq, ~a s: ~a\n" seconds
              (string-join (string-split (string-replace (judgement-message j) "./certificate.v"
                                                         (path->string (short-path file))))
                           " ")))
  (judgement-accepted? j))

(define (brief form)
  (define text (value->text form))
  (if (> (string-length text) 90) (string-append (substring text 0 87) "...") text))

(define (print-sum all good coqc only-written?)
  (define (having status) (count (lambda (v) (eq? status (verdict-status v))) all))
  (define (others status) (if (= 0 (having status)) "" (format ", ~a ~a" (having status) status)))
  (define proved (having 'proved))
  (printf "~a shown, ~a proved, ~a ~a~a~a\n" (counted (length all) "verdict") proved good
          (if coqc "accepted by Coq" "with a certificate") (others 'refuted) (others 'undecided))
  (when (> proved good)
    (printf "~a proved and not ~a; above stands why\n" (- proved good)
            (if coqc "accepted" "certified")))
  (when (null? all)
    (printf "a verdict that is shown, as a result or by printing it, gets a certificate\n"))
  (unless (or coqc only-written?)
    (printf "Coq is not there to check them: on Debian, apt-get install coq libcoq-coquelicot\n")))
