#lang racket/base
;; Judgements of Coq, kept in build/certification/ between runs: a text is given to it once,
;; until that folder is deleted.
;;
;; Loading Coq's libraries takes longer than most proofs.  So files go to it by tens, as modules of
;; one; where that is not accepted, or not in the time of one, each goes alone.

(require file/sha1 racket/file racket/list racket/runtime-path racket/string racket/system
         mechanics/certificate/Coq-check)

(provide judge-all judge-alone expect-rejections errors-in-sessions longest
         rejected-by-proof? judgement-late? lasting?)

(define-runtime-path folder "../../../../build/certification")
(define (kept-file) (build-path folder "judgements.rktd"))

(define longest 20)                     ; seconds in which a certificate is to be accepted
(define patience (* 6 longest))         ; by the clock

;; hash from texts' digests to (outcome seconds message)
(define kept #f)

(define (load-kept!)
  (make-directory* folder)
  (set! kept (make-hash (if (file-exists? (kept-file)) (file->list (kept-file)) '()))))

(define (digest text) (sha1 (open-input-string text)))

;; -> judgement or #f
(define (kept-judgement text)
  (unless kept (load-kept!))
  (define old (hash-ref kept (digest text) #f))
  (define j (and old (apply judgement old)))
  (and j (lasting? j) j))

;; A judgement is not used again where only the clock ran out, on a busy machine perhaps.
(define (lasting? j)
  (or (not (eq? 'unfinished (judgement-outcome j))) (> (judgement-seconds j) longest)))

(define (keep! text j)
  (define value (list (judgement-outcome j) (judgement-seconds j) (judgement-message j)))
  (hash-set! kept (digest text) value)
  (call-with-output-file (kept-file) #:exists 'append
    (lambda (out) (writeln (cons (digest text) value) out))))

(define (judgement-late? j)
  (or (eq? 'unfinished (judgement-outcome j)) (> (judgement-seconds j) longest)))

;; Does Coq's message speak of a proof, and not of a text that it cannot read?
(define (rejected-by-proof? j)
  (not (regexp-match? #rx"Syntax error|not found in the current environment|has type"
                      (judgement-message j))))

;; -> judgement; the text stands in the folder under the name while it is not accepted
(define (judge-alone coqc name text)
  (define old (kept-judgement text))
  (define j (or old (check-by-Coq coqc text patience)))
  (unless old
    (keep! text (if (judgement-late? j) (struct-copy judgement j [outcome 'unfinished]) j)))
  (define plain (regexp-replace* #px"[^A-Za-z0-9]" name "_"))
  (define file (build-path folder (string-append plain ".v")))
  (if (judgement-accepted? j)
      (when (file-exists? file) (delete-file file))
      (display-to-file text file #:exists 'truncate))
  j)

;; Judges many texts of certificates, most of which will be accepted.
(define (judge-all coqc texts)
  (load-kept!)
  (define new (filter (lambda (t) (not (kept-judgement t))) (remove-duplicates texts)))
  (for* ([alike (in-list (group-by preamble new))]
         [some (in-list (in-tens alike))] #:when (pair? (cdr some)))
    (define j (check-by-Coq coqc (as-modules some) patience))
    (when (and (judgement-accepted? j) (not (judgement-late? j)))
      (for ([t (in-list some)])
        (keep! t (judgement 'accepted (/ (judgement-seconds j) (length some)) ""))))))

(define (in-tens xs)
  (if (> (length xs) 10) (cons (take xs 10) (in-tens (drop xs 10))) (list xs)))

;; The part that the files have in common, and the rest
(define (preamble text) (car (parts text)))
(define (parts text)
  (define start (caar (regexp-match-positions #rx"Definition hypotheses" text)))
  (list (substring text 0 start) (substring text start)))

(define (as-modules texts)
  (define last-line "Print Assumptions certificate.\n")
  (define names (for/list ([_ (in-list texts)] [k (in-naturals 1)]) (format "File_~a" k)))
  (string-append
   (preamble (car texts))
   (string-append*
    (for/list ([t (in-list texts)] [name (in-list names)])
      (define rest (string-replace (cadr (parts t)) last-line ""))
      (format "Module ~a.\n~aEnd ~a.\n\n" name rest name)))
   (format "Definition certificate := ~a.\n~a"
           (for/fold ([all "I"]) ([name (in-list names)])
             (format "(conj ~a.certificate ~a)" name all))
           last-line)))

;; ---------------------------------------------------------------------------
;; Texts that are to be rejected, in one session of Coq, which goes on after errors

;; Keeps the judgement of each that is rejected; what has no error or takes long goes to coqc.
(define (expect-rejections texts)
  (errors-in-sessions (filter (lambda (t) (not (kept-judgement t))) texts)
                      (lambda (t error seconds)
                        (when error (keep! t (judgement 'rejected seconds error))))))

;; use : text, its error or #f, and seconds; called with each
(define (errors-in-sessions texts use)
  (define coqtop (find-executable-path "coqtop"))
  (for* ([alike (in-list (group-by preamble texts))]
         [some (in-list (in-tens alike))] #:when coqtop)
    (define start (current-process-milliseconds 'subprocesses))
    (define said (said-in-session coqtop some))
    (define seconds (/ (- (current-process-milliseconds 'subprocesses) start) 1000.0 (length some)))
    (for ([t (in-list some)] [message (in-list said)])
      (define e (regexp-match #rx"Error:(.*?)\n\n" message))
      (use t (and e (not (regexp-match? #rx"Timeout" (cadr e))) (string-trim (cadr e))) seconds))))

;; -> what Coq says of each; a step may take so long as a certificate
(define (said-in-session coqtop texts)
  (define home (make-temporary-file "session~a" 'directory))
  (parameterize ([current-directory home])
    (display-to-file (session texts) "in.v")
    (call-with-output-file "out.txt"
      (lambda (said)
        (call-with-input-file "in.v"
          (lambda (commands)
            (define control
              (list-ref (process*/ports said commands 'stdout coqtop "-q" "-w" "none") 4))
            (control 'wait)))))
    (begin0
      (cdr (regexp-split #rx"mark_[0-9]+ is defined" (file->string "out.txt")))
      (delete-directory/files home))))

(define (session texts)
  (format "~aSet Default Timeout ~a.\n~a" (preamble (car texts)) longest
          (string-append*
           (for/list ([t (in-list texts)] [k (in-naturals)])
             (format "Definition mark_~a := tt.\n~a\nAbort All.\nReset mark_~a.\n"
                     k (cadr (parts t)) k)))))
