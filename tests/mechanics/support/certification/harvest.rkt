#lang racket/base
;; All proved verdicts that the examples, the README and the pages of the guide show, with their
;; certificates.

(require racket/file racket/path racket/runtime-path
         mechanics/certificate/certificate
         mechanics/lang/command/program-verdicts
         mechanics/show/notebook/program-cells
         mechanics/verdict/verdict
         "../../../../scribblings/mechanics/guide-notebook.rkt"
         "proved-claims.rkt")

(provide program-files text-files entries-of-program entries-of-claims claim-kind
         (struct-out entry))

;; kind    : of the question
;; content : certificate, or why there is none
;; proof   : milliseconds of the program since the proved verdict before, or 0 where unknown
;; writing : milliseconds that the certificate takes
(struct entry (name kind content proof writing) #:authentic)

(define-runtime-path top "../../../..")
(define examples (simple-form-path (build-path top "examples" "mechanics")))

(define folders
  '("." "chapter-1" "constraints" "exercises" "forces" "geometry" "geometry/exercises" "questions"
    "rigid" "variational"))

;; -> ((name . file) ...)
(define (program-files)
  (for*/list ([folder (in-list folders)]
              [file (in-list (directory-list (build-path examples folder)))]
              #:when (path-has-extension? file #".rkt")
             #:unless (equal? file (string->path "info.rkt")))
    (define path (simplify-path (build-path examples folder file)))
    (cons (path->string (path-replace-extension (find-relative-path examples path) #"")) path)))

;; The forms of the README and of each page of the guide, as programs in the folder
(define (text-files folder)
  (define (written name forms)
    (define file (build-path folder (string-append name ".rkt")))
    (display-lines-to-file (cons "#lang mechanics" forms) file #:exists 'truncate)
    (cons (string-append "guide/" name) file))
  (cons (written "README" (forms-of-README))
        (for/list ([p (in-list (guide-pages (build-path guide "guide.scrbl")))])
          (written (guide-page-name p) (forms-of-page p)))))

(define guide (build-path top "scribblings" "mechanics"))

(define (forms-of-page p)
  (for/list ([c (in-list (guide-page-cells p))]
             #:when (eq? 'code (cell-kind c)) #:unless (memq c (guide-page-failing p)))
    (cell-source c)))

;; The forms after its prompts
(define (forms-of-README)
  (define text (file->string (build-path top "README.md")))
  (for/list ([place (in-list (regexp-match-positions* #rx"(?m:^    > )" text))])
    (format "~s" (read (open-input-string (substring text (cdr place)))))))

;; ---------------------------------------------------------------------------

(define (entries-of-program name file)
  (define-values (all problem) (program-verdicts 'certify (simple-form-path file) file))
  (when problem (printf "~a did not run to its end: ~a\n" name problem))
  (for/list ([s (in-list all)] [k (in-naturals 1)] #:when (proved? (shown-verdict-verdict s)))
    (entry-of (format "~a ~a" name k) (shown-verdict-verdict s) (shown-verdict-milliseconds s))))

(define (entries-of-claims)
  (for/list ([c (in-list (proved-claims))])
    (entry-of (format "claim ~a" (asked-name c)) (asked-verdict c) 0)))

(define (entry-of name v proof)
  (define start (current-process-milliseconds))
  (define content (certificate-in-time v))
  (entry name (claim-kind v) content proof (- (current-process-milliseconds) start)))

(define (claim-kind v)
  (define s (claim-subject (verdict-claim v)))
  (cond [(equality-claim? s) "equality"]
        [(motion-claim? s) "motion"]
        [(conserved-claim? s) "conserved"]
        [(canonical-claim? s) "canonical"]
        [(gauge-claim? s) "gauge"]
        [else "other residual"]))
