#lang racket/base
;; Characters as TeX.  All of a text comes out as itself: none of its characters is a command,
;; ends the formula or is unknown to pdfLaTeX.

(require "../../algebra/notation/name.rkt")

(provide letters->TeX upright typewriter word->TeX sign->TeX escaped)

;; Letters and digits of a name, in italics where TeX has them.
(define (letters->TeX text)
  (cond [(greek text) => values]
        [(regexp-match? #px"^(?:[A-Za-z]|[0-9]+)$" text) text]
        [(regexp-match? #px"^[A-Za-z0-9]+$" text) (format "\\mathit{~a}" text)]
        [else (upright text)]))

(define (greek text)
  (define name (letter->greek text))
  (cond [(not name) #f]
        [(string=? name "omicron") "o"]
        [(string=? name "epsilon") "\\varepsilon"]
        [(string=? name "phi") "\\varphi"]
        [else (string-append "\\" name)]))

(define (upright text) (format "\\text{~a}" (escaped text)))
(define (typewriter text) (format "\\texttt{~a}" (escaped text)))

(define (word->TeX text)
  (cond [(assoc text '(("∞" . "\\infty{}") ("⋯" . "\\cdots{}") ("…" . "\\ldots{}")
                       ("∂" . "\\partial{}")
                       ("𝐢" . "\\mathbf{i}") ("𝐣" . "\\mathbf{j}") ("𝐤" . "\\mathbf{k}")))
         => cdr]
        [else (upright text)]))

(define (sign->TeX sign)
  (cond [(assoc sign '(("≤" . "\\le ") ("≥" . "\\ge ") ("∘" . "\\circ ") ("−" . "-")
                       ("·" . "\\cdot ") ("≠" . "\\ne ") ("↦" . "\\mapsto ")
                       (":" . "\\colon ") ("→" . "\\to ") ("∧" . "\\wedge ")))
         => cdr]
        [else sign]))

;; Text as it stands within \text{...}.
(define (escaped text)
  (apply string-append
         (for/list ([c (in-string text)] [before (in-sequences '(#f) (in-string text))])
           (if (and before (member (string before c) ligatures))
               (string #\{ c #\})
               (character c)))))

;; Pairs that TeX would join to one sign.
(define ligatures '("--" "''" "``" ",," "?`" "!`"))

(define (character c)
  (cond [(hash-ref special c #f) => values]
        [(char<=? #\space c #\~) (string c)]
        [(greek (string c)) => (lambda (text) (format "\\ensuremath{~a}" text))]
        [(memv c accented) (string c)]
        [else (format "(U+~a)" (string-upcase (number->string (char->integer c) 16)))]))

(define special
  (hasheqv #\\ "\\textbackslash{}" #\{ "\\{" #\} "\\}" #\$ "\\$" #\& "\\&" #\# "\\#" #\_ "\\_"
           #\% "\\%" #\^ "\\textasciicircum{}" #\~ "\\textasciitilde{}" #\< "\\textless{}"
           #\> "\\textgreater{}" #\| "\\textbar{}" #\" "\\textquotedblright{}"
           #\newline " " #\tab " "
           #\− "\\ensuremath{-}" #\∞ "\\ensuremath{\\infty}" #\… "\\dots{}"
           #\≤ "\\ensuremath{\\le}" #\≥ "\\ensuremath{\\ge}" #\· "\\ensuremath{\\cdot}"
           #\∇ "\\ensuremath{\\nabla}" #\£ "\\pounds{}"
           #\∂ "\\ensuremath{\\partial}" #\→ "\\ensuremath{\\to}"
           #\ℝ "\\ensuremath{\\mathbf{R}}" #\× "\\ensuremath{\\times}"
           #\² "\\ensuremath{^2}" #\³ "\\ensuremath{^3}"))

;; Known to pdfLaTeX with its oldest fonts.
(define accented
  (string->list "àáâäãåçèéêëìíîïñòóôöõøùúûüýÿæÀÁÂÄÃÅÇÈÉÊËÌÍÎÏÑÒÓÔÖÕØÙÚÛÜÝÆß"))
