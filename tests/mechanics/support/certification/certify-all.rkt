#lang racket/base
;; `make certify`: certificates of the claims of claims.rktd and of all that the examples, the
;; README and the pages of the guide prove, given to Coq, and false neighbours of the claims, which
;; it has to reject.
;;
;;     racket certify-all.rkt --neighbours 3          all, or what is left of the last run
;;     racket certify-all.rkt --only exercise-5       programs of such a name
;;     racket certify-all.rkt --record                accepted.txt as of this run
;;
;; The table is written to build/certificates.txt too. The exit code is 1 if Coq does not accept
;; what accepted.txt names, or if it accepts a false neighbour or cannot read one.

(require racket/cmdline racket/file racket/format racket/list racket/runtime-path racket/string
         mechanics/certificate/certificate mechanics/certificate/Coq-check
         "false-neighbours.rkt" "harvest.rkt" "kept-judgements.rkt" "proved-claims.rkt")

(define-runtime-path top "../../../..")
(define-runtime-path record-file "accepted.txt")

;; outcome : 'accepted, 'rejected, 'unfinished, 'none, or of neighbours 'unreadable
;; level   : of its certificate; best : of those that there are for such a question, 1 or 2
;; writing : the time of the certificate by that of the proof, or #f
(struct row (name kind outcome level best seconds writing why) #:authentic)

(define (judge e coqc)
  (define c (entry-content e))
  (define (row-of outcome level best seconds why)
    (row (entry-name e) (entry-kind e) outcome level best seconds
         (and level (> (entry-proof e) 0) (/ (entry-writing e) (entry-proof e) 1.0)) why))
  (cond [(string? c) (row-of 'none #f 1 0 c)]
        [else
         (define j (judge-alone coqc (entry-name e) (certificate-text c)))
         (define gap (certificate-gap c))
         (row-of (outcome-of j) (certificate-level c) (if gap 2 (certificate-level c))
                 (judgement-seconds j)
                 (string-append (if gap (format "(not level 2: ~a) " gap) "")
                                (judgement-message j)))]))

(define (judge-neighbour n coqc)
  (define j (judge-alone coqc (neighbour-name n) (neighbour-text n)))
  (define outcome
    (if (and (eq? 'rejected (judgement-outcome j)) (not (rejected-by-proof? j)))
        'unreadable
        (outcome-of j)))
  (row (neighbour-name n) (neighbour-kind n) outcome #f #f (judgement-seconds j) #f
       (judgement-message j)))

(define (outcome-of j) (if (judgement-late? j) 'unfinished (judgement-outcome j)))

(define (row->text r)
  (format "~a: ~a~a~a~a~a" (row-name r)
          (if (row-level r) (format "level ~a " (row-level r)) "")
          (row-outcome r)
          (if (eq? 'none (row-outcome r)) "" (format " in ~a s" (~r (row-seconds r) #:precision 1)))
          (if (row-writing r) (format ", writing ~a" (~r (row-writing r) #:precision 2)) "")
          (if (string=? "" (row-why r)) "" (string-append "\n    " (brief (row-why r))))))

(define (brief text)
  (define line (string-normalize-spaces text))
  (if (> (string-length line) 300) (string-append (substring line 0 300) " ...") line))

(define (shown! r)
  (printf "~a\n" (row->text r))
  (flush-output)
  r)

;; ---------------------------------------------------------------------------
;; Tables

(define (count-of rows good?) (~a (count good? rows)))
(define ((of-outcome . outcomes) r) (memq (row-outcome r) outcomes))
(define (second-level? r) (eqv? 2 (row-best r)))

;; titles : of columns; columns : rows -> string, each
(define (table rows titles columns)
  (define kinds (sort (remove-duplicates (map row-kind rows)) string<?))
  (define (line name rows) (cons name (for/list ([c (in-list columns)]) (c rows))))
  (define lines
    (list* titles
           (append (for/list ([k (in-list kinds)])
                     (line k (filter (lambda (r) (equal? k (row-kind r))) rows)))
                   (list (line "all" rows)))))
  (string-append*
   (for/list ([cells (in-list lines)])
     (format "| ~a |\n" (string-join cells " | ")))))

(define (verdict-table rows)
  (define (number . outcomes) (lambda (rows) (count-of rows (apply of-outcome outcomes))))
  (table rows
         '("question" "proved" "written" "accepted" "rejected" "over 20 s" "level 2 for" "level 2")
         (list (lambda (rows) (~a (length rows)))
               (number 'accepted 'rejected 'unfinished)
               (number 'accepted) (number 'rejected) (number 'unfinished)
               (lambda (rows) (count-of rows second-level?))
               (lambda (rows)
                 (count-of rows (lambda (r) (and (eqv? 2 (row-level r))
                                                 (eq? 'accepted (row-outcome r)))))))))

(define (neighbour-table rows)
  (define (number outcome) (lambda (rows) (count-of rows (of-outcome outcome))))
  (table rows '("false neighbours" "written" "rejected" "over 20 s" "unreadable" "ACCEPTED")
         (list (lambda (rows) (~a (length rows))) (number 'rejected) (number 'unfinished)
               (number 'unreadable) (number 'accepted))))

(define (sum-text rows)
  (define (number . outcomes) (count-of rows (apply of-outcome outcomes)))
  (format "~a proved: ~a accepted by Coq, ~a rejected, ~a longer than ~a s, ~a not certified\n"
          (length rows) (number 'accepted) (number 'rejected) (number 'unfinished) longest
          (number 'none)))

(define (writing-text rows)
  (define all (sort (filter-map row-writing rows) <))
  (define (at part) (~r (list-ref all (exact-floor (* part (- (length all) 1)))) #:precision 2))
  (if (null? all)
      ""
      (format "writing takes ~a times the proof (median), ~a (90th percentile), ~a (most)\n"
              (at 1/2) (at 9/10) (at 1))))

(define (exact-floor x) (inexact->exact (floor x)))

;; ---------------------------------------------------------------------------

;; only : regexp or #f -> rows of verdicts
(define (verdict-rows coqc only)
  (define (entries-of-programs ps)
    (append*
     (for/list ([p (in-list ps)] #:when (or (not only) (regexp-match? only (car p))))
       (entries-of-program (car p) (cdr p)))))
  (define folder (make-temporary-file "texts~a" 'directory))
  (begin0
    (append (if only '() (rows-of (entries-of-claims) coqc))
            (rows-of (entries-of-programs (program-files)) coqc)
            (if (or (not only) (regexp-match? only "guide/"))
                (rows-of (entries-of-programs (text-files folder)) coqc)
                '()))
    (delete-directory/files folder)))

(define (rows-of entries coqc)
  (judge-all coqc (for*/list ([e (in-list entries)]
                              [c (in-value (entry-content e))] #:when (certificate? c))
                    (certificate-text c)))
  (for/list ([e (in-list entries)]) (shown! (judge e coqc))))

(define (neighbour-rows coqc most)
  (define all (all-neighbours (proved-claims) most))
  (expect-rejections (map neighbour-text all))
  (for/list ([n (in-list all)]) (shown! (judge-neighbour n coqc))))

;; Names that the record has and that are not accepted now
(define (lost rows)
  (define accepted (map row-name (filter (of-outcome 'accepted) rows)))
  (if (file-exists? record-file) (remove* accepted (file->lines record-file)) '()))

(define (record! rows)
  (display-lines-to-file (map row-name (filter (of-outcome 'accepted) rows)) record-file
                         #:exists 'truncate))

(module+ main
  (define-values (most only record?)
    (let ([most 3] [only #f] [record? #f])
      (command-line
       #:once-each
       ["--neighbours" n "how many false neighbours of each claim" (set! most (string->number n))]
       ["--only" name "programs of such a name" (set! only (regexp name))]
       ["--record" "what is accepted becomes the record" (set! record? #t)])
      (values most only record?)))
  (define coqc (find-Coq))
  (unless coqc
    (printf "skipped: Coq is not there; on Debian, apt-get install coq libcoq-coquelicot\n")
    (exit 0))
  (define verdicts (verdict-rows coqc only))
  (define neighbours (if only '() (neighbour-rows coqc most)))
  (when record? (record! verdicts))
  (define missing (if only '() (lost verdicts)))
  (define wrong (filter (of-outcome 'accepted 'unreadable) neighbours))
  (define text
    (string-append
     (verdict-table verdicts) "\n" (neighbour-table neighbours) "\n" (writing-text verdicts)
     (sum-text verdicts)
     (format "not accepted, though the record says so: ~a\n" (if (null? missing) "none" missing))
     (format "false neighbours accepted or unreadable: ~a\n"
             (if (null? wrong) "none" (map row-name wrong)))))
  (display text)
  (display-lines-to-file (append (map row->text (append verdicts neighbours)) (list text))
                         (build-path top "build" "certificates.txt") #:exists 'truncate)
  (exit (if (and (null? missing) (null? wrong)) 0 1)))
