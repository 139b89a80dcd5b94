#lang racket/base
;; A program as the cells of a notebook, and back.
;;
;; Nothing of a program is lost on the way there and back: cells are cut out at blank lines between
;; its forms, and all else stays in them, byte for byte.  Comments that stand alone are prose, in
;; Markdown; submodules and `provide`, which mean something in a file only, are raw cells, which are
;; not run.
;;
;; Cells of a notebook that a program would not give back as they are stand in it between two lines
;; of comment, such as ;;; cell and ;;; end.

(require racket/list
         racket/string
         "../../error/complain.rkt")

(provide program->cells cells->program Markdown-escaped
         (struct-out cell)
         usual-header usual-gap header? gap?)

;; kind : 'code, 'markdown or 'raw; source : as the notebook shows it; text : as it stands in the
;; program, or #f; after : the text between it and the next cell
(struct cell (kind source text after) #:transparent)

(define usual-header "#lang mechanics\n\n")
(define usual-gap "\n\n")

;; ---------------------------------------------------------------------------
;; From a program

(define header-pattern
  (byte-pregexp
   #"^(?:[ \t]*(?:;[^\n]*)?\r?\n)*#lang[ \t][^\n]*(?:$|\n(?:[ \t]*\r?\n)*)"))

;; text : bytes of a file that begins with #lang; who : in whose name is complained
;; -> header, with the line #lang, and cells
(define (program->cells who text)
  (define m (regexp-match header-pattern text))
  (unless m
    (complain who "the program does not begin with #lang; only such a program becomes a notebook"))
  (values (bytes->string/utf-8 (car m))
          (body->cells who (subbytes text (bytes-length (car m))))))

;; Is the text the header of a program, and no more?  May it stand between cells?
(define (header? text) (equal? (list (string->bytes/utf-8 text))
                               (regexp-match header-pattern (string->bytes/utf-8 text))))
(define (gap? text) (regexp-match? #px"^\\s*$" text))

(define (body->cells who text)
  (define end (caar (regexp-match-positions #px#"\\s*$" text)))
  (define gaps (cell-gaps who text end))
  (define starts (if (= end 0) '() (cons 0 (map cdr gaps))))
  (define ends (append gaps (list (cons end (bytes-length text)))))
  (for/list ([start (in-list starts)] [gap (in-list ends)])
    (define (part from to) (bytes->string/utf-8 (subbytes text from to)))
    (text->cell (part start (car gap)) (part (car gap) (cdr gap)))))

;; The blank lines between cells: pairs of start and end
(define (cell-gaps who text end)
  (define wholes (whole-parts who text))
  (define (within? k) (for/or ([w (in-list wholes)]) (and (<= (car w) k) (< k (cdr w)))))
  (for/list ([gap (in-list (regexp-match-positions* #px#"\r?\n(?:[ \t]*\r?\n)+(?=\\S)" text))]
             #:unless (or (>= (car gap) end) (within? (car gap))))
    gap))

;; ---------------------------------------------------------------------------
;; Parts that stay whole: forms, comments of several lines, and cells between lines that mark them

(define marked-cell #px#"(?m:^;;; (?:cell|markdown|raw)\r?$)(?s:.*?)(?m:^;;; end\r?$)")

(define (whole-parts who text)
  (define marked (regexp-match-positions* marked-cell text))
  (define readable (for/fold ([t text]) ([m (in-list marked)]) (blanked t m)))
  (append marked (form-parts who readable)))

(define (blanked text m)
  (bytes-append (subbytes text 0 (car m))
                (regexp-replace* #px#"[^\r\n]" (subbytes text (car m) (cdr m)) #" ")
                (subbytes text (cdr m))))

;; Without lines to count, positions are those of bytes.
(define (form-parts who text)
  (define port (open-input-bytes text))
  (let loop ([from 0])
    (define form
      (with-handlers ([exn:fail:read? (lambda (e) (complain who "the program cannot be read: ~a"
                                                            (exn-message e)))])
        ;; to divide a text loads nothing that it names
        (parameterize ([read-accept-reader #f] [read-accept-lang #f])
          (read-syntax 'program port))))
    (define start (if (eof-object? form) (bytes-length text) (- (syntax-position form) 1)))
    (define end (if (eof-object? form) start (+ start (syntax-span form))))
    (append (comment-parts (subbytes text from start) from)
            (if (eof-object? form) '() (cons (cons start end) (loop end))))))

;; Between forms: a comment #| ... |#, and all from a #; on, which leaves out the form behind it
(define (comment-parts text offset)
  (define m (regexp-match-positions #rx#";|#[|]|#;" text))
  (define (rest end) (comment-parts (subbytes text end) (+ offset end)))
  (cond [(not m) '()]
        [(= (- (cdar m) (caar m)) 1)
         (rest (cdar (regexp-match-positions #rx#"[^\n]*" text (caar m))))]
        [(regexp-match? #rx#"^#;" text (caar m)) (list (cons (+ offset (caar m))
                                                             (+ offset (bytes-length text))))]
        [else
         (define end (or (block-end text (cdar m)) (bytes-length text)))
         (cons (cons (+ offset (caar m)) (+ offset end)) (rest end))]))

;; Comments within comments count.
(define (block-end text at [depth 1])
  (define m (regexp-match-positions #rx#"#[|]|[|]#" text at))
  (cond [(not m) #f]
        [(= (bytes-ref text (caar m)) 35) (block-end text (cdar m) (+ depth 1))]
        [(= depth 1) (cdar m)]
        [else (block-end text (cdar m) (- depth 1))]))

;; ---------------------------------------------------------------------------
;; One cell

(define (text->cell text after)
  (define m (regexp-match #px"^;;; (cell|markdown|raw)\r?\n(?s:(.*?))\r?\n?;;; end\r?$" text))
  (define-values (kind source)
    (cond [m (values (if (string=? (cadr m) "cell") 'code (string->symbol (cadr m)))
                     (if (string=? (cadr m) "cell")
                         (regexp-replace* #px"(?m:^;(;;;+ (?:end)))" (caddr m) "\\1")
                         (uncommented (caddr m))))]
          [(andmap comment? (lines-of text)) (values 'markdown (prose->Markdown text))]
          [(of-a-file? text) (values 'raw text)]
          [else (values 'code text)]))
  (cell kind source text after))

(define (lines-of text) (regexp-split #rx"\r?\n" text))
(define (comment? line) (regexp-match? #rx"^;" line))
(define (uncommented text) (string-join (map without-semicolons (lines-of text)) "\n"))
(define (without-semicolons line) (regexp-replace #px"^;+ ?" line ""))

(define (of-a-file? text)
  (regexp-match? #px"^(?:;[^\n]*\n)*[(](?:module[+*]?|provide)\\s" text))

;; Headings and lists are written alike in both; other signs of Markdown are escaped, but not
;; in lines that are indented as code is.
(define (prose->Markdown text)
  (string-join
   (for/list ([line (in-list (map without-semicolons (lines-of text)))])
     (if (regexp-match? #px"^(?:    |#{1,6} |[-=]{3,}$)" line)
         line
         (Markdown-escaped line)))
   "\n"))

;; So that a text reads as it is
(define (Markdown-escaped text) (regexp-replace* #px"[\\\\`*_<>$\\[\\]|~]" text "\\\\&"))

;; ---------------------------------------------------------------------------
;; To a program

;; Texts of cells that came from a program stand as they stood there, unless their source changed.
(define (cells->program header cells)
  (define texts (map cell->text cells))
  (define afters
    (for/list ([c (in-list cells)] [k (in-range (length cells) 0 -1)])
      (define after (cell-after c))
      (cond [(= k 1) (or after "\n")]
            [(and after (regexp-match? #rx"\n[ \t\r]*\n" after)) after]
            [else usual-gap])))
  (string-append* header (append-map list texts afters)))

(define (cell->text c)
  (define kept (cell-text c))
  (define source (cell-source c))
  (define plain (if (eq? (cell-kind c) 'markdown) (commented source) source))
  (cond [(and kept (gives? kept c)) kept]
        [(gives? plain c) plain]
        [else (marked c)]))

;; Would a program with this text give the cell back, and no other?
(define (gives? text c)
  (define cells
    (with-handlers ([exn:fail? (lambda (e) '())])
      (body->cells 'program (string->bytes/utf-8 (string-append text "\n")))))
  (and (= 1 (length cells))
       (eq? (cell-kind (car cells)) (cell-kind c))
       (string=? (cell-source (car cells)) (cell-source c))))

(define (marked c)
  (define kind (cell-kind c))
  (format ";;; ~a\n~a\n;;; end" (if (eq? kind 'code) "cell" kind)
          (if (eq? kind 'code)
              (regexp-replace* #px"(?m:^;;;+ end)" (cell-source c) ";&")
              (commented (cell-source c)))))

(define (commented source)
  (string-join (for/list ([line (in-list (lines-of source))])
                 (if (string=? line "") ";;" (string-append ";; " line)))
               "\n"))
