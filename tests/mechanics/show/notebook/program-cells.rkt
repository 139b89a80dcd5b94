#lang racket/base
;; Programs as cells of notebooks, and back: nothing is lost.

(require json
         racket/file
         racket/list
         racket/runtime-path
         mechanics/show/notebook/notebook-file mechanics/show/notebook/program-cells
         "../../support/checks.rkt" "../../support/messages.rkt")

(define-runtime-path examples "../../../../examples/mechanics")

(define (cells-of text)
  (define-values (header cells) (program->cells 'notebook (string->bytes/utf-8 text)))
  cells)

(define (kinds+sources cells)
  (for/list ([c (in-list cells)]) (list (cell-kind c) (cell-source c))))

(define (fresh . parts)
  (for/list ([p (in-list parts)]) (cell (car p) (cadr p) #f #f)))

;; ---------------------------------------------------------------------------
;; Program to notebook and back

(define (check-there-and-back text)
  (define-values (header cells) (program->cells 'notebook text))
  (define-values (header-read cells-read)
    (bytes->notebook 'program "x.ipynb" (notebook->bytes header cells)))
  (check-equal? (string->bytes/utf-8 (cells->program header-read cells-read)) text))

(test-case "every example, byte for byte"
  (for ([f (in-directory examples)]
        #:when (regexp-match? #rx"[.]rkt$" (path->string f))
        #:unless (regexp-match? #rx"compiled|/info[.]rkt$" (path->string f)))
    (with-check-info (['file f]) (check-there-and-back (file->bytes f)))))

(test-case "odd programs, byte for byte"
  (for ([text
         (list "#lang mechanics" "#lang mechanics\n" "#lang mechanics\n\n\n"
               "#lang mechanics\n(+ 1 2)"
               "; first\n\n#lang mechanics\n\n\n\n(f)\n\n\n; x\n\n  (g)\n   \n(h)\n\n\n"
               "#lang mechanics\r\n\r\n(f\r\n\r\n 1)\r\n\r\n; a\r\n; b\r\n\r\n(g)\r\n"
               "#lang mechanics\n\n  (f)\n\n(g) ; θ 力\n"
               "#lang mechanics\n\n;;; cell\n(f)\n\n(g)\n;;; end\n\n(h)\n"
               "#lang mechanics\n\n#! a line of comment #| for readers\n\n(f)\n"
               "#lang mechanics\n(define s \"a\n\nb\")\n\n#| c\n\n#| d |#\n\n|#\n\n#;(f\n\n1)\n\n(g)\n")])
    (with-check-info (['text text]) (check-there-and-back (string->bytes/utf-8 text)))))

(test-case "cells are cut at blank lines between forms, and nowhere else"
  (check-equal?
   (kinds+sources
    (cells-of (string-append "#lang mechanics\n\n;; # On a pendulum\n;; a_1 is *small*\n\n"
                             "(define (f x)\n\n  x)\n(f 1)\n\n; why\n(f 2)\n\n"
                             "(define s \"a\n\nb\")\n\n#| c\n\nd |#\n(f 3)\n\n"
                             "(module+ test\n\n (f 4))\n\n(provide f)\n")))
   '((markdown "# On a pendulum\na\\_1 is \\*small\\*")
     (code "(define (f x)\n\n  x)\n(f 1)")
     (code "; why\n(f 2)")
     (code "(define s \"a\n\nb\")")
     (code "#| c\n\nd |#\n(f 3)")
     (raw "(module+ test\n\n (f 4))")
     (raw "(provide f)"))))

(test-case "a comment between forms ends where it is closed, with those within it"
  (for ([comment '("#| c |#" "#| c #| d |# \n\n e |#" "#|\n\n#| d |#\n#| e |#\n\n|#")])
    (define program (format "#lang mechanics\n\n~a\n\n; x\n\n(f)\n" comment))
    (check-equal? (kinds+sources (cells-of program))
                  `((code ,comment) (markdown "x") (code "(f)"))
                  comment)))

;; A form that #; leaves out stays with the form behind it, whatever its text is.
(test-case "a form that is left out is not cut"
  (define program "#;(f \"|#\"\n\n 2)\n\n(g)")
  (check-equal? (kinds+sources (cells-of (string-append "#lang mechanics\n\n" program "\n\n(h)\n")))
                `((code ,program) (code "(h)"))))

;; ---------------------------------------------------------------------------
;; Notebook to program and back

(define (check-cells-kept cells)
  (define text (cells->program usual-header cells))
  (with-check-info (['text text])
    (check-equal? (kinds+sources (cells-of text)) (kinds+sources cells))))

(test-case "cells keep their texts and kinds"
  (check-cells-kept
   (fresh '(code "(f)") '(markdown "A *word*, a $x^2$\n\n- an item\n\n# A heading")
          '(code "(g)\n\n(h)")
          '(raw "any text\n\n(") '(code "; a comment alone") '(code "(not closed")
          '(code ",help D") '(code "") '(markdown "") '(code ";;; end\n\n;;; cell")
          '(markdown ";;; end") '(raw "(provide f)") '(code "(provide f)")
          '(markdown "two\\_words"))))

(test-case "prose that was not touched stays as it was written; prose that was is written anew"
  (define-values (header cells)
    (program->cells 'notebook #"#lang mechanics\n\n;;;; a_1\n;; b\n\n(f)\n"))
  (check-equal? (cells->program header cells) "#lang mechanics\n\n;;;; a_1\n;; b\n\n(f)\n")
  (define changed (cons (struct-copy cell (car cells) [source "new\n\nprose"]) (cdr cells)))
  (check-equal? (cells->program header changed) "#lang mechanics\n\n;; new\n;;\n;; prose\n\n(f)\n"))

;; ---------------------------------------------------------------------------
;; Files

(test-case "a notebook's format"
  (define x (bytes->jsexpr (notebook->bytes usual-header (fresh '(code "(f)") '(markdown "a")))))
  (check-equal? (list (hash-ref x 'nbformat) (hash-ref x 'nbformat_minor)) '(4 5))
  (check-equal? (first (hash-ref x 'cells))
                (hasheq 'cell_type "code" 'id "cell-1" 'source "(f)" 'outputs '()
                        'execution_count 'null 'metadata (hasheq))))

(test-case "a cell whose source is folded is hidden"
  (define cells (fresh '(code "(f)") '(code "(g)")))
  (define x (bytes->jsexpr (notebook->bytes usual-header cells
                                            #:folded? (lambda (c) (eq? c (car cells))))))
  (check-equal? (for/list ([c (hash-ref x 'cells)]) (hash-ref c 'metadata))
                (list (hasheq 'jupyter (hasheq 'source_hidden #t)) (hasheq))))

(test-case "sources may be lists of lines"
  (define-values (header cells)
    (bytes->notebook
     'program "x" #"{\"cells\":[{\"cell_type\":\"code\",\"source\":[\"(f\\n\",\" 1)\"]}]}"))
  (check-equal? (kinds+sources cells) '((code "(f\n 1)"))))

(define (cells-in notebook #:attachments? [attachments? #t])
  (define-values (header cells)
    (bytes->notebook 'program "x" notebook #:attachments? attachments?))
  (kinds+sources cells))

(define no-notebook "program: x is no notebook of Jupyter, in its format 4: ")

(test-case "an attachment is left out, or refused"
  (define (notebook attached)
    (bytes-append #"{\"cells\":[{\"cell_type\":\"markdown\",\"source\":\"a\",\"attachments\":"
                  attached #"}]}"))
  (define-values (picture none) (values (notebook #"{\"a.png\":{}}") (notebook #"{}")))
  (check-equal? (cells-in picture) '((markdown "a")))
  (check-equal? (cells-in none #:attachments? #f) '((markdown "a")))
  (define-values (_ cells) (bytes->notebook 'program "x" picture))
  (check-equal? (kinds+sources cells) '((markdown "a")))
  (check-message
   (string-append "program: a cell holds an attachment, such as a picture that was pasted, "
                  "which is not read; take it out")
   (cells-in picture #:attachments? #f)))

;; Braces in a text nest nothing.
(test-case "a text ends at its own quotation mark"
  (define braces (make-string 70 #\{))
  (for ([texts `(("a\\" ,braces) (,(string-append "\"" braces)) (,(string-append "\\\"" braces)))])
    (define cells (for/list ([t texts]) (list 'code t)))
    (check-equal? (cells-in (notebook->bytes usual-header (apply fresh cells))) cells)))

(test-case "a key stands once in an object, whichever way it is written"
  (check-equal? (cells-in #"{\"cells\":[], \"a\":{\"b\":1}, \"b\":[{\"a\":1},{\"a\":1}]}") '())
  (for ([again '(#"cells" #"ce\\u006cls")])
    (check-message (string-append no-notebook
                                  "the key \"cells\" stands twice in one object of its JSON")
                   (cells-in (bytes-append #"{\"cells\":[],\"a\":1,\"" again #"\":[]}")))))

;; An object, its two lists and n numbers in one of them, of which a comma tells each next one
(test-case "a notebook holds 200000 values, and no more"
  (define (notebook n)
    (bytes-append #"{\"cells\":[],\"x\":[1" (apply bytes-append (make-list (- n 1) #",1")) #"]}"))
  (check-equal? (cells-in (notebook 199997)) '())
  (check-message (string-append no-notebook "its JSON holds more than 200000 values")
                 (cells-in (notebook 199998))))

(test-case "metadata bring no code that no cell shows, and no text loads what it names"
  (define-values (header cells)
    (bytes->notebook
     'program "x"
     (jsexpr->bytes
      (hasheq 'metadata (hasheq 'mechanics (hasheq 'header "#lang mechanics\n(hidden)\n"))
              'cells (for/list ([code '("; note" "(f)")])
                       (hasheq 'cell_type "code" 'source code
                               'metadata (hasheq 'mechanics (hasheq 'after "\n\n(hidden)\n\n"
                                                                    'text "(hidden)"))))))))
  (check-equal? header usual-header)
  (check-equal? (cells->program header cells)
                "#lang mechanics\n\n;;; cell\n; note\n;;; end\n\n(f)\n")
  (check-cells-kept (fresh '(code "#reader \"no-such-file.rkt\" x") '(code "(f)"))))

(test-case "what is no notebook, and no program with #lang"
  (check-message
      "program: x.ipynb is no notebook of Jupyter, in its format 4: its JSON has a mistake"
    (bytes->notebook 'program "x.ipynb" #"{]"))
  (check-message (string-append no-notebook "its JSON has a mistake") (cells-in #"{\"cells\": \"a"))
  (check-exn #rx"^notebook: the program cannot be read: .*end of file in"
             (lambda () (cells-of "#lang mechanics\n\n(f)\n\n#| open")))
  (check-exn #rx"^notebook: the program cannot be read: .*#reader"
             (lambda () (cells-of "#lang mechanics\n\n#reader \"no-such-file.rkt\" x\n")))
  (check-message "program: a cell of an unknown kind: #f" (cells-in #"{\"cells\":[{}]}"))
  (check-message "program: x.ipynb is no notebook of Jupyter, in its format 4"
    (bytes->notebook 'program "x.ipynb" #"{\"cells\": 1}"))
  (check-message "program: a cell of an unknown kind: \"heading\""
    (bytes->notebook 'program "x" #"{\"cells\":[{\"cell_type\":\"heading\"}]}"))
  (check-message
      "notebook: the program does not begin with #lang; only such a program becomes a notebook"
    (program->cells 'notebook #"(module a racket)")))
