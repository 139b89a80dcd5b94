#lang racket/base
;; A class in which many wish ill: none escapes, none changes another's result, and each is
;; reported as what it is.

(require (prefix-in m: mechanics)
         mechanics/teaching/class/class-page
         mechanics/teaching/class/class-tables
         (only-in mechanics/teaching/class/process-cost waits-known?)
         mechanics/teaching/class/grade
         mechanics/teaching/class/submission
         mechanics/teaching/worksheet/judgment
         mechanics/teaching/worksheet/make-exercise
         mechanics/teaching/worksheet/make-worksheet
         racket/file
         racket/string
         racket/tcp
         xml
         "../../support/checks.rkt" "../../support/evaluated-here.rkt"
         "../../support/hostile-programs.rkt" "../../support/isolated.rkt"
         "../../support/patience.rkt")

(define folder (make-temporary-file "mechanics-hostile~a" 'directory))
(file-or-directory-permissions folder #o755)
(define canary (path->string (build-path folder "canary.txt")))
(define (sing) (display-to-file "still here" canary #:exists 'truncate))
(sing)

(define listener (tcp-listen 0 4 #t "127.0.0.1"))
(define-values (_a port _b _c) (tcp-addresses listener #t))

(define (motion t) (m:* 'a (m:sin (m:* (m:sqrt (m:/ 'k 'm)) t))))
(define (L local) (m:- (m:* 1/2 'm (m:square (m:velocity local)))
                       (m:* 1/2 'k (m:square (m:coordinate local)))))

(define w
  (make-worksheet
   "Hostile" #f "hostile"
   (list (make-exercise 'frequency 'expression "?" (list (list 'key (m:sqrt (m:/ 'k 'm)))))
         (make-exercise 'motion 'solution "?"
                        (list '(coordinates x) (list 'of L) (list 'key motion)))
         (make-exercise 'why 'reason "?" '()))))

(define honest
  (with-answer "(define (motion t) (* 'a (sin (* (sqrt (/ 'k 'm)) t))))"
               "(define why \"because\")"))

;; ---------------------------------------------------------------------------
;; Two classes, of those who take all their time and of the others

(define (write-class name programs)
  (define place (build-path folder name))
  (make-directory place)
  (for ([h (in-list programs)])
    (display-to-file (hostile-text h) (build-path place (string-append (hostile-name h) ".rkt"))))
  (display-to-file honest (build-path place "aaa-honest.rkt"))
  (display-to-file honest (build-path place "zzz-honest.rkt"))
  place)

(define quick (quick-programs canary port canary))
(define quick-class (write-class "quick" quick))
(define slow-class (write-class "slow" slow-programs))

;; Files that are not run at all.
(define (in-quick name) (build-path quick-class name))
(call-with-output-file (in-quick "large.rkt") (lambda (out) (file-truncate out 100000000)))
(display-to-file #"#lang mechanics\n\xFF\xFE" (in-quick "bytes.rkt"))
(display-to-file "  \n" (in-quick "empty.rkt"))
(make-file-or-directory-link canary (in-quick "link.rkt"))
(make-directory (in-quick "folder.rkt"))
(make-directory (in-quick "two-files"))
(for ([n '("a.rkt" "b.rkt")]) (display-to-file honest (build-path (in-quick "two-files") n)))
(make-directory (in-quick "one-file"))
(display-to-file honest (build-path (in-quick "one-file") "answer.rkt"))

;; seconds : what an idle machine takes for the honest, with room
(define (graded-class place seconds)
  (define granted ((if (waits-known?) processor-seconds clock-seconds) seconds))
  (define r
    (grade-class w (folder->submissions 'check place) #:seconds granted
                 #:collect (collect-here-if harmless?)))
  (values r (for/hash ([g (in-list (class-report-graded r))])
              (values (submission-id (graded-submission g)) g))))

(define-values (quick-report quick-results) (graded-class quick-class 30))
(define-values (slow-report slow-results) (graded-class slow-class 3))

;; ---------------------------------------------------------------------------
;; Each is reported as what it is

(define (status-of g k) (judgment-status (list-ref (graded-judgments g) k)))

(define (check-hostile h results)
  (define g (hash-ref results (hostile-name h)))
  (define expected (hostile-expected h))
  (define told (format "~s ~s" (graded-problem g) (graded-judgments g)))
  (cond [(regexp? expected)
         (check-true (and (graded-problem g) (regexp-match? expected (graded-problem g))) told)]
        [(eq? expected 'any) (check-true (graded? g))]
        [else (check-equal? (status-of g 0) expected told)]))

(for ([h (in-list quick)])
  (test-case (hostile-name h) (check-hostile h quick-results)))
(for ([h (in-list slow-programs)])
  (test-case (hostile-name h) (check-hostile h slow-results)))

(test-case "files that cannot be submissions are not opened, and it is said why"
  (for ([(id expected) (hash "large" #rx"100000000 bytes" "bytes" #rx"UTF-8" "empty" #rx"empty"
                             "link" #rx"link" "folder" #rx"folder" "two-files" #rx"several")])
    (check-regexp-match expected (graded-problem (hash-ref quick-results id)))))

(test-case "the honest are judged as ever"
  (for ([results (list quick-results slow-results)] [quick? '(#t #f)])
    (for ([id '("aaa-honest" "zzz-honest")])
      (define g (hash-ref results id))
      (check-false (graded-problem g))
      (check-equal? (map judgment-status (graded-judgments g)) '(right right kept))))
  (check-equal? (status-of (hash-ref quick-results "one-file") 1) 'right))

(test-case "an answer that loops costs only itself and what follows it"
  (check-equal? (map judgment-status (graded-judgments (hash-ref slow-results "answer-that-loops")))
                '(right failed failed)))

;; Answers after it were told to have taken too long.
(test-case "an answer that ends the program costs only itself"
  (define g (hash-ref quick-results "answer-that-exits"))
  (check-equal? (map judgment-status (graded-judgments g)) '(right failed kept)))

(test-case "two answers to one item are told"
  (check-equal? (graded-notes (hash-ref quick-results "answered-twice"))
                '("frequency is answered twice; the last answer was judged")))

(test-case "no file was touched, and nobody called"
  (check-equal? (file->string canary) "still here")
  (check-false (tcp-accept-ready? listener)))

;; ---------------------------------------------------------------------------
;; Reports

(test-case "the page is well-formed, and nothing on it is a student's markup"
  (define text (class->page quick-report))
  (check-not-exn
   (lambda () (read-xml (open-input-string (string-replace text "<!DOCTYPE html>" "")))))
  (check-false (regexp-match? #rx"<script|<img src=x" text))
  (check-true (string-contains? text "&lt;script&gt;alert(1)")))

(test-case "no cell of the table begins like a formula"
  (define text (class->csv quick-report))
  (check-false (regexp-match? #px"(?m:(^|,)\"?[=+@|%-])" text))
  (check-true (string-contains? text "\"'=HYPERLINK(\"\"http://x\"\"")))

;; ---------------------------------------------------------------------------
;; Means of escape from the sandbox reach nothing

(define (tried i form) (isolated i form "racket/tcp" "racket/system" "racket/file"))

;; form : whose values are written; -> the values as they are read
(define (values-tried i . forms)
  (define (guarded form) `(with-handlers ([void (lambda (e) 'refused)]) ,form))
  (read (open-input-string (tried i `(write (list ,@(map guarded forms)))))))

(call-with-namespaces
 (lambda (i)
   (test-case "no file of the teacher's can be read, none written, nobody reached"
     (check-equal? (values-tried i ''here
                                 `(file->string ,canary)
                                 `(display-to-file "gone" ,canary)
                                 '(display-to-file "x" "/usr/share/x")
                                 '(display-to-file "x" "/x")
                                 `(directory-list ,(path->string folder))
                                 `(begin (tcp-connect "127.0.0.1" ,port) 'connected))
                   (cons 'here (for/list ([_ 6]) 'refused))))
   (test-case "it sees no process but its own, has no environment, and is nobody"
     (define seen
       (values-tried i
                     '(for/list ([p (directory-list "/proc")]
                                 #:when (regexp-match? #rx"^[0-9]+$" (path->string p)))
                        (path->string p))
                     '(environment-variables-names (current-environment-variables))
                     '(file->string "/proc/self/status")))
     (check-equal? (car seen) '("1"))
     (check-false (ormap (lambda (name) (regexp-match? #rx"HOME|PATH|USER" name)) (cadr seen)))
     (check-regexp-match #rx"CapEff:\t0+\nCapBnd:\t0+\n" (caddr seen)))
   (test-case "what it starts ends with it"
     (check-equal? (tried i '(begin (system "sleep 1000 &") (display 'started))) "started"))
   (test-case "nothing was touched"
     (check-equal? (file->string canary) "still here")
     (check-false (tcp-accept-ready? listener)))))

(tcp-close listener)
(delete-directory/files folder)
