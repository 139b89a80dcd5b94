#lang racket/base
;; The map (mechanics/README.md) is true: every folder has its line, every file it names is
;; there, and so is every file that a comment of the library sends its reader to.

(require racket/file
         racket/list
         racket/string
         "support/checks.rkt" "support/house/library.rkt"
         "support/house/map.rkt")

(define text (map-text))

;; ---------------------------------------------------------------------------
;; Reading

(test-case "folders and files are read off a map"
  (define page
    "- `a/`: x\n  - `a/b/`: y, as in `a/b/c.rkt`\n- `main.rkt`, `base.rkt`: z\n1. `d/e.rkt`, `D`")
  (check-equal? (mapped-folders page) '("a" "a/b"))
  (check-equal? (mapped-files page) '("a/b/c.rkt" "main.rkt" "base.rkt" "d/e.rkt")))

;; ---------------------------------------------------------------------------
;; The map

(define (holds-files? folder)
  (for/or ([name (in-list (library-files))])
    (and (string-prefix? name (string-append folder "/"))
         (not (string-contains? (substring name (+ 1 (string-length folder))) "/")))))

(test-case "every folder has its line, and every line its folder"
  (check-equal? (sort (mapped-folders text) string<?)
                ;; a folder that only holds folders is told by theirs
                (sort (filter holds-files? (library-folders)) string<?)))

(define top (build-path library-root 'up))

;; Pages name files from the top of the project, or from that of the library.
(define (there? name)
  (or (file-exists? (full-path name)) (file-exists? (build-path top name))))

(test-case "every file that the map or another page names is there"
  (for* ([page '("mechanics/README.md" "README.md" "CONTRIBUTING.md")]
         [name (in-list (mapped-files (file->string (build-path top page))))]
         #:unless (member name '("on-demand.rkt")))      ; of any room
    (check-true (there? name) (format "~a, in ~a" name page))))

(test-case "the four walks name the files they pass through"
  (for ([walk '("A residual" "`evolve-trajectory`" "`verify-solution`" "A wrong call")])
    (define found
      (regexp-match (string-append "\n[*][*]" (regexp-quote walk) ".*?\n\n(.*?)\n\n") text))
    (check-true (and found (>= (length (mapped-files (cadr found))) 6)) walk)))

;; ---------------------------------------------------------------------------
;; Comments

;; Files named in the comments of a source, as they are written there.
(define (files-in-comments source)
  (remove-duplicates
   (for*/list ([comment (in-list (regexp-match* #rx"(?m:^ *;.*$)" source))]
               [name (in-list (regexp-match* #px"[\\w./-]*\\w[.]rkt" comment))])
     name)))

;; Where a comment's reader looks: beside the file, in the house, in the wing.
(define (resolves? name from)
  (define wing (car (string-split from "/")))
  (define-values (folder base dir?) (split-path (full-path from)))
  (for/or ([place (list folder library-root (build-path library-root wing))])
    (file-exists? (build-path place name))))

(test-case "files in comments are found"
  (check-equal? (files-in-comments
                 "; see zero/proof.rkt, and (size.rkt)\n(f \"x.rkt\")\n  ;; d.rkt")
                '("zero/proof.rkt" "size.rkt" "d.rkt"))
  (check-true (resolves? "fingerprint.rkt" "algebra/zero/proof.rkt"))
  (check-true (resolves? "polynomial/work-budget.rkt" "algebra/zero/proof.rkt"))
  (check-false (resolves? "work-budget.rkt" "algebra/zero/proof.rkt")))

(test-case "comments send their reader to files that are there"
  (check-equal? (for*/list ([name (in-list (library-files))]
                            [file (in-list (files-in-comments (file-text name)))]
                            #:unless (or (equal? file "file.rkt")      ; any, in an explanation
                                         (resolves? file name)))
                  (format "~a, in ~a" file name))
                '()))
