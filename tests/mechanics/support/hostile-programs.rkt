#lang racket/base
;; Submissions that wish the teacher ill, or are merely broken: what each is, its text, and what
;; is to be said of it.

(provide (struct-out hostile) slow-programs quick-programs harmless? with-answer)

;; expected : a regexp that matches the problem of the program, or the status of its answer
(struct hostile (name text expected))

(define (program . lines)
  (apply string-append "#lang mechanics\n(require mechanics/answers)\n"
         (for/list ([l (in-list lines)]) (string-append l "\n"))))

(define right "(define frequency (sqrt (/ 'k 'm)))")
(define (with-answer . lines) (apply program (append lines (list right))))
(define (answering text) (program (format "(define frequency ~a)" text)))

(define too-long #rx"took too long")

;; Each takes all the time it is given, or as much memory.
(define slow-programs
  (list
   (hostile "endless-loop" (with-answer "(let loop () (loop))") too-long)
   (hostile "endless-output" (with-answer "(let loop () (display \"x\") (loop))") too-long)
   (hostile "memory" (with-answer "(let loop ([l '()]) (loop (cons (make-bytes 10000000) l)))")
            too-long)
   (hostile "macro-that-loops"
            (with-answer "(require (for-syntax racket/base))"
                         "(define-syntax (m stx) (let loop () (loop)))" "(m)")
            too-long)
   (hostile "reader-that-loops"
            (with-answer "(define t (make-readtable #f #\\! 'terminating-macro"
                         "  (lambda _ (let loop () (loop)))))"
                         "(parameterize ([current-readtable t]) (read (open-input-string \"!\")))")
            too-long)
   (hostile "deep-recursion" (with-answer "(define (f n) (+ 1 (f n)))" "(f 0)") too-long)
   (hostile "answer-that-loops"
            (program "(define (motion t) (let loop () (loop)))" right) 'right)
   (hostile "threads-without-end" (with-answer "(let loop () (thread loop) (loop))") too-long)
   (hostile "handler-of-everything"
            (with-answer "(let again ()"
                         "  (with-handlers ([void (lambda (e) (again))]) (let loop () (loop))))")
            too-long)
   (hostile "sleeps" (with-answer "(sleep 1000)") too-long)
   (hostile "tower-of-powers" (with-answer "(expt 9 (expt 9 9))") too-long)))

;; canary : path of a file that is to stay; port : of a server that is to hear nothing
(define (quick-programs canary port key)
  (append (against-the-system canary) against-the-process against-the-report
          (harmless-programs canary port key)))

(define (harmless-programs canary port key)
  (append (against-files canary port) (against-the-teacher key) against-the-reader merely-broken))

;; Could the program of this name do nothing to the process that it runs in?
(define (harmless? name)
  (for/or ([h (in-list (harmless-programs "" 0 ""))]) (equal? name (hostile-name h))))

(define (against-files canary port)
  (list
   (hostile "reads-a-file"
            (with-answer (format "(define s (call-with-input-file ~s read-line))" canary))
            #rx"does not run")
   (hostile "deletes-a-file" (with-answer (format "(delete-file ~s)" canary)) #rx"does not run")
   (hostile "writes-a-file"
            (with-answer (format "(call-with-output-file ~s #:exists 'truncate void)" canary))
            #rx"does not run")
   (hostile "network"
            (with-answer "(require racket/tcp)" (format "(tcp-connect \"127.0.0.1\" ~a)" port))
            #rx"does not run")))

(define (against-the-system canary)
  (list
   (hostile "fork-bomb"
            (with-answer "(define (go) (subprocess #f #f #f \"/bin/sh\" \"-c\" \":(){ :|:& };:\"))"
                         "(go)")
            #rx"does not run")
   (hostile "fork-bomb-by-system"
            (with-answer "(require racket/system)" "(system \"sh -c '(sleep 100 & sleep 100 &)'\")")
            #rx"does not run")
   (hostile "foreign-functions"
            (with-answer "(require ffi/unsafe)"
                         "((get-ffi-obj \"kill\" #f (_fun _int _int -> _int)) -1 9)")
            #rx"does not run")
   (hostile "primitives-of-the-machine"
            (with-answer "(require ffi/unsafe/vm)" "(vm-eval '(system \"true\"))")
            #rx"does not run")
   (hostile "machine-code"
            (with-answer "(require mechanics/numeric/machine/executable)"
                         "(machine-procedures (bytes #xc3) '((0 flvector)))")
            #rx"does not run")
   (hostile "a-place"
            (with-answer "(require '#%place)"
                         (format "(dynamic-place '(file ~s) 'main)" canary))
            'any)
   (hostile "exit" (with-answer "(exit 0)") #rx"")
   (hostile "answer-that-exits"
            (program "(define (motion t) (exit 0))" right "(define why \"because\")") 'right)
   (hostile "kills-its-thread" (with-answer "(kill-thread (current-thread))") #rx"")
   (hostile "shuts-its-custodian" (with-answer "(custodian-shutdown-all (current-custodian))")
            #rx"")
   (hostile "environment" (with-answer "(putenv \"PATH\" \"/tmp\")") 'any)))

(define against-the-process
  (list
   (hostile "raises-what-prints-itself"
            (program "(struct trap () #:property prop:custom-write"
                     "  (lambda (x port mode) (write-string \"(frequency answer k)\" port)))"
                     "(raise (trap))")
            #rx"raised what is no error")
   (hostile "prints-lines-of-its-own"
            (program "(define out (current-output-port))"
                     "(define (frequency)"
                     "  (write-string \"(frequency answer (sqrt (/ k m)))\\n\" out) 'x)")
            'failed)
   (hostile "ports-and-parameters"
            (with-answer "(close-output-port (current-output-port))"
                         "(error-display-handler (lambda _ (error-display-handler)))"
                         "(current-print (lambda (x) (error \"no\")))"
                         "(uncaught-exception-handler (lambda (e) (let loop () (loop))))"
                         "(exit-handler void)")
            'any)
   (hostile "plumber"
            (with-answer "(plumber-add-flush! (current-plumber) (lambda (h) (error \"no\")))") 'any)
   (hostile "logger"
            (with-answer "(for ([i 10000]) (log-error \"line ~a\" i))") 'right)))

(define (against-the-teacher key)
  (list
   (hostile "redefines-the-questions"
            (program "(define (verify-solution . _) (prove-zero 0))"
                     "(define (verify-equal . _) (prove-zero 0))" "(define (proved? v) #t)"
                     "(define frequency 'wrong)")
            'wrong)
   (hostile "a-verdict-for-an-answer" (answering "(prove-zero 0)") 'failed)
   (hostile "forged-kind"
            (program "(require mechanics/generic/kind)"
                     "(struct trap () #:property prop:kind"
                     "  (make-kind #:rank 0 #:describe (lambda (x) \"x\")"
                     "             #:datum (lambda (x) '(sqrt (/ k m)))))"
                     "(define frequency (trap))")
            'failed)
   (hostile "looks-for-the-key"
            (program (format "(define frequency (dynamic-require '(file ~s) 'worksheet))" key))
            #rx"does not run")
   (hostile "assumes-what-it-likes"
            (program "(assume '(< k 0))" "(automatic-assumptions #f)" "(define frequency 0)")
            'wrong)))

(define against-the-reader
  (list
   (hostile "name-of-a-quantity"
            (answering "(string->symbol \"k) (motion answer 0)\\n(motion answer\")") 'failed)
   (hostile "markup-for-a-name"
            (answering "(string->symbol \"<script>alert(1)</script>\")") 'failed)
   (hostile "too-many-parts"
            (answering "(for/fold ([e 'x]) ([i 30]) (* (sin e) (cos e)))") 'failed)
   (hostile "number-too-long" (answering "(expt 7 20000)") 'failed)))

(define against-the-report
  (list
   (hostile "markup-for-a-reason"
            (with-answer ";; Name: =HYPERLINK(\"http://x\",\"y\")<img src=x onerror=alert(1)>"
                         "(define why \"</p><script>alert(1)</script>\")")
            'right)
   (hostile "quotes'\"<b>and&spaces in its name" (with-answer) 'right)))

(define merely-broken
  (list
   (hostile "no-language" "(define frequency 1)" #rx"does not run")
   (hostile "unbalanced" "#lang mechanics\n(define frequency (sqrt" #rx"does not run")
   (hostile "another-language" "#lang racket/base\n(define frequency 'k)" 'wrong)
   (hostile "unbound" (with-answer "(no-such-thing 1)") #rx"does not run")
   (hostile "not-answered" (program) 'unanswered)
   (hostile "answered-twice" (program "(define frequency 'k)" right) 'right)))
