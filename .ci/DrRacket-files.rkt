#lang racket/base
;; A package one of whose files is open DrRacket compiles once more, with debugging, into folders
;; of its own: minutes at the first Run of an example.  Links in these folders to what Racket
;; compiled spare that; a file that changes DrRacket compiles as ever, in place of its link.

(require racket/file
         racket/path)

(provide link-for-DrRacket      ; folder of sources ->
         linked-for-DrRacket?)  ; the same -> boolean

;; below compiled/, with debugging and without
(define folders (list (build-path "drracket" "errortrace") (build-path "drracket")))

(define (linked-for-DrRacket? folder)
  (define links (build-path folder "compiled" "drracket"))
  (and (directory-exists? links)
       (for/or ([file (in-list (directory-list links #:build? #t))]) (link-exists? file))))

(define (link-for-DrRacket folder)
  (for* ([file (in-list (find-files compiled? folder))]
         [below (in-list folders)])
    (define name (file-name-from-path file))
    (define link (build-path (path-only file) below name))
    (unless (or (link-exists? link) (file-exists? link))
      (make-directory* (path-only link))
      (link-or-copy (apply build-path (append (map (lambda (_) 'up) (explode-path below))
                                              (list name)))
                    file link))))

;; Not those for DrRacket
(define (compiled? path)
  (regexp-match? #px"[/\\\\]compiled[/\\\\][^/\\\\]*[.](?:zo|dep)$" (path->string path)))

;; Not every system has links for everybody.
(define (link-or-copy target file link)
  (with-handlers ([exn:fail:filesystem? (lambda (_) (copy-file file link))])
    (make-file-or-directory-link target link)))
