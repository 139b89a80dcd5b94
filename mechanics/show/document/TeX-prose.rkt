#lang racket/base
;; Text as TeX: characters that physicists use, beyond those of names
;; (../typesetting/TeX-text.rkt).

(require racket/string
         "../typesetting/TeX-text.rkt")

(provide prose->TeX code->TeX verbatim-text declarations)

;; Characters of ASCII are one piece, and so are a letter and its dot.
(define pieces #px"(?:[ -~](?![\u307\u308\u20DB]))+|.[\u307\u308\u20DB]|.")

(define (prose->TeX text)
  (string-append*
   (for/list ([piece (in-list (regexp-match* pieces (string-replace text "\n" " ")))])
     (piece->TeX piece))))

;; The same with spaces as wide as a letter, where they stand.
(define (code->TeX text) (string-replace (prose->TeX (string-replace text "\t" "    ")) " " "~"))

(define (piece->TeX piece)
  (define c (string-ref piece 0))
  (cond [(regexp-match? #px"^[ -~]+$" piece) (escaped piece)]
        [(= 2 (string-length piece))
         (format "\\ensuremath{\\~a{~a}}" (cdr (assv (string-ref piece 1) dots))
                 (escaped (string c)))]
        [(hash-ref signs c #f) => (lambda (formula) (format "\\ensuremath{~a}" formula))]
        [(hash-ref words c #f) => values]
        [(hash-ref pieces-of-text c #f) => values]
        [else (escaped (string c))]))

(define dots '((#\u307 . "dot") (#\u308 . "ddot") (#\u20DB . "dddot")))

(define words
  (hasheqv #\– "--" #\— "---" #\‘ "`" #\’ "'" #\“ "\\textquotedblleft{}" #\” "\\textquotedblright{}"
           #\° "\\textdegree{}" #\§ "\\S{}" #\u00A0 "~" #\u202F "\\," #\u2009 "\\,"
           #\′ "\\ensuremath{'}"))

;; ---------------------------------------------------------------------------
;; Programs, as they are written

;; Lines for the environment `program` (TeX-document.rkt), with nothing in them that ends it.
(define (verbatim-text text)
  (regexp-replaces
   text `([#rx"\t" "    "]
          [#px"[\0-\u9\uB-\u1F\u7F]" ,escaped]
          [#px"(?<=\\\\end)(?= *[{])" ,nothing])))

;; Makes the characters known that stand in such lines.
(define (declarations texts)
  (define found
    (for*/hasheqv ([text (in-list texts)] [c (in-string text)] #:when (char>? c #\~))
      (values c #t)))
  (string-append*
   (for/list ([c (in-list (sort (hash-keys found) char<?))]
              #:unless (string=? (string c) (escaped (string c))))
     (format "\\letter{~a}{~a}\n" (hexadecimal c) (declared c)))))

(define (hexadecimal c)
  (define digits (string-upcase (number->string (char->integer c) 16)))
  (string-append (make-string (max 0 (- 4 (string-length digits))) #\0) digits))

(define nothing "\u200B")               ; declared to be nothing

(define (declared c)
  (cond [(assv c dots)
         => (lambda (d) (format "\\llap{\\ensuremath{\\~a{\\phantom{\\theta}}}}" (cdr d)))]
        [(string=? (string c) nothing) ""]
        [else (piece->TeX (string c))]))

;; ---------------------------------------------------------------------------
;; Characters

;; The characters of formulas drawn as text: lines, and pieces of brackets.
(define pieces-of-text
  (for*/hasheqv ([entry (in-list '(("─" . "\\rule[0.55ex]{0.525em}{0.4pt}")
                                   ("│⎜⎟" . "\\textbar{}") ("⎛⎠╱" . "/")
                                   ("⎝⎞╲" . "\\textbackslash{}") ("⎡⎢⎣" . "[") ("⎤⎥⎦" . "]")))]
                 [c (in-string (car entry))])
    (values c (cdr entry))))

(define (numbered characters form)
  (for/list ([c (in-string characters)] [i (in-naturals)]) (list c (form i))))

(define signs
  (for/hasheqv ([entry (in-list
                        (append
                         (numbered "⁰¹²³⁴⁵⁶⁷⁸⁹" (lambda (i) (format "^{~a}" i)))
                         (numbered "₀₁₂₃₄₅₆₇₈₉" (lambda (i) (format "_{~a}" i)))
                         (numbered "½⅓¼⅕" (lambda (i) (format "\\tfrac{1}{~a}" (+ i 2))))
                         '((#\¾ "\\tfrac{3}{4}") (#\⅔ "\\tfrac{2}{3}") (#\⅛ "\\tfrac{1}{8}")
                           (#\⁻ "^{-}") (#\⁺ "^{+}") (#\ⁿ "^{n}") (#\× "\\times") (#\√ "\\surd")
                           (#\± "\\pm") (#\≈ "\\approx") (#\≠ "\\ne") (#\≡ "\\equiv")
                           (#\→ "\\to") (#\← "\\leftarrow") (#\↦ "\\mapsto") (#\⇒ "\\Rightarrow")
                           (#\∈ "\\in") (#\∫ "\\int") (#\∑ "\\sum") (#\∏ "\\prod")
                           (#\∇ "\\nabla") (#\∘ "\\circ") (#\⋯ "\\cdots") (#\↑ "\\uparrow")
                           (#\↓ "\\downarrow") (#\∝ "\\propto") (#\ℏ "\\hbar") (#\ϕ "\\phi")
                           (#\ϵ "\\epsilon") (#\∧ "\\wedge") (#\⟨ "\\langle")
                           (#\⟩ "\\rangle"))))])
    (values (car entry) (cadr entry))))
