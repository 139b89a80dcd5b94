#lang racket/base
;; Results in an editor of Racket's, on a display that is made up: formulas that are drawn,
;; copied, saved and read as programs.

(require racket/file
         racket/runtime-path
         racket/string
         "../../support/checks.rkt" "../../support/display.rkt" "../../support/skip.rkt")

(define-runtime-path program "../../runner/fixture/editor.rkt")

(define expected
  (list "formulas: 2"
        "text: (/ r theta_1)|\"text\"|3|(list 1 (/ a b))|<function>|"
        "other styles: 0"
        "big: 1"
        "too big: 0 not typeset: it has 2999 parts, and up to 2000 are drawn"
        "png: PNG" "svg: #t" "pdf: %PDF" "unknown: #f"
        "Copy as S-Expression: (/ r theta_1)"
        "Copy as TeX: \\frac{r}{\\theta_{1}}"
        (string-append "Copy as MathML: <math xmlns=\"http://www.w3.org/1998/Math/MathML\""
                       " display=\"block\"><mfrac><mi>r</mi><msub><mi>θ</mi><mn>1</mn></msub>"
                       "</mfrac></math>")
        "Copy as One Line: r/θ₁"
        "Copy as Text:  r|────| θ₁"
        "clipboard: \\frac{r}{\\theta_{1}}"
        "red: #t #t"
        "larger: #t"
        "scrolled: 1 #t 0 2 32"
        "menus: 0 1 1"
        "loaded: 1 #t"))

;; Libraries may complain in between, as they do where there is no home for their settings.
(define (said output)
  (filter (lambda (line) (regexp-match? #rx"^[A-Za-z -]+: " line))
          (map string-trim (string-split output "\n"))))

(skip-unless (display-server)
             "Xvfb (Debian: apt install xvfb) is not installed: there are no editors to print in"
  (define folder (make-temporary-file "formulas~a" 'directory))
  (define file (build-path folder "saved.rkt"))
  (define output
    (call-with-display
     (lambda (display) (run-program program (environment-with display) (path->string file)))))
  (skip-unless (not (regexp-match? #rx"ffi-lib: " output))
               "the shared libraries of racket/gui are not installed: no editors to print in"
    (test-case "results are formulas in an editor, and text where they are copied"
      (check-equal? (said output) expected output))
    (test-case "a file with a formula in it is a program, without windows, too"
      (check-equal? (run-program file (environment-with #"nowhere:99")) "3\n")))
  (delete-directory/files folder))
