#lang racket/base
;; `raco mechanics show` and `tex`: programs of all sorts, what is written and what is told.

(require racket/file
         racket/list
         racket/string
         (only-in xml document-element read-xml)
         "../../support/checks.rkt" "../../../../mechanics/show/document/document-piece.rkt"
         "../../../../mechanics/show/document/shown-result.rkt"
         "../../../../mechanics/lang/command/raco.rkt"
         "../../../../mechanics/lang/command/program-document.rkt")

(define folder (make-temporary-file "show~a" 'directory))

(define (write-program name . lines)
  (define file (build-path folder name))
  (display-lines-to-file lines file #:exists 'truncate)
  file)

;; The pieces of the document of a program, and the message of its error or #f.
(define (document-of . lines)
  (define-values (d error) (program-document 'show (apply write-program "program.rkt" lines)))
  (list (document-pieces d) error))
(define (pieces . lines) (car (apply document-of lines)))

(define (what p)
  (cond [(code? p) (code-text p)] [(output? p) (list 'printed (output-text p))]
        [(failure? p) (list 'failed (failure-text p))] [(prose? p) (prose-paragraphs p)]
        [(folded? p) (list 'folded (folded-label p))]
        [(heading? p) (list 'heading (heading-text p))]
        [(shown-text? (result-shown p)) (list 'text (shown-text-text (result-shown p)))]
        [(shown-formula? (result-shown p)) 'formula]
        [else 'other]))

(define (outline . lines) (map what (apply pieces lines)))

;; ---------------------------------------------------------------------------
;; Forms and what comes of them

(test-case "every form as it is written, with what it prints and gives"
  (check-equal?
   (outline "#lang mechanics" ";; A title" "" ";; Some words." "(define (f x)" "  (* 2 x)) ; twice"
            "(define y 'a)" "(f y)" "(begin (printf \"hello\\n\") (values 'one \"two\"))"
            ";; ------------" ";; More" "(display \"end\")")
   '((("Some words.")) "(define (f x)\n  (* 2 x)) ; twice\n(define y 'a)\n(f y)" formula
     "(begin (printf \"hello\\n\") (values 'one \"two\"))" (printed "hello\n") (text "one")
     (text "\"two\"") (heading "More") "(display \"end\")" (printed "end"))))

(test-case "output and results of a form stay in their order"
  (check-equal? (outline "#lang mechanics" "(define (say x) (printf \"~a\" x) x)"
                         "(begin (say 1) (say 2))")
                '("(define (say x) (printf \"~a\" x) x)\n(begin (say 1) (say 2))"
                  (printed "1") formula (printed "2") formula)))

(test-case "what print-expression and show-expression print is typeset, but in another style"
  (check-equal?
   (outline "#lang mechanics" "(require racket/port)"
            "(begin (printf \"first\\n\") (print-expression (/ 'a 'b)) (show-expression 'c))"
            "(print-expression (/ 'a 'b) #:as 'infix)"
            "(with-output-to-string (lambda () (print-expression (/ 'a 'b))))"
            "(show-derivation (Lagrange-equations (lambda (s) (square (velocity s)))) cube)")
   '("(require racket/port)
(begin (printf \"first\\n\") (print-expression (/ 'a 'b)) (show-expression 'c))"
     (printed "first\n") formula formula
     "(print-expression (/ 'a 'b) #:as 'infix)" (printed "a/b\n")
     "(with-output-to-string (lambda () (print-expression (/ 'a 'b))))" (text "\"(/ a b)\\n\"")
     "(show-derivation (Lagrange-equations (lambda (s) (square (velocity s)))) cube)" formula)))

(test-case "words in a list of formulas are typeset with them; quoted data are not"
  (check-equal? (outline "#lang mechanics" "(list (list (acos 'x) 'stable) '(0 unstable))"
                         "'((0 stable))")
                '("(list (list (acos 'x) 'stable) '(0 unstable))" formula
                  "'((0 stable))" (text "'((0 stable))"))))

(test-case "the program runs as it would by itself"
  ;; a name used before its definition, one defined twice, a macro, a file beside it, a submodule
  (write-program "beside.rkt" "#lang racket/base" "(provide six)" "(define six 6)")
  (check-equal?
   (outline "#lang mechanics" "(require \"beside.rkt\")" "(define (g) (h))" "(define (h) \"first\")"
            "(g)" "(define (h) \"second\")" "(g)" "(define-syntax-rule (twice x) (list x x))"
            "(twice \"a\")" "(provide g)" "(module+ test (error \"never\"))"
            "(module+ main (error \"never\"))" "(number->string six)")
   '("(require \"beside.rkt\")\n(define (g) (h))\n(define (h) \"first\")\n(g)" (text "\"first\"")
     "(define (h) \"second\")\n(g)" (text "\"second\"")
     "(define-syntax-rule (twice x) (list x x))\n(twice \"a\")" (text "'(\"a\" \"a\")")
     "(provide g)" (folded "Tests") (folded "Submodule main")
     "(number->string six)" (text "\"6\""))))

(test-case "what a program assumes and sets is gone when it ends; there is nothing to read"
  (define lines '("#lang mechanics" "(length (assumptions))" "(assume '(> x 0))"
                  "(derivative-style)" "(derivative-style 'D)" "(eof-object? (read))"))
  (check-equal? (apply outline lines) (apply outline lines))
  (check-not-false (member '(text "#t") (apply outline lines))))

(test-case "line ends of other systems, a mark at the start, other languages"
  (define file (build-path folder "crlf.rkt"))
  (display-to-file
   "\uFEFF#lang racket/base\r\n; θ\u307 here\r\n\r\n(define x\r\n  1)\r\nx\r\n" file)
  (define-values (d error) (program-document 'show file))
  (check-false error)
  (check-equal? (document-language d) "#lang racket/base")
  (check-equal? (map what (document-pieces d)) '("(define x\n  1)\nx" formula)))

(test-case "a module that is written with its name runs form by form as any other"
  (define file (build-path folder "one.rkt"))
  (display-to-file "(module one racket/base\n  (* 2 3))\n" file)
  (define-values (d error) (program-document 'show file))
  (check-false error)
  (check-not-false (memq 'formula (map what (document-pieces d)))))

(test-case "an empty program is an empty page"
  (check-equal? (document-of "#lang mechanics" "") '(() #f)))

;; ---------------------------------------------------------------------------
;; Errors

(test-case "an error stands in its place; what follows is shown, and was not run"
  (define result (document-of "#lang mechanics" "\"before\"" "(car 5)" "(display \"never\")"))
  (check-regexp-match #rx"^car: contract violation" (cadr result))
  (define told (map what (car result)))
  (check-equal? (first told) "\"before\"")
  (check-equal? (third told) "(car 5)")
  (check-regexp-match #rx"in: program.rkt, line 3" (cadr (fourth told)))
  (check-equal? (drop told 4)
                '((failed "The program stopped here; what follows was not run.")
                  "(display \"never\")")))

(test-case "a program that cannot be compiled says where"
  (define result
    (document-of "#lang mechanics" "\"before\"" "(define x (+ 1 nothing-such))" "'after"))
  (define told (map what (car result)))
  (check-equal? (first told) "\"before\"\n(define x (+ 1 nothing-such))")
  (check-regexp-match #rx"unbound identifier; as a symbol it is written 'nothing-such"
                      (cadr (second told)))
  (check-equal? (third told)
                '(failed "The program could not be compiled; nothing of it was run.")))

(test-case "what is raised and no error, and a program that ends itself"
  (check-regexp-match #rx"raised, though it is no error: 'oops"
                      (cadr (document-of "#lang mechanics" "(raise 'oops)")))
  (define ended (document-of "#lang mechanics" "(exit 3)" "'after"))
  (check-false (cadr ended))
  (check-equal? (second (map what (car ended)))
                '(failed "The program ended itself here; what follows was not run.")))

;; ---------------------------------------------------------------------------
;; The command

;; -> status, and what was printed
(define (command . arguments)
  (define out (open-output-string))
  (define status
    (parameterize ([current-output-port out] [current-error-port out] [current-directory folder])
      (run-command-line arguments)))
  (list status (get-output-string out)))

(define (files) (sort (map path->string (directory-list folder)) string<?))

(define good (write-program "good.rkt" "#lang mechanics" ";; Good" "(* 2 'x)"))
(define bad (write-program "bad.rkt" "#lang mechanics" "(car 5)"))

(test-case "a page is written, well-formed, beside the reader"
  (check-equal? (command "show" "good.rkt") '(0 "good.html\n"))
  (define text (file->string (build-path folder "good.html")))
  (check-not-exn
   (lambda ()
     (document-element
      (read-xml (open-input-string (string-replace text "<!DOCTYPE html>" ""))))))
  (check-true (string-contains? text "<h1>Good</h1>"))
  (check-equal? (command "show" "good.rkt" "-o" "other.html")
                (command "show" "-o" "other.html" "good.rkt"))
  (check-equal? (file->string (build-path folder "other.html")) text))

(test-case "a page is beside its program, wherever the reader is"
  (make-directory (build-path folder "sub"))
  (write-program (build-path "sub" "there.rkt") "#lang mechanics" "1")
  (check-equal? (command "show" "sub/there.rkt") '(0 "sub/there.html\n"))
  (check-equal? (command "tex" "sub/there.rkt") '(0 "sub/there.tex\n"))
  (check-equal? (command "show" "sub/there.rkt" "-o" "there.html") '(0 "there.html\n")))

(test-case "LaTeX is written"
  (check-equal? (command "tex" "good.rkt" "-o" "x.tex") '(0 "x.tex\n"))
  (check-true (string-contains? (file->string (build-path folder "x.tex")) "\\shown{2\\,x}")))

(test-case "a program that fails is shown, and the status says so"
  (define result (command "show" "bad.rkt"))
  (check-equal? (first result) 1)
  (check-regexp-match #rx"^bad.html\nbad.rkt did not run to its end:\ncar: contract violation"
                      (second result))
  (check-true (string-contains? (file->string (build-path folder "bad.html"))
                                "contract violation")))

(test-case "what cannot be shown is told, and nothing is written"
  (define before (files))
  (write-program "data.rkt" "(not a module)")
  (write-program "open.rkt" "#lang mechanics" "(define x (1" "")
  (display-to-file #"\xFF\xFE\0" (build-path folder "bytes.rkt"))
  (for ([(arguments message)
         (hash '("no-such.rkt") #rx"^show: there is no file no-such.rkt; the programs in its folder"
               '("data.rkt") #rx"^show: data.rkt does not say its language: its first line"
               '("open.rkt") #rx"^show: open.rkt, line 2: the \\( there is never closed"
               '("bytes.rkt") #rx"^show: bytes.rkt is no text in UTF-8; save it as such"
               '("good.rkt" "-o" "good.rkt") #rx"^show: the result would replace the program"
               '("good.rkt" "-o" "no-such/x.html") #rx"^show: there is no such folder"
               '("good.rkt" "-o" ".") #rx"^show: there is a folder of that name"
               '() #rx"^raco mechanics show: expects 1 <file>"
               '("good.rkt" "bad.rkt") #rx"^raco mechanics show: expects 1 <file>"
               '("good.rkt" "--odd") #rx"unknown switch")])
    (define result (apply command "show" arguments))
    (check-equal? (first result) 2 (format "~s" arguments))
    (check-regexp-match message (second result)))
  (check-equal? (remove* '("bytes.rkt" "data.rkt" "open.rkt") (files)) before))

(test-case "a break leaves no file"
  (write-program "endless.rkt" "#lang mechanics" "(display \"begun\" (open-output-file \"begun\"))"
                 "(let loop () (loop))")
  (define done (make-channel))
  (define runner
    (thread (lambda ()
              (channel-put done (with-handlers ([exn:break? (lambda (e) 'broken)])
                                  (command "show" "endless.rkt"))))))
  (let wait ()
    (unless (file-exists? (build-path folder "begun"))
      (sleep 0.05)
      (wait)))
  (break-thread runner)
  (check-equal? (channel-get done) 'broken)
  (check-false (file-exists? (build-path folder "endless.html"))))

(delete-directory/files folder)
