#lang racket/base
;; A document for LaTeX, with amsmath.  Pictures are files beside it, in PDF where possible.
;;
;; The program stands in it as it is written, in an environment of which nothing is a command; its
;; characters beyond ASCII are declared before (TeX-prose.rkt).

(require racket/path
         racket/string
         "TeX-prose.rkt" "document-piece.rkt" "shown-interaction.rkt" "shown-result.rkt"
         "../../algebra/notation/tree.rkt"
         "../typesetting/TeX.rkt" "../typesetting/break.rkt")

(provide document->TeX)

;; base : path of the file to be written, without its extension
;; -> string, and ((path . bytes) ...)
(define (document->TeX d base)
  (define names (make-hasheq))
  (define pictures
    (for*/list ([p (in-list (document-pieces d))] #:when (result? p)
                [s (in-value (still (result-shown p)))] #:when (shown-picture? s))
      (define extension (if (shown-picture-pdf s) "pdf" "png"))
      (define file (path-add-extension base (format "-~a.~a" (+ 1 (hash-count names)) extension)
                                       #""))
      (hash-set! names s (path->string (file-name-from-path file)))
      (cons file (or (shown-picture-pdf s) (shown-picture-png s) #""))))
  (define body (string-append* (map (lambda (p) (piece->TeX p names)) (document-pieces d))))
  (values (string-append preamble
                         (declarations
                          (regexp-match* #rx"\\\\begin{program}.*?\\\\end{program}" body))
                         (format "\\title{~a}\n" (prose->TeX (document-title d)))
                         "\\author{}\\date{}\n\n\\begin{document}\n\\maketitle\n\n"
                         body
                         "\\end{document}\n")
          pictures))

;; An interaction is shown in its first state.
(define (still s) (if (shown-interaction? s) (shown-first s) s))

(define preamble #<<TeX
\documentclass[a4paper]{article}
\usepackage[utf8]{inputenc}
\usepackage[T1]{fontenc}
\usepackage{amsmath,graphicx,textcomp,verbatim}
\IfFileExists{lmodern.sty}{\usepackage{lmodern}}{}
\setlength{\textwidth}{16cm}\setlength{\oddsidemargin}{0pt}
\setlength{\textheight}{24cm}\setlength{\topmargin}{-1.5cm}
\setlength{\parindent}{0pt}\setlength{\parskip}{0.5\baselineskip}
\allowdisplaybreaks
% a result
\newcommand{\shown}[1]{\par\smallskip\noindent\hspace*{1.5em}$\displaystyle #1$\par\smallskip}
% programs, and what they print: lines as they are written; one that is too long goes on beneath
\makeatletter
\newenvironment{program}{\footnotesize
  \def\@xobeysp{\ifvmode\leavevmode\nobreak\fi\ }%
  \def\verbatim@processline{\rightskip 0pt plus 1fil\relax\hangindent 4em\hangafter 1
    \the\verbatim@line\par}%
  \verbatim}{\endverbatim}
\begingroup\catcode`'=\active\catcode``=\active
\g@addto@macro\@noligs{\let`\textasciigrave\let'\textquotesingle}\endgroup
% characters of theirs beyond ASCII
\ifdefined\DeclareUnicodeCharacter
  \newcommand{\letter}[2]{\DeclareUnicodeCharacter{#1}{#2}}
\else
  \newcommand{\letter}[2]{\catcode"#1=\active\begingroup\lccode`\~="#1
    \lowercase{\endgroup\protected\def~}{#2}}
\fi
\makeatother

TeX
  )

;; ---------------------------------------------------------------------------
;; Pieces

(define (piece->TeX p names)
  (cond [(heading? p) (format "\\section*{~a}\n\n" (prose->TeX (heading-text p)))]
        [(prose? p)
         (string-append* (for/list ([lines (in-list (prose-paragraphs p))])
                           (string-append (string-join (map prose->TeX lines) "\\\\\n") "\n\n")))]
        [(code? p) (program (code-text p))]
        [(folded? p)
         (string-append (format "\\textit{~a}\n" (prose->TeX (folded-label p)))
                        (program (folded-text p)))]
        [(output? p) (program (output-text p))]
        [(failure? p) (program (failure-text p))]
        [else (shown->TeX (result-shown p) names)]))

(define (program text)
  (format "\\begin{program}\n~a\n\\end{program}\n\n" (verbatim-text (string-trim text "\n"))))

(define (shown->TeX s names)
  (cond [(shown-interaction? s)
         (format "~a~a\n\n" (shown->TeX (still s) names)
                 (prose->TeX (string-append "at " (at-start s))))]
        [(shown-failure? s) (program (shown-failure-text s))]
        [(shown-formula? s)
         (string-append (tree-block (shown-formula-tree s))
                        (string-append* (for/list ([n (in-list (shown-formula-notes s))])
                                          (string-append (inline n) "\n\n"))))]
        [(shown-table? s) (table s)]
        [(shown-picture? s)
         (format "\\begin{center}\\includegraphics[width=0.6\\textwidth]{~a}\\end{center}\n\n"
                 (hash-ref names s))]
        [else (program (shown-text-text s))]))

;; ---------------------------------------------------------------------------
;; Formulas

(define (tree-block t)
  (cond [(report? t) (report-block t)]
        [(plain? t) (program (plain-text t))]
        [(and (listing? t) (ormap report? (listing-items t)))
         (string-append* (map tree-block (listing-items t)))]
        [else (format "\\shown{~a}\n\n" (tree->TeX (fit t 80 #:typeset? #t)))]))

(define (report-block t)
  (string-append
   "\\begin{flushleft}\n"
   (string-join
    (for/list ([l (in-list (report-lines t))])
      (define depth (report-line-depth l))
      (format "~a~a" (if (= depth 0) "" (format "\\hspace*{~aem}" (* 2 depth)))
              (string-join (cons (prose->TeX (report-line-label l))
                                 (map inline (report-line-parts l))))))
    "\\\\\n")
   "\n\\end{flushleft}\n\n"))

(define (inline t)
  (cond [(word? t) (prose->TeX (word-text t))]
        [(plain? t) (format "\\texttt{~a}" (code->TeX (plain-text t)))]
        [(and (row? t) (ormap word? (row-items t))) (string-append* (map inline (row-items t)))]
        [else (format "$\\displaystyle ~a$" (tree->TeX (fit t 60 #:typeset? #t)))]))

(define (table s)
  (define columns (apply max (map length (shown-table-rows s))))
  (define (line cells) (string-append (string-join cells " & ") "\\\\\n"))
  (string-append
   (format "\\begin{center}\n\\begin{tabular}{~a}\n" (make-string columns #\l))
   (if (shown-table-header s) (string-append (line (shown-table-header s)) "\\hline\n") "")
   (string-append* (map (lambda (row) (line (map inline row))) (shown-table-rows s)))
   "\\end{tabular}\n\\end{center}\n\n"))
