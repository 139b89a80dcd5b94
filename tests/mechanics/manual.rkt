#lang racket/base
;; The manual builds: every example in it runs, those that are to raise an error
;; do, and they print what the text around them says.
;;
;; An example that raises an error, or fails to, stops the document, so loading
;; it is most of the test.  Its text is then searched for what a reader should
;; never see, and for results that matter.

;; for-label: compiled with this file.
(require (for-label "../../scribblings/mechanics/mechanics.scrbl")
         json
         net/uri-codec
         racket/file
         racket/list
         racket/path
         racket/port
         racket/runtime-path
         racket/sandbox
         racket/string
         scribble/render
         (prefix-in html: scribble/html-render)
         (prefix-in text: scribble/text-render)
         "support/checks.rkt" "../../scribblings/mechanics/clashes.rkt"
         "../../scribblings/mechanics/eval.rkt"
         "support/browser.rkt" "support/skip.rkt")

(define-runtime-path manual "../../scribblings/mechanics/mechanics.scrbl")
(define-runtime-path readme "../../README.md")
(define-runtime-path operation-table "../../mechanics/operation/operation-table.rkt")

;; ---------------------------------------------------------------------------
;; The text of the manual

(define document (dynamic-require manual 'doc))

;; The value of (read folder), of the folder where the manual is rendered.
(define (rendered mixin read)
  (define folder (make-temporary-file "manual~a" 'directory))
  (render (list document) '("manual") #:render-mixin mixin
          #:dest-dir folder #:quiet? #t #:warn-undefined? #t)
  (begin0 (read folder)
          (delete-directory/files folder)))

(define (manual-text)
  (parameterize ([current-error-port (open-output-nowhere)])
    (rendered text:render-mixin
              (lambda (folder) (file->string (build-path folder "manual.txt"))))))

;; Lines and indentation are the renderer's affair.
(define (words text) (string-normalize-spaces text #px"[\\s\u00A0]+"))

(define text (words (manual-text)))

;; Is this what the prompt answered to that?
(define (answered? input output)
  (string-contains? text (words (string-append "> " input " " output))))

(define-syntax-rule (check-answers [input output] ...)
  (begin
    (check-true (answered? input output) (format "~a\nanswers\n~a" input output)) ...))

;; ---------------------------------------------------------------------------

;; Values of the pict library, which plain text cannot show, are written so.
(define (without-picts text) (string-replace text "#<serialized-convertible>" "(a picture)"))

(test-case "no reference is missing, and nothing opaque is printed"
  (check-false (string-contains? text "[missing]"))
  (check-false (string-contains? (without-picts text) "#<"))
  (check-false (regexp-match? #px"\\.rkt:[0-9]+" text)))

(test-case "an answer that is not there is not found"
  (check-true (answered? "((D cube) 5)" "75"))
  (check-false (answered? "((D cube) 5)" "76")))

(test-case "equations of motion"
  (check-answers
   ["(((Lagrange-equations (L-harmonic 'm 'k)) (literal-function 'x)) 't)"
    "(+ (* k (x t)) (* m (((expt D 2) x) t)))"]
   ["(((Lagrange-equations (L-pendulum 'g 'm 'l)) theta) 't)"
    "(+ (* g l m (sin (theta t))) (* (expt l 2) m (((expt D 2) theta) t)))"]
   ["(((Lagrange-equations (L-free-particle 'm)) (literal-function 'x)) 't)"
    "(* m (((expt D 2) x) t))"]))

(test-case "verdicts say what the text says of them"
  (check-answers
   ["(verify-solution (L-pendulum 'g 'm 'l) swing)" "refuted:"]
   ["(verify-solution (L-small 'g 'm 'l) small-swing)" "proved:"]
   ["(verify-solution (L-small (* 'l (square 'omega)) 'm 'l) swing)" "proved:"]
   ["(verify-solution (L-pendulum 'g 'm 'l) (lambda (t) 0))" "proved:"]
   ["(verify-solution (L-pendulum 'g 'm 'l) (lambda (t) (* 'Omega t)))" "refuted:"]
   ["(verify-solution (L-Kepler 'm mu) circular-orbit)" "proved:"]
   ["(verdict-conditions verdict)" "'((= k (* m (expt omega 2))))"]
   ["(prove-zero (- (* 0.1 'x 3) (* 0.3 'x)))"
    "undecided: the residual is neither proved nor refuted to be zero"]
   ["(prove-zero (- (* 1/10 'x 3) (* 3/10 'x)))" "proved:"]))

(test-case "each line from Newton to Lagrange is proved"
  (check-answers
   ["(verify-equal dAlembert ((d-Alembert-equations 'm r F) theta))" "proved:"]
   ["(verify-equal (((partial 2) velocities) state) (slope state))" "proved:"]
   ["(verify-equal (D s) (along ((partial 1) velocities)))" "proved:"]
   ["(verify-equal dAlembert (- (D (along ((partial 2) T))) (along ((partial 1) T)) (along Q)))"
    "proved:"]
   ["(verify-equal dAlembert ((Lagrange-equations L) theta))" "proved:"]
   ["(verify-equal ((d-Alembert-equations 'm any-r any-F) q) ((Lagrange-equations any-T #:force any-Q) q))"
    "proved:"]
   ["((Dt (Lagrangian->energy L)) moving)" "0"]
   ["(dot-product N across)" "(* 2 R m omega thetadot (cos theta))"]))

(test-case "derivatives, nested and not"
  (check-answers
   ["((D (lambda (x) (* x (sin x)))) 'x)" "(+ (* x (cos x)) (sin x))"]
   ["((D g) 'x)" "1"]
   ["(naive-derivative naive-g 3)" "2"]
   ["((slope (slope cube)) 'y)" "(* 6 y)"]))

(test-case "the entries shown of the table of operations are in it"
  (define shown (regexp-match* #px"\\[(?:sin|exp|[*]) \\([a-z ]+\\)[^]]*(?= ...\\])" text))
  (check-equal? (length shown) 3)
  (for ([entry (in-list shown)])
    (check-true (string-contains? (file->string operation-table) entry) entry)))

(test-case "structures"
  (check-answers
   ["(* (down 1 2) (up 1 2 3))" "(up (down 1 2) (down 2 4) (down 3 6))"]
   ["(* (down 'p_x 'p_y) (up 'v_x 'v_y))" "(+ (* p_x v_x) (* p_y v_y))"]
   ["(ref (up 1 2) 5)" "ref: index 5 is outside an up tuple of 2"]))

;; ---------------------------------------------------------------------------
;; The pages as a browser gets them

;; Warnings about references that lead nowhere.
(define warnings (open-output-string))

;; Width of a phone's screen, and how far the pages reach on it: ((file . pixels) ...), or #f
;; where no browser measures.
(define phone 390)
(define widths #f)

(define (measure-widths folder)
  (define files
    (for/list ([file (in-list (directory-list folder))] #:when (path-has-extension? file #".html"))
      (path->string file)))
  (when (browser?)
    (set! widths (map cons files
                      (measure folder files phone "d.documentElement.scrollWidth")))))

;; file name -> text, but for pictures and fonts
(define pages
  (parameterize ([current-error-port warnings])
    (rendered (lambda (%) (html:render-multi-mixin (html:render-mixin %)))
              (lambda (folder)
                (measure-widths (build-path folder "manual"))
                (for/hash ([file (in-list (directory-list (build-path folder "manual")))]
                           #:unless (or (path-has-extension? file #".png")
                                        (path-has-extension? file #".woff2")))
                  (values (path->string file)
                          (file->string (build-path folder "manual" file))))))))

(define html-pages
  (for/list ([(file text) (in-hash pages)] #:when (string-suffix? file ".html")) text))

;; In "mechanicsManual({...});": lists of kind, title, place, sentence and address
(define findings
  (hash-ref
   (string->jsexpr
    (cadr (regexp-match #rx"^mechanicsManual[(](.*)[)];" (hash-ref pages "search-index.js"))))
   'findings))

(define (findings-titled title)
  (filter (lambda (f) (string=? (second f) title)) findings))

;; Is there such a place on the pages?
(define (leads-somewhere? address)
  (define parts (string-split address "#"))
  (define page (hash-ref pages (car parts) #f))
  (and page
       (or (null? (cdr parts))
           (string-contains? page (format "<a name=\"~a\">" (uri-decode (cadr parts)))))))

;; References to Racket's own documents are not known here, and what a name depends on, `dep`,
;; is no reference.
(define (reference-of-ours? line)
  (and (not (regexp-match? #px"^ \\(dep " line))
       (regexp-match? #px"^ \\(part \"|^ \\(\\w+ \\(\\(lib \"mechanics/" line)))

(test-case "every section and name that is referred to is there"
  (check-true (reference-of-ours? " (part \"no-such-page\")"))
  (check-true (reference-of-ours? " (def ((lib \"mechanics/main.rkt\") no-such-name))"))
  (define lines (string-split (get-output-string warnings) "\n"))
  (check-true (> (length lines) 100))
  (check-equal? (filter reference-of-ours? lines) '()))

(test-case "every page has the style and the search box"
  (for* ([page (in-list html-pages)] [file (in-list '("look.css" "search.js"))])
    (check-true (string-contains? page (format "\"~a\"" file)))
    (check-true (hash-has-key? pages file))))

(test-case "results and formulas are typeset, with what the prompt prints behind a switch"
  (define page (hash-ref pages "ten-minutes.html"))
  (check-true (> (length (regexp-match* #rx"<math " page)) 15))
  (check-true (string-contains? page "<mover><mi>θ</mi><mo stretchy=\"false\">˙</mo></mover>"))
  (check-regexp-match #rx"class=\"printed\">[(][+] [(][*] g l m [(]cos theta[)][)]" page)
  ;; A string that ->MathML gave prints with \\" where markup has a quotation mark.
  (check-false (regexp-match? #rx"<math [a-z]+=\"" text)))

(test-case "a phone shows each page in its width"
  (skip-unless widths "pages on a phone: Chromium is not here"
    (check-true (> (length widths) 50))
    (for ([w (in-list widths)])
      (check-true (<= (cdr w) phone) (format "~a is ~a pixels wide" (car w) (cdr w))))))

(test-case "the search box knows names with their sentences, sections and libraries"
  (define (about title) (map (lambda (f) (take (cddr f) 2)) (findings-titled title)))
  (check-equal? (about "verify-solution")
                '(("mechanics"
                   "Whether the path q satisfies Lagrange's equations of L at all times.")))
  (check-equal? (about "L-pendulum")
                '(("mechanics/book" "A pendulum whose pivot is at rest.")))
  (define (kinds title) (map first (findings-titled title)))
  (check-equal? (kinds "The first ten minutes") '("page"))
  (check-equal? (kinds "Friction") '("section"))
  (check-equal? (kinds "mechanics/plot") '("library"))
  (check-equal? (kinds "Exercise 1.29") '("exercise"))
  (check-true (> (length findings) 1500)))

(test-case "what is found is there"
  (check-false (leads-somewhere? "no-such-page.html"))
  (check-false (leads-somewhere? "ten-minutes.html#nowhere"))
  (for ([f (in-list findings)])
    (check-true (leads-somewhere? (fifth f)) (format "~s" f))))

(test-case "a page is where the prompt says that it is"
  (for ([f (in-list findings)] #:when (member (first f) '("page" "section")))
    (define file (string-append (first (string-split (third f) "#")) ".html"))
    (check-true (string-prefix? (fifth f) file) (format "~s" f))))

(test-case "programs are links, to copies beside the pages"
  (define linked
    (remove-duplicates
     (append-map (lambda (page)
                   (regexp-match* #rx"href=\"([^\"#:]*[.]rkt)\"" page #:match-select cadr))
                 html-pages)))
  (check-true (> (length linked) 70))
  (for ([file (in-list linked)])
    (check-true (string-contains? (hash-ref pages file "") "#lang ") file)))

(test-case "the package is ours"
  (define packages
    (append-map (lambda (page) (regexp-match* #rx"pkgs.racket-lang.org/package/([a-z]*)" page
                                              #:match-select cadr))
                html-pages))
  (check-equal? (remove-duplicates packages) '("mechanics")))

;; ---------------------------------------------------------------------------
;; Names shared with other libraries

;; Can a module that requires mechanics and this be expanded?
(define (fit-together? requirement)
  (parameterize ([current-namespace (make-base-namespace)])
    (with-handlers ([exn:fail:syntax? (lambda (e) #f)])
      (expand `(module sample racket/base (require mechanics ,requirement)))
      #t)))

(test-case "what the manual says to write settles a clash of names"
  (for ([library '(racket/math racket/function racket/contract)])
    (define names (shared-names 'mechanics library))
    (check-false (null? names))
    (check-false (fit-together? library))
    (check-true (fit-together? `(except-in ,library ,@names)))
    (check-true (string-contains? text (format "~s" `(except-in ,library ,@names))))))

(test-case "libraries that share no names need nothing"
  (check-equal? (shared-names 'mechanics 'racket/list) '())
  (check-true (fit-together? 'racket/list)))

;; ---------------------------------------------------------------------------
;; The session in the README

;; ((input . output) ...): what follows an indented `>`, and the indented lines
;; after it.
(define (interactions lines)
  (define start (dropf lines (lambda (l) (not (string-prefix? l "    > ")))))
  (cond [(null? start) '()]
        [else
         (define-values (more rest)
           (splitf-at (cdr start) (lambda (l) (regexp-match? #rx"^    [^>]" l))))
         (define port
           (open-input-string (string-join (cons (substring (car start) 6) more) "\n")))
         (define input (read port))
         (cons (cons input (words (port->string port))) (interactions rest))]))

;; The prompt's answer to that form.
(define (answer session form)
  (define value (session form))
  (call-in-sandbox-context
   session
   (lambda ()
     (define port (open-output-string))
     (parameterize ([current-output-port port])
       ((current-print) value))
     (words (get-output-string port)))))

;; Which point refutes is no promise.
(define (without-witness text)
  (regexp-replace* #px"at: .*? value: \\S+" text "at: ..."))

(test-case "the README shows what the prompt prints"
  (define session (make-session))
  (define shown (interactions (file->lines readme)))
  (check-true (> (length shown) 5))
  (for ([s (in-list shown)])
    (check-equal? (without-witness (answer session (car s))) (without-witness (cdr s))
                  (format "~s" (car s))))
  (kill-evaluator session))
