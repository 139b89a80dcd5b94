#lang racket/base
;; The text between the forms of a program as prose: comments, in paragraphs, and headings.  A
;; heading is a line beneath or above a rule of hyphens, or begins with # as in Markdown.

(require racket/list
         racket/string
         "document-piece.rkt")

(provide gap->pieces take-title)

;; The text between two forms -> pieces.  A form that a #; leaves out stays code.
(define (gap->pieces text)
  (define rest (string-trim text #:right? #f))
  (cond [(string=? rest "") '()]
        [(regexp-match #px"^(?:;[^\n]*(?:\n[ \t]*|$))+" rest)
         => (lambda (m)
              (append (lines->pieces (map uncommented (string-split (car m) "\n")))
                      (gap->pieces (substring rest (string-length (car m))))))]
        [(block-end rest)
         => (lambda (end)
              (append (lines->pieces (map string-trim
                                          (string-split (substring rest 2 (- end 2)) "\n"
                                                        #:trim? #f)))
                      (gap->pieces (substring rest end))))]
        [else (list (code (string-trim rest) 1))]))

(define (uncommented line) (string-trim (regexp-replace #px"^\\s*;+ ?" line "") #:left? #f))

;; The end of a comment #| ... |# at the start of the text, with all comments in it, or #f.
(define (block-end text)
  (and (string-prefix? text "#|")
       (let loop ([at 2] [depth 1])
         (define m (regexp-match-positions #rx"#[|]|[|]#" text at))
         (cond [(not m) #f]
               [(char=? #\# (string-ref text (caar m))) (loop (cdar m) (+ depth 1))]
               [(= depth 1) (cdar m)]
               [else (loop (cdar m) (- depth 1))]))))

;; ---------------------------------------------------------------------------
;; Paragraphs and headings

(define (blank? line) (string=? line ""))
(define (rule? line) (regexp-match? #px"^[-=─*#]{5,}$" line))
(define (underline? line) (regexp-match? #px"^={5,}$" line))

;; # Heading, ## Heading -> its words, or #f
(define (marked line)
  (define m (regexp-match #px"^#{1,6}\\s+(.*?)\\s*#*$" line))
  (and m (not (blank? (cadr m))) (cadr m)))

(define (lines->pieces lines)
  (define rest (dropf lines blank?))
  (cond [(null? rest) '()]
        [(rule? (car rest))
         (define after (dropf (cdr rest) rule?))
         (if (or (null? after) (blank? (car after)))
             (lines->pieces after)
             (cons (heading (or (marked (car after)) (car after)))
                   (lines->pieces (dropf (cdr after) rule?))))]
        [(marked (car rest)) => (lambda (text) (cons (heading text) (lines->pieces (cdr rest))))]
        [(underlined? (cdr rest)) (cons (heading (car rest)) (lines->pieces (cddr rest)))]
        [else
         (define-values (block more)
           (splitf-at rest (lambda (l) (not (or (rule? l) (marked l))))))
         (cons (prose (paragraphs block)) (lines->pieces more))]))

;; Lines after a first one: a rule that belongs to it, and not to a line beneath.
(define (underlined? lines)
  (and (pair? lines) (rule? (car lines))
       (or (underline? (car lines)) (null? (cdr lines)) (blank? (cadr lines)))))

(define (paragraphs lines)
  (define-values (paragraph others) (splitf-at lines (lambda (l) (not (blank? l)))))
  (define more (dropf others blank?))
  (cons (meant-lines paragraph) (if (null? more) '() (paragraphs more))))

;; A line with room for the first word of the next line was meant to end there, and so was a line
;; before an item of a list or a label, as in "Units: metres".
(define (meant-lines lines)
  (define widest (apply max (map string-length lines)))
  (define (meant? line next)
    (or (regexp-match? #px"^(?:\\s|- |[*] |\\p{Lu}\\p{Ll}+: )" next)
        (< (+ (string-length line) (string-length (car (string-split next))) 12) widest)))
  (let loop ([lines (cdr lines)] [current (car lines)])
    (cond [(null? lines) (list (string-normalize-spaces current))]
          [(meant? (last (string-split current "\n" #:trim? #f)) (car lines))
           (cons (string-normalize-spaces current) (loop (cdr lines) (car lines)))]
          [else (loop (cdr lines) (string-append current "\n" (car lines)))])))

;; ---------------------------------------------------------------------------
;; The title

(define longest-title 120)

;; The heading that the opening comment begins with, or its first sentence, if that is short, is the
;; title -> the title or `otherwise`, and the other pieces.
(define (take-title pieces otherwise)
  (define start (and (pair? pieces) (car pieces)))
  (cond [(heading? start) (values (heading-text start) (cdr pieces))]
        [(prose? start) (sentence-title pieces otherwise)]
        [else (values otherwise pieces)]))

(define (sentence-title pieces otherwise)
  (define first-lines (car (prose-paragraphs (car pieces))))
  (define line (string-normalize-spaces (car first-lines)))
  (define end (or (sentence-end line) (string-length line)))
  (cond [(<= end longest-title)
         (define left (cons (string-trim (substring line end)) (cdr first-lines)))
         (values (string-trim (substring line 0 end) "." #:left? #f)
                 (without-first pieces (remove "" left)))]
        [else (values otherwise pieces)]))

;; "p. 22" ends no sentence.
(define (sentence-end line)
  (define m (regexp-match-positions #px"(?<![ (]p)(?<![ (]pp)[.?!](?=\\s|$)" line))
  (and m (cdar m)))

(define (without-first pieces lines)
  (define others (cdr (prose-paragraphs (car pieces))))
  (define left (if (null? lines) others (cons lines others)))
  (if (null? left) (cdr pieces) (cons (prose left) (cdr pieces))))
