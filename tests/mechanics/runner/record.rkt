#lang racket/base
;; The last run of the tests in this checkout, kept in build/tests.fasl.  For each test file: its
;; seconds, the sources it loaded, and, if it passed, their fingerprint.  A test whose sources have
;; another fingerprint now is stale: something that it loads has changed since it passed.

(require file/sha1
         racket/fasl
         racket/file
         racket/list
         "discover.rkt")

(provide read-record            ; [file] -> record, an empty one where nothing is kept
         write-record           ; record, [file] ->
         (struct-out record) (struct-out entry)
         source-digests         ; -> hasheq: each source -> digest
         make-entry             ; seconds, names of files it loaded, passed?, digests -> entry
         test-stale?            ; entry or #f, digests -> boolean
         test-name              ; path -> symbol
         changed-sources)       ; record, digests -> sources that are not as they were

;; Sources are named by symbols, their paths from the top folder.
;; digests : of all sources, when all tests of the day ran; entries : hasheq, test -> entry
(struct record (digests entries) #:prefab)

;; fingerprint : of the sources, or #f if the test failed
(struct entry (seconds sources fingerprint) #:prefab)

(define kept (from-top "build/tests.fasl"))

(define (read-record [file kept])
  (define nothing (record (hasheq) (hasheq)))
  (with-handlers ([exn:fail? (lambda (_) nothing)])     ; there is none, or half of one
    (define found (call-with-input-file file fasl->s-exp))
    (if (record? found) found nothing)))

(define (write-record r [file kept])
  (make-parent-directory* file)
  (call-with-atomic-output-file file (lambda (out _) (s-exp->fasl r out))))

;; ---------------------------------------------------------------------------

(define (source-digests)
  (for*/hasheq ([folder (in-list '("mechanics" "tests" "examples" "scribblings"))]
                [file (in-list (sources-under (from-top folder)))])
    (values (test-name file) (call-with-input-file file sha1))))

(define (test-name file) (string->symbol (short-name file)))

;; Modules, documents, and what tests compare with.
(define (sources-under folder)
  (find-files (lambda (path) (regexp-match? #rx"[.](rkt|scrbl|txt|css|js)$" path)) folder))

(define (make-entry seconds files passed? digests)
  (define sources
    (filter (lambda (name) (hash-has-key? digests name)) (map string->symbol files)))
  (entry seconds sources (and passed? (fingerprint sources digests))))

;; A source that is gone has the digest #f.
(define (fingerprint sources digests)
  (sha1 (open-input-string
         (format "~s" (for/list ([s (in-list (sort sources symbol<?))])
                        (hash-ref digests s #f))))))

(define (test-stale? e digests)
  (not (and e (entry-fingerprint e)
            (equal? (entry-fingerprint e) (fingerprint (entry-sources e) digests)))))

;; None where all tests never ran.
(define (changed-sources r digests)
  (define before (record-digests r))
  (define names (if (hash-empty? before) '() (append (hash-keys before) (hash-keys digests))))
  (for/list ([name (in-list (remove-duplicates names))]
             #:unless (equal? (hash-ref before name #f) (hash-ref digests name #f)))
    name))
