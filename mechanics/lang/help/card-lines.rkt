#lang racket/base
;; A card as text, in lines of at most so many columns:
;;
;;     (iota n [start] [step])  → list
;;       The list of n values from start on, each larger by step.
;;
;;       n      0, 1, 2 …
;;
;;       > (iota 4)
;;       '(0 1 2 3)
;;
;;       See also: …

(require (only-in racket/format ~a)
         racket/list
         racket/string
         "card.rkt" "demonstration.rkt"
         "../../show/display/filled-lines.rkt" "../../error/message-words.rkt")

(provide card-lines call-lines)

(define indentation "  ")

(define (card-lines c width)
  (define inside (- width (string-length indentation)))
  (define paragraphs
    (list (append (filled (string-split (or (card-sentence c) "")) inside)
                  (library-lines c))
          (argument-lines (append-map described-arguments (card-signatures c)) inside)
          (example-lines (card-demonstration c) inside)
          (reference-lines c inside)))
  (append (append-map (lambda (s) (call-lines s width)) (card-signatures c))
          (indented (append* (add-between (filter pair? paragraphs) '(""))))))

;; A line other than a string (result-line, demonstration.rkt) is left to the caller.
(define (indented lines [by indentation])
  (for/list ([l (in-list lines)])
    (if (and (string? l) (non-empty-string? l)) (string-append by l) l)))

;; ---------------------------------------------------------------------------
;; The call, and its arguments

(define (call-lines s width)
  (define result (signature-result s))
  (filled (append (signature-call s) (if result (cons " →" (string-split result)) '()))
          width
          (string-append "    " indentation)))

(define (library-lines c)
  (if (eq? (card-library c) 'mechanics)
      '()
      (list (format "(require ~a) provides it." (card-library c)))))

(define (described-arguments s)
  (filter (lambda (a) (or (argument-default a) (specific? (argument-what a))))
          (append (signature-needed s) (signature-optional s) (signature-keywords s))))

(define (specific? what) (not (member what '("value" "any value"))))

;; A line for each name, in columns.
(define (argument-lines arguments width)
  (define named (remove-duplicates arguments #:key argument-name))
  (define room (+ 3 (apply max 0 (map (lambda (a) (string-length (argument-name a))) named))))
  (append*
   (for/list ([a (in-list named)])
     (define lines (filled (string-split (description a)) (- width room)))
     (cons (string-append (~a (argument-name a) #:min-width room) (car lines))
           (indented (cdr lines) (make-string room #\space))))))

(define (description a)
  (define default (argument-default a))
  (cond [(not default) (argument-what a)]
        [(equal? default "#f") (without-false (argument-what a))]
        [(specific? (argument-what a)) (format "~a; ~a unless given" (argument-what a) default)]
        [else (format "~a unless given" default)]))

;; "constraint, list or #f" -> "constraint or list"; commas before an arrow are between arguments
(define (without-false what)
  (define found (regexp-match #rx"^(.*) or #f$" what))
  (if found
      (regexp-replace #rx", ([^,→]*)$" (cadr found) " or \\1")
      what))

;; ---------------------------------------------------------------------------
;; The example

(define (example-lines e width)
  (if e
      (append (append-map lines-of (example-definitions e))
              (append-map answer-lines (demonstrate e width)))
      '()))

(define (answer-lines a)
  (define typed (lines-of (answer-typed a)))
  (append (cons (string-append "> " (car typed)) (indented (cdr typed)))
          (answer-printed a)))

(define (lines-of text) (string-split text "\n"))

;; ---------------------------------------------------------------------------
;; References

(define (reference-lines c width)
  (define also (card-also c))
  (append
   (filled (string-split (format "~aManual: ~a."
                                 (if (card-place c) (format "Book: ~a. " (card-place c)) "")
                                 (card-page c)))
           width)
   (if (null? also)
       '()
       (filled (string-split (format "See also: ~a." (joined (map symbol->string also)))) width))))
