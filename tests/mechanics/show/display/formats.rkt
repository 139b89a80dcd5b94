#lang racket/base
;; Results obey their format: TeX compiles where there is a TeX, MathML is
;; well-formed and holds what it should, lines keep to their width.

(require mechanics
         (only-in mechanics/show/typesetting/text-box columns-wide)
         "../../support/checks.rkt"
         "../../support/bigfloats.rkt" "../../support/golden/values.rkt"
         "../../support/messages.rkt" "../../support/skip.rkt"
         racket/file
         racket/port
         racket/string
         racket/system
         xml)

;; ---------------------------------------------------------------------------
;; TeX

(define latex (find-executable-path "latex"))

(define (document formulas)
  (string-append
   "\\documentclass{article}\n\\usepackage{amsmath}\n\\begin{document}\n"
   (apply string-append (for/list ([f (in-list formulas)]) (format "\\[~a\\]\n" f)))
   "\\end{document}\n"))

;; -> what LaTeX says of it, or #f if it compiles without an error
(define (complaint-of-latex formulas)
  (define folder (make-temporary-file "formulas~a" 'directory))
  (define file (build-path folder "formulas.tex"))
  (display-to-file (document formulas) file)
  (define out (open-output-string))
  (define done?
    (parameterize ([current-directory folder] [current-output-port out]
                   [current-input-port (open-input-string "")])
      (system* latex "-interaction=nonstopmode" "-halt-on-error" "formulas.tex")))
  (delete-directory/files folder)
  (if done? #f (get-output-string out)))

(skip-unless latex "there is no latex"
  (test-case "every value compiles as TeX"
    (check-false (complaint-of-latex (for/list ([v (in-list values-to-typeset)]) (->TeX (cdr v)))))
    (check-false (complaint-of-latex (for/list ([v (in-list values-to-typeset)])
                                       (->TeX (cdr v) #:width 40)))))
  (test-case "what does not compile would be noticed"
    (check-regexp-match #rx"nosuch" (complaint-of-latex '("\\nosuch")))))

;; ---------------------------------------------------------------------------
;; MathML

(define (parsed text) (xml->xexpr (document-element (read-xml (open-input-string text)))))

(define elements
  '(math mrow mi mn mo mtext mspace mfrac msup msub msubsup msqrt mover mtable mtr mtd))

(define (elements-of x)
  (if (pair? x) (cons (car x) (apply append (map elements-of (cddr x)))) '()))

(define (text-of x)
  (cond [(string? x) x]
        [(pair? x) (string-append* (map text-of (cddr x)))]
        [else ""]))

(test-case "every value is well-formed MathML of few elements"
  (for ([v (in-list values-to-typeset)])
    (define x (parsed (->MathML (cdr v))))
    (check-equal? (remove* elements (elements-of x)) '() (car v))))

(test-case "on a line of its own or within a text"
  (check-equal? (->MathML 'x)
                (string-append "<math xmlns=\"http://www.w3.org/1998/Math/MathML\" "
                               "display=\"block\"><mi>x</mi></math>"))
  (check-regexp-match #rx"display=\"inline\"" (->MathML 'x #:inline? #t)))

;; ---------------------------------------------------------------------------
;; Names that would break out

(define attacks
  (map string->symbol
       (list "</mi><script>alert(1)</script>" "\\input{x}" "$" "$$\\write18{ls}$$" "x}y{z" "%"
             "\\end{document}" "&amp;" "]]>" "<!--" "\"'" "^^5cinput" "\n\n" "\e[2J" "\u202E" "\0"
             "a_b_" "_" "^" "~" "--" "\uFFFE" "𝒳" "中文" "e\u301" "|" "a|b" "\\" "(" "1" "")))

(define (everywhere s)
  (list s (+ s 1) (/ 1 s) (expt 2 s) (up s (sqrt s)) ((literal-function s) 't)
        ((D (literal-function s)) 't) (matrix-by-rows (list s))))

(test-case "no name is markup"
  (for* ([s (in-list attacks)] [x (in-list (everywhere s))])
    (define parts (parsed (->MathML x)))
    (check-equal? (remove* elements (elements-of parts)) '() (format "~s" s))))

(skip-unless bigfloats? no-bigfloats
  (test-case "numbers of higher precision have powers of ten as others"
    (check-equal? (->TeX (bigfloat 1e20 60)) (->TeX 1e20))))

(test-case "names are shown as they are"
  (check-equal? (text-of (parsed (->MathML '|</mi><script>|))) "</mi><script>")
  (check-equal? (text-of (parsed (->MathML '|\\input{x}|))) "\\\\input{x}")
  (check-equal? (->TeX '|$|) "\\text{\\$}")
  (check-equal? (->TeX (* 'epsilon 'omicron)) "\\varepsilon\\,o")   ; TeX has no omicron
  (check-equal? (->text '|$|) "$"))

(skip-unless latex "there is no latex"
  (test-case "no name is a command of TeX"
    (check-false (complaint-of-latex (for*/list ([s (in-list attacks)] [x (in-list (everywhere s))])
                                       (->TeX x))))))

(test-case "no name breaks a line or commands the terminal"
  (for ([s (in-list attacks)])
    (check-false (regexp-match? #px"\\p{Cc}|\u202E" (->infix s)) (format "~s" s))
    (check-false (regexp-match? #px"\\p{Cc}|\u202E" (->text s)) (format "~s" s))))

(test-case "names that look alike are told apart on one line, and every name is read back"
  (check-equal? (->infix (+ 'theta 'θ)) "θ + |θ|")
  (check-equal? (->infix 'theta) "θ")
  (check-equal? (->infix 'θ) "|θ|")
  (check-eq? (read-infix (->infix 'θ)) 'θ)
  (check-equal? (->infix (* ':pi 'pi)) "π |pi|")
  (check-equal? (->text (* ':pi 'pi)) "π pi")
  (for ([s (in-list attacks)])
    (check-equal? (read-infix (->infix s)) s)))

(test-case "a Greek letter that was typed as such looks in text as its name does, with dots as well"
  (for ([name '(theta_1 omega xdot theta)] [letters '(θ_1 ω ẋ θ)])
    (check-equal? (->text letters) (->text name)))
  (define (second s) (->text (((expt D 2) (literal-function s)) 't)))
  (for ([name '(theta_1 omega theta)] [letters '(θ_1 ω θ)])
    (check-equal? (second letters) (second name)))
  (check-equal? (second '|a b|) "D²a b(t)"))

;; ---------------------------------------------------------------------------
;; Width

(define (widest text) (apply max (map columns-wide (string-split text "\n" #:trim? #f))))

(test-case "long sums keep to the width they are given"
  (define long (expand (expt (+ 'a 'b 'c 'd) 7)))
  (for ([width '(120 80 40 25)])
    (check-true (<= (widest (->text long #:width width)) width) (format "~a" width)))
  (check-equal? (length (string-split (->text long #:width #f) "\n")) 1)
  (check-false (regexp-match? #rx"aligned" (->TeX long #:width #f))))

;; ---------------------------------------------------------------------------
;; Values that are no formulas, and wishes

(test-case "what cannot be typeset shows its plain form"
  (define cycle (make-placeholder #f))
  (placeholder-set! cycle (list 1 cycle))
  (define circle (make-reader-graph cycle))
  (check-equal? (->infix circle) "#0=(1 #0#)")
  (check-equal? (->text circle) "#0=(1 #0#)")
  (check-equal? (->infix (lambda (x) x)) "<function>")
  (check-equal? (->infix (make-hash)) "#hash()")
  (check-equal? (->infix '(1 . 2)) "(1 . 2)")
  (check-equal? (->text "a\nb") "\"a\\nb\"")
  (check-equal? (->infix (up (lambda (x) x) 1)) "up(<function>, 1)"))

(test-case "a value that is larger than print-limit is cut, and says so"
  (define big (for/fold ([x 'a]) ([k 40]) (+ (sin x) (cos x))))
  (parameterize ([print-limit 50])
    (check-regexp-match #rx"[.][.][.][0-9^]+ more" (->infix big))
    (check-regexp-match #rx"[.][.][.][0-9^]+ more" (->text big))
    (check-regexp-match #rx"more" (->TeX big))))

(test-case "derivatives are marked as one wishes, arguments hidden on request"
  (define x (literal-function 'x))
  (define a (((expt D 2) x) 't))
  (check-equal? (->infix a) "D²x(t)")
  (check-equal? (->TeX a) "\\ddot{x}(t)")
  (parameterize ([derivative-style 'dots])
    (check-equal? (->infix a) "ẍ(t)")
    (check-equal? (->TeX ((D x) 's)) "\\dot{x}(s)")
    (check-equal? (->TeX (((expt D 4) x) 't)) "D^{4} x(t)"))
  (parameterize ([derivative-style 'D])
    (check-equal? (->TeX a) "D^{2} x(t)"))
  (parameterize ([suppress-arguments '(t)])
    (check-equal? (->TeX a) "\\ddot{x}")
    (check-equal? (->infix a) "D²x")
    (check-equal? (->infix (x 's)) "x(s)")
    (check-equal? (->infix (sin 't)) "sin t")))

(test-case "a value is drawn as it stands; simplified it is what the prompt shows"
  (define twice (+ 'a 'a))
  (define two (simplify twice))
  (check-equal? (map ->infix (list twice two)) '("a + a" "2 a"))
  (check-equal? (map ->text (list twice two)) '("a + a" "2 a"))
  (check-equal? (map ->TeX (list twice two)) '("a + a" "2\\,a"))
  (define-syntax-rule (card name) (with-output-to-string (lambda () (help name))))
  (for ([c (list (card ->infix) (card ->text) (card ->TeX) (card ->MathML))])
    (check-regexp-match #rx"as it stands" c)))

(says
 [(->TeX 'x #:width 0)
  "->TeX: expected a width in columns, or #f for lines of any length\n  given: the number 0"]
 [(->text 'x #:width 'wide)
  "->text: expected a width in columns, or #f for lines of any length\n  given: the symbol wide"]
 [(->MathML 'x #:size 3)
  "->MathML: there is no keyword #:size here\n  its keywords: (#:inline? #:width)"]
 [(derivative-style 'primes)
  "derivative-style: expected 'automatic, 'dots or 'D\n  given: 'primes"]
 [(suppress-arguments 't)
  "suppress-arguments: expected a list of symbols, such as '(t)\n  given: 't"]
 [(read-infix "a + ")
  "read-infix: not a formula on one line\n  at: it ends here, position 4\n  in: a + "]
 [(read-infix "a ! b")
  "read-infix: not a formula on one line\n  at: ! b, position 2\n  in: a ! b"]
 [(read-infix "(a")
  "read-infix: not a formula on one line\n  at: it ends here, position 2\n  in: (a"]
 [(read-infix 'a)
  "read-infix: expected a string such as \"½ m ẋ²\"\n  given: the symbol a"])
