#lang racket/base
;; Documents for LaTeX: nothing in them is a command of its own, and LaTeX takes them.

(require racket/file
         racket/list
         racket/port
         racket/string
         mechanics mechanics/plot
         (only-in mechanics/algebra/notation/tree plain report report-line)
         "../../support/checks.rkt" "../../../../mechanics/show/document/TeX-document.rkt"
         "../../../../mechanics/show/document/TeX-prose.rkt"
         "../../../../mechanics/show/document/document-piece.rkt"
         "../../../../mechanics/show/document/shown-result.rkt"
         (only-in "../../../../mechanics/show/plot/on-demand.rkt" can-draw?)
         "../../support/skip.rkt")

(define (shown x) (result (value->shown x)))

(define (TeX pieces [base "doc"])
  (document->TeX (document "A title: 100% & more_" "#lang mechanics" pieces) base))

(define evil "\\end{document}\\input{/etc/passwd} $x_1^2$ #~%&{}")

(test-case "text is text"
  (check-equal? (prose->TeX "50% of m_1 & {x}") "50\\% of m\\_1 \\& \\{x\\}")
  (check-equal? (prose->TeX "10⁻⁸ θ\u307²")
                (string-append "10\\ensuremath{^{-}}\\ensuremath{^{8}} "
                               "\\ensuremath{\\dot{\\ensuremath{\\theta}}}\\ensuremath{^{2}}"))
  (check-equal? (prose->TeX "a-priori it's -- ''so''") "a-priori it's -{-} '{'}so'{'}")
  (check-equal? (prose->TeX "“a”–b′ §")
                "\\textquotedblleft{}a\\textquotedblright{}--b\\ensuremath{'} \\S{}")
  (check-equal? (code->TeX "(a  b)") "(a~~b)")
  (check-false (regexp-match? #px"(?<!\\\\)[$&#%_]|\\\\(end|input)" (prose->TeX evil))))

(define (written . pieces)
  (define-values (text pictures) (TeX pieces))
  (cadr (regexp-match #rx"\\\\maketitle\n\n(.*)\n\n\\\\end{document}" text)))

(test-case "headings, failures, lists of verdicts and words of a program have their forms"
  (check-equal? (written (heading "A & b")) "\\section*{A \\& b}")
  (check-equal? (written (failure "oh no")) "\\begin{program}\noh no\n\\end{program}")
  (define proved "\\begin{flushleft}\nproved: the residual is zero\n\\end{flushleft}")
  (define v (verify-equal 'x 'x))
  (check-equal? (written (shown (list v v))) (string-append proved "\n\n" proved))
  (define lines (for/list ([depth 2]) (report-line depth "name:" (list (plain "a_b")))))
  (define line "name: \\texttt{a\\_b}")
  (check-equal? (written (result (shown-formula (report lines) '())))
                (string-append "\\begin{flushleft}\n" line "\\\\\n\\hspace*{2em}" line
                               "\n\\end{flushleft}")))

(test-case "rows of numbers and events are tables"
  (define (table columns . lines)
    (string-append "\\begin{center}\n\\begin{tabular}{" columns "}\n" (string-append* lines)
                   "\\end{tabular}\n\\end{center}"))
  (define (row . cells)
    (string-append (string-join (map (lambda (c) (format "$\\displaystyle ~a$" c)) cells) " & ")
                   "\\\\\n"))
  (check-equal? (written (shown (list (list 1 2.5) (list 3 4))))
                (table "ll" (row 1 2.5) (row 3 4)))
  (define events (shown-table '("event" "time") (list (list (plain "a_b") (plain "1")))))
  (check-equal? (written (result events))
                (table "ll" "event & time\\\\\n\\hline\n"
                       "\\texttt{a\\_b} & \\texttt{1}\\\\\n")))

;; The program environment of a text, and the lines that declare its characters.
(define (program text)
  (define-values (document pictures) (TeX (list (code text 0))))
  (list (cadr (regexp-match #rx"\\\\begin{program}\n(.*?)\n\\\\end{program}\n" document))
        (regexp-match* #px"(?m:^\\\\letter[{].*$)" document)))

(test-case "a program is in it as it is written, and can be edited"
  (define text "(define ((L 'm_1) local)\n\n  (* 1/2 #t \"50%\")) ; \\alpha & {x} -- ~^")
  (check-equal? (program text) (list text '()))
  (check-equal? (program "θ\u307 ½ é Ж")
                '("θ\u307 ½ é Ж"
                  ("\\letter{00BD}{\\ensuremath{\\tfrac{1}{2}}}"
                   "\\letter{0307}{\\llap{\\ensuremath{\\dot{\\phantom{\\theta}}}}}"
                   "\\letter{03B8}{\\ensuremath{\\theta}}" "\\letter{0416}{(U+416)}"))))

(test-case "nothing in a program ends it"
  (define end "\\end{program}\\end {program}\\end  {program}")
  (check-false (regexp-match? #px"\\\\end *[{]" (car (program end))))
  (check-equal? (string-replace (car (program end)) "\u200B" "") end)
  (check-equal? (program "\u1B[0m\t\r") '("(U+1B)[0m    (U+D)" ())))

(define all-kinds
  (list (heading evil) (prose (list (list evil "½ m (l θ\u307)², x → ∞, “quoted” – 10⁻⁸ ⟨x⟩ Ж")))
        (code "(define (f x)\n\n  (* 1/2 x)) ; \\alpha_1 θ\u307 x\u20DB é Ж \u0 \uFFFE 𝐢" 0)
        (folded "Tests" evil) (output "\\end{program} \\end {program} \\undefined")
        (output evil) (output (->text (up (/ 'a 'b) (sqrt (/ 'c 'd))))) (failure evil)
        (shown (* 1/2 'm (square 'thetadot))) (shown (up 'a (/ 'b 'c)))
        (shown (string->symbol evil)) (shown evil) (shown (sqrt (square 'x)))
        (shown (verify-equal (* 'a 'x) 'b)) (shown (list (list 1 2.5) (list 3 4)))
        (shown (matrix-by-rows (list 'a 'b) (list 'c 'd)))
        (shown (apply + (for/list ([i 12]) (* 'amplitude (sin (* i 'omega 't))))))))

(define (LaTeX folder text)
  (define file (build-path folder "doc.tex"))
  (display-to-file text file)
  (define-values (process out in err)
    (parameterize ([current-directory folder])
      (subprocess #f #f 'stdout (find-executable-path "pdflatex")
                  "-interaction=nonstopmode" "-halt-on-error" "-no-shell-escape" "doc.tex")))
  (close-output-port in)
  (define log (port->string out))
  (subprocess-wait process)
  (values (subprocess-status process) log))

(test-case "what formulas in text are drawn with is drawn, too"
  (check-false (regexp-match? #rx"U[+]" (prose->TeX (->text (up (/ 'a 'b) (sqrt (/ 'c 'd)))))))
  (check-false (regexp-match? #rx"U[+]" (prose->TeX (->text (down 'a (up 'b (/ 'c 'd))))))))

(test-case "LaTeX takes all of it"
  (skip-unless (find-executable-path "pdflatex") "documents for LaTeX: pdflatex is not here"
    (define folder (make-temporary-file "TeX~a" 'directory))
    (define f (frame 0 1 0 1))
    (define pieces (if (can-draw?) (append all-kinds (list (shown f))) all-kinds))
    (define-values (text pictures) (TeX pieces (build-path folder "doc")))
    (for ([p (in-list pictures)]) (display-to-file (cdr p) (car p)))
    (define-values (status log) (LaTeX folder text))
    (check-equal? status 0 (last (string-split log "!")))
    (check-true (file-exists? (build-path folder "doc.pdf")))
    (delete-directory/files folder)))

(test-case "pictures are numbered files beside it"
  (skip-unless (can-draw?) "pictures for LaTeX: the libraries that draw are not here"
    (define-values (text pictures)
      (TeX (list (shown (frame 0 1 0 1)) (shown (frame 0 2 0 1))) (build-path "/tmp/some/doc")))
    (check-equal? (map (lambda (p) (path->string (car p))) pictures)
                  '("/tmp/some/doc-1.pdf" "/tmp/some/doc-2.pdf"))
    (for ([name '("{doc-1.pdf}" "{doc-2.pdf}")]) (check-true (string-contains? text name)))
    (for ([p pictures]) (check-true (regexp-match? #rx#"^%PDF" (cdr p))))))
