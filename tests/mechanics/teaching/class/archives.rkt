#lang racket/base
;; A class in a ZIP archive, which anybody may have made: its submissions are found, and no path in
;; it leads anywhere.

(require file/gzip
         mechanics/teaching/class/submission
         mechanics/teaching/class/submission-archive
         racket/file
         "../../support/checks.rkt" "../../support/folder.rkt" "../../support/messages.rkt")

;; ---------------------------------------------------------------------------
;; Archives (PKWARE's APPNOTE 4.3): entries are (name content), and 'deflated perhaps

(define (number n size) (subbytes (integer->integer-bytes n 8 #f #f) 0 size))
(define (sum-of-bytes . parts) (apply bytes-append parts))

(define (deflated content)
  (define out (open-output-bytes))
  (deflate (open-input-bytes content) out)
  (get-output-bytes out))

;; The part common to both headers: version to the length of further fields
(define (fields name stored size method [flags 0])
  (sum-of-bytes (number 20 2) (number flags 2) (number method 2) (number #x8BB2 2) (number #x5D74 2)
                (number 0 4) (number (bytes-length stored) 4) (number size 4)
                (number (bytes-length name) 2) (number 0 2)))

(define (archive . entries)
  (define-values (body directory)
    (for/fold ([body #""] [directory #""]) ([e (in-list entries)])
      (define-values (name content) (values (car e) (cadr e)))
      (define packed? (memq 'deflated e))
      (define stored (if packed? (deflated content) content))
      (define common (fields name stored (bytes-length content) (if packed? 8 0)))
      (values (sum-of-bytes body #"PK\3\4" common name stored)
              (sum-of-bytes directory #"PK\1\2" (number 20 2) common (number 0 2) (number 0 2)
                            (number 0 2) (number #o100644 4) (number (bytes-length body) 4) name))))
  (define n (length entries))
  (sum-of-bytes body directory #"PK\5\6" (number 0 4) (number n 2) (number n 2)
                (number (bytes-length directory) 4) (number (bytes-length body) 4) (number 0 2)))

(define (read-archive bytes)
  (with-folder (folder)
    (define file (build-path folder "class.zip"))
    (display-to-file bytes file)
    (begin0 (parameterize ([current-directory folder]) (archive->submissions 'check "class.zip"))
            (check-equal? (directory-list folder) (list (string->path "class.zip"))
                          "nothing was unpacked"))))

(define program #"#lang mechanics\n;; Name: Ann A.\n(define two 2)\n")
(define (ids bytes) (map submission-id (read-archive bytes)))
(define (problems bytes) (map submission-problem (read-archive bytes)))

;; ---------------------------------------------------------------------------

(test-case "files, and folders of platforms, are submissions, in the order of their numbers"
  (check-equal?
   (ids (archive (list #"s10.rkt" program) (list #"s9.rkt" program 'deflated)
                 (list #"Ann Arbor_12_assignsubmission_file_/pendulum.ipynb" #"{}")
                 (list #"notes.txt" #"x") (list #"__MACOSX/._s9.rkt" #"x")
                 (list #".ipynb_checkpoints/a.ipynb" #"x")))
   '("Ann Arbor_12_assignsubmission_file_" "s9" "s10")))

(test-case "a folder that holds the whole class names nobody"
  (check-equal? (ids (archive (list #"class/" #"") (list #"class/ann.rkt" program)
                              (list #"class/bob/x.rkt" program)))
                '("ann" "bob"))
  (check-equal? (ids (archive (list #"ann/a.rkt" program))) '("ann")))

(test-case "who handed in other files alone is told so"
  (define all
    (read-archive (archive (list #"class/ann/x.rkt" program) (list #"class/bob/answers.pdf" #"x")
                           (list #"class/ann/notes.txt" #"x") (list #"class/cy/a.docx" #"x")
                           (list #"class/cy/b.png" #"x") (list #"class/dan.ipynb" #"{}")
                           (list #"class/empty/" #"") (list #"class/readme.txt" #"x"))))
  (check-equal? (map submission-id all) '("ann" "bob" "cy" "dan"))
  (check-equal? (map submission-problem all)
                `(#f "handed in answers.pdf, which is no program (.rkt) and no notebook (.ipynb)"
                     ,(string-append "handed in a.docx, b.png, of which none is a program (.rkt) "
                                     "or a notebook (.ipynb)")
                     #f)))

(test-case "text, name and time are those of the file"
  (for ([how '(stored deflated)])
    (define s (car (read-archive (archive (list #"ann.rkt" program how)))))
    (check-equal? (submission-text s) (bytes->string/utf-8 program))
    (check-equal? (submission-person s) "Ann A.")
    (check-equal? (date-year (seconds->date (submission-time s))) 2026)))

(test-case "a path that leads out of the archive leads nowhere"
  (for ([name '(#"../x.rkt" #"a/../../x.rkt" #"/etc/x.rkt" #"C:\\x.rkt" #"..\\x.rkt" #"a//x.rkt"
                #"./x.rkt")])
    (define all (read-archive (archive (list name program) (list #"ann.rkt" program))))
    (check-equal? (map submission-problem all)
                  (for/list ([s all])
                    (and (not (equal? "ann" (submission-id s)))
                         "its name leads out of the archive, and it was not read"))
                  (format "~s" name))))

(test-case "a bomb, an empty file, bytes, and several files of one cost themselves alone"
  (define bomb (make-bytes 20000000 32))
  (define all
    (archive (list #"bomb.rkt" bomb 'deflated) (list #"bomb2.ipynb" bomb 'deflated)
             (list #"bytes.rkt" #"\377\376") (list #"empty.rkt" #"")
             (list #"two/a.rkt" program) (list #"two/b.rkt" program) (list #"zed.rkt" program)))
  (define told (problems all))
  (check-equal? (ids all) '("bomb" "bomb2" "bytes" "empty" "two" "zed"))
  (for ([pattern '(#rx"^it has more than 1000000 bytes$" #rx"^it has more than 4000000 bytes; Clear"
                   #rx"^it is no text in UTF-8$" #rx"^it is empty$" #rx"several files of it" #f)]
        [problem told])
    (if pattern (check-regexp-match pattern problem) (check-false problem))))

(test-case "what cannot be unpacked is told"
  (define good (archive (list #"a.rkt" (make-bytes 5000 40) 'deflated) (list #"z.rkt" program)))
  (define broken (bytes-copy good))
  (bytes-copy! broken 36 (make-bytes 8 255))
  (check-equal? (problems broken) '("it could not be unpacked" #f)))

(test-case "a name is text, and commands no terminal"
  (check-equal? (ids (archive (list #"a\33[2J.rkt" program) (list #"=cmd.rkt" program)
                              (list (string->bytes/utf-8 "Ünal.rkt") program)))
                '("=cmd" "a\uFFFD[2J" "Ünal")))

(test-case "the same name twice is one submission"
  (check-equal? (ids (archive (list #"a.rkt" program) (list #"a.rkt" #"x"))) '("a")))

(says
 [(read-archive #"PK no archive")
  "check: it is no ZIP archive, or a damaged one\n  file: class.zip"]
 [(read-archive (subbytes (archive (list #"a.rkt" program)) 0 80))
  "check: it is no ZIP archive, or a damaged one\n  file: class.zip"]
 [(read-archive (archive (list #"a.txt" program)))
  "check: there is no submission, no file that ends with .rkt or .ipynb\n  archive: class.zip"]
 [(read-archive (apply archive (for/list ([k 5001]) (list (number k 8) #""))))
  "check: the archive has 5001 entries; at most 5000 are read\n  file: class.zip"])
